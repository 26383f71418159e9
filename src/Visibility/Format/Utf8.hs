-- | Text of files, which is UTF-8.
module Visibility.Format.Utf8
  ( decoded
  ) where

import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Chars
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Visibility.Error (TextPosition (..))

-- | The text, or the position of the first byte that is not UTF-8.
decoded :: ByteString -> Either TextPosition Text
decoded bytes = either (const (Left (invalidByte bytes))) Right (Text.decodeUtf8' bytes)

-- The position of the first byte that is not UTF-8. No character extends over the end of a line, so lines are tried one
-- by one; in a bad one, NUL stands for what cannot be decoded. (A NUL that was there before is as wrong.)
invalidByte :: ByteString -> TextPosition
invalidByte bytes = case [(n, line) | (n, line) <- zip [1 ..] (Chars.split '\n' bytes), isBad line] of
  (n, line) : _ ->
    TextPosition n (1 + Text.length (Text.takeWhile (/= '\0') (Text.decodeUtf8With (\_ _ -> Just '\0') line)))
  [] -> TextPosition 1 (1 + Bytes.length bytes)
  where
    isBad = either (const True) (const False) . Text.decodeUtf8'
