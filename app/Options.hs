-- | What the command line says, and the help that explains it.
module Options
  ( -- * Commands
    Command (..)
  , readCommand
    -- * Their options
  , Objects (..)
  , GenerateOptions (..)
  , module Options.Common
  , module Options.Draw
  , module Options.Factors
  , module Options.Mesh
  , module Options.Radiosity
  , module Options.View
  ) where

import Data.List (intercalate)
import qualified Data.Text as Text
import Data.Version (showVersion)
import Data.Word (Word64)
import Options.Applicative hiding (empty)
import Options.Applicative.Help.Pretty (empty, indent, text, vsep)
import Options.Applicative.Types (Context (..))
import Options.Common
import qualified Paths_viscomplex as Paths
import Options.Draw
import Options.Factors
import Options.Mesh
import Options.Radiosity
import Options.Reader
import Options.View
import Visibility.Scene.Family

-- | A command with its options.
data Command
  = Info !Common
  | Graph !Common !GraphOptions
  | Factors !Common !FactorOptions
  | Complex !Common !Objects
  | Mesh !Common !MeshOptions
  | Radiosity !Common !RadiosityOptions
  | Verify !Common
  | View !Common !ViewOptions
  | Draw !Common !DrawOptions
  | Generate !GenerateOptions

-- | What counts as one object in the complex.
data Objects = BySides | ByPolygons

data GenerateOptions = GenerateOptions
  { generatedFamily :: !Family
  , generatedSize :: !Size
  , generatedSeed :: !Seed
  , generatedMemory :: !(Maybe Word64)
  }

-- | Reads the arguments; a mistake in them ends the program with exit code 1 and a hint.
readCommand :: IO Command
readCommand = customExecParser preferences whole >>= either mistaken pure
  where
    preferences = prefs showHelpOnEmpty
    mistaken (Mistake name within message) =
      handleParseResult (Failure (parserFailure preferences whole (ErrorMsg message) [Context name within]))

-- | A mistake that shows only when the arguments of a command are looked at together: the command and what is wrong.
data Mistake = Mistake !String !(ParserInfo (Either Mistake Command)) !String

whole :: ParserInfo (Either Mistake Command)
whole =
  info
    (commands <**> version <**> helper)
    ( fullDesc
        <> header "viscomplex: the exact visibility complex of polygonal scenes"
        <> progDesc
          "What sees what in a scene of polygons, decided without rounding: the visibility graph by a topological \
          \sweep, the whole visibility complex, views from points, corners and sides, form factors as exact sums of \
          \square roots, radiosity within proved bounds, figures. Scenes are files in JSON, GeoJSON (.geojson) or WKT \
          \(.wkt); - is standard input, in JSON."
        <> examples
          [ ("a scene to try things on", "viscomplex generate random --size 10 > ten.json")
          , ("how big is its complex?", "viscomplex info ten.json")
          , ("who sees whom", "viscomplex graph ten.json")
          , ("what is seen from a corner", "viscomplex view ten.json --corner 3.0")
          , ("is the complex right?", "viscomplex verify ten.json")
          , ("form factors with 30 correct digits", "viscomplex factors ten.json --digits 30")
          , ("pictures", "viscomplex draw scene ten.json -o ten.svg\nviscomplex draw dual ten.json -o ten-dual.svg")
          , ("from another program", "viscomplex generate grid --size 9 | viscomplex graph -")
          ]
          "Exit codes: 0 done, 1 wrong usage, 2 unreadable or unwritable file, 3 not parseable, 4 invalid scene,\n\
          \5 a check found a difference, 6 more memory needed than allowed, 70 broken internal law.\n\
          \'viscomplex COMMAND --help' explains a command."
    )
  where
    version = infoOption ("viscomplex " <> showVersion Paths.version) (long "version" <> help "Print the version.")

