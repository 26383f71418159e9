-- | Exact sums of the terms of pairs of objects: distances between corners, as multiples of square roots.
module Visibility.FormFactor.Sums
  ( groupSums
  ) where

import qualified Data.Vector as V
import Visibility.Exact.Point
import Visibility.Exact.RootSum (RootSum)
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Exact.SquareClass
import Visibility.FormFactor.Terms
import Visibility.Scene

-- | The measure of a group, in the file's units, terms merged.
--
-- /Cost/ that of 'RootSum.mergedSum'. Distances are kept once they are found; a sum asked for again is added up again.
groupSums :: Scene -> Terms -> Groups -> Int -> RootSum
groupSums scene terms groups = sumOf
  where
    scale = latticeScale (sceneLattice scene)
    distances = V.generate (slotCount terms) (distance . slotEnds terms)
    distance (a, b) = distanceAlong (cornerAt scene (CornerId a) `way` cornerAt scene (CornerId b))
    sumOf g = RootSum.mergedSum (scale * common) [(n * (common `quot` w), root) | Distance n w root <- found]
      where
        found = groupTerms weigh [] groups g
        weigh sums slot k = let Distance n w root = distances V.! slot in Distance (toInteger k * n) w root : sums
        common = foldr (\(Distance _ w _) -> lcm w) 1 found

-- | A distance on the lattice: a multiple of a root, the factor a fraction.
data Distance = Distance !Integer !Integer !PreparedRoot

-- | The length of a way, which is not 0, in lengths of the primitive lattice vector along it: between whole points it is
-- an integer multiple of one root.
distanceAlong :: Way -> Distance
distanceAlong (Way (Vector2 x y) w) = Distance n w (preparedRoot (px * px + py * py))
  where
    n = gcd x y
    (px, py) = (x `quot` n, y `quot` n)
