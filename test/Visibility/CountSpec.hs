module Visibility.CountSpec (spec) where

import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Count
import Visibility.Scene
import Visibility.Sweep
import Visibility.Test.Generator
import Visibility.View

spec :: Spec
spec = describe "count" $ do
  modifyMaxSuccess (* 5) $ do
    it "obeys V - E - B + F = W + 1 under an open sky, W in a room" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            c = counted scene
            walls = length [() | p <- scenePolygons scene, length (polygonCorners p) == 2]
            whole = case surroundings scene of OpenSky -> 1; Room -> 0
         in counterexample (show c) $
              vertexCount c - edgeCount c - buriedCount c + faceCount c === walls + whole
    it "counts pairs, vertices and bitangents as brute force has them" $
      property $ \(SmallScene s) ->
        let scene = sampleScene s
            c = counted scene
            brute = bruteForce scene
         in (vertexCount c, degenerateCount c, pairCount c)
              === (length brute, length (filter isDegenerate brute), sum (map (length . vertexPairs) brute))
  it "finds, for two squares, what can be counted by hand" $
    -- Pairs: eight sides and four across the gap. The two horizontal lines are one vertex each, for three pairs; beside
    -- them there are four vertical sides and two diagonals. The inner corners have three vertices each, the outer ones
    -- two, and an edge from each to the next.
    fmap (counted . sampleScene) (sampleOf [square 0, square 2]) `shouldBeJust` Counts 8 2 12 4 20 0 13
  it "has two edges a vertex and a face more than vertices, in general position" $
    property $ \(ConvexScene s) ->
      let scene = sampleScene s
          c = counted scene
          general =
            degenerateCount c == 0
              && surroundings scene == OpenSky
              && all ((> 2) . length . polygonCorners) (scenePolygons scene)
       in general ==> (edgeCount c, faceCount c) === (2 * vertexCount c, vertexCount c + 1)
  where
    counted scene = count scene (events scene (vertices scene))
    square x = [(x, 0), (x + 1, 0), (x + 1, 1), (x, 1)]
    shouldBeJust actual expected = actual `shouldBe` Just expected
