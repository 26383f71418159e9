-- | Form factors, each correctly rounded, to a Double or to a decimal, at a small multiple of the cost of computing
-- with Doubles.
module Visibility.FormFactor.Rounded
  ( FactorRow (..)
  , nearestFactors
  , decimalFactors
  , exactFactors
  ) where

import Data.ByteString.Char8 (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import Data.Maybe (catMaybes, isNothing)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.DoubleDouble
import Visibility.Exact.IntegerRoot (bitLength)
import Visibility.Exact.Point
import Visibility.Exact.RootSum (RootSum)
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Exact.Rounding
import Visibility.FormFactor.Exact
import Visibility.FormFactor.Terms
import Visibility.Scene

-- | The form factors of a side of the file, each correctly rounded.
data FactorRow a = FactorRow
  { rowFrom :: !SideName
  , rowFactors :: [(Seen, a)]
  -- ^ What the light from it reaches, by name, the sky last.
  , rowByRoots :: Int
  -- ^ For how many of them an exact sum of roots was needed.
  }
  deriving (Eq, Show)

-- | All form factors that are not exactly zero, each rounded to the nearest Double, a tie to the even one, by the side
-- they leave. Sums are made in two Doubles with a proved bound, and in roots only where that leaves a doubt.
--
-- /Degenerate cases/ those of 'formFactors'; a form factor of 2^−1075 or less is 0, but listed.
--
-- /Cost/ O(1) per term, and an exact sum of roots where it is needed: where lengths cancel to less than about 2^−50 of
-- themselves, as nearly all do in a scene that is 2^40 times as long as it is high.
--
-- /Laws/ the factors are those of 'formFactors', each the 'nearestDouble' of its value.
nearestFactors :: Scene -> Measures -> [FactorRow Double]
nearestFactors = roundedFactors (Rounder nearestHalfQuotient nearestDouble) const
{-# NOINLINE nearestFactors #-}

-- | The same, each as a decimal of so many significant digits.
--
-- /Cost/ that of 'nearestFactors' for up to about 25 digits, for more that of 'decimal' for each.
--
-- /Laws/ the factors are those of 'formFactors', each the 'decimal' of its value.
decimalFactors :: Digits -> Scene -> Measures -> [FactorRow ByteString]
decimalFactors wanted = roundedFactors (toDigits wanted) const
{-# NOINLINE decimalFactors #-}

-- | The same, each with its measure A(s, t) = 2 L_s F_st in the file's units.
--
-- /Laws/ the measures are those of 'formFactors'.
exactFactors :: Digits -> Scene -> Measures -> [FactorRow (ByteString, RootSum)]
exactFactors wanted = roundedFactors (toDigits wanted) (,)
{-# NOINLINE exactFactors #-}

toDigits :: Digits -> Rounder ByteString
toDigits wanted = Rounder between (Bytes.pack . decimal wanted)
  where
    between total by = Bytes.pack <$> (scaledHalfQuotient total by >>= decimalBetween wanted)

-- | How a form factor is rounded: from a sum of lengths and the length to divide twice of, if their bounds leave no
-- doubt that it is positive, and how it is rounded; and from its exact value.
data Rounder a = Rounder !(Sum2 -> Double2 -> Maybe a) !(RootSum -> a)

-- | What is told of a form factor is made of its rounded value and of its measure.
roundedFactors :: Rounder a -> (a -> RootSum -> b) -> Scene -> Measures -> [FactorRow b]
roundedFactors (Rounder inDoubles inRoots) told scene (Measures terms) =
  [ FactorRow name (catMaybes (zipWith listed reached quick)) (length (filter isNothing quick))
  | (r, name, reached) <- factorRows scene groups
  , let quick = map (\(_, g) -> inDoubles (sumAt g) (sideLengths r)) reached
        listed (other, g) found = do
          x <- maybe (exactly (formFactor scene name) other g) Just found
          Just (other, told x (totals g))
  ]
  where
    groups = byName scene terms
    exactly value other g
      | null (RootSum.terms total) = Nothing
      | otherwise = Just $! inRoots (factorValue (value other total))
      where
        total = totals g
    totals = groupSums scene terms groups

    sumAt g = let (a, b, bound, number) = sums U.! g in Sum2 a b bound number
    sums = U.generate (groupCount groups) $ \g ->
      let Sum2 a b bound number = groupTerms (\total -> plusLength total . distances) noLengths groups g
       in (a, b, bound, number)
    distances = lengthsOf (slotCount terms) (lengthOf . alongSlot)
    alongSlot slot = let (a, b) = slotEnds terms slot in way (corner a) (corner b)
    corner = cornerAt scene . CornerId
    sideLengths = lengthsOf (V.length spans) (lengthOf . (spans V.!))
    spans = V.fromList (map (sideSpan scene) (statedSides scene))
    -- All coordinates are below 2^reach.
    reach = maximum (0 : map size (V.toList spans) <> map (size . inPlace . cornerAt scene) (corners scene))
    inPlace (LatticePoint x y w) = Way (Vector2 x y) w
    size (Way (Vector2 x y) w) = max (bitLength x) (bitLength y) - bitLength w + 1
    areWhole = all (isWhole . cornerAt scene) (corners scene)
    lengthOf (Way (Vector2 x y) w)
      | areWhole && reach <= 31 = machineLength (fromInteger x) (fromInteger y)
      | otherwise = scaledLength reach x y w
{-# INLINE roundedFactors #-}

-- | Lengths by number.
lengthsOf :: Int -> (Int -> Double2) -> Int -> Double2
lengthsOf n f = \k -> let (high, low) = table U.! k in Double2 high low
  where
    table = U.generate n (\k -> let Double2 high low = f k in (high, low))
{-# INLINE lengthsOf #-}
