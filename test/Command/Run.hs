-- | The executable as tests run it: the one named by VISCOMPLEX_EXE, or bin/viscomplex.
module Command.Run
  ( run
  , executable
  , output
  , refuses
  , cells
  ) where

import Data.Foldable (for_)
import Data.List (isInfixOf)
import Data.Maybe (fromMaybe)
import System.Environment (lookupEnv)
import System.Exit (ExitCode (..))
import System.Process (readProcessWithExitCode)
import Test.Hspec

-- | Runs the program with arguments and standard input: exit code, standard output, standard error.
run :: [String] -> String -> IO (Int, String, String)
run arguments input = do
  exe <- executable
  (code, out, err) <- readProcessWithExitCode exe arguments input
  pure (case code of ExitSuccess -> 0; ExitFailure n -> n, out, err)

executable :: IO FilePath
executable = fromMaybe "bin/viscomplex" <$> lookupEnv "VISCOMPLEX_EXE"

-- | The output of a call that must succeed, and say nothing else.
output :: [String] -> String -> IO String
output arguments input = do
  (code, out, err) <- run arguments input
  (code, err) `shouldBe` (0, "")
  pure out

-- | A call that must fail with this exit code, print nothing, and say all of this.
refuses :: Int -> [String] -> [String] -> String -> Expectation
refuses wanted phrases arguments input = do
  (code, out, err) <- run arguments input
  (code, out) `shouldBe` (wanted, "")
  for_ phrases $ \phrase -> err `shouldSatisfy` isInfixOf phrase

-- | The cells of a line of CSV, none of which holds a comma or a quote.
cells :: String -> [String]
cells line = case break (== ',') line of
  (cell, _ : rest) -> cell : cells rest
  (cell, []) -> [cell]
