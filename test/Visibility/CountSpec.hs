module Visibility.CountSpec (spec) where

import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Count
import Visibility.Scene
import Visibility.Scene.Family (Family (Random), Seed (..), family, size)
import Visibility.Scene.Validate (validate)
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
  it "has two edges a vertex and a face more than vertices, for convex polygons in general position" $
    forAll ((,) <$> choose (1, 8) <*> fmap Seed arbitrary) $ \(n, seed) ->
      case fmap (\k -> validate (family Random k seed)) (size n) of
        Just (Right scene) ->
          let c = counted scene
           in degenerateCount c == 0 ==> (edgeCount c, faceCount c) === (2 * vertexCount c, vertexCount c + 1)
        _ -> property False
  where
    counted scene = count scene (events scene (vertices scene))
    square x = [(x, 0), (x + 1, 0), (x + 1, 1), (x, 1)]
    shouldBeJust actual expected = actual `shouldBe` Just expected
