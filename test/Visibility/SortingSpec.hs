module Visibility.SortingSpec (spec) where

import Data.List (group, sortOn)
import qualified Data.Vector.Unboxed as U
import Test.Hspec
import Test.QuickCheck
import Visibility.Sorting

spec :: Spec
spec = do
  describe "sortedPairs" $
    it "sorts by pairs" $
      forAll (listOf ((,) <$> choose (0, 9) <*> choose (0, 9))) $ \pairs ->
        map parts (U.toList (sortedPairs 10 id (U.fromList (map (uncurry pairOf) pairs)))) === sortOn id pairs
  describe "runs" $
    it "begin where the part changes, and end with the number of items" $
      forAll (listOf (choose (0, 3 :: Int))) $ \items ->
        U.toList (runs id (U.fromList items)) === scanl (+) 0 (map length (group items))
  describe "bucketsBy" $
    it "has the items of each bucket in their own order, and none of a negative bucket" $
      forAll (listOf (choose (-2, 9))) $ \owners ->
        let buckets = bucketsBy 10 (U.fromList (map fromIntegral owners))
            expected = [[i | (i, o) <- zip [0 ..] owners, o == g] | g <- [0 .. 9 :: Int]]
         in (map (bucketOf buckets) [0 .. 9] === expected)
              .&&. (map (map fromIntegral . U.toList . bucketSlice buckets) [0 .. 9] === expected)
