{-# LANGUAGE BangPatterns #-}

-- | Scales of values, for axes and for colours, and the bar that explains the colours.
module Visibility.Draw.Values
  ( -- * Scales
    Scaling (..)
  , Values
  , fitted
  , placeOn
  , ticks
  , evenTicks
  , ticksAcross
    -- * Colours
  , Tone (..)
  , shadeOf
  , colourBar
  ) where

import Data.List (foldl')
import Data.Text (Text)
import Visibility.Draw.Colour
import Visibility.Draw.Drawing
import Visibility.Draw.Scale

-- | How values are spread: evenly, or their logarithms.
data Scaling = Linear | Logarithmic
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | A scale, by the values at its ends: those of a logarithmic one by their logarithms to the base 10.
data Values = Values !Scaling !Double !Double
  deriving (Eq, Show)

-- | The scale that some values just fit on. A linear one begins at 0.
--
-- /Degenerate cases/ values that are not positive, or infinite, do not count; if there are no others, a linear scale
-- ends at 1 and a logarithmic one is around 1. A logarithmic scale spans at least a factor of ten, from the greatest
-- value downwards.
fitted :: Scaling -> [Double] -> Values
fitted scaling values = case (scaling, foldl' spanned Nothing values) of
  (Linear, Nothing) -> Values Linear 0 1
  (Linear, Just (_, greatest)) -> Values Linear 0 greatest
  (Logarithmic, Nothing) -> Values Logarithmic (-0.5) 0.5
  (Logarithmic, Just (least, greatest)) ->
    let (low, high) = (logBase 10 least, logBase 10 greatest)
     in Values Logarithmic (min low (high - 1)) high
  where
    spanned found v = case found of
      Just (least, greatest) | counts v -> let { !a = min least v; !b = max greatest v } in Just (a, b)
      Nothing | counts v -> Just (v, v)
      _ -> found
    counts v = v > 0 && not (isInfinite v)

-- | Where a value lies on a scale, from 0 to 1.
--
-- /Degenerate cases/ what lies beyond an end, as 0 on a logarithmic scale, is at that end.
--
-- /Laws/ monotone.
placeOn :: Values -> Double -> Double
placeOn (Values scaling low high) value = case scaling of
  Linear -> kept ((value - low) / (high - low))
  Logarithmic
    | value > 0 -> kept ((logBase 10 value - low) / (high - low))
    | otherwise -> 0
  where
    kept t
      | t >= 1 = 1
      | t > 0 = t
      | otherwise = 0

-- | Round values on a scale, from the least upwards, with their places and texts; at most so many steps between them.
--
-- /Requires/ at least one step.
ticks :: Values -> Int -> [(Double, Text)]
ticks (Values scaling low high) most = case scaling of
  Linear -> evenTicks (toRational high) most
  Logarithmic
    | last' - first >= 2 -> [tick (10 ^^ k) | k <- thinned most first last']
    | otherwise -> map tick (fewEnough (map leading [[1, 2, 5], [1, 3], [1]]))
  where
    (first, last') = (ceiling low, floor high) :: (Int, Int)
    leading digits = [value | k <- [first - 1 .. last'], m <- digits, let value = m * 10 ^^ k, within value]
    within value = let l = logBase 10 (fromRational value) in l >= low && l <= high
    fewEnough choices = case filter ((<= most + 1) . length) choices of
      found : _ -> found
      [] -> []
    tick value = (placeOn (Values scaling low high) (fromRational value), decimalText value)

-- | The same on a linear scale from 0 to a number of any size.
evenTicks :: Rational -> Int -> [(Double, Text)]
evenTicks high most = [(fromRational (value / high), decimalText value) | value <- multiplesWithin step 0 high]
  where
    -- The reciprocals of round steps are round.
    step = 1 / roundStep (fromIntegral most / high)

-- | Round values by how many steps there may be, on a scale that is so many pixels wide: as many, up to eight, as have
-- room for their texts beside each other.
ticksAcross :: Double -> (Int -> [(Double, Text)]) -> [(Double, Text)]
ticksAcross width atMost = case filter fits (map atMost [8, 7 .. 1]) of
  found@(_ : _) : _ -> found
  _ -> take 1 (atMost 1)
  where
    fits found = and (zipWith apart found (drop 1 found))
    apart (s, text) (s', text') =
      (s' - s) * width >= (textWidth TickLabel text + textWidth TickLabel text') / 2 + 4

-- | What bright colours stand for.
data Tone
  = -- | As of light.
    MoreIsBrighter
  | -- | As of ink.
    MoreIsDarker
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | The colour of a value.
--
-- /Laws/ monotone, in the direction that the tone says.
shadeOf :: Tone -> Values -> Double -> Shade
shadeOf tone values = toned tone . shadeAt . placeOn values

toned :: Tone -> Shade -> Shade
toned MoreIsBrighter = id
toned MoreIsDarker = opposite

-- | The colours in a box, from the least value at its left to the greatest, with ticks and their values below.
--
-- /Shape/ cells, then what explains them, which takes 20 pixels below the box and some to its left and right.
colourBar :: Tone -> Values -> Box -> ([Mark], [Mark])
colourBar tone values (Box l b r t) = (zipWith cell [0 ..] shades, frame : concatMap tickMarks found)
  where
    found = ticksAcross (r - l) (ticks values)
    step = (r - l) / fromIntegral (length shades)
    cell k shade = plain (Cell (toned tone shade)) (boxRegion (Box (l + step * k) b (l + step * (k + 1)) t))
    frame = plain Axis (boxRegion (Box l b r t))
    tickMarks (s, text) =
      [ plain Tick (Polyline [Place x (b - 5), Place x b])
      , plain TickLabel (Label MiddleAnchor (Place x (b - 17)) text)
      ]
      where
        x = l + s * (r - l)
