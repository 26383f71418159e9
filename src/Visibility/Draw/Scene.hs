{-# LANGUAGE OverloadedStrings #-}

-- | The figure of a scene: its polygons, what gives light, and all free bitangents.
module Visibility.Draw.Scene
  ( sceneDrawing
  ) where

import Data.List (sort)
import Data.Maybe (fromMaybe)
import Visibility.Draw.Figure
import Visibility.Scene
import Visibility.Sweep.Vertex
import Visibility.View

-- | The scene drawn to scale, 800 pixels wide.
--
-- Layers, from the bottom: @bitangents@, named @0.1 2.3@; @polygons@, named as in output; @lights@, named by their
-- sides; @flat-corners@, dots.
--
-- /Degenerate cases/ a scene without height or width is drawn on a strip. The light of a thin wall is drawn on the
-- face that gives it.
--
-- /Requires/ all vertices of the scene, in any order. /Cost/ O(m log m), besides labels.
--
-- /Laws/ those of 'planeDrawing'; the order of the vertices makes no difference; every polygon and every free bitangent
-- has exactly one mark.
sceneDrawing :: Scene -> [Vertex] -> Drawing
sceneDrawing scene vertices =
  planeDrawing scene $
    scenePlane
      { planeTitle = fromMaybe "Untitled scene" (sceneTitle scene)
      , planeAbout = "Polygons of the scene and its free bitangents: "
      , planeFacts = facts
      , planeEntries =
          polygonEntries <> [Entry (lineSwatch [Bitangent]) "free bitangent" | not (null bitangents)] <> lightEntries
      , planeSheets = \frame ->
          [ Sheet Crossable "bitangents" (densityOf (length bitangents)) $
              map (bitangentMark (placeOf scene frame)) bitangents
          , polygonSheet scene frame
          , Sheet Crossable "lights" (polygonDensity scene) (lightsOf scene frame)
          , Sheet Ground "flat-corners" Sparse (flatCornerMarks scene frame)
          ]
      }
  where
    bitangents = sort (concatMap (freeBitangents scene) vertices)
    bitangentMark place (p, q) =
      Mark (cornerTag scene p <> " " <> cornerTag scene q) Bitangent (Polyline [place p, place q])
    (polygonEntries, lightEntries) = sceneryEntries scene
    facts =
      [ counted (length (scenePolygons scene)) "polygon" "polygons"
      , counted (length (statedCorners scene)) "corner" "corners"
      , countedVertices (length vertices) (length (filter (isDegenerate scene) vertices))
      , counted pairs "elementary visible pair" "elementary visible pairs"
      , counted (length bitangents) "free bitangent" "free bitangents"
      ]
    pairs = sum (map (statedPairCount scene) (concatMap (vertexPairs scene) vertices))
