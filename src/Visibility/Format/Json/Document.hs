{-# LANGUAGE OverloadedStrings #-}

-- | What all results in JSON have in common.
module Visibility.Format.Json.Document
  ( document
  , ascii
  , exact
  , exactPoint
  , rationalBuilder
    -- * What they consist of
  , Builder
  , Key
  , module Data.Aeson.Encoding
  ) where

import Data.Aeson (Key)
import Data.Aeson.Encoding (Encoding, Series, fromEncoding, int, list, null_, pair, pairs, string, unsafeToEncoding)
import Data.ByteString.Builder (Builder, char7, integerDec)
import Data.Ratio (denominator, numerator)
import Visibility.Exact.Point (Point (..))

-- | An object that begins with the name of the format, in a line.
document :: Series -> Builder
document parts = fromEncoding (pairs (pair "format" (string "viscomplex/1") <> parts)) <> char7 '\n'

-- | A text that needs no escapes.
ascii :: Builder -> Encoding
ascii text = unsafeToEncoding (char7 '"' <> text <> char7 '"')

-- | An exact number, as a string.
exact :: Rational -> Encoding
exact = ascii . rationalBuilder

-- | The list of x and y.
exactPoint :: Point -> Encoding
exactPoint (Point x y) = list exact [x, y]

-- | As 'Visibility.Exact.Rounding.rationalText' has it.
rationalBuilder :: Rational -> Builder
rationalBuilder q
  | denominator q == 1 = integerDec (numerator q)
  | otherwise = integerDec (numerator q) <> char7 '/' <> integerDec (denominator q)
