-- | Rays and all edges of a scene by shooting them: an oracle for views and edges.
module Visibility.Test.Ray
  ( Hit (..)
  , shoot
  , viewAt
  , edgesByRays
  ) where

import Data.List (minimumBy, sortBy)
import Visibility.Exact.Predicate (Direction (..), compareDirections, direction, primitive)
import Visibility.Ray
import Visibility.Scene
import Visibility.Sweep.Vertex
import Visibility.Test.BruteForce (bruteForce)
import Visibility.Test.Scan (Hit (..))
import Visibility.View

-- | The ray from a corner.
--
-- /Requires/ a direction in which no other corner is seen, that does not run along a side of the corner.
-- /Cost/ O(n).
shoot :: Scene -> CornerId -> Direction -> Hit
shoot scene c d = case viewAt scene c d of
  Tangent _ _ front -> Meets front
  Ending Back front -> Meets front
  _ -> Solid

-- | The view of a corner. /Requires/ what 'viewFrom' does. /Cost/ O(n).
viewAt :: Scene -> CornerId -> Direction -> View Object
viewAt = viewFrom . raysIn

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
                     , not (samePlace scene q c)
                     ]
    index (CornerId k) = k
    firstAfter from = minimumBy compareDirections . filter (from `earlier`)
    earlier (Direction 0 (-1)) _ = True
    earlier a b = compareDirections a b == LT
