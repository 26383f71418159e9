{-# LANGUAGE OverloadedStrings #-}

-- | Radiosities as JSON.
module Visibility.Format.Radiosity
  ( radiosityDocument
  ) where

import Data.Maybe (fromMaybe)
import Data.Ratio ((%))
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Exact.Rounding
import Visibility.Format.Json.Document
import Visibility.Format.Number (numberText)
import Visibility.Mesh.Element
import Visibility.Radiosity
import Visibility.Scene (sideText)
import Visibility.Scene.Raw (Material (..))

-- | The document: see the contract of formats.
--
-- /Shape/ bounds are pairs of decimals, the lower one rounded down and the upper one up: what is written encloses the
-- true number. Of powers there is the middle of the bounds too. @fill@ is the part of all pairs of elements that see
-- each other.
--
-- /Degenerate cases/ where a part of an element is covered, @uncovered@ is the part that is not.
radiosityDocument :: Radiosity -> Builder
radiosityDocument found =
  document $
    pair "elements" (list element (litElements found))
      <> pair "sides" (list side (sideAverages found))
      <> pair "iterations" (int (passCount found))
      <> pair "fill" (string (decimal (few 6) (RootSum.rational fill)))
      <> power "emitted" "emittedBounds" emittedPower
      <> power "absorbed" "absorbedBounds" absorbedPower
      <> power "lost" "lostBounds" lostPower
  where
    fill = if n == 0 then 0 else toInteger (nonzeroFactors found) % (n * n)
    n = toInteger (length (litElements found))
    element l =
      pairs $
        pair "id" (string (elementText (litElement l)))
          <> pair "from" (exact (elementFrom (litElement l)))
          <> pair "to" (exact (elementTo (litElement l)))
          <> mconcat [pair "uncovered" (exact (litOpen l)) | litOpen l /= 1]
          <> pair "emission" (string (numberText (emission (litMaterial l))))
          <> pair "reflectivity" (string (numberText (reflectivity (litMaterial l))))
          <> pair "radiosity" (bounds (litRadiosity l))
    side (name, within) = pairs (pair "id" (string (sideText name)) <> pair "radiosity" (bounds within))
    power :: Key -> Key -> (Balance -> (Rational, Rational)) -> Series
    power name boundsName pick =
      let (low, high) = pick (energy found)
       in pair name (string (decimal shown (RootSum.rational ((low + high) / 2))))
            <> pair boundsName (bounds (low, high))
    bounds :: (Rational, Rational) -> Encoding
    bounds within = let (low, high) = outwardDecimals shown within in list string [low, high]
    shown = worthyDigits found
    few k = fromMaybe defaultDigits (digits k)
