-- | All that can be wrong with input, its text, and the exit code of each case.
--
-- A text has the form @FILE: PLACE: WHAT IS WRONG; WHAT WOULD BE RIGHT@. The place is a line and column, a JSON path, or a
-- polygon with its corner or side as the file counts them.
module Visibility.Error
  ( -- * Problems of a file
    Problem (..)
  , errorText
    -- ** It cannot be read
  , ReadFault (..)
    -- ** It cannot be parsed
  , ParseError (..)
  , TextPosition (..)
  , SyntaxFault (..)
  , Expected (..)
  , JsonPath (..)
  , ShapeFault (..)
  , Found (..)
  , Wanted (..)
  , Format (..)
    -- ** It states no valid scene
  , SceneError (..)
  , MaterialPlace (..)
  , sceneErrorPlace
  , sceneErrorText
    -- * Outcomes of a run
  , Outcome (..)
  , exitNumber
  , problemOutcome
  , problemsOutcome
    -- * Broken laws
  , BrokenLaw (..)
  ) where

import Control.Exception (Exception (..))
import Data.Char (isAlpha, isAlphaNum, isAscii, isControl, ord)
import Data.Foldable (toList)
import Data.List (intercalate)
import Data.List.NonEmpty (NonEmpty)
import qualified Data.Text as Text
import Data.Text (Text)
import Numeric (showHex)
import Visibility.Exact.Point (Point (..))
import Visibility.Format.Number
import Visibility.Scene.Id

-- | Something wrong with an input file. The path is what the user called it.
data Problem
  = UnreadableFile !FilePath !ReadFault
  | UnparseableFile !FilePath !ParseError
  | InvalidScene !FilePath !SceneError
  deriving (Eq, Ord, Show)

-- | Why no bytes came.
data ReadFault
  = NoSuchFile
  | NotPermitted
  | -- | Anything else, in the system's words.
    ReadFailed !String
  deriving (Eq, Ord, Show)

-- | Why bytes are not the statement of a scene, true or false.
data ParseError
  = SyntaxError !TextPosition !SyntaxFault
  | ShapeError !JsonPath !ShapeFault
  | -- | A format that is not read yet.
    FormatNotReadYet !Format
  deriving (Eq, Ord, Show)

-- | Line and column, both from 1; a column is a character, not a byte.
data TextPosition = TextPosition !Int !Int
  deriving (Eq, Ord, Show)

-- | Why a text is not JSON.
data SyntaxFault
  = -- | The character found, nothing at the end of the text.
    Unexpected !(Maybe Char) !Expected
  | ControlCharacter !Char
  | UnpairedSurrogate
  | InvalidUtf8
  | -- | More brackets open than this.
    TooDeep !Int
  deriving (Eq, Ord, Show)

-- | What JSON allows at a place.
data Expected
  = AValue
  | AKey
  | AKeyOrClosingBrace
  | AColon
  | CommaOrClosingBrace
  | CommaOrClosingBracket
  | ADigit
  | -- | After a leading zero.
    NoDigit
  | ClosingQuote
  | AnEscape
  | AHexDigit
  | TheEnd
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | Where in a JSON document.
data JsonPath = Root | Key !JsonPath !Text | Item !JsonPath !Int
  deriving (Eq, Ord, Show)

-- | Why a JSON value does not have the shape of its place in a scene.
data ShapeFault
  = WrongKind !Found !Wanted
  | MissingKey !Text !Wanted
  | -- | With the keys that are allowed.
    UnknownKey !Text ![Text]
  | DuplicateKey !Text
  | -- | A key of @sides@ that is no side number.
    BadSideKey !Text
  | BadNumber !Found !NumberFault
  deriving (Eq, Ord, Show)

-- | A JSON value, as far as a message repeats it. A number is kept as it is spelled.
data Found
  = FoundNull
  | FoundBoolean !Bool
  | FoundNumber !Text
  | FoundString !Text
  | FoundList !Int
  | FoundObject
  deriving (Eq, Ord, Show)

