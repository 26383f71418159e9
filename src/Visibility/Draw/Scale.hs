-- | Round numbers and exact conversions for figures: scenes may be anywhere and of any size, so coordinates are taken
-- relative to the scene before they become Doubles.
module Visibility.Draw.Scale
  ( -- * Round numbers
    roundStep
  , multiplesWithin
  , decimalText
  , shortNumber
  , roundedTo
  , thinned
    -- * Conversions
  , directionAngle
    -- * Counted things
  , counted
  , countedVertices
  , countedUnlabelled
  , mergedFact
  ) where

import Data.Bits (shiftR)
import Data.Ratio (denominator, numerator)
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as Text
import Visibility.Exact.IntegerRoot (bitLength)
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.Predicate (Direction (..))

-- | The largest of 1, 2 and 5 times a power of ten that is at most the argument.
--
-- /Requires/ a positive number.
--
-- >>> map (decimalText . roundStep) [0.5, 0.49, 1999]
-- ["0.5","0.2","1000"]
roundStep :: Rational -> Rational
roundStep x = maximum (power : [m * power | m <- [2, 5], m * power <= x])
  where
    power = until (\p -> p * 10 > x) (* 10) (until (<= x) (/ 10) 1)

-- | The multiples of a positive step from a least to a greatest value, both included.
multiplesWithin :: Rational -> Rational -> Rational -> [Rational]
multiplesWithin step low high = [fromInteger k * step | k <- [ceiling (low / step) .. floor (high / step)]]

-- | The multiple of a positive step next to a number.
roundedTo :: Rational -> Rational -> Rational
roundedTo step x = fromInteger (round (x / step)) * step

-- | The numbers from the first to the last, or every second, third and so on, so that there are at most so many steps.
--
-- /Requires/ at least one step.
--
-- >>> thinned 3 0 7
-- [0,3,6]
thinned :: Int -> Int -> Int -> [Int]
thinned most from to = [from, from + max 1 ((to - from + most - 1) `div` most) .. to]

-- | A finite decimal, exactly; with an exponent where it would be long. A number that is no finite decimal is given as
-- a fraction.
--
-- >>> map decimalText [1/4, -20, 3 * 10^9, 1/3]
-- ["0.25","−20","3e9","1/3"]
decimalText :: Rational -> Text
decimalText x
  | x < 0 = Text.cons '−' (decimalText (negate x))
  | x == 0 = Text.pack "0"
  | not (isDecimal (denominator x)) = Text.pack (show (numerator x) <> "/" <> show (denominator x))
  | e >= 0 && (e < 5 || length figures + e <= 7) = Text.pack (figures <> replicate e '0')
  | e < 0 && point > 0 = Text.pack (take point figures <> "." <> drop point figures)
  | e < 0 && point > -4 = Text.pack ("0." <> replicate (negate point) '0' <> figures)
  | otherwise = Text.pack (take 1 figures <> mantissaRest <> "e" <> minus <> show (abs (point - 1)))
  where
    isDecimal d = until ((/= 0) . (`rem` 2)) (`quot` 2) (until ((/= 0) . (`rem` 5)) (`quot` 5) d) == 1
    (m, e) = trim (until ((== 1) . denominator . fst) (\(v, k) -> (v * 10, k - 1)) (x, 0 :: Int))
    trim (v, k) = until ((/= 0) . (`rem` 10) . fst) (\(n, j) -> (n `quot` 10, j + 1)) (numerator v, k)
    figures = show m
    point = length figures + e
    minus = if point < 1 then "−" else ""
    mantissaRest = if length figures > 1 then '.' : drop 1 figures else ""

-- | A number to about three digits, as captions have it.
--
-- >>> map shortNumber [0.41421356, 1, 1/12345, 0]
-- ["0.414","1","8.1e−5","0"]
--
-- /Requires/ a number that is not infinite.
shortNumber :: Double -> Text
shortNumber v
  | v == 0 = decimalText 0
  | otherwise = decimalText (roundedTo step (toRational v))
  where
    step = 10 ^^ (floor (logBase 10 (abs v)) - 2 :: Int)

-- | The angle of a direction in radians.
--
-- /Degenerate cases/ components of any size; the angle of (0, 1) is π/2 and that of (0, −1) is −π/2, as near as a
-- Double comes.
directionAngle :: Direction -> Double
directionAngle (Direction dx dy) = atan2 (small dy) (small dx)
  where
    small v = fromInteger (v `shiftR` excess)
    excess = max 0 (max (bitLength dx) (bitLength dy) - 900)

-- | A number of things, in words that fit it.
--
-- >>> counted 1 "vertex" "vertices"
-- "1 vertex"
counted :: Int -> String -> String -> Text
counted k one many = Text.pack (show k <> " " <> if k == 1 then one else many)

-- | The vertices, and how many of them are degenerate.
countedVertices :: Int -> Int -> Text
countedVertices total degenerate
  | degenerate > 0 = counted total "vertex" "vertices" <> Text.pack (" (" <> show degenerate <> " degenerate)")
  | otherwise = counted total "vertex" "vertices"

-- | The corners whose labels found no place, if there are any.
countedUnlabelled :: [a] -> [Text]
countedUnlabelled [] = []
countedUnlabelled missing =
  [counted (length missing) "corner without room for its label" "corners without room for their labels"]

-- | What a figure says of corners that it cannot tell apart, by the size of a pixel in the units of the points.
--
-- Places are told apart to a hundredth of a pixel. A scene may have parts that differ by more, as two corners that are
-- 1 apart where others are at 10^72. Coordinates are taken relative to the scene's box before they are rounded, so such
-- corners fall together in one place and nothing else moves. Whether something lies left or right, in front or behind
-- is never read off places: that is decided by the exact coordinates.
--
-- /Laws/ nothing is said where all places are different. /Cost/ O(n log n).
mergedFact :: Rational -> [Point] -> [Text]
mergedFact pixel points
  | merged == 0 = []
  | otherwise =
    [ counted merged "corner drawn in the place of another" "corners drawn in the places of others"
        <> Text.pack ", less than "
        <> decimalText (roundStep (2 * seen))
        <> Text.pack " away"
    ]
  where
    seen = pixel / 100
    merged = Set.size (Set.fromList points) - Set.size (Set.fromList (map place points))
    (left, bottom) = (minimum [x | Point x _ <- points], minimum [y | Point _ y <- points])
    place (Point x y) = (round ((x - left) / seen), round ((y - bottom) / seen)) :: (Integer, Integer)
