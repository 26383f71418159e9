-- | The points at which Doubles tell left from right wrongly, as scenes.
--
-- /Source/ Kettner, Mehlhorn, Pion, Schirra, Yap, Classroom examples of robustness problems in geometric computations:
-- the turn of (1/2 + x·2⁻⁵³, 1/2 + y·2⁻⁵³), (12, 12) and (24, 24) for 0 ≤ x, y < 256. Its sign is that of y − x, but
-- Doubles do not find it for most x and y, though all coordinates are Doubles.
module Visibility.Scene.Family.Kettner
  ( kettner
  , kettnerUnit
  ) where

import Visibility.Scene.Family.Draw

-- | Coordinates are counted in units of 2⁻⁵³, the distance of neighbouring Doubles between 1/2 and 1.
kettnerUnit :: Rational
kettnerUnit = 1 / 2 ^ (53 :: Int)

-- | A triangle with a corner at (12, 12), one with a corner at (24, 24), and so many tiny ones near (1/2, 1/2).
--
-- The first lies below the diagonal and the second above it, so that the diagonal touches both. Of the corners near
-- (1/2, 1/2) those on or above the diagonal see both points, and those below it see (12, 12) only, unless tiny
-- triangles are in the way. Each has a cell of 16 by 16 units: those on the diagonal, and those beside them. In a cell
-- on the diagonal one corner is exactly on it or, in a half of all cases, a unit beside it. The cells of the first 46
-- are among the 256 by 256 points of the source; those of others go on along the diagonal.
kettner :: Int -> Seed -> [[(Integer, Integer)]]
kettner n seed = map (map (both (* whole))) large <> [runDraw seed k (inCell (cells k)) | k <- [0 .. n - 1]]
  where
    large = [[(12, 12), (13, 9), (16, 11)], [(24, 24), (25, 30), (21, 28)]]
    inCell cell@(i, j) = map (placed cell) <$> if i == j then touching else beside
    placed (i, j) (x, y) = (whole `div` 2 + 16 * i + x, whole `div` 2 + 16 * j + y)
    whole = 2 ^ (53 :: Int)
    both f (x, y) = (f x, f y)

-- | The cell of a tiny triangle: one on the diagonal, the one right of it, the one above it, and so on.
cells :: Int -> (Integer, Integer)
cells k = case toInteger k `quotRem` 3 of
  (m, 0) -> (m, m)
  (m, 1) -> (m + 1, m)
  (m, _) -> (m, m + 1)

-- | A triangle with one corner on the diagonal of its cell or a unit beside it, the others below, or mirrored above.
touching :: Draw [(Integer, Integer)]
touching = do
  a <- between 6 8
  off <- oneOf 0 [0, -1, 1]
  b <- (,) <$> between 3 7 <*> between 0 1
  c <- (,) <$> between 12 14 <*> between 4 8
  mirror <- oneOf id [swapped]
  pure (map mirror [(a, a + off), b, c])

-- | A triangle of any kind.
beside :: Draw [(Integer, Integer)]
beside = do
  a <- (,) <$> between 0 4 <*> between 0 3
  b <- (,) <$> between 10 14 <*> between 0 3
  c <- (,) <$> between 0 14 <*> between 8 14
  mirror <- oneOf id [swapped]
  turn <- oneOf id [opposed]
  pure (map (mirror . turn) [a, b, c])
  where
    opposed (x, y) = (14 - x, 14 - y)

swapped :: (Integer, Integer) -> (Integer, Integer)
swapped (x, y) = (y, x)
