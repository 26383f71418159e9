{-# LANGUAGE OverloadedStrings #-}

-- | Form factors as CSV, JSON and text.
module Visibility.Format.Factors
  ( FactorFormat (..)
  , Detail (..)
  , Naming (..)
  , exactDocument
  , decimalDocument
  , nearestDocument
  , exactTerms
  ) where

import Data.Aeson.Encoding (Encoding, list, pair, pairs, string)
import qualified Data.Aeson.Encoding as Aeson
import Data.ByteString.Builder (Builder, byteString, char7, intDec, string7)
import qualified Data.ByteString.Char8 as Bytes
import Data.Double.Conversion.ByteString (toShortest)
import qualified Data.Map.Strict as Map
import Visibility.Exact.RootSum (RootSum)
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Exact.Rounding
import Visibility.FormFactor
import Visibility.Scene

-- | The formats that a form factor matrix is written in.
data FactorFormat = FactorsCsv | FactorsJson | FactorsText
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | Whether exact measures are written beside the decimals.
data Detail = DecimalsOnly | WithExactMeasures
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | What sides are called.
data Naming
  = -- | By their names.
    OwnNames
  | -- | As the elements that they are.
    ElementNames !(SideName -> String)

-- | The document of form factors with their exact measures. Decimals are correctly rounded to so many significant digits;
-- factors that are exactly zero are not there.
--
-- /Shape/ CSV: header @from,to,value,measure@, the measure as Σ coefficient·√radicand = 2·L·F, such as
-- @1\/2*sqrt(13) - 3*sqrt(2)@. JSON: see the contract of formats. Text: a block per side.
--
-- /Degenerate cases/ where a part of a side is covered, JSON has @uncovered@ beside its length, the part of it that is
-- not, exactly, and so has the text: the factors of the side add up to that.
exactDocument :: FactorFormat -> Digits -> Naming -> Scene -> [FormFactor] -> Builder
exactDocument format wanted naming scene factors =
  document format naming (decimalBytes wanted . sideLength scene) scene "from,to,value,measure\n" (map entry factors)
  where
    entry factor =
      Entry
        (factorFrom factor)
        (factorTo factor)
        (decimalBytes wanted (factorValue factor))
        (Just (factorMeasure factor))

-- | The document of form factors as decimals of so many significant digits, of the same shape without measures.
decimalDocument :: FactorFormat -> Digits -> Naming -> Scene -> [FactorRow Bytes.ByteString] -> Builder
decimalDocument format wanted naming scene rows =
  document format naming (decimalBytes wanted . sideLength scene) scene plainHeader (entriesOf id rows)

plainHeader :: String
plainHeader = "from,to,value\n"

entriesOf :: (a -> Bytes.ByteString) -> [FactorRow a] -> [Entry]
entriesOf text rows = [Entry (rowFrom row) to (text x) Nothing | row <- rows, (to, x) <- rowFactors row]

-- | The document of form factors rounded to Doubles, of the same shape. Values and lengths are the nearest Doubles,
-- each the shortest decimal that is read back as it.
--
-- /Degenerate cases/ a length that no positive Double is near to, being too large or too small, is the decimal of
-- 'defaultDigits' that 'decimalDocument' writes. A form factor that is too small is 0: see 'nearestFactors'.
nearestDocument :: FactorFormat -> Naming -> Scene -> [FactorRow Double] -> Builder
nearestDocument format naming scene rows =
  document format naming (lengthBytes . sideLength scene) scene plainHeader (entriesOf toShortest rows)
  where
    lengthBytes exact
      | nearest > 0 && not (isInfinite nearest) = toShortest nearest
      | otherwise = decimalBytes defaultDigits exact
      where
        nearest = nearestDouble exact

-- | A form factor as it is written, and its measure where that is wanted.
data Entry = Entry !SideName !Seen !Bytes.ByteString !(Maybe RootSum)

-- | Entries by the side that they leave; with the text of a side's length and the header of CSV.
document :: FactorFormat -> Naming -> (SideName -> Bytes.ByteString) -> Scene -> String -> [Entry] -> Builder
document format naming lengthOf scene header entries = case format of
  FactorsCsv -> string7 header <> foldMap (csvRow naming) entries
  FactorsJson -> Aeson.fromEncoding (json naming lengthOf scene entries) <> char7 '\n'
  FactorsText -> plain naming lengthOf scene entries

decimalBytes :: Digits -> RootSum -> Bytes.ByteString
decimalBytes wanted = Bytes.pack . decimal wanted

csvRow :: Naming -> Entry -> Builder
csvRow naming (Entry from to value measure) =
  sideBuilder naming from
    <> char7 ','
    <> seenBuilder naming to
    <> char7 ','
    <> byteString value
    <> foldMap (\total -> char7 ',' <> string7 (rootSumText total)) measure
    <> char7 '\n'

sideBuilder :: Naming -> SideName -> Builder
sideBuilder naming side@(SideName polygon k) = case (naming, polygon) of
  (ElementNames name, _) -> string7 (name side)
  -- As 'sideText' has it.
  (OwnNames, Obstacle p) -> intDec p <> char7 '.' <> intDec k
  (OwnNames, Enclosure) -> string7 "E." <> intDec k

seenBuilder :: Naming -> Seen -> Builder
seenBuilder naming (TheSide s) = sideBuilder naming s
seenBuilder _ TheSky = string7 (seenText TheSky)

nameOf :: Naming -> SideName -> String
nameOf naming = case naming of
  OwnNames -> sideText
  ElementNames name -> name

nameOfSeen :: Naming -> Seen -> String
nameOfSeen naming seen = case seen of
  TheSide s -> nameOf naming s
  TheSky -> seenText TheSky

json :: Naming -> (SideName -> Bytes.ByteString) -> Scene -> [Entry] -> Encoding
json naming lengthOf scene entries =
  pairs $
    pair "format" (string "viscomplex/1")
      <> pair "sides" (list side (statedSides scene))
      <> pair "factors" (list factor entries)
  where
    side s =
      pairs $
        pair "id" (string (nameOf naming s))
          <> pair "length" (ascii (lengthOf s))
          <> mconcat [pair "uncovered" (string (rationalText part)) | part <- covering scene s]
    factor (Entry from to value measure) =
      pairs $
        pair "from" (string (nameOf naming from))
          <> pair "to" (string (nameOfSeen naming to))
          <> pair "value" (ascii value)
          <> foldMap (pair "measure" . exactTerms) measure
    ascii text = Aeson.unsafeToEncoding (char7 '"' <> byteString text <> char7 '"')

-- | The part of a side that is not covered, where that is not all of it.
covering :: Scene -> SideName -> [Rational]
covering scene s = [part | let part = uncovered scene s, part /= 1]

-- | The terms of a sum of roots as a JSON list of @[coefficient, radicand]@.
exactTerms :: RootSum -> Encoding
exactTerms = list term . RootSum.terms
  where
    term (c, n) = list string [rationalText c, show n]

plain :: Naming -> (SideName -> Bytes.ByteString) -> Scene -> [Entry] -> Builder
plain naming lengthOf scene entries = foldMap block (statedSides scene)
  where
    bySide = Map.fromListWith (flip (<>)) [(from, [entry]) | entry@(Entry from _ _ _) <- entries]
    block s =
      string7 ("side " <> nameOf naming s <> ", length ")
        <> byteString (lengthOf s)
        <> foldMap (\part -> string7 (", " <> rationalText part <> " of it uncovered")) (covering scene s)
        <> string7 ", sees\n"
        <> foldMap row (Map.findWithDefault [] s bySide)
    row (Entry _ to value measure) =
      string7 ("  " <> padded (nameOfSeen naming to)) <> byteString value <> foldMap exact measure <> char7 '\n'
    padded text = text <> replicate (max 1 (10 - length text)) ' '
    exact total = string7 "  = (" <> string7 (rootSumText total) <> string7 ") / (2 L)"

-- | A sum of roots for people: @1\/2*sqrt(13) - 3@.
rootSumText :: RootSum -> String
rootSumText total = case RootSum.terms total of
  [] -> "0"
  first : rest -> leading first <> concatMap following rest
  where
    leading (c, n) = (if c < 0 then "-" else "") <> magnitude (abs c) n
    following (c, n) = (if c < 0 then " - " else " + ") <> magnitude (abs c) n
    magnitude c 1 = rationalText c
    magnitude 1 n = root n
    magnitude c n = rationalText c <> "*" <> root n
    root n = "sqrt(" <> show n <> ")"
