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
import Visibility.Draw.Scenery
import Visibility.Scene
import Visibility.Sweep.Vertex
import Visibility.View

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
        filter (not . null . layerMarks) $
          groundLayers scene frame
            <> [ Layer "bitangents" (densityOf (length bitangents)) bitangents
               , Layer "polygons" (polygonDensity scene) polygons
               , Layer "lights" (polygonDensity scene) lights
               , Layer "flat-corners" Sparse flatCorners
               , Layer "leaders" Sparse leaders
               , Layer "labels" Sparse labels
               , Layer "legend" Sparse (titleMark height title : legendMarks <> scaleBar <> caption)
               ]
    }
  where
    title = fromMaybe "Untitled scene" (sceneTitle scene)
    frame = frameFor standardFoot scene []
    place = placeOf scene frame
    bitangents =
      [ Mark (nameOf p <> " " <> nameOf q) Bitangent (Polyline [place p, place q])
      | (p, q) <- sort (concatMap (freeBitangents scene) vertices)
      ]
    nameOf = Text.pack . cornerText . cornerName scene
    polygons = polygonMarks scene frame
    lights = lightsOf scene frame
    flatCorners = flatCornerMarks scene frame
    scenery =
      Obstruction
        { canvas = frameOutside frame
        , lightLines = concatMap wideLines (bitangents <> lights)
        , walls = concatMap wideLines polygons
        , taken = dotBoxes flatCorners
        , clearance = 1.5
        }
    (labels, leaders, unlabelled)
      | fewCorners scene = placeLabels scenery (cornerRequests scene frame)
      | otherwise = (mapMaybe inside (scenePolygons scene), [], [])
    inside = polygonLabel (placeOfPoint scene frame) (concatMap wideLines lights)

    width = canvasWidth
    top = frameHeight frame + footHeight
    height = top + 40
    footHeight = frameFoot frame
    (legendTop, legendWidth) = (footHeight - 6, width - 2 * sideMargin - 150)
    legendMarks = legend sideMargin legendTop legendWidth entries
    entries =
      polygonEntries
        <> [Entry (lineSwatch [Bitangent]) "free bitangent" | not (null bitangents)]
        <> lightEntries
    (polygonEntries, lightEntries) = sceneryEntries scene
    caption = captionLines sideMargin (legendTop - legendHeight legendWidth entries - 15) (width - 2 * sideMargin) facts
    scaleBar = scaleMarks scene frame (Place (width - sideMargin) (legendTop - rowHeight / 2))
    facts =
      [ counted (length (scenePolygons scene)) "polygon" "polygons"
      , counted (length (statedCorners scene)) "corner" "corners"
      , countedVertices vertexTotal degenerate
      , counted pairs "elementary visible pair" "elementary visible pairs"
      , counted (length bitangents) "free bitangent" "free bitangents"
      ]
        <> countedUnlabelled unlabelled
    Totals vertexTotal degenerate pairs = foldl' addVertex (Totals 0 0 0) vertices
    addVertex (Totals a b c) vertex =
      Totals (a + 1) (if isDegenerate scene vertex then b + 1 else b) (c + length (pairsOf vertex))
    pairsOf = concatMap (statedPairs scene) . vertexPairs scene

data Totals = Totals !Int !Int !Int
