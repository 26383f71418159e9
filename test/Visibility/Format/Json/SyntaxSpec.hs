{-# LANGUAGE OverloadedStrings #-}

module Visibility.Format.Json.SyntaxSpec (spec) where

import qualified Data.Aeson as Aeson
import qualified Data.Aeson.Key as Key
import Data.Bifunctor (first)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Chars
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_)
import Data.List (isInfixOf, nub)
import Data.Text (Text)
import qualified Data.Text as Text
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck
import Visibility.Error
import Visibility.Format.Json.Syntax

spec :: Spec
spec = describe "parseDocument" $ do
  it "keeps numbers as spelled, and members in order with their duplicates" $
    parsed " {\"b\": [1.50e+2, -0, 1E400], \"a\": null, \"b\": true}\n"
      `shouldBe` Right
        (Members [("b", Items [Numeral "1.50e+2", Numeral "-0", Numeral "1E400"]), ("a", Nil), ("b", Truth True)])
  it "reads escapes and characters beyond U+FFFF" $
    parsed "\"\\\"\\\\\\/\\b\\f\\n\\r\\t\\u00e9\\uD834\\uDD1E \195\169\""
      `shouldBe` Right (Words "\"\\/\b\f\n\r\t\233\119070 \233")
  it "pairs the first and the last surrogates" $
    parsed "\"\\ud800\\udc00\\udbff\\udfff\"" `shouldBe` Right (Words "\x10000\x10ffff")
  it "reads half of a surrogate pair as U+FFFD, and goes on behind it" $ do
    parsed "\"\\ud834\\ud834\\udd1e \\udd1ex\\ud834\\n\\ud834\\u0041\""
      `shouldBe` Right (Words "\xfffd\x1d11e \xfffdx\xfffd\n\xfffd\&A")
    parsed "\"\\ud834\\u00g0\""
      `shouldBe` Left (TextPosition 1 12, Unexpected (Just 'g') (Expected "four hexadecimal digits belong here"))
  it "tells brackets and quotes in strings from those around them" $
    parsed "[[\"]\", \"\\\"]\", \"\\\\\"], {\"}\": \"{\", \",\\\\\": \"[\"} ,1]"
      `shouldBe` Right
        ( Items
            [ Items [Words "]", Words "\"]", Words "\\"]
            , Members [("}", Words "{"), (",\\", Words "[")]
            , Numeral "1"
            ]
        )
  it "bounds the depth" $ do
    let nested n = Chars.replicate n '[' <> Chars.replicate n ']'
    parsed (nested deepest) `shouldBe` Right (iterate (Items . (: [])) (Items []) !! (deepest - 1))
    parsed (Bytes.concat (replicate deepest "{\"\":[" <> ["1"] <> replicate deepest "]}"))
      `shouldBe` Left (TextPosition 1 (5 * div deepest 2 + 1), TooDeep deepest)
    parsed (nested (deepest + 1)) `shouldBe` Left (TextPosition 1 (deepest + 1), TooDeep deepest)
    parsed (Chars.replicate 10000000 '[') `shouldBe` Left (TextPosition 1 (deepest + 1), TooDeep deepest)
    parsed (Bytes.concat (replicate 1000000 "{\"\":"))
      `shouldBe` Left (TextPosition 1 (4 * deepest + 1), TooDeep deepest)
  it "takes a list of many elements" $
    let zeros = "[" <> Bytes.intercalate "," (replicate 300000 "0") <> "]"
     in fmap (size . value) (parseDocument zeros) `shouldBe` Right 300000
  describe "counts lines and characters" $
    for_ positions $ \(text, line, column) ->
      it (show text) $ either (Right . fst) Left (parsed text) `shouldBe` Right (TextPosition line column)
  modifyMaxSuccess (* 20) $
    -- aeson 2.0.3 lets a control character pass in a string that also has an escape, and refuses half a surrogate pair.
    prop "accepts what aeson accepts but for control characters and halves in strings, and nothing else" $
      forAll (mutated `suchThat` (\bytes -> not (isControlled bytes || isHalved (parsed bytes)))) $ \bytes ->
        let isRight = either (const False) (const True)
            accepted = isRight (parseDocument bytes)
         in cover 20 accepted "accepted" $
              cover 20 (not accepted) "refused" $
                counterexample (show (parsed bytes)) $
                  accepted === isRight (Aeson.eitherDecodeStrict bytes :: Either String Aeson.Value)
  modifyMaxSuccess (* 20) $
    prop "finds in a document what aeson finds" $
      forAll (fmap (\bytes -> (bytes, parsed bytes)) mutated `suchThat` hasOneMeaning) $ \(bytes, tree) ->
        fmap valueOf tree === first (const (TextPosition 1 1, InvalidUtf8)) (Aeson.eitherDecodeStrict bytes)
  where
    isControlled bytes = case parseDocument bytes of
      Left (_, ControlCharacter _) -> True
      _ -> False
    size (List items) = length items
    size _ = 0
    -- aeson keeps one of two equal keys.
    hasOneMeaning (_, tree) = not (isHalved tree) && either (const False) keysDiffer tree
    isHalved = either (const False) (isInfixOf (show (fromEnum '\xfffd')) . show)
    keysDiffer tree = case tree of
      Items trees -> all keysDiffer trees
      Members members -> length (nub (map fst members)) == length members && all (keysDiffer . snd) members
      _ -> True

-- | All of a document.
data Tree
  = Nil
  | Truth Bool
  | Numeral Bytes.ByteString
  | Words Text
  | Items [Tree]
  | Members [(Text, Tree)]
  deriving (Eq, Show)

parsed :: Bytes.ByteString -> Either (TextPosition, SyntaxFault) Tree
parsed bytes = treeOf <$> parseDocument bytes
  where
    treeOf document = case value document of
      Null -> Nil
      Boolean b -> Truth b
      Number spelled -> Numeral spelled
      String text -> Words text
      List items -> Items (map treeOf items)
      Object members -> Members (map (fmap treeOf) members)

valueOf :: Tree -> Aeson.Value
valueOf tree = case tree of
  Nil -> Aeson.Null
  Truth b -> Aeson.Bool b
  Numeral spelled -> either (Aeson.String . Text.pack) Aeson.Number (Aeson.eitherDecodeStrict spelled)
  Words text -> Aeson.String text
  Items trees -> Aeson.toJSON (map valueOf trees)
  Members members -> Aeson.object [(Key.fromText key, valueOf member) | (key, member) <- members]

positions :: [(Bytes.ByteString, Int, Int)]
positions =
  [ ("", 1, 1)
  , ("\n\n  ]", 3, 3)
  , ("[1,\n2,\n]", 3, 1)
  , ("[\"\195\169\195\169\" 1]", 1, 7)
  , ("[\"\\u12\"]", 1, 7)
  , ("[\"ab\\x\"]", 1, 6)
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
