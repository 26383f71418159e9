-- | The commands: one table, from which arguments are read, help and the manual are made, and mistakes are answered.
module Options.Table
  ( Instead (..)
  , Entry
  , commands
  , figures
  , whole
  , versionText
  ) where

import Command.Draw (drawDual, drawScene)
import Command.Elements (runMesh)
import Command.Query
import Data.Bifunctor (first)
import Data.List (intercalate)
import qualified Data.Text as Text
import Data.Version (showVersion)
import Options.Applicative hiding (empty)
import Options.Applicative.Help.Pretty (empty, indent, text, vsep)
import Options.Applicative.Types (Context (..))
import Options.Common
import Options.Mesh
import Options.Reader
import Options.Results
import qualified Paths_viscomplex as Paths
import Visibility.Complex.Polygons (polygonComplex)
import Visibility.Format.Complex (complexDocument, polygonDocument)
import Visibility.Format.Graph (PairSelection (..))
import Visibility.Scene.Family

-- | What is to be done instead of a command.
data Instead
  = -- | To tell a mistake that shows only when the arguments of a command are looked at together: where, the inner one
    -- first, and what is wrong.
    Mistake ![Context] !String
  | -- | To explain a command, and perhaps a figure of it.
    Explain ![String]

-- | The word of a command or a figure, and what is read and said of it.
type Entry = (String, ParserInfo (Either Instead (IO ())))

-- | Everything.
whole :: String -> ParserInfo (Either Instead (IO ()))
whole manual =
  info
    (choiceOf "COMMAND" commands <**> version <**> man <**> helper)
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
          \'viscomplex help COMMAND' explains a command."
    )
  where
    version = infoOption versionText (long "version" <> help "Print the version.")
    man = infoOption manual (long "man" <> help "Print the manual page, for man -l -.")

versionText :: String
versionText = "viscomplex " <> showVersion Paths.version

-- | One of some commands or figures.
choiceOf :: String -> [Entry] -> Parser (Either Instead (IO ()))
choiceOf shape entries =
  hsubparser (metavar shape <> commandGroup ("Each " <> shape <> ":") <> foldMap (uncurry command) entries)

-- | A command or a figure: its word, what it is for, examples, and its arguments, or what is wrong with them together.
entry :: String -> String -> [(String, String)] -> Parser (Either Instead (IO ())) -> Entry
entry name purpose shown = entryWith name purpose shown ""

-- | With more lines below the examples.
entryWith :: String -> String -> [(String, String)] -> String -> Parser (Either Instead (IO ())) -> Entry
entryWith name purpose shown more arguments = (name, described)
  where
    described = info (first within <$> arguments) (progDesc purpose <> examples shown more)
    within (Mistake inner wrong) = Mistake (inner <> [Context name described]) wrong
    within other = other

-- | Arguments with which nothing is wrong when they are looked at together.
right :: Parser (IO ()) -> Parser (Either Instead (IO ()))
right = fmap Right

-- | Other arguments.
checked :: Parser (Either String (IO ())) -> Parser (Either Instead (IO ()))
checked = fmap (first (Mistake []))

