{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE OverloadedStrings #-}

-- | JSON text, looked at in place: nothing is lost, and nothing is built but what is looked at.
--
-- A reader of our own, because aeson's (2.0.3) loses what the contract of scenes promises to report: an exponent beyond
-- 64 bits wraps around (@1e18446744073709551617@ is read as 10), of two equal keys one disappears, a control character
-- passes in a string that also has an escape, and nesting is bounded by memory only. Here numbers stay as they are
-- spelled, keys stay in order with their duplicates, depth is bounded, and a fault has its line and column.
--
-- The text is checked once from end to end. From then on a value is the place in the text that it begins at: brackets
-- and quotes tell where it ends. So a document takes no memory beside its text, and a list is passed over in the time
-- that its text takes; a walk through all of a document reads each byte about once for every bracket around it, which
-- are no more than 'deepest'. Read into a tree instead, 3 000 quadrilaterals take 1.24 times the memory in @info@, and
-- 30 000 take 1.37 times in @graph@.
module Visibility.Format.Json.Syntax
  ( Document
  , parseDocument
  , deepest
    -- * Looking
  , Value (..)
  , value
  ) where

import Data.Bits (setBit, shiftL, shiftR, testBit)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Chars
import Data.Char (chr, digitToInt, isDigit, isHexDigit)
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Word (Word64)
import Visibility.Error (Expected (..), SyntaxFault (..), TextPosition (..))
import Visibility.Format.Utf8

-- | A JSON value: text that has been checked, and the place of the value's first byte.
data Document = Document !ByteString !Int

-- | What a value is, one level deep. Members are in the order of the file, duplicates included.
data Value
  = Null
  | Boolean !Bool
  | -- | As it is spelled.
    Number !ByteString
  | String Text
  | List [Document]
  | Object [(Text, Document)]

-- | At most this many brackets may be open at once: a bit of a machine word for each.
deepest :: Int
deepest = 64

-- Places in the text ----------------------------------------------------------------------------------------------

-- Places count bytes, as all that has a meaning in JSON is ASCII.
isEnd :: ByteString -> Int -> Bool
isEnd bytes i = i >= Bytes.length bytes

-- The place behind white space.
skip :: ByteString -> Int -> Int
skip bytes i = case charAt bytes i of
  ' ' -> skip bytes (i + 1)
  '\n' -> skip bytes (i + 1)
  '\r' -> skip bytes (i + 1)
  '\t' -> skip bytes (i + 1)
  _ -> i

slice :: ByteString -> Int -> Int -> ByteString
slice bytes from to = Bytes.take (to - from) (Bytes.drop from bytes)

-- Checking --------------------------------------------------------------------------------------------------------

-- | One JSON value with white space around it and nothing else, in UTF-8.
--
-- /Degenerate cases/ the first fault is reported, nothing is repaired or passed over.
--
-- /Cost/ O(n) in bytes, in constant memory beside them.
parseDocument :: ByteString -> Either (TextPosition, SyntaxFault) Document
parseDocument bytes = case invalidByte bytes of
  Just position -> Left (position, InvalidUtf8)
  Nothing -> case firstFailure bytes of
    Just (Failure place fault) -> Left (positionOf bytes place, fault)
    Nothing -> Right (Document bytes (skip bytes 0))

-- | The place of a fault, and the fault.
data Failure = Failure !Int !SyntaxFault

-- The position of a byte.
positionOf :: ByteString -> Int -> TextPosition
positionOf bytes place = TextPosition (1 + Chars.count '\n' before) (1 + Text.length (decoded line))
  where
    before = Bytes.take place bytes
    line = Chars.takeWhileEnd (/= '\n') before

unexpected :: Expected -> ByteString -> Int -> Failure
unexpected expected bytes i = Failure i (Unexpected found expected)
  where
    -- No character is longer.
    found = fst <$> Text.uncons (decoded (slice bytes i (i + 4)))

-- The first fault of syntax. A loop over the bytes: of the brackets open, it keeps the number and the kinds.
firstFailure :: ByteString -> Maybe Failure
firstFailure bytes = anyValue 0 0 (skip bytes 0)
  where
    -- At the first character of a value.
    anyValue :: Int -> Word64 -> Int -> Maybe Failure
    anyValue !open !kinds !i = case charAt bytes i of
      '{'
        | open >= deepest -> tooDeep i
        | otherwise -> case charAt bytes inner of
            '}' -> behind open kinds (inner + 1)
            '"' -> member (open + 1) (setBit (shiftL kinds 1) 0) inner
            _ -> failed AKeyOrClosingBrace inner
      '['
        | open >= deepest -> tooDeep i
        | otherwise -> case charAt bytes inner of
            ']' -> behind open kinds (inner + 1)
            _ -> anyValue (open + 1) (shiftL kinds 1) inner
      '"' -> stringEnd bytes (i + 1) `thenAt` behind open kinds
      't' | "true" `Bytes.isPrefixOf` Bytes.drop i bytes -> behind open kinds (i + 4)
      'f' | "false" `Bytes.isPrefixOf` Bytes.drop i bytes -> behind open kinds (i + 5)
      'n' | "null" `Bytes.isPrefixOf` Bytes.drop i bytes -> behind open kinds (i + 4)
      c | c == '-' || isDigit c -> numberEnd bytes i `thenAt` behind open kinds
      _ -> failed AValue i
      where
        inner = skip bytes (i + 1)
    -- Behind a value.
    behind :: Int -> Word64 -> Int -> Maybe Failure
    behind !open !kinds !i
      | open == 0 = if isEnd bytes next then Nothing else failed TheEnd next
      | testBit kinds 0 = case charAt bytes next of
          ',' -> member open kinds (skip bytes (next + 1))
          '}' -> behind (open - 1) (shiftR kinds 1) (next + 1)
          _ -> failed CommaOrClosingBrace next
      | otherwise = case charAt bytes next of
          ',' -> anyValue open kinds (skip bytes (next + 1))
          ']' -> behind (open - 1) (shiftR kinds 1) (next + 1)
          _ -> failed CommaOrClosingBracket next
      where
        next = skip bytes i
    -- At the first character of a key.
    member !open !kinds !i = case charAt bytes i of
      '"' -> stringEnd bytes (i + 1) `thenAt` \end ->
        let colon = skip bytes end
         in case charAt bytes colon of
              ':' -> anyValue open kinds (skip bytes (colon + 1))
              _ -> failed AColon colon
      _ -> failed AKey i
    thenAt (Ended end) next = next end
    thenAt (Failed failure) _ = Just failure
    failed expected i = Just (unexpected expected bytes i)
    tooDeep i = Just (Failure i (TooDeep deepest))

-- | The place behind a piece of the text, or why there is none.
data End = Ended !Int | Failed !Failure

-- Behind a number, whose first character is given.
numberEnd :: ByteString -> Int -> End
numberEnd bytes i
  | end == whole = Failed (unexpected ADigit bytes whole)
  | charAt bytes whole == '0', end > whole + 1 = Failed (unexpected NoDigit bytes (whole + 1))
  | charAt bytes end == '.' = digits (end + 1) power
  | otherwise = power end
  where
    whole = if charAt bytes i == '-' then i + 1 else i
    end = digitsEnd whole
    power k = case charAt bytes k of
      c | c == 'e' || c == 'E' -> digits (if isSign (charAt bytes (k + 1)) then k + 2 else k + 1) Ended
      _ -> Ended k
    digits k next
      | digitsEnd k == k = Failed (unexpected ADigit bytes k)
      | otherwise = next (digitsEnd k)
    digitsEnd k = if isDigit (charAt bytes k) then digitsEnd (k + 1) else k
    isSign c = c == '+' || c == '-'

-- Behind a string, of which the place behind its opening quote is given.
stringEnd :: ByteString -> Int -> End
stringEnd bytes i = case charAt bytes i of
  '"' -> Ended (i + 1)
  '\\' -> either Failed (stringEnd bytes . snd) (escaped bytes (i + 1))
  c | c >= ' ' -> stringEnd bytes (i + 1)
    | isEnd bytes i -> Failed (unexpected ClosingQuote bytes i)
    | otherwise -> Failed (Failure i (ControlCharacter c))

-- What an escape means, of which the place behind the backslash is given; and the place behind it. Two code units may
-- make one character beyond U+FFFF; U+FFFD stands for half of such a pair, which is no character.
escaped :: ByteString -> Int -> Either Failure (Char, Int)
escaped bytes i = case charAt bytes i of
  'u' -> do
    unit <- codeUnit (i + 1)
    Right $ case codeUnit (i + 7) of
      Right unit'
        | isHigh unit, isLow unit', slice bytes (i + 5) (i + 7) == "\\u" ->
            (chr (0x10000 + (unit - 0xD800) * 0x400 + (unit' - 0xDC00)), i + 11)
      _ -> (if isHigh unit || isLow unit then '\xFFFD' else chr unit, i + 5)
  c | Just meant <- lookup c short -> Right (meant, i + 1)
  _ -> Left (unexpected AnEscape bytes i)
  where
    short = zip "\"\\/bfnrt" "\"\\/\b\f\n\r\t"
    isHigh u = u >= 0xD800 && u < 0xDC00
    isLow u = u >= 0xDC00 && u < 0xE000
    codeUnit from
      | Chars.length found == 4 = Right (Chars.foldl' (\acc c -> 16 * acc + digitToInt c) 0 found)
      | otherwise = Left (unexpected AHexDigit bytes (from + Chars.length found))
      where
        found = Chars.takeWhile isHexDigit (slice bytes from (from + 4))

-- Looking ---------------------------------------------------------------------------------------------------------

-- | What a value is. Items, members and strings are read when they are looked at, each time anew.
--
-- /Cost/ O(1), then O(n) in the bytes of the items or members that are passed over.
value :: Document -> Value
value (Document bytes i) = case charAt bytes i of
  '{' -> Object (members bytes (skip bytes (i + 1)))
  '[' -> List (items bytes (skip bytes (i + 1)))
  '"' -> String (stringText (slice bytes (i + 1) (behindString bytes (i + 1) - 1)))
  't' -> Boolean True
  'f' -> Boolean False
  'n' -> Null
  _ -> Number (slice bytes i (behindWord bytes i))

-- The items from the one that begins here, or from the closing bracket.
items :: ByteString -> Int -> [Document]
items bytes !i
  | isEnd bytes i || charAt bytes i == ']' = []
  | otherwise = Document bytes i : items bytes (following bytes (behindValue bytes i))

-- The members from the one whose key begins here, or from the closing brace.
members :: ByteString -> Int -> [(Text, Document)]
members bytes !i
  | isEnd bytes i || charAt bytes i == '}' = []
  | otherwise = (stringText (slice bytes (i + 1) (end - 1)), Document bytes inner) : members bytes after
  where
    end = behindString bytes (i + 1)
    !inner = skip bytes (skip bytes end + 1)
    after = following bytes (behindValue bytes inner)

-- What follows behind a value: the next, or a closing bracket.
following :: ByteString -> Int -> Int
following bytes i = if charAt bytes next == ',' then skip bytes (next + 1) else next
  where
    next = skip bytes i

-- In text that has been checked.
behindValue, behindWord, behindString :: ByteString -> Int -> Int
behindValue bytes start = go (0 :: Int) start
  where
    go !open !i
      | isEnd bytes i = i
      | otherwise = case charAt bytes i of
          '"' -> closed open (behindString bytes (i + 1))
          c | c == '[' || c == '{' -> go (open + 1) (i + 1)
            | c == ']' || c == '}' -> closed (open - 1) (i + 1)
            | open > 0 -> go open (i + 1)
            | otherwise -> behindWord bytes i
    closed open i = if open == 0 then i else go open i
behindWord bytes i
  | isEnd bytes i || isMark (charAt bytes i) = i
  | otherwise = behindWord bytes (i + 1)
  where
    isMark c = c == ',' || c == ']' || c == '}' || c == ' ' || c == '\n' || c == '\r' || c == '\t'
behindString bytes i
  | isEnd bytes i = i
  | otherwise = case charAt bytes i of
      '"' -> i + 1
      '\\' -> behindString bytes (i + 2)
      _ -> behindString bytes (i + 1)

-- What stands between quotes.
stringText :: ByteString -> Text
stringText spelled
  | Chars.notElem '\\' spelled = decoded spelled
  | otherwise = Text.concat (pieces 0)
  where
    pieces i = case Chars.elemIndex '\\' (Bytes.drop i spelled) of
      Nothing -> [decoded (Bytes.drop i spelled)]
      Just n -> decoded (slice spelled i (i + n)) : either (const []) meant (escaped spelled (i + n + 1))
    meant (c, next) = Text.singleton c : pieces next
