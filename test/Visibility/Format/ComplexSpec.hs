module Visibility.Format.ComplexSpec (spec) where

import Data.ByteString.Builder (toLazyByteString)
import qualified Data.ByteString.Lazy as Lazy
import Data.List (sortBy)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck
import Visibility.Complex
import Visibility.Format.Complex
import Visibility.Format.Json (readSceneFile)
import Visibility.Sweep
import Visibility.Test.Generator

spec :: Spec
spec = describe "complexDocument" $ do
  modifyMaxSuccess (* 5) $
    it "is the same to the last byte for both sweeps, whatever order they number things in" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
         in document (build scene (straightVertices scene)) === document (build scene (vertices scene))
  it "is that of brute force" $
    property $ \(SmallScene s) ->
      let scene = sampleScene s
       in document (build scene (sortBy (compareVertices scene) (bruteForce scene)))
            === document (build scene (vertices scene))
  mapM_
    golden
    [ ("two squares, which have vertices of four corners", "two-squares")
    , ("a room, where corners are buried", "l-room")
    ]
  where
    document = toLazyByteString . complexDocument
    golden (what, name) =
      it ("tells all of " <> what) $ do
        scene <- readSceneFile ("test/golden/complex/" <> name <> ".scene.json") >>= either (fail . show) pure
        expected <- Lazy.readFile ("test/golden/complex/" <> name <> ".json")
        document (complexOf scene) `shouldBe` expected
