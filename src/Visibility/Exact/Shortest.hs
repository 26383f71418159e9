{-# LANGUAGE MagicHash #-}
{-# LANGUAGE UnboxedTuples #-}

-- | The shortest decimal that is read back as a Double.
module Visibility.Exact.Shortest
  ( shortest
  ) where

import Data.Bits (countLeadingZeros, finiteBitSize, shiftL, shiftR, (.&.), (.|.))
import Data.ByteString.Builder (Builder, char7, intDec, string7, wordDec)
import qualified Data.Vector as V
import GHC.Exts (Word (W#), timesWord2#)
import GHC.Float (castDoubleToWord64)

-- | The shortest decimal that the given Double is the nearest one to; of several the one that is nearest to it.
--
-- /Shape/ positional for 10⁻⁶ ≤ x < 10²¹, else scientific, as in @1.5e-7@ or @1e21@. There are no trailing zeros
-- behind a point.
--
-- /Degenerate cases/ 0 is @0@. Where a decimal is half-way between two Doubles, it is read as the one with the even
-- significand.
--
-- /Requires/ a finite number that is not negative; the sign is not looked at.
--
-- /Cost/ six multiplications of machine words, and as many divisions as there are trailing zeros.
--
-- /Laws/ reading it gives the number; no decimal with fewer digits does; none of as many is nearer.
--
-- /Example/ 1\/10 is @0.1@, the next Double is @0.10000000000000002@.
shortest :: Double -> Builder
shortest x
  | fraction == 0 && biased == 0 = char7 '0'
  | otherwise = written (shortestDecimal fraction biased)
  where
    bits = fromIntegral (castDoubleToWord64 x) :: Word
    fraction = bits .&. (1 `shiftL` 52 - 1)
    biased = fromIntegral (bits `shiftR` 52) .&. 0x7ff

-- | The number m·10ᵏ.
data Decimal = Decimal !Word !Int

-- | The shortest decimal of the Double with this fraction and biased exponent, not both 0.
--
-- The Double is c·2^q. What is read as it lies between (c − ½)·2^q and (c + ½)·2^q; below a power of two, where Doubles
-- are denser, from (c − ¼)·2^q on. With 10ᵏ the greatest power of ten that is not above the width of this interval, a
-- multiple of 10ᵏ lies in it, and at most one of 10ᵏ⁺¹. All comparisons are those of multiples of 4·10ᵏ with the
-- Double and both ends, each times 4, cut down to an integer, and made odd if something was cut off.
--
-- /Source/ Giulietti, The Schubfach way to render doubles (2020).
shortestDecimal :: Word -> Int -> Decimal
shortestDecimal fraction biased
  | s >= 10 && tenBelow /= tenAbove = stripped (if tenBelow then s `quot` 10 else s `quot` 10 + 1) (k + 1)
  | below /= above = stripped (if below then s else s + 1) k
  | otherwise = stripped (if v > middle || v == middle && odd s then s + 1 else s) k
  where
    normal = biased /= 0
    c = if normal then fraction .|. (1 `shiftL` 52) else fraction
    q = if normal then biased - 1075 else -1074
    afterDenser = fraction == 0 && biased > 1
    -- Logarithms of powers of two and ten, rounded down, for all exponents that occur.
    k = (q * 1262611 - (if afterDenser then 524031 else 0)) `shiftR` 22
    power = powerOfTen (negate k)
    place = q + floorLog2 (negate k) + 1
    times = timesPower power . (`shiftL` place)
    (low, v, high) = (times (4 * c - (if afterDenser then 1 else 2)), times (4 * c), times (4 * c + 2))
    -- An end of the interval belongs to it where the significand is even.
    ends = c .&. 1
    within n = low + ends <= 4 * n && 4 * n + ends <= high
    s = v `shiftR` 2
    middle = 4 * s + 2
    (below, above) = (within s, within (s + 1))
    tens = s - s `rem` 10
    (tenBelow, tenAbove) = (within tens, within (tens + 10))

-- | Without the trailing zeros.
stripped :: Word -> Int -> Decimal
stripped m k = case m `quotRem` 10 of
  (shorter, 0) -> stripped shorter (k + 1)
  _ -> Decimal m k

-- | ⌊log₂ 10ᵉ⌋, for |e| < 1000.
floorLog2 :: Int -> Int
floorLog2 e = (e * 1741647) `shiftR` 19

-- | The first 128 bits of a power of ten, rounded up.
data Power = Power !Word !Word

powerOfTen :: Int -> Power
powerOfTen e = powers V.! (e + 292)

powers :: V.Vector Power
powers = V.generate 617 (power . subtract 292)
  where
    power i = case ceiling (10 ^^ i * 2 ^^ (127 - floorLog2 i) :: Rational) `quotRem` (2 ^ (64 :: Int) :: Integer) of
      (high, low) -> Power (fromInteger high) (fromInteger low)
{-# NOINLINE powers #-}

-- | The product cut down by 2¹²⁸, and made odd if more was cut off than the rounding of the power makes up for.
timesPower :: Power -> Word -> Word
timesPower (Power high low) n = top' .|. (if rest > 1 then 1 else 0)
  where
    (carried, _) = low `timesWide` n
    (top, bottom) = high `timesWide` n
    rest = bottom + carried
    top' = if rest < bottom then top + 1 else top

timesWide :: Word -> Word -> (Word, Word)
timesWide (W# a) (W# b) = case timesWord2# a b of (# high, low #) -> (W# high, W# low)
{-# INLINE timesWide #-}

written :: Decimal -> Builder
written (Decimal m k)
  | e < -6 || e >= 21 = pointAfter 1 <> char7 'e' <> intDec e
  | e < 0 = string7 "0." <> zeros (-1 - e) <> wordDec m
  | k >= 0 = wordDec m <> zeros k
  | otherwise = pointAfter (e + 1)
  where
    count = figures m
    -- The exponent of the first figure.
    e = count + k - 1
    zeros n = string7 (replicate n '0')
    pointAfter n
      | n == count = wordDec m
      | otherwise = case m `quotRem` (10 ^ (count - n)) of
        (whole, part) -> wordDec whole <> char7 '.' <> zeros (count - n - figures part) <> wordDec part

-- | How many figures a positive number below 10¹⁸ has.
figures :: Word -> Int
figures m = if m < 10 ^ estimate then estimate else estimate + 1
  where
    estimate = ((finiteBitSize m - countLeadingZeros m) * 1233) `shiftR` 12
