-- | What values of the command line may be: each is read, described and completed from one place.
module Options.Reader
  ( -- * Options with a value
    given
  , Usual (..)
    -- * What a value may be
  , Reading (..)
  , refined
  , words'
  , oneOf
  , wholeNumber
  , counted
  , pair
  , direction
  , exactNumber
  , address
  , inputFile
  , outputFile
    -- * Corners and sides
  , Address (..)
    -- * Near words
  , meant
  ) where

import Data.Char (isDigit, toLower, toUpper)
import Data.List (intercalate, isPrefixOf, sortOn)
import Data.Ratio (denominator, numerator)
import qualified Data.Text as Text
import Options.Applicative
import Options.Applicative.Help.Levenshtein (editDistance)
import System.FilePath (replaceExtension, takeExtension)
import Text.Read (readMaybe)
import Visibility.Error (numberFaultText)
import Visibility.Exact.Predicate (Direction (..), primitive)
import Visibility.Format.Number (readNumber)

-- | What a value may be.
data Reading a = Reading
  { readingShape :: !String
  -- ^ What stands for it in a usage line.
  , readingBounds :: !String
  -- ^ Its bounds, its unit and an example, in a sentence or none.
  , readingCompleter :: !Completer
  , readingOf :: String -> Either String a
  -- ^ The value, or what is wrong with the word.
  }

-- | What is made of a value, or what is wrong with it.
refined :: (a -> Either String b) -> Reading a -> Reading b
refined make reading = reading {readingOf = \word -> readingOf reading word >>= make}

-- | What holds where an option is not given.
data Usual
  = Default !String
  | -- | One option or another must be given.
    Required

-- | An option with a value: the value, the name, and what it is for.
given :: Reading a -> String -> String -> Usual -> Parser a
given reading name purpose usual =
  option (eitherReader (readingOf reading)) $
    long name <> metavar (readingShape reading) <> completer (readingCompleter reading) <> help (unwords said)
  where
    said = filter (not . null) [purpose, readingBounds reading, usually]
    usually = case usual of
      Default x -> "(default: " <> x <> ")"
      Required -> "(required)"

-- | One of some words.
words' :: [(String, a)] -> Reading a
words' choices = Reading (intercalate "|" (map fst choices)) "" (listCompleter (map fst choices)) (oneOf choices)

-- | Another word is answered with the list, and with the one that is near.
oneOf :: [(String, a)] -> String -> Either String a
oneOf choices word = case lookup word choices of
  Just choice -> Right choice
  Nothing -> Left (word <> " is none of: " <> intercalate ", " names <> meant word names)
  where
    names = map fst choices

-- | @; did you mean graph?@, where one of the words is near to a word: at most two changes of a letter away, of a
-- short word one, or longer by some letters at its end.
meant :: String -> [String] -> String
meant word known = case sortOn fst near <> [(0, name) | not (null word), name <- known, word `isPrefixOf` name] of
  (_, name) : _ -> "; did you mean " <> name <> "?"
  [] -> ""
  where
    near = [(changes, name) | name <- known, let changes = editDistance word name, changes <= farthest name]
    farthest name = min 2 (length (dropWhile (== '-') name) `div` 2) :: Int

-- | A number in decimal digits, within bounds, exactly; given are its letter and an example.
wholeNumber :: String -> Integer -> Integer -> String -> Reading Integer
wholeNumber letter least greatest example = Reading letter (letter <> " is " <> bounds <> ".") mempty $ \word ->
  case readMaybe word of
    Just n | all isDigit word, least <= n, n <= greatest -> Right n
    _ -> Left (show word <> " is not " <> bounds)
  where
    bounds = "a whole number from " <> show least <> " to " <> show greatest <> ", such as " <> example

-- | What is made of a number from 1 to a greatest one.
counted :: String -> Integer -> String -> (Int -> Maybe a) -> Reading a
counted letter greatest example make =
  refined (maybe (Left "give 1 or more") Right . make . fromInteger) (wholeNumber letter 1 greatest example)

-- | An exact number.
exactNumber :: String -> Either String Rational
exactNumber word = either (Left . (show word <>) . numberFaultText) Right (readNumber (Text.pack word))

-- | Two exact numbers with a comma between them; given are their letters.
pair :: String -> Reading (Rational, Rational)
pair letters = Reading letters bounds mempty $ \word -> case break (== ',') word of
  (x, ',' : y) | ',' `notElem` y -> (,) <$> exactNumber x <*> exactNumber y
  _ -> Left (word <> " is not a pair such as 1/2,3")
  where
    bounds = letters <> " are exact numbers as in files, such as 1/2,3 or 0.1,-2e-3, with exponents from -400 to 400."

direction :: String -> Reading Direction
direction = refined direct . pair
  where
    direct (0, 0) = Left "0,0 has no direction; give another pair"
    direct (x, y) =
      let scale = denominator x * denominator y
       in Right (primitive (Direction (scaled scale x) (scaled scale y)))
    scaled scale q = numerator q * (scale `div` denominator q)

-- | A corner or a side, as it is given: with the number or name of its polygon, and its own number.
data Address = Address
  { addressPolygon :: !String
  , addressNumber :: !Integer
  }

-- | Given is the letter of the corner or side; both are spelled alike.
address :: String -> Reading Address
address letter = Reading shape bounds mempty $ \word -> case break (== '.') (reverse word) of
  (number, '.' : polygon) | isNumber (reverse number), not (null polygon) ->
    maybe (notOne word) (Right . Address (reverse polygon)) (readMaybe (reverse number))
  _ -> notOne word
  where
    shape = "P." <> letter
    bounds =
      "P is the number of a polygon, E for the enclosure, or a name that one polygon has, and " <> letter
        <> " counts from 0, such as 3.0, E.2 or lamp.1."
    notOne word = Left (word <> " is not a name such as 3.0 or E.2")
    -- Without leading zeros, as it is written.
    isNumber digits = all isDigit digits && (take 1 digits /= "0" || digits == "0")

inputFile :: Reading FilePath
inputFile = Reading "SCENE" "" (bashCompleter "file") Right

-- | A file for SVG. A name that says another format is refused.
outputFile :: String -> Reading FilePath
outputFile shape = Reading shape "" (bashCompleter "file") $ \path -> case drop 1 (map toLower (takeExtension path)) of
  ending
    | ending `elem` convertible ->
        refused path ending (unwords ["rsvg-convert -f", ending, "-o", path, svg path])
    | ending `elem` others -> refused path ending "with another program"
    | otherwise -> Right path
  where
    convertible = ["png", "pdf", "ps", "eps"]
    others = words "jpg jpeg gif webp bmp tif tiff ico svgz html htm json csv txt tex dxf"
    refused path ending way =
      Left (path <> " says " <> map toUpper ending <> ", figures are SVG; give " <> svg path <> " and convert it: "
        <> way)
    svg path = replaceExtension path "svg"
