-- | The command line of viscomplex. No geometry here.
module Main (main) where

import Command.Draw (runDraw)
import Command.Generate (runGenerate)
import Command.Query (runFactors, runGraph, runInfo)
import GHC.IO.Encoding (setLocaleEncoding, utf8)
import Options
import Run (guarded)

main :: IO ()
main = do
  setLocaleEncoding utf8
  command <- readCommand
  guarded $ case command of
    Info common -> runInfo common
    Graph common options -> runGraph common options
    Factors common options -> runFactors common options
    Draw common options -> runDraw common options
    Generate options -> runGenerate options
