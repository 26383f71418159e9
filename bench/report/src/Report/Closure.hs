-- | How far the form factors of a side are from closure, that is, from adding up to the part of it that nothing covers.
module Report.Closure
  ( Closure (..)
  , tolerance
  , closureExactly
  , closureInDoubles
  ) where

import Estimate.Matrix
import Estimate.Strings
import Visibility.Exact.Point (Arithmetic (UnsafeDouble))
import Visibility.Exact.RootSum (Sign (Zero), sign)
import Visibility.Exact.Rounding (nearestDouble)
import Visibility.FormFactor (closureDefect, measures, sideLength)
import Visibility.Scene
import Visibility.Sweep

-- | What closure is like on a scene.
data Closure = Closure
  { closureSides :: !Int
  , closureOpen :: !Int
  -- ^ The sides whose form factors do not add up to what they should.
  , closureWorst :: !(Maybe Double)
  -- ^ How far the farthest sum is from what it should be; nothing where a sum is no number.
  }

-- | In Doubles, a sum that is not farther off counts as right.
tolerance :: Double
tolerance = 1e-9

-- | Decided exactly, on the topology that the scene's arithmetic finds: open is what is off at all.
--
-- /Cost/ much more than that of the sweep, for sums of roots.
closureExactly :: Scheduler -> Scene -> Closure
closureExactly scheduler scene =
  closureOf
    (\(_, defect) -> sign defect /= Zero)
    (\(side, defect) -> nearestDouble defect / (2 * nearestDouble (sideLength scene side)))
    (closureDefect scene (measures scene (verticesBy scheduler scene)))

-- | All in Doubles: topology, distances in the file's coordinates, and sums. Open is what is off by more than
-- 'tolerance', or no number.
closureInDoubles :: Scene -> Closure
closureInDoubles scene = closureOf (not . (<= tolerance) . abs) id (zipWith lacking [0 ..] (statedSides under))
  where
    under = underArithmetic UnsafeDouble scene
    matrix = plainStrings under (verticesInPieces under)
    lacking row side =
      sum (map (entryAt matrix row) [0 .. matrixSize matrix]) - fromRational (uncovered under side)

closureOf :: (a -> Bool) -> (a -> Double) -> [a] -> Closure
closureOf isOpen off sums =
  Closure
    { closureSides = length sums
    , closureOpen = length (filter isOpen sums)
    , closureWorst = if all isNumber distances then Just (maximum (0 : distances)) else Nothing
    }
  where
    distances = map (abs . off) sums
    isNumber x = not (isNaN x || isInfinite x)
