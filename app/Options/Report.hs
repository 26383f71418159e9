-- | The options of the report.
module Options.Report
  ( ReportOptions (..)
  , reportOptions
  ) where

import Options.Applicative
import Report.Paper (Thoroughness (..))

data ReportOptions = ReportOptions
  { reportFolder :: !FilePath
  , reportDegenerate :: !FilePath
  , reportThoroughness :: !Thoroughness
  }

reportOptions :: Parser ReportOptions
reportOptions =
  ReportOptions
    <$> strOption
      ( short 'o'
          <> long "output"
          <> metavar "DIR"
          <> value "report"
          <> showDefault
          <> help "The folder to write to; it is made if it is not there."
      )
    <*> strOption
      ( long "degenerate"
          <> metavar "DIR"
          <> value "scenes/degenerate"
          <> showDefault
          <> help "The folder of degenerate scenes; without it the report leaves them out, and says so."
      )
    <*> flag Full Quick (long "quick" <> help "Fewer and smaller scenes: less than a minute.")
