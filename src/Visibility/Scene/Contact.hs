-- | How two segments between corners meet, decided exactly.
module Visibility.Scene.Contact
  ( -- * Corners with their ranks
    Ranked (..)
  , column
  , row
  , ranked
  , samePlace
  , lexicographic
    -- * Segments
  , Segment (..)
  , segmentBox
  , Meeting (..)
  , Touch (..)
  , meeting
    -- * Rays
  , isBelow
  ) where

import Data.Int (Int32)
import qualified Data.Vector as V
import qualified Data.Vector.Algorithms.Intro as Intro
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Scene.Boxes (Box (..))
import Visibility.Sorting (denseRanks)

-- | Corners by index, with the ranks of their coordinates: a comparison of ranks is a comparison of coordinates.
data Ranked = Ranked
  { rankedPoints :: !Points
  , rankTable :: !(U.Vector Int32)
  -- ^ Ranks of x and y of corner i at 2i and 2i+1. Small coordinates are their own ranks.
  }

-- | /Requires/ places of a lattice. /Cost/ O(n log n).
ranked :: Places -> Ranked
ranked places = Ranked (pointsOn Filtered places) $ case places of
  SmallPlaces xs -> xs
  LargePlaces points ->
    interleaved (ranksOf (V.map (fst . coordinates) points)) (ranksOf (V.map (snd . coordinates) points))
  where
    ranksOf table = denseRanks (\i j -> compare (table V.! i) (table V.! j)) (V.length table)
    interleaved xs ys = U.generate (2 * U.length xs) (\k -> (if even k then xs else ys) U.! (k `quot` 2))

-- | The number of corners.
rankedTotal :: Ranked -> Int
rankedTotal r = U.length (rankTable r) `quot` 2

-- | Equal columns are equal x, lesser ones lesser x.
column, row :: Ranked -> Int -> Int
column r i = fromIntegral (rankTable r U.! (2 * i))
row r i = fromIntegral (rankTable r U.! (2 * i + 1))
{-# INLINE column #-}
{-# INLINE row #-}

-- | Are two corners in one place?
samePlace :: Ranked -> Int -> Int -> Bool
samePlace r a b = column r a == column r b && row r a == row r b
{-# INLINE samePlace #-}

-- | The corners in the lexicographic order of their places, those in one place in their own order.
--
-- /Cost/ O(n log n) comparisons of machine integers.
lexicographic :: Ranked -> U.Vector Int32
lexicographic r = U.map fromIntegral (U.modify (Intro.sortBy order) (U.enumFromN 0 (rankedTotal r)))
  where
    order i j = compare (column r i) (column r j) <> compare (row r i) (row r j) <> compare i j

-- | A closed segment between two corners, which may be in one place.
data Segment = Segment !Int !Int
  deriving (Eq, Show)

-- | The box around a segment, in ranks.
segmentBox :: Ranked -> Segment -> Box
segmentBox r (Segment a b) = Box (min x x') (max x x') (min y y') (max y y')
  where
    x = column r a
    x' = column r b
    y = row r a
    y' = row r b

-- | How two segments meet.
data Meeting
  = Apart
  | -- | In one point, which is an end of neither, and not along each other.
    Crossing
  | -- | With an end of one in the other; where they overlap, every end that lies in the other.
    Touching ![Touch]
  deriving (Eq, Show)

-- | An end of one segment in the other.
data Touch
  = -- | Ends of the first and of the second in one place.
    Ends !Int !Int
  | -- | An end of the first between the ends of the second.
    FirstOnSecond !Int
  | -- | An end of the second between the ends of the first.
    SecondOnFirst !Int
  deriving (Eq, Ord, Show)

-- | How two segments meet.
--
-- /Degenerate cases/ segments on one line, segments of no length.
--
-- /Laws/ swapping the two, or the ends of one, changes nothing but names.
meeting :: Ranked -> Segment -> Segment -> Meeting
meeting r (Segment a b) (Segment c d)
  | cSide == dSide && cSide /= Collinear = Apart
  | aSide == bSide && aSide /= Collinear = Apart
  | Collinear `notElem` [aSide, bSide, cSide, dSide] = Crossing
  | null touches = Apart
  | otherwise = Touching touches
  where
    points = rankedPoints r
    cSide = turn points a b c
    dSide = turn points a b d
    aSide = turn points c d a
    bSide = turn points c d b
    touches =
      [Ends i j | i <- [a, b], j <- [c, d], samePlace r i j]
        <> [FirstOnSecond i | (i, Collinear) <- [(a, aSide), (b, bSide)], isBetween r c d i]
        <> [SecondOnFirst j | (j, Collinear) <- [(c, cSide), (d, dSide)], isBetween r a b j]

-- Of three corners on a line: does the third lie between the other two, and at neither?
isBetween :: Ranked -> Int -> Int -> Int -> Bool
isBetween r a b c = min (place a) (place b) < place c && place c < max (place a) (place b)
  where
    place i = (column r i, row r i)

-- | Does the vertical ray upwards from a corner hit a segment? A segment holds its left end, not its right end.
--
-- /Requires/ that the corner is not on the segment.
isBelow :: Ranked -> Int -> Segment -> Bool
isBelow r c (Segment a b)
  | leftOf a == leftOf b = False
  | leftOf a = turn points a b c == RightTurn
  | otherwise = turn points b a c == RightTurn
  where
    points = rankedPoints r
    leftOf i = column r i <= column r c
