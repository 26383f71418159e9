module Estimate.PointsSpec (spec) where

import Test.Hspec
import Test.QuickCheck hiding (sample)
import Estimate.Matrix
import Estimate.Points
import Estimate.Sample
import Visibility.Test.Generator

spec :: Spec
spec =
  describe "quadrature of the double integral" $ do
    it "sees all around from each point: rows add up to one" $
      property $ \(ConvexScene s) ->
        let scene = sampleScene s
            sums = rowSums scene (pointQuadrature 3 (sidesIn scene))
         in counterexample (show sums) (all (\(a, b) -> abs (a - b) < 1e-9) sums)
    it "comes nearer with more points: within 4 / N of the form factors" $
      property $ \(ConvexScene s) ->
        let scene = sampleScene s
            found n = largestAbsolute (errorsIn scene (pointQuadrature n (sidesIn scene)))
         in conjoin [counterexample (show (n, found n)) (found n <= 4 / fromIntegral n) | n <- [20, 200]]
