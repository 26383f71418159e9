-- | The half turn in two ranges of directions that are swept apart, so that two processors can share the work.
module Visibility.Sweep.Range
  ( halvesInPieces
  ) where

import Visibility.Scene (Scene)
import Visibility.Scene.Turned (quarterTurned)
import Visibility.Sweep.Piece
import Visibility.Sweep.Topological

-- | The vertices with directions up to 0°, which is one of them, and those beyond it. Either stream can be evaluated
-- without the other.
--
-- /Cost/ of each that of 'vertices' to start, and O(n log n) to turn the scene for the second; then O(1) for each of
-- its pairs and chain steps.
--
-- /Laws/ both together are the vertices of the scene; in the first followed by the second, each corner's vertices come
-- by increasing direction.
halvesInPieces :: Scene -> ([Piece], [Piece])
halvesInPieces scene = (quarterInPieces scene, map (renamed original) (quarterInPieces turned))
  where
    (turned, original) = quarterTurned scene
