{-# LANGUAGE OverloadedStrings #-}

-- | Form factors as CSV, JSON and text.
module Visibility.Format.Factors
  ( FactorFormat (..)
  , Detail (..)
  , factorsDocument
  , exactTerms
  ) where

import Data.Aeson.Encoding (Encoding, list, pair, pairs, string)
import qualified Data.Aeson.Encoding as Aeson
import Data.ByteString.Builder (Builder, char7, string7)
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

-- | The document. Decimals are correctly rounded to so many significant digits; factors that are exactly zero are not
-- there.
--
-- /Shape/ CSV: header @from,to,value@, with exact measures also @measure@, Σ coefficient·√radicand = 2·L·F as
-- @1\/2*sqrt(13) - 3*sqrt(2)@. JSON: see the contract of formats. Text: a block per side.
--
-- /Degenerate cases/ where a part of a side is covered, JSON has @uncovered@ beside its length, the part of it that is
-- not, exactly, and so has the text: the factors of the side add up to that.
factorsDocument :: FactorFormat -> Detail -> Digits -> Scene -> [FormFactor] -> Builder
factorsDocument format detail wanted scene factors = case format of
  FactorsCsv -> csv detail wanted factors
  FactorsJson -> Aeson.fromEncoding (json detail wanted scene factors) <> char7 '\n'
  FactorsText -> plain detail wanted scene factors

fromText, toText :: FormFactor -> String
fromText = sideText . factorFrom
toText = seenText . factorTo

valueText :: Digits -> FormFactor -> String
valueText wanted = decimal wanted . factorValue

csv :: Detail -> Digits -> [FormFactor] -> Builder
csv detail wanted factors = string7 header <> foldMap row factors
  where
    header = case detail of
      DecimalsOnly -> "from,to,value\n"
      WithExactMeasures -> "from,to,value,measure\n"
    row factor =
      string7 (fromText factor)
        <> char7 ','
        <> string7 (toText factor)
        <> char7 ','
        <> string7 (valueText wanted factor)
        <> exact factor
        <> char7 '\n'
    exact factor = case detail of
      DecimalsOnly -> mempty
      WithExactMeasures -> char7 ',' <> string7 (rootSumText (factorMeasure factor))

json :: Detail -> Digits -> Scene -> [FormFactor] -> Encoding
json detail wanted scene factors =
  pairs $
    pair "format" (string "viscomplex/1")
      <> pair "sides" (list side (statedSides scene))
      <> pair "factors" (list entry factors)
  where
    side s =
      pairs $
        pair "id" (string (sideText s))
          <> pair "length" (string (decimal wanted (sideLength scene s)))
          <> mconcat [pair "uncovered" (string (rationalText part)) | part <- covering scene s]
    entry factor =
      pairs $
        pair "from" (string (fromText factor))
          <> pair "to" (string (toText factor))
          <> pair "value" (string (valueText wanted factor))
          <> exact factor
    exact factor = case detail of
      DecimalsOnly -> mempty
      WithExactMeasures -> pair "measure" (exactTerms (factorMeasure factor))

-- | The part of a side that is not covered, where that is not all of it.
covering :: Scene -> SideName -> [Rational]
covering scene s = [part | let part = uncovered scene s, part /= 1]

-- | The terms of a sum of roots as a JSON list of @[coefficient, radicand]@.
exactTerms :: RootSum -> Encoding
exactTerms = list term . RootSum.terms
  where
    term (c, n) = list string [rationalText c, show n]

plain :: Detail -> Digits -> Scene -> [FormFactor] -> Builder
plain detail wanted scene factors = foldMap block (statedSides scene)
  where
    bySide = Map.fromListWith (flip (<>)) [(factorFrom factor, [factor]) | factor <- factors]
    block s =
      string7 ("side " <> sideText s <> ", length " <> decimal wanted (sideLength scene s))
        <> foldMap (\part -> string7 (", " <> rationalText part <> " of it uncovered")) (covering scene s)
        <> string7 ", sees\n"
        <> foldMap row (Map.findWithDefault [] s bySide)
    row factor =
      string7 ("  " <> padded (toText factor) <> valueText wanted factor) <> exact factor <> char7 '\n'
    padded text = text <> replicate (max 1 (10 - length text)) ' '
    exact factor = case detail of
      DecimalsOnly -> mempty
      WithExactMeasures -> string7 "  = (" <> string7 (rootSumText (factorMeasure factor)) <> string7 ") / (2 L)"

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