-- | What belongs in a place of a scene.
data Wanted
  = WantedScene
  | WantedFormat
  | WantedString
  | WantedPolygon
  | WantedPolygons
  | WantedCorners
  | WantedCorner
  | WantedNumber
  | WantedSides
  | WantedMaterial
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | Formats other than JSON.
data Format = GeoJson | Wkt
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | Why a 'Visibility.Scene.Raw.RawScene' is not a valid scene. Of two polygons, the earlier one comes first.
data SceneError
  = -- | Neither polygons nor an enclosure.
    EmptyScene
  | -- | With the number of corners.
    TooFewCorners !PolygonId !Int
  | -- | A corner in the place of an earlier one of the same polygon, the first there.
    RepeatedCorner !CornerName !Int !Point
  | -- | Three or more corners, all on a line. Spikes and contacts of the polygon with itself are not named besides.
    ZeroArea !PolygonId
  | -- | An angle of 0° or 360°.
    Spike !CornerName !Point
  | -- | Corners of two polygons in one place.
    CornerOnCorner !CornerName !CornerName !Point
  | -- | A corner on a side, not at its ends, of the same polygon or of another one.
    CornerOnSide !CornerName !SideName !Point
  | -- | Two sides of one polygon or of two that cross in a point that is no corner.
    CrossingSides !SideName !SideName
  | -- | The first lies inside the second; their boundaries do not meet.
    NestedPolygon !PolygonId !PolygonId
  | -- | A polygon outside of the enclosure; their boundaries do not meet.
    OutsideEnclosure !PolygonId
  | -- | A side named under @sides@, and the number of sides that there are.
    NoSuchSide !SideName !Int
  | BadEmission !MaterialPlace !Rational
  | BadReflectivity !MaterialPlace !Rational
  deriving (Eq, Ord, Show)

-- | What a material is stated for.
data MaterialPlace = OfPolygon !PolygonId | OfSide !SideName
  deriving (Eq, Ord, Show)

-- | The polygon, and in it the corner or side, that an error is listed under; nothing for the scene as a whole.
sceneErrorPlace :: SceneError -> Maybe (PolygonId, Maybe Int)
sceneErrorPlace problem = case problem of
  EmptyScene -> Nothing
  TooFewCorners p _ -> Just (p, Nothing)
  RepeatedCorner c _ _ -> corner c
  ZeroArea p -> Just (p, Nothing)
  Spike c _ -> corner c
  CornerOnCorner c _ _ -> corner c
  CornerOnSide c _ _ -> corner c
  CrossingSides s _ -> side s
  NestedPolygon p _ -> Just (p, Nothing)
  OutsideEnclosure p -> Just (p, Nothing)
  NoSuchSide (SideName p _) _ -> Just (p, Nothing)
  BadEmission m _ -> material m
  BadReflectivity m _ -> material m
  where
    corner (CornerName p k) = Just (p, Just k)
    side (SideName p k) = Just (p, Just k)
    material (OfPolygon p) = Just (p, Nothing)
    material (OfSide s) = side s

-- | One line without its end.
errorText :: Problem -> String
errorText problem = case problem of
  UnreadableFile file fault -> file <> ": " <> readText fault
  UnparseableFile file fault -> file <> ": " <> parseText fault
  InvalidScene file fault -> file <> ": " <> sceneErrorText fault

readText :: ReadFault -> String
readText fault = case fault of
  NoSuchFile -> "there is no such file; give the path of a scene, or - for standard input"
  NotPermitted -> "may not be read; give yourself permission to read it"
  ReadFailed reason -> "cannot be read (" <> reason <> "); give the path of a scene, or - for standard input"

parseText :: ParseError -> String
parseText fault = case fault of
  SyntaxError (TextPosition line column) why ->
    "line " <> show line <> ", column " <> show column <> ": " <> syntaxText why
  ShapeError path why -> pathText path <> ": " <> shapeText why
  FormatNotReadYet format -> formatText format <> " is not read yet; give the scene as JSON"

formatText :: Format -> String
formatText GeoJson = "GeoJSON"
formatText Wkt = "WKT"

syntaxText :: SyntaxFault -> String
syntaxText fault = case fault of
  Unexpected found expected -> "found " <> maybe "the end of the text" characterText found <> "; " <> expectedText expected
  ControlCharacter c -> "found " <> characterText c <> " inside a string; spell it as an escape"
  UnpairedSurrogate -> "half of a surrogate pair; give both halves, or the character itself"
  InvalidUtf8 -> "these bytes are not UTF-8; save the file as UTF-8"
  TooDeep limit -> "more than " <> show limit <> " brackets are open; a scene needs no more than five"

characterText :: Char -> String
characterText c
  | isControl c = "the character U+" <> codeText c
  | otherwise = ['\'', c, '\'']