commands :: Parser (Either Mistake Command)
commands =
  hsubparser
    ( command "info" (info (right (Info <$> commonOptions)) infoHelp)
        <> command "graph" (info (right (Graph <$> commonOptions <*> graphOptions)) graphHelp)
        <> command "factors" factorsCommand
        <> command "complex" (info (right (Complex <$> commonOptions <*> objects)) complexHelp)
        <> command "radiosity" radiosityCommand
        <> command "view" viewCommand
        <> command "mesh" (info (right (Mesh <$> commonOptions <*> meshOptions)) meshHelp)
        <> command "verify" (info (right (Verify <$> commonOptions)) verifyHelp)
        <> command "draw" drawCommand
        <> command "generate" (info (right (Generate <$> generateOptions)) generateHelp)
    )
  where
    right = fmap Right
    factorsCommand = info (mistakenIn "factors" factorsCommand (factoring <$> commonOptions <*> factorOptions)) factorsHelp
    factoring shared = fmap (Factors shared)
    radiosityCommand =
      info (mistakenIn "radiosity" radiosityCommand (radiating <$> commonOptions <*> radiosityOptions)) radiosityHelp
    radiating shared = fmap (Radiosity shared)
    viewCommand = info (mistakenIn "view" viewCommand (fmap . View <$> commonOptions <*> viewOptions)) viewHelp
    drawCommand = info (mistakenIn "draw" drawCommand (drawing <$> figureKind <*> commonOptions <*> figureOption)) drawHelp
    drawing chosen shared file = Draw shared . (`DrawOptions` file) <$> chosen
    mistakenIn name within = fmap (either (Left . Mistake name within) Right)
    objects =
      flag
        BySides
        ByPolygons
        ( long "polygons"
            <> help
              "Take each polygon as one object, instead of its sides. Vertices and edges are printed where all \
              \polygons are convex or thin walls and none touches another, under the sky; else faces only."
        )
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
          , ("the nearest Doubles, fast", "viscomplex factors scenes/room.json --double > room.csv")
          ]
          ""
    complexHelp =
      progDesc
        "Print the whole visibility complex as JSON: corners, vertices, edges, faces and their incidences, in an order \
        \that depends on the scene only."
        <> examples
          [ ("all of it", "viscomplex complex scenes/room.json > room-complex.json")
          , ("the faces, with jq", "viscomplex complex scenes/room.json | jq -c '.faces[]'")
          , ("of polygons instead of sides", "viscomplex complex scenes/grid.json --polygons")
          ]
          ""
    radiosityHelp =
      progDesc
        "Print the radiosity of every side as JSON: a lower and an upper bound, proved, that are as close as asked; \
        \and what is emitted, absorbed and lost to the sky. Emission and reflectivity are those of the scene's file."
        <> examples
          [ ("within a billionth", "viscomplex radiosity scenes/flat.json")
          , ("closer", "viscomplex radiosity scenes/flat.json --tolerance 1e-12")
          , ("fifty digits, from exact form factors", "viscomplex radiosity scenes/room.json --digits 50")
          , ("the sides, with jq", "viscomplex radiosity scenes/room.json | jq -c '.sides[]'")
          ]
          ""
    viewHelp =
      progDesc
        "Print what is seen from a point, a corner or a side, as JSON: the visibility polygon, or with --normal the \
        \form factors of a small element there, to which rays into the solid add nothing; of a side, all sides that it \
        \sees with their form factors. Exact."
        <> examples
          [ ("the visibility polygon of a point", "viscomplex view scenes/room.json --from 1/2,3")
          , ("of one that is not between the corners", "viscomplex view scenes/two-squares.json --from=-1,1/2")
          , ("of a corner", "viscomplex view scenes/room.json --corner 0.1")
          , ("an element that faces upwards", "viscomplex view scenes/room.json --from 1/2,3 --normal 0,1")
          , ("what a side sees", "viscomplex view scenes/room.json --side E.0 --digits 30")
          ]
          ""
    meshHelp =
      progDesc
        "Print the discontinuity mesh as JSON: for every side the exact points where the line of two corners that see \
        \each other lands, each with the corners that cast it, and whether it is the limit of a shadow or a kink."
        <> examples
          [ ("all break points", "viscomplex mesh scenes/room.json")
          , ("where shadows end", "viscomplex mesh scenes/room.json --breaks shadow-limits")
          , ("at most 8 elements on a side", "viscomplex mesh scenes/room.json --max-elements 8")
          , ("ten equal parts", "viscomplex mesh scenes/room.json --breaks uniform:10")
          ]
          ""
    verifyHelp =
      progDesc
        "Build the complex and decide every one of its laws, exactly: one line each, and one that counts them. Ends \
        \with exit code 5 if one does not hold; the laws of the complex of polygons are then left out."
        <> examples [("a file", "viscomplex verify scenes/grid.json")] ""
    drawHelp =
      progDesc "Draw a figure as SVG."
        <> examples
          [ ("the scene with its free bitangents", "viscomplex draw scene scenes/room.json -o room.svg")
          , ("its dual: lines as points", "viscomplex draw dual scenes/room.json -o room-dual.svg")
          , ("its form factors", "viscomplex draw matrix scenes/room.json -o room-matrix.svg")
          , ("its light, with a profile along a side", "viscomplex draw radiosity scenes/room.json --profile E.0")
          , ("what is seen from a point", "viscomplex draw view scenes/room.json --from 1/2,3 -o room-view.svg")
          , ("where shadows end", "viscomplex draw mesh scenes/room.json --breaks shadow-limits --lines")
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

generateOptions :: Parser GenerateOptions
generateOptions =
  GenerateOptions
    <$> argument
      (oneOf [(familyLabel f, f) | f <- [minBound ..]])
      (metavar "FAMILY" <> help (intercalate ", " (map familyLabel [minBound ..])))
    <*> option
      (eitherReader (countOf "size" 10000000 size))
      (long "size" <> metavar "N" <> help "How many polygons (of a comb: teeth).")
    <*> option
      (eitherReader (fmap (Seed . fromInteger) . wholeNumber "seed" 0 (2 ^ (64 :: Int) - 1)))
      (long "seed" <> metavar "S" <> value (Seed 1) <> showDefaultWith (const "1") <> help "A whole number.")
    <*> memoryOption

familyLabel :: Family -> String
familyLabel = Text.unpack . familyName
