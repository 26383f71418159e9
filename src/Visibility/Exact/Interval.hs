-- | Intervals of numbers with so many binary places: sums, products and multiples, rounded outwards.
module Visibility.Exact.Interval
  ( BinaryPlaces (..)
  , Interval (..)
    -- * From rationals and back
  , around
  , between
  , ends
    -- * Arithmetic
  , plus
  , times
  , multiple
    -- * Powers of two
  , powerOfTwo
  , halvings
  ) where

import Data.Bits (shiftL, shiftR)
import Data.Ratio (denominator, numerator)
import Visibility.Exact.IntegerRoot (bitLength)

-- | So many binary places: the unit is 2^−w. Not negative.
newtype BinaryPlaces = BinaryPlaces Int
  deriving (Eq, Ord, Show)

-- | All numbers from a lower to an upper end, in units.
data Interval = Interval !Integer !Integer
  deriving (Eq, Show)

-- | The least interval around a number.
around :: BinaryPlaces -> Rational -> Interval
around w q = between w (q, q)

-- | The least interval around all numbers from a lower to an upper one.
between :: BinaryPlaces -> (Rational, Rational) -> Interval
between (BinaryPlaces w) (low, high) = Interval (floored (scaled low)) (ceiled (scaled high))
  where
    scaled q = (numerator q `shiftL` w, denominator q)

-- | Its ends as numbers.
--
-- /Laws/ @between w . ends w@ changes nothing.
ends :: BinaryPlaces -> Interval -> (Rational, Rational)
ends (BinaryPlaces w) (Interval low high) = (fromInteger low * unit, fromInteger high * unit)
  where
    unit = powerOfTwo (negate w)

-- | The sums of the numbers of one and of the other.
plus :: Interval -> Interval -> Interval
plus (Interval a b) (Interval c d) = Interval (a + c) (b + d)

-- | The products of the numbers of one and of the other. /Requires/ that no number in them is negative.
times :: BinaryPlaces -> Interval -> Interval -> Interval
times (BinaryPlaces w) (Interval a b) (Interval c d) =
  Interval ((a * c) `shiftR` w) (negate (negate (b * d) `shiftR` w))

-- | The multiples by a rational that is not negative.
multiple :: Rational -> Interval -> Interval
multiple q (Interval a b)
  | q == 1 = Interval a b
  | otherwise = Interval (floored (numerator q * a, denominator q)) (ceiled (numerator q * b, denominator q))

floored, ceiled :: (Integer, Integer) -> Integer
floored (p, q) = p `div` q
ceiled (p, q) = negate (negate p `div` q)

-- | 2^k for any k.
powerOfTwo :: Int -> Rational
powerOfTwo k = 2 ^^ k

-- | The k for which q·2^−k is between 1\/4 and 1; 0 for 0. /Requires/ that q is not negative.
halvings :: Rational -> Int
halvings q
  | q == 0 = 0
  | otherwise = bitLength (numerator q) - bitLength (denominator q) + 1
