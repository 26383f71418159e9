{-# LANGUAGE OverloadedStrings #-}

-- | What all figures in the plane of the scene share: where the scene lies on the canvas, its polygons and lights, and
-- the labels of its corners and polygons.
module Visibility.Draw.Scenery
  ( -- * The scene on the canvas
    Frame
  , frameFor
  , standardFoot
  , frameOutside
  , frameHeight
  , canvasWidth
  , sideMargin
  , placeOf
  , placeOfPoint
  , heading
  , freeCone
  , lineOrDot
    -- * Names
  , cornerTag
  , sideTag
    -- * Polygons
  , groundLayers
  , polygonMarks
  , polygonDensity
  , lightsOf
  , lightSources
  , raySteps
  , besideSide
  , flatCornerMarks
  , sceneryEntries
    -- * Labels
  , fewCorners
  , wideLines
  , dotBoxes
  , cornerRequests
  , polygonLabel
    -- * Scale
  , scaleMarks
  , framePixel
  ) where

import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Visibility.Draw.Drawing
import Visibility.Draw.Labels
import Visibility.Draw.Legend
import Visibility.Draw.Scale
import Visibility.Exact.Point
import Visibility.Exact.Predicate (Direction (..), turn)
import Visibility.Scene
import Visibility.Scene.Raw (Material (..))
import qualified Visibility.Scene.Raw as Raw

-- | Where the scene lies on the canvas.
data Frame = Frame
  { frameScale :: !Double
  -- ^ Pixels per extent.
  , frameExtent :: !Rational
  -- ^ The longer side of the bounding box, on the lattice.
  , frameCorner :: !(Rational, Rational)
  -- ^ The lower left of the bounding box, on the lattice.
  , frameOrigin :: !Place
  -- ^ Its place.
  , frameOutside :: !Box
  -- ^ What the figure fills, margins included.
  , frameHeight :: !Double
  -- ^ The height of what the figure fills.
  }

-- | The width of the figure, and that of the margin left and right, in pixels.
canvasWidth, sideMargin :: Double
canvasWidth = 800
sideMargin = 16

plotMargin, tallest, lowest :: Double
plotMargin = 34
tallest = 760
lowest = 90

-- | The room that figures leave below them for a row of the legend and two lines of caption.
standardFoot :: Double
standardFoot = 66

-- | The scene, with some further points, as large as 800 pixels of width and 'tallest' of height admit, in the middle
-- and above a foot of this height.
frameFor :: Double -> Scene -> [Point] -> Frame
frameFor foot scene further =
  Frame scale extent (left, bottom) (Place originX originY) outside (plotHeight + 2 * plotMargin)
  where
    points = map (latticePlace scene . snd) (statedCorners scene) <> others
    others = map (latticePlace scene) further
    left = minimum (0 : map fst others)
    bottom = minimum (0 : map snd others)
    across = maximum (0 : map fst points) - left
    up = maximum (0 : map snd points) - bottom
    extent = maximum [1, across, up]
    (w, h) = (fromRational (across / extent), fromRational (up / extent))
    plotWidth = canvasWidth - 2 * (sideMargin + plotMargin)
    scale = if h * plotWidth <= w * tallest then plotWidth / w else tallest / h
    plotHeight = fromIntegral (ceiling (max lowest (scale * h)) :: Int)
    originX = (canvasWidth - scale * w) / 2
    originY = foot + plotMargin + (plotHeight - scale * h) / 2
    outside = Box sideMargin foot (canvasWidth - sideMargin) (foot + plotHeight + 2 * plotMargin)

-- | The place of a corner.
placeOf :: Scene -> Frame -> CornerId -> Place
placeOf scene frame c = placed frame (coordinates (cornerAt scene c))

-- | The place of a point in the file's coordinates.
--
-- /Law/ @placeOfPoint scene frame (cornerPoint scene c) == placeOf scene frame c@.
placeOfPoint :: Scene -> Frame -> Point -> Place
placeOfPoint scene frame = placed frame . latticePlace scene

-- | A point of the file on the lattice, where it may lie between the lattice's points.
latticePlace :: Scene -> Point -> (Rational, Rational)
latticePlace scene = coordinates . ontoLattice (sceneLattice scene)

-- | Exact up to the last step, so that figures of far places are as good.
placed :: Frame -> (Rational, Rational) -> Place
placed frame (x, y) = Place (ox + part (x - left)) (oy + part (y - bottom))
  where
    (left, bottom) = frameCorner frame
    Place ox oy = frameOrigin frame
    part v = frameScale frame * fromRational (v / frameExtent frame)

-- | The unit vector from a corner to another one, and how far it is on the canvas.
--
-- /Degenerate cases/ where the two are in one place to a hundredth of a pixel, rounding would decide the direction: it
-- is taken from the exact coordinates. Only that of a corner to itself is (0, 0).
heading :: Scene -> (CornerId -> Place) -> CornerId -> CornerId -> ((Double, Double), Double)
heading scene place from to
  | long >= leastSeen = ((dx / long, dy / long), long)
  | otherwise = (exact, long)
  where
    (Place x0 y0, Place x1 y1) = (place from, place to)
    (dx, dy) = (x1 - x0, y1 - y0)
    long = sqrt (dx * dx + dy * dy)
    exact = case towards (cornerAt scene from) (cornerAt scene to) of
      Vector2 0 0 -> (0, 0)
      Vector2 ex ey -> let angle = directionAngle (Direction ex ey) in (cos angle, sin angle)

-- | What is shorter is a point, in pixels: SVG has hundredths.
leastSeen :: Double
leastSeen = 0.01

-- | Where free space lies at a corner: it begins at an angle, that of the preceding side, and is so wide,
-- counter-clockwise to the following side.
--
-- /Degenerate cases/ whether it is wider than a half turn is decided exactly: a spike is 0 or 2π wide though both its
-- sides have one bearing.
freeCone :: Scene -> (CornerId -> Place) -> CornerId -> (Double, Double)
freeCone scene place corner@(CornerId c) = (from, wide)
  where
    (before@(CornerId b), after@(CornerId a)) = (previousCorner scene corner, nextCorner scene corner)
    bearing to = let ((ux, uy), _) = heading scene place corner to in atan2 uy ux
    from = bearing before
    turned = let w = bearing after - from in if w <= 0 then w + 2 * pi else w
    wide = case turn (scenePoints scene) b c a of
      RightTurn | turned > 1.5 * pi -> 0
      LeftTurn | turned < 0.5 * pi -> 2 * pi
      _ -> turned

-- | What marks of corners and of sides are called.
cornerTag :: Scene -> CornerId -> Text
cornerTag scene = Text.pack . cornerText . cornerName scene

sideTag :: Scene -> SideId -> Text
sideTag scene = Text.pack . sideText . sideName scene

-- | A line, or a dot where all of it is in one place.
lineOrDot :: [Place] -> Shape
lineOrDot places = fromMaybe (Polyline places) (dotFor places)

dotFor :: [Place] -> Maybe Shape
dotFor places = case places of
  here@(Place x y) : others
    | and [abs (x' - x) < leastSeen && abs (y' - y) < leastSeen | Place x' y' <- others] -> Just (Dot here)
  _ -> Nothing

-- | The layers below everything: @outside@ and @room@ of an enclosure.
groundLayers :: Scene -> Frame -> [Layer]
groundLayers scene frame =
  [ Layer "outside" Sparse [Mark "E" Outside (boxRegion (frameOutside frame)) | _ <- enclosures]
  , Layer "room" Sparse [Mark "E" RoomFloor (Region places) | places <- enclosures]
  ]
  where
    enclosures =
      [ map (placeOfPoint scene frame) (polygonPoints polygon)
      | polygon <- scenePolygons scene
      , polygonId polygon == Enclosure
      ]

-- | A mark for each polygon, named as in output: a dot where it is smaller than what is seen.
polygonMarks :: Scene -> Frame -> [Mark]
polygonMarks scene frame = map mark (scenePolygons scene)
  where
    mark polygon
      | polygonId polygon == Enclosure = Mark name RoomWall (lineOrDot (places <> take 1 places))
      | isThin polygon = Mark name ThinWall (lineOrDot places)
      | otherwise = Mark name Opaque (fromMaybe (Region places) (dotFor places))
      where
        name = Text.pack (polygonText (polygonId polygon))
        places = map (placeOfPoint scene frame) (polygonPoints polygon)

-- | The density of the layers of polygons and lights.
polygonDensity :: Scene -> Density
polygonDensity = densityOf . cornerCount

isThin :: Polygon -> Bool
isThin polygon = polygonForm polygon == Raw.Polyline

-- | The marks of all sides that give light, named by their sides: a band along the side and short rays from it into
-- free space, which lies to the right of the side.
lightsOf :: Scene -> Frame -> [Mark]
lightsOf scene frame = concatMap marks (lightSources scene)
  where
    marks side =
      [Mark (sideTag scene side) style (lineOrDot [along 0 0, along 1 0]) | style <- [LightRim, LightSource]]
        <> [Mark (sideTag scene side) LightRay (Polyline [along (k / count) 4.5, along (k / count) 9]) | k <- steps]
      where
        (count, steps) = raySteps long
        (_, long) = heading scene (placeOf scene frame) (sideStart side) (sideEnd scene side)
        along = besideSide scene (placeOf scene frame) side

-- | The sides that give light.
lightSources :: Scene -> [SideId]
lightSources scene = [side | side <- sides scene, emission (sideMaterial scene side) > 0]

-- | How many rays stand on a light source of a length in pixels, and where, counted in their distance.
raySteps :: Double -> (Double, [Double])
raySteps long = (count, takeWhile (< count) (map (+ 0.5) [0 ..]))
  where
    count = max 1 (fromIntegral (round (long / 12) :: Int))

-- | A place along a side, 0 at its start and 1 at its end, so many pixels out into free space.
--
-- /Degenerate cases/ the two faces of a thin wall lie beside it, so that both can be told apart.
besideSide :: Scene -> (CornerId -> Place) -> SideId -> Double -> Double -> Place
besideSide scene place side s out = Place (x0 + s * (x1 - x0) + far * uy) (y0 + s * (y1 - y0) - far * ux)
  where
    (Place x0 y0, Place x1 y1) = (place (sideStart side), place (sideEnd scene side))
    ((ux, uy), _) = heading scene place (sideStart side) (sideEnd scene side)
    far = out + (if isFaceOfWall scene side then 2.6 else 0)

-- | Is the side a face of a thin wall?
isFaceOfWall :: Scene -> SideId -> Bool
isFaceOfWall scene side = or [isThin polygon | polygon <- scenePolygons scene, polygonId polygon == owner]
  where
    SideName owner _ = sideName scene side

-- | Dots at flat corners of a scene whose corners are labelled: there a label would name a corner that no outline
-- shows.
flatCornerMarks :: Scene -> Frame -> [Mark]
flatCornerMarks scene frame =
  [ Mark (cornerTag scene c) VertexDot (Dot (placeOf scene frame c))
  | fewCorners scene
  , c@(CornerId i) <- corners scene
  , not (isWallEnd scene c)
  , let (CornerId before, CornerId after) = (previousCorner scene c, nextCorner scene c)
  , turn (scenePoints scene) before i after == Collinear
  ]

-- | The entries of the legend for polygons; those for lights.
sceneryEntries :: Scene -> ([Entry], [Entry])
sceneryEntries scene =
  ( [Entry (regionSwatch Opaque) "opaque" | any (not . isThin) (scenePolygons scene)]
      <> [Entry (lineSwatch [ThinWall]) "thin wall" | any isThin (scenePolygons scene)]
  , [Entry (lineSwatch [LightRim, LightSource]) "light source" | not (null (lightSources scene))]
  )

-- | Are all corners to be labelled? Up to 40 are.
fewCorners :: Scene -> Bool
fewCorners scene = cornerCount scene <= 40

-- | What a mark draws, as it is in the way of labels.
wideLines :: Mark -> [Line]
wideLines mark = map (Line (strokeWidth Sparse (markStyle mark) / 2)) (strokes mark)

-- | Dots, as they are in the way of labels, which keep clear of thin rims anyway.
dotBoxes :: [Mark] -> [Box]
dotBoxes marks = [widened (around style) (Box x y x y) | Mark _ style (Dot (Place x y)) <- marks]
  where
    around style = dotRadius Sparse style + max 0 (strokeWidth Sparse style / 2 - 1)

-- | A label for each place with corners, with all their names. It had best lie where the free angle is widest, opposite
-- the solid; where all is solid, anywhere.
cornerRequests :: Scene -> Frame -> [Request]
cornerRequests scene frame =
  [request (place c) (outward group) (namesHere scene c) | group@(c : _) <- placeGroups scene]
    <> [request (placeOfPoint scene frame at) (-pi / 2) names | (at, names) <- Map.toList coveredPlaces]
  where
    place = placeOf scene frame
    request here angle names =
      let text = Text.pack (unwords (map cornerText names)) in Request text CornerLabel text [Seat here angle pi]
    outward group = snd (maximum [(wide, from + wide / 2) | (from, wide) <- map (freeCone scene place) group])
    coveredPlaces =
      Map.fromListWith
        (flip (<>))
        [(point, [name]) | (name, point) <- statedCorners scene, Just [] <- [cornersNamed scene name]]

-- | The number of an obstacle, and its name where there is room, inside it and on none of some lines.
polygonLabel :: (Point -> Place) -> [Line] -> Polygon -> Maybe Mark
polygonLabel place bands polygon
  | polygonId polygon == Enclosure || isThin polygon = Nothing
  | otherwise = labelInside bands number PolygonLabel texts (map place (polygonPoints polygon))
  where
    number = Text.pack (polygonText (polygonId polygon))
    texts = [number <> " " <> name | Just name <- [polygonName polygon]] <> [number]

-- | A bar whose length in the file's units is a round number, by its right end.
scaleMarks :: Scene -> Frame -> Place -> [Mark]
scaleMarks scene frame (Place right y) =
  [ plain Axis (Polyline [Place left y, Place right y])
  , plain Axis (Polyline [Place left (y - 3), Place left (y + 3)])
  , plain Axis (Polyline [Place right (y - 3), Place right (y + 3)])
  , plain Caption (Label EndAnchor (Place (left - 6) (y - 0.36 * textSize Caption)) (decimalText bar))
  ]
  where
    -- 80 pixels in the file's units.
    bar = roundStep (unit * toRational (80 / frameScale frame))
    unit = frameUnit scene frame
    left = right - frameScale frame * fromRational (bar / unit)

-- | The longer side of the bounding box, and a pixel, in the file's units.
frameUnit, framePixel :: Scene -> Frame -> Rational
frameUnit scene frame = frameExtent frame / fromInteger (latticeScale (sceneLattice scene))
framePixel scene frame = frameUnit scene frame / toRational (frameScale frame)
