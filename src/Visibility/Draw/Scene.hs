{-# LANGUAGE OverloadedStrings #-}

-- | The figure of a scene: its polygons, what gives light, and all free bitangents.
module Visibility.Draw.Scene
  ( sceneDrawing
  ) where

import Data.List (foldl', sort)
import Data.Maybe (fromMaybe, mapMaybe)
import qualified Data.Text as Text
import Visibility.Draw.Drawing
import Visibility.Draw.Labels
import Visibility.Draw.Legend
import Visibility.Draw.Scale
import Visibility.Exact.Point
import Visibility.Exact.Predicate (Turn (..), turn)
import Visibility.Scene
import Visibility.Scene.Raw (Material (..))
import Visibility.Sweep.Vertex
import Visibility.View (freeBitangents)

-- | The scene drawn to scale, 800 pixels wide.
--
-- Layers, from the bottom: @outside@ and @room@ of an enclosure; @bitangents@, named @0.1 2.3@; @polygons@, named as
-- in output; @lights@, named by their sides; @flat-corners@, dots; @leaders@, @labels@; @legend@. Up to 40 corners are
-- labelled; where there are more, the polygons are numbered that have room for it.
--
-- /Degenerate cases/ a scene without height or width is drawn on a strip. The light of a thin wall is drawn on the
-- face that gives it.
--
-- /Requires/ all vertices of the scene, in any order. /Cost/ O(m log m), besides labels.
--
-- /Laws/ the order of the vertices makes no difference; every polygon and every free bitangent has exactly one mark;
-- no label covers a line, an outline or another label.
sceneDrawing :: Scene -> [Vertex] -> Drawing
sceneDrawing scene vertices =
  Drawing
    { drawingTitle = title
    , drawingDescription = "Polygons of the scene and its free bitangents: " <> Text.intercalate ", " facts <> "."
    , drawingWidth = width
    , drawingHeight = height
    , drawingLayers =
        filter
          (not . null . layerMarks)
          [ Layer "outside" Sparse outside
          , Layer "room" Sparse room
          , Layer "bitangents" (densityOf (length bitangents)) bitangents
          , Layer "polygons" polygonDensity polygons
          , Layer "lights" polygonDensity lights
          , Layer "flat-corners" Sparse flatCorners
          , Layer "leaders" Sparse leaders
          , Layer "labels" Sparse labels
          , Layer "legend" Sparse (titleMark : legendMarks <> scaleBar <> caption)
          ]
    }
  where
    title = fromMaybe "Untitled scene" (sceneTitle scene)
    frame = frameFor scene
    place = placeOf scene frame
    bitangents =
      [ Mark (nameOf p <> " " <> nameOf q) Bitangent (Polyline [place p, place q])
      | (p, q) <- sort (concatMap (freeBitangents scene) vertices)
      ]
    nameOf = Text.pack . cornerText . cornerName scene
    polygons = map (polygonMark place) (scenePolygons scene)
    polygonDensity = densityOf (cornerCount scene)
    enclosures = [map place (polygonCorners polygon) | polygon <- scenePolygons scene, polygonId polygon == Enclosure]
    room = [Mark "E" RoomFloor (Region places) | places <- enclosures]
    outside = [Mark "E" Outside (boxRegion (frameOutside frame)) | _ <- enclosures]
    lights = concatMap (lightMarks scene place) (sides scene)

    -- Where a label names a corner that no outline shows.
    flatCorners =
      [ Mark (nameOf c) VertexDot (Dot (place c))
      | cornerCount scene <= 40
      , c@(CornerId i) <- corners scene
      , let (CornerId before, CornerId after) = (previousCorner scene c, nextCorner scene c)
      , before /= after
      , turn (scenePoints scene) before i after == Collinear
      ]
    scenery =
      Obstruction
        { canvas = frameOutside frame
        , lightLines = concatMap wide (bitangents <> lights)
        , walls = concatMap wide polygons
        , taken = [widened (dotRadius Sparse VertexDot) (Box x y x y) | Mark _ _ (Dot (Place x y)) <- flatCorners]
        , clearance = 1.5
        }
    (labels, leaders, unlabelled)
      | cornerCount scene <= 40 = placeLabels scenery (map (cornerRequest scene place) (corners scene))
      | otherwise = (mapMaybe (polygonLabel place (concatMap wide lights)) (scenePolygons scene), [], [])

    wide mark = map (Line (strokeWidth Sparse (markStyle mark) / 2)) (strokes mark)

    width = canvasWidth
    top = frameHeight frame + footHeight
    height = top + 40
    titleMark =
      plain FigureTitle $
        Label StartAnchor (Place sideMargin (height - 25)) (shortened FigureTitle (width - 2 * sideMargin) title)
    footHeight = frameFoot frame
    (legendTop, legendWidth) = (footHeight - 6, width - 2 * sideMargin - 150)
    legendMarks = legend sideMargin legendTop legendWidth entries
    entries =
      [Entry (regionSwatch Opaque) "opaque" | any isSolid (scenePolygons scene)]
        <> [Entry (lineSwatch [ThinWall]) "thin wall" | any isThin (scenePolygons scene)]
        <> [Entry (lineSwatch [Bitangent]) "free bitangent" | not (null bitangents)]
        <> [Entry (lineSwatch [LightRim, LightSource]) "light source" | not (null lights)]
    caption = captionLines sideMargin (legendTop - legendHeight legendWidth entries - 15) (width - 2 * sideMargin) facts
    scaleBar = scaleMarks scene frame (Place (width - sideMargin) (legendTop - rowHeight / 2))
    facts =
      [ counted (length (scenePolygons scene)) "polygon" "polygons"
      , counted (cornerCount scene) "corner" "corners"
      , countedVertices vertexTotal degenerate
      , counted pairs "elementary visible pair" "elementary visible pairs"
      , counted (length bitangents) "free bitangent" "free bitangents"
      ]
        <> countedUnlabelled unlabelled
    Totals vertexTotal degenerate pairs = foldl' addVertex (Totals 0 0 0) vertices
    addVertex (Totals a b c) vertex =
      Totals (a + 1) (if isDegenerate vertex then b + 1 else b) (c + length (vertexPairs vertex))

data Totals = Totals !Int !Int !Int

-- | Where the scene lies on the canvas.
data Frame = Frame
  { frameScale :: !Double
  -- ^ Pixels per lattice extent, the longer side of the bounding box.
  , frameExtent :: !Integer
  , frameOrigin :: !Place
  -- ^ The place of the lattice's origin, the lower left of the bounding box.
  , frameOutside :: !Box
  -- ^ What the figure fills, margins included.
  , frameFoot :: !Double
  -- ^ Room below the figure.
  , frameHeight :: !Double
  }

canvasWidth, sideMargin, plotMargin, tallest, lowest :: Double
canvasWidth = 800
sideMargin = 16
plotMargin = 34
tallest = 760
lowest = 90

-- | The scene as large as 800 pixels of width and 'tallest' of height admit, in the middle.
frameFor :: Scene -> Frame
frameFor scene = Frame scale extent (Place originX originY) outside foot (plotHeight + 2 * plotMargin)
  where
    points = map (cornerAt scene) (corners scene)
    right = maximum (0 : [x | Vector2 x _ <- points])
    up = maximum (0 : [y | Vector2 _ y <- points])
    extent = maximum [1, right, up]
    (w, h) = (quotient right extent, quotient up extent)
    plotWidth = canvasWidth - 2 * (sideMargin + plotMargin)
    scale = if h * plotWidth <= w * tallest then plotWidth / w else tallest / h
    plotHeight = fromIntegral (ceiling (max lowest (scale * h)) :: Int)
    foot = 66
    originX = (canvasWidth - scale * w) / 2
    originY = foot + plotMargin + (plotHeight - scale * h) / 2
    outside = Box sideMargin foot (canvasWidth - sideMargin) (foot + plotHeight + 2 * plotMargin)

placeOf :: Scene -> Frame -> CornerId -> Place
placeOf scene frame c = Place (ox + part x) (oy + part y)
  where
    Vector2 x y = cornerAt scene c
    Place ox oy = frameOrigin frame
    part v = frameScale frame * quotient v (frameExtent frame)

boxRegion :: Box -> Shape
boxRegion (Box l b r t) = Region [Place l b, Place r b, Place r t, Place l t]

isSolid, isThin :: Polygon -> Bool
isSolid = not . isThin
isThin polygon = length (polygonCorners polygon) == 2

polygonMark :: (CornerId -> Place) -> Polygon -> Mark
polygonMark place polygon
  | polygonId polygon == Enclosure = Mark name RoomWall (Polyline (places <> take 1 places))
  | isThin polygon = Mark name ThinWall (Polyline places)
  | otherwise = Mark name Opaque (Region places)
  where
    name = Text.pack (polygonText (polygonId polygon))
    places = map place (polygonCorners polygon)

-- | A band along the side and short rays from it into free space, which lies to the right of the side.
lightMarks :: Scene -> (CornerId -> Place) -> SideId -> [Mark]
lightMarks scene place side
  | emission (sideMaterial scene side) <= 0 = []
  | otherwise =
    [Mark name LightRim (Polyline [from, to]), Mark name LightSource (Polyline [from, to])]
      <> [ Mark name LightRay (Polyline [along (k / count) 4.5, along (k / count) 9])
         | long > 0
         , k <- takeWhile (< count) (map (+ 0.5) [0 ..])
         ]
  where
    name = Text.pack (sideText (sideName scene side))
    Place x0 y0 = place (sideStart side)
    Place x1 y1 = place (sideEnd scene side)
    (dx, dy) = (x1 - x0, y1 - y0)
    long = sqrt (dx * dx + dy * dy)
    count = max 1 (fromIntegral (round (long / 12) :: Int)) :: Double
    -- Only one face of a thin wall may shine, so its band lies beside it.
    beside = if isWallCorner scene (sideStart side) then 2.6 else 0
    (from, to) = if long > 0 then (along 0 0, along 1 0) else (Place x0 y0, Place x1 y1)
    along s out = Place (x0 + s * dx + (beside + out) * dy / long) (y0 + s * dy - (beside + out) * dx / long)

-- | A label that had best lie where the free angle of its corner is widest, opposite the solid.
cornerRequest :: Scene -> (CornerId -> Place) -> CornerId -> Request
cornerRequest scene place c = Request name CornerLabel name [Seat here outward pi]
  where
    name = Text.pack (cornerText (cornerName scene c))
    here = place c
    next = bearing (place (nextCorner scene c))
    previous = bearing (place (previousCorner scene c))
    -- Free space runs counter-clockwise from the preceding side to the following one.
    outward = previous + positive (next - previous) / 2
    positive a = if a <= 0 then a + 2 * pi else a
    bearing (Place x y) = let Place hx hy = here in atan2 (y - hy) (x - hx)

polygonLabel :: (CornerId -> Place) -> [Line] -> Polygon -> Maybe Mark
polygonLabel place bands polygon
  | polygonId polygon == Enclosure || isThin polygon = Nothing
  | otherwise = labelInside bands number PolygonLabel texts (map place (polygonCorners polygon))
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
    unit = fromInteger (frameExtent frame) / fromInteger (latticeScale (sceneLattice scene))
    left = right - frameScale frame * fromRational (bar / unit)
