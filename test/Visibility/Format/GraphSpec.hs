module Visibility.Format.GraphSpec (spec) where

import Data.ByteString.Builder (Builder, byteString, toLazyByteString)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.List (sort)
import qualified Data.Set as Set
import qualified Data.Vector.Unboxed as U
import Test.Hspec
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Point (Point (..))
import Visibility.Format.Graph
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Sorting (pairOf)
import Visibility.Sweep
import Visibility.Test.Generator
import Visibility.View (isTangent)

spec :: Spec
spec = do
  describe "sortedLines" $
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
         in textLines (sortedOf scene AllPairs) === map line (Set.toAscList named)
  describe "linesOf" $ do
    it "has a line for each selected pair, in the order of the stream, and the same lines as when sorted" $
      property $ \(AnyScene s) ->
        forAll (elements [minBound .. maxBound]) $ \selection ->
          let scene = sampleScene s
              found = vertices scene
              line (a, b) = cornerText a <> " " <> cornerText b
           in conjoin
                [ textLines (streamOf scene selection) === map line (selectedPairs scene selection found)
                , sort (textLines (streamOf scene selection))
                    === sort (textLines (sortedOf scene selection))
                ]
    it "writes names of any length" $
      let polygons = [[(0, k), (1, k)] | k <- [1 .. 1000]] <> [[(k, k `mod` 2 - 9) | k <- [0 .. 1100]]]
          raw = RawScene Nothing Nothing [rawWall [Point (fromInteger x) (fromInteger y) | (x, y) <- p] | p <- polygons]
          texts scene = map (cornerText . fst) (statedCorners scene)
          neighbours scene = U.fromList [pairOf k (k + 1) | k <- [0 .. length (texts scene) - 2]]
       in [ textLines (byteString (linesOf (namesOf scene) (neighbours scene)))
              == zipWith (\a b -> a <> " " <> b) (texts scene) (drop 1 (texts scene))
          | Just scene <- [sampleScene <$> sample raw]
          ]
            `shouldBe` [True]
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

-- | All lines, in the order of the sweep and sorted.
streamOf, sortedOf :: Scene -> PairSelection -> Builder
streamOf scene selection =
  foldMap (byteString . linesOf names . pairKeys scene names selection) (verticesInPieces scene)
  where
    names = namesOf scene
sortedOf scene selection = sortedLines names (map (pairKeys scene names selection) (verticesInPieces scene))
  where
    names = namesOf scene

textLines :: Builder -> [String]
textLines = lines . Lazy.unpack . toLazyByteString
