module Visibility.Format.GraphSpec (spec) where

import Data.ByteString.Builder (Builder, toLazyByteString)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.List (sort)
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
    it "names each pair once, smaller name first, sorted by names" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            pairs = selectedPairs scene AllPairs (vertices scene)
            named (p, q) = (min (cornerName scene p) (cornerName scene q), max (cornerName scene p) (cornerName scene q))
            line (a, b) = cornerText a <> " " <> cornerText b
         in textLines (sortedGraphLines scene pairs) === map line (sort (map named pairs))
  describe "graphLines" $
    it "has the same lines, in the order of the stream" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            pairs = selectedPairs scene AllPairs (vertices scene)
         in conjoin
              [ sort (textLines (graphLines scene pairs)) === sort (textLines (sortedGraphLines scene pairs))
              , concatMap (textLines . graphLines scene . pure) pairs === textLines (graphLines scene pairs)
              ]
  describe "selectedPairs" $
    it "keeps, of free bitangents, the pairs that are tangent at both corners and no sides" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            chosen (p, q) =
              isTangent scene p q && isTangent scene q p && q `notElem` [nextCorner scene p, previousCorner scene p]
         in selectedPairs scene FreeBitangents (vertices scene)
              === filter chosen (selectedPairs scene AllPairs (vertices scene))

textLines :: Builder -> [String]
textLines = lines . Lazy.unpack . toLazyByteString
