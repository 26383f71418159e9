module Visibility.Scene.PackedSpec (spec) where

import Data.Ratio ((%))
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Visibility.Exact.Point (Point (..))
import Visibility.Scene.Packed

spec :: Spec
spec = do
  describe "unpacked" $ do
    prop "unpacked (packed ps) == ps" $ forAll points $ \ps -> unpacked (packed ps) === ps
    prop "does not depend on what else is in the list" $ forAll ((,) <$> points <*> points) $ \(ps, qs) ->
      unpacked (packed ps) <> unpacked (packed qs) === unpacked (packed (ps <> qs))
  describe "packed" $
    prop "packed ps == packed qs just if ps == qs" $ forAll ((,) <$> points <*> points) $ \(ps, qs) ->
      (packed ps == packed ps, packed ps == packed qs) === (True, ps == qs)
  describe "packedLength" $
    prop "is the number of points" $ forAll points $ \ps -> packedLength (packed ps) === length ps

-- Up to the bounds of what is a machine integer over the common denominator, and beyond.
points :: Gen [Point]
points = do
  number <- elements [whole, decimals, oneof [whole, decimals, fractions, bounds]]
  upTo 5 (Point <$> number <*> number)
  where
    whole = fromInteger <$> choose (-3, 3)
    decimals = (\n k -> n % 10 ^ k) <$> choose (-10 ^ (12 :: Int), 10 ^ (12 :: Int)) <*> choose (0, 12 :: Int)
    fractions = (%) <$> choose (-100, 100) <*> elements [1, 3, 2 ^ (31 :: Int), 3 ^ (20 :: Int), 2 ^ (64 :: Int)]
    bounds = (\n d -> (2 ^ (63 :: Int) + n) / d) <$> elements [-2 .. 2] <*> elements [-2, -1, 1, 2]
    upTo n g = choose (0, n :: Int) >>= \k -> vectorOf k g