commands :: [Entry]
commands =
  [ entry
      "info"
      "Count what the scene and its visibility complex consist of."
      [("a file", "viscomplex info scenes/grid.json")]
      (right (runInfo <$> commonOptions))
  , entry
      "graph"
      "Print the elementary visible pairs of corners, one a line: 0.1 2.3 means corner 1 of polygon 0 and corner 3 of \
      \polygon 2. Of collinear corners that see each other, only neighbours make a pair."
      [ ("all pairs, sorted", "viscomplex graph scenes/grid.json")
      , ("the lines that bound shadows", "viscomplex graph scenes/grid.json --bitangents")
      , ("in memory that does not grow with the output", "viscomplex graph big.json --unsorted | wc -l")
      ]
      (right (runGraph <$> commonOptions <*> pairs <*> order))
  , entry
      "factors"
      "Print the form factors of all sides, correctly rounded. Factors that are exactly zero are left out; the sky is \
      \a column like the sides."
      [ ("a table for other programs", "viscomplex factors scenes/room.json > room.csv")
      , ("for reading", "viscomplex factors scenes/two-squares.json --format text --digits 6")
      , ("the exact sums of roots", "viscomplex factors scenes/two-squares.json --format json --exact")
      , ("the nearest Doubles, fast", "viscomplex factors scenes/room.json --double > room.csv")
      ]
      (with factorOptions)
  , entry
      "complex"
      "Print the whole visibility complex as JSON: corners, vertices, edges, faces and their incidences, in an order \
      \that depends on the scene only."
      [ ("all of it", "viscomplex complex scenes/room.json > room-complex.json")
      , ("the faces, with jq", "viscomplex complex scenes/room.json | jq -c '.faces[]'")
      , ("of polygons instead of sides", "viscomplex complex scenes/grid.json --polygons")
      ]
      (right (runComplex <$> commonOptions <*> objects))
  , entry
      "radiosity"
      "Print the radiosity of every side as JSON: a lower and an upper bound, proved, that are as close as asked; and \
      \what is emitted, absorbed and lost to the sky. Emission and reflectivity are those of the scene's file."
      [ ("within a billionth", "viscomplex radiosity scenes/flat.json")
      , ("closer", "viscomplex radiosity scenes/flat.json --tolerance 1e-12")
      , ("fifty digits, from exact form factors", "viscomplex radiosity scenes/room.json --digits 50")
      , ("the sides, with jq", "viscomplex radiosity scenes/room.json | jq -c '.sides[]'")
      ]
      (with radiosityOptions)
  , entry
      "view"
      "Print what is seen from a point, a corner or a side, as JSON: the visibility polygon, or with --normal the form \
      \factors of a small element there, to which rays into the solid add nothing; of a side, all sides that it sees \
      \with their form factors. Exact."
      [ ("the visibility polygon of a point", "viscomplex view scenes/room.json --from 1/2,3")
      , ("of one that is not between the corners", "viscomplex view scenes/two-squares.json --from=-1,1/2")
      , ("of a corner", "viscomplex view scenes/room.json --corner 0.1")
      , ("an element that faces upwards", "viscomplex view scenes/room.json --from 1/2,3 --normal 0,1")
      , ("what a side sees", "viscomplex view scenes/room.json --side E.0 --digits 30")
      ]
      (with viewOptions)
  , entry
      "mesh"
      "Print the discontinuity mesh as JSON: for every side the exact points where the line of two corners that see \
      \each other lands, each with the corners that cast it, and whether it is the limit of a shadow or a kink."
      [ ("all break points", "viscomplex mesh scenes/room.json")
      , ("where shadows end", "viscomplex mesh scenes/room.json --breaks shadow-limits")
      , ("at most 8 elements on a side", "viscomplex mesh scenes/room.json --max-elements 8")
      , ("ten equal parts", "viscomplex mesh scenes/room.json --breaks uniform:10")
      ]
      (right (runMesh <$> commonOptions <*> meshOptions))
  , entry
      "verify"
      "Build the complex and decide every one of its laws, exactly: one line each, and one that counts them. Ends with \
      \exit code 5 if one does not hold; the laws of the complex of polygons are then left out."
      [("a file", "viscomplex verify scenes/grid.json")]
      (right (runVerify <$> commonOptions))
  , entry
      "draw"
      "Draw a figure as SVG."
      [ ("the scene with its free bitangents", "viscomplex draw scene scenes/room.json -o room.svg")
      , ("the options of a figure", "viscomplex help draw mesh")
      ]
      (choiceOf "FIGURE" figures)
  , entryWith
      "generate"
      "Print a scene of a named family. The same family, size and seed give the same scene."
      [ ("a thousand quadrilaterals", "viscomplex generate random --size 1000 --seed 7 > thousand.json")
      , ("squares in a square lattice", "viscomplex generate grid --size 25")
      ]
      ("Families:\n" <> unlines [pad 14 (familyLabel f) <> Text.unpack (familyPurpose f) | f <- [minBound ..]])
      (right generation)
  , entry
      "help"
      "Explain a command, or a figure of draw."
      [("a command", "viscomplex help graph"), ("a figure", "viscomplex help draw scene")]
      (Left . Explain <$> many (argument str (metavar "COMMAND" <> completeWith (map fst commands <> map fst figures))))
  ]
  where
    with options = checked ((\shared -> fmap ($ shared)) <$> commonOptions <*> options)
    pairs =
      flag
        AllPairs
        FreeBitangents
        (long "bitangents" <> help "Only pairs whose line is tangent at both corners; sides of polygons left out.")
    order =
      flag
        ByName
        AsSwept
        (long "unsorted" <> help "Print pairs as they are swept, in memory that does not grow with them.")
    objects =
      flag
        complexDocument
        (polygonDocument . polygonComplex)
        ( long "polygons"
            <> help
              "Take each polygon as one object, instead of its sides. Vertices and edges are printed where all \
              \polygons are convex or thin walls and none touches another, under the sky; else faces only."
        )
    pad n word = "  " <> word <> replicate (n - length word) ' '

