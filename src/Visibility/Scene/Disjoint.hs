-- | Whether segments meet at all, decided by a sweep. For valid scenes it is the whole check of contacts, and unlike a
-- comparison of boxes its cost does not depend on how the sides lie; it does not say what meets.
module Visibility.Scene.Disjoint
  ( Boundaries (..)
  , boundaries
  ) where

import Control.Monad (forM_)
import Data.Foldable (toList)
import Data.Sequence (Seq)
import qualified Data.Sequence as Seq
import qualified Data.Vector.Algorithms.Intro as Intro
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.Predicate
import Visibility.Scene.Contact

-- | Whether segments meet elsewhere than in corners that they share.
data Boundaries = Disjoint | Meet
  deriving (Eq, Show)

-- Note [The sweep]
-- ~~~~~~~~~~~~~~~~
-- Corners are visited in lexicographic order; the status holds the segments with one end visited, ordered upwards
-- (along a line turned from the vertical by as little as you like, so a vertical segment starts at its lower end).
-- Segments that become neighbours in the status are compared. Let p be the least point, in the order of corners, in
-- which segments meet that do not share a corner there; no two corners are in one place, which is checked at the start.
-- Until p the status is in order. If two of the segments through p are in the status just before p, then all that are
-- follow each other, and two neighbours among them that do not share p were compared when the last event made them
-- neighbours. Otherwise one of them starts at p and one at most comes from before: it is next to p in the status, and
-- so to those that start there. So the sweep stops at p or before, and what it relies on is right until then.

-- | Do any of the segments meet, but for segments with a corner in common, which meet there?
--
-- /Requires/ segments with different corners as ends, at most two at each corner, and no two of them with a common
-- corner and the same direction from it.
--
-- /Degenerate cases/ two corners in one place are 'Meet'. Vertical segments and segments on one line are ordinary.
--
-- /Cost/ O(n log² n), however the segments lie.
--
-- /Laws/ 'Meet' exactly when 'meeting' is not 'Apart' for two segments without a common corner, or two corners are in
-- one place.
--
-- /Source/ Shamos and Hoey, Geometric intersection problems, 1976.
boundaries :: Ranked -> [Segment] -> Boundaries
boundaries r segments
  | or [samePlace r (order U.! (k - 1)) (order U.! k) | k <- [1 .. U.length order - 1]] = Meet
  | otherwise = sweep 0 Seq.empty
  where
    -- The other ends of the segments at each corner, two at most, or −1.
    others = otherEnds (rankedTotal r) segments
    atCorner c = [d | k <- [2 * c, 2 * c + 1], let d = others U.! k, d >= 0]
    order = U.modify (Intro.sortBy earlier) (U.filter used (U.enumFromN 0 (rankedTotal r)))
    used c = others U.! (2 * c) >= 0
    earlier a b = compare (column r a) (column r b) <> compare (row r a) (row r b)
    isBefore a b = earlier a b == LT

    -- See Note [The sweep].
    sweep k status
      | k >= U.length order = Disjoint
      | all (uncurry compatible) (neighbours (toList below <> starting <> toList above)) =
          sweep (k + 1) (replaced low width starting status)
      | otherwise = Meet
      where
        c = order U.! k
        starting = upwardsFrom [Segment c d | d <- atCorner c, isBefore c d]
        width = length [() | d <- atCorner c, isBefore d c]
        low = firstNotBelow c status
        below = Seq.lookup (low - 1) status
        above = Seq.lookup (low + width) status

    side c (Segment a b) = turn (rankedPoints r) a b c
    upwardsFrom [s@(Segment _ b), t] = if side b t == LeftTurn then [t, s] else [s, t]
    upwardsFrom other = other
    compatible s@(Segment a b) t@(Segment c d) = a == c || a == d || b == c || b == d || meeting r s t == Apart

    -- The first place whose segment does not run below the corner.
    firstNotBelow c status = search 0 (Seq.length status)
      where
        search from to
          | from >= to = from
          | side c (Seq.index status middle) == LeftTurn = search (middle + 1) to
          | otherwise = search from middle
          where
            middle = (from + to) `div` 2

otherEnds :: Int -> [Segment] -> U.Vector Int
otherEnds n segments = U.create $ do
  ends <- M.replicate (2 * n) (-1)
  forM_ segments $ \(Segment a b) -> forM_ [(a, b), (b, a)] $ \(c, d) -> do
    first <- M.read ends (2 * c)
    M.write ends (if first < 0 then 2 * c else 2 * c + 1) d
  pure ends

neighbours :: [a] -> [(a, a)]
neighbours items = zip items (drop 1 items)

-- Instead of so many items from a place on, others.
replaced :: Int -> Int -> [a] -> Seq a -> Seq a
replaced k 1 [new] items = Seq.update k new items
replaced k width new items = foldr (Seq.insertAt k) (iterate (Seq.deleteAt k) items !! width) new
