module Visibility.Exact.IntegerRootSpec (spec) where

import Data.Maybe (isJust)
import Test.Hspec
import Test.QuickCheck
import Visibility.Exact.IntegerRoot

isTrueRoot :: Integer -> Bool
isTrueRoot n = let r = integerSquareRoot n in r >= 0 && r * r <= n && n < (r + 1) * (r + 1)

spec :: Spec
spec = do
  describe "integerSquareRoot" $ do
    it "is the floor of the root for all integers to 20000" $
      filter (not . isTrueRoot) [0 .. 20000] `shouldBe` []
    it "is right around powers of two, where the method changes" $
      filter (not . isTrueRoot) [2 ^ e + d | e <- [2 .. 260 :: Int], d <- [-3 .. 3], 2 ^ e + d >= (0 :: Integer)]
        `shouldBe` []
    it "is right at squares and next to them, up to 3000 digits" $
      filter
        (not . isTrueRoot)
        [ n * n + d
        | e <- [1 .. 60] ++ [100, 333, 500, 1000, 1500 :: Int]
        , n <- [10 ^ e - 1, 10 ^ e, 10 ^ e `div` 7, 3 * 10 ^ e + 1, 2 ^ (3 * e) - 1]
        , n > (0 :: Integer)
        , d <- [-1, 0, 1]
        ]
        `shouldBe` []
    it "is right next to squares of machine size" $
      property $ \(NonNegative k) ->
        let n = 2 ^ (31 :: Int) - k in all isTrueRoot [n * n - 1, n * n, n * n + 1, n * n + 2 * n]
    it "is 0 below zero" $ integerSquareRoot (-4) `shouldBe` 0

  describe "exactSquareRoot" $ do
    it "finds exactly the squares to 100000" $
      [n | n <- [-50 .. 100000], isJust (exactSquareRoot n)] `shouldBe` takeWhile (<= 100000) [i * i | i <- [0 ..]]
    it "finds huge squares, and nothing next to them" $
      property $
        forAll (choose (2, 10 ^ (200 :: Int))) $ \n ->
          map exactSquareRoot [n * n - 1, n * n, n * n + 1] === [Nothing, Just n, Nothing]
    it "is not taken in by integers that are squares modulo 64, 63, 65 and 11" $
      property $
        forAll ((,) <$> choose (1, 10 ^ (30 :: Int)) <*> choose (1, 10 ^ (6 :: Int))) $ \(n, j) ->
          let a = n * n + 64 * 63 * 65 * 11 * j; r = integerSquareRoot a
           in exactSquareRoot a === if r * r == a then Just r else Nothing
