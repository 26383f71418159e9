-- | Measures of faces and form factors: as exact sums of square roots, and correctly rounded.
module Visibility.FormFactor
  ( -- * Measures of lines
    Measures
  , measures
  , measuresInPieces
  , measureList
  , statedMeasures
    -- * Form factors
  , FormFactor (..)
  , formFactors
  , formFactor
  , sideLength
    -- * Rounded
  , FactorRow (..)
  , nearestFactors
  , decimalFactors
  , exactFactors
    -- * Laws
  , closureDefect
  ) where

import Visibility.FormFactor.Exact
import Visibility.FormFactor.Rounded
