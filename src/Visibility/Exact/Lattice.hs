-- | Exact coordinates: rationals at the border, integers of one lattice inside.
--
-- Rational coordinates are multiplied by one common denominator and moved so that the lower left corner of the bounding
-- box is (0, 0). Nothing is rounded. A point that needs a denominator beyond the common one has it for itself: break
-- points of a mesh, and the corners of a scene whose common denominator would be far longer than each one's own.
module Visibility.Exact.Lattice
  ( -- * Points at the border
    Point (..)
    -- * The lattice
  , Lattice (..)
  , latticeFor
  , latticeScale
  , ontoLattice
  , fromLattice
    -- * Points of it
  , LatticePoint (..)
  , latticePoint
  , isWhole
  , coordinates
  , comparePlaces
    -- * Ways between them
  , Vector2 (..)
  , towards
  , Way (..)
  , way
    -- * Many points
  , Places (..)
  , placesFrom
  , placesOn
  , placeAt
  , placeCount
  , placeList
  , comparePlacesAt
  , rearranged
  ) where

import Data.Bits (shiftL)
import Data.Foldable (foldlM)
import Data.Int (Int32)
import Data.Maybe (fromMaybe)
import Data.Ratio (denominator, numerator, (%))
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.IntegerRoot (bitLength)

-- | A point of the plane with exact coordinates, in the units of the file.
data Point = Point !Rational !Rational
  deriving (Eq, Ord, Show)

-- | A vector of the lattice.
data Vector2 = Vector2 !Integer !Integer
  deriving (Eq, Ord, Show)

-- | (x, y) / w in units of the lattice: homogeneous coordinates in lowest terms, w > 0. For most points w is 1.
data LatticePoint = LatticePoint !Integer !Integer !Integer
  deriving (Eq, Show)

-- | A scale and the lattice's origin. A file's point (x, y) is (scale·x, scale·y) − origin on the lattice.
data Lattice = Lattice !Integer !Vector2
  deriving (Eq, Show)

-- | The lattice for points, its origin below and to the left of all by less than one of its units. Its scale is the
-- least common denominator of all coordinates, or 1 where that would be far longer than the longest denominator of a
-- point.
--
-- /Cost/ O(n) multiplications of the coordinates' size.
latticeFor :: [Point] -> Lattice
latticeFor [] = Lattice 1 (Vector2 0 0)
latticeFor points = Lattice scale (Vector2 (below [x | Point x _ <- points]) (below [y | Point _ y <- points]))
  where
    below values = floor (minimum values * (scale % 1))
    scale = fromMaybe 1 (foldlM common 1 points)
    longest = maximum (map (bitLength . ownDenominator) points)
    common found point
      | own == 1 = Just found
      | bitLength found' > 64 + 4 * longest = Nothing
      | otherwise = Just found'
      where
        own = ownDenominator point
        found' = found `lcm` own

ownDenominator :: Point -> Integer
ownDenominator (Point x y)
  | denominator x == 1 = denominator y
  | otherwise = denominator x `lcm` denominator y

-- | Lattice units per unit of the file, at least 1.
latticeScale :: Lattice -> Integer
latticeScale (Lattice scale _) = scale

-- | Where a point of the file lies on the lattice.
ontoLattice :: Lattice -> Point -> LatticePoint
ontoLattice (Lattice scale (Vector2 ox oy)) (Point x y)
  | restX == 0 && restY == 0 = LatticePoint (numerator x * wholeX - ox) (numerator y * wholeY - oy) 1
  | otherwise = latticePoint (scale % 1 * x - ox % 1) (scale % 1 * y - oy % 1)
  where
    (wholeX, restX) = scale `quotRem` denominator x
    (wholeY, restY) = scale `quotRem` denominator y

-- | /Law/ @fromLattice l (ontoLattice l p) == p@.
fromLattice :: Lattice -> LatticePoint -> Point
fromLattice (Lattice scale (Vector2 ox oy)) (LatticePoint x y w) =
  Point ((x + ox * w) % (scale * w)) ((y + oy * w) % (scale * w))

