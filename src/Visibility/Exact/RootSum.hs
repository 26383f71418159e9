-- |
-- Exact finite sums of rational multiples of square roots of positive integers.
--
-- Every measure of lines and every form factor of a polygonal scene is such a sum. This module adds them, decides their
-- sign, and encloses them between rationals as tightly as one likes. Nothing is ever rounded.
--
-- Two roots √a and √b are rational multiples of each other if and only if a·b is a perfect square; a and b are then in
-- one /square class/. Roots of different classes are linearly independent over the rationals, so a sum with one term
-- per class is zero only if it has no term. No integer is ever factored.
module Visibility.Exact.RootSum
  ( -- * Sums of square roots
    RootSum
  , zero
  , rational
  , root
  , hypotenuse
  , rootOfRational
  , fromTerms
  , terms

    -- * Arithmetic
  , plus
  , minus
  , negated
  , scaled
  , timesRoot
  , quotientByRoot

    -- * Decisions
  , Sign (..)
  , sign
  , compareRootSums
  , merged
  , PreparedRoot
  , preparedRoot
  , mergedSum
  , asRational

    -- * Enclosures
  , enclosure
  , enclosureRelative
  ) where

import Control.Monad (guard)
import Data.Bits (shiftL, shiftR, testBit, (.&.))
import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl')
import Data.Map.Merge.Strict (merge, preserveMissing, zipWithMaybeMatched)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Ratio (denominator, numerator, (%))
import GHC.Num (integerLog2)
import Visibility.Exact.IntegerRoot

-- | A finite sum Σ cᵢ √nᵢ with rational cᵢ and integers nᵢ > 0.
--
-- Equality and order are those of the real numbers, decided exactly; two equal sums may have different 'terms'.
--
-- Shape: kept by radicand, without zero coefficients. Square classes are merged on demand only, see 'merged'.
--
-- /Laws:/ a commutative group under 'plus'; a vector space over the rationals under 'scaled'; totally ordered.
newtype RootSum = RootSum (Map Integer Rational)

instance Show RootSum where
  showsPrec d s = showParen (d > 10) (showString "fromTerms " . showsPrec 11 (terms s))

instance Eq RootSum where
  a == b = compareRootSums a b == EQ

instance Ord RootSum where
  compare = compareRootSums

instance Semigroup RootSum where
  (<>) = plus

instance Monoid RootSum where
  mempty = zero
  mconcat = foldl' plus zero

-- | The empty sum.
zero :: RootSum
zero = RootSum Map.empty

-- | A rational number, as its multiple of √1.
rational :: Rational -> RootSum
rational c = positiveRoot c 1

-- | @root c n@ is c √n.
--
-- /Degenerate cases:/ the sum is 'zero' if c or n is; there is none, 'Nothing', if n is negative.
root :: Rational -> Integer -> Maybe RootSum
root c n
  | n < 0 = Nothing
  | otherwise = Just (nonNegativeRoot c n)

-- | @hypotenuse c x y@ is c √(x² + y²): a multiple of the length of an integer vector. Unlike 'root' it cannot fail.
--
-- Shape: at most one term, its radicand that of the primitive vector (x, y) / gcd(x, y). On the lattice of a scene with
-- many denominators the gcd is nearly as long as x and y.
hypotenuse :: Rational -> Integer -> Integer -> RootSum
hypotenuse c x y
  | g == 0 = zero
  | otherwise = nonNegativeRoot (multiplied g c) (square (x `quot` g) + square (y `quot` g))
  where
    g = gcd x y
    square a = a * a

-- | The square root of a rational number, √(p\/q) = (1\/q) √(p q); 'Nothing' for a negative one.
rootOfRational :: Rational -> Maybe RootSum
rootOfRational q = root (1 % denominator q) (numerator q * denominator q)

-- | The sum of some terms (coefficient, radicand), in any order, repeated radicands allowed; 'Nothing' if one of the
-- radicands is negative.
--
-- /Cost:/ O(t log t) for t terms.
fromTerms :: [(Rational, Integer)] -> Maybe RootSum
fromTerms = fmap mconcat . traverse (uncurry root)

