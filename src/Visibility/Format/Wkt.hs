{-# LANGUAGE OverloadedStrings #-}

-- | Scenes as well-known text (OGC 06-103r4, 7.2), a geometry to a line.
module Visibility.Format.Wkt
  ( readWkt
  ) where

import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Chars
import Data.Char (isAlpha, isDigit)
import Data.Foldable (traverse_)
import Data.List.NonEmpty (NonEmpty)
import Data.Maybe (isNothing)
import Data.Text (Text)
import qualified Data.Text as Text
import Visibility.Error
import Visibility.Exact.Point (Point (..))
import Visibility.Format.Checked
import Visibility.Format.Number
import Visibility.Format.Utf8
import Visibility.Scene.Raw

-- | What the text of a file says of a scene; the path is only what the file is called in problems. Polygons are those
-- of POLYGON and MULTIPOLYGON, thin walls those of LINESTRING and MULTILINESTRING, in the order of the file. WKT has
-- no words for names, materials and the enclosure.
--
-- Numbers are exact: decimals with or without an exponent, as WKT spells them, and fractions @p/q@.
--
-- /Degenerate cases/ keywords are read in capitals or not. Empty lines, lines that begin with @#@, what is @EMPTY@, and
-- z and m of positions are passed over. Other geometry, holes and rings that do not close are faults. In each line the
-- first fault of syntax is reported, or every fault of numbers and rings; lines that go on with a geometry that ended
-- too early are passed over.
--
-- /Cost/ O(n) in bytes, but for the size of the numbers.
readWkt :: FilePath -> ByteString -> Either (NonEmpty Problem) RawScene
readWkt file bytes = outcome file $ case invalidByte bytes of
  Just place -> fault (SyntaxError place InvalidUtf8)
  Nothing -> RawScene Nothing Nothing <$> geometries (zip [1 ..] (map line (Chars.lines bytes)))
  where
    line = Text.dropWhileEnd isBlank . decoded

-- | The polygons of lines without blanks at their ends, by their numbers.
geometries :: [(Int, Text)] -> Checked [RawPolygon]
geometries numbered = case numbered of
  [] -> Good []
  (n, line) : rest
    | isPassedOver line -> geometries rest
    | otherwise -> case geometry (tokens line) of
        Left (Stop place expected) ->
          fault (SyntaxError (at n line place) (UnexpectedWord (tokenText <$> place) expected))
            *> geometries (if isNothing place then dropWhile (goesOn . snd) rest else rest)
        Right found -> (<>) <$> found n <*> geometries rest
  where
    at n text = TextPosition n . maybe (Text.length text + 1) tokenColumn
    isPassedOver = all (Text.isPrefixOf "#") . beginning
    -- All geometry begins with a letter.
    goesOn = not . any (Text.any isAlpha . Text.take 1) . beginning
    beginning = map tokenText . take 1 . tokens

-- Words -----------------------------------------------------------------------------------------------------------

-- | A bracket, a comma, or a word of other characters; with the column that it begins in.
data Token = Token {tokenColumn :: !Int, tokenText :: !Text}

tokens :: Text -> [Token]
tokens = go 1
  where
    go column text = case Text.uncons text of
      Nothing -> []
      Just (c, rest)
        | isBlank c -> go (column + 1) rest
        | isMark c -> Token column (Text.singleton c) : go (column + 1) rest
        | otherwise ->
            let (word, more) = Text.break (\x -> isBlank x || isMark x) text
             in Token column word : go (column + Text.length word) more

isBlank, isMark :: Char -> Bool
isBlank c = c == ' ' || c == '\t' || c == '\r'
isMark c = c == '(' || c == ')' || c == ','

-- Syntax ----------------------------------------------------------------------------------------------------------

-- | What has been found where something else was expected, nothing at the end of the line.
data Stop = Stop !(Maybe Token) !Expected

type Step a = [Token] -> Either Stop (a, [Token])

-- | What stands between brackets, nothing if it is EMPTY; with the column of the bracket or of the word.
data Group a = Group !Int ![a]

stop :: Expected -> [Token] -> Either Stop a
stop expected rest = Left (Stop (case rest of token : _ -> Just token; [] -> Nothing) expected)

-- The polygons of a line with this number.
geometry :: [Token] -> Either Stop (Int -> Checked [RawPolygon])
geometry input = case input of
  Token _ word : rest -> case Text.toUpper word of
    "POLYGON" -> whole polygons (group (group position)) rest
    "MULTIPOLYGON" -> whole (each polygons) (group (group (group position))) rest
    "LINESTRING" -> whole walls (group position) rest
    "MULTILINESTRING" -> whole (each walls) (group (group position)) rest
    _ -> noGeometry
  [] -> noGeometry
  where
    noGeometry = stop (Expected "POLYGON, MULTIPOLYGON, LINESTRING or MULTILINESTRING belongs here") input
    whole meaning body rest = do
      (found, end) <- body (withoutDimension rest)
      if null end
        then Right (`meaning` found)
        else stop (Expected "nothing may follow the geometry, give each a line of its own") end
    each meaning n (Group _ parts) = concat <$> traverse (meaning n) parts
    withoutDimension rest = case rest of
      Token _ word : more | Text.toUpper word `elem` ["Z", "M", "ZM"] -> more
      _ -> rest

group :: Step a -> Step (Group a)
group item input = case input of
  Token column "(" : rest -> items column [] rest
  Token column word : rest | Text.toUpper word == "EMPTY" -> Right (Group column [], rest)
  _ -> stop (Expected "( or EMPTY belongs here") input
  where
    items column done rest = do
      (found, after) <- item rest
      case after of
        Token _ "," : more -> items column (found : done) more
        Token _ ")" : more -> Right (Group column (reverse (found : done)), more)
        _ -> stop (Expected ", or ) belongs here, and all of a geometry on one line") after

-- | The spellings of x and y.
position :: Step (Token, Token)
position input = do
  (x, afterX) <- spelled input
  (y, afterY) <- spelled afterX
  Right ((x, y), beyond 2 afterY)
  where
    spelled (token : rest) | isWord token = Right (token, rest)
    spelled rest = stop (Expected "a number belongs here, two for each position") rest
    -- At most so many more numbers, of no meaning in the plane.
    beyond :: Int -> [Token] -> [Token]
    beyond n (token : rest) | n > 0, isWord token = beyond (n - 1) rest
    beyond _ rest = rest
    isWord = not . Text.any isMark . tokenText

-- Meaning ---------------------------------------------------------------------------------------------------------

-- In the line with the number.
polygons :: Int -> Group (Group (Token, Token)) -> Checked [RawPolygon]
polygons n (Group _ rings) = case rings of
  [] -> Good []
  outer : holes -> (: []) <$> (outline ringPolygon n outer <* traverse_ hole holes)
  where
    hole (Group column _) = fault (SyntaxError (TextPosition n column) (BadGeometry Hole))

walls :: Int -> Group (Token, Token) -> Checked [RawPolygon]
walls n line = case line of
  Group _ [] -> Good []
  _ -> (: []) <$> outline lineWall n line

outline :: ([Point] -> Either OutlineFault RawPolygon) -> Int -> Group (Token, Token) -> Checked RawPolygon
outline made n (Group column positions) = eachOf (const point) positions `andThen` (either wrong Good . made)
  where
    wrong = fault . SyntaxError (TextPosition n column) . BadGeometry
    point (x, y) = Point <$> number x <*> number y
    number (Token k word) = either (fault . SyntaxError (TextPosition n k) . BadWord word) Good (readWktNumber word)

-- WKT, unlike JSON, allows a plus sign, and a point without digits on one side.
readWktNumber :: Text -> Either NumberFault Rational
readWktNumber word = case Text.uncons word of
  Just ('-', rest) -> negate <$> readUnsigned rest
  Just ('+', rest) -> readUnsigned rest
  _ -> readUnsigned word
  where
    readUnsigned text
      | "-" `Text.isPrefixOf` text = Left NotANumber
      | otherwise = readNumber (filled text)
    filled text = case Text.span isDigit text of
      (whole, rest)
        | Just more <- Text.stripPrefix "." rest
        , (part, power) <- Text.span isDigit more
        , not (Text.null whole && Text.null part) ->
            orZero whole <> "." <> orZero part <> power
      _ -> text
    orZero digits = if Text.null digits then "0" else digits
