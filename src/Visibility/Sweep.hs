-- | The sweeps of the visibility complex: the topological one, and brute force as its oracle.
--
-- +---------------+------------------+-----------------+------------------------------+
-- | algorithm     | time             | live memory     | source                       |
-- +===============+==================+=================+==============================+
-- | 'vertices'    | O(m + n log n)   | O(n)            | Rivière, horizon trees       |
-- +---------------+------------------+-----------------+------------------------------+
-- | 'bruteForce'  | O(n³)            | O(m)            | the definition               |
-- +---------------+------------------+-----------------+------------------------------+
--
-- n corners, m elementary visible pairs. That the chain steps of 'vertices' are O(m) is proved by Rivière for a scan from one
-- end; for the scan from both ends that is used here it is measured.
module Visibility.Sweep
  ( -- * Vertices
    Vertex (..)
  , vertexCorners
  , vertexPairs
  , vertexDirection
  , isDegenerate
  , fromCorners
    -- * The topological sweep
  , vertices
  , Sweep
  , start
  , step
  , trace
  , finish
  , stepsTaken
  , pairsSwept
    -- * The oracle
  , bruteForce
  ) where

import Visibility.Sweep.BruteForce
import Visibility.Sweep.Topological
import Visibility.Sweep.Vertex
