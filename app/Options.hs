-- | What the command line says, and the help that explains it.
module Options
  ( -- * Commands
    Command (..)
  , readCommand
    -- * Their options
  , Common (..)
  , GraphOptions (..)
  , LineOrder (..)
  , FactorOptions (..)
  , DrawOptions (..)
  , Figure (..)
  , GenerateOptions (..)
  ) where

import Control.Applicative (optional, (<**>))
import Data.Char (isDigit)
import Data.List (intercalate)
import qualified Data.Text as Text
import Options.Applicative
  ( InfoMod
  , Parser
  , ParserInfo
  , ReadM
  , argument
  , command
  , customExecParser
  , eitherReader
  , flag
  , footerDoc
  , fullDesc
  , header
  , help
  , helper
  , hsubparser
  , info
  , infoOption
  , long
  , metavar
  , option
  , prefs
  , progDesc
  , short
  , showDefaultWith
  , showHelpOnEmpty
  , str
  , strOption
  , value
  )
import Options.Applicative.Help.Pretty (empty, indent, text, vsep)
import Text.Read (readMaybe)
import Visibility.Exact.Point (Arithmetic (..))
import Visibility.Exact.Rounding (Digits, defaultDigits, digitCount, digits)
import Visibility.Format.Factors (Detail (..), FactorFormat (..))
import Visibility.Format.Graph (PairSelection (..))
import Visibility.Scene.Family

-- | A command with its options.
data Command
  = Info !Common
  | Graph !Common !GraphOptions
  | Factors !Common !FactorOptions
  | Draw !Common !DrawOptions
  | Generate !GenerateOptions

-- | What every command on a scene takes.
data Common = Common
  { sceneFile :: !FilePath
  , arithmeticChoice :: !Arithmetic
  }

-- | Which lines of the graph, in which order.
data GraphOptions = GraphOptions
  { pairSelection :: !PairSelection
  , lineOrder :: !LineOrder
  }

data LineOrder = ByName | AsSwept

data FactorOptions = FactorOptions
  { factorFormat :: !FactorFormat
  , factorDigits :: !Digits
  , factorDetail :: !Detail
  }

data DrawOptions = DrawOptions
  { figure :: !Figure
  , figureFile :: !(Maybe FilePath)
  }

data Figure = SceneFigure | DualFigure
  deriving (Eq, Ord, Show, Enum, Bounded)

data GenerateOptions = GenerateOptions
  { generatedFamily :: !Family
  , generatedSize :: !Size
  , generatedSeed :: !Seed
  }

-- | Reads the arguments; a mistake in them ends the program with exit code 1 and a hint.
readCommand :: IO Command
readCommand = customExecParser (prefs showHelpOnEmpty) whole

whole :: ParserInfo Command
whole =
  info
    (commands <**> version <**> helper)
    ( fullDesc
        <> header "viscomplex: the exact visibility complex of polygonal scenes"
        <> progDesc
          "What sees what in a scene of polygons, decided without rounding: the visibility graph by a topological \
          \sweep, form factors as exact sums of square roots, figures. Scenes are JSON files; - is standard input."
        <> examples
          [ ("a scene to try things on", "viscomplex generate random --size 10 > ten.json")
          , ("how big is its complex?", "viscomplex info ten.json")
          , ("who sees whom", "viscomplex graph ten.json")
          , ("form factors with 30 correct digits", "viscomplex factors ten.json --digits 30")
          , ("pictures", "viscomplex draw scene ten.json -o ten.svg\nviscomplex draw dual ten.json -o ten-dual.svg")
          , ("from another program", "viscomplex generate grid --size 9 | viscomplex graph -")
          ]
          "Exit codes: 0 done, 1 wrong usage, 2 unreadable file, 3 not parseable, 4 invalid scene,\n\
          \70 broken internal law.\n\
          \'viscomplex COMMAND --help' explains a command."
    )
  where
    version = infoOption "viscomplex 0.1.0.0" (long "version" <> help "Print the version.")

commands :: Parser Command
commands =
  hsubparser
    ( command "info" (info (Info <$> common) infoHelp)
        <> command "graph" (info (Graph <$> common <*> graphOptions) graphHelp)
        <> command "factors" (info (Factors <$> common <*> factorOptions) factorsHelp)
        <> command "draw" (info drawCommand drawHelp)
        <> command "generate" (info (Generate <$> generateOptions) generateHelp)
    )
  where
    drawCommand = (\f c file -> Draw c (DrawOptions f file)) <$> figureArgument <*> common <*> figureOption
    infoHelp =
      progDesc "Count what the scene and its visibility complex consist of."
        <> examples [("a file", "viscomplex info scenes/grid.json")] ""
    graphHelp =
      progDesc
        "Print the elementary visible pairs of corners, one a line: 0.1 2.3 means corner 1 of polygon 0 and corner 3 \
        \of polygon 2. Of collinear corners that see each other, only neighbours make a pair."
        <> examples
          [ ("all pairs, sorted", "viscomplex graph scenes/grid.json")
          , ("the lines that bound shadows", "viscomplex graph scenes/grid.json --bitangents")
          , ("in memory that does not grow with the output", "viscomplex graph big.json --unsorted | wc -l")
          ]
          ""
    factorsHelp =
      progDesc
        "Print the form factors of all sides, correctly rounded. Factors that are exactly zero are left out; the sky \
        \is a column like the sides."
        <> examples
          [ ("a table for other programs", "viscomplex factors scenes/room.json > room.csv")
          , ("for reading", "viscomplex factors scenes/two-squares.json --format text --digits 6")
          , ("the exact sums of roots", "viscomplex factors scenes/two-squares.json --format json --exact")
          ]
          ""
    drawHelp =
      progDesc "Draw a figure as SVG."
        <> examples
          [ ("the scene with its free bitangents", "viscomplex draw scene scenes/room.json -o room.svg")
          , ("its dual: lines as points", "viscomplex draw dual scenes/room.json -o room-dual.svg")
          ]
          ""
    generateHelp =
      progDesc "Print a scene of a named family. The same family, size and seed give the same scene."
        <> examples
          [ ("a thousand quadrilaterals", "viscomplex generate random --size 1000 --seed 7 > thousand.json")
          , ("squares in a square lattice", "viscomplex generate grid --size 25")
          ]
          ("Families:\n" <> unlines [pad 14 (familyLabel f) <> Text.unpack (familyPurpose f) | f <- [minBound ..]])
    pad n word = "  " <> word <> replicate (n - length word) ' '

