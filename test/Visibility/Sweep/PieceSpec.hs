module Visibility.Sweep.PieceSpec (spec) where

import qualified Data.Vector.Unboxed as U
import Test.Hspec
import Test.QuickCheck hiding (sample)
import Visibility.Scene
import Visibility.Sweep
import Visibility.Sweep.Piece (inPieces)
import Visibility.Test.Generator

spec :: Spec
spec =
  describe "a piece" $ do
    it "holds the vertices that it is made of" $
      property $ \(AnyScene s) ->
        let found = vertices (sampleScene s)
         in conjoin
              [ pieceVertices (pieceOf found) === found
              , concatMap pieceVertices (inPieces found) === found
              , pieceLength (pieceOf found) === length found
              ]
    it "of the sweep is not empty, and all of them are the sweep" $
      property $ \(AnyScene s) ->
        let found = verticesInPieces (sampleScene s)
         in conjoin
              [ concatMap pieceVertices found === vertices (sampleScene s)
              , property (all ((> 0) . pieceLength) found)
              ]
    it "knows the neighbours on each of its lines" $
      property $ \(AnyScene s) ->
        let found = vertices (sampleScene s)
            lineOf vertex = [c | CornerId c <- vertexCorners vertex]
         in U.toList (pieceNeighbours (,) (pieceOf found))
              === concat [zip line (drop 1 line) | vertex <- found, let line = lineOf vertex]
