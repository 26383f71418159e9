-- | Correctly rounded output of exact numbers.
--
-- A number is enclosed between two rationals. When both round to the same result, so does the number, because rounding
-- is monotone. Otherwise the precision is doubled (Ziv's strategy). Only a rational number can lie exactly where the
-- rounding changes; whether the number is rational is decided first, by merging square classes, and a rational is
-- rounded directly. So every call ends, and no digit is a guess.
module Visibility.Exact.Rounding
  ( -- * Decimals
    Digits
  , digits
  , digitCount
  , defaultDigits
  , decimal
  , decimalBetween
  , outwardDecimals
    -- * Floating point
  , nearestDouble
    -- * Exact text
  , rationalText
  ) where

import Data.Bits (bit, shiftR, (.&.))
import Data.Maybe (fromMaybe)
import Data.Ratio (denominator, numerator)
import qualified Data.Vector as V
import GHC.Num (integerLog2)
import Visibility.Exact.DoubleDouble (Scaled (..))
import Visibility.Exact.RootSum (RootSum, asRational, enclosureRelative, merged)

-- | A number of significant decimal digits, at least 1.
newtype Digits = Digits Int
  deriving (Eq, Ord, Show)

-- | The smart constructor; 'Nothing' for less than one digit.
digits :: Int -> Maybe Digits
digits n = if n >= 1 then Just (Digits n) else Nothing

-- | The number itself.
digitCount :: Digits -> Int
digitCount (Digits n) = n

-- | 17 digits, enough to tell any two Doubles apart.
defaultDigits :: Digits
defaultDigits = Digits 17

-- | A sum of roots with N significant digits, correctly rounded; a tie, possible only for a rational, goes to the even
-- last digit.
--
-- /Shape/ trailing zeros are kept. With e the decimal exponent of the leading digit after rounding, the notation is
-- positional if −2 ≤ e < N and else scientific, as in @4.08e-3@ or @1.23e7@.
--
-- /Degenerate cases/ zero is @0@ whatever N.
--
-- /Cost/ one integer square root of about 7 N bits per term, unless the digits following the N-th are extreme.
--
-- /Laws/ off by at most half a unit of the last digit; odd in its argument but for the minus sign.
--
-- /Example/ 1\/8 with two digits is @0.12@, 3\/8 is @0.38@, and 9995\/1000 with three is @10.0@.
--
-- /Source/ Ziv, Fast evaluation of elementary mathematical functions with correctly rounded last bit (1991).
decimal :: Digits -> RootSum -> String
decimal n s = written n (rounded (firstBits n) (toDecimal Nearest n) s)

-- | The 'decimal' of a number of which a positive enclosure is known, if both ends have the same one, neither is a
-- tie, and no power of ten is in between.
--
-- /Cost/ a multiplication and a shift of numbers with as many bits as the enclosure and the digits have. With
-- 'positiveDecimal' of both ends instead, @factors@ takes 1.15 times as long.
--
-- /Laws/ it is the 'decimal' of each rational in the enclosure.
--
-- /Degenerate cases/ 'Nothing' for numbers of 10ᴺ or more, and for a positive exponent of the enclosure.
decimalBetween :: Digits -> Scaled -> Maybe String
decimalBetween n@(Digits count) (Scaled low high k)
  | k > 0 || low <= 0 = Nothing
  | otherwise = place ((toInteger (integerLog2' low + k) * 30103) `div` 100000)
  where
    integerLog2' = fromIntegral . integerLog2
    (least, limit) = (powerOfTen (count - 1), powerOfTen count)
    -- The estimate may be off; the digits before the point tell.
    place exponent'
      | shift' < 0 = Nothing
      | halves < 2 * least = place (exponent' - 1)
      | halves >= 2 * limit = place (exponent' + 1)
      | nearest /= nearestTo (halvesOf high) || odd halves && times low .&. (bit (negate k) - 1) == 0 = Nothing
      | nearest == limit = Just (written n (Decimal least (fromInteger exponent' + 1)))
      | otherwise = Just (written n (Decimal nearest (fromInteger exponent')))
      where
        shift' = count - 1 - fromInteger exponent'
        times x = 2 * powerOfTen shift' * x
        -- Twice the number in units of its last digit, rounded down; a tie where it is odd and nothing was cut off.
        halvesOf x = times x `shiftR` negate k
        halves = halvesOf low
        nearest = nearestTo halves
        nearestTo twice = (twice + 1) `shiftR` 1

powerOfTen :: Int -> Integer
powerOfTen k
  | k < V.length powers = powers V.! k
  | otherwise = 10 ^ k
  where
    powers = V.iterateN 64 (* 10) 1
{-# NOINLINE powerOfTen #-}

-- | Two rationals written like 'decimal', but rounded outwards: the first one downwards, the second one upwards.
--
-- /Degenerate cases/ zero is @0@ whatever N.
--
-- /Laws/ what is written encloses the interval; an end that has N digits or less stays. Each end moves by less than a
-- unit of its last digit.
--
-- /Example/ (1\/3, 2\/3) with two digits is @0.33@, @0.67@.
outwardDecimals :: Digits -> (Rational, Rational) -> (String, String)
outwardDecimals n (low, high) = (written n (toDecimal Downwards n low), written n (toDecimal Upwards n high))

-- | Enough bits for the digits, and some more so that a second look is seldom needed.
firstBits :: Digits -> Int
firstBits (Digits n) = 10 * n `quot` 3 + 28

-- | The Double nearest to a sum of roots; a tie, possible only for a rational, goes to the even significand.
--
-- /Degenerate cases/ from 2¹⁰²⁴ − 2⁹⁷⁰ on, in absolute value, the result is an infinity of the right sign, as IEEE 754
-- has it. Subnormal results are rounded once. A nonzero number of absolute value 2⁻¹⁰⁷⁵ or less gives 0, or −0 if
-- negative.
--
-- /Laws/ exact on numbers that are Doubles; monotone.
nearestDouble :: RootSum -> Double
nearestDouble = rounded 80 fromRational

-- | The shortest exact text of a rational: @2@, @1\/3@, @-7\/2@.
rationalText :: Rational -> String
rationalText q
  | denominator q == 1 = show (numerator q)
  | otherwise = shows (numerator q) ('/' : show (denominator q))

-- | Rounds by a monotone function whose steps are at rational places, after a first look at so many bits. An irrational
-- number has an enclosure for each number of bits, shrinking to it.
rounded :: Eq a => Int -> (Rational -> a) -> RootSum -> a
rounded bits f s = fromMaybe settled (agreed (enclosureRelative bits s))
  where
    settled = maybe (refine 128) f (asRational s)
    refine k = fromMaybe (refine (2 * k)) (agreed (enclosureRelative k whole))
    whole = merged s
    agreed (low, high)
      | low > 0 || high < 0, let found = f low, found == f high = Just found
      | otherwise = Nothing

-- | An integer of N digits, with its sign, and the decimal exponent of its leading digit; or zero.
data Decimal = Decimal !Integer !Int
  deriving (Eq)

-- | Which decimal stands for a number that is between two of them.
data Toward
  = -- | The nearest one, of two the one with the even last digit.
    Nearest
  | Downwards
  | Upwards

toDecimal :: Toward -> Digits -> Rational -> Decimal
toDecimal toward n q
  | q == 0 = Decimal 0 0
  | q < 0 = let Decimal m e = positive (opposite toward) (negate q) in Decimal (negate m) e
  | otherwise = positive toward q
  where
    opposite Nearest = Nearest
    opposite Downwards = Upwards
    opposite Upwards = Downwards
    positive way a = positiveDecimal way n (numerator a) (denominator a)

-- | The decimal of a quotient of two positive integers. The exponent is estimated from their lengths in bits, which is
-- nearly always at most one off; the digits before the point tell.
positiveDecimal :: Toward -> Digits -> Integer -> Integer -> Decimal
positiveDecimal toward (Digits n) a b = place (fromInteger ((bits a - bits b) * 30103 `div` 100000))
  where
    bits = toInteger . integerLog2
    (least, limit) = (powerOfTen (n - 1), powerOfTen n)
    place e
      | whole < least = place (e - 1)
      | whole >= limit = place (e + 1)
      | up + whole == limit = Decimal least (e + 1)
      | otherwise = Decimal (up + whole) e
      where
        shift = n - 1 - e
        y = b * powerOfTen (max 0 (negate shift))
        (whole, rest) = (a * powerOfTen (max 0 shift)) `quotRem` y
        up = case toward of
          Downwards -> 0
          Upwards -> if rest == 0 then 0 else 1
          Nearest -> case compare (2 * rest) y of
            LT -> 0
            EQ -> whole `rem` 2
            GT -> 1

written :: Digits -> Decimal -> String
written (Digits n) (Decimal m e)
  | m == 0 = "0"
  | m < 0 = '-' : unsigned
  | otherwise = unsigned
  where
    figures = show (abs m)
    unsigned
      | e < -2 || e >= n = pointAfter 1 figures ++ 'e' : show e
      | e < 0 = "0." ++ replicate (-1 - e) '0' ++ figures
      | otherwise = pointAfter (e + 1) figures

pointAfter :: Int -> String -> String
pointAfter k figures = case splitAt k figures of
  (whole, "") -> whole
  (whole, part) -> whole ++ '.' : part
