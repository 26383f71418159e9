-- | All that can prevent a file from stating any scene, valid or not, and its text.
module Visibility.Error.Parse
  ( ParseError (..)
  , TextPosition (..)
  , SyntaxFault (..)
  , Expected (..)
  , JsonPath (..)
  , ShapeFault (..)
  , OutlineFault (..)
  , Wanted (..)
  , aNumber
  , parseErrorText
  , quoted
  , shortened
  , numberFaultText
  ) where

import Data.Char (isAlpha, isAlphaNum, isAscii, isControl, ord)
import Data.Foldable (toList)
import Data.List (intercalate)
import Data.List.NonEmpty (NonEmpty (..))
import Data.Text (Text)
import qualified Data.Text as Text
import Numeric (showHex)
import Visibility.Exact.Point (Point (..))
import Visibility.Format.Number

-- | Why bytes are not the statement of a scene, true or false.
data ParseError
  = SyntaxError !TextPosition !SyntaxFault
  | ShapeError !JsonPath !ShapeFault
  deriving (Eq, Ord, Show)

-- | Line and column, both from 1; a column is a character, not a byte.
data TextPosition = TextPosition !Int !Int
  deriving (Eq, Ord, Show)

-- | Why a text is neither JSON nor WKT of a scene, or not even text.
data SyntaxFault
  = -- | The character found, nothing at the end of the text.
    Unexpected !(Maybe Char) !Expected
  | -- | The word or sign found in a line of WKT, nothing at its end.
    UnexpectedWord !(Maybe Text) !Expected
  | BadWord !Text !NumberFault
  | BadGeometry !OutlineFault
  | ControlCharacter !Char
  | InvalidUtf8
  | -- | More brackets open than this.
    TooDeep !Int
  deriving (Eq, Ord, Show)

-- | What JSON or WKT allows at a place, in words.
newtype Expected = Expected String
  deriving (Eq, Ord, Show)

-- | Where in a JSON document.
data JsonPath = Root | Key !JsonPath !Text | Item !JsonPath !Int
  deriving (Eq, Ord, Show)

-- | Why a JSON value does not have the shape of its place in a scene. What was found is told in words.
data ShapeFault
  = WrongKind !String !Wanted
  | -- | Neither this key nor one of the others that would do.
    MissingKey !(NonEmpty Text) !Wanted
  | -- | Two keys of which only one may be given.
    ClashingKeys !Text !Text
  | -- | With the keys that are allowed.
    UnknownKey !Text ![Text]
  | DuplicateKey !Text
  | -- | A key of @sides@ that is no side number.
    BadSideKey !Text
  | BadNumber !String !NumberFault
  | BadOutline !OutlineFault
  | -- | A ring within the enclosure's outer one.
    EnclosureHole
  | -- | A line given as the enclosure.
    EnclosureWall
  | -- | With the place of the first.
    SecondEnclosure !JsonPath
  deriving (Eq, Ord, Show)

-- | Why the positions of a ring or a line, as GeoJSON and WKT give them, are not an outline of a polygon.
data OutlineFault
  = -- | The last position is not the first: the first and the last.
    OpenRing !Point !Point
  | -- | So few positions that, the last left out, there are not three.
    ShortRing !Int
  | -- | With the number of positions, 0 or 1.
    ShortLine !Int
  | -- | A ring within a polygon's outer one.
    Hole
  deriving (Eq, Ord, Show)

-- | What belongs in a place of a scene, in words.
newtype Wanted = Wanted String
  deriving (Eq, Ord, Show)

aNumber :: Wanted
aNumber = Wanted "a number such as 2, -0.5 or 1e-3, or a string such as \"1/3\", \"-2.5\" or \"7\""

-- | The text of an error without the file, one line.
parseErrorText :: ParseError -> String
parseErrorText fault = case fault of
  SyntaxError position why -> positionText position <> ": " <> syntaxText why
  ShapeError path why -> pathText path <> ": " <> shapeText why
  where
    positionText (TextPosition line column) = "line " <> show line <> ", column " <> show column

