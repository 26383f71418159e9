-- | The sweeps of the visibility complex: the topological one, the straight one, and brute force as their oracle.
--
-- +--------------------+------------------+-------------+-----------------------------------+
-- | algorithm          | time             | live memory | source                            |
-- +====================+==================+=============+===================================+
-- | 'vertices'         | O(m + n log n)   | O(n)        | Rivière, horizon trees            |
-- +--------------------+------------------+-------------+-----------------------------------+
-- | 'straightVertices' | O((m + n) log n) | O(n)        | Orti and others, queue over faces |
-- +--------------------+------------------+-------------+-----------------------------------+
-- | 'bruteForce'       | O(n³)            | O(m)        | the definition                    |
-- +--------------------+------------------+-------------+-----------------------------------+
--
-- n corners, m elementary visible pairs. That the chain steps of 'vertices' are O(m) is proved by Rivière for a scan
-- from one end; for the scan from both ends that is used here it is measured.
module Visibility.Sweep
  ( -- * Vertices
    Vertex (..)
  , vertexCorners
  , vertexFirst
  , vertexLast
  , vertexPairs
  , vertexDirection
  , isDegenerate
  , fromCorners
  , compareVertices
    -- * Either sweep
  , Scheduler (..)
  , verticesBy
  , piecesBy
    -- * Many vertices in one array
  , Piece
  , pieceOf
  , pieceLength
  , pieceVertices
  , pieceNeighbours
    -- * The topological sweep
  , vertices
  , verticesInPieces
  , Sweep
  , start
  , step
  , trace
  , finish
  , stepsTaken
  , pairsSwept
    -- * The straight sweep
  , straightVertices
    -- * The oracle
  , bruteForce
  ) where

import Visibility.Scene (Scene)
import Visibility.Sweep.BruteForce
import Visibility.Sweep.Piece
import Visibility.Sweep.Straight
import Visibility.Sweep.Topological
import Visibility.Sweep.Vertex

-- | In which order vertices are swept. What is swept does not depend on it.
data Scheduler
  = -- | Any order in which each corner's vertices come by increasing direction.
    Topological
  | -- | By direction: the canonical order.
    Straight
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | All vertices of a scene, lazily, in the order of a scheduler.
verticesBy :: Scheduler -> Scene -> [Vertex]
verticesBy Topological = vertices
verticesBy Straight = straightVertices

-- | The same vertices in the same order, in pieces of many vertices each.
piecesBy :: Scheduler -> Scene -> [Piece]
piecesBy Topological = verticesInPieces
piecesBy Straight = inPieces . straightVertices
