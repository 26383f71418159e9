{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE HexFloatLiterals #-}

-- | Lengths and their sums as unevaluated sums of two Doubles, with proved bounds of what is lost; and quotients of
-- them rounded to a Double where the bound leaves no doubt. With exact sums for all form factors, as 30 digits want
-- them, @factors@ of 1 000 quadrilaterals takes six times as long.
--
-- /Source/ error-free transformations: Dekker, A floating-point technique for extending the available precision (1971);
-- Knuth, The Art of Computer Programming 2, 4.2.2. The rounding test is Ziv's (1991).
module Visibility.Exact.DoubleDouble
  ( -- * Lengths
    Double2 (..)
  , machineLength
  , scaledLength
    -- * Sums
  , Sum2 (..)
  , noLengths
  , plusLength
    -- * Quotients
  , nearestHalfQuotient
  , Scaled (..)
  , scaledHalfQuotient
    -- * Error-free transformations
  , twoSum
  , twoProduct
    -- * What is proved
  , sumBound
  , Quotient2 (..)
  , halfQuotient
  ) where

import Data.Bits (shift, shiftR, (.&.))
import Visibility.Exact.IntegerRoot (bitLength, integerSquareRoot)

-- Note [The bounds of lengths and sums]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
-- Write u = 2^-53. A length ℓ is given as s + t with s a Double, |t| <= 2us and |ℓ − (s + t)| <= 8u²ℓ.
--
-- 'machineLength' of N = x² + y² < 2^63: N = h + l exactly, h the Double nearest to N, |l| <= uN. s = fl(√h). The
-- product s·s = p + p' is exact (Dekker; s < 2^32, and p' is no smaller than 2^-104). h − p is exact (Sterbenz: s² is
-- within 3uN of h). e = N − s² is then computed with two more roundings, of numbers below 4uN: the error is at most
-- 8u²N, and |e| <= 3.1uN. From √N = s + e/(2s) − e²/(8s³) + …, t = fl(e/(2s)) is off by at most
-- (8u²N)/(2s) + 1.6u²s + 1.3u²s < 8u²ℓ.
--
-- 'scaledLength' keeps the 128 leading bits, or up to two more, of the longer coordinate and the same places of the
-- other one, in units of the last place kept: the vector is 2^127 or longer, and each coordinate loses less than 1 (a
-- shift to the right and then a division by w round down once: floor(floor(a/2^s)/w) is floor(a/(2^s w))). So the
-- length loses less than √2 (triangle inequality), the integer root of the sum of squares less than 1 more: less than
-- 2^-125 of it. The root has 128 bits or more; truncating it to 106 loses at most 2^-105. Together that is below 3u²,
-- and t < 2^-52 s.
--
-- A sum of k lengths with signs keeps Σs as a + b: a is the floating-point sum, each step's exact loss (Knuth's
-- two-sum) and t are added to b. With A = Σs, every partial a is at most A(1 + ku), a loss at most uA(1 + ku), so b
-- stays below (k + 2)uA(1 + ku), and its 2k roundings lose at most k(k + 5)u²A(1 + 2ku). With the losses of the
-- lengths, 8u²A, the value is within (k² + 5k + 9)u²A(1 + 2^-30) of a + b for k < 2^20. A itself is computed with an
-- error of kuA.

-- | A length as the unevaluated sum of two Doubles, the second small. Not a number where there is none in their range.
data Double2 = Double2 !Double !Double
  deriving (Eq, Show)

