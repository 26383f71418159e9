-- | Vertices of the visibility complex, as the sweeps produce them.
module Visibility.Sweep.Vertex
  ( Vertex (..)
  , vertexCorners
  , vertexPairs
  , isDegenerate
  , vertexDirection
  , compareVertices
  , vertexLast
  , fromCorners
  ) where

import Visibility.Exact.Predicate
import Visibility.Scene

-- | A maximal free segment with two or more corners on it: the corners in order along the line, from left to right (the
-- order of their ids), all of them. Two in general position; more make a degenerate vertex, which is as good as any.
data Vertex = Vertex !CornerId !CornerId ![CornerId]
  deriving (Eq, Ord, Show)

-- | All corners in order along the line, at least two.
vertexCorners :: Vertex -> [CornerId]
vertexCorners (Vertex a b rest) = a : b : rest

-- | The elementary visible pairs of a vertex: its consecutive corners.
vertexPairs :: Vertex -> [(CornerId, CornerId)]
vertexPairs (Vertex a b rest) = (a, b) : zip (b : rest) rest

-- | Are there more than two corners on the line?
isDegenerate :: Vertex -> Bool
isDegenerate (Vertex _ _ rest) = not (null rest)

-- | The direction of the line, right-going. Not reduced: the displacement from the first corner to the second.
vertexDirection :: Scene -> Vertex -> Direction
vertexDirection scene (Vertex (CornerId a) (CornerId b) _) = direction (scenePoints scene) a b

-- | The corner furthest to the right.
vertexLast :: Vertex -> CornerId
vertexLast (Vertex _ b rest) = foldl (\_ c -> c) b rest

-- | A vertex from its corners in order; 'Nothing' for fewer than two.
fromCorners :: [CornerId] -> Maybe Vertex
fromCorners (a : b : rest) = Just (Vertex a b rest)
fromCorners _ = Nothing

-- | The canonical order of vertices: by direction, then by offset, then along the line. /Cost/ O(1).
compareVertices :: Scene -> Vertex -> Vertex -> Ordering
compareVertices scene (Vertex (CornerId a) (CornerId b) _) (Vertex (CornerId c) (CornerId d) _) =
  case headingTurn points a b c d of
    LeftTurn -> LT
    RightTurn -> GT
    Collinear -> case turn points a b c of
      LeftTurn -> LT
      RightTurn -> GT
      Collinear -> compare a c
  where
    points = scenePoints scene
