module Estimate.LinesSpec (spec) where

import qualified Data.Vector.Unboxed as U
import Test.Hspec
import Test.QuickCheck hiding (sample)
import Estimate.Lines
import Estimate.Matrix
import Estimate.Sample
import Visibility.Test.Generator

spec :: Spec
spec = do
  describe "areas in the dual" $
    it "come nearer with more directions: within 20 / N of the form factors" $
      property $ \(ConvexScene s) ->
        let scene = sampleScene s
            found n = largestAbsolute (errorsIn scene (dualAreas n (sidesIn scene)))
         in conjoin [counterexample (show (n, found n)) (found n <= 20 / fromIntegral n) | n <- [100, 1000]]
  describe "random lines" $ do
    it "scatter around the form factors: each is within eight standard deviations" $
      property $ \(ConvexScene s) ->
        let scene = sampleScene s
            sides = sidesIn scene
            count = 4000 :: Int
            matrix = randomLines 7 count sides
            -- A line counts for an entry with a probability p, and then with the weight w = F / p.
            w row = 2 * pi * reach sides / (2 * (lengths sides U.! row) * fromIntegral count)
            deviation row x = sqrt (x * w row) + w row
         in conjoin
              [ counterexample (show (row, column, x, entryAt matrix row column)) $
                  abs (entryAt matrix row column - x) <= 8 * deviation row x
              | ((row, column), x) <- truthEntries (truthIn scene)
              ]
    it "are the same for the same seed" $
      property $ \(ConvexScene s) ->
        let sides = sidesIn (sampleScene s)
            first = randomLines 3 100 sides
         in [entryAt first r c | r <- [0 .. matrixSize first - 1], c <- [0 .. matrixSize first]]
              === [ entryAt (randomLines 3 100 sides) r c
                  | r <- [0 .. matrixSize first - 1]
                  , c <- [0 .. matrixSize first]
                  ]
  where
    -- At least the radius of the disc that lines are taken from.
    reach sides = extent (startX sides) + extent (startY sides)
    extent xs = U.maximum xs - U.minimum xs
