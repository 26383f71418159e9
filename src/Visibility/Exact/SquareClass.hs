-- |
-- Square classes of positive integers, and sums of square roots with one term for each class.
--
-- Two roots √a and √b are rational multiples of each other if and only if a·b is a perfect square; a and b are then in
-- one square class. No integer is ever factored: classes are told apart by their images in ℚ₂, ℚ₃, …, ℚ₄₇, and compared
-- by greatest common divisors where those agree.
module Visibility.Exact.SquareClass
  ( PreparedRoot (..)
  , preparedRoot
  , mergedTerms
  , multiplied
  , balancedSum
  ) where

import Control.Monad (guard)
import Data.Bits (Bits, popCount, shiftL, shiftR, (.&.))
import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl', sortBy)
import Data.Ord (comparing)
import Visibility.Exact.IntegerRoot

-- | The root of a positive integer, ready to be summed: what is found out about it alone.
data PreparedRoot a = PreparedRoot
  { classKey :: !Int
  -- ^ The classes of the integer in ℚₚ modulo squares, for all primes up to 47: equal for equal square classes. 0 for
  -- perfect squares.
  , rootFactor :: !a
  -- ^ The root of the squares of those primes that have left the radicand.
  , radicand :: !a
  -- ^ What is left of the integer.
  }

-- | /Requires/ a positive integer. Machine integers do where it is one.
preparedRoot :: (Integral a, Bits a) => a -> PreparedRoot a
preparedRoot n = foldl' (oddStep (fromIntegral (n `rem` fromInteger oddPrimesProduct))) twoAdic oddPrimes
  where
    v = popCount ((n .&. negate n) - 1)
    unit = fromIntegral ((n `shiftR` v) .&. 7) `quot` 2
    twoAdic = PreparedRoot (4 * (v `rem` 2) + unit) (1 `shiftL` (v `quot` 2)) (n `shiftR` (2 * (v `quot` 2)))
{-# SPECIALISE preparedRoot :: Int -> PreparedRoot Int #-}
{-# SPECIALISE preparedRoot :: Integer -> PreparedRoot Integer #-}

oddStep :: Integral a => Int -> PreparedRoot a -> OddPrime -> PreparedRoot a
oddStep residue (PreparedRoot key s m) (OddPrime p squares)
  | r /= 0 = PreparedRoot (4 * key + symbol r) s m
  | otherwise = PreparedRoot (4 * key + 2 * (v `rem` 2) + symbol unit) (s * power) (m `quot` (power * power))
  where
    r = residue `rem` p
    symbol a = 1 - (squares `shiftR` a) .&. 1
    -- The exponent of p in m, and the residue of what is left.
    (v, unit) = valuation (0 :: Int) m
    power = fromIntegral p ^ (v `quot` 2)
    valuation k a = case a `quotRem` fromIntegral p of
      (q, 0) -> valuation (k + 1) q
      (_, b) -> (k, fromIntegral b)
{-# INLINE oddStep #-}

-- | A prime, and the set of the residues of squares as bits.
data OddPrime = OddPrime !Int !Int

oddPrimes :: [OddPrime]
oddPrimes = [OddPrime p (fromInteger (squareResidues p)) | p <- [3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47]]

-- | Less than 2⁵⁹.
oddPrimesProduct :: Integer
oddPrimesProduct = product [toInteger p | OddPrime p _ <- oddPrimes]

-- | The terms of a sum of multiples of roots, the radicands first and rising: one for each square class whose
-- coefficients do not cancel.
--
-- /Cost/ for t terms O(t log t), a greatest common divisor and two integer square roots for each term that shares its
-- class. Only terms of one 'classKey' are tested against each other.
mergedTerms :: (Integral a, Eq c, Num c) => [(c, PreparedRoot a)] -> [(a, c)]
mergedTerms found = sortBy (comparing fst) (concatMap oneTermPerClass (IntMap.toList buckets))
  where
    buckets = IntMap.fromListWith (<>) [(key, [Term m (multiplied k c)]) | (c, PreparedRoot key k m) <- found]
{-# INLINABLE mergedTerms #-}

-- | c √n, the radicand first.
data Term a c = Term !a !c

-- | The terms of one bucket, merged.
oneTermPerClass :: (Integral a, Eq c, Num c) => (Int, [Term a c]) -> [(a, c)]
oneTermPerClass (key, bucket) = case bucket of
  [Term m c] | key /= 0 -> [(m, c) | c /= 0]
  _ -> [(g, c) | (g, members) <- foldl' enter start bucket, let c = classCoefficient g members, c /= 0]
  where
    -- The class of the perfect squares is there from the start, so that a lone perfect square becomes 1 too.
    start = [(1, []) | key == 0]
{-# INLINABLE oneTermPerClass #-}

type SquareClass a c = (a, [Term a c])

enter :: Integral a => [SquareClass a c] -> Term a c -> [SquareClass a c]
enter classes term@(Term n _) = go classes
  where
    go [] = [(n, [term])]
    go (known@(g, members) : others) = case commonRadicand g n of
      Just h -> (h, term : members) : others
      Nothing -> known : go others
{-# INLINABLE enter #-}

-- | The greatest common divisor of two radicands if they are in one square class: the cofactors, coprime, are then
-- both squares.
commonRadicand :: Integral a => a -> a -> Maybe a
commonRadicand a b | a == b = Just a
commonRadicand a b = do
  let g = gcd a b
  guard (isSquare (toInteger (a `quot` g)) && isSquare (toInteger (b `quot` g)))
  Just g
{-# INLINABLE commonRadicand #-}

-- | The coefficient of √g, g a common radicand of all members.
classCoefficient :: (Integral a, Num c) => a -> [Term a c] -> c
classCoefficient g members =
  balancedSum
    [if n == g then c else multiplied (integerSquareRoot (toInteger (n `quot` g))) c | Term n c <- members]
{-# INLINABLE classCoefficient #-}

-- | The same number so many times.
multiplied :: (Integral a, Num c) => a -> c -> c
multiplied k c = if k == 1 then c else fromIntegral k * c
{-# INLINE multiplied #-}

-- | Adds neighbours first: long numbers, unrelated denominators and long sums then cost far less than one by one.
balancedSum :: Num c => [c] -> c
balancedSum [] = 0
balancedSum [c] = c
balancedSum cs = balancedSum (pairs cs)
  where
    pairs (a : b : rest) = (a + b) : pairs rest
    pairs rest = rest
{-# INLINABLE balancedSum #-}