codeText :: Char -> String
codeText c = replicate (4 - length digits) '0' <> digits
  where
    digits = showHex (ord c) ""

expectedText :: Expected -> String
expectedText expected = case expected of
  AValue -> "a value belongs here"
  AKey -> "a key in double quotes belongs here"
  AKeyOrClosingBrace -> "a key in double quotes or } belongs here"
  AColon -> ": belongs here"
  CommaOrClosingBrace -> ", or } belongs here"
  CommaOrClosingBracket -> ", or ] belongs here"
  ADigit -> "a digit belongs here"
  NoDigit -> "leave out the zero that the number begins with"
  ClosingQuote -> "a closing \" belongs here"
  AnEscape -> "one of \" \\ / b f n r t u belongs here"
  AHexDigit -> "four hexadecimal digits belong here"
  TheEnd -> "nothing may follow the scene"

-- | @$.polygons[2].corners[0]@; a key that is no plain word stands in brackets and quotes.
pathText :: JsonPath -> String
pathText path = case path of
  Root -> "$"
  Item above k -> pathText above <> "[" <> show k <> "]"
  Key above key
    | isWord (Text.unpack key) -> pathText above <> "." <> Text.unpack key
    | otherwise -> pathText above <> "[" <> quoted key <> "]"
  where
    isWord (c : cs) = isAscii c && isAlpha c && all (\x -> isAscii x && isAlphaNum x) cs
    isWord [] = False

shapeText :: ShapeFault -> String
shapeText fault = case fault of
  WrongKind found wanted -> "found " <> foundText found <> "; give " <> wantedText wanted
  MissingKey key wanted -> "has no " <> quoted key <> "; give " <> wantedText wanted
  UnknownKey key allowed -> "unknown key " <> quoted key <> "; allowed are " <> intercalate ", " (map Text.unpack allowed)
  DuplicateKey key -> "key " <> quoted key <> " is given more than once; give it once"
  BadSideKey key -> quoted key <> " is not a side number; give a number such as \"0\""
  BadNumber found why -> foundText found <> case why of
    NotANumber -> " is not a number; give " <> wantedText WantedNumber
    ZeroDenominator -> " has the denominator 0; give a denominator of 1 or more"
    ExponentTooLarge ->
      let limit = show exponentLimit
       in " has too large an exponent; give one from -" <> limit <> " to " <> limit

foundText :: Found -> String
foundText found = case found of
  FoundNull -> "null"
  FoundBoolean True -> "true"
  FoundBoolean False -> "false"
  FoundNumber spelled -> Text.unpack (shortened spelled)
  FoundString text -> quoted text
  FoundList 0 -> "an empty list"
  FoundList 1 -> "a list of 1 element"
  FoundList n -> "a list of " <> show n <> " elements"
  FoundObject -> "an object"

wantedText :: Wanted -> String
wantedText wanted = case wanted of
  WantedScene -> "an object with the key \"polygons\""
  WantedFormat -> "\"viscomplex/1\""
  WantedString -> "a string"
  WantedPolygon -> "an object with the key \"corners\", or just the list of corners"
  WantedPolygons -> "a list of polygons"
  WantedCorners -> "a list of corners [x, y]"
  WantedCorner -> "a list of two numbers [x, y]"
  WantedNumber -> "a number such as 2, -0.5 or 1e-3, or a string such as \"1/3\", \"-2.5\" or \"7\""
  WantedSides -> "an object with side numbers as keys"
  WantedMaterial -> "an object with the keys \"emission\", \"reflectivity\" or both"

-- In double quotes, on one line, of a length that can be read.
quoted :: Text -> String
quoted text = "\"" <> concatMap escaped (Text.unpack (shortened text)) <> "\""
  where
    escaped c
      | c == '"' || c == '\\' = ['\\', c]
      | isControl c = "\\u" <> codeText c
      | otherwise = [c]

shortened :: Text -> Text
shortened text
  | Text.compareLength text 60 == GT = Text.take 40 text <> Text.pack "..."
  | otherwise = text

