-- | Text of files, which is UTF-8.
module Visibility.Format.Utf8
  ( invalidByte
  , decoded
  , charAt
  ) where

import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Chars
import Data.ByteString.Internal (w2c)
import Data.ByteString.Unsafe (unsafeIndex)
import Data.Maybe (listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Text.Encoding.Error as Text
import Visibility.Error (TextPosition (..))

-- | The position of the first byte that is not UTF-8, if there is one.
--
-- No character extends over the end of a line, so lines are tried one by one; in a bad one, NUL stands for what cannot
-- be decoded. (A NUL that was there before is as wrong.)
--
-- /Cost/ O(n), and memory for one line.
invalidByte :: ByteString -> Maybe TextPosition
invalidByte bytes
  | Bytes.all (< 0x80) bytes = Nothing
  | otherwise = listToMaybe [place n line | (n, line) <- zip [1 ..] (Chars.split '\n' bytes), isBad line]
  where
    place n line =
      TextPosition n (1 + Text.length (Text.takeWhile (/= '\0') (Text.decodeUtf8With (\_ _ -> Just '\0') line)))
    isBad = either (const True) (const False) . Text.decodeUtf8'

-- | The text of bytes.
--
-- /Degenerate cases/ U+FFFD stands for each byte that is not UTF-8, of which 'invalidByte' finds the first.
decoded :: ByteString -> Text
decoded = Text.decodeUtf8With Text.lenientDecode

-- | The byte at a place from 0 on, as a character; NUL behind the end. (The bytes of ASCII stand for nothing else in
-- UTF-8.)
--
-- /Requires/ a place that is not negative.
charAt :: ByteString -> Int -> Char
charAt bytes i = if i < Bytes.length bytes then w2c (unsafeIndex bytes i) else '\0'
{-# INLINE charAt #-}
