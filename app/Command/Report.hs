-- | Speed against error.
module Command.Report
  ( runReport
  ) where

import Control.Monad (forM_)
import qualified Data.ByteString.Lazy as Lazy
import Data.List (intercalate, isPrefixOf)
import qualified Data.Text as Text
import GHC.Clock (getMonotonicTime)
import GHC.Conc (getNumProcessors)
import Options.Report
import Report.Cancellation
import Report.Factors
import Report.Hard
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
          [topologySection (reportDegenerate options), factorsSection, cancellationSection, hardSection, radiositySection]
      ]
  finished <- getMonotonicTime
  progress ""
  machine <- described
  forM_ sections $ \section -> do
    forM_ (sectionData section) $ \(name, rows) -> writeFile (folder </> name) (csv rows)
    forM_ (sectionFigures section) $ \(Figure name plot _) ->
      Lazy.writeFile (folder </> name) (renderSvg (plotDrawing plot))
  writeFile (folder </> "report.md") (unlines (heading machine (finished - begun)) <> concatMap markdown sections)
  putStrLn (folder </> "report.md")
  where
    folder = reportFolder options
    plan = planOf (reportThoroughness options)
    heading machine seconds =
      [ "# Speed against error"
      , ""
      , "Written by `viscomplex report"
          <> (if reportThoroughness options == Quick then " --quick" else "")
          <> "` in "
          <> sig seconds
          <> " s. All figures here were measured in that run, but for two that say they are from elsewhere, on "
          <> machine
          <> "; the report uses one processor. The scenes are in [scenes](scenes), so that each can be measured again."
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
  pure (intercalate ", " (model <> [Text.unpack (counted count "processor" "processors"), os <> " on " <> arch, compiler]))
