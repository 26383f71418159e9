-- | The string rule in Doubles: plain, and compensated by error-free transformations.
--
-- /Source/ Hottel's string rule, as it telescopes along a sweep; Dekker, Knuth for the transformations.
module Estimate.Strings
  ( plainStrings
  , compensatedStrings
  ) where

import Control.Monad (forM_, when)
import Control.Monad.ST (ST)
import Data.Ratio ((%))
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Estimate.Matrix
import Visibility.Exact.DoubleDouble hiding (halfQuotient)
import Visibility.Exact.Point (Point (..), Vector2 (..), Way (..), latticeScale)
import Visibility.FormFactor.Exact (byName)
import Visibility.FormFactor.Terms
import Visibility.Scene
import Visibility.Sweep (Piece)

-- | Each form factor as a sum of distances in Doubles, in the order of the sweep, divided by twice the length of a
-- side. Nothing is said of the error.
--
-- /Cost/ O(1) per elementary pair.
plainStrings :: Scene -> [Piece] -> Matrix
plainStrings scene pieces = matrixFrom n $ eachPair n groups $ \g from ->
  groupTerms (\total slot times -> total + fromIntegral times * (distances U.! slot)) 0 groups g / (2 * halves U.! from)
  where
    terms = termsInPieces scene pieces
    groups = byName scene terms
    n = U.length halves
    distances = U.generate (slotCount terms) (euclid . displacement scene terms)
    halves = U.fromList (map (euclid . spanOf scene) (statedSides scene))
    euclid (dx, dy) = sqrt (dx * dx + dy * dy)

-- | The same with lengths and sums in two Doubles, rounded at the end without asking whether that is right.
--
-- /Cost/ O(1) per elementary pair.
compensatedStrings :: Scene -> [Piece] -> Matrix
compensatedStrings scene pieces = matrixFrom n $ eachPair n groups $ \g from ->
  halfQuotient (groupTerms longer noLengths groups g) (halves V.! from)
  where
    longer total slot = plusLength total (distances V.! slot)
    terms = termsInPieces scene pieces
    groups = byName scene terms
    n = V.length halves
    distances = V.generate (slotCount terms) (uncurry doubleLength . displacement scene terms)
    halves = V.fromList (map (uncurry doubleLength . spanOf scene) (statedSides scene))

-- | The length of a vector of Doubles, like 'machineLength', as long as no square leaves the range of Doubles; but
-- nothing is proved of it.
doubleLength :: Double -> Double -> Double2
doubleLength x y
  | h == 0 = Double2 0 0
  | otherwise = Double2 s (e / (2 * s))
  where
    (a, a') = twoProduct x x
    (b, b') = twoProduct y y
    (h, l) = twoSum a b
    s = sqrt h
    (p, p') = twoProduct s s
    e = ((h - p) - p') + (l + (a' + b'))

-- | A sum of lengths divided by twice a length, in one Double, without asking whether it is the nearest one.
halfQuotient :: Sum2 -> Double2 -> Double
halfQuotient (Sum2 a b _ _) (Double2 length1 length2) = q + (((x - p) - p') + (x' - q * (2 * length2))) / d
  where
    (x, x') = twoSum a b
    d = 2 * length1
    q = x / d
    (p, p') = twoProduct q d

-- | Puts the value of each group from both of its numbers, but not from the sky, whose number is n.
eachPair :: Int -> Groups -> (Int -> Int -> Double) -> (Int -> Int -> Double -> ST s ()) -> ST s ()
eachPair n groups value put =
  forM_ [0 .. groupCount groups - 1] $ \g -> do
    let (a, b) = groupPair groups g
    put a b (value g a)
    when (b < n) $ put b a (value g b)
{-# INLINE eachPair #-}

-- | The way along a slot, from the Doubles nearest to both corners.
displacement :: Scene -> Terms -> Slot -> (Double, Double)
displacement scene terms slot = (x' - x, y' - y)
  where
    (a, b) = slotEnds terms slot
    (x, y) = rounded a
    (x', y') = rounded b
    rounded c = let Point u v = cornerPoint scene (CornerId c) in (fromRational u, fromRational v)

spanOf :: Scene -> SideName -> (Double, Double)
spanOf scene side = (fromRational (x % (scale * w)), fromRational (y % (scale * w)))
  where
    Way (Vector2 x y) w = sideSpan scene side
    scale = latticeScale (sceneLattice scene)
