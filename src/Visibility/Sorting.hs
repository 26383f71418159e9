-- | Sorting by counting: for numbers below a bound that is not much greater than their count.
module Visibility.Sorting
  ( -- * Sorting
    denseRanks
  , runs
  , firstWhere
    -- * Buckets
  , Buckets (..)
  , bucketsBy
  , bucketOf
  , bucketSlice
    -- * Two numbers in one
  , Pair
  , pairOf
  , parts
  , sortedPairs
  ) where

import Data.Bits (shiftL, shiftR, (.&.), (.|.))
import Data.Int (Int32)
import qualified Data.Vector.Algorithms.Intro as Intro
import qualified Data.Vector.Algorithms.Radix as Radix
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M

-- | By item, how many smaller items there are, equal ones counted once; items are numbered from 0.
--
-- /Cost/ O(n log n) comparisons.
denseRanks :: (Int -> Int -> Ordering) -> Int -> U.Vector Int32
denseRanks order n = U.update_ (U.replicate n 0) sorted (U.take n (U.scanl' (+) 0 steps))
  where
    sorted = U.modify (Intro.sortBy order) (U.enumFromN 0 n)
    steps = U.zipWith (\i j -> if order i j == EQ then 0 else 1) sorted (U.drop 1 sorted)
{-# INLINE denseRanks #-}

-- | Where runs of equal parts begin, and the number of items.
--
-- >>> runs id (U.fromList "aab")
-- [0,2,3]
runs :: (U.Unbox a, Eq b) => (a -> b) -> U.Vector a -> U.Vector Int
runs part items = U.filter begins (U.enumFromN 0 (n + 1))
  where
    n = U.length items
    begins i = i == 0 || i == n || part (items U.! (i - 1)) /= part (items U.! i)
{-# INLINE runs #-}

-- | The least number from the first on, below the second, from which on a predicate holds; the second if there is none.
--
-- /Requires/ that it holds from somewhere on. /Cost/ O(log) calls.
firstWhere :: (Int -> Bool) -> Int -> Int -> Int
firstWhere holds low high
  | low >= high = high
  | holds middle = firstWhere holds low middle
  | otherwise = firstWhere holds (middle + 1) high
  where
    middle = low + (high - low) `quot` 2

-- | Items by number in buckets by number: where those of each bucket begin and end, and all of them.
data Buckets = Buckets !(U.Vector Int32) !(U.Vector Int32)

-- | The items by their buckets, which are numbered from 0 to just below a bound; in each one in their own order. Those
-- of a negative bucket are left out.
--
-- /Cost/ O(m + n) for m items and a bound n.
--
-- /Laws/ @bucketOf (bucketsBy n owners) g == [i | (i, o) <- zip [0 ..] (U.toList owners), o == g]@.
bucketsBy :: Int -> U.Vector Int32 -> Buckets
bucketsBy bound owners = Buckets starts members
  where
    starts = U.scanl' (+) 0 (U.accumulate (+) (U.replicate bound 0) (U.map (\o -> (fromIntegral o, 1)) owned))
    owned = U.filter (>= 0) owners
    members = U.create $ do
      places <- U.thaw starts
      table <- M.new (U.length owned)
      U.forM_ (U.filter ((>= 0) . snd) (U.indexed owners)) $ \(item, o) -> do
        place <- M.read places (fromIntegral o)
        M.write table (fromIntegral place) (fromIntegral item)
        M.write places (fromIntegral o) (place + 1)
      pure table

-- | The items in a bucket.
bucketOf :: Buckets -> Int -> [Int]
bucketOf buckets = map fromIntegral . U.toList . bucketSlice buckets
{-# INLINE bucketOf #-}

-- | The same, as a part of the table.
bucketSlice :: Buckets -> Int -> U.Vector Int32
bucketSlice (Buckets starts members) g = U.slice from (fromIntegral (starts U.! (g + 1)) - from) members
  where
    from = fromIntegral (starts U.! g)
{-# INLINE bucketSlice #-}

-- | Two numbers from 0 to below 2^32 in one that sorts like the two.
type Pair = Int

pairOf :: Int -> Int -> Pair
pairOf a b = a `shiftL` 32 .|. b
{-# INLINE pairOf #-}

-- | /Law/ @parts (pairOf a b) == (a, b)@.
parts :: Pair -> (Int, Int)
parts k = (k `shiftR` 32, k .&. 0xFFFFFFFF)
{-# INLINE parts #-}

-- | Items by pairs of numbers below the bound.
sortedPairs :: U.Unbox a => Int -> (a -> Pair) -> U.Vector a -> U.Vector a
sortedPairs bound pair = U.modify (Radix.sortBy 2 bound digit)
  where
    -- The lower half first.
    digit 0 = snd . parts . pair
    digit _ = fst . parts . pair
{-# INLINE sortedPairs #-}
