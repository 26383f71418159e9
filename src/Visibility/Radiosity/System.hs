{-# LANGUAGE BangPatterns #-}

-- | The equations of radiosity of a scene: elements, and the light that goes from one to another.
module Visibility.Radiosity.System
  ( -- * The system
    System (..)
  , Patch (..)
    -- ** The matrix
  , Matrix (..)
  , Precision (..)
  , rowDot
    -- * From form factors
  , fromNearest
  , fromExact
  ) where

import Control.Monad.ST (ST)
import Data.Bits (shiftL)
import Data.Int (Int32)
import Data.List (foldl', scanl')
import qualified Data.IntSet as IntSet
import qualified Data.Map.Strict as Map
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.IntegerRoot (bitLength)
import Visibility.Exact.Interval
import Visibility.Exact.RootSum (RootSum)
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.FormFactor
import Visibility.Law (broken)
import Visibility.Mesh.Element
import Visibility.Scene
import Visibility.Scene.Raw (Material (..))

-- Note [Radiosity of sides that are covered in part]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
-- Light leaves and reaches only the part u of an element that nothing covers; radiosity B, emission E and incident
-- light H are per unit of that length. F_ij is A(i, j) / (2 L_i) with the whole length L_i, so what reaches i is
-- Σ L_j F_ji B_j = L_i Σ F_ij B_j = u_i L_i H_i by reciprocity: H_i = Σ F_ij B_j / u_i. So
--   B_i = E_i + (ρ_i / u_i) Σ F_ij B_j.
-- ρ/u is the /gain/. The sum of the factors of a row is u, the sky's among them; gain times the sum is ρ < 1 at most,
-- whatever is covered. With powers P_i = u_i L_i: Σ P E = Σ P (1 − ρ) H + Σ L F_sky B, emitted = absorbed + lost.
-- Where all of an element is covered it has no factors; its gain is taken as 0, its radiosity is its emission, and it
-- counts for nothing.

-- | What the equations say of one element.
data Patch = Patch
  { patchElement :: !Element
  , patchMaterial :: !Material
  , patchOpen :: !Rational
  -- ^ The part of it that nothing covers, from 0 to 1.
  , patchLength :: RootSum
  -- ^ Its whole length, in the file's units.
  , patchGain :: !Rational
  -- ^ Reflectivity by the part that is not covered.
  , patchEmission :: !Interval
  -- ^ Emission, in units of the system.
  , patchSky :: !Interval
  -- ^ The form factor to the sky.
  }

-- | Equations B = E + gain · F B in units of 2^(scale − places).
data System = System
  { systemPlaces :: !BinaryPlaces
  , systemScale :: !Int
  -- ^ Emissions are divided by this power of two, and are then below 1.
  , systemPatches :: !(V.Vector Patch)
  , systemMatrix :: !Matrix
  , systemLit :: !(U.Vector Bool)
  -- ^ Which elements light leaves at all, that is, which radiosities are not exactly zero.
  , systemReached :: !(U.Vector Bool)
  -- ^ Which elements light reaches at all.
  }

-- | The form factors between elements that are not exactly zero, by rows.
data Matrix = Matrix
  { rowStarts :: !(U.Vector Int)
  -- ^ Where each row begins in the tables that follow; then their length.
  , columns :: !(U.Vector Int32)
  , factorDoubles :: !(U.Vector Double)
  -- ^ Doubles x with F <= x (1 + 2^−52) + 2^−1074.
  , factorPrecision :: !Precision
  }

-- | What is known of the factors.
data Precision
  = -- | The Doubles are the nearest ones.
    CorrectlyRounded
  | -- | Each is from this integer to 2 more, in units.
    Enclosed !(V.Vector Integer)

-- | The elements that an element sees.
rowColumns :: Matrix -> Int -> U.Vector Int32
rowColumns matrix i = U.slice start (rowStarts matrix U.! (i + 1) - start) (columns matrix)
  where
    start = rowStarts matrix U.! i

-- | A row of the matrix by a vector.
rowDot :: Matrix -> M.STVector s Double -> Int -> ST s Double
rowDot matrix x i = go (rowStarts matrix U.! i) 0
  where
    end = rowStarts matrix U.! (i + 1)
    go !k !total
      | k == end = pure total
      | otherwise = do
          value <- M.read x (fromIntegral (columns matrix U.! k))
          go (k + 1) (total + factorDoubles matrix U.! k * value)
{-# INLINE rowDot #-}

-- | The equations with form factors as Doubles.
--
-- /Requires/ one element for every side of the scene. /Cost/ O(factors + n log n).
fromNearest :: BinaryPlaces -> Refined -> [FactorRow Double] -> System
fromNearest places cut rows =
  assembled places cut known bounds (\entries -> (U.fromList entries, CorrectlyRounded))
  where
    bounds x = (toRational x * (1 - slack) - least, toRational x * (1 + slack) + least)
    known = Map.fromList [(rowFrom row, rowFactors row) | row <- rows]
    -- |F − x| <= 2^-53 F, or 2^-1075 below the range of normal Doubles.
    slack = powerOfTwo (-52)
    least = powerOfTwo (-1074)

-- | The equations with form factors to so many places.
--
-- /Requires/ one element for every side of the scene. /Cost/ O(n log n) and an enclosure for each term of each factor.
fromExact :: BinaryPlaces -> Refined -> [FormFactor] -> System
fromExact places@(BinaryPlaces w) cut factors =
  assembled places cut known id $ \entries ->
    let lower = V.fromList [low | Interval low _ <- map (between places) entries]
     in (U.convert (V.map (upperDouble . (+ 2)) lower), Enclosed lower)
  where
    known =
      Map.fromListWith
        (flip (<>))
        [(factorFrom f, [(factorTo f, RootSum.enclosure w (factorValue f))]) | f <- factors]
    -- At least the number of units; it is at most 2^53 that is kept.
    upperDouble m = let k = max 0 (bitLength m - 53) in encodeFloat (up m k) (k - w)
    up m k = let unit = 1 `shiftL` k in (m + unit - 1) `div` unit

-- | The tables, from factors by what they leave; with bounds of a factor and a way to keep them.
assembled
  :: BinaryPlaces
  -> Refined
  -> Map.Map SideName [(Seen, a)]
  -> (a -> (Rational, Rational))
  -> ([a] -> (U.Vector Double, Precision))
  -> System
assembled places (Refined scene elements) known bounds kept =
  System
    { systemPlaces = places
    , systemScale = scale
    , systemPatches = V.fromList patches
    , systemMatrix = matrix
    , systemLit = leaving
    , systemReached = U.generate (length patches) (U.any ((leaving U.!) . fromIntegral) . rowColumns matrix)
    }
  where
    leaving = lit matrix patches
    numbers = Map.fromList (zip (map elementIn elements) [0 ..])
    rows = [Map.findWithDefault [] (elementIn e) known | e <- elements]
    entries = [[(number name, x) | (TheSide name, x) <- row] | row <- rows]
    number name = case Map.lookup name numbers of
      Just i -> i
      Nothing -> broken "every side of a refined scene is an element" (sideText name)
    matrix = Matrix (U.fromList (scanl' (+) 0 (map length entries))) (U.fromList (map fst found)) doubles precision
    (doubles, precision) = kept (map snd found)
    found = concat entries
    materials = map (statedMaterial scene . elementIn) elements
    scale = halvings (maximum (0 : map emission materials))
    patches = zipWith3 patch elements materials rows
    patch element material row =
      Patch
        { patchElement = element
        , patchMaterial = material
        , patchOpen = open
        , patchLength = sideLength scene (elementIn element)
        , patchGain = if open == 0 then 0 else reflectivity material / open
        , patchEmission = around places (emission material * powerOfTwo (negate scale))
        , patchSky = foldl' plus (Interval 0 0) [between places (bounds x) | (TheSky, x) <- row]
        }
      where
        open = uncovered scene (elementIn element)

-- | What emits, and what reflects and sees what is lit. A factor is not zero exactly if its reverse is not.
lit :: Matrix -> [Patch] -> U.Vector Bool
lit matrix patches = U.generate (length patches) (`IntSet.member` spread emitting emitting)
  where
    emitting = IntSet.fromList [i | (i, p) <- zip [0 ..] patches, emission (patchMaterial p) > 0]
    reflecting = U.fromList (map ((> 0) . patchGain) patches)
    spread found new
      | IntSet.null new = found
      | otherwise = spread (IntSet.union found next) next
      where
        next =
          IntSet.fromList
            [ j
            | i <- IntSet.toList new
            , j <- map fromIntegral (U.toList (rowColumns matrix i))
            , reflecting U.! j
            , j `IntSet.notMember` found
            ]
