module Visibility.Format.CheckedSpec (spec) where

import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Visibility.Error
import Visibility.Format.Checked

spec :: Spec
spec = describe "eachOf" $ do
  prop "is traverse with the places in the list" $ \items ->
    let check k (Positive size) = traverse (part k) [1 .. size `mod` 4 :: Int]
        part k n
          | even (k + n) || n == 1 = Good (k, n)
          | otherwise = fault (ShapeError (Item (Item Root k) n) (DuplicateKey mempty))
        result = outcome "a"
     in cover 10 (all isGood (zipWith check [0 ..] items)) "without faults" $
          result (eachOf check items) === result (traverse (uncurry check) (zip [0 ..] items))
  it "takes a list of a million" $ case eachOf (\k x -> Good (k + x)) (replicate 1000000 1) of
    Good sums -> sum sums `shouldBe` 500000500000
    Wrong _ -> expectationFailure "faults of nothing"
  where
    isGood (Good _) = True
    isGood (Wrong _) = False
