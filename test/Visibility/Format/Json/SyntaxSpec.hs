{-# LANGUAGE OverloadedStrings #-}

module Visibility.Format.Json.SyntaxSpec (spec) where

import qualified Data.Aeson as Aeson
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Chars
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck
import Visibility.Error
import Visibility.Format.Json.Syntax

spec :: Spec
spec = describe "parseDocument" $ do
  it "keeps numbers as spelled, and members in order with their duplicates" $
    parseDocument " {\"b\": [1.50e+2, -0, 1E400], \"a\": null, \"b\": true}\n"
      `shouldBe` Right
        (Object [("b", List [Number "1.50e+2", Number "-0", Number "1E400"]), ("a", Null), ("b", Boolean True)])
  it "reads escapes and characters beyond U+FFFF" $
    parseDocument "\"\\\"\\\\\\/\\b\\f\\n\\r\\t\\u00e9\\uD834\\uDD1E \195\169\""
      `shouldBe` Right (String "\"\\/\b\f\n\r\t\233\119070 \233")
  it "pairs the first and the last surrogates" $
    parseDocument "\"\\ud800\\udc00\\udbff\\udfff\"" `shouldBe` Right (String "\x10000\x10ffff")
  it "bounds the depth" $ do
    let nested n = Chars.replicate n '[' <> Chars.replicate n ']'
    parseDocument (nested deepest) `shouldSatisfy` either (const False) (const True)
    parseDocument (nested (deepest + 1)) `shouldBe` Left (TextPosition 1 (deepest + 1), TooDeep deepest)
    parseDocument (Chars.replicate 10000000 '[') `shouldBe` Left (TextPosition 1 (deepest + 1), TooDeep deepest)
    parseDocument (Bytes.concat (replicate 1000000 "{\"\":"))
      `shouldBe` Left (TextPosition 1 (4 * deepest + 1), TooDeep deepest)
  it "takes a list of many elements" $
    fmap size (parseDocument ("[" <> Bytes.intercalate "," (replicate 300000 "0") <> "]")) `shouldBe` Right 300000
  describe "counts lines and characters" $
    for_ positions $ \(text, line, column) ->
      it (show text) $ either (Right . fst) Left (parseDocument text) `shouldBe` Right (TextPosition line column)
  modifyMaxSuccess (* 20) $
    -- aeson 2.0.3 lets a control character pass in a string that also has an escape.
    prop "accepts what aeson accepts but for control characters in strings, and nothing else" $
      forAll (mutated `suchThat` (not . isControlled)) $ \bytes ->
        let isRight = either (const False) (const True)
            accepted = isRight (parseDocument bytes)
         in cover 20 accepted "accepted" $
              cover 20 (not accepted) "refused" $
                counterexample (show (parseDocument bytes)) $
                  accepted === isRight (Aeson.eitherDecodeStrict bytes :: Either String Aeson.Value)
  where
    isControlled bytes = case parseDocument bytes of
      Left (_, ControlCharacter _) -> True
      _ -> False
    size (List items) = length items
    size _ = 0

positions :: [(Bytes.ByteString, Int, Int)]
positions =
  [ ("", 1, 1)
  , ("\n\n  ]", 3, 3)
  , ("[1,\n2,\n]", 3, 1)
  , ("[\"\195\169\195\169\" 1]", 1, 7)
  , ("[\"\\u12\"]", 1, 7)
  , ("[\"ab\\x\"]", 1, 6)
  , ("[\"ab\\ud800\"]", 1, 6)
  , ("[01]", 1, 3)
  , ("[-]", 1, 3)
  , ("{\"a\" 1}", 1, 6)
  , ("{\"a\":1,}", 1, 8)
  , ("[tru]", 1, 2)
  , ("[1] 2", 1, 5)
  , ("[\n\"a\195\169\255\"]", 2, 4)
  , ("\239\187\191[]", 1, 1)
  ]

-- Short documents with up to three bytes changed, left out or put in.
mutated :: Gen Bytes.ByteString
mutated = do
  document <- frequency [(4, Lazy.toStrict . Aeson.encode <$> values 3), (1, elements samples)]
  times <- elements [0, 0, 1, 1, 2, 3 :: Int]
  go times document
  where
    go 0 bytes = pure bytes
    go n bytes = do
      k <- choose (0, Bytes.length bytes)
      let (front, back) = Bytes.splitAt k bytes
      new <- elements (Bytes.unpack "{}[]\",:0123456789.-+eE \n\t\\utrnx/" <> [0, 31, 127, 128, 195, 169, 255])
      let less = Bytes.drop 1 back
      changed <- elements [front <> Bytes.cons new back, front <> less, front <> Bytes.cons new less]
      go (n - 1 :: Int) changed
    samples =
      [ "[1.5e10,-0.0,1E-2,0]"
      , "\"\\u00e9\\ud834\\udd1e\\n\""
      , "{\"a\":{\"b\":[true,false,null]},\"\":\"\"}"
      , "[\"\195\169\",\"\\\\\\\"\"]"
      ]
    values :: Int -> Gen Aeson.Value
    values depth =
      oneof $
        [ Aeson.toJSON <$> (arbitrary :: Gen Int)
        , Aeson.toJSON <$> (arbitrary :: Gen Double)
        , Aeson.toJSON <$> listOf (elements "a\"\\\n\233\119070/u")
        , pure Aeson.Null
        , Aeson.toJSON <$> (arbitrary :: Gen Bool)
        ]
          <> [Aeson.toJSON <$> vectorUpTo 3 (values (depth - 1)) | depth > 0]
          <> [Aeson.toJSON . asObject <$> vectorUpTo 3 (values (depth - 1)) | depth > 0]
    vectorUpTo n g = choose (0, n :: Int) >>= \k -> vectorOf k g
    asObject vs = Aeson.object (zip ["a", "b", "c"] vs)
