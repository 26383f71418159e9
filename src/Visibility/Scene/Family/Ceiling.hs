-- | Scenes with one long convex chain of tree edges that many corners look at, one after the other.
--
-- Of k² + k corners of a convex ceiling, a steep column of k corners sees the k on the right only, each of them as far
-- as a corner of its own, where its tangent touches the ceiling. A search for that corner that began at the far end of
-- the chain would pass the k² corners on the left each time: k³ steps for some k² pairs. See docs/scan-bound.md.
--
-- The ceiling is a parabola: its corners are (4u, u²). So each corner c of the column lies on a tangent of it.
module Visibility.Scene.Family.Ceiling
  ( aboveColumn
  , aboveTower
  ) where

-- | The ceiling; a wall that hangs from it, but for a gap, and hides its left part; and the column, of so many walls.
aboveColumn :: Integer -> [[(Integer, Integer)]]
aboveColumn k =
  [ceiling' k, [(4 * k * k - 2, k ^ (4 :: Int) - k * k + k `div` 2), (4 * k * k - 3, ground k)]]
    <> [[(x, y), (x + 1, y - 1)] | (x, y) <- drop 1 (column k)]

-- | The ceiling, and a tower, whose convex flank is the column. Its roof is the tangent at its end on the right.
aboveTower :: Integer -> [[(Integer, Integer)]]
aboveTower k =
  [ceiling' k, column k <> [(4 * k * k - 1, ground k), (4 * end, ground k), (4 * end, end * end)]]
  where
    end = 2 * k * k + k

-- | At u = 0, 1, …, k² − 1, and at u = k² + k, k² + 2k, …, 2k².
ceiling' :: Integer -> [(Integer, Integer)]
ceiling' k =
  [(4 * u, u * u) | u <- [0 .. k * k - 1] <> [k * k + i * k | i <- [1 .. k]]]
    <> [(8 * k * k, 5 * k ^ (4 :: Int)), (0, 5 * k ^ (4 :: Int))]

-- | From the lowest corner to the highest one, where tangents touch the ceiling further and further to the left; the
-- first of them touches the parabola beyond the ceiling.
column :: Integer -> [(Integer, Integer)]
column k = [(4 * k * k + 2 * i, c * (2 * k * k + i - c)) | i <- [k, k - 1 .. 0], let c = k * k + k * (i + 1)]

-- | A height below all others.
ground :: Integer -> Integer
ground k = -3 * k * k * (k + 1)
