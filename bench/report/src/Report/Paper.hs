-- | What sections of the report are made of.
module Report.Paper
  ( Section (..)
  , Table (..)
  , Figure (..)
  , Plan (..)
  , Thoroughness (..)
  , planOf
  , markdown
  , csv
  , sig
  , micro
  , timeCell
  , leastOf
  , limitsOf
  , shareCell
  , signCells
  ) where

import Data.List (intercalate)
import Data.Text (Text)
import qualified Data.Text as Text
import Numeric (showEFloat, showFFloat)
import Report.Arithmetic (Signs (..), shareLeft)
import Report.Plot (Plot (plotTitle))

-- | A part of the report, in this order: text, tables, figures.
data Section = Section
  { sectionTitle :: !String
  , sectionText :: ![String]
  -- ^ Paragraphs.
  , sectionTables :: ![Table]
  , sectionFigures :: ![Figure]
  , sectionData :: ![(FilePath, [[String]])]
  -- ^ CSV files, each with its header.
  }

-- | A table with its caption and header.
data Table = Table !String ![String] ![[String]]

-- | A plot, its file, and the caption that a reader understands it from.
data Figure = Figure !FilePath !Plot !Text

data Thoroughness = Quick | Full
  deriving (Eq, Show)

-- | How much is measured, with which program, and where it is written.
data Plan = Plan
  { program :: !FilePath
  -- ^ The executable of viscomplex.
  , folder :: !FilePath
  , thoroughness :: !Thoroughness
  , progress :: String -> IO ()
  -- ^ Tells what is under work.
  , ladderSizes :: ![Int]
  -- ^ Of random quadrilaterals.
  , otherSize :: !Int
  , largeSize :: !Int
  -- ^ Of random quadrilaterals with coordinates beyond machine integers.
  , bruteForceLimit :: !Int
  -- ^ Brute force up to so many corners.
  , slowLimit :: !Int
  -- ^ Rationals up to so many corners.
  , closureLimit :: !Int
  -- ^ Closure is decided up to so many corners; each decision takes much longer than a sweep.
  , runs :: !Int
  -- ^ Times are the least of so many runs, at least one.
  , factorSizes :: ![Int]
  , lineCounts, pointCounts, directionCounts :: ![Int]
  , hardSteps :: ![Int]
  , partCounts :: ![Int]
  -- ^ Of uniform meshes, for each side of a scene that is lit.
  , referenceParts :: !Int
  -- ^ What the reference cuts each side into, besides the break points; an even number.
  , timeLimit :: !Double
  -- ^ For a child, in seconds.
  , memoryLimit :: !Int
  -- ^ For a child under the unsafe arithmetic, in megabytes.
  }

-- | The plan by the program, the folder and how progress is told.
planOf :: Thoroughness -> FilePath -> FilePath -> (String -> IO ()) -> Plan
planOf Quick exe place tell =
  Plan
    { program = exe
    , folder = place
    , thoroughness = Quick
    , progress = tell
    , ladderSizes = [4, 16, 64]
    , otherSize = 32
    , largeSize = 32
    , bruteForceLimit = 64
    , slowLimit = 550
    , closureLimit = 150
    , runs = 1
    , factorSizes = [30]
    , lineCounts = [1000, 10000, 100000]
    , pointCounts = [1, 4, 16]
    , directionCounts = [10, 100, 1000]
    , hardSteps = [0, 8 .. 64]
    , partCounts = [2, 4, 8]
    , referenceParts = 32
    , timeLimit = 5
    , memoryLimit = 500
    }
planOf Full exe place tell =
  (planOf Quick exe place tell)
    { thoroughness = Full
    , ladderSizes = [8, 32, 128, 512, 2048]
    , otherSize = 256
    , largeSize = 128
    , bruteForceLimit = 160
    , slowLimit = 2100
    , closureLimit = 2100
    , runs = 3
    , factorSizes = [30, 100]
    , lineCounts = [1000, 10000, 100000, 1000000, 10000000]
    , pointCounts = [1, 4, 16, 64, 256]
    , directionCounts = [10, 100, 1000, 10000]
    , hardSteps = [0, 2 .. 70]
    , partCounts = [2, 4, 8, 16]
    , referenceParts = 64
    , timeLimit = 20
    , memoryLimit = 1000
    }

-- | A number with three digits.
sig :: Double -> String
sig x
  | x == 0 = "0"
  | abs x >= 0.01 && abs x < 1000 = showFFloat (Just places) x ""
  | otherwise = showEFloat (Just 2) x ""
  where
    places = max 0 (2 - floor (logBase 10 (abs x))) :: Int

-- | What a time is, by how often it was taken.
leastOf :: Plan -> String
leastOf plan
  | runs plan <= 1 = "taken once"
  | otherwise = "the least of " <> show (runs plan) <> " runs, or where they are short of as many as take half a second"

-- | What a child under the unsafe arithmetic is allowed.
limitsOf :: Plan -> String
limitsOf plan = show (round (timeLimit plan) :: Int) <> " s and " <> show (memoryLimit plan) <> " MB"

-- | A time, or nothing where none was measured.
timeCell :: Maybe Double -> String
timeCell = maybe "" ((<> " s") . sig)

-- | Microseconds of seconds.
micro :: Double -> String
micro = sig . (* 1e6)

-- | The share of signs that a filter left to integers.
shareCell :: Signs -> String
shareCell signs = sig (100 * fromRational (shareLeft signs)) <> " %"

-- | As data: how many signs a filter was asked, and how many it left; empty where none was.
signCells :: Maybe Signs -> [String]
signCells = maybe ["", ""] (\(Signs decided left) -> [show decided, show left])

-- | A section in Markdown. The title's level is the second.
markdown :: Section -> String
markdown (Section title texts tables figures files) =
  unlines $
    ["## " <> title, ""]
      <> concatMap (\paragraph -> [paragraph, ""]) texts
      <> concatMap table tables
      <> concatMap figure figures
      <> ["Data: " <> intercalate ", " ["[" <> name <> "](" <> name <> ")" | (name, _) <- files] <> ".", ""]
  where
    table (Table caption header rows) =
      ["*" <> caption <> "*", "", row header, row (map (const "---") header)] <> map row rows <> [""]
    row cells = "| " <> intercalate " | " cells <> " |"
    figure (Figure file plot caption) =
      ["![" <> Text.unpack (plotTitle plot) <> "](" <> file <> ")", "", "*" <> Text.unpack caption <> "*", ""]

-- | Rows of cells, none of which holds a comma or a quote.
csv :: [[String]] -> String
csv = unlines . map (intercalate ",")
