-- | Random draws that are the same for all time: the stream of a seed belongs to the contract of @generate@, so it is
-- written here and not taken from a library.
--
-- /Source/ Steele, Lea, Flood, Fast splittable pseudorandom number generators (2014), the generator SplitMix64.
module Visibility.Scene.Family.Draw
  ( -- * Seeds
    Seed (..)
    -- * Draws
  , Draw
  , runDraw
  , between
  , oneOf
  ) where

import Control.Monad.Trans.State.Lazy (State, evalState, state)
import Data.Bits (shiftR, xor)
import Data.Word (Word64)

-- | What a stream of draws starts from.
newtype Seed = Seed Word64
  deriving (Eq, Ord, Show)

-- | A value that depends on a stream of random words.
type Draw = State Word64

-- | The value from the stream of this number under a seed. Streams of different numbers are unrelated, so that the
-- tenth polygon of a scene does not depend on how many draws the ninth took.
runDraw :: Seed -> Int -> Draw a -> a
runDraw (Seed seed) number draw = evalState draw (mixed (mixed seed + golden * fromIntegral number))

-- | A word after which the state moves on by the golden ratio.
word :: Draw Word64
word = state (\s -> let s' = s + golden in (mixed s', s'))

golden :: Word64
golden = 0x9e3779b97f4a7c15

mixed :: Word64 -> Word64
mixed z0 = z2 `xor` (z2 `shiftR` 31)
  where
    z1 = (z0 `xor` (z0 `shiftR` 30)) * 0xbf58476d1ce4e5b9
    z2 = (z1 `xor` (z1 `shiftR` 27)) * 0x94d049bb133111eb

-- | An integer from a closed range of less than 2³² numbers; the lower bound where the range is empty.
between :: Integer -> Integer -> Draw Integer
between low high
  | high <= low = pure low
  | otherwise = (\w -> low + toInteger (w `shiftR` 11) `mod` (high - low + 1)) <$> word

-- | One of the elements, the first being repeated in front so that there always is one.
oneOf :: a -> [a] -> Draw a
oneOf a as = (\k -> case drop (fromInteger k) as of b : _ -> b; [] -> a) <$> between 0 (toInteger (length as))
