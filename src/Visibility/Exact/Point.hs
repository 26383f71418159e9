{-# LANGUAGE BangPatterns #-}

-- | Exact coordinates of the corners of a scene, on one integer lattice.
--
-- Rational coordinates are multiplied by one common denominator and moved so that the lower left corner of the bounding
-- box is (0, 0). Nothing is rounded. Where the extent of the lattice proves that determinants fit, the corners are also
-- kept as machine integers; otherwise as Doubles with a bound on each one's error, for the filter of
-- "Visibility.Exact.Predicate".
module Visibility.Exact.Point
  ( -- * Points at the border
    Point (..)
    -- * The lattice
  , Lattice (..)
  , latticeFor
  , latticeScale
  , ontoLattice
  , fromLattice
  , Vector2 (..)
  , difference
    -- * Corners with their arithmetic
  , Arithmetic (..)
  , Points
  , Kernel (..)
  , pointsOn
  , withArithmetic
  , tallied
  , pointAt
  , pointsKernel
  ) where

import Data.Bits (shiftL)
import Data.Int (Int32)
import Data.List (foldl')
import Data.Ratio (denominator, numerator, (%))
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.IntegerRoot (bitLength)
import Visibility.Exact.Tally (Tally)

-- | A point of the plane with exact coordinates, in the units of the file.
data Point = Point !Rational !Rational
  deriving (Eq, Ord, Show)

-- | A point or a displacement of the lattice.
data Vector2 = Vector2 !Integer !Integer
  deriving (Eq, Ord, Show)

-- | @difference a b@ is the displacement from a to b.
difference :: Vector2 -> Vector2 -> Vector2
difference (Vector2 ax ay) (Vector2 bx by) = Vector2 (bx - ax) (by - ay)

-- | A common denominator and the lattice's origin. A file's point (x, y) is (scale·x, scale·y) − origin on the lattice.
data Lattice = Lattice !Integer !Vector2
  deriving (Eq, Show)

-- | The coarsest lattice of this kind that holds all points, its origin at the lower left of their bounding box.
--
-- /Cost/ O(n) multiplications of the coordinates' size.
latticeFor :: [Point] -> Lattice
latticeFor [] = Lattice 1 (Vector2 0 0)
latticeFor points@(Point x0 y0 : _) = Lattice scale (Vector2 (scaled (least fst x0)) (scaled (least snd y0)))
  where
    scale = foldl' (\acc (Point x y) -> acc `lcm` denominator x `lcm` denominator y) 1 points
    least part start = foldl' (\acc (Point x y) -> min acc (part (x, y))) start points
    scaled x = numerator (x * (scale % 1))

-- | Lattice units per unit of the file, at least 1.
latticeScale :: Lattice -> Integer
latticeScale (Lattice scale _) = scale

-- | /Requires/ a point among those the lattice was made for; other points may fall between lattice points and are
-- rounded down, so they must not be asked for.
ontoLattice :: Lattice -> Point -> Vector2
ontoLattice (Lattice scale (Vector2 ox oy)) (Point x y) = Vector2 (whole x - ox) (whole y - oy)
  where
    whole q = numerator q * (scale `div` denominator q)

-- | /Law/ @fromLattice l (ontoLattice l p) == p@.
fromLattice :: Lattice -> Vector2 -> Point
fromLattice (Lattice scale (Vector2 ox oy)) (Vector2 x y) = Point ((x + ox) % scale) ((y + oy) % scale)

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
  { exactPoints :: !(V.Vector Vector2)
  , pointsKernel :: !Kernel
  }

-- | /Requires/ coordinates of a lattice, that is, none negative. /Cost/ O(n).
pointsOn :: Arithmetic -> [Vector2] -> Points
pointsOn arithmetic = fromVector arithmetic . V.fromList

fromVector :: Arithmetic -> V.Vector Vector2 -> Points
fromVector arithmetic exact = Points exact (kernelFor arithmetic exact)

-- | The same corners, decided about in another way.
withArithmetic :: Arithmetic -> Points -> Points
withArithmetic arithmetic = fromVector arithmetic . exactPoints

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

-- | The exact lattice coordinates of a corner. /Requires/ an index below the number of corners.
pointAt :: Points -> Int -> Vector2
pointAt points i = exactPoints points V.! i
{-# INLINE pointAt #-}

kernelFor :: Arithmetic -> V.Vector Vector2 -> Kernel
kernelFor Exact _ = IntegerKernel
kernelFor RationalBaseline exact = RationalKernel (V.map (\(Vector2 x y) -> Point (fromInteger x) (fromInteger y)) exact)
kernelFor UnsafeDouble exact = DoubleKernel (U.fromList (concatMap both (V.toList exact)))
  where
    both (Vector2 x y) = [scaledDouble k x, scaledDouble k y]
    k = binaryOrder exact
kernelFor Filtered exact
  | extent < 1 `shiftL` 31 = MachineKernel (U.fromList (concatMap machine (V.toList exact)))
  | otherwise = FilterKernel (U.fromList (concatMap bounded (V.toList exact)))
  where
    extent = extentOf exact
    orderX = bitLength (V.foldl' (\acc (Vector2 x _) -> max acc x) 0 exact)
    orderY = bitLength (V.foldl' (\acc (Vector2 _ y) -> max acc y) 0 exact)
    machine (Vector2 x y) = [fromInteger x, fromInteger y]
    bounded (Vector2 x y) =
      let !dx = scaledDouble orderX x
          !dy = scaledDouble orderY y
       in [dx, dy, errorBound orderX x dx, errorBound orderY y dy]

-- | The largest coordinate.
extentOf :: V.Vector Vector2 -> Integer
extentOf = V.foldl' (\acc (Vector2 x y) -> acc `max` x `max` y) 0

-- | The least k with all coordinates below 2^k.
binaryOrder :: V.Vector Vector2 -> Int
binaryOrder = bitLength . extentOf

-- | x·2^−k, rounded to nearest; 0 ≤ x < 2^k.
scaledDouble :: Int -> Integer -> Double
scaledDouble k x = fromRational (x % (1 `shiftL` k))

-- | A bound on |x·2^−k − d|, d its rounded value. Zero where nothing was rounded. Otherwise u·d·(1 + 2^−50) covers the
-- relative error u = 2^−53 of rounding to nearest (relative to the exact value, hence the slack), and 2^−1070 whatever
-- is lost below the normal range.
errorBound :: Int -> Integer -> Double -> Double
errorBound k x d
  | toRational d == x % (1 `shiftL` k) = 0
  | otherwise = d * encodeFloat 1 (-53) * (1 + encodeFloat 1 (-50)) + encodeFloat 1 (-1070)