-- | What follows @draw@.
figures :: [Entry]
figures =
  [ drawn "scene" "The polygons and their free bitangents." [("a file", "scene", "-o room.svg")] (plain drawScene)
  , drawn
      "dual"
      "The arrangement of the corners' curves: a line is a point there, a corner a curve."
      [("lines as points", "dual", "-o room-dual.svg")]
      (plain drawDual)
  , drawn
      "matrix"
      "The form factors, a coloured cell for each that is not zero."
      [ ("of sides", "matrix", "-o room-matrix.svg")
      , ("of elements", "matrix", "--mesh uniform:4")
      ]
      matrixFigure
  , drawn
      "view"
      "What is seen from a point, a corner or a side."
      [("from a point", "view", "--from 1/2,3 -o room-view.svg"), ("from a corner", "view", "--corner 0.1")]
      viewFigure
  , drawn
      "mesh"
      "The break points of all sides."
      [("where shadows end", "mesh", "--breaks shadow-limits --lines")]
      meshFigure
  , drawn
      "radiosity"
      "How bright each element of each side is."
      [("with a profile along a side", "radiosity", "--profile E.0")]
      lightFigure
  , framed
      "FILE.svg|FOLDER"
      "sweep"
      "Both horizon trees of the topological sweep, --at a moment or in several --frames."
      [("after 20 vertices", "sweep", "--at 20 -o room-sweep.svg"), ("a film", "sweep", "--frames 10 -o room-sweep")]
      sweepFigure
  ]
  where
    drawn = framed "FILE.svg"
    plain = pure . Right
    framed shape name purpose shown chosen =
      entry name purpose [(what, unwords ["viscomplex draw", f, "scenes/room.json", o]) | (what, f, o) <- shown] $
        checked (drawing <$> commonOptions <*> chosen <*> optional (output shape))
    drawing shared wanted file = (\draw -> draw shared file) <$> wanted
    output shape =
      option (eitherReader (readingOf (outputFile shape))) $
        short 'o' <> long "output" <> metavar shape <> completer (readingCompleter (outputFile shape))
          <> help "Where to write. (default: standard output)"

-- | Examples, each with its purpose, and further lines, below the list of options.
examples :: [(String, String)] -> String -> InfoMod a
examples shown more = footerDoc (Just (vsep (text "Examples:" : concatMap example shown <> ending)))
  where
    example (purpose, call) = indent 2 (text ("# " <> purpose)) : map (indent 2 . text) (lines call)
    ending = if null more then [] else empty : map text (lines more)

generation :: Parser (IO ())
generation =
  runGenerate
    <$> argument
      (eitherReader (readingOf families))
      (metavar "FAMILY" <> completer (readingCompleter families) <> help (intercalate ", " labels))
    <*> given (counted "N" 10000000 "25" size) "size" "How many polygons (of a comb: teeth)." Required
    <*> (given seed "seed" "Which of the scenes of this size." (Default "1") <|> pure (Seed 1))
    <*> talkOption
    <*> memoryOption
  where
    labels = map familyLabel [minBound ..]
    families = words' [(familyLabel f, f) | f <- [minBound ..]]
    seed = refined (Right . Seed . fromInteger) (wholeNumber "S" 0 (2 ^ (64 :: Int) - 1) "7")

familyLabel :: Family -> String
familyLabel = Text.unpack . familyName