-- | The length of the vector (x, y).
--
-- /Requires/ |x|, |y| < 2^31. /Laws/ see Note [The bounds of lengths and sums].
machineLength :: Int -> Int -> Double2
machineLength x y
  | n == 0 = Double2 0 0
  | otherwise = Double2 s (e / (2 * s))
  where
    n = x * x + y * y
    h = fromIntegral n :: Double
    l = fromIntegral (n - truncate h) :: Double
    s = sqrt h
    (p, p') = twoProduct s s
    e = ((h - p) - p') + l
{-# INLINE machineLength #-}

-- | The length of the vector (x, y) / w times 2^−k; not a number unless it is zero or between 2^−400 and 2^400.
--
-- /Requires/ w > 0.
--
-- /Cost/ that of looking at the 128 leading bits, whatever the size of x and y.
--
-- /Laws/ see Note [The bounds of lengths and sums].
scaledLength :: Int -> Integer -> Integer -> Integer -> Double2
scaledLength k x y w
  | longest == 0 = Double2 0 0
  | abs (bits + place) > 400 = Double2 notANumber notANumber
  | otherwise = Double2 (encodeFloat (r `shiftR` 53) (place + 53)) (encodeFloat (r .&. (2 ^ (53 :: Int) - 1)) place)
  where
    longest = bitLength x `max` bitLength y
    -- To the left where there are fewer than 128 bits.
    onto128 = 128 - longest + if w == 1 then 0 else bitLength w
    leading a = let moved = abs a `shift` onto128 in if w == 1 then moved else moved `quot` w
    root = integerSquareRoot (leading x * leading x + leading y * leading y)
    bits = 106
    surplus = bitLength root - bits
    r = root `shiftR` surplus
    -- The exponent of the last bit of r.
    place = surplus - onto128 - k
    notANumber = 0 / 0 :: Double

-- | A sum of lengths with signs: its two parts, the sum of the lengths without signs, and their number.
data Sum2 = Sum2 !Double !Double !Double !Double

noLengths :: Sum2
noLengths = Sum2 0 0 0 0

-- | A sum with a length added, or taken away, so many times.
plusLength :: Sum2 -> Double2 -> Int -> Sum2
plusLength !total (Double2 s t) k = go total k
  where
    go !acc j
      | j > 0 = go (once acc s t) (j - 1)
      | j < 0 = go (once acc (negate s) (negate t)) (j + 1)
      | otherwise = acc
    once (Sum2 a b size count) x y = let (a', loss) = twoSum a x in Sum2 a' (b + (loss + y)) (size + abs x) (count + 1)
{-# INLINE plusLength #-}

-- Note [The bound of the quotient]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
-- Let S be the value of a sum, given as a + b within E (Note [The bounds of lengths and sums]), and D = d + d' twice a
-- length, within 8u²D, |d'| <= 2ud. Two-sum makes a + b into x + x' exactly, |x'| <= ux. Only x > 4E is gone on with.
-- q = fl(x/d), and q·d = p + p' exactly; x − p is exact, and |x − qd| <= 1.01ux. r = x + x' − q(d + d') is computed
-- with roundings of numbers of at most 1.01ux, 2.1ux, 3.2ux and 4.3ux: the error is below 11u²x. q' = fl(r/d) has
-- |q'| <= 4.4uq; it loses 4.4u²q by rounding and 8.8u²q by leaving out d'. So q + q' is within 25u²q of
-- (a + b)/(d + d'), hence within E/d (1 + 8u) + 40u²q of S/D.
-- Two-sum makes q + q' into h + g exactly. S/D lies between h + g − B and h + g + B; where both of these round to one
-- Double, so does S/D, because rounding is monotone. The sums g ± B are rounded themselves, by at most u(ug + B), which
-- the summand 4u²q and the factor 1 + 2^-20 in B cover, together with the roundings of the bounds.
-- Nothing here is near the ends of the range of Doubles: lengths are between 2^-400 and 2^400 or zero, a sum of less
-- than 2^20 lengths is below 2^420 and, where it exceeds 4E, above 2^-520; the quotient is looked at only from 2^-900
-- on.

-- | The Double nearest to a sum of lengths divided by twice a length, if the bound leaves no doubt which it is;
-- 'Nothing' for sums that are not surely positive.
--
-- /Laws/ it is that of the exact quotient.
nearestHalfQuotient :: Sum2 -> Double2 -> Maybe Double
nearestHalfQuotient total@(Sum2 _ _ _ count) by
  | surely && count < 0x1p20 && below == above && below >= 0x1p-900 && below <= 0x1p900 = Just below
  | otherwise = Nothing
  where
    Quotient2 surely h g slack = halfQuotient total by
    below = h + (g - slack)
    above = h + (g + slack)
{-# INLINE nearestHalfQuotient #-}

-- | Numbers between two integers times a power of two: the lower one, the upper one, the exponent.
data Scaled = Scaled !Integer !Integer !Int
  deriving (Eq, Show)

-- | A sum of lengths divided by twice a length, enclosed, if the sum is surely positive.
--
-- With h = m·2^j, everything is counted in units of 2^(j−64), that is, 2^-116 h or less. What is below a unit is cut
-- off from g and the slack; two units outwards make up for that.
--
-- /Laws/ the exact quotient lies between. The ends are positive, and about 2^-100 of them apart, as long as the lengths
-- do not cancel.
scaledHalfQuotient :: Sum2 -> Double2 -> Maybe Scaled
scaledHalfQuotient total@(Sum2 _ _ _ count) by
  | surely && count < 0x1p20 && h >= 0x1p-900 && h <= 0x1p900 && low > 0 = Just (Scaled low high k)
  | otherwise = Nothing
  where
    Quotient2 surely h g slack = halfQuotient total by
    (m, j) = decodeFloat h
    k = j - 64
    units x = let (m', j') = decodeFloat x in m' `shift` (j' - k)
    middle = m `shift` 64 + units g
    wide = units slack + 2
    low = middle - wide
    high = middle + wide
{-# INLINE scaledHalfQuotient #-}

-- | Is the sum surely positive? If so, its quotient is within the third number of the sum of the first two.
data Quotient2 = Quotient2 !Bool !Double !Double !Double

halfQuotient :: Sum2 -> Double2 -> Quotient2
halfQuotient total (Double2 length1 length2) = Quotient2 (x > 4 * bound) h g slack
  where
    Sum2 a b _ _ = total
    bound = sumBound total
    (x, x') = twoSum a b
    d = 2 * length1
    d' = 2 * length2
    q = x / d
    (p, p') = twoProduct q d
    r = ((x - p) - p') + (x' - q * d')
    (h, g) = twoSum q (r / d)
    slack = (bound / d + 44 * 0x1p-106 * q) * (1 + 0x1p-20)
{-# INLINE halfQuotient #-}

-- | How far a sum may be from the sum of its two parts.
sumBound :: Sum2 -> Double
sumBound (Sum2 _ _ size count) = size * (count * count + 5 * count + 9) * 0x1p-106 * (1 + 0x1p-20)
{-# INLINE sumBound #-}

-- | The sum and what is lost by it, exactly.
twoSum :: Double -> Double -> (Double, Double)
twoSum a b = (s, (a - (s - b')) + (b - b'))
  where
    s = a + b
    b' = s - a
{-# INLINE twoSum #-}

-- | The product and what is lost by it, exactly, as long as nothing leaves the range of normal Doubles.
twoProduct :: Double -> Double -> (Double, Double)
twoProduct a b = (p, ((high a * high b - p) + high a * low b + low a * high b) + low a * low b)
  where
    p = a * b
    high x = let c = 0x8000001 * x in c - (c - x)
    low x = x - high x
{-# INLINE twoProduct #-}
