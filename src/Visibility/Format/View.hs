{-# LANGUAGE OverloadedStrings #-}

-- | What is seen from a point, an element or a side, as JSON.
module Visibility.Format.View
  ( regionDocument
  , elementDocument
  , sideDocument
  ) where

import Data.List (sortOn)
import Visibility.Exact.Predicate (Direction (..))
import Visibility.Exact.RootSum (RootSum)
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Exact.Rounding
import Visibility.FormFactor
import Visibility.Format.Factors (Detail (..), exactTerms)
import Visibility.Format.Json.Document
import Visibility.Scene
import Visibility.Sight

-- | The visibility polygon of a viewpoint.
--
-- /Shape/ @from@, for a corner also @corner@; @polygon@, its points; @unbounded@, directions, two and two of them an
-- interval in which the sky is seen, counter-clockwise. All numbers are exact, as strings.
--
-- /Degenerate cases/ @unbounded@ is empty in a room; a full turn is @[["1","0"],["1","0"]]@, with an empty @polygon@.
regionDocument :: Viewpoint -> Region -> Builder
regionDocument viewpoint seen =
  document $
    standing viewpoint
      <> pair "polygon" (list exactPoint (regionPoints seen))
      <> pair "unbounded" (list vector (concat [[from, to] | (from, to) <- regionUnbounded seen]))

-- | The form factors of an element at a viewpoint, with a normal.
--
-- /Shape/ @from@, for a corner also @corner@; @normal@; @sees@, an entry for each object whose factor is not exactly
-- zero: sides by name, the sky last. @value@ is a decimal, correctly rounded to so many digits; with exact measures
-- there is also @exact@, the factor as Σ coefficient·√radicand.
elementDocument :: Detail -> Digits -> Viewpoint -> Direction -> [(Seen, RootSum)] -> Builder
elementDocument detail wanted viewpoint normal factors =
  document $
    standing viewpoint
      <> pair "normal" (vector normal)
      <> pair "sees" (list entry (sortOn fst (filter (notZero . snd) merged)))
  where
    merged = [(object, RootSum.merged value) | (object, value) <- factors]
    entry (object, value) = seenEntry wanted object value (exactly detail "exact" value)

-- | The form factors of a side.
--
-- /Shape/ @side@; @sees@ as in 'elementDocument', with exact measures @measure@, Σ coefficient·√radicand = 2·L·F.
--
-- /Requires/ the factors of this side; those of other sides are left out.
sideDocument :: Detail -> Digits -> SideName -> [FormFactor] -> Builder
sideDocument detail wanted side factors =
  document $
    pair "side" (string (sideText side))
      <> pair "sees" (list entry (sortOn factorTo own))
  where
    own = [factor | factor <- factors, factorFrom factor == side, notZero (factorValue factor)]
    entry factor =
      seenEntry wanted (factorTo factor) (factorValue factor) $
        exactly detail "measure" (factorMeasure factor)

standing :: Viewpoint -> Series
standing viewpoint =
  pair "from" (exactPoint (viewpointAt viewpoint))
    <> mconcat [pair "corner" (string (cornerText name)) | AtCorner name _ <- [viewpoint]]

seenEntry :: Digits -> Seen -> RootSum -> Series -> Encoding
seenEntry wanted object value measure =
  pairs $
    pair "id" (string (seenText object)) <> pair "value" (string (decimal wanted value)) <> measure

exactly :: Detail -> Key -> RootSum -> Series
exactly detail key value = case detail of
  DecimalsOnly -> mempty
  WithExactMeasures -> pair key (exactTerms value)

notZero :: RootSum -> Bool
notZero value = RootSum.sign value /= RootSum.Zero

vector :: Direction -> Encoding
vector (Direction x y) = list (string . show) [x, y]
