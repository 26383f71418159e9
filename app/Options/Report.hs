-- | The options of the report.
module Options.Report
  ( ReportOptions (..)
  , reportOptions
  ) where

import Options.Applicative
import Report.Paper (Thoroughness (..))

data ReportOptions = ReportOptions
  { reportFolder :: !FilePath
  , reportThoroughness :: !Thoroughness
  }

reportOptions :: Parser ReportOptions
reportOptions =
  ReportOptions
    <$> strOption (short 'o' <> long "output" <> metavar "DIR" <> value "report" <> showDefault <> help "The folder to write to; it is made if it is not there.")
    <*> flag Full Quick (long "quick" <> help "Fewer and smaller scenes: less than a minute.")
