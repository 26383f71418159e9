-- | Form factors, each rounded to the nearest Double, at a small multiple of the cost of computing with Doubles.
module Visibility.FormFactor.Nearest
  ( NearestRow (..)
  , nearestFactors
  ) where

import Data.Maybe (fromMaybe)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.DoubleDouble
import Visibility.Exact.IntegerRoot (bitLength)
import Visibility.Exact.Point
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Exact.Rounding (nearestDouble)
import Visibility.FormFactor.Exact
import Visibility.FormFactor.Terms
import Visibility.Scene

-- | The form factors of a side of the file, each correctly rounded to a Double.
data NearestRow = NearestRow
  { rowFrom :: !SideName
  , rowFactors :: [(Seen, Double)]
  -- ^ What the light from it reaches, by name, the sky last.
  , rowByRoots :: Int
  -- ^ For how many of the side's measures an exact sum of roots was needed.
  }
  deriving (Eq, Show)

-- | All form factors that are not exactly zero, each rounded to the nearest Double, a tie to the even one, by the side
-- they leave. Sums are made in two Doubles with a proved bound, and in roots only where that leaves a doubt.
--
-- /Degenerate cases/ those of 'formFactors'; a form factor of 2^−1075 or less is 0, but listed.
--
-- /Cost/ O(1) per term, and an exact sum of roots where it is needed.
--
-- /Laws/ the factors are those of 'formFactors', each the 'nearestDouble' of its value.
nearestFactors :: Scene -> Measures -> [NearestRow]
nearestFactors scene (Measures terms) = [row r name | (r, TheSide name) <- zip [0 ..] (V.toList seen)]
  where
    seen = seenByRank scene
    bound = V.length seen
    groups = byName scene terms
    rows = rowsOf bound groups
    row r name = NearestRow name [(seen V.! other, x) | (other, x, _) <- found, x >= 0] (length [() | (_, _, True) <- found])
      where
        found = [(other, if other > r then x else y, hard) | (other, g) <- rows r, let (x, y, hard) = values U.! g]
    values = U.generate (groupCount groups) nearest

    -- The form factors from the first object and from the second, −1 where there is none; and whether roots were needed.
    nearest g = case (fromDoubles a, fromDoubles b) of
      (Just x, Just y) -> (x, y, False)
      (x, y) -> (fromMaybe (fromRoots a) x, fromMaybe (fromRoots b) y, True)
      where
        (a, b) = groupPair groups g
        sum2 = groupTerms (\sum2' slot -> plusLength sum2' (distances `lengthAt` slot)) noLengths groups g
        total = exactSum g
        fromDoubles k
          | k == bound - 1 = Just (-1)
          | otherwise = nearestHalfQuotient sum2 (sideLengths `lengthAt` k)
        fromRoots k = case seen V.! k of
          TheSide name | not (null (RootSum.terms total)) -> nearestDouble (factorValue (formFactor scene name TheSky total))
          _ -> -1
    exactSum = groupSums scene terms groups

    distances = lengthsOf (slotCount terms) $ \slot ->
      let (a, b, _) = slotEnds terms slot in lengthOf (way (cornerAt scene (CornerId a)) (cornerAt scene (CornerId b)))
    sideLengths = lengthsOf (V.length spans) (lengthOf . (spans V.!))
    spans = V.fromList (map (sideSpan scene) (statedSides scene))
    -- All coordinates are below 2^reach.
    reach = maximum (0 : map size (V.toList spans) <> [max (bitLength x) (bitLength y) | LatticePoint x y _ <- map (cornerAt scene) (corners scene)])
    size (Way (Vector2 x y) _) = max (bitLength x) (bitLength y)
    lengthOf (Way (Vector2 x y) w)
      | w /= 1 = Double2 (0 / 0) (0 / 0)
      | reach <= 31 = machineLength (fromInteger x) (fromInteger y)
      | otherwise = scaledLength reach x y

-- | Lengths by number.
data Lengths = Lengths !(U.Vector Double) !(U.Vector Double)

lengthsOf :: Int -> (Int -> Double2) -> Lengths
lengthsOf n f = Lengths high low
  where
    (high, low) = U.unzip (U.generate n (\k -> let Double2 s t = f k in (s, t)))
{-# INLINE lengthsOf #-}

lengthAt :: Lengths -> Int -> Double2
lengthAt (Lengths high low) k = Double2 (high U.! k) (low U.! k)
{-# INLINE lengthAt #-}
