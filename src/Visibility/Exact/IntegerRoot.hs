-- | Lengths, square roots and perfect squares of integers.
module Visibility.Exact.IntegerRoot
  ( bitLength
  , integerSquareRoot
  , exactSquareRoot
  , isSquare
  , squareResidues
  ) where

import Data.Bits (setBit, shiftL, shiftR)
import Data.List (foldl')
import Data.Maybe (isJust)
import GHC.Num (integerLog2)

-- | The least k with |n| < 2^k.
--
-- /Example/ 0 for 0, 2 for 3, 3 for 4.
bitLength :: Integer -> Int
bitLength 0 = 0
bitLength n = fromIntegral (integerLog2 (abs n)) + 1

-- | The largest integer whose square is at most n.
--
-- /Degenerate cases/ 0 for a negative n.
--
-- /Cost/ that of one division of a number of n's length by one half as long: every Newton step doubles the digits.
--
-- /Laws/ r² ≤ n < (r + 1)² for n ≥ 0.
--
-- /Example/ 9 for 99, 10 for 100.
--
-- /Source/ the recursion is the one of Python's @math.isqrt@ (Dickinson); it stays within one of the root.
integerSquareRoot :: Integer -> Integer
integerSquareRoot n
  | n <= 0 = 0
  | n < machineLimit = machineSquareRoot n
  | a * a > n = a - 1
  | otherwise = a
  where
    a = nearSquareRoot (fromIntegral (integerLog2 n) `quot` 2) n

-- | For 4ᶜ ≤ n < 4ᶜ⁺¹ an integer a with (a − 1)² < n < (a + 1)².
nearSquareRoot :: Int -> Integer -> Integer
nearSquareRoot c n
  | n < machineLimit = machineSquareRoot n
  | otherwise = (a `shiftL` k) + (n `shiftR` (k + 2)) `quot` a
  where
    k = (c - 1) `quot` 2
    a = nearSquareRoot (c `quot` 2) (n `shiftR` (2 * k + 2))

machineLimit :: Integer
machineLimit = 1 `shiftL` 62

-- | The exact root of an integer from 1 to 2⁶² − 1. The floating-point root errs by less than one, and is corrected.
machineSquareRoot :: Integer -> Integer
machineSquareRoot big
  | guess * guess > n = toInteger (guess - 1)
  | (guess + 1) * (guess + 1) <= n = toInteger (guess + 1)
  | otherwise = toInteger guess
  where
    n = fromInteger big :: Int
    guess = truncate (sqrt (fromIntegral n :: Double)) :: Int

-- | The root of a perfect square.
exactSquareRoot :: Integer -> Maybe Integer
exactSquareRoot n
  | r * r == n = Just r
  | otherwise = Nothing
  where
    r = integerSquareRoot n

-- | Is this a perfect square?
isSquare :: Integer -> Bool
isSquare n = n == 1 || isJust (exactSquareRoot n)

-- | The squares modulo m, as bits.
squareResidues :: Int -> Integer
squareResidues m = foldl' setBit 0 [i * i `rem` m | i <- [0 .. m - 1]]
