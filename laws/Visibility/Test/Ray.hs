-- | What a corner sees, by shooting rays: an oracle for views and edges, written from the definition in rationals.
module Visibility.Test.Ray
  ( -- * Rays
    Sight (..)
  , shoot
  , viewAt
    -- * Edges by rays
  , edgesByRays
  , between
  , primitive
  ) where

import Data.List (minimumBy, sortBy)
import Data.Ratio ((%))
import Visibility.Exact.Point
import Visibility.Exact.Predicate (Direction (..), compareDirections, direction)
import Visibility.Scene
import Visibility.Sweep.BruteForce (bruteForce)
import Visibility.Sweep.Vertex
import Visibility.View

-- | What a ray meets first.
data Sight = Sees !Object | Solid
  deriving (Eq, Ord, Show)

-- | The ray from a corner in a direction in which no other corner lies. It ends at the first side that it
-- crosses. If it crosses that one from the solid to the free, it was in the solid all the way.
shoot :: Scene -> CornerId -> Direction -> Sight
shoot scene c (Direction dx dy)
  | null hits = case surroundings scene of OpenSky -> Sees Sky; Room -> Solid
  | otherwise = case [s | (t, s, True) <- hits, t == nearest] of
      s : _ -> Sees (Side s)
      [] -> Solid
  where
    Vector2 cx cy = cornerAt scene c
    nearest = minimum [t | (t, _, _) <- hits]
    hits =
      [ (t, s, inward > 0)
      | s <- sides scene
      , sideStart s /= c
      , sideEnd scene s /= c
      , let Vector2 ax ay = cornerAt scene (sideStart s)
      , let Vector2 bx by = cornerAt scene (sideEnd scene s)
      , let (ex, ey) = (bx - ax, by - ay)
      , let inward = ex * dy - ey * dx
      , inward /= 0
      , let t = ((ax - cx) * ey - (ay - cy) * ex) % negate inward
      , let u = ((ax - cx) * dy - (ay - cy) * dx) % negate inward
      , t > 0
      , u > 0
      , u < 1
      ]

-- | The view of a corner at a direction in which, forward and backward, no other corner lies.
viewAt :: Scene -> CornerId -> Direction -> View
viewAt scene c d@(Direction dx dy) = case (shoot scene c (Direction (-dx) (-dy)), shoot scene c d) of
  (Sees back, Sees front) -> Tangent flank back front
  (Sees back, Solid) -> Ending Front back
  (Solid, Sees front) -> Ending Back front
  (Solid, Solid) -> Buried flank
  where
    Vector2 cx cy = cornerAt scene c
    Vector2 nx ny = cornerAt scene (nextCorner scene c)
    flank = if dx * (ny - cy) - dy * (nx - cx) > 0 then Above else Below

-- | All edges by brute force: each corner's vertices cut the half turn into intervals, and one ray each way tells the
-- view in each.
--
-- /Cost/ O(n³).
edgesByRays :: Scene -> [Edge]
edgesByRays scene =
  [ Edge c (primitive from) (primitive to) view
  | c <- corners scene
  , let directions = sortBy compareDirections [vertexDirection scene v | v <- found, c `elem` vertexCorners v]
  , (from, to) <- zip (Direction 0 (-1) : directions) (directions <> [Direction 0 1])
  , primitive from /= primitive to
  , let view = viewAt scene c (between from (firstAfter from (linesThrough c <> [to])))
  , not (isBuried view)
  ]
  where
    found = bruteForce scene
    -- Towards every other corner, seen or not.
    linesThrough c = [ direction (scenePoints scene) (min (index c) (index q)) (max (index c) (index q))
                     | q <- corners scene
                     , q /= c
                     ]
    index (CornerId k) = k
    firstAfter from = minimumBy compareDirections . filter (from `earlier`)
    earlier (Direction 0 (-1)) _ = True
    earlier a b = compareDirections a b == LT

-- | A direction strictly between two others, the first reached before the second.
between :: Direction -> Direction -> Direction
between a b = case (primitive a, primitive b) of
  (Direction 0 (-1), Direction 0 1) -> Direction 1 0
  (Direction ax ay, Direction bx by) -> Direction (ax + bx) (ay + by)

-- | The same direction in lowest terms.
primitive :: Direction -> Direction
primitive (Direction x y) = let g = max 1 (gcd x y) in Direction (x `quot` g) (y `quot` g)
