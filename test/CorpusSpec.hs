-- | The files that fuzzing has kept, since each reaches something in the readers that no other one does.
module CorpusSpec (spec) where

import qualified Data.ByteString as Bytes
import Data.Foldable (for_, toList)
import Data.List (isPrefixOf, sort)
import System.Directory (listDirectory)
import System.FilePath ((</>))
import Test.Hspec
import Visibility.Error
import Visibility.Format.File (readSceneBytes)
import Visibility.Scene.Validate (validate)
import Visibility.Sweep (vertices)
import Visibility.Test.BruteForce (bruteForce)

spec :: Spec
spec = do
  files <- runIO (sort <$> listDirectory folder)
  it "has files" $ length files `shouldSatisfy` (> 20)
  for_ files $ \file ->
    it (file <> " gets a documented answer, and the sweep of brute force") $ do
      bytes <- Bytes.readFile (folder </> file)
      case readSceneBytes file bytes of
        Left problems -> for_ (map errorText (toList problems)) (`shouldSatisfy` isMessage file)
        Right raw -> case validate raw of
          Left errors -> for_ (map (errorText . InvalidScene file) (toList errors)) (`shouldSatisfy` isMessage file)
          Right scene -> sort (vertices scene) `shouldBe` bruteForce scene
  where
    folder = "test/corpus"
    isMessage file text = (file <> ": ") `isPrefixOf` text && length (lines text) == 1
