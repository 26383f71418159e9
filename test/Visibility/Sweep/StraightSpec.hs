module Visibility.Sweep.StraightSpec (spec) where

import Data.List (sortBy)
import qualified Data.Set as Set
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Point (Arithmetic (..))
import Visibility.Exact.Predicate (Direction (..))
import Visibility.Scene
import Visibility.Scene.Family
import Visibility.Sweep
import Visibility.Test.BruteForce (bruteForce)
import Visibility.Test.Generator

spec :: Spec
spec = do
  describe "straightVertices" $ do
    modifyMaxSuccess (* 30) $
      it "are the vertices of the topological sweep, in canonical order" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
           in straightVertices scene === sortBy (compareVertices scene) (vertices scene)
    modifyMaxSuccess (* 10) $
      it "are the vertices of the topological sweep where polygons touch" $
        property $ \(TouchingScene s) ->
          let scene = sampleScene s
           in straightVertices scene === sortBy (compareVertices scene) (vertices scene)
    modifyMaxSuccess (* 5) $ do
      it "are those of brute force" $
        property $ \(SmallScene s) ->
          let scene = sampleScene s
           in Set.fromList (straightVertices scene) === Set.fromList (bruteForce scene)
      it "are the same whatever decides the signs, if it is exact" $
        property $ \(HardScene s) ->
          let scene = sampleScene s
           in straightVertices (underArithmetic Exact scene) === straightVertices scene
    it "are those of the topological sweep in scenes swept in several pieces" $
      once $
        conjoin
          [ counterexample (show kind) (straightVertices scene === sortBy (compareVertices scene) (vertices scene))
          | kind <- [minBound .. maxBound]
          , Just count <- [size (sizeOfCorners kind 160)]
          , Just s <- [sample (family kind count (Seed 1))]
          , let scene = sampleScene s
          ]
  describe "compareVertices" $ do
    it "goes by direction, then by offset" $
      fmap (map vertexCorners . straightVertices . sampleScene) (sampleOf [[(0, 0), (1, 0)], [(0, 1), (1, 1)]])
        `shouldBe` Just (map (map CornerId) [[1, 2], [0, 2], [1, 3], [0, 3], [2, 3], [0, 1]])
    it "then along the line" $
      -- Two walls on one line that do not see each other, as a square stands between them.
      fmap (level . sampleScene) (sampleOf [[(0, 0), (1, 0)], [(2, -1), (3, -1), (3, 1), (2, 1)], [(4, 0), (5, 0)]])
        `shouldBe` Just (map (map CornerId) [[2, 4], [0, 1], [6, 7], [3, 5]])
    it "is total: no two vertices are equal" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            found = straightVertices scene
         in [(v, w) | (v, w) <- zip found (drop 1 found), compareVertices scene v w /= LT] === []
  where
    level scene =
      [ vertexCorners v
      | v <- straightVertices scene
      , let Direction _ dy = vertexDirection scene v
      , dy == 0
      ]
