-- | Exact sums of the terms of pairs of objects: distances between corners, as multiples of square roots.
--
-- Where places are small, a distance is three machine words: as integers of any size for all scenes, @factors --exact@
-- of 1 000 quadrilaterals takes 1.3 times as long and 1.2 times the memory.
module Visibility.FormFactor.Sums
  ( groupSums
  ) where

import Control.Monad (forM_)
import Data.Bits (Bits)
import Data.Int (Int32)
import Data.List (foldl')
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.Point
import Visibility.Exact.RootSum (RootSum)
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Exact.SquareClass
import Visibility.FormFactor.Terms
import Visibility.Scene

-- | The measure of a group, in the file's units, terms merged.
--
-- /Cost/ that of 'RootSum.mergedSum'. Where places are small, all distances are found when the first one is needed, and
-- kept in three words each; a sum asked for again is added up again, which takes less than to keep them all. Where they
-- are large, distances and sums are kept once they are found.
groupSums :: Scene -> Terms -> Groups -> Int -> RootSum
groupSums scene terms groups = case pointPlaces (scenePoints scene) of
  SmallPlaces xs -> smallSum (smallDistances xs)
  LargePlaces points ->
    let distances = V.generate (slotCount terms) (largeDistance points . slotEnds terms)
     in (V.generate (groupCount groups) (largeSum distances) V.!)
  where
    scale = latticeScale (sceneLattice scene)

    smallSum distances g = RootSum.mergedSum scale (groupTerms weigh [] groups g)
      where
        weigh sums slot k =
          let at part = distances U.! (3 * slot + part)
           in (toInteger (k * at 0), PreparedRoot (at 1) 1 (at 2)) : sums
    -- Those of one distance lie together in memory.
    smallDistances xs = U.create $ do
      table <- M.new (3 * slotCount terms)
      forM_ [0 .. slotCount terms - 1] $ \slot -> do
        let (n, PreparedRoot key s m) = smallDistance xs (slotEnds terms slot)
        M.write table (3 * slot) (n * s)
        M.write table (3 * slot + 1) key
        M.write table (3 * slot + 2) m
      pure table

    largeSum distances g =
      RootSum.mergedSum (scale * common) [(n * (common `quot` w), root) | Distance n w root <- found]
      where
        found = groupTerms weigh [] groups g
        weigh sums slot k = let Distance n w root = distances V.! slot in Distance (toInteger k * n) w root : sums
        common = foldl' (\sofar (Distance _ w _) -> if w == 1 then sofar else lcm sofar w) 1 found

-- | A distance on the lattice: a multiple of a root, the factor a fraction.
data Distance = Distance !Integer !Integer !(PreparedRoot Integer)

-- | The distance between two corners in lengths of the primitive lattice vector along their line: between whole points it
-- is an integer multiple of one root.
largeDistance :: V.Vector LatticePoint -> (Int, Int) -> Distance
largeDistance points (a, b) = let (n, root) = inPrimitives x y in Distance n w root
  where
    Way (Vector2 x y) w = (points V.! a) `way` (points V.! b)

-- | The same of whole points with coordinates below 2^31. So the square of a distance is below 2^63.
smallDistance :: U.Vector Int32 -> (Int, Int) -> (Int, PreparedRoot Int)
smallDistance xs (a, b) = inPrimitives (along 0) (along 1)
  where
    along k = fromIntegral (xs U.! (2 * b + k)) - fromIntegral (xs U.! (2 * a + k)) :: Int
{-# INLINE smallDistance #-}

-- | A vector, which is not 0, as a multiple of a primitive one, and the length of that.
inPrimitives :: (Integral a, Bits a) => a -> a -> (a, PreparedRoot a)
inPrimitives x y = (n, preparedRoot (px * px + py * py))
  where
    n = gcd x y
    (px, py) = (x `quot` n, y `quot` n)
{-# INLINE inPrimitives #-}