syntaxText :: SyntaxFault -> String
syntaxText fault = case fault of
  Unexpected found (Expected expected) ->
    "found " <> maybe "the end of the text" characterText found <> "; " <> expected
  UnexpectedWord found (Expected expected) ->
    "found " <> maybe "the end of the line" quoted found <> "; " <> expected
  BadWord spelled why -> quoted spelled <> numberFaultText why
  BadGeometry why -> outlineText why
  ControlCharacter c -> "found " <> characterText c <> " inside a string; spell it as an escape"
  InvalidUtf8 -> "these bytes are not UTF-8; save the file as UTF-8"
  TooDeep limit -> "more than " <> show limit <> " brackets are open; a scene needs no more than ten"

characterText :: Char -> String
characterText c
  | isControl c = "the character U+" <> codeText c
  | otherwise = ['\'', c, '\'']

codeText :: Char -> String
codeText c = replicate (4 - length digits) '0' <> digits
  where
    digits = showHex (ord c) ""

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
  WrongKind found (Wanted wanted) -> "found " <> found <> "; give " <> wanted
  MissingKey (key :| []) (Wanted wanted) -> "has no " <> quoted key <> "; give " <> wanted
  MissingKey keys (Wanted wanted) ->
    "has neither " <> intercalate " nor " (map quoted (toList keys)) <> "; give one of them, " <> wanted
  ClashingKeys key other -> "has both " <> quoted key <> " and " <> quoted other <> "; give one of them"
  UnknownKey key allowed ->
    "unknown key " <> quoted key <> "; allowed are " <> intercalate ", " (map Text.unpack allowed)
  DuplicateKey key -> "key " <> quoted key <> " is given more than once; give it once"
  BadSideKey key -> quoted key <> " is not a side number; give a number such as \"0\""
  BadNumber found NotANumber -> let Wanted wanted = aNumber in found <> " is not a number; give " <> wanted
  BadNumber found why -> found <> numberFaultText why
  BadOutline why -> outlineText why
  EnclosureHole -> "is a hole of the enclosure; leave it out, and give what stands there as a polygon of its own"
  EnclosureWall -> "is a line and cannot be the enclosure; give a Polygon"
  SecondEnclosure first ->
    "is a second enclosure beside " <> pathText first <> "; leave out the \"role\" of one of them"

outlineText :: OutlineFault -> String
outlineText fault = case fault of
  OpenRing first end ->
    "the ring begins at " <> pointText first <> " and ends at " <> pointText end
      <> "; repeat its first position as the last"
  ShortRing n ->
    "the ring has " <> positions n
      <> "; give four or more, the last the same as the first, or a line of two for a thin wall"
  ShortLine n -> "the line has " <> positions n <> "; give two or more"
  Hole -> "is a hole, and the polygons of a scene are solid; leave it out, or cut the polygon into some without holes"
  where
    positions 1 = "1 position"
    positions n = show n <> " positions"
    pointText (Point x y) = "(" <> numberText x <> ", " <> numberText y <> ")"

-- | What is wrong with a number and what would be right, to follow its text.
numberFaultText :: NumberFault -> String
numberFaultText why = case why of
  NotANumber -> " is not a number; give one such as 2, -0.5, 1e-3 or 1/3"
  ZeroDenominator -> " has the denominator 0; give a denominator of 1 or more"
  ExponentTooLarge ->
    let limit = show exponentLimit
     in " has too large an exponent; give one from -" <> limit <> " to " <> limit

-- | In double quotes, on one line, of a length that can be read.
quoted :: Text -> String
quoted text = "\"" <> concatMap escaped (Text.unpack (shortened text)) <> "\""
  where
    escaped c
      | c == '"' || c == '\\' = ['\\', c]
      | isControl c = "\\u" <> codeText c
      | otherwise = [c]

-- | Cut where it is long.
shortened :: Text -> Text
shortened text
  | Text.compareLength text 60 == GT = Text.take 40 text <> Text.pack "..."
  | otherwise = text
