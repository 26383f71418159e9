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

import Control.Monad (unless)
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Chars
import Data.Char (chr, digitToInt, isDigit, isHexDigit)
import Data.Text (Text)
import qualified Data.Text as Text
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

-- | At most this many brackets may be open at once.
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
  Nothing -> first (first (positionOf bytes)) $ do
    end <- skip bytes <$> valueEnd bytes 0 start
    unless (isEnd bytes end) $ unexpected (Expected "nothing may follow the scene") bytes end
    pure (Document bytes start)
  where
    start = skip bytes 0

-- | The place behind a piece of the text; or the place of the first fault in it, and the fault.
type End = Either (Int, SyntaxFault) Int

-- The position of a byte.
positionOf :: ByteString -> Int -> TextPosition
positionOf bytes place = TextPosition (1 + Chars.count '\n' before) (1 + Text.length (decoded line))
  where
    before = Bytes.take place bytes
    line = Chars.takeWhileEnd (/= '\n') before

unexpected :: Expected -> ByteString -> Int -> Either (Int, SyntaxFault) a
unexpected expected bytes i = Left (i, Unexpected found expected)
  where
    -- No character is longer.
    found = fst <$> Text.uncons (decoded (slice bytes i (i + 4)))

-- Behind a value, of which the first character is given, and how many brackets are open around it.
valueEnd :: ByteString -> Int -> Int -> End
valueEnd bytes !open !i = case charAt bytes i of
  c | c == '{' || c == '[', open >= deepest -> Left (i, TooDeep deepest)
  '{' -> case charAt bytes inner of
    '}' -> Right (inner + 1)
    '"' -> membersEnd inner
    _ -> unexpected (Expected "a key in double quotes or } belongs here") bytes inner
  '[' -> if charAt bytes inner == ']' then Right (inner + 1) else itemsEnd inner
  '"' -> stringEnd bytes (i + 1)
  't' | "true" `Bytes.isPrefixOf` Bytes.drop i bytes -> Right (i + 4)
  'f' | "false" `Bytes.isPrefixOf` Bytes.drop i bytes -> Right (i + 5)
  'n' | "null" `Bytes.isPrefixOf` Bytes.drop i bytes -> Right (i + 4)
  c | c == '-' || isDigit c -> numberEnd bytes i
  _ -> unexpected (Expected "a value belongs here") bytes i
  where
    inner = skip bytes (i + 1)
    -- From the first character of an item, or of a key, on.
    itemsEnd !k = do
      end <- skip bytes <$> valueEnd bytes (open + 1) k
      case charAt bytes end of
        ',' -> itemsEnd (skip bytes (end + 1))
        ']' -> Right (end + 1)
        _ -> unexpected (Expected ", or ] belongs here") bytes end
    membersEnd !k = do
      unless (charAt bytes k == '"') $ unexpected (Expected "a key in double quotes belongs here") bytes k
      colon <- skip bytes <$> stringEnd bytes (k + 1)
      unless (charAt bytes colon == ':') $ unexpected (Expected ": belongs here") bytes colon
      end <- skip bytes <$> valueEnd bytes (open + 1) (skip bytes (colon + 1))
      case charAt bytes end of
        ',' -> membersEnd (skip bytes (end + 1))
        '}' -> Right (end + 1)
        _ -> unexpected (Expected ", or } belongs here") bytes end

-- Behind a number, whose first character is given.
numberEnd :: ByteString -> Int -> End
numberEnd bytes i = do
  end <- digits whole
  behind <- case charAt bytes whole of
    '0' | end > whole + 1 -> unexpected (Expected "leave out the zero that the number begins with") bytes (whole + 1)
    _ -> if charAt bytes end == '.' then digits (end + 1) else Right end
  case charAt bytes behind of
    c | c == 'e' || c == 'E' -> digits (if isSign (charAt bytes (behind + 1)) then behind + 2 else behind + 1)
    _ -> Right behind
  where
    whole = if charAt bytes i == '-' then i + 1 else i
    digits k
      | digitsEnd k == k = unexpected (Expected "a digit belongs here") bytes k
      | otherwise = Right (digitsEnd k)
    digitsEnd k = if isDigit (charAt bytes k) then digitsEnd (k + 1) else k
    isSign c = c == '+' || c == '-'

-- Behind a string, of which the place behind its opening quote is given.
stringEnd :: ByteString -> Int -> End
stringEnd bytes i = case charAt bytes i of
  '"' -> Right (i + 1)
  '\\' -> escaped bytes (i + 1) >>= stringEnd bytes . snd
  c | c >= ' ' -> stringEnd bytes (i + 1)
    | isEnd bytes i -> unexpected (Expected "a closing \" belongs here") bytes i
    | otherwise -> Left (i, ControlCharacter c)

-- What an escape means, of which the place behind the backslash is given; and the place behind it. Two code units may
-- make one character beyond U+FFFF; U+FFFD stands for half of such a pair, which is no character.
escaped :: ByteString -> Int -> Either (Int, SyntaxFault) (Char, Int)
escaped bytes i = case charAt bytes i of
  'u' -> do
    unit <- codeUnit (i + 1)
    Right $ case codeUnit (i + 7) of
      Right unit'
        | isHigh unit, isLow unit', slice bytes (i + 5) (i + 7) == "\\u" ->
            (chr (0x10000 + (unit - 0xD800) * 0x400 + (unit' - 0xDC00)), i + 11)
      _ -> (if isHigh unit || isLow unit then '\xFFFD' else chr unit, i + 5)
  c | Just meant <- lookup c short -> Right (meant, i + 1)
  _ -> unexpected (Expected "one of \" \\ / b f n r t u belongs here") bytes i
  where
    short = zip "\"\\/bfnrt" "\"\\/\b\f\n\r\t"
    isHigh u = u >= 0xD800 && u < 0xDC00
    isLow u = u >= 0xDC00 && u < 0xE000
    codeUnit from
      | Chars.length found == 4 = Right (Chars.foldl' (\acc c -> 16 * acc + digitToInt c) 0 found)
      | otherwise = unexpected (Expected "four hexadecimal digits belong here") bytes (from + Chars.length found)
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
  '"' -> String (stringText (slice bytes (i + 1) (checked (stringEnd bytes (i + 1)) - 1)))
  't' -> Boolean True
  'f' -> Boolean False
  'n' -> Null
  _ -> Number (slice bytes i (checked (numberEnd bytes i)))

-- In text that has been checked there is no fault.
checked :: End -> Int
checked = either fst id

-- The items from the one that begins here, or from the closing bracket.
items :: ByteString -> Int -> [Document]
items bytes !i
  | isEnd bytes i || charAt bytes i == ']' = []
  | otherwise = Document bytes i : items bytes (following bytes i)

-- The members from the one whose key begins here, or from the closing brace.
members :: ByteString -> Int -> [(Text, Document)]
members bytes !i
  | isEnd bytes i || charAt bytes i == '}' = []
  | otherwise = (key, Document bytes inner) : members bytes (following bytes inner)
  where
    key = stringText (slice bytes (i + 1) (end - 1))
    end = checked (stringEnd bytes (i + 1))
    !inner = skip bytes (skip bytes end + 1)

-- What follows behind the value that begins here: the next, or a closing bracket.
following :: ByteString -> Int -> Int
following bytes i = if charAt bytes next == ',' then skip bytes (next + 1) else next
  where
    next = skip bytes (checked (valueEnd bytes 0 i))

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
