-- | What a side sees, by the faces with the side at back or front, and their measures from their own boundaries.
module Visibility.Complex.Walk.Side
  ( sees
  , faceMeasure
  ) where

import qualified Data.Map.Strict as Map
import Data.Ratio ((%))
import qualified Data.Set as Set
import Data.Tuple (swap)
import Visibility.Complex.Type
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Exact.RootSum (RootSum)
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.FormFactor (FormFactor, formFactor)
import Visibility.Scene

-- | All that a side of the file sees, with exact measures and form factors, by the names of what is seen, the sky last:
-- all its pieces together, so faces have positive measures, and no factor is zero. 'Nothing' if the file has no such
-- side.
--
-- /Cost/ O(number of faces), and the boundaries of the side's faces, besides the arithmetic of sums of roots.
--
-- /Laws/ equal to those that are added up along the sweep ('Visibility.FormFactor.formFactors'); they sum up to the
-- part of the side that is not covered.
sees :: Complex -> SideName -> Maybe [FormFactor]
sees complex name = looked . Set.fromList . map Side <$> piecesOf scene name
  where
    scene = complexScene complex
    looked pieces = map factor (Map.toAscList (Map.map RootSum.merged (RootSum.totalsBy measured)))
      where
        measured =
          [ (seenAs scene other, faceMeasure complex f)
          | f <- faceIds complex
          , let ends = (faceBack complex f, faceFront complex f)
          , (side, other) <- if uncurry (==) ends then [ends] else [ends, swap ends]
          , side `Set.member` pieces
          ]
    factor (object, total) = formFactor scene name object total

-- | The measure of the lines of a face, its area in the dual, in the file's units: the integral of its upper boundary
-- less that of its lower one. A corner's curve adds what its position along the line gains from one end of the
-- stretch to the other.
--
-- /Degenerate cases/ where the half turn's end cuts the face or a stretch, directions go on turning.
--
-- /Requires/ a face with a first vertex. /Cost/ one gcd and one square for each end of a stretch.
--
-- /Source/ Orti, Rivière, Durand, Puech, Using the visibility complex for radiosity computation, propositions 1 and 2.
faceMeasure :: Complex -> FaceId -> RootSum
faceMeasure complex f = along (upperChain complex f) - along (lowerChain complex f)
  where
    scene = complexScene complex
    unit = latticeScale (sceneLattice scene)
    along (Chain early late) = mconcat (concatMap (gained id) early <> concatMap (gained reversed) late)
    gained turned e =
      [ position (edgeCorner complex e) (turned (passed (edgeTo complex e)))
      , negate (position (edgeCorner complex e) (turned (edgeFrom complex e)))
      ]
      where
        passed = if wrapsAround complex e then reversed else id
    position c d = RootSum.hypotenuse ((x * dx + y * dy) % (unit * w * (dx * dx + dy * dy))) dx dy
      where
        LatticePoint x y w = cornerAt scene c
        Direction dx dy = primitive d
