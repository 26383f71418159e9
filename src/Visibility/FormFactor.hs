-- | Measures of faces and form factors: as exact sums of square roots, and correctly rounded to Doubles.
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
    -- * As Doubles
  , NearestRow (..)
  , nearestFactors
    -- * Laws
  , closureDefect
  ) where

import Visibility.FormFactor.Exact
import Visibility.FormFactor.Nearest
