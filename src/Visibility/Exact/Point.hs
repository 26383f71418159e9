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
  , Turn (..)
  , pointsOn
  , withArithmetic
  , decidedBy
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

-- | How signs are decided.
data Arithmetic
  = -- | Machine integers where they provably fit, else a floating-point filter with integers behind it. Always right.
    Filtered
  | -- | Integers of any size, always.
    Exact
  | -- | Doubles without a bound. Wrong near degeneracy; exists to be measured.
    UnsafeDouble
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | Where the third of three corners lies, looking from the first to the second.
data Turn = RightTurn | Collinear | LeftTurn
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
  | IntegerKernel
  | -- | x and y of corner i at 2i and 2i+1, rounded.
    DoubleKernel !(U.Vector Double)
  | -- | A function that somebody else gives: the turn from the way between two corners to that between two others.
    GivenKernel !(Int -> Int -> Int -> Int -> Turn)

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

-- | The same corners, with a function in place of 'Visibility.Exact.Predicate.headingTurn': for whoever measures an
-- arithmetic of their own. What is asked of one corner and others comes as @headingTurn a b a c@.
--
-- /Laws/ @headingTurn (decidedBy f p) a b c d == f a b c d@; @decidedBy (headingTurn p) p@ decides as @p@ does.
decidedBy :: (Int -> Int -> Int -> Int -> Turn) -> Points -> Points
decidedBy given points = points {pointsKernel = GivenKernel given}

-- | Exactly where a corner is on the lattice. /Requires/ an index below the number of corners.
pointAt :: Points -> Int -> LatticePoint
pointAt = placeAt . pointPlaces
{-# INLINE pointAt #-}

kernelFor :: Arithmetic -> Places -> Kernel
kernelFor arithmetic places = case arithmetic of
  Exact -> IntegerKernel
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
scaledExactly k x w = if x == 0 then 0 else (x % w) * 2 ^^ negate k

-- | A bound on |x/w·2^−k − d|, d its rounded value. Zero where nothing was rounded. Otherwise u·d·(1 + 2^−50) covers
-- the relative error u = 2^−53 of rounding to nearest (relative to the exact value, hence the slack), and 2^−1070
-- whatever is lost below the normal range.
errorBound :: Int -> Integer -> Integer -> Double -> Double
errorBound k x w d
  | toRational d == scaledExactly k x w = 0
  | otherwise = d * encodeFloat 1 (-53) * (1 + encodeFloat 1 (-50)) + encodeFloat 1 (-1070)
