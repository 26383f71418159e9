module Visibility.Test.BruteForceSpec (spec) where

import Data.List (sort)
import Test.Hspec
import Test.QuickCheck hiding (sample)
import Visibility.Scene
import Visibility.Sweep
import Visibility.Test.BruteForce (bruteForce, isElementary)
import Visibility.Test.Generator

-- | The vertices of a scene of loops, by name.
found :: [[(Integer, Integer)]] -> [[String]]
found loops = case sampleOf loops of
  Just s -> sort [map (cornerText . cornerName (sampleScene s)) (vertexCorners v) | v <- bruteForce (sampleScene s)]
  Nothing -> []

spec :: Spec
spec = do
  describe "brute force, by hand" $ do
    it "finds a thin wall alone" $
      found [[(0, 0), (3, 1)]] `shouldBe` [["0.0", "0.1"]]
    it "finds the sides of a triangle and nothing else" $
      found [[(0, 0), (2, 0), (0, 2)]] `shouldBe` [["0.0", "0.1"], ["0.0", "0.2"], ["0.2", "0.1"]]
    it "finds no diagonal inside a polygon, and one across its notch" $
      found [[(0, 0), (4, 0), (4, 4), (2, 1), (0, 4)]]
        `shouldBe` [["0.0", "0.1"], ["0.0", "0.4"], ["0.1", "0.2"], ["0.3", "0.2"], ["0.4", "0.2"], ["0.4", "0.3"]]
    it "sees along a wall past its end, and not through it" $
      found [[(0, 0), (2, 0)], [(4, 0), (6, 0)], [(3, -1), (3, 1)]]
        `shouldBe` [ ["0.0", "0.1"]
                   , ["0.0", "2.0"]
                   , ["0.0", "2.1"]
                   , ["0.1", "2.0"]
                   , ["0.1", "2.1"]
                   , ["1.0", "1.1"]
                   , ["2.0", "1.0"]
                   , ["2.0", "1.1"]
                   , ["2.0", "2.1"]
                   , ["2.1", "1.0"]
                   , ["2.1", "1.1"]
                   ]
    it "makes one vertex of three aligned walls" $
      found [ [(0, 0), (1, 0)]
            , [(2, 0), (3, 0)]
            , [(4, 0), (5, 0)]
            ] `shouldBe` [["0.0", "0.1", "1.0", "1.1", "2.0", "2.1"]]
    it "passes grazing corners on both flanks" $
      found [[(0, 0), (0, -2), (-1, 0)], [(2, 0), (3, 2), (1, 2)], [(4, 0), (5, -2), (6, -1)]]
        `shouldSatisfy` elem ["0.2", "0.0", "1.0", "2.0"]
  describe "an elementary pair" $
    it "is one of two consecutive corners of a vertex, or of two along one face of a wall" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
         in sort (concatMap (vertexPairs scene) (bruteForce scene))
              === [(p, q) | p <- corners scene, q <- corners scene, p < q, isElementary scene p q]
