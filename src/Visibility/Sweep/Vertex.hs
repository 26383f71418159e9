-- | Vertices of the visibility complex, as the sweeps produce them.
module Visibility.Sweep.Vertex
  ( Vertex (..)
  , vertexCorners
  , vertexPairs
  , isDegenerate
  , vertexDirection
  , compareVertices
  , vertexFirst
  , vertexLast
  , fromCorners
  ) where

import Data.List (groupBy)
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Scene.Cone

-- | A maximal free segment with two or more corners on it: the corners in order along the line, from left to right (the
-- order of their ids), all of them. Two in general position; more make a degenerate vertex, which is as good as any.
--
-- /Degenerate cases/ a line along a thin wall that stands alone runs along both its faces at once. So does one along a
-- wall that something touches, or that has corners between its ends, as long as the two faces lead to one free end:
-- then two corners in one place, one for each face, may follow each other here.
data Vertex = Vertex !CornerId !CornerId ![CornerId]
  deriving (Eq, Ord, Show)

-- | All corners in order along the line, at least two.
vertexCorners :: Vertex -> [CornerId]
vertexCorners (Vertex a b rest) = a : b : rest

-- | The elementary visible pairs of a vertex, from left to right: its consecutive corners. Where the line runs along
-- both faces of a piece of a wall, a pair for each face, that of the upper one first.
--
-- /Cost/ O(1) for each.
vertexPairs :: Scene -> Vertex -> [(CornerId, CornerId)]
vertexPairs scene vertex@(Vertex a b rest)
  | hasSplitEnds scene, any (isSplitEnd scene) line = concat (zipWith (pairsBetween scene) groups (drop 1 groups))
  | otherwise = (a, b) : zip (b : rest) rest
  where
    line = vertexCorners vertex
    groups = groupBy (samePlace scene) line

-- | The pairs of a line between the corners in one place and those in the next one.
pairsBetween :: Scene -> [CornerId] -> [CornerId] -> [(CornerId, CornerId)]
pairsBetween _ [p] [q] = [(p, q)]
pairsBetween scene ps qs
  | null alongSides = [(p, q) | p <- ps, q <- qs, opens p q, opens q p]
  | otherwise = alongSides
  where
    alongSides = upper <> lower
    upper = [(p, q) | p <- ps, q <- qs, previousCorner scene p == q]
    lower = [(p, q) | p <- ps, q <- qs, nextCorner scene p == q]
    opens p q = not (entersSolid scene JustThen p (heading scene p q))

-- | Does the line pass more than two places?
isDegenerate :: Scene -> Vertex -> Bool
isDegenerate scene (Vertex a b rest) = case rest of
  [] -> False
  _ | not (hasSplitEnds scene) -> True
  _ -> length (groupBy (samePlace scene) (a : b : rest)) > 2

-- | The direction of the line, right-going. Not reduced: the displacement from the first corner to the last.
vertexDirection :: Scene -> Vertex -> Direction
vertexDirection scene vertex = direction (scenePoints scene) a b
  where
    CornerId a = vertexFirst vertex
    CornerId b = vertexLast vertex

-- | The corner furthest to the left.
vertexFirst :: Vertex -> CornerId
vertexFirst (Vertex a _ _) = a

-- | The corner furthest to the right.
vertexLast :: Vertex -> CornerId
vertexLast (Vertex _ b rest) = foldl (\_ c -> c) b rest

-- | A vertex from its corners in order; 'Nothing' for fewer than two.
fromCorners :: [CornerId] -> Maybe Vertex
fromCorners (a : b : rest) = Just (Vertex a b rest)
fromCorners _ = Nothing

-- | The canonical order of vertices: by direction, then by offset, then along the line. /Cost/ O(1).
compareVertices :: Scene -> Vertex -> Vertex -> Ordering
compareVertices scene v w =
  turnOrder (headingTurn points a b c d) <> turnOrder (turn points a b c) <> compare a c
  where
    points = scenePoints scene
    (CornerId a, CornerId b) = (vertexFirst v, vertexLast v)
    (CornerId c, CornerId d) = (vertexFirst w, vertexLast w)