-- | The point with these coordinates on the lattice.
latticePoint :: Rational -> Rational -> LatticePoint
latticePoint x y = LatticePoint (whole x) (whole y) w
  where
    w = denominator x `lcm` denominator y
    whole q = numerator q * (w `quot` denominator q)

-- | Does the point lie on the lattice itself, rather than between its points?
isWhole :: LatticePoint -> Bool
isWhole (LatticePoint _ _ w) = w == 1

-- | The coordinates in units of the lattice.
coordinates :: LatticePoint -> (Rational, Rational)
coordinates (LatticePoint x y w) = (x % w, y % w)

-- | Lexicographic order, by x and then by y.
comparePlaces :: LatticePoint -> LatticePoint -> Ordering
comparePlaces (LatticePoint x y w) (LatticePoint x' y' w')
  | w == w' = compare x x' <> compare y y'
  | otherwise = compare (x * w') (x' * w) <> compare (y * w') (y' * w)

-- | A vector from the first point in the direction of the second: a positive multiple of the way, the way itself where
-- both are whole.
towards :: LatticePoint -> LatticePoint -> Vector2
towards (LatticePoint ax ay aw) (LatticePoint bx by bw)
  | aw == bw = Vector2 (bx - ax) (by - ay)
  | otherwise = Vector2 (bx * aw - ax * bw) (by * aw - ay * bw)
{-# INLINE towards #-}

-- | A displacement: an integer vector divided by a positive integer.
data Way = Way !Vector2 !Integer
  deriving (Eq, Show)

-- | The displacement from the first point to the second. Not in lowest terms.
way :: LatticePoint -> LatticePoint -> Way
way a@(LatticePoint _ _ aw) b@(LatticePoint _ _ bw) = Way (towards a b) (if aw == bw then aw else aw * bw)

-- | Points by index.
data Places
  = -- | x and y of point i at 2i and 2i+1: whole points with coordinates in [0, 2^31).
    SmallPlaces !(U.Vector Int32)
  | LargePlaces !(V.Vector LatticePoint)

-- | /Cost/ O(n).
placesFrom :: [LatticePoint] -> Places
placesFrom points
  | all isSmall points =
      SmallPlaces (U.fromList (concat [[fromInteger x, fromInteger y] | LatticePoint x y _ <- points]))
  | otherwise = LargePlaces (V.fromList points)
  where
    isSmall (LatticePoint x y w) = w == 1 && inRange x && inRange y
    inRange v = v >= 0 && v < 1 `shiftL` 31

-- | The places of a file's points.
placesOn :: Lattice -> [Point] -> Places
placesOn lattice = placesFrom . map (ontoLattice lattice)

-- | /Requires/ an index below the number of points.
placeAt :: Places -> Int -> LatticePoint
placeAt (SmallPlaces xs) i = LatticePoint (fromIntegral (xs U.! (2 * i))) (fromIntegral (xs U.! (2 * i + 1))) 1
placeAt (LargePlaces points) i = points V.! i
{-# INLINE placeAt #-}

-- | The number of points.
placeCount :: Places -> Int
placeCount (SmallPlaces xs) = U.length xs `quot` 2
placeCount (LargePlaces points) = V.length points

-- | All points in order.
placeList :: Places -> [LatticePoint]
placeList places = map (placeAt places) [0 .. placeCount places - 1]

-- | The order of two of them.
comparePlacesAt :: Places -> Int -> Int -> Ordering
comparePlacesAt (SmallPlaces xs) i j =
  compare (xs U.! (2 * i)) (xs U.! (2 * j)) <> compare (xs U.! (2 * i + 1)) (xs U.! (2 * j + 1))
comparePlacesAt (LargePlaces points) i j = comparePlaces (points V.! i) (points V.! j)
{-# INLINE comparePlacesAt #-}

-- | The points at these indices.
rearranged :: U.Vector Int32 -> Places -> Places
rearranged indices places = case places of
  SmallPlaces xs -> SmallPlaces (U.generate (2 * U.length indices) (\k -> xs U.! (2 * index (k `quot` 2) + k `rem` 2)))
  LargePlaces points -> LargePlaces (V.generate (U.length indices) (\k -> points V.! index k))
  where
    index k = fromIntegral (indices U.! k)
