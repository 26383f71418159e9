-- | Sizes of the visibility complex, counted along the stream of events in O(n) memory.
module Visibility.Count
  ( Counts (..)
  , count
  , facesBegun
  ) where

import Data.List (foldl')
import Visibility.Scene
import Visibility.Sweep.Vertex
import Visibility.View

-- | How many there are of each.
data Counts = Counts
  { vertexCount :: !Int
  , degenerateCount :: !Int
  -- ^ Vertices with three or more corners.
  , pairCount :: !Int
  -- ^ m, the elementary visible pairs, as the file calls them.
  , bitangentCount :: !Int
  -- ^ Elementary pairs whose line is tangent at both corners, sides left out.
  , edgeCount :: !Int
  , buriedCount :: !Int
  -- ^ Intervals between consecutive vertices of a corner in which it is buried.
  , faceCount :: !Int
  }
  deriving (Eq, Show)

-- | Counts all events of a half turn.
--
-- Every edge begins at one vertex, and so does every face but one: under an open sky the lines that miss everything
-- form a face without a first vertex.
--
-- /Cost/ O(1) per elementary pair.
--
-- /Laws/ V − E − B + F = W + 1 under an open sky and W in a room, for V vertices, E edges, B buried intervals, F faces
-- and W thin walls. In general position the complex of convex polygons under an open sky has E = 2 V and F = V + 1.
count :: Scene -> [Event] -> Counts
count scene = foldl' add (Counts 0 0 0 0 0 0 unbounded)
  where
    unbounded = case surroundings scene of
      OpenSky -> 1
      Room -> 0
    add counts (Event vertex _ after) =
      Counts
        { vertexCount = vertexCount counts + 1
        , degenerateCount = degenerateCount counts + (if isDegenerate scene vertex then 1 else 0)
        , pairCount = pairCount counts + statedTotal (vertexPairs scene vertex)
        , bitangentCount = bitangentCount counts + statedTotal (freeBitangents scene vertex)
        , edgeCount = edgeCount counts + length (filter (not . isBuried) after)
        , buriedCount = buriedCount counts + length (filter isBuried after)
        , faceCount = faceCount counts + facesBegun scene vertex
        }
    statedTotal = sum . map (statedPairCount scene)

-- | The faces that begin at a vertex: one for each of its elementary pairs, two for that of the two ends of a thin wall
-- that nothing touches.
facesBegun :: Scene -> Vertex -> Int
facesBegun scene = sum . map faces . vertexPairs scene
  where
    faces (p, q) = if nextCorner scene p == q && previousCorner scene p == q then 2 else 1
