{-# LANGUAGE OverloadedStrings #-}

-- | The figure of what is seen from a point, from an element with a normal, or from a side.
module Visibility.Draw.View
  ( ViewFigure (..)
  , viewDrawing
  ) where

import Data.List (find, sortOn)
import Data.Maybe (fromMaybe)
import Data.Ord (Down (..))
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Visibility.Draw.Drawing as Drawing
import Visibility.Draw.Figure hiding (Region)
import Visibility.Draw.Outline
import Visibility.Exact.Point
import Visibility.Exact.Predicate (Direction (..))
import Visibility.Exact.RootSum (RootSum)
import Visibility.Exact.Rounding
import Visibility.Mesh.Span (parameterOn)
import Visibility.Scene
import Visibility.Sight

-- | What is looked from, with what is seen.
data ViewFigure
  = -- | A point, which may be a corner, and the sights all around it.
    RegionFigure !Point ![Sight]
  | -- | A differential element at a point with a normal, the sights all around the point, and the form factors.
    ElementFigure !Point !Direction ![Sight] ![(Seen, RootSum)]
  | -- | A side and its form factors.
    SideFigure !SideName ![(Seen, RootSum)]

-- | The scene to scale, 800 pixels wide, with what is seen.
--
-- Layers, from the bottom: @region@, what a point sees, cut off at the figure's margin where it reaches the sky;
-- @limits@, the lines of sight that bound the region; @polygons@, named as in output; @seen@, the seen sides or pieces
-- of sides, and the side that sees, named by their sides; @flat-corners@, dots; @viewpoint@. A region comes with the
-- labels of the figure of the scene, form factors with labels of the sides that are seen most.
--
-- /Degenerate cases/ a viewpoint beyond the scene is within the figure, which shows the scene smaller. The face of a
-- thin wall that is seen lies beside it.
--
-- /Requires/ of an element: its sights counter-clockwise. /Cost/ that of the marks, besides labels.
--
-- /Laws/ those of 'planeDrawing'; every polygon has exactly one mark; every side with a form factor has one mark in a
-- figure of a side.
viewDrawing :: Scene -> ViewFigure -> Drawing
viewDrawing scene figure =
  planeDrawing scene $
    scenePlane
      { planeTitle = title
      , planeAbout = title <> ", "
      , planeFacts = factsOf scene figure
      , planeEntries = fst (sceneryEntries scene) <> entriesOf scene figure
      , planePoints = viewpointOf figure
      , planeNaming = naming
      , planeSheets = \frame ->
          let (region', limits) = regionMarks scene frame figure
           in [ Sheet Crossable "region" Sparse region'
              , Sheet Crossable "limits" (densityOf (length limits)) limits
              , polygonSheet scene frame
              , Sheet Solid "seen" (polygonDensity scene) (sideMarks scene frame figure)
              , Sheet Ground "flat-corners" Sparse (flatCorners frame)
              , Sheet Solid "viewpoint" Sparse (viewpointMarks scene frame figure)
              ]
      }
  where
    title = titleOf scene figure
    (naming, flatCorners) = case figure of
      RegionFigure _ _ -> (Corners, flatCornerMarks scene)
      _ -> (Asked (\frame -> sideRequests scene frame figure), const [])

viewpointOf :: ViewFigure -> [Point]
viewpointOf figure = case figure of
  RegionFigure q _ -> [q]
  ElementFigure q _ _ _ -> [q]
  SideFigure _ _ -> []

-- | The boundaries of what is seen from a point, with that point: of an element, of what is in front of it, which is in
-- two parts where it stands at a corner.
boundariesOf :: Scene -> ViewFigure -> [(Point, [Bend])]
boundariesOf scene figure = case figure of
  RegionFigure q sights -> [(q, bends scene q sights)]
  ElementFigure q normal sights _ -> [(q, bends scene q front) | front <- inFront normal sights]
  SideFigure _ _ -> []

-- | The seen region, and the lines of sight that bound it.
regionMarks :: Scene -> Frame -> ViewFigure -> ([Mark], [Mark])
regionMarks scene frame figure =
  ( [plain SeenRegion (Drawing.Region (outlinePlaces box place (place q) seen)) | (q, seen) <- boundaries]
  , [ plain SightLimit (Polyline [a, b])
    | (q, seen) <- boundaries
    , Just (a, b) <- map (limitLine box place (place q)) (sightLimits q seen)
    ]
  )
  where
    boundaries = boundariesOf scene figure
    box = frameOutside frame
    place = placeOfPoint scene frame

-- | The seen sides, or of an element the seen pieces, the side that sees above them.
sideMarks :: Scene -> Frame -> ViewFigure -> [Mark]
sideMarks scene frame figure = case figure of
  RegionFigure _ _ -> []
  ElementFigure {} -> [mark SeenSide side (band side from to) | (side, from, to) <- seenPieces scene figure]
  SideFigure from factors ->
    [mark SeenSide piece (band piece 0 1) | (TheSide side, _) <- factors, piece <- piecesNamed scene side]
      <> [mark SeeingSide piece (band piece 0 1) | piece <- piecesNamed scene from]
  where
    mark style side = Mark (sideTag scene side) style
    band side from to = lineOrDot [besideSide scene (placeOf scene frame) side s 0 | s <- [from, to]]

-- | All uncovered pieces of a side of the file.
piecesNamed :: Scene -> SideName -> [SideId]
piecesNamed scene = fromMaybe [] . piecesOf scene

-- | The seen pieces of sides, between two positions on each, 0 at its start and 1 at its end.
seenPieces :: Scene -> ViewFigure -> [(SideId, Double, Double)]
seenPieces scene figure = case figure of
  ElementFigure q normal sights _ ->
    [ (side, landing from, landing to)
    | Sight from to (Side side) <- concat (inFront normal (joined sights))
    , let ends = (cornerPoint scene (sideStart side), cornerPoint scene (sideEnd scene side))
    , let landing ray = fromRational (parameterOn ends (rayMeets scene q ray side))
    ]
  _ -> []

-- | The viewpoint, and the normal of an element.
viewpointMarks :: Scene -> Frame -> ViewFigure -> [Mark]
viewpointMarks scene frame figure = arrow <> map dot (viewpointOf figure)
  where
    place = placeOfPoint scene frame
    dot q = Mark (Text.pack (maybe "" cornerText (cornerHere scene q))) ViewpointDot (Dot (place q))
    arrow = case figure of
      ElementFigure q normal _ _ -> arrowMarks (place q) (directionAngle normal) 4 30
      _ -> []

-- | An arrow from a place in a direction, from one distance to another.
arrowMarks :: Place -> Double -> Double -> Double -> [Mark]
arrowMarks (Place x y) angle near far =
  [plain Arrow (Polyline [at near 0, at far 0]), plain Arrow (Polyline [at (far - 7) 4, at far 0, at (far - 7) (-4)])]
  where
    at ahead aside = Place (x + ahead * cos angle - aside * sin angle) (y + ahead * sin angle + aside * cos angle)

-- | The corner of the file at a point, the first one if there are several.
cornerHere :: Scene -> Point -> Maybe CornerName
cornerHere scene q = fst <$> find ((== q) . snd) (statedCorners scene)

-- | The sides that are seen most, each with its form factor, and the side that sees.
sideRequests :: Scene -> Frame -> ViewFigure -> [Request]
sideRequests scene frame figure =
  [Request name SideLabel name (seats (whole side)) | SideFigure side _ <- [figure], let name = sideAsText side]
    <> [ Request (sideAsText side) SideLabel (sideAsText side <> ": " <> factorText value) (seats (parts side))
       | (TheSide side, value) <- take labelledFactors (greatestFirst (factorsOf figure))
       ]
  where
    sideAsText = Text.pack . sideText
    whole side = [(piece, 0, 1) | piece <- piecesNamed scene side]
    parts side = case figure of
      ElementFigure {} -> [part | part@(piece, _, _) <- seenPieces scene figure, sideName scene piece == side]
      _ -> whole side
    seats found =
      [ Seat (besideSide scene place piece (a + k * (b - a)) 0) (outward piece) pi
      | k <- [1 / 2, 1 / 3, 2 / 3, 1 / 6, 5 / 6]
      , (piece, a, b) <- found
      ]
    place = placeOf scene frame
    outward piece =
      let ((ux, uy), _) = heading scene place (sideStart piece) (sideEnd scene piece) in atan2 (negate ux) uy

-- | How many form factors the caption states, and how many the labels.
captionedFactors, labelledFactors :: Int
captionedFactors = 6
labelledFactors = 12

factorsOf :: ViewFigure -> [(Seen, RootSum)]
factorsOf figure = case figure of
  RegionFigure _ _ -> []
  ElementFigure _ _ _ factors -> factors
  SideFigure _ factors -> factors

greatestFirst :: [(Seen, RootSum)] -> [(Seen, RootSum)]
greatestFirst = sortOn (\(object, value) -> (Down value, object))

-- | Three digits are enough for a figure.
factorText :: RootSum -> Text
factorText = Text.pack . maybe (const "") decimal (digits 3)

titleOf :: Scene -> ViewFigure -> Text
titleOf scene figure = flip titleAfter scene $ case figure of
  RegionFigure q _ -> "Seen from " <> maybe "a point" (Text.pack . ("corner " <>) . cornerText) (cornerHere scene q)
  ElementFigure {} -> "Seen from an element"
  SideFigure side _ -> "Seen from side " <> Text.pack (sideText side)

factsOf :: Scene -> ViewFigure -> [Text]
factsOf scene figure = case figure of
  RegionFigure q sights ->
    [ "seen from " <> pointText q
    , "a region of " <> counted (length (regionPoints (region scene q sights))) "corner" "corners"
    , case length (regionUnbounded (region scene q sights)) of
        0 -> "bounded"
        k -> "open to the sky in " <> counted k "interval" "intervals" <> " of directions"
    ]
  ElementFigure q (Direction dx dy) _ _ ->
    ["seen from " <> pointText q, "normal " <> pointText (Point (fromInteger dx) (fromInteger dy))] <> seen
  SideFigure _ _ -> seen
  where
    pointText (Point x y) = "(" <> Text.pack (rationalText x) <> ", " <> Text.pack (rationalText y) <> ")"
    factors = greatestFirst (factorsOf figure)
    named = [counted k "side" "sides" | let k = length [() | (TheSide _, _) <- factors], k > 0]
    sky = ["the sky" | any ((== TheSky) . fst) factors]
    nothing = ["nothing" | null factors]
    seen = ("sees " <> Text.intercalate " and " (named <> sky <> nothing)) : introduced <> rest
    introduced = zipWith (<>) ("form factors " : repeat "") stated
    stated = [Text.pack (seenText object) <> ": " <> factorText value | (object, value) <- largest]
    rest = [Text.pack ("and " <> show (length smaller) <> " smaller") | not (null smaller)]
    (largest, smaller) = splitAt captionedFactors factors

-- | What the legend explains besides polygons.
entriesOf :: Scene -> ViewFigure -> [Entry]
entriesOf scene figure =
  [Entry (regionSwatch SeenRegion) "seen region" | not (null boundaries)]
    <> [Entry (lineSwatch [SightLimit]) "limit of sight" | not (all (null . uncurry sightLimits) boundaries)]
    <> case figure of
      RegionFigure _ _ -> [viewpoint]
      ElementFigure {} -> [seenSide | seesSide] <> [viewpoint, Entry arrowSwatch "normal"]
      SideFigure side _ ->
        Entry (lineSwatch [SeeingSide]) ("side " <> Text.pack (sideText side)) : [seenSide | seesSide]
  where
    boundaries = boundariesOf scene figure
    viewpoint = Entry (dotSwatch ViewpointDot) "viewpoint"
    seenSide = Entry (lineSwatch [SeenSide]) "seen side"
    arrowSwatch (Box l b r t) = arrowMarks (Place l ((b + t) / 2)) 0 0 (r - l)
    seesSide = or [True | (TheSide _, _) <- factorsOf figure]
