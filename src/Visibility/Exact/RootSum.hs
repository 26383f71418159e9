{-# LANGUAGE BangPatterns #-}

-- | Exact finite sums of rational multiples of square roots of positive integers.
--
-- Every measure of lines and every form factor of a polygonal scene is such a sum. This module adds them, decides their
-- sign, and encloses them between rationals as tightly as one likes. Nothing is ever rounded.
--
-- Roots of different square classes ("Visibility.Exact.SquareClass") are linearly independent over the rationals, so a
-- sum with one term per class is zero only if it has no term.
module Visibility.Exact.RootSum
  ( -- * Sums of square roots
    RootSum
  , zero
  , rational
  , root
  , hypotenuse
  , fromTerms
  , terms
    -- * Arithmetic
  , totalsBy
  , scaled
  , quotientByRoot
    -- * Decisions
  , Sign (..)
  , sign
  , merged
  , mergedSum
  , asRational
    -- * Enclosures
  , enclosure
  , enclosureRelative
  ) where

import Data.Bits (shiftL, shiftR)
import Data.List (foldl', sortBy)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Ord (comparing)
import Data.Ratio (denominator, numerator, (%))
import GHC.Num (integerLog2)
import GHC.Real (Ratio (..))
import Visibility.Exact.IntegerRoot
import Visibility.Exact.SquareClass

-- | A finite sum Σ cᵢ √nᵢ with rational cᵢ and integers nᵢ > 0.
--
-- Equality and order are those of the real numbers, decided exactly; two equal sums may have different 'terms'.
--
-- /Shape/ kept by radicand, without zero coefficients. Square classes are merged on demand only, see 'merged'.
--
-- /Laws/ a field, since products and quotients of such sums are such sums; totally ordered.
data RootSum
  = End
  | -- | Of the least radicand, with the other terms.
    Term !Integer !Rational !RootSum

instance Show RootSum where
  showsPrec d s = showParen (d > 10) (showString "fromTerms " . showsPrec 11 (terms s))

instance Eq RootSum where
  a == b = compare a b == EQ

instance Ord RootSum where
  compare a b = compare (sign (a - b)) Zero

-- | /Cost/ O(a + b) for the sum of sums of a and b terms; many are best added by 'mconcat'.
instance Num RootSum where
  End + b = b
  a + End = a
  a@(Term n c a') + b@(Term m d b') = case compare n m of
    LT -> Term n c (a' + b)
    EQ -> term n (c + d) (a' + b')
    GT -> Term m d (a + b')
  a * b = mconcat [a `byRoot` (recip (r * fromInteger n), n) | (r, n) <- terms b]
  negate = mapped negate
  abs s = s * signum s
  signum s = case sign s of
    Negative -> -1
    Zero -> 0
    Positive -> 1
  fromInteger = rational . fromInteger

-- | /Cost/ of a quotient, up to 2ᵏ terms if the divisor's radicands are products of powers of k integers, prime to each
-- other.
instance Fractional RootSum where
  fromRational = rational

  -- Each step multiplies with what the divisor is when a root √g changes its sign, as √2 − 1 is for √2 + 1. The product
  -- has no √g. It is not zero, since roots of integers that are no squares and prime to each other are independent. In
  -- the end it is rational. As of other fractions, there is none of zero.
  recip s = go 1 divisor (foldl' coprime [] (map snd (terms divisor)))
    where
      divisor = merged s
      go over under (g : others) = go (over * conjugate) (under * conjugate) others
        where
          conjugate = foldr (\(c, n) -> Term n (if odd (power g n) then negate c else c)) zero (terms under)
      go over under [] = scaled (maybe (recip 0) recip (asRational under)) over
      power g n = if n `rem` g == 0 then 1 + power g (n `quot` g) else 0 :: Int

-- | With one more integer, integers above 1, no squares and prime to each other, of which and of squares all are
-- products.
coprime :: [Integer] -> Integer -> [Integer]
coprime found n
  | Just r <- exactSquareRoot n = if n == 1 then found else coprime found r
coprime [] n = [n]
coprime (g : others) n
  | common == 1 = g : coprime others n
  | otherwise = foldl' coprime others [g `quot` common, common, n `quot` common]
  where
    common = gcd g n

instance Semigroup RootSum where
  (<>) = (+)

instance Monoid RootSum where
  mempty = zero
  -- O(t log t) for t terms in all.
  mconcat = balancedSum

-- | The empty sum.
zero :: RootSum
zero = End

-- | A rational number, as its multiple of √1.
rational :: Rational -> RootSum
rational c = nonNegativeRoot c 1

-- | @root c n@ is c √n.
--
-- /Degenerate cases/ the sum is 'zero' if c or n is; there is none, 'Nothing', if n is negative.
root :: Rational -> Integer -> Maybe RootSum
root c n
  | n < 0 = Nothing
  | otherwise = Just (nonNegativeRoot c n)

-- | @hypotenuse c x y@ is c √(x² + y²): a multiple of the length of an integer vector. Unlike 'root' it cannot fail.
--
-- /Shape/ at most one term, its radicand that of the primitive vector (x, y) / gcd(x, y). On the lattice of a scene
-- with many denominators the gcd is nearly as long as x and y.
hypotenuse :: Rational -> Integer -> Integer -> RootSum
hypotenuse c x y
  | g == 0 = zero
  | otherwise = nonNegativeRoot (multiplied g c) (square (x `quot` g) + square (y `quot` g))
  where
    g = gcd x y
    square a = a * a

-- | The sum of some terms (coefficient, radicand), in any order, repeated radicands allowed; 'Nothing' if one of the
-- radicands is negative.
--
-- /Cost/ O(t log t) for t terms.
fromTerms :: [(Rational, Integer)] -> Maybe RootSum
fromTerms found
  | any ((< 0) . snd) found = Nothing
  | otherwise = Just (collected [(n, c) | (c, n) <- found, n /= 0])

-- | The terms (coefficient, radicand) as they are kept: no zero coefficient, radicands positive and rising.
--
-- /Laws/ @fromTerms (terms s) == Just s@, with the same terms.
terms :: RootSum -> [(Rational, Integer)]
terms End = []
terms (Term n c rest) = (c, n) : terms rest

nonNegativeRoot :: Rational -> Integer -> RootSum
nonNegativeRoot c n = if n == 0 then zero else term n c zero

-- The sum with one more term, of a lesser radicand than any, if its coefficient is not zero.
term :: Integer -> Rational -> RootSum -> RootSum
term n c rest = if c == 0 then rest else Term n c rest

-- | The total of all sums with each key.
--
-- /Cost/ for k sums of t terms in all, O(k log k + t log t).
totalsBy :: Ord k => [(k, RootSum)] -> Map k RootSum
totalsBy found = Map.map mconcat (Map.fromListWith (<>) [(key, [s]) | (key, s) <- found])

-- | A rational multiple of a sum.
scaled :: Rational -> RootSum -> RootSum
scaled r s = if r == 0 then zero else mapped (r *) s

-- Coefficients that are not zero must stay so.
mapped :: (Rational -> Rational) -> RootSum -> RootSum
mapped _ End = End
mapped f (Term n c rest) = Term n (f c) (mapped f rest)

-- | @quotientByRoot s r n@ is s \/ (r √n), again a sum of roots: for a form factor, the measure by twice a side's
-- length.
--
-- /Degenerate cases/ 'Nothing' if the divisor r √n is zero or n is negative.
--
-- /Cost/ one greatest common divisor per term, which keeps the new radicands small.
--
-- /Laws/ undone by the quotient by √n \/ (r n), which is the product with r √n.
quotientByRoot :: RootSum -> Rational -> Integer -> Maybe RootSum
quotientByRoot s r n
  | n <= 0 || r == 0 = Nothing
  | otherwise = Just (s `byRoot` (r, n))

-- | The quotient by r √n, neither being zero.
byRoot :: RootSum -> (Rational, Integer) -> RootSum
byRoot s (r, n) = collected [quotientOf c m (gcd m n) | (c, m) <- terms s]
  where
    -- Rational arithmetic step by step would look for common divisors at each step; these numbers may be huge.
    quotientOf c m g =
      let !m' = over g m
          !n' = over g n
          !radicand' = m' * n'
          !c' = lowest (numerator c * p) (denominator c * q * n')
       in (radicand', c')
    (p, q) = (signum (numerator r) * denominator r, abs (numerator r))
    lowest a b = let g = gcd a b in over g a :% over g b
    over g a = if g == 1 then a else a `quot` g

-- | The sum of multiples of roots of positive integers, the radicands first.
--
-- /Cost/ linear where the radicands rise.
collected :: [(Integer, Rational)] -> RootSum
collected = together . sortBy (comparing fst)
  where
    together ((n, c) : (m, d) : rest)
      | n == m = together ((n, c + d) : rest)
    together ((n, c) : rest) = term n c (together rest)
    together [] = zero

-- | Where a number lies with respect to zero.
data Sign = Negative | Zero | Positive
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | The sign of a sum, exactly.
--
-- Terms of one sign decide at once. Otherwise the sum is enclosed to 64 bits; only if that does not exclude zero are
-- the square classes merged. A merged sum with a term left is not zero, so doubling the precision must come to an end.
--
-- /Cost/ one integer square root per term in all but the hardest cases; a sum that is zero costs what 'merged' costs.
--
-- /Laws/ @sign (negate s)@ is opposite; a positive factor keeps it; 'Zero' exactly if the real number is zero.
--
-- /Example/ √10 + √11 − √5 − √18 is positive, about 2·10⁻⁴; √18 + √2 − √32 is zero.
sign :: RootSum -> Sign
sign s = fromMaybe (refine (128 :: Int)) (shown 64 s)
  where
    whole = merged s
    refine bits = fromMaybe (refine (2 * bits)) (shown bits whole)

-- | The sign, if it shows at a precision relative to the largest term.
shown :: Int -> RootSum -> Maybe Sign
shown bits s
  | null coefficients = Just Zero
  | all (> 0) coefficients || low > 0 = Just Positive
  | all (< 0) coefficients || high < 0 = Just Negative
  | otherwise = Nothing
  where
    coefficients = map fst (terms s)
    (low, high) = units (relativeScale bits s) s

-- | The same number, with one term per square class.
--
-- /Shape/ perfect squares have become 1, the squares of primes up to 47 have left the radicands, and a class of several
-- radicands is represented by their greatest common divisor.
--
-- /Cost/ for t terms, t reductions by machine-sized moduli, then a greatest common divisor and two integer square
-- roots for each term that shares its class. Terms are first sorted by their classes in ℚ₂, ℚ₃, …, ℚ₄₇, and only terms
-- equal in all of them are tested against each other.
--
-- /Laws/ the value stays. Two sums of equal value have, after merging, equally many terms, and these pair off: equal
-- signs, equal c² n. The radicands themselves depend only on the set of radicands that came in; they need not be
-- square-free. Merging twice is merging once. The number is zero exactly if no term is left.
--
-- /Example/ √8 − 2√2 has no term left; √12 + √75 + √4 becomes 2√1 + 7√3.
--
-- /Source/ independence of roots of distinct square classes: Besicovitch, On the linear independence of fractional
-- powers of integers (1940).
merged :: RootSum -> RootSum
merged s = foldr (\(n, c) rest -> Term n c rest) zero (mergedTerms [(c, preparedRoot n) | (c, n) <- terms s])

-- | The sum of integer multiples of roots, divided by an integer, merged.
--
-- /Requires/ a positive divisor. /Cost/ that of 'merged' without preparing the roots.
--
-- /Laws/ terms as those of @'merged' ('fromTerms' [(c % d, n), …])@ but for the representatives of classes, which may
-- differ where radicands cancel.
mergedSum :: Integral a => Integer -> [(Integer, PreparedRoot a)] -> RootSum
mergedSum divisor found = foldr (\(n, c) rest -> Term (toInteger n) (part c) rest) zero (mergedTerms found)
  where
    part c = if divisor == 1 then fromInteger c else c % divisor
{-# SPECIALISE mergedSum :: Integer -> [(Integer, PreparedRoot Int)] -> RootSum #-}
{-# SPECIALISE mergedSum :: Integer -> [(Integer, PreparedRoot Integer)] -> RootSum #-}

-- | The rational number that a sum is, if it is one.
--
-- /Example/ √4 + √9 is 5; √2 is none.
asRational :: RootSum -> Maybe Rational
asRational s = case terms (merged s) of
  [] -> Just 0
  [(c, 1)] -> Just c
  _ -> Nothing

-- | @enclosure k s@ is an interval that contains s and is at most 2⁻ᵏ wide; k may be negative.
--
-- /Shape/ (lower end, upper end), closed.
--
-- /Cost/ one integer square root per term, of about twice the bits that the term has left of the point and k to the
-- right of it. However long the numbers in a term are, only as many leading bits of them are computed with.
enclosure :: Int -> RootSum -> (Rational, Rational)
enclosure k s = inUnits (k + guardBits s) s

-- | @enclosureRelative p s@ is an interval that contains s and is at most 2⁻ᵖ times as wide as the largest term of s,
-- in absolute value, is large. Cancellation between terms makes it wide with respect to s itself.
enclosureRelative :: Int -> RootSum -> (Rational, Rational)
enclosureRelative p s = inUnits (relativeScale p s) s

inUnits :: Int -> RootSum -> (Rational, Rational)
inUnits k s = (scale low, scale high)
  where
    (low, high) = units k s
    scale a = if k >= 0 then a % (1 `shiftL` k) else fromInteger (a `shiftL` negate k)

-- | Bounds in units of 2⁻ᵏ, twice as far apart as there are terms.
units :: Int -> RootSum -> (Integer, Integer)
units k s = (low, low + 2 * toInteger (length (terms s)))
  where
    low = foldl' (\a (c, n) -> a + lowerUnits k n c) 0 (terms s)

-- | An integer a with a ≤ c √n 2ᵏ ≤ a + 2.
--
-- x, y and n are cut to their leading w bits, downwards but for y. The relative losses of x and n are below 2¹⁻ʷ, that
-- of y at most 2¹⁻ʷ, and that of the root less than their sum. The result is below 2ʷ⁻⁸, so it loses less than 1 by the
-- cutting, and less than 1 by being rounded down.
lowerUnits :: Int -> Integer -> Rational -> Integer
lowerUnits k n c = if c > 0 then magnitude else negate magnitude - 2
  where
    (x, y) = (abs (numerator c), denominator c)
    w = 8 + max 0 (bitLength x + (bitLength n + 1) `quot` 2 - bitLength y + 1 + k)
    (x', i) = leading w x
    (n', j) = leading w n
    (cut, l) = leading w y
    y' = if l > 0 then cut + 1 else cut
    magnitude
      | n == 1 = shiftedQuotient (k + i - l) x' y'
      | otherwise = integerSquareRoot (shiftedQuotient (2 * (k + i - l) + j) (x' * x' * n') (y' * y'))

-- | The leading bits of a positive integer, at most so many, and how many others were cut off.
leading :: Int -> Integer -> (Integer, Int)
leading w a = (a `shiftR` excess, excess)
  where
    excess = max 0 (bitLength a - w)

shiftedQuotient :: Int -> Integer -> Integer -> Integer
shiftedQuotient k a b
  | k < 0 = a `quot` (b `shiftL` negate k)
  | b == 1 = a `shiftL` k
  | otherwise = (a `shiftL` k) `quot` b

-- | The k for 'units' that gives p bits of the largest term.
relativeScale :: Int -> RootSum -> Int
relativeScale p s = p + guardBits s - largest
  where
    largest = case terms s of
      [] -> 0
      found -> maximum [below n c | (c, n) <- found]
    -- A power of two at or below |c| √n.
    below n c = (2 * bits (numerator c) + bits n - 2 * bits (denominator c) - 2) `div` 2
    bits a = fromIntegral (integerLog2 (abs a))

-- | Bits by which the bounds of 'units' are farther apart than one unit.
guardBits :: RootSum -> Int
guardBits s = fromIntegral (integerLog2 (toInteger (length (terms s)))) + 2
