{-# LANGUAGE OverloadedStrings #-}

-- | Exact numbers as files spell them: decimals, integers and fractions.
module Visibility.Format.Number
  ( -- * Reading
    NumberFault (..)
  , readNumber
  , readSpelled
  , exponentLimit
    -- * Writing
  , decimalText
  , numberText
  ) where

import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import Data.Char (isDigit)
import Data.List (find)
import Data.Maybe (fromMaybe)
import Data.Ratio (denominator, numerator, (%))
import Data.Text (Text)
import qualified Data.Text.Encoding as Text
import Visibility.Exact.Rounding (rationalText)

-- | Why a text is not an exact number.
data NumberFault
  = -- | It is not spelled as a number.
    NotANumber
  | -- | p/0.
    ZeroDenominator
  | -- | The exponent is larger in size than 'exponentLimit'.
    ExponentTooLarge
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | 400. The exponent /as spelled/ counts, whatever the number of digits before it: @1.234e-400@ is read exactly,
-- though its denominator is 10^403. So a number is never larger than its text is long, but for these 400 digits.
exponentLimit :: Int
exponentLimit = 400

-- | Reads a decimal with or without an exponent, an integer, or a fraction p/q of integers with q > 0. Digits stand on
-- both sides of a decimal point, a sign is only @-@ and only in front (or after @e@, where @+@ may stand too), and
-- there are no spaces. Leading zeros do no harm here; JSON forbids them outside of strings.
--
-- /Degenerate cases/ the size of the exponent is checked before any power of ten is computed.
--
-- /Laws/ @readNumber (pack (numberText q)) == Right q@.
--
-- >>> map readNumber ["1e-3", "-7/2", "1e-400", "1e401", "1/-2"]
-- [Right (1 % 1000),Right ((-7) % 2),Right (1 % 1000…000),Left ExponentTooLarge,Left NotANumber]
readNumber :: Text -> Either NumberFault Rational
readNumber = readSpelled . Text.encodeUtf8

-- | The same from the bytes of a text in UTF-8.
readSpelled :: ByteString -> Either NumberFault Rational
readSpelled bytes = maybe (unsigned bytes) (fmap negate . unsigned) (Bytes.stripPrefix "-" bytes)

unsigned :: ByteString -> Either NumberFault Rational
unsigned text = do
  (whole, rest) <- digits text
  case Bytes.uncons rest of
    Nothing -> Right (fromInteger (natural whole))
    Just ('/', below) -> do
      (q, end) <- digits below
      atEnd end
      if natural q == 0 then Left ZeroDenominator else Right (natural whole % natural q)
    Just ('.', below) -> do
      (part, rest') <- digits below
      power <- exponentPart rest'
      Right (scaled (natural (whole <> part)) (power - Bytes.length part))
    Just _ -> scaled (natural whole) <$> exponentPart rest

exponentPart :: ByteString -> Either NumberFault Int
exponentPart text = case Bytes.uncons text of
  Nothing -> Right 0
  Just (e, rest) | e == 'e' || e == 'E' -> case Bytes.uncons rest of
    Just ('-', rest') -> negate <$> size rest'
    Just ('+', rest') -> size rest'
    _ -> size rest
  Just _ -> Left NotANumber
  where
    size rest = do
      (found, end) <- digits rest
      atEnd end
      let significant = Bytes.dropWhile (== '0') found
      if Bytes.length significant > 3 || natural significant > toInteger exponentLimit
        then Left ExponentTooLarge
        else Right (fromInteger (natural significant))

digits :: ByteString -> Either NumberFault (ByteString, ByteString)
digits text
  | Bytes.null found = Left NotANumber
  | otherwise = Right (found, rest)
  where
    (found, rest) = Bytes.span isDigit text

atEnd :: ByteString -> Either NumberFault ()
atEnd rest = if Bytes.null rest then Right () else Left NotANumber

-- The value of a run of digits, in less than quadratic time.
natural :: ByteString -> Integer
natural = maybe 0 fst . Bytes.readInteger

-- n·10^k.
scaled :: Integer -> Int -> Rational
scaled n k
  | k >= 0 = fromInteger (n * 10 ^ k)
  | otherwise = n % (10 ^ negate k)

-- | The number as an integer or as a decimal of at most 20 digits after the point, if it is one.
--
-- >>> map decimalText [-5/2, 7, 1/3]
-- [Just "-2.5",Just "7",Nothing]
decimalText :: Rational -> Maybe String
decimalText q = render <$> find divides [0 .. longest]
  where
    longest = 20 :: Int
    divides k = (10 ^ k) `rem` denominator q == 0
    render 0 = show (numerator q)
    render k =
      let (whole, part) = abs (numerator q * (10 ^ k `div` denominator q)) `quotRem` (10 ^ k)
          padded = replicate (k - length (show part)) '0' <> show part
       in (if q < 0 then "-" else "") <> show whole <> "." <> padded

-- | 'decimalText' if there is one, else 'rationalText'. Always exact.
numberText :: Rational -> String
numberText q = fromMaybe (rationalText q) (decimalText q)
