-- | Speed against error: @report PROGRAM FOLDER [quick]@, from the root of the project.
module Main (main) where

import GHC.IO.Encoding (setLocaleEncoding, utf8)
import Report
import System.Environment (getArgs)
import System.Exit (die)
import System.IO (hPutStrLn, stderr)

main :: IO ()
main = do
  setLocaleEncoding utf8
  arguments <- getArgs
  case arguments of
    [exe, place] -> measured Full exe place
    [exe, place, "quick"] -> measured Quick exe place
    _ -> die "usage: report PROGRAM FOLDER [quick]"
  where
    measured much exe place = writeReport (planOf much exe place (hPutStrLn stderr)) >> putStrLn (place <> "/report.md")
