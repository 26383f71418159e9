-- | Radiosity of a scene: B = E + ρ F B, each number within proved bounds.
module Visibility.Radiosity
  ( -- * What is asked for
    Closeness (..)
  , Tolerance
  , tolerance
  , toleranceValue
  , defaultTolerance
    -- * What is found
  , Radiosity (..)
  , Lit (..)
  , Shortfall (..)
  , radiosity
  , radiosityOfElements
    -- * Energy
  , Balance (..)
  , balanceViolations
  ) where

import Data.Foldable (for_)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.IntegerRoot (bitLength)
import Visibility.Exact.Interval
import Visibility.Exact.RootSum (enclosure, enclosureRelative)
import Visibility.Exact.Rounding (Digits, digitCount, digits, defaultDigits)
import Visibility.FormFactor
import Visibility.Law (Violation (..), broken, ensure)
import Visibility.Mesh.Element
import Visibility.Radiosity.Certificate
import Visibility.Radiosity.Solve
import Visibility.Radiosity.System
import Visibility.Scene hiding (PolygonId (..))
import Visibility.Scene.Raw (Material (..))

-- | How close bounds must be to each other, and from which form factors they are found.
data Closeness
  = -- | For every element at most this part of the largest radiosity of the scene; with form factors as the nearest
    -- Doubles.
    WithinTolerance !Tolerance
  | -- | Ten times closer than so many digits of the largest radiosity; with form factors as exact sums of roots. For
    -- small scenes: each costs a root for each of its terms.
    ToDigits !Digits
  deriving (Eq, Show)

-- | A part of the largest radiosity, between 0 and 1.
newtype Tolerance = Tolerance Rational
  deriving (Eq, Ord, Show)

-- | The smart constructor: 'Nothing' unless between 0 and 1.
tolerance :: Rational -> Maybe Tolerance
tolerance x = if x > 0 && x < 1 then Just (Tolerance x) else Nothing

toleranceValue :: Tolerance -> Rational
toleranceValue (Tolerance x) = x

-- | 10^−9.
defaultTolerance :: Tolerance
defaultTolerance = Tolerance (1 / 10 ^ (9 :: Int))

-- | The radiosities of a scene. Shown as @\<radiosity: 12 elements, 9 passes\>@.
data Radiosity = Radiosity
  { litElements :: ![Lit]
  , sideAverages :: ![(SideName, (Rational, Rational))]
  -- ^ For each side of the file, the mean of the radiosities of its elements by the lengths that are not covered.
  , energy :: !Balance
  , passCount :: !Int
  -- ^ How often Gauss–Seidel went through the matrix.
  , nonzeroFactors :: !Int
  -- ^ How many form factors between elements are not zero, of as many as there are pairs of elements.
  , worthyDigits :: !Digits
  -- ^ How many significant digits bounds are to be written with, so that rounding them outwards does not count.
  }

instance Show Radiosity where
  show found =
    "<radiosity: " <> show (length (litElements found)) <> " elements, " <> show (passCount found) <> " passes>"

-- | An element with bounds of its radiosity, which is per unit of the length that is not covered.
data Lit = Lit
  { litElement :: !Element
  , litMaterial :: !Material
  , litOpen :: !Rational
  -- ^ The part of it that nothing covers.
  , litRadiosity :: !(Rational, Rational)
  }
  deriving (Eq, Show)

-- | The radiosities of the sides of a scene, each an element.
radiosity :: Closeness -> Scene -> Measures -> Either Shortfall Radiosity
radiosity closeness = radiosityOfElements closeness . unrefined

-- | The radiosities of the elements of a mesh. The measures are those of the scene in which they are the sides.
--
-- /Degenerate cases/ an element that others cover in part counts for the part that is free, see Note [Radiosity of
-- sides that are covered in part]; one that is all covered has its emission as radiosity. An element that no light
-- leaves has exactly 0.
--
-- /Cost/ O(factors) for each pass of Gauss–Seidel, and one product
-- of integers per factor for each round of correction.
--
-- /Laws/ bounds enclose the solution of B = E + ρ F B with the exact form factors. What is emitted is absorbed or lost
-- to the sky, within the bounds; else a law is broken.
radiosityOfElements :: Closeness -> Refined -> Measures -> Either Shortfall Radiosity
radiosityOfElements closeness cut@(Refined scene elements) sums = do
  Solution bounds passes <- solve target system
  let balance = balanceOf system bounds
  for_ (take 1 (balanceViolations balance)) $ \(Violation law details) -> broken law details
  let unit = powerOfTwo (systemScale system)
      lit patch within =
        let (low, high) = ends (systemPlaces system) within
         in Lit (patchElement patch) (patchMaterial patch) (patchOpen patch) (low * unit, high * unit)
      found = zipWith lit (V.toList (systemPatches system)) (V.toList (radiosityWithin bounds))
  Right
    Radiosity
      { litElements = found
      , sideAverages = averages found
      , energy = balance
      , passCount = passes
      , nonzeroFactors = U.length (columns (systemMatrix system))
      , worthyDigits = shownDigits
      }
  where
    least = minimum (1 : [1 - reflectivity (statedMaterial scene (elementIn e)) | e <- elements])
    -- Roundings of single units grow by the number of elements, and by how often light is reflected.
    placesFor bits = BinaryPlaces (bits + bitLength (toInteger (length elements)) + 2 * bitLength (ceiling (1 / least)))
    (system, target, shownDigits) = case closeness of
      WithinTolerance (Tolerance x) ->
        (fromNearest (placesFor 128) cut (nearestFactors scene sums), x * 9 / 10, digitsFor x)
      ToDigits wanted ->
        ( fromExact (placesFor (10 * digitCount wanted `quot` 3 + 48)) cut (formFactors scene sums)
        , 1 / 10 ^ (digitCount wanted + 1)
        , wanted
        )

-- | So many digits that an outward rounding of both ends costs less than a tenth of the tolerance.
digitsFor :: Rational -> Digits
digitsFor x = fromMaybe defaultDigits (digits (length (takeWhile (< 20 / x) (iterate (* 10) 1)) + 1))

averages :: [Lit] -> [(SideName, (Rational, Rational))]
averages found = Map.toAscList (Map.map mean (Map.fromListWith (<>) [(elementSide (litElement l), [l]) | l <- found]))
  where
    mean group =
      let total = sum (map free group)
          weights = if total > 0 then map free group else map whole group
          by pick = sum (zipWith (\w l -> w * pick (litRadiosity l)) weights group) / sum weights
       in (by fst, by snd)
    free l = whole l * litOpen l
    whole l = elementTo (litElement l) - elementFrom (litElement l)

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
balanceOf system (Enclosure leaving arriving) =
  Balance
    { emittedPower = power (V.zipWith emitting patches lengths)
    , absorbedPower = power (V.zipWith3 absorbing patches lengths arriving)
    , lostPower = power (V.zipWith3 losing patches lengths leaving)
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
