-- | The command line of viscomplex. No geometry here.
module Main (main) where

import Control.Monad (join)
import Options (readCommand)
import Output (guarded, prepare)

main :: IO ()
main = prepare >> guarded (join readCommand)
