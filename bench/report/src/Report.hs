-- | Speed against error: all that is measured, as a page, its data and its plots.
module Report
  ( Plan
  , Thoroughness (..)
  , planOf
  , writeReport
  ) where

import Control.Monad (forM_)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.List (intercalate, isPrefixOf)
import Data.Version (showVersion)
import GHC.Clock (getMonotonicTime)
import Report.Cancellation
import Report.Factors
import Report.Hard
import Report.Measure (Outcome (..), runChild)
import Report.Paper
import Report.Plot (plotDrawing)
import Report.Radiosity
import Report.Topology
import System.Directory (createDirectoryIfMissing)
import System.FilePath ((</>))
import System.IO.Error (tryIOError)
import System.Info (arch, compilerName, compilerVersion, os)
import Visibility.Draw.Render (renderSvg)

-- | Measures everything and writes report.md, the CSV files and the plots, from the root of the project.
writeReport :: Plan -> IO ()
writeReport plan = do
  createDirectoryIfMissing True (folder plan)
  begun <- getMonotonicTime
  sections <-
    mapM ($ plan) [topologySection, factorsSection, cancellationSection, hardSection, radiositySection]
  finished <- getMonotonicTime
  machine <- described
  version <- runChild plan ["--version"]
  forM_ sections $ \section -> do
    forM_ (sectionData section) $ \(name, rows) -> writeFile (folder plan </> name) (csv rows)
    forM_ (sectionFigures section) $ \(Figure name plot _) ->
      Lazy.writeFile (folder plan </> name) (renderSvg (plotDrawing plot))
  writeFile
    (folder plan </> "report.md")
    (unlines (heading (versionText version) machine (finished - begun)) <> concatMap markdown sections)
  where
    heading version machine seconds =
      [ "# Speed against error"
      , ""
      , "Written by `make report"
          <> (if thoroughness plan == Quick then " QUICK=1" else "")
          <> "`, "
          <> version
          <> ", in "
          <> sig seconds
          <> " s. All figures here were measured in that run, but for two that say they are from elsewhere, on "
          <> machine
          <> "; the report uses one processor. Each scene is a file in [scenes](scenes), so that it can be measured \
             \again, by this program or by another; but for the degenerate ones, which are the project's. Below each \
             \section are its figures as CSV, with all digits; a cell is empty there and in the tables where nothing \
             \was measured or there is nothing to tell."
      , ""
      ]
    -- The name and version of the program, as it says itself.
    versionText outcome = case outcome of
      Finished _ text -> concat (take 1 (lines (Bytes.unpack text)))
      Failed _ -> "viscomplex"

-- | The machine in general terms.
described :: IO String
described = do
  cpu <- tryIOError (readFile "/proc/cpuinfo")
  let models = [line | line <- either (const []) lines cpu, "model name" `isPrefixOf` line]
      model = take 1 (map (drop 2 . dropWhile (/= ':')) models)
      processors = ["1 processor" | [_] <- [models]] <> [show (length models) <> " processors" | _ : _ : _ <- [models]]
  pure (intercalate ", " (model <> processors <> [os <> " on " <> arch, compilerName <> " " <> showVersion compilerVersion]))
