module Visibility.Format.Utf8Spec (spec) where

import qualified Data.ByteString as Bytes
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Visibility.Error (TextPosition (..))
import Visibility.Format.Utf8

spec :: Spec
spec = describe "invalidByte" $ do
  prop "finds nothing in text, which is decoded" $ \string ->
    let text = Text.pack (filter (\c -> c < '\xD800' || c > '\xDFFF') string)
        bytes = Text.encodeUtf8 text
     in (invalidByte bytes, decoded bytes) === (Nothing, text)
  prop "finds the first byte that is none, by the lines and characters before it" $
    forAll (listOf (elements "a\233\8364\119070\n")) $ \front ->
      forAll (elements [[0xff], [0x80], [0xc3], [0xe2, 0x82], [0xc0, 0x80], [0xed, 0xa0, 0x80]]) $ \wrong ->
        forAll (listOf (elements "a\n\255")) $ \behind ->
          let encoded = Text.encodeUtf8 . Text.pack
              line = takeWhile (/= '\n') (reverse front)
           in invalidByte (encoded front <> Bytes.pack wrong <> encoded ('\n' : behind))
                === Just (TextPosition (1 + length (filter (== '\n') front)) (1 + length line))