-- | The terms (coefficient, radicand) as they are kept: no zero coefficient, radicands positive and rising.
--
-- /Laws:/ @fromTerms (terms s) == Just s@, with the same terms.
terms :: RootSum -> [(Rational, Integer)]
terms (RootSum m) = [(c, n) | (n, c) <- Map.toAscList m]

nonNegativeRoot :: Rational -> Integer -> RootSum
nonNegativeRoot c n = if n == 0 then zero else positiveRoot c n

positiveRoot :: Rational -> Integer -> RootSum
positiveRoot c n = if c == 0 then zero else RootSum (Map.singleton n c)

-- | The sum of two sums.
--
-- /Cost:/ O(a log (b\/a + 1)) for a ≤ b terms: adding a single term to a large sum is logarithmic.
plus :: RootSum -> RootSum -> RootSum
plus (RootSum a) (RootSum b) = RootSum (merge preserveMissing preserveMissing (zipWithMaybeMatched together) a b)
  where
    together _ c d = let e = c + d in if e == 0 then Nothing else Just e

-- | The difference of two sums.
minus :: RootSum -> RootSum -> RootSum
minus a b = a `plus` negated b

-- | The opposite sum.
negated :: RootSum -> RootSum
negated (RootSum m) = RootSum (Map.map negate m)

-- | A rational multiple of a sum.
scaled :: Rational -> RootSum -> RootSum
scaled r (RootSum m)
  | r == 0 = zero
  | otherwise = RootSum (Map.map (r *) m)

-- | @timesRoot r n s@ is s · r √n; 'Nothing' if n is negative.
--
-- /Cost:/ one greatest common divisor per term, which keeps the new radicands small.
timesRoot :: Rational -> Integer -> RootSum -> Maybe RootSum
timesRoot r n s
  | n < 0 = Nothing
  | n == 0 || r == 0 = Just zero
  | otherwise = Just (collected [productOf c m (gcd m n) | (c, m) <- terms s])
  where
    productOf c m g = ((m `quot` g) * (n `quot` g), multiplied g (c * r))

-- | @quotientByRoot s r n@ is s \/ (r √n), again a sum of roots: for a form factor, the measure by twice a side's
-- length.
--
-- /Degenerate cases:/ 'Nothing' if the divisor r √n is zero or n is negative.
--
-- /Cost:/ that of 'timesRoot'.
--
-- /Laws:/ undone by 'timesRoot'.
quotientByRoot :: RootSum -> Rational -> Integer -> Maybe RootSum
quotientByRoot s r n
  | n <= 0 || r == 0 = Nothing
  | otherwise = Just (collected [quotientOf c m (gcd m n) | (c, m) <- terms s])
  where
    -- Rational arithmetic step by step would look for common divisors at each step; these numbers may be huge.
    quotientOf c m g =
      let n' = n `quot` g
       in ((m `quot` g) * n', (numerator c * denominator r) % (denominator c * numerator r * n'))

-- | The sum of multiples of roots of positive integers, the radicands first.
collected :: [(Integer, Rational)] -> RootSum
collected [(n, c)] = positiveRoot c n
collected found = RootSum (Map.filter (/= 0) (Map.fromListWith (+) found))

-- | Where a number lies with respect to zero.
data Sign = Negative | Zero | Positive
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | The sign of a sum, exactly.
--
-- Terms of one sign decide at once. Otherwise the sum is enclosed to 64 bits; only if that does not exclude zero are
-- the square classes merged. A merged sum with a term left is not zero, so doubling the precision must come to an end.
--
-- /Cost:/ one integer square root per term in all but the hardest cases; a sum that is zero costs what 'merged' costs.
--
-- /Laws:/ @sign (negated s)@ is opposite; a positive factor keeps it; 'Zero' exactly if the real number is zero.
--
-- Example: √10 + √11 − √5 − √18 is positive, about 2·10⁻⁴; √18 + √2 − √32 is zero.
sign :: RootSum -> Sign
sign s = fromMaybe (refine (128 :: Int)) (shown 64 s)
  where
    whole = merged s
    refine bits = fromMaybe (refine (2 * bits)) (shown bits whole)

