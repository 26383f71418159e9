module Estimate.StringsSpec (spec) where

import Test.Hspec
import Test.QuickCheck hiding (sample)
import Estimate.Matrix
import Estimate.Sample
import Estimate.Strings
import Visibility.Sweep
import Visibility.Test.Generator

spec :: Spec
spec = do
  describe "the string rule in Doubles" $
    it "is near the exact one where coordinates are small: 2^-40 of a whole" $
      property $ \(LatticeScene s) -> estimated s plainStrings (2 ** (-40))
  describe "the compensated string rule" $
    it "is as near as a Double can be, or a unit of the last place beside it" $
      property $ \(LatticeScene s) -> estimated s compensatedStrings (2 ** (-52))
  where
    estimated s method bound =
      let scene = sampleScene s
          found = errorsIn scene (method scene (verticesInPieces scene))
       in counterexample (show found) (largestAbsolute found <= bound)
