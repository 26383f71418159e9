-- | Where the light stays: what is emitted is absorbed, or lost to the sky.
module Visibility.Radiosity.Balance
  ( Balance (..)
  , balanceOf
  , balanceViolations
  ) where

import qualified Data.Vector as V
import Visibility.Exact.Interval
import Visibility.Exact.RootSum (enclosure, enclosureRelative)
import Visibility.Law
import Visibility.Radiosity.Certificate
import Visibility.Radiosity.System
import Visibility.Scene.Raw (Material (..))

-- | Powers, each within proved bounds: emission and radiosity times length, in the file's units.
data Balance = Balance
  { emittedPower :: !(Rational, Rational)
  , absorbedPower :: !(Rational, Rational)
  , lostPower :: !(Rational, Rational)
  -- ^ What the sky takes.
  }
  deriving (Eq, Show)

-- | The powers that bounds of the radiosities imply: Σ P E, Σ (1 − ρ) L Σ_j F_ij B_j, Σ L F_sky B, with P the length
-- that is not covered.
--
-- /Cost/ O(n) products, and a root for each length.
balanceOf :: System -> Enclosure -> Balance
balanceOf system (Enclosure radiosity arriving) =
  Balance
    { emittedPower = power (V.zipWith emitting patches lengths)
    , absorbedPower = power (V.zipWith3 absorbing patches lengths arriving)
    , lostPower = power (V.zipWith3 losing patches lengths radiosity)
    }
  where
    w@(BinaryPlaces places) = systemPlaces system
    patches = systemPatches system
    -- Lengths by a power of two.
    longest = maximum (0 : map (halvings . max 0 . snd . enclosureRelative 8 . patchLength) (V.toList patches))
    lengths = V.map (within . enclosure (places - longest) . patchLength) patches
    within (low, high) = between w (max 0 low * powerOfTwo (negate longest), high * powerOfTwo (negate longest))
    emitting patch len = multiple (patchOpen patch) (times w len (patchEmission patch))
    absorbing patch len light = multiple (1 - reflectivity (patchMaterial patch)) (times w len light)
    losing patch len = times w (times w len (patchSky patch))
    power found = let (low, high) = ends w (V.foldl' plus (Interval 0 0) found) in (low * unit, high * unit)
    unit = powerOfTwo (systemScale system + longest)

-- | Emitted is absorbed and lost: the bounds must meet.
--
-- /Laws/ empty for bounds that hold.
balanceViolations :: Balance -> [Violation]
balanceViolations (Balance (low, high) (absorbedLow, absorbedHigh) (lostLow, lostHigh)) =
  ensure "what is emitted is absorbed or lost to the sky" (unlines [emitted, absorbed, lost]) meet
  where
    meet = low <= absorbedHigh + lostHigh && absorbedLow + lostLow <= high
    emitted = "emitted  " <> shown low high
    absorbed = "absorbed " <> shown absorbedLow absorbedHigh
    lost = "lost     " <> shown lostLow lostHigh
    shown a b = show (fromRational a :: Double) <> " to " <> show (fromRational b :: Double)
