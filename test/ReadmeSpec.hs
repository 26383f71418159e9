-- | The program of README.md, as the executable that VISCOMPLEX_README names: the test suite @readme@.
module ReadmeSpec (spec) where

import Command.Run
import System.Environment (lookupEnv)
import System.Process (readProcess)
import Test.Hspec

spec :: Spec
spec =
  describe "the program of README.md" $
    it "prints the form factors of its scene" $ do
      named <- lookupEnv "VISCOMPLEX_README"
      case named of
        Nothing -> pendingWith "VISCOMPLEX_README names no executable; make test builds it"
        Just program -> do
          found <- readProcess program [] ""
          table <- output ["factors", "scenes/room.json"] ""
          map words (lines found) `shouldBe` map cells (drop 1 (lines table))
