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
import Visibility.Exact.DoubleDouble
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
  halfQuotientDouble (groupTerms longer noLengths groups g) (halves V.! from)
  where
    longer total slot = plusLength total (distances V.! slot)
    terms = termsInPieces scene pieces
    groups = byName scene terms
    n = V.length halves
    distances = V.generate (slotCount terms) (uncurry doubleLength . displacement scene terms)
    halves = V.fromList (map (uncurry doubleLength . spanOf scene) (statedSides scene))

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
