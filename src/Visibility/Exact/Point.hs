{-# LANGUAGE BangPatterns #-}

-- | The corners of a scene with the arithmetic that decides about them.
--
-- Where the extent of the lattice proves that determinants fit, decisions are made in machine integers; otherwise in
-- Doubles with a bound on each one's error, for the filter of "Visibility.Exact.Predicate".
module Visibility.Exact.Point
  ( -- * Corners with their arithmetic
    Arithmetic (..)
  , Points
  , Kernel (..)
  , pointsOn
  , withArithmetic
  , tallied
  , pointAt
  , pointsKernel
  , pointPlaces
    -- * Where they are
  , module Visibility.Exact.Lattice
  ) where

import Data.Int (Int32)
import Data.Ratio ((%))
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.IntegerRoot (bitLength)
import Visibility.Exact.Lattice
import Visibility.Exact.Tally (Tally)

-- | How signs are decided.
data Arithmetic
  = -- | Machine integers where they provably fit, else a floating-point filter with integers behind it. Always right.
    Filtered
  | -- | Integers of any size, always.
    Exact
  | -- | Doubles without a bound. Wrong near degeneracy; exists to be measured.
    UnsafeDouble
  | -- | Rationals without a lattice's advantages: what a first attempt would do. Right, and there to be measured.
    RationalBaseline
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | What the predicates compute with.
data Kernel
  = -- | x and y of corner i at 2i and 2i+1. All lie in [0, 2^31), so that a difference is below 2^31 in size, a product
    -- of two below 2^62, and the difference of two products below 2^63: nothing overflows in 64 bits.
    MachineKernel !(U.Vector Int32)
  | -- | x, y, error of x, error of y of corner i from 4i on. Each error bounds |coordinate·2^−k − its Double|, for the
    -- one k for all x, and the one for all y, that brings them below 1; the Doubles are at most 1. Signs of
    -- determinants do not change when an axis is scaled.
    FilterKernel !(U.Vector Double)
  | -- | As for the filter, whose signs are counted.
    TallyKernel !Tally !(U.Vector Double)
  | IntegerKernel
  | -- | x and y of corner i at 2i and 2i+1, rounded.
    DoubleKernel !(U.Vector Double)
  | RationalKernel !(V.Vector Point)

-- | Corners by index, with the arithmetic that decides about them.
data Points = Points
  { pointPlaces :: !Places
  -- ^ Exactly where they are.
  , pointsKernel :: !Kernel
  }

-- | /Requires/ places of a lattice, that is, no coordinate negative. /Cost/ O(n).
pointsOn :: Arithmetic -> Places -> Points
pointsOn arithmetic places = Points places (kernelFor arithmetic places)

-- | The same corners, decided about in another way.
withArithmetic :: Arithmetic -> Points -> Points
withArithmetic arithmetic = pointsOn arithmetic . pointPlaces

-- | The same corners, the signs that their filter decides being counted; 'Nothing' where no filter decides.
--
-- /Laws/ every predicate has the same value.
tallied :: Tally -> Points -> Maybe Points
tallied tally points = case pointsKernel points of
  FilterKernel xs -> Just points {pointsKernel = TallyKernel tally xs}
  TallyKernel _ xs -> Just points {pointsKernel = TallyKernel tally xs}
  MachineKernel _ -> Nothing
  IntegerKernel -> Nothing
  DoubleKernel _ -> Nothing
  RationalKernel _ -> Nothing

-- | Exactly where a corner is on the lattice. /Requires/ an index below the number of corners.
pointAt :: Points -> Int -> LatticePoint
pointAt = placeAt . pointPlaces
{-# INLINE pointAt #-}

kernelFor :: Arithmetic -> Places -> Kernel
kernelFor arithmetic places = case arithmetic of
  Exact -> IntegerKernel
  RationalBaseline -> RationalKernel (V.fromList [let (x, y) = coordinates p in Point x y | p <- placeList places])
  UnsafeDouble ->
    DoubleKernel $
      U.fromList (concat [[scaledDouble k x w, scaledDouble k y w] | LatticePoint x y w <- placeList places])
  Filtered -> case places of
    SmallPlaces xs -> MachineKernel xs
    LargePlaces points -> FilterKernel (U.fromList (concatMap bounded (V.toList points)))
  where
    k = max orderX orderY
    orderX = binaryOrder [(x, w) | LatticePoint x _ w <- placeList places]
    orderY = binaryOrder [(y, w) | LatticePoint _ y w <- placeList places]
    bounded (LatticePoint x y w) =
      let !dx = scaledDouble orderX x w
          !dy = scaledDouble orderY y w
       in [dx, dy, errorBound orderX x w dx, errorBound orderY y w dy]

-- | A k with all x/w below 2^k, and the least such for integers. It may be negative.
binaryOrder :: [(Integer, Integer)] -> Int
binaryOrder = maximum . (minBound `div` 2 :) . map order
  where
    order (0, _) = minBound `div` 2
    order (x, w) = bitLength x - bitLength w + 1

-- | x/w·2^−k, rounded to nearest; 0 ≤ x/w < 2^k.
scaledDouble :: Int -> Integer -> Integer -> Double
scaledDouble k x w = fromRational (scaledExactly k x w)

scaledExactly :: Int -> Integer -> Integer -> Rational
scaledExactly _ 0 _ = 0
scaledExactly k x w
  | k >= 0 = x % (w * 2 ^ k)
  | otherwise = (x * 2 ^ negate k) % w

-- | A bound on |x/w·2^−k − d|, d its rounded value. Zero where nothing was rounded. Otherwise u·d·(1 + 2^−50) covers
-- the relative error u = 2^−53 of rounding to nearest (relative to the exact value, hence the slack), and 2^−1070
-- whatever is lost below the normal range.
errorBound :: Int -> Integer -> Integer -> Double -> Double
errorBound k x w d
  | toRational d == scaledExactly k x w = 0
  | otherwise = d * encodeFloat 1 (-53) * (1 + encodeFloat 1 (-50)) + encodeFloat 1 (-1070)
