module Visibility.Format.GraphSpec (spec) where

import Data.ByteString.Builder (Builder, toLazyByteString)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.List (sort)
import qualified Data.Set as Set
import Test.Hspec
import Test.QuickCheck hiding (sample)
import Visibility.Format.Graph
import Visibility.Scene
import Visibility.Sweep
import Visibility.Test.Generator
import Visibility.View (isTangent)

spec :: Spec
spec = do
  describe "sortedGraphLines" $
    it "names each pair once, smaller name first, sorted by names; of several names in a place, each" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            found = vertices scene
            named =
              Set.fromList
                [ (min a b, max a b)
                | (p, q) <- concatMap (vertexPairs scene) found
                , a <- namesAt scene p
                , b <- namesAt scene q
                ]
            line (a, b) = cornerText a <> " " <> cornerText b
         in textLines (sortedGraphLines scene AllPairs [pieceOf found]) === map line (Set.toAscList named)
  describe "graphLines" $
    it "has a line for each selected pair, in the order of the stream, and the same lines as when sorted" $
      property $ \(AnyScene s) ->
        forAll (elements [minBound .. maxBound]) $ \selection ->
          let scene = sampleScene s
              found = vertices scene
              line (a, b) = cornerText a <> " " <> cornerText b
           in conjoin
                [ textLines (graphLines scene selection (verticesInPieces scene)) === map line (selectedPairs scene selection found)
                , sort (textLines (graphLines scene selection (verticesInPieces scene)))
                    === sort (textLines (sortedGraphLines scene selection (verticesInPieces scene)))
                ]
  describe "selectedPairs" $ do
    it "keeps, of free bitangents, the pairs that are tangent at both corners and no sides" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            chosen (p, q) =
              isTangent scene p q && isTangent scene q p && q `notElem` [nextCorner scene p, previousCorner scene p]
            kept = filter chosen (concatMap (vertexPairs scene) (vertices scene))
         in Set.fromList (selectedPairs scene FreeBitangents (vertices scene))
              === Set.fromList
                [(min a b, max a b) | (p, q) <- kept, a <- namesAt scene p, b <- namesAt scene q]
    it "keeps the order of the stream, and names no pair twice" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            found = vertices scene
            streamed selection = concatMap (selectedPairs scene selection . pure) found
         in conjoin
              [ selectedPairs scene selection found === streamed selection
                  .&&. Set.size (Set.fromList (streamed selection)) === length (streamed selection)
              | selection <- [minBound ..]
              ]

-- | All corners of the file in the place of one.
namesAt :: Scene -> CornerId -> [CornerName]
namesAt scene c = [name | (name, point) <- statedCorners scene, point == cornerPoint scene c]

textLines :: Builder -> [String]
textLines = lines . Lazy.unpack . toLazyByteString
