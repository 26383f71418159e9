-- | The abstract valid scene, as others see it: the package shows this module as @Visibility.Scene@.
--
-- Ids of corners and sides come from a scene only, and a scene comes from 'Visibility.Scene.Validate.validate' only. So
-- nothing here can fail on a scene's own ids and names, or break what holds of a scene.
module Visibility.Surface.Scene
  ( -- * The scene
    Scene
  , Surroundings (..)
  , sceneTitle
  , surroundings
    -- * Polygons
  , Polygon (..)
  , scenePolygons
  , statedCorners
    -- * Corners
  , CornerId
  , cornerCount
  , corners
  , cornerPoint
  , nextCorner
  , previousCorner
  , samePlace
  , isWallEnd
    -- ** Their names
  , PolygonId (..)
  , CornerName (..)
  , polygonText
  , cornerText
  , readCornerName
  , cornerName
  , namesHere
  , cornersNamed
  , statedPoint
    -- * Sides
  , SideId
  , sides
  , sideStart
  , sideEnd
  , sideMaterial
    -- ** Their names
  , SideName (..)
  , sideText
  , sideName
  , statedSides
  , piecesOf
    -- * What is seen
  , Object (..)
  , Seen (..)
  , seenAs
  , seenText
  ) where

import Data.Text (Text)
import Visibility.Scene hiding (scenePolygons, sceneTitle, surroundings)
import qualified Visibility.Scene as Inside

-- | The name that the file gives, fit to be shown: control characters are replaced by U+FFFD.
sceneTitle :: Scene -> Maybe Text
sceneTitle = Inside.sceneTitle

-- | Whether there is an enclosure.
surroundings :: Scene -> Surroundings
surroundings = Inside.surroundings

-- | In the file's order, the enclosure last.
scenePolygons :: Scene -> [Polygon]
scenePolygons = Inside.scenePolygons
