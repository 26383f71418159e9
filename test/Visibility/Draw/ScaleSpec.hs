module Visibility.Draw.ScaleSpec (spec) where

import qualified Data.Text as Text
import Test.Hspec
import Test.QuickCheck
import Visibility.Draw.Scale
import Visibility.Exact.Predicate (Direction (..))

spec :: Spec
spec = do
  describe "roundStep" $ do
    it "is the largest of 1, 2 and 5 times a power of ten that is at most the argument" $
      property $ \(Positive x) ->
        let step = roundStep x
            next = if leading step == 2 then step * 5 / 2 else step * 2
         in counterexample (show step) (step <= x && x < next && leading step `elem` [1, 2, 5])
    it "keeps round numbers" $
      map roundStep [1, 2, 5, 10, 1 / 50] `shouldBe` [1, 2, 5, 10, 1 / 50]
    it "does not stop at the range of Doubles" $ do
      roundStep (3 * 10 ^ (400 :: Int)) `shouldBe` 2 * 10 ^ (400 :: Int)
      roundStep (7 / 10 ^ (400 :: Int)) `shouldBe` 5 / 10 ^ (400 :: Int)
  describe "multiplesWithin" $
    it "includes both ends" $
      multiplesWithin (1 / 2) (-1) (1 / 2) `shouldBe` [-1, -1 / 2, 0, 1 / 2]
  describe "thinned" $
    it "has at most so many steps, all the same, and no fewer than it must" $
      property $ \(Positive most) from (NonNegative more) ->
        let found = thinned most from (from + more)
            step = case found of a : b : _ -> b - a; _ -> more + 1
         in conjoin
              [ take 1 found === [from]
              , counterexample (show found) (length found <= most + 1 && all (<= from + more) found)
              , zipWith (-) (drop 1 found) found === (step <$ drop 1 found)
              , counterexample (show step) (step == 1 || more >= most * (step - 1) || length found == 1)
              ]
  describe "decimalText" $ do
    it "is exact" $
      map (Text.unpack . decimalText) [0, 1 / 4, -20, 12.5, 0.001, 3 * 10 ^ (9 :: Int), 1500000, 15000000, 1 / 3]
        `shouldBe` ["0", "0.25", "−20", "12.5", "0.001", "3e9", "1500000", "1.5e7", "1/3"]
    it "writes small numbers with an exponent" $
      map (Text.unpack . decimalText) [0.0001, 0.00001, 0.0000125, -0.000001]
        `shouldBe` ["0.0001", "1e−5", "1.25e−5", "−1e−6"]
    it "keeps all digits of a long integer" $
      decimalText (12345678901234567890123456789012345678901 / 10)
        `shouldBe` Text.pack "1234567890123456789012345678901234567890.1"
  describe "shortNumber" $
    it "keeps three digits" $
      map (Text.unpack . shortNumber) [0.41421356, 0.99996, 1, 1 / 12345, 0, 2.5e-9, -123456, 5e-324]
        `shouldBe` ["0.414", "1", "1", "8.1e−5", "0", "2.5e−9", "−123000", "4.94e−324"]
  describe "directionAngle" $ do
    it "is exact at the ends of the half turn" $
      map directionAngle [Direction 0 1, Direction 0 (-1), Direction 7 0] `shouldBe` [pi / 2, -pi / 2, 0]
    it "takes components of any size" $
      let huge = 10 ^ (500 :: Int)
       in map directionAngle [Direction huge huge, Direction huge (-huge), Direction 1 huge, Direction huge 1]
            `shouldBe` [pi / 4, -pi / 4, pi / 2, 0]
  where
    leading :: Rational -> Rational
    leading = until (< 10) (/ 10) . until (>= 1) (* 10)
