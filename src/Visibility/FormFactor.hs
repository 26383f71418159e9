-- | Measures of faces and form factors: as exact sums of square roots, and correctly rounded.
module Visibility.FormFactor
  ( module Visibility.FormFactor.Exact
  , module Visibility.FormFactor.Rounded
  ) where

import Visibility.FormFactor.Exact (Measures)
import Visibility.FormFactor.Exact hiding (Measures (..), byName, factorRows, groupSums)
import Visibility.FormFactor.Rounded
