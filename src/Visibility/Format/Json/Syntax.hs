{-# LANGUAGE OverloadedStrings #-}

-- | JSON text as a tree that loses nothing.
--
-- A reader of our own, because aeson's (2.0.3) loses what the contract of scenes promises to report: an exponent beyond
-- 64 bits wraps around (@1e18446744073709551617@ is read as 10), of two equal keys one disappears, a control character
-- passes in a string that also has an escape, and nesting is bounded by memory only. Here numbers stay as they are
-- spelled, keys stay in order with their duplicates, depth is bounded, and a fault has its line and column.
module Visibility.Format.Json.Syntax
  ( Document (..)
  , parseDocument
  , deepest
  ) where

import Data.ByteString (ByteString)
import Data.Char (chr, digitToInt, isDigit, isHexDigit)
import Data.Text (Text)
import qualified Data.Text as Text
import Visibility.Error (Expected (..), SyntaxFault (..), TextPosition (..))
import Visibility.Format.Utf8

-- | A JSON value. A number is its text; members are in the order of the file, duplicates included.
data Document
  = Null
  | Boolean !Bool
  | Number !Text
  | String !Text
  | List ![Document]
  | Object ![(Text, Document)]
  deriving (Eq, Show)

-- | At most this many brackets may be open at once.
deepest :: Int
deepest = 64

-- | One JSON value with white space around it and nothing else, in UTF-8.
--
-- /Degenerate cases/ the first fault is reported, nothing is repaired or passed over.
--
-- /Cost/ O(n) in bytes. The stack grows with 'deepest' only.
parseDocument :: ByteString -> Either (TextPosition, SyntaxFault) Document
parseDocument bytes = case decoded bytes of
  Left position -> Left (position, InvalidUtf8)
  Right text -> case value deepest (skip text) of
    Left failure -> Left (located text failure)
    Right (document, rest)
      | Text.null (skip rest) -> Right document
      | otherwise -> Left (located text (unexpected TheEnd (skip rest)))

-- The text from the fault on, and the fault.
data Failure = Failure !Text !SyntaxFault

type Step a = Either Failure (a, Text)

located :: Text -> Failure -> (TextPosition, SyntaxFault)
located text (Failure rest fault) = (endOf (Text.dropEnd (Text.length rest) text), fault)

-- The position just behind a text.
endOf :: Text -> TextPosition
endOf before = TextPosition (1 + Text.count "\n" before) (1 + Text.length (Text.takeWhileEnd (/= '\n') before))

unexpected :: Expected -> Text -> Failure
unexpected expected rest = Failure rest (Unexpected (fst <$> Text.uncons rest) expected)

skip :: Text -> Text
skip = Text.dropWhile (\c -> c == ' ' || c == '\n' || c == '\r' || c == '\t')

-- A value, at whose first character the text stands; so many brackets may yet be opened.
value :: Int -> Text -> Step Document
value depth input = case Text.uncons input of
  Just ('{', rest)
    | depth <= 0 -> Left (Failure input (TooDeep deepest))
    | otherwise -> object depth (skip rest)
  Just ('[', rest)
    | depth <= 0 -> Left (Failure input (TooDeep deepest))
    | otherwise -> list depth (skip rest)
  Just ('"', rest) -> do
    (text, rest') <- string [] rest
    Right (String text, rest')
  Just (c, _)
    | c == '-' || isDigit c -> number input
    | Just rest <- Text.stripPrefix "true" input -> Right (Boolean True, rest)
    | Just rest <- Text.stripPrefix "false" input -> Right (Boolean False, rest)
    | Just rest <- Text.stripPrefix "null" input -> Right (Null, rest)
  _ -> Left (unexpected AValue input)

list :: Int -> Text -> Step Document
list depth input = case Text.uncons input of
  Just (']', rest) -> Right (List [], rest)
  _ -> items [] input
  where
    items done text = do
      (item, after) <- value (depth - 1) text
      let rest = skip after
      case Text.uncons rest of
        Just (',', more) -> items (item : done) (skip more)
        Just (']', more) -> Right (List (reverse (item : done)), more)
        _ -> Left (unexpected CommaOrClosingBracket rest)

object :: Int -> Text -> Step Document
object depth input = case Text.uncons input of
  Just ('}', rest) -> Right (Object [], rest)
  Just ('"', _) -> members [] input
  _ -> Left (unexpected AKeyOrClosingBrace input)
  where
    members done text = do
      (key, afterKey) <- case Text.uncons text of
        Just ('"', rest) -> string [] rest
        _ -> Left (unexpected AKey text)
      inner <- case Text.uncons (skip afterKey) of
        Just (':', rest) -> Right (skip rest)
        _ -> Left (unexpected AColon (skip afterKey))
      (member, after) <- value (depth - 1) inner
      let rest = skip after
      case Text.uncons rest of
        Just (',', more) -> members ((key, member) : done) (skip more)
        Just ('}', more) -> Right (Object (reverse ((key, member) : done)), more)
        _ -> Left (unexpected CommaOrClosingBrace rest)

number :: Text -> Step Document
number input = do
  let (sign, afterSign) = Text.splitAt (if "-" `Text.isPrefixOf` input then 1 else 0) input
  (whole, afterWhole) <- naturalPart afterSign
  (part, afterPart) <- case Text.uncons afterWhole of
    Just ('.', rest) -> do
      (found, rest') <- digits rest
      Right (Text.cons '.' found, rest')
    _ -> Right ("", afterWhole)
  (power, rest) <- case Text.uncons afterPart of
    Just (e, rest) | e == 'e' || e == 'E' -> do
      let (plus, unsigned) = case Text.uncons rest of
            Just (c, rest') | c == '+' || c == '-' -> (Text.singleton c, rest')
            _ -> ("", rest)
      (found, rest') <- digits unsigned
      Right (Text.cons e (plus <> found), rest')
    _ -> Right ("", afterPart)
  Right (Number (Text.concat [sign, whole, part, power]), rest)
  where
    naturalPart text = do
      (found, rest) <- digits text
      if Text.compareLength found 1 == GT && "0" `Text.isPrefixOf` found
        then Left (unexpected NoDigit (Text.drop 1 text))
        else Right (found, rest)
    digits text = case Text.span isDigit text of
      (found, rest)
        | Text.null found -> Left (unexpected ADigit text)
        | otherwise -> Right (found, rest)

-- The rest of a string behind its opening quote.
string :: [Text] -> Text -> Step Text
string done input = case Text.uncons rest of
  Nothing -> Left (unexpected ClosingQuote rest)
  Just ('"', more) -> Right (Text.concat (reverse (plain : done)), more)
  Just ('\\', more) -> do
    (c, more') <- escape more
    string (Text.singleton c : plain : done) more'
  Just (c, _) -> Left (Failure rest (ControlCharacter c))
  where
    (plain, rest) = Text.span (\c -> c /= '"' && c /= '\\' && c >= ' ') input

escape :: Text -> Step Char
escape input = case Text.uncons input of
  Just ('u', rest) -> unicode input rest
  Just (c, rest) | Just meant <- lookup c short -> Right (meant, rest)
  _ -> Left (unexpected AnEscape input)
  where
    short = zip "\"\\/bfnrt" "\"\\/\b\f\n\r\t"

-- A code unit, or two that make a character beyond U+FFFF.
unicode :: Text -> Text -> Step Char
unicode start input = do
  (unit, rest) <- codeUnit input
  case () of
    _ | isHigh unit, Just more <- Text.stripPrefix "\\u" rest -> do
          (unit', rest') <- codeUnit more
          if isLow unit'
            then Right (chr (0x10000 + (unit - 0xD800) * 0x400 + (unit' - 0xDC00)), rest')
            else Left (Failure start UnpairedSurrogate)
      | isHigh unit || isLow unit -> Left (Failure start UnpairedSurrogate)
      | otherwise -> Right (chr unit, rest)
  where
    isHigh u = u >= 0xD800 && u < 0xDC00
    isLow u = u >= 0xDC00 && u < 0xE000
    codeUnit text
      | Text.length found == 4 = Right (Text.foldl' (\acc c -> 16 * acc + digitToInt c) 0 found, Text.drop 4 text)
      | otherwise = Left (unexpected AHexDigit (Text.drop (Text.length found) text))
      where
        found = Text.takeWhile isHexDigit (Text.take 4 text)
