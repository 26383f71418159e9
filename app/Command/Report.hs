-- | Speed against error.
module Command.Report
  ( runReport
  ) where

import Control.Monad (forM_)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.List (intercalate, isPrefixOf)
import qualified Data.Text as Text
import GHC.Clock (getMonotonicTime)
import GHC.Conc (getNumProcessors)
import Options.Report
import Report.Cancellation
import Report.Factors
import Report.Hard
import Report.Measure (Outcome (..), runChild)
import Report.Paper
import Report.Radiosity
import Report.Topology
import Run (orComplain)
import System.Directory (createDirectoryIfMissing)
import System.FilePath ((</>))
import System.IO (hFlush, hIsTerminalDevice, hPutStr, stderr)
import System.IO.Error (tryIOError)
import System.Info (arch, compilerName, compilerVersion, os)
import Data.Version (showVersion)
import Visibility.Draw.Render (renderSvg)
import Visibility.Draw.Scale (counted)
import Visibility.Report.Plot (plotDrawing)

-- | Measures everything and writes report.md, the CSV files and the plots.
runReport :: ReportOptions -> IO ()
runReport options = orComplain folder $ do
  createDirectoryIfMissing True folder
  terminal <- hIsTerminalDevice stderr
  let progress text
        | terminal = hPutStr stderr ("\r\ESC[K" <> text) >> hFlush stderr
        | otherwise = pure ()
  begun <- getMonotonicTime
  sections <-
    sequence
      [ section progress plan folder
      | section <-
          [ topologySection (reportDegenerate options)
          , factorsSection
          , cancellationSection
          , hardSection
          , radiositySection
          ]
      ]
  finished <- getMonotonicTime
  progress ""
  machine <- described
  version <- versionOf plan
  forM_ sections $ \section -> do
    forM_ (sectionData section) $ \(name, rows) -> writeFile (folder </> name) (csv rows)
    forM_ (sectionFigures section) $ \(Figure name plot _) ->
      Lazy.writeFile (folder </> name) (renderSvg (plotDrawing plot))
  writeFile
    (folder </> "report.md")
    (unlines (heading version machine (finished - begun)) <> concatMap markdown sections)
  putStrLn (folder </> "report.md")
  where
    folder = reportFolder options
    plan = planOf (reportThoroughness options)
    heading version machine seconds =
      [ "# Speed against error"
      , ""
      , "Written by `viscomplex report"
          <> (if reportThoroughness options == Quick then " --quick" else "")
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

-- | The machine in general terms.
described :: IO String
described = do
  count <- getNumProcessors
  cpu <- tryIOError (readFile "/proc/cpuinfo")
  let models = [line | line <- either (const []) lines cpu, "model name" `isPrefixOf` line]
      model = take 1 (map (drop 2 . dropWhile (/= ':')) models)
      compiler = compilerName <> " " <> showVersion compilerVersion
      processors = Text.unpack (counted count "processor" "processors")
  pure (intercalate ", " (model <> [processors, os <> " on " <> arch, compiler]))

-- | The name and version of this program, as it says itself.
versionOf :: Plan -> IO String
versionOf plan = do
  outcome <- runChild (timeLimit plan) ["--version"]
  pure $ case outcome of
    Finished _ text -> concat (take 1 (lines (Bytes.unpack text)))
    Failed _ -> "viscomplex"
