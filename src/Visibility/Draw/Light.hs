{-# LANGUAGE OverloadedStrings #-}

-- | What figures show of elements: their form factors, and their radiosities.
module Visibility.Draw.Light
  ( elementMatrix
  , lightFigure
  ) where

import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Text as Text
import Visibility.Draw.Matrix (Group (..), Matrix (..), factorMatrix, withSky)
import Visibility.Draw.Radiosity (LitElement (..), RadiosityFigure (..))
import Visibility.Draw.Scale (decimalText, roundStep)
import Visibility.Draw.Values (Scaling)
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Exact.Rounding (nearestDouble)
import Visibility.FormFactor (FactorRow)
import Visibility.Mesh.Element
import Visibility.Radiosity (Lit (..), Radiosity (..))
import Visibility.Scene

-- | The matrix of the form factors of elements, by the sides that they are on, which are parts of polygons.
--
-- /Laws/ those of 'Visibility.Draw.Matrix.factorMatrix'.
elementMatrix :: Refined -> [FactorRow Double] -> Matrix Seen
elementMatrix cut rows =
  (factorMatrix scene rows)
    { matrixTitle = "Form factors of the elements of " <> fromMaybe "an untitled scene" (sceneTitle scene)
    , matrixThings = "elements"
    , matrixGroups = "sides"
    , matrixRows = sidesOfFile
    , matrixColumns = withSky scene sidesOfFile
    , matrixName = nameOf
    }
  where
    scene = refinedScene cut
    sidesOfFile =
      [ Group (Text.pack (sideText side)) (Text.pack (polygonText polygon)) (map TheSide members)
      | (side@(SideName polygon _), members) <- Map.toList bySide
      ]
    bySide = Map.fromListWith (flip (<>)) [(elementSide e, [elementIn e]) | e <- refinedElements cut]
    names = elementNames cut
    nameOf seen = Text.pack $ case seen of
      TheSide name -> names name
      TheSky -> seenText TheSky

-- | The radiosities of elements, each the Double nearest to the middle of its bounds, with profiles along some sides.
--
-- /Degenerate cases/ where all are too small for Doubles, or some too large, they are in units that the figure names.
lightFigure :: Scaling -> [SideName] -> Refined -> Radiosity -> RadiosityFigure
lightFigure scaling profiles cut found =
  RadiosityFigure
    { radiosityQuantity = "radiosity" <> unitText
    , radiosityScaling = scaling
    , radiosityProfiles = profiles
    , radiosityElements = map lit (litElements found)
    }
  where
    lit l =
      LitElement
        { litSide = elementSide (litElement l)
        , litFrom = elementFrom (litElement l)
        , litTo = elementTo (litElement l)
        , litEnds = elementEnds cut (litElement l)
        , litValue = nearestDouble (RootSum.rational (middle l / unit))
        }
    middle l = let (low, high) = litRadiosity l in (low + high) / 2
    greatest = maximum (0 : map middle (litElements found))
    (unit, unitText)
      | greatest == 0 || (1e-300 < greatest && greatest < 1e300) = (1, "")
      | otherwise = let step = roundStep greatest in (step, " in units of " <> decimalText step)