-- | The text of an error without the file, one line.
sceneErrorText :: SceneError -> String
sceneErrorText problem = case problem of
  EmptyScene -> "the scene is empty; give at least one polygon or an enclosure"
  TooFewCorners p n ->
    polygon p <> ": has " <> counted n "corner" <> "; give three or more"
      <> (if p == Enclosure then "" else ", or two for a thin wall")
  RepeatedCorner c j at ->
    corner c <> ": repeats corner " <> show j <> " at " <> point at
      <> "; give each corner its own place, or leave one of them out"
  ZeroArea p ->
    polygon p <> ": all corners lie on one line, so its area is zero; move a corner off the line"
      <> (if p == Enclosure then "" else ", or give only the two ends for a thin wall")
  Spike c at ->
    corner c <> ": is the tip of a spike at " <> point at <> ", where the polygon turns back along its own side"
      <> "; move the corner or leave it out"
  CornerOnCorner c d at ->
    corner c <> ": touches " <> otherCorner d <> " at " <> point at <> "; " <> gap
  CornerOnSide c@(CornerName p _) s@(SideName q k) at
    | p == q ->
        corner c <> ": lies on side " <> show k <> " of the same polygon, at " <> point at
          <> "; a polygon may not touch itself, move one of them"
    | otherwise -> corner c <> ": touches " <> otherSide s <> " at " <> point at <> "; " <> gap
  CrossingSides s@(SideName p _) t@(SideName q k)
    | p == q ->
        side s <> ": crosses side " <> show k <> " of the same polygon"
          <> "; list the corners in order around the polygon"
    | q == Enclosure -> side s <> ": crosses " <> otherSide t <> "; keep all of the polygon inside the enclosure"
    | otherwise -> side s <> ": crosses " <> otherSide t <> "; move the polygons apart"
  NestedPolygon p q ->
    polygon p <> ": lies inside " <> polygon q <> ", which is solid; move it out, or leave it out"
  OutsideEnclosure p ->
    polygon p <> ": lies outside the enclosure; move it inside, or leave it or the enclosure out"
  NoSuchSide (SideName p k) n ->
    polygon p <> ": \"sides\" names side " <> show k <> "; "
      <> (if n == 0 then "it has no sides" else "its sides are 0 to " <> show (n - 1))
  BadEmission place x -> material place <> ": emission is " <> numberText x <> "; give 0 or more"
  BadReflectivity place x -> material place <> ": reflectivity is " <> numberText x <> "; give 0 or more, and less than 1"
  where
    gap = "contacts are not supported yet, leave a gap"
    polygon (Obstacle k) = "polygon " <> show k
    polygon Enclosure = "enclosure"
    corner (CornerName p k) = polygon p <> ", corner " <> show k
    side (SideName p k) = polygon p <> ", side " <> show k
    otherCorner (CornerName p k) = "corner " <> show k <> " of " <> the p
    otherSide (SideName p k) = "side " <> show k <> " of " <> the p
    the Enclosure = "the enclosure"
    the p = polygon p
    material (OfPolygon p) = polygon p
    material (OfSide s) = side s
    point (Point x y) = "(" <> numberText x <> ", " <> numberText y <> ")"
    counted 1 noun = "1 " <> noun
    counted n noun = show (n :: Int) <> " " <> noun <> "s"

-- | How a run ends.
data Outcome
  = Success
  | WrongUsage
  | UnreadableInput
  | UnparseableInput
  | InvalidInput
  | -- | A check found a difference.
    DifferenceFound
  | -- | A law that holds by construction does not: an error of this program.
    LawBroken
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | The exit code.
exitNumber :: Outcome -> Int
exitNumber outcome = case outcome of
  Success -> 0
  WrongUsage -> 1
  UnreadableInput -> 2
  UnparseableInput -> 3
  InvalidInput -> 4
  DifferenceFound -> 5
  LawBroken -> 70

-- | How a run ends that meets this problem.
problemOutcome :: Problem -> Outcome
problemOutcome problem = case problem of
  UnreadableFile _ _ -> UnreadableInput
  UnparseableFile _ _ -> UnparseableInput
  InvalidScene _ _ -> InvalidInput

-- | The earliest failure decides: an unreadable file before an unparseable one before an invalid one.
problemsOutcome :: NonEmpty Problem -> Outcome
problemsOutcome = minimum . map problemOutcome . toList

-- | A law of a data structure that does not hold: thrown where it is found, never the fault of the input.
data BrokenLaw = BrokenLaw
  { brokenLawName :: !String
  , brokenLawDetails :: !String
  -- ^ What was found, with all that is needed to see it again.
  }
  deriving (Eq, Ord, Show)

instance Exception BrokenLaw where
  displayException (BrokenLaw name details) =
    "an internal law is broken, which is an error of this program: " <> name <> "\n" <> details
