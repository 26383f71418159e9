-- | The abstract valid scene: corners, sides and polygons with typed ids, on one integer lattice.
--
-- The only door to a 'Scene' is "Visibility.Scene.Validate", which reports every violation. So whoever holds a 'Scene'
-- may rely on its polygons being simple, without spikes, pairwise disjoint and inside the enclosure.
module Visibility.Scene
  ( -- * The scene
    Scene
  , Surroundings (..)
  , sceneTitle
  , surroundings
  , scenePoints
  , sceneLattice
  , sceneArithmetic
  , underArithmetic
    -- * Polygons
  , Polygon (..)
  , scenePolygons
    -- * Corners
  , cornerCount
  , corners
  , cornerName
  , cornerNamed
  , cornerAt
  , cornerPoint
  , nextCorner
  , previousCorner
  , neighbourTable
  , isWallCorner
    -- * Sides
  , sides
  , sideName
  , sideNamed
  , sideStart
  , sideEnd
  , sideMaterial
  , objectText
  , objectOrder
    -- * Names
  , module Visibility.Scene.Id
  ) where

import Visibility.Scene.Id
import Visibility.Scene.Type
