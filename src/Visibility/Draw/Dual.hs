{-# LANGUAGE OverloadedStrings #-}

-- | The figure of the dual: every line is a point, every corner a curve.
--
-- A line with direction angle θ and offset u is the point (θ, u); the lines through a corner (x, y) are the curve
-- u = −x sin θ + y cos θ.
module Visibility.Draw.Dual
  ( -- * The figure
    dualDrawing
    -- * Its coordinates
  , Frame
  , frameOrigin
  , frameUnit
  , frameFor
  , onCanvas
  ) where

import Data.List (foldl', sortOn)
import Data.Maybe (fromMaybe)
import Data.Ratio ((%))
import qualified Data.Text as Text
import qualified Data.Vector.Unboxed as U
import Visibility.Count (Counts (..), count)
import Visibility.Draw.Figure hiding (Frame, frameFor)
import Visibility.Exact.Point
import Visibility.Exact.Predicate (Direction (..))
import Visibility.Scene
import Visibility.Sweep.Vertex
import Visibility.View

-- | The dual of a scene: θ from −90° to 90° to the right, u in the file's units upwards.
--
-- Layers, from the bottom: @frame@ with ticks; @buried@, @ending@ and @tangent@, a curve per stretch, named by its
-- corner; @vertices@, dots named by their corners; @leaders@, @labels@ of up to 24 corners; @legend@. An edge is
-- drawn in two curves where the half turn cuts it.
--
-- Where the file's origin is far from the scene, u is measured from a round point in the scene, which the figure
-- names: otherwise all curves would run into one.
--
-- /Degenerate cases/ a vertical vertex, at 90°, is also drawn at −90°, where u has the other sign. Vertices of three
-- or more corners are drawn larger and hollow.
--
-- /Requires/ all events of the scene in the order of the stream. /Cost/ O(m log m), besides labels.
--
-- /Laws/ which legal order the stream has makes no difference; as many dots as vertices, and one more for each
-- vertical one; all points of a curve satisfy its equation.
dualDrawing :: Scene -> [Event] -> Drawing
dualDrawing scene stream =
  pageDrawing
    (scenePage ("Dual of " <> fromMaybe "an untitled scene" (sceneTitle scene)) (top + 48))
      { pageAbout = "The visibility complex in the dual, angle θ against offset u: "
      , pageFacts = map (shortened Caption (right - left)) (facts <> countedUnlabelled unlabelled <> origin)
      , pageAcross = (left, right)
      , pageTop = 26
      , pageEntries = entries
      , pageLegend = (legendTop, right - left)
      , pageCaption = pageBelow legendTop (right - left) entries
      , pageLayers =
          [Layer "frame" Sparse axes]
            <> [ Layer name curveDensity (map curveMark (curvesIn style))
               | (name, style) <- [("buried", BuriedCurve), ("ending", EndingCurve), ("tangent", TangentCurve)]
               ]
            <> [Layer "vertices" dotDensity dots, Layer "leaders" Sparse leaders, Layer "labels" Sparse labels]
      }
  where
    frame = frameFor scene stream
    -- A corner's edges come in order whatever the sweep, corners do not.
    allEdges = sortOn edgeCorner (stretches scene stream)
    curvesIn style = [edge | edge <- allEdges, curveStyle (edgeView edge) == style]
    curveMark edge =
      Mark (cornerTag scene (edgeCorner edge)) (curveStyle (edgeView edge)) $
        Polyline (map (onCanvas frame) (edgeSamples frame edge))
    dots = concatMap (dotMarks scene frame) (sortOn eventVertex stream)
    dotDensity = densityOf (2 * length dots)
    curveDensity = densityOf (length allEdges)
    axes = axisMarks frame

    (labels, leaders, unlabelled)
      | cornerCount scene <= 24 = placeLabels scenery (map request (placeGroups scene))
      | otherwise = ([], [], [])
    -- Corners in one place have one curve.
    request here =
      Request name CornerLabel name $
        [ Seat (onCanvas frame (theta, heightAt frame c theta)) (slope + turned) (pi / 4)
        | edge <- allEdges
        , let c = edgeCorner edge
        , c `elem` here
        , theta <- samples 6 edge
        , let slope = atan (slopeOnCanvas frame c theta)
        , turned <- [pi / 2, -pi / 2]
        ]
      where
        name = Text.pack (unwords (map cornerText (concatMap (namesHere scene) (take 1 here))))
    Box left bottom right top = plot
    scenery =
      Obstruction
        { canvas = Box (left + 2) (bottom + 2) (right - 2) (top - 2)
        , lightLines = map (Line 0.6) (concatMap (strokes . curveMark) allEdges <> concatMap strokes axes)
        , walls = []
        , taken = [widened (dotRadius dotDensity style) (Box x y x y) | Mark _ style (Dot (Place x y)) <- dots]
        , clearance = 2.5
        }

    legendTop = bottom - 44
    entries =
      [ Entry (lineSwatch [style]) text
      | (style, text) <- [(TangentCurve, "tangent at the corner"), (EndingCurve, "ending"), (BuriedCurve, "buried")]
      , not (null (curvesIn style))
      ]
        <> [ Entry (dotSwatch style) text
           | (style, text) <- [(VertexDot, "vertex"), (DegenerateVertexDot, "degenerate vertex")]
           , any ((== style) . markStyle) dots
           ]
    counts = count scene stream
    facts =
      [ counted (length (statedCorners scene)) "corner" "corners"
      , countedVertices (vertexCount counts) (degenerateCount counts)
      , counted (edgeCount counts) "edge" "edges"
      , counted (faceCount counts) "face" "faces"
      ]
        <> mergedFact pixel (map snd (statedCorners scene))
    pixel = frameUnit frame * toRational ((frameHigh frame - frameLow frame) / (top - bottom))
    origin =
      [ "u measured from (" <> decimalText x <> "; " <> decimalText y <> ")"
      | Point x y <- [frameOrigin frame]
      , (x, y) /= (0, 0)
      ]

-- | Tangent and ending parts of a curve are edges of the complex; where the corner is buried, its curve still bounds a
-- face.
curveStyle :: View Object -> Style
curveStyle view = case view of
  Tangent {} -> TangentCurve
  Ending _ _ -> EndingCurve
  Buried _ -> BuriedCurve

plot :: Box
plot = Box 84 112 780 532

-- | The coordinates of the figure. Offsets are Doubles in 'frameUnit's, measured from 'frameOrigin', so that they are
-- accurate wherever the scene lies; angles are in radians.
data Frame = Frame
  { frameOrigin :: !Point
  -- ^ The point that offsets are measured from: the file's origin unless that is far away.
  , frameUnit :: !Rational
  -- ^ The longer side of the scene's bounding box, in the file's units.
  , frameCorners :: !(U.Vector (Double, Double))
  , frameLow :: !Double
  , frameHigh :: !Double
  }

-- | The frame that all curves and vertices of the stream fit in.
--
-- /Degenerate cases/ where all of a room is filled, there is nothing to fit in.
frameFor :: Scene -> [Event] -> Frame
frameFor scene stream = unfitted {frameLow = low - margin, frameHigh = high + margin}
  where
    points = map (cornerPoint scene) (corners scene)
    (xs, ys) = unzip [(x, y) | (_, Point x y) <- statedCorners scene]
    span' values = maximum values - minimum values
    middle values = (maximum values + minimum values) / 2
    unit = max (span' xs) (span' ys)
    isNear values = abs (middle values) <= 3 / 2 * unit
    origin@(Point ox oy)
      | isNear xs && isNear ys = Point 0 0
      | otherwise = Point (roundedTo (roundStep unit) (middle xs)) (roundedTo (roundStep unit) (middle ys))
    unfitted =
      Frame
        { frameOrigin = origin
        , frameUnit = unit
        , frameCorners =
            U.fromList [(fromRational ((x - ox) / unit), fromRational ((y - oy) / unit)) | Point x y <- points]
        , frameLow = -1
        , frameHigh = 1
        }
    Range low high
      | null drawn = Range (-1) 1
      | otherwise = foldl' (\(Range a b) (_, u) -> Range (min a u) (max b u)) (Range (1 / 0) (-1 / 0)) drawn
    drawn = concatMap (edgeSamples unfitted) (stretches scene stream) <> concatMap (eventPoints scene unfitted) stream
    margin = max 1e-3 (0.03 * (high - low))

data Range = Range !Double !Double

-- | The place of (θ, u).
onCanvas :: Frame -> (Double, Double) -> Place
onCanvas frame (theta, u) =
  Place
    (left + (right - left) * (theta / pi + 0.5))
    (bottom + (top - bottom) * (u - frameLow frame) / (frameHigh frame - frameLow frame))
  where
    Box left bottom right top = plot

-- | The curve of a corner: its u at θ.
heightAt :: Frame -> CornerId -> Double -> Double
heightAt frame (CornerId c) theta = y * cos theta - x * sin theta
  where
    (x, y) = frameCorners frame U.! c

-- | The rise of a corner's curve to its run, in pixels.
slopeOnCanvas :: Frame -> CornerId -> Double -> Double
slopeOnCanvas frame c theta = (y1 - y0) / (x1 - x0)
  where
    Place x0 y0 = onCanvas frame (theta - 1e-4, heightAt frame c (theta - 1e-4))
    Place x1 y1 = onCanvas frame (theta + 1e-4, heightAt frame c (theta + 1e-4))

-- | The points of an edge's curve that are drawn. Between two of them the curve is off its chord by less than a tenth
-- of a pixel.
edgeSamples :: Frame -> Edge -> [(Double, Double)]
edgeSamples frame edge = [(theta, heightAt frame (edgeCorner edge) theta) | theta <- from : samples 2 edge <> [to]]
  where
    (from, to) = (directionAngle (edgeFrom edge), directionAngle (edgeTo edge))

-- | The multiples of some degrees strictly inside the interval of an edge, in radians.
samples :: Int -> Edge -> [Double]
samples degrees edge =
  filter (> from) (takeWhile (< to) [fromIntegral k * step | k <- [floor (from / step) :: Int ..]])
  where
    step = fromIntegral degrees * pi / 180
    (from, to) = (directionAngle (edgeFrom edge), directionAngle (edgeTo edge))

-- | The point of a vertex, and its other end if it is vertical.
eventPoints :: Scene -> Frame -> Event -> [(Double, Double)]
eventPoints scene frame (Event vertex _ _) = case vertexDirection scene vertex of
  Direction 0 _ -> [(pi / 2, u (pi / 2)), (-pi / 2, u (-pi / 2))]
  direction -> let theta = directionAngle direction in [(theta, u theta)]
  where
    u = heightAt frame (vertexFirst vertex)

dotMarks :: Scene -> Frame -> Event -> [Mark]
dotMarks scene frame event = [Mark name style (Dot (onCanvas frame at)) | at <- eventPoints scene frame event]
  where
    vertex = eventVertex event
    name = Text.unwords (map (cornerTag scene) (vertexCorners vertex))
    style = if isDegenerate scene vertex then DegenerateVertexDot else VertexDot

-- | The frame, ticks every 15°, at round values of u, and the line u = 0.
axisMarks :: Frame -> [Mark]
axisMarks frame =
  [ plain Reference (Polyline [Place left y, Place right y])
  | frameLow frame < 0
  , frameHigh frame > 0
  , let Place _ y = onCanvas frame (0, 0)
  ]
    <> concatMap angleTick [-90, -75 .. 90]
    <> concatMap offsetTick (multiplesWithin step low high)
    <> [ plain Axis (Polyline (around <> take 1 around))
       , plain AxisTitle (Label MiddleAnchor (Place ((left + right) / 2) (bottom - 36)) "θ")
       , plain AxisTitle (Label EndAnchor (Place (left - 9) (top + 10)) "u")
       ]
  where
    Box left bottom right top = plot
    around = [Place left bottom, Place right bottom, Place right top, Place left top]
    angleTick :: Int -> [Mark]
    angleTick degrees =
      plain Tick (Polyline [Place x bottom, Place x (bottom - (if isLabelled then 6 else 3))])
        : [ plain TickLabel (Label MiddleAnchor (Place x (bottom - 19)) (decimalText (toInteger degrees % 1) <> "°"))
          | isLabelled
          ]
      where
        isLabelled = degrees `rem` 30 == 0
        Place x _ = onCanvas frame (fromIntegral degrees * pi / 180, 0)
    (low, high) = (toRational (frameLow frame) * frameUnit frame, toRational (frameHigh frame) * frameUnit frame)
    step = roundStep ((high - low) / 5)
    offsetTick value =
      [ plain Tick (Polyline [Place (left - 6) y, Place left y])
      , plain TickLabel (Label EndAnchor (Place (left - 9) (y - 0.36 * textSize TickLabel)) (decimalText value))
      ]
      where
        Place _ y = onCanvas frame (0, fromRational (value / frameUnit frame))