-- | The sign, if it shows at a precision relative to the largest term.
shown :: Int -> RootSum -> Maybe Sign
shown bits s@(RootSum m)
  | Map.null m = Just Zero
  | all (> 0) m || low > 0 = Just Positive
  | all (< 0) m || high < 0 = Just Negative
  | otherwise = Nothing
  where
    (low, high) = units (relativeScale bits s) s

-- | The order of two sums as real numbers, decided exactly.
--
-- /Laws:/ @compareRootSums a b@ is the order of @sign (a \`minus\` b)@ and 'Zero'.
compareRootSums :: RootSum -> RootSum -> Ordering
compareRootSums a b = compare (sign (a `minus` b)) Zero

-- | The same number, with one term per square class.
--
-- Shape: perfect squares have become 1, the squares of primes up to 47 have left the radicands, and a class of several
-- radicands is represented by their greatest common divisor.
--
-- /Cost:/ for t terms, t reductions by machine-sized moduli, then a greatest common divisor and two integer square
-- roots for each term that shares its class. Terms are first sorted by their classes in ℚ₂, ℚ₃, …, ℚ₄₇, and only terms
-- equal in all of them are tested against each other.
--
-- /Laws:/ the value stays. Two sums of equal value have, after merging, equally many terms, and these pair off: equal
-- signs, equal c² n. The radicands themselves depend only on the set of radicands that came in; they need not be
-- square-free. Merging twice is merging once. The number is zero exactly if no term is left.
--
-- Example: √8 − 2√2 has no term left; √12 + √75 + √4 becomes 2√1 + 7√3.
--
-- /Source:/ independence of roots of distinct square classes: Besicovitch, On the linear independence of fractional
-- powers of integers (1940).
merged :: RootSum -> RootSum
merged s = RootSum (Map.fromList (concatMap oneTermPerClass (IntMap.toList buckets)))
  where
    buckets = IntMap.fromListWith (++) [(key, [term]) | (c, n) <- terms s, let (key, term) = localised c n]

-- | The root of a positive integer, ready to be summed: what 'merged' finds out about it alone.
newtype PreparedRoot = PreparedRoot Local

-- | /Requires/ a positive integer.
preparedRoot :: Integer -> PreparedRoot
preparedRoot = PreparedRoot . local

-- | The sum of integer multiples of roots, divided by an integer, merged.
--
-- /Requires/ a positive divisor. /Cost/ that of 'merged' without the reductions.
--
-- /Laws/ terms as those of @'merged' ('fromTerms' [(c % d, n), …])@ but for the representatives of classes, which may
-- differ where radicands cancel.
mergedSum :: Integer -> [(Integer, PreparedRoot)] -> RootSum
mergedSum divisor found = RootSum (Map.fromList (concatMap oneTerm (IntMap.toList buckets)))
  where
    buckets = IntMap.fromListWith (++) [(key, [Term m (c * k)]) | (c, PreparedRoot (Local key k m)) <- found]
    oneTerm bucket = [(g, if divisor == 1 then fromInteger c else c % divisor) | (g, c) <- oneTermPerClass bucket]

-- | The terms of one bucket, merged.
oneTermPerClass :: (Eq a, Num a) => (Int, [Term a]) -> [(Integer, a)]
oneTermPerClass (key, bucket) =
  [(g, c) | (g, members) <- foldl' enter start bucket, let c = classCoefficient g members, c /= 0]
  where
    -- The class of the perfect squares is there from the start, so that a lone perfect square becomes 1 too.
    start = [(1, []) | key == 0]

-- | c √n, the radicand first.
data Term a = Term !Integer !a

type SquareClass a = (Integer, [Term a])

enter :: [SquareClass a] -> Term a -> [SquareClass a]
enter classes term@(Term n _) = go classes
  where
    go [] = [(n, [term])]
    go (known@(g, members) : others) = case commonRadicand g n of
      Just h -> (h, term : members) : others
      Nothing -> known : go others

-- | The greatest common divisor of two radicands if they are in one square class: the cofactors, coprime, are then
-- both squares.
commonRadicand :: Integer -> Integer -> Maybe Integer
commonRadicand a b | a == b = Just a
commonRadicand a b = do
  let g = gcd a b
  guard (isSquare (a `quot` g) && isSquare (b `quot` g))
  Just g

-- | The coefficient of √g, g a common radicand of all members.
classCoefficient :: Num a => Integer -> [Term a] -> a
classCoefficient g members =
  balancedSum [if n == g then c else multiplied (integerSquareRoot (n `quot` g)) c | Term n c <- members]

multiplied :: Num a => Integer -> a -> a
multiplied k c = if k == 1 then c else fromInteger k * c

-- | Adds neighbours first: unrelated denominators then cost far less than one by one.
balancedSum :: Num a => [a] -> a
balancedSum [] = 0
balancedSum [c] = c
balancedSum cs = balancedSum (pairs cs)
  where
    pairs (a : b : rest) = (a + b) : pairs rest
    pairs rest = rest

-- | A term with the squares of small primes taken out of its radicand, and a key that is equal for equal square
-- classes: the classes of the radicand in ℚₚ modulo squares, for all primes up to 47. The key is 0 for perfect
-- squares.
localised :: Rational -> Integer -> (Int, Term Rational)
localised c n = let Local key s m = local n in (key, Term m (multiplied s c))

local :: Integer -> Local
local n = foldl' (oddStep (fromInteger (n `rem` oddPrimesProduct))) twoAdic oddPrimes
  where
    v = fromIntegral (integerLog2 (n .&. negate n))
    unit = fromInteger ((n `shiftR` v) .&. 7) `quot` 2
    twoAdic = Local (4 * (v `rem` 2) + unit) (1 `shiftL` (v `quot` 2)) (n `shiftR` (2 * (v `quot` 2)))

-- | The key so far, the root of the square factor taken out so far, and the radicand left.
data Local = Local !Int !Integer !Integer

-- | A prime, and the set of the residues of squares as bits.
data OddPrime = OddPrime !Int !Integer

oddStep :: Int -> Local -> OddPrime -> Local
oddStep residue (Local key s m) (OddPrime p squares)
  | r /= 0 = Local (4 * key + symbol r) s m
  | otherwise = Local (4 * key + 2 * (v `rem` 2) + symbol unit) (s * power) (m `quot` (power * power))
  where
    r = residue `rem` p
    symbol a = if testBit squares a then 0 else 1
    -- The exponent of p in m, and the residue of what is left.
    (v, unit) = valuation 0 m
    power = toInteger p ^ (v `quot` 2)
    valuation :: Int -> Integer -> (Int, Int)
    valuation k a = case a `quotRem` toInteger p of
      (q, 0) -> valuation (k + 1) q
      (_, b) -> (k, fromInteger b)

oddPrimes :: [OddPrime]
oddPrimes = [OddPrime p (squareResidues p) | p <- [3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47]]

-- | Less than 2⁵⁹.
oddPrimesProduct :: Integer
oddPrimesProduct = product [toInteger p | OddPrime p _ <- oddPrimes]

-- | The rational number that a sum is, if it is one.
--
-- Example: √4 + √9 is 5; √2 is none.
asRational :: RootSum -> Maybe Rational
asRational s = case terms (merged s) of
  [] -> Just 0
  [(c, 1)] -> Just c
  _ -> Nothing

-- | @enclosure k s@ is an interval that contains s and is at most 2⁻ᵏ wide; k may be negative.
--
-- Shape: (lower end, upper end), closed.
--
-- /Cost:/ one integer square root per term, of about twice the bits that the term has left of the point and k to the
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
units k (RootSum m) = (low, low + 2 * toInteger (Map.size m))
  where
    low = Map.foldlWithKey' (\a n c -> a + lowerUnits k n c) 0 m

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
relativeScale p s@(RootSum m) = p + guardBits s - largest
  where
    largest = if Map.null m then 0 else maximum [below n c | (n, c) <- Map.toList m]
    -- A power of two at or below |c| √n.
    below n c = (2 * bits (numerator c) + bits n - 2 * bits (denominator c) - 2) `div` 2
    bits a = fromIntegral (integerLog2 (abs a))

-- | Bits by which the bounds of 'units' are farther apart than one unit.
guardBits :: RootSum -> Int
guardBits (RootSum m) = fromIntegral (integerLog2 (toInteger (Map.size m))) + 2