-- | Examples, each with its purpose, and further lines, below the list of options.
examples :: [(String, String)] -> String -> InfoMod a
examples shown more = footerDoc (Just (vsep (text "Examples:" : concatMap example shown <> ending)))
  where
    example (purpose, call) = indent 2 (text ("# " <> purpose)) : map (indent 2 . text) (lines call)
    ending = if null more then [] else empty : map text (lines more)

common :: Parser Common
common = Common <$> scene <*> arithmetic <* scheduler
  where
    scene = argument str (metavar "SCENE" <> help "A scene file (JSON), or - for standard input.")
    arithmetic =
      option
        (oneOf [("filtered", Filtered), ("exact", Exact), ("double", UnsafeDouble)])
        ( long "arithmetic"
            <> metavar "filtered|exact|double"
            <> value Filtered
            <> showDefaultWith (const "filtered")
            <> help "How signs are decided. double is unsafe: wrong results are its purpose."
        )
    scheduler =
      option
        (oneOf [("topological", ())])
        ( long "scheduler"
            <> metavar "topological"
            <> value ()
            <> showDefaultWith (const "topological")
            <> help "The order in which vertices are swept; the result does not depend on it."
        )

graphOptions :: Parser GraphOptions
graphOptions =
  GraphOptions
    <$> flag
      AllPairs
      FreeBitangents
      (long "bitangents" <> help "Only pairs whose line is tangent at both corners; sides of polygons left out.")
    <*> flag
      ByName
      AsSwept
      (long "unsorted" <> help "Print pairs as they are swept, in memory that does not grow with them.")

factorOptions :: Parser FactorOptions
factorOptions =
  FactorOptions
    <$> option
      (oneOf [("csv", FactorsCsv), ("json", FactorsJson), ("text", FactorsText)])
      ( long "format"
          <> metavar "csv|json|text"
          <> value FactorsCsv
          <> showDefaultWith (const "csv")
          <> help "Output format."
      )
    <*> option
      significant
      ( long "digits"
          <> metavar "N"
          <> value defaultDigits
          <> showDefaultWith (show . digitCount)
          <> help "Significant digits, at least 1, correctly rounded."
      )
    <*> flag
      DecimalsOnly
      WithExactMeasures
      (long "exact" <> help "Also print the measure 2 L F of each factor, as an exact sum of square roots.")
  where
    significant = eitherReader $ \word -> do
      count <- fromInteger <$> wholeNumber "digits" 1 1000000 word
      maybe (Left "give 1 digit or more") Right (digits count)

figureArgument :: Parser Figure
figureArgument =
  argument
    (oneOf [("scene", SceneFigure), ("dual", DualFigure)])
    ( metavar "FIGURE"
        <> help "scene: the polygons and their free bitangents. dual: the arrangement of the corners' curves."
    )

figureOption :: Parser (Maybe FilePath)
figureOption =
  optional . strOption $
    short 'o' <> long "output" <> metavar "FILE.svg" <> help "Where to write; standard output if not given."

generateOptions :: Parser GenerateOptions
generateOptions =
  GenerateOptions
    <$> argument
      (oneOf [(familyLabel f, f) | f <- [minBound ..]])
      (metavar "FAMILY" <> help (intercalate ", " (map familyLabel [minBound ..])))
    <*> option
      sizeReader
      (long "size" <> metavar "N" <> help "How many polygons (of a comb: teeth).")
    <*> option
      (eitherReader (fmap (Seed . fromInteger) . wholeNumber "seed" 0 (2 ^ (64 :: Int) - 1)))
      (long "seed" <> metavar "S" <> value (Seed 1) <> showDefaultWith (const "1") <> help "A whole number.")

sizeReader :: ReadM Size
sizeReader = eitherReader $ \word -> do
  count <- fromInteger <$> wholeNumber "size" 1 10000000 word
  maybe (Left "give a size of 1 or more") Right (size count)

familyLabel :: Family -> String
familyLabel = Text.unpack . familyName

-- | One of some words; another one is answered with the list.
oneOf :: [(String, a)] -> ReadM a
oneOf choices = eitherReader $ \word -> case lookup word choices of
  Just choice -> Right choice
  Nothing -> Left (word <> " is none of: " <> intercalate ", " (map fst choices))

-- | A number in decimal digits, within bounds; the name is that of what is counted.
wholeNumber :: String -> Integer -> Integer -> String -> Either String Integer
wholeNumber name least greatest word = case readMaybe word of
  Just n | not (null word), all isDigit word, least <= n, n <= greatest -> Right n
  _ -> Left (name <> ": " <> show word <> " is not a whole number from " <> show least <> " to " <> show greatest)
