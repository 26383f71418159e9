-- | The sweeps of the visibility complex: the topological one, fast and as a text, and the straight one.
--
-- +---------------------+--------------------+-------------+-----------------------------------+
-- | algorithm           | time               | live memory | source                            |
-- +=====================+====================+=============+===================================+
-- | 'vertices'          | O(m + n log n)     | O(n)        | Rivière, horizon trees            |
-- +---------------------+--------------------+-------------+-----------------------------------+
-- | 'referenceVertices' | O((m + n) log n)   | O(n)        | the same, over persistent maps    |
-- +---------------------+--------------------+-------------+-----------------------------------+
-- | 'straightVertices'  | O((m + n) log n)   | O(n)        | Orti and others, queue over faces |
-- +---------------------+--------------------+-------------+-----------------------------------+
--
-- n corners, m elementary visible pairs, where no line has many corners; a line of k corners costs O(k log k).
-- docs/scan-bound.md proves the bound of the searches of the topological sweep.
module Visibility.Sweep
  ( -- * Vertices
    module Visibility.Sweep.Vertex
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
  , referenceVertices
    -- * The straight sweep
  , straightVertices
  ) where

import Data.List (unfoldr)
import Visibility.Law (broken)
import Visibility.Scene (Scene, cornerCount)
import Visibility.Sweep.Piece
import qualified Visibility.Sweep.Reference as Reference
import Visibility.Sweep.Straight
import Visibility.Sweep.Topological
import Visibility.Sweep.Vertex

-- | In which order vertices are swept. What is swept does not depend on it.
data Scheduler
  = -- | Any order in which each corner's vertices come by increasing direction.
    Topological
  | -- | By direction: the canonical order.
    Straight
  | -- | The same order as the topological sweep, by the pure steps of "Visibility.Sweep.Reference".
    Reference
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | All vertices of a scene, lazily, in the order of a scheduler.
verticesBy :: Scheduler -> Scene -> [Vertex]
verticesBy Topological = vertices
verticesBy Straight = straightVertices
verticesBy Reference = referenceVertices

-- | All vertices of the complex, lazily, by pure steps over persistent maps.
--
-- /Laws/ @referenceVertices s == vertices s@.
referenceVertices :: Scene -> [Vertex]
referenceVertices scene = zipWith const swept (replicate most () <> more)
  where
    swept = unfoldr (Reference.step scene) (Reference.start scene)
    most = cornerCount scene * (cornerCount scene - 1) `div` 2
    -- Unsafe arithmetic may go round in circles.
    more = broken "each elementary pair is swept once" (show most)

-- | The same vertices in the same order, in pieces of many vertices each.
piecesBy :: Scheduler -> Scene -> [Piece]
piecesBy Topological = verticesInPieces
piecesBy scheduler = inPieces . verticesBy scheduler
