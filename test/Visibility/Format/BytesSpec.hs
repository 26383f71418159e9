module Visibility.Format.BytesSpec (spec) where

import qualified Data.ByteString.Char8 as Chars
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Visibility.Format.Utf8

spec :: Spec
spec = describe "charAt" $
  prop "reads the bytes of a text that is part of another, and NUL behind it" $ \front inner behind ->
    let bytes = Chars.pack inner
        whole = Chars.pack front <> bytes <> Chars.pack behind
        part = Chars.take (Chars.length bytes) (Chars.drop (length front) whole)
     in map (charAt part) [0 .. length inner + 2] === Chars.unpack bytes <> "\0\0\0"
