{-# LANGUAGE OverloadedStrings #-}

module Visibility.Format.NumberSpec (spec) where

import Data.Foldable (for_)
import Data.Ratio ((%))
import qualified Data.Text as Text
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Visibility.Exact.Rounding (rationalText)
import Visibility.Format.Number

spec :: Spec
spec = do
  describe "readNumber" $ do
    for_ spelled $ \(text, value) -> it (show text) (readNumber text `shouldBe` Right value)
    for_ refused $ \(text, fault) -> it (show text <> " is refused") (readNumber text `shouldBe` Left fault)
    it "checks the size of the exponent before it computes a power" $
      readNumber ("1e" <> Text.replicate 100000 "9") `shouldBe` Left ExponentTooLarge
    it "reads a million digits" $
      readNumber (Text.replicate 1000000 "9") `shouldBe` Right (10 ^ (1000000 :: Int) - 1)
    prop "reads any decimal as it is spelled" $ \(whole, digits, power) ->
      let fraction = map (\d -> toEnum (fromEnum '0' + abs d `mod` 10)) (digits :: [Int]) <> "0"
          k = power `mod` 400 :: Int
          text = show (whole :: Integer) <> "." <> fraction <> "e" <> show k
          mantissa = read (show (abs whole) <> fraction) :: Integer
          sign = if whole < 0 then -1 else 1
       in readNumber (Text.pack text) === Right (sign * fromInteger mantissa * 10 ^^ (k - length fraction))
    prop "reads a number the same with zeros around it, be they more digits than a machine integer has" $
      forAll ((,) <$> upToDigits 20 <*> oneof [pure Nothing, Just <$> upToDigits 20]) $ \(whole, part) ->
        forAll ((,,) <$> elements ["", "-"] <*> elements [1, 25] <*> elements [1, 25]) $ \(sign, front, behind) ->
          let spelling zeros zeros' =
                sign <> zero zeros <> whole <> foldMap (\digits -> "." <> digits <> zero zeros') part
              zero n = Text.replicate n "0"
           in readNumber (spelling front behind) === readNumber (spelling 0 0)
  describe "numberText" $ do
    prop "readNumber (pack (numberText q)) == Right q" $
      forAll rationals $ \q -> readNumber (Text.pack (numberText q)) === Right q
    prop "readNumber (pack (rationalText q)) == Right q" $
      forAll rationals $ \q -> readNumber (Text.pack (rationalText q)) === Right q
    it "writes decimals of up to 20 digits after the point" $ do
      numberText (-1 % 10 ^ (20 :: Int)) `shouldBe` "-0.00000000000000000001"
      numberText (1 % 10 ^ (21 :: Int)) `shouldBe` "1/1000000000000000000000"
      numberText (-5 % 2) `shouldBe` "-2.5"
      numberText (10 % 3) `shouldBe` "10/3"
      numberText 100 `shouldBe` "100"

upToDigits :: Int -> Gen Text.Text
upToDigits n = choose (1, n) >>= \k -> Text.pack <$> vectorOf k (choose ('0', '9'))

rationals :: Gen Rational
rationals =
  oneof
    [ arbitrary
    , fromInteger <$> arbitrary
    , (\p k -> p % (10 ^ k)) <$> choose (-10 ^ (30 :: Int), 10 ^ (30 :: Int)) <*> choose (0, 25 :: Int)
    , (%) <$> choose (-10 ^ (50 :: Int), 10 ^ (50 :: Int)) <*> choose (1, 10 ^ (50 :: Int))
    ]

spelled :: [(Text.Text, Rational)]
spelled =
  [ ("0", 0)
  , ("-0", 0)
  , ("7", 7)
  , ("-7/2", -7 % 2)
  , ("1/3", 1 % 3)
  , ("4/6", 2 % 3)
  , ("0/5", 0)
  , ("0.1", 1 % 10)
  , ("-2.50", -5 % 2)
  , ("1e-3", 1 % 1000)
  , ("1E3", 1000)
  , ("1e+03", 1000)
  , ("-1.5e1", -15)
  , ("007", 7)
  , ("1e400", 10 ^ (400 :: Int))
  , ("1e0000000000400", 10 ^ (400 :: Int))
  , ("1.234e-400", 1234 % 10 ^ (403 :: Int))
  , ("0e400", 0)
  , ("1.00000000000000000000000000000000000000001", 1 + 1 % 10 ^ (41 :: Int))
  ]

refused :: [(Text.Text, NumberFault)]
refused =
  [(text, NotANumber) | text <- Text.words malformed <> ["", " 1", "1 ", "1/ 2", "1 /2", "1e 3", "1\n"]]
    <> [(text, ZeroDenominator) | text <- ["1/0", "0/0", "-7/00"]]
    <> [(text, ExponentTooLarge) | text <- Text.words tooLarge]
  where
    tooLarge = "1e401 1e-401 0e401 1e1000000000 1e18446744073709551617 1.5e-9999"
    malformed =
      "a - + +1 --1 1- .5 5. -.5 1..2 1.2.3 e5 1e 1e+ 1e- 1e5.0 1ee5 1/ /2 1/-2 1/+2 -1/-2 1.5/2 1/2.5 1/2e3 1/2/3 \
      \0x10 0b1 1_000 \
      \1,5 NaN Infinity ∞ ½ ٣ 1٣ 1f 1d 1L"
