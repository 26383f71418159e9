-- | The abstract valid scene: corners, sides and polygons with typed ids, on one integer lattice.
--
-- The only door to a 'Scene' is "Visibility.Scene.Validate", which reports every violation. So whoever holds a 'Scene'
-- may rely on its polygons being simple, without spikes, without overlaps and inside the enclosure. Where they touch,
-- the boundary of free space is cut into walks that share places but never meet ("Visibility.Scene.Boundary"): corners
-- and sides are those of the walks, and know what the file calls them.
module Visibility.Scene
  ( module Visibility.Scene.Type
  , module Visibility.Scene.Id
  ) where

import Visibility.Scene.Id
import Visibility.Scene.Type (Scene)
import Visibility.Scene.Type hiding
  ( Scene (Scene)
  , assemble
  , piecesBySide
  , sceneOn
  , sceneStated
  , splitEnds
  , statedByPlace
  , statedPlaceNumbers
  )
