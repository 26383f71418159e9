module Visibility.Sweep.RangeSpec (spec) where

import Data.List (sort)
import qualified Data.Map.Strict as Map
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Predicate
import Visibility.Sweep
import Visibility.Test.Generator

spec :: Spec
spec =
  describe "the two halves of the half turn" $
    modifyMaxSuccess (* 3) $ do
      it "are together all vertices, corners in order" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s; (first, second) = halves scene
           in sort (first <> second) === sort (vertices scene)
      it "are those that do not rise, and those that do" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s; (first, second) = halves scene
              rises vertex = let Direction _ y = vertexDirection scene vertex in y > 0
           in (filter rises first, filter (not . rises) second) === ([], [])
      it "come by increasing direction at each corner, the first half before the second" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s; (first, second) = halves scene
              byCorner =
                Map.fromListWith
                  (flip (<>))
                  [(c, [vertexDirection scene v]) | v <- first <> second, c <- vertexCorners v]
           in conjoin
                [ counterexample (show (c, directions)) (and (zipWith before' directions (drop 1 directions)))
                | (c, directions) <- Map.toList byCorner
                ]
  where
    halves scene =
      let (first, second) = halvesInPieces scene in (concatMap pieceVertices first, concatMap pieceVertices second)
    before' a b = compareDirections a b == LT
