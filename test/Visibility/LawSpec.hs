module Visibility.LawSpec (spec) where

import Control.Exception (displayException, evaluate)
import Data.List (isInfixOf)
import Test.Hspec
import Visibility.Law

spec :: Spec
spec = do
  describe "broken" $
    it "throws the law and what was found" $
      evaluate (broken "closure" "row 3.0 sums to 2" :: Int) `shouldThrow` (== Violation "closure" "row 3.0 sums to 2")
  describe "a violation" $
    it "shows both" $ do
      let text = displayException (Violation "closure" "row 3.0 sums to 2")
      text `shouldSatisfy` isInfixOf "closure"
      text `shouldSatisfy` isInfixOf "row 3.0 sums to 2"
  describe "ensure" $
    it "gives a violation exactly where the law is false" $
      (ensure "law" "details" True, ensure "law" "details" False) `shouldBe` ([], [Violation "law" "details"])
