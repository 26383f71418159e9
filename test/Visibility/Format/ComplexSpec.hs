module Visibility.Format.ComplexSpec (spec) where

import Control.Monad (forM)
import Data.ByteString.Builder (toLazyByteString)
import qualified Data.ByteString.Lazy as Lazy
import Data.List (sort, sortBy)
import System.Directory (listDirectory)
import System.FilePath (takeExtension, (</>))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck
import Visibility.Complex
import Visibility.Format.Complex
import Visibility.Format.File (readSceneFile)
import Visibility.Scene (cornerCount)
import Visibility.Sweep
import Visibility.Test.BruteForce (bruteForce)
import Visibility.Test.Generator

spec :: Spec
spec = describe "complexDocument" $ do
  modifyMaxSuccess (* 5) $
    it "is the same to the last byte for both sweeps, whatever order they number things in" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
         in document (build scene (straightVertices scene)) === document (build scene (vertices scene))
  modifyMaxSuccess (* 3) $
    it "is the same to the last byte for both sweeps where polygons touch" $
      property $ \(TouchingScene s) ->
        let scene = sampleScene s
         in document (build scene (straightVertices scene)) === document (build scene (vertices scene))
  it "is that of brute force" $
    property $ \(SmallScene s) ->
      let scene = sampleScene s in document (byBruteForce scene) === document (complexOf scene)
  it "is that of brute force where polygons touch" $
    property $ \(TouchingScene s) ->
      let scene = sampleScene s in document (byBruteForce scene) === document (complexOf scene)
  it "is that of brute force in the files of small scenes" $ do
    names <- sort . filter ((== ".json") . takeExtension) <$> listDirectory "scenes"
    compared <- forM names $ \name -> do
      scene <- readSceneFile ("scenes" </> name) >>= either (fail . show) pure
      if cornerCount scene > 40
        then pure []
        else do
          (name, document (byBruteForce scene) == document (complexOf scene)) `shouldBe` (name, True)
          pure [name]
    length (concat compared) `shouldSatisfy` (>= 8)
  mapM_
    golden
    [ ("two squares, which have vertices of four corners", "two-squares")
    , ("a room, where corners are buried", "l-room")
    ]
  where
    document = toLazyByteString . complexDocument
    byBruteForce scene = build scene (sortBy (compareVertices scene) (bruteForce scene))
    golden (what, name) =
      it ("tells all of " <> what) $ do
        scene <- readSceneFile ("test/golden/complex/" <> name <> ".scene.json") >>= either (fail . show) pure
        expected <- Lazy.readFile ("test/golden/complex/" <> name <> ".json")
        document (complexOf scene) `shouldBe` expected
