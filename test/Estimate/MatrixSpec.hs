module Estimate.MatrixSpec (spec) where

import Test.Hspec
import Test.QuickCheck hiding (sample)
import Estimate.Matrix
import Estimate.Sample
import Visibility.Test.Generator

spec :: Spec
spec =
  describe "errors" $ do
    it "of the nearest Doubles are at most half a unit of the last place" $
      property $ \(AnyScene s) ->
        let found = errorsIn (sampleScene s) (exactly (sampleScene s))
         in counterexample (show found) (largestRelative found <= 2 ** (-53) && spurious found == 0)
    it "of nothing are one everywhere" $
      property $ \(ConvexScene s) ->
        let scene = sampleScene s
            found = errorsIn scene (matrixFrom (matrixSize (exactly scene)) (const (pure ())))
         in (largestRelative found, medianRelative found, spurious found) === (1, 1, 0)
    it "count what should be zero" $
      property $ \(ConvexScene s) ->
        let scene = sampleScene s
            exact = exactly scene
            n = matrixSize exact
            full = matrixFrom n (\put -> sequence_ [put i j 1 | i <- [0 .. n - 1], j <- [0 .. n]])
         in spurious (errorsIn scene full) === n * (n + 1) - length (truthEntries (truthIn scene))
  where
    exactly scene =
      let entries = truthEntries (truthIn scene)
          n = length (rowSumsOf scene)
       in matrixFrom n (\put -> mapM_ (\((row, column), x) -> put row column x) entries)
    rowSumsOf scene = rowSums scene (matrixFrom 0 (const (pure ())))
