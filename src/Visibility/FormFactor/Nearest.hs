-- | Form factors, each rounded to the nearest Double, at a small multiple of the cost of computing with Doubles.
module Visibility.FormFactor.Nearest
  ( NearestRow (..)
  , nearestFactors
  ) where

import Data.Maybe (fromMaybe, mapMaybe)
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
-- /Cost/ O(1) per term, and an exact sum of roots where it is needed: where lengths cancel to less than about 2^−50 of
-- themselves, as nearly all do in a scene that is 2^40 times as long as it is high.
--
-- /Laws/ the factors are those of 'formFactors', each the 'nearestDouble' of its value.
nearestFactors :: Scene -> Measures -> [NearestRow]
nearestFactors scene (Measures terms) = [row r name | (r, TheSide name) <- zip [0 ..] (V.toList seen)]
  where
    seen = seenByRank scene
    bound = V.length seen
    groups = byName scene terms
    rows = rowsOf bound groups
    row r name = NearestRow name (mapMaybe listed found) (length [() | (_, Between _ _ InRoots) <- found])
      where
        found = [(other, between `at` g) | (other, g) <- rows r]
        listed (other, Between x y _) = case if other > r then x else y of
          Factor value -> Just (seen V.! other, value)
          NoFactor -> Nothing
    between = tableOf (groupCount groups) nearest

    nearest g = case (inDoubles a, inDoubles b) of
      (Just x, Just y) -> Between x y InDoubles
      (x, y) -> Between (fromMaybe (inRoots a) x) (fromMaybe (inRoots b) y) InRoots
      where
        (a, b) = groupPair groups g
        sum2 = groupTerms (\sum2' slot -> plusLength sum2' (distances `lengthAt` slot)) noLengths groups g
        total = exactSum g
        inDoubles k
          | k == bound - 1 = Just NoFactor
          | otherwise = Factor <$> nearestHalfQuotient sum2 (sideLengths `lengthAt` k)
        inRoots k = case seen V.! k of
          TheSide name | not (null (RootSum.terms total)) -> Factor (nearestDouble (valueFrom name))
          _ -> NoFactor
        valueFrom name = factorValue (formFactor scene name TheSky total)
    exactSum = groupSums scene terms groups

    distances = lengthsOf (slotCount terms) (lengthOf . alongSlot)
    alongSlot slot = let (a, b, _) = slotEnds terms slot in way (corner a) (corner b)
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

-- | What leaves one object of a pair and reaches the other, both ways, the first one's first.
data Between = Between !Value !Value !Means

-- | A form factor that is not exactly zero; the sky has none.
data Value = NoFactor | Factor !Double

-- | Whether sums of Doubles with their bounds told both, or an exact sum of roots was needed.
data Means = InDoubles | InRoots
  deriving (Eq)

-- | A 'Between' for each group, unboxed.
newtype Table = Table (U.Vector (Double, Double, Bool))

tableOf :: Int -> (Int -> Between) -> Table
tableOf n f = Table (U.generate n (\g -> let Between x y means = f g in (packed x, packed y, means == InRoots)))
  where
    packed NoFactor = absent
    packed (Factor x) = x
{-# INLINE tableOf #-}

at :: Table -> Int -> Between
at (Table rows) g = Between (unpacked x) (unpacked y) (if rooted then InRoots else InDoubles)
  where
    (x, y, rooted) = rows U.! g
    unpacked v = if v == absent then NoFactor else Factor v
{-# INLINE at #-}

-- | Stands for 'NoFactor' in a table: no form factor is negative.
absent :: Double
absent = -1

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
