{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE HexFloatLiterals #-}

-- | Every sign decision of the project. Nothing else compares determinants.
--
-- The laws of 'turn', tested for every exact arithmetic: cyclic, antisymmetric, 'Collinear' for two equal arguments,
-- invariant under translation and positive scaling of the lattice, and equal to the sign of the integer determinant.
-- What is /not/ a law: transitivity (being left of something is no order).
module Visibility.Exact.Predicate
  ( -- * Turns of corners
    Turn (..)
  , turn
  , machineTurn
  , opposite
  , turnOrder
    -- * Turns of headings
  , headingTurn
  , filterTurn
    -- * Turns and order of directions
  , Direction (..)
  , direction
  , directionTurn
  , compareDirections
  , upwards
  , primitive
  , reversed
    -- * Arcs of directions
  , insideArc
  ) where

import Data.Int (Int64)
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.Point

-- | The order of two directions from the turn between them: of what is within half a turn, left comes later.
turnOrder :: Turn -> Ordering
turnOrder LeftTurn = LT
turnOrder Collinear = EQ
turnOrder RightTurn = GT
{-# INLINE turnOrder #-}

-- | The other way round; 'Collinear' stays.
opposite :: Turn -> Turn
opposite RightTurn = LeftTurn
opposite Collinear = Collinear
opposite LeftTurn = RightTurn
{-# INLINE opposite #-}

-- | @turn points a b c@ tells on which side of the directed line from a to b the corner c lies.
--
-- /Degenerate cases/ 'Collinear' exactly when the three corners are on one line, also when some coincide.
--
-- /Cost/ O(1) in machine integers or where the filter decides, else one determinant of integers.
--
-- /Laws/ @turn p a b c == turn p b c a == opposite (turn p b a c)@.
turn :: Points -> Int -> Int -> Int -> Turn
turn points a b = headingTurn points a b a
{-# INLINE turn #-}

-- | @headingTurn points a b c d@ is the turn from the direction a to b to the direction c to d.
--
-- /Degenerate cases/ 'Collinear' for parallel directions, equal or opposed, and where a coincides with b or c with d.
--
-- /Cost/ that of 'turn'.
--
-- /Laws/ @headingTurn p a b c d == opposite (headingTurn p c d a b) == opposite (headingTurn p b a c d)@;
-- @headingTurn p a b a c == turn p a b c@.
headingTurn :: Points -> Int -> Int -> Int -> Int -> Turn
headingTurn points a b c d = case pointsKernel points of
  MachineKernel xs ->
    let x i = fromIntegral (xs U.! (2 * i))
        y i = fromIntegral (xs U.! (2 * i + 1))
     in machineHeadingTurn (x b - x a) (y b - y a) (x d - x c) (y d - y c)
  _ -> otherTurn points a b c d
{-# INLINE headingTurn #-}

-- | 'headingTurn' under all other kernels, kept out of the code that is inlined at every call. Were it lazy in the
-- corners, as a given function may be, the sweep would allocate their numbers for each turn.
otherTurn :: Points -> Int -> Int -> Int -> Int -> Turn
otherTurn points !a !b !c !d = case pointsKernel points of
  DoubleKernel xs -> doubleTurn xs a b c d
  MachineKernel _ -> integerTurn points a b c d
  FilterKernel xs -> filteredTurn points xs a b c d
  GivenKernel given -> given a b c d
  IntegerKernel -> integerTurn points a b c d
{-# NOINLINE otherTurn #-}

-- | The turn at the second of three corners, given by the numbers of a 'MachineKernel', from the way to it from the
-- first one to the way from the first to the third.
--
-- /Requires/ numbers in [0, 2^31): then every intermediate value is within 64 bits.
machineTurn :: Int64 -> Int64 -> Int64 -> Int64 -> Int64 -> Int64 -> Turn
machineTurn ax ay bx by cx cy = machineHeadingTurn (bx - ax) (by - ay) (cx - ax) (cy - ay)
{-# INLINE machineTurn #-}

-- The same of two displacements, below 2^31 in size.
machineHeadingTurn :: Int64 -> Int64 -> Int64 -> Int64 -> Turn
machineHeadingTurn x1 y1 x2 y2 = signTurn (x1 * y2 - y1 * x2)
{-# INLINE machineHeadingTurn #-}

-- Note [The filter's bound]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~
-- Write u = 2^-53. Each stored coordinate â has |a - â| <= e(a), with e(a) stored. For a difference D = b - a, the
-- Double D̂ = fl(b̂ - â) satisfies |D - D̂| <= E := e(a) + e(b) + u|D̂| (subtraction cannot underflow).
-- For a product P = D1·D2 and P̂ = fl(D̂1·D̂2): |P - P̂| <= |D̂1|E2 + |D̂2|E1 + E1E2 + u|P̂| + 2^-1074.
-- The determinant is P1 - P2, computed with one more rounding of at most u|det^|. The sum of these terms, without the
-- two 2^-1074, is computed as the bound.
-- It is itself computed in fewer than forty operations on non-negative Doubles, each with relative error at most u or
-- an absolute loss of 2^-1074 by underflow; all Doubles are at most 1, so nothing overflows. The factor 1 + 2^-40 and
-- the summand 2^-1000 dominate those losses and the two 2^-1074. So a computed |det^| above the computed bound has the
-- sign of the determinant.

-- | The turn, if the filter is sure of it. It can be sure of a left or a right turn only: 'Collinear' means that it is
-- not.
certainTurn :: U.Vector Double -> Int -> Int -> Int -> Int -> Turn
certainTurn xs a b c d
  | det > bound = LeftTurn
  | det < negate bound = RightTurn
  | otherwise = Collinear
  where
    coordinate i k = xs U.! (4 * i + k)
    between i j k = coordinate j k - coordinate i k
    loss i j k delta = coordinate i (k + 2) + coordinate j (k + 2) + unitRoundoff * abs delta
    !dx1 = between a b 0
    !dy1 = between a b 1
    !dx2 = between c d 0
    !dy2 = between c d 1
    !ex1 = loss a b 0 dx1
    !ey1 = loss a b 1 dy1
    !ex2 = loss c d 0 dx2
    !ey2 = loss c d 1 dy2
    !left = dx1 * dy2
    !right = dy1 * dx2
    !det = left - right
    product' p e q f = abs p * f + abs q * e + e * f
    !bound =
      ( product' dx1 ex1 dy2 ey2
          + product' dy1 ey1 dx2 ex2
          + unitRoundoff * (abs left + abs right + abs det)
      )
        * (1 + 0x1p-40)
        + 0x1p-1000
    unitRoundoff = 0x1p-53
{-# INLINE certainTurn #-}

filteredTurn :: Points -> U.Vector Double -> Int -> Int -> Int -> Int -> Turn
filteredTurn points xs a b c d = case certainTurn xs a b c d of
  Collinear | mayDiffer a b c d -> integerTurn points a b c d
  known -> known
{-# NOINLINE filteredTurn #-}

-- | What the filter alone says of a 'headingTurn': 'Nothing' where it leaves the answer to integers, or where no filter
-- decides.
filterTurn :: Points -> Int -> Int -> Int -> Int -> Maybe Turn
filterTurn points a b c d = case pointsKernel points of
  FilterKernel xs -> case certainTurn xs a b c d of
    Collinear | mayDiffer a b c d -> Nothing
    known -> Just known
  _ -> Nothing

-- | False for headings that are collinear by their corners alone: one has no length, or both join the same two
-- corners. The sweeps ask such questions, and without this they would all be left to integers.
mayDiffer :: Int -> Int -> Int -> Int -> Bool
mayDiffer a b c d = a /= b && c /= d && (a /= c || b /= d) && (a /= d || b /= c)
{-# INLINE mayDiffer #-}

integerTurn :: Points -> Int -> Int -> Int -> Int -> Turn
integerTurn points a b c d = directionTurn (along a b) (along c d)
  where
    along = direction points

{-# NOINLINE integerTurn #-}

doubleTurn :: U.Vector Double -> Int -> Int -> Int -> Int -> Turn
doubleTurn xs a b c d = signTurn ((x b - x a) * (y d - y c) - (y b - y a) * (x d - x c))
  where
    x i = xs U.! (2 * i)
    y i = xs U.! (2 * i + 1)

{-# NOINLINE doubleTurn #-}

signTurn :: (Ord a, Num a) => a -> Turn
signTurn det
  | det > 0 = LeftTurn
  | det < 0 = RightTurn
  | otherwise = Collinear
{-# INLINE signTurn #-}

-- | An exact vector (dx, dy) whose length does not matter; of a line: dx > 0, or dx = 0 < dy.
data Direction = Direction !Integer !Integer
  deriving (Eq, Ord, Show)

-- | The direction from one corner to another.
direction :: Points -> Int -> Int -> Direction
direction points a b = Direction x y
  where
    Vector2 x y = towards (pointAt points a) (pointAt points b)

-- | 'LeftTurn' when the second direction is reached from the first by turning left by less than 180°.
-- 'Collinear' for parallel directions, equal or opposed.
directionTurn :: Direction -> Direction -> Turn
directionTurn (Direction ax ay) (Direction bx by) = signTurn (ax * by - ay * bx)

-- | Order by angle of the directions of lines, from just above −90° up to 90°.
--
-- /Requires/ both right-going: dx > 0, or dx = 0 < dy. Angles are never computed.
compareDirections :: Direction -> Direction -> Ordering
compareDirections a b = turnOrder (directionTurn a b)

-- | 90°, the last direction of the half turn.
upwards :: Direction
upwards = Direction 0 1

-- | The same direction in lowest terms.
primitive :: Direction -> Direction
primitive (Direction x y) = let g = max 1 (gcd x y) in Direction (x `quot` g) (y `quot` g)

-- | The opposite direction.
reversed :: Direction -> Direction
reversed (Direction x y) = Direction (negate x) (negate y)

-- | Is a direction inside the open arc from one direction counter-clockwise to another? Given is the turn from one
-- direction to another; of two directions that are parallel, the arc is half a turn.
insideArc :: (a -> a -> Turn) -> (a, a) -> a -> Bool
insideArc to (a, b) c = case to a b of
  LeftTurn -> to a c == LeftTurn && to c b == LeftTurn
  Collinear -> to a c == LeftTurn
  RightTurn -> not (to b c /= RightTurn && to c a /= RightTurn)
{-# INLINE insideArc #-}
