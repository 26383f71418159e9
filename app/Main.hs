-- | The command line of viscomplex. No geometry here.
module Main (main) where

import Command.Draw
import Command.Elements (runMesh, runRadiosity)
import Command.Query
import Command.View (runView)
import Options
import Output (guarded, prepare)

main :: IO ()
main = do
  prepare
  guarded $ readCommand >>= \command -> case command of
    Info common -> runInfo common
    Graph common options -> runGraph common options
    Factors common options -> runFactors common options
    Complex common objects -> runComplex common objects
    Radiosity common options -> runRadiosity common options
    View common options -> runView common options
    Mesh common options -> runMesh common options
    Verify common -> runVerify common
    Draw common options -> runDraw common options
    Generate options -> runGenerate options
