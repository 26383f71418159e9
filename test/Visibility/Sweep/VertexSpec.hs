module Visibility.Sweep.VertexSpec (spec) where

import Data.List (group)
import Data.Maybe (mapMaybe)
import qualified Data.Set as Set
import Test.Hspec
import Test.QuickCheck hiding (sample)
import Visibility.Scene
import Visibility.Sweep
import Visibility.Test.BruteForce (bruteForce)
import Visibility.Test.Generator

spec :: Spec
spec = describe "a vertex" $ do
  it "has the corners it is made of, if they are two or more" $
    property $ \ks ->
      let line = map CornerId ks
       in fmap vertexCorners (fromCorners line) === (if length ks < 2 then Nothing else Just line)
  it "has a pair less than corners, each beginning where the one before ends" $
    property $ \a b ks ->
      let line = map CornerId (a : b : ks)
       in fmap (\scene -> fmap (vertexPairs scene) (fromCorners line)) square === Just (Just (zip line (drop 1 line)))
  it "has a pair or two, one for each face of a wall, between its corners in one place and those in the next one" $
    property $ \(TouchingScene s) ->
      let scene = sampleScene s
          at = cornerPoint scene
       in conjoin
            [ counterexample (show (v, pairs)) $
                map fst (runs (map (both at) pairs)) === zip places (drop 1 places)
                  .&&. conjoin [length same <= 2 | (_, same) <- runs (map (both at) pairs)]
                  .&&. and [p `elem` vertexCorners v && q `elem` vertexCorners v | (p, q) <- pairs]
                  .&&. length pairs === Set.size (Set.fromList pairs)
            | v <- bruteForce scene
            , let pairs = vertexPairs scene v
            , let places = map fst (runs (map at (vertexCorners v)))
            ]
  it "is degenerate from three places on, and ends at the last" $ do
    fmap (\scene -> [(isDegenerate scene v, vertexLast v) | v <- made [[3, 1], [3, 1, 2]]]) square
      `shouldBe` Just [(False, CornerId 1), (True, CornerId 2)]
    -- A wall on a side of the square: two corners in the place where they touch.
    fmap (\scene -> [(isDegenerate scene v, vertexCorners v) | v <- bruteForce scene, isLong v]) wall
      `shouldBe` Just [(False, map CornerId [3, 4, 6])]
  where
    square = sampleScene <$> sampleOf [unit]
    wall = sampleScene <$> sampleOf [unit, [(2, 1), (3, 1)]]
    unit = [(0, 0), (2, 0), (2, 3), (0, 2)]
    isLong v = length (vertexCorners v) > 2
    made = mapMaybe (fromCorners . map CornerId)
    both f (a, b) = (f a, f b)
    runs xs = [(x, same) | same@(x : _) <- group xs]
