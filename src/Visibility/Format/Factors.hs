{-# LANGUAGE OverloadedStrings #-}

-- | Form factors as CSV, JSON and text.
module Visibility.Format.Factors
  ( FactorFormat (..)
  , Detail (..)
  , Naming
  , sideBuilder
  , exactDocument
  , decimalDocument
  , nearestDocument
  , exactTerms
  ) where

import Data.Aeson.Encoding (Encoding, list, pair, pairs)
import Data.ByteString.Builder (Builder, byteString, char7, intDec, integerDec, string7, toLazyByteString)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Visibility.Exact.RootSum (RootSum)
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Exact.Rounding
import Visibility.Exact.Shortest (shortest)
import Visibility.FormFactor
import Visibility.Format.Json.Document (ascii, exact, rationalBuilder)
import qualified Visibility.Format.Json.Document as Json
import Visibility.Scene

-- | The formats that a form factor matrix is written in.
data FactorFormat = FactorsCsv | FactorsJson | FactorsText
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | Whether exact measures are written beside the decimals.
data Detail = DecimalsOnly | WithExactMeasures
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | What sides are called: 'sideBuilder', or the names of elements.
type Naming = SideName -> Builder

-- | The document of form factors with their exact measures. Decimals are correctly rounded to so many significant
-- digits; factors that are exactly zero are not there.
--
-- /Shape/ CSV: header @from,to,value,measure@, the measure as Σ coefficient·√radicand = 2·L·F, such as
-- @1\/2*sqrt(13) - 3*sqrt(2)@. JSON: see the contract of formats. Text: a block per side.
--
-- /Degenerate cases/ where a part of a side is covered, JSON has @uncovered@ beside its length, the part of it that is
-- not, exactly, and so has the text: the factors of the side add up to that.
exactDocument :: FactorFormat -> Digits -> Naming -> Scene -> [FactorRow (Bytes.ByteString, RootSum)] -> Builder
exactDocument format wanted naming scene =
  document format naming (decimalText wanted . sideLength scene) scene "from,to,value,measure\n" entry
  where
    entry (value, measure) = Entry (byteString value) (Just measure)

-- | The document of form factors as decimals of so many significant digits, of the same shape without measures.
decimalDocument :: FactorFormat -> Digits -> Naming -> Scene -> [FactorRow Bytes.ByteString] -> Builder
decimalDocument format wanted naming scene =
  document format naming (decimalText wanted . sideLength scene) scene plainHeader (\x -> Entry (byteString x) Nothing)

plainHeader :: String
plainHeader = "from,to,value\n"

-- | The document of form factors rounded to Doubles, of the same shape. Values and lengths are the nearest Doubles,
-- each the shortest decimal that is read back as it.
--
-- /Degenerate cases/ a length that no positive Double is near to, being too large or too small, is the decimal of
-- 'defaultDigits' that 'decimalDocument' writes. A form factor that is too small is 0: see 'nearestFactors'.
nearestDocument :: FactorFormat -> Naming -> Scene -> [FactorRow Double] -> Builder
nearestDocument format naming scene =
  document format naming (lengthText . sideLength scene) scene plainHeader (\x -> Entry (shortest x) Nothing)
  where
    lengthText found
      | nearest > 0 && not (isInfinite nearest) = shortest nearest
      | otherwise = decimalText defaultDigits found
      where
        nearest = nearestDouble found

-- | A form factor as it is written, and its measure where that is wanted.
data Entry = Entry !Builder !(Maybe RootSum)

-- | Form factors by the side that they leave, each side having its row; with the text of a side's length and the header
-- of CSV.
document
  :: FactorFormat -> Naming -> (SideName -> Builder) -> Scene -> String -> (a -> Entry) -> [FactorRow a] -> Builder
document format naming lengthOf scene header entry rows = case format of
  FactorsCsv -> string7 header <> foldMap csvRow entries
  FactorsJson -> Json.document $ pair "sides" (list side (statedSides scene)) <> pair "factors" (list factor entries)
  FactorsText -> foldMap block rows
  where
    entries = [(rowFrom row, to, entry x) | row <- rows, (to, x) <- rowFactors row]
    seen to = case to of
      TheSide s -> naming s
      TheSky -> string7 (seenText TheSky)
    csvRow (from, to, Entry value measure) =
      naming from <> char7 ',' <> seen to <> char7 ',' <> value
        <> foldMap (\total -> char7 ',' <> rootSum total) measure
        <> char7 '\n'
    side s =
      pairs $
        pair "id" (ascii (naming s))
          <> pair "length" (ascii (lengthOf s))
          <> mconcat [pair "uncovered" (exact part) | part <- covering scene s]
    factor (from, to, Entry value measure) =
      pairs $
        pair "from" (ascii (naming from))
          <> pair "to" (ascii (seen to))
          <> pair "value" (ascii value)
          <> foldMap (pair "measure" . exactTerms) measure
    -- What the light from one side reaches.
    block row =
      string7 "side " <> naming (rowFrom row) <> string7 ", length " <> lengthOf (rowFrom row)
        <> mconcat [string7 ", " <> rationalBuilder q <> string7 " of it uncovered" | q <- covering scene (rowFrom row)]
        <> string7 ", sees\n"
        <> mconcat [textRow to (entry x) | (to, x) <- rowFactors row]
    textRow to (Entry value measure) =
      string7 "  " <> padded (seen to) <> value <> foldMap equals measure <> char7 '\n'
    padded name = name <> string7 (replicate (max 1 (10 - fromIntegral (Lazy.length (toLazyByteString name)))) ' ')
    equals total = string7 "  = (" <> rootSum total <> string7 ") / (2 L)"

decimalText :: Digits -> RootSum -> Builder
decimalText wanted = string7 . decimal wanted

-- | As 'sideText' has it.
sideBuilder :: SideName -> Builder
sideBuilder (SideName polygon k) = case polygon of
  Obstacle p -> intDec p <> char7 '.' <> intDec k
  Enclosure -> string7 "E." <> intDec k

-- | The part of a side that is not covered, where that is not all of it.
covering :: Scene -> SideName -> [Rational]
covering scene s = [part | let part = uncovered scene s, part /= 1]

-- | The terms of a sum of roots as a JSON list of @[coefficient, radicand]@.
exactTerms :: RootSum -> Encoding
exactTerms = list term . RootSum.terms
  where
    term (c, n) = list ascii [rationalBuilder c, integerDec n]

-- | A sum of roots for people: @1\/2*sqrt(13) - 3@.
rootSum :: RootSum -> Builder
rootSum total = case RootSum.terms total of
  [] -> char7 '0'
  first : rest -> leading first <> foldMap following rest
  where
    leading (c, n) = (if c < 0 then char7 '-' else mempty) <> magnitude (abs c) n
    following (c, n) = string7 (if c < 0 then " - " else " + ") <> magnitude (abs c) n
    magnitude c 1 = rationalBuilder c
    magnitude 1 n = root n
    magnitude c n = rationalBuilder c <> char7 '*' <> root n
    root n = string7 "sqrt(" <> integerDec n <> char7 ')'
