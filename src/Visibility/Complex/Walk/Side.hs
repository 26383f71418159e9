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
-- stretch to the other. So each vertex of the boundary adds the way along its line from the corner of one stretch to
-- that of the next.
--
-- /Degenerate cases/ where the half turn's end cuts the face or a stretch, directions go on turning.
--
-- /Requires/ a face with a first vertex, corners of a vertex on its line. /Cost/ one gcd and one square for each vertex
-- of the boundary at which the corner changes.
--
-- /Source/ Orti, Rivière, Durand, Puech, Using the visibility complex for radiosity computation, propositions 1 and 2.
faceMeasure :: Complex -> FaceId -> RootSum
faceMeasure complex f = mconcat (begun <> along upper <> map negate (along lower) <> ended)
  where
    scene = complexScene complex
    unit = latticeScale (sceneLattice scene)
    (upper, lower) = (flattened (upperChain complex f), flattened (lowerChain complex f))
    flattened (Chain early late) = [(e, id) | e <- early] <> [(e, reversed) | e <- late]
    along chain = [between later earlier (beginning later) | (earlier, later) <- zip chain (drop 1 chain)]
    begun = [between u l (beginning u) | (u, l) <- zip (take 1 upper) (take 1 lower)]
    ended = [between l u (end u) | (u, l) <- zip (lastOf upper) (lastOf lower)]
    lastOf = take 1 . reverse
    beginning (e, turned) = turned (edgeFrom complex e)
    end (e, turned) = turned ((if wrapsAround complex e then reversed else id) (edgeTo complex e))
    -- From the corner of one stretch to that of another, along the line through both.
    between (e, _) (e', _) (Direction dx dy)
      | edgeCorner complex e == edgeCorner complex e' = RootSum.zero
      | otherwise = RootSum.hypotenuse (signum (x * dx + y * dy) % (unit * w)) x y
      where
        Way (Vector2 x y) w = cornerAt scene (edgeCorner complex e) `way` cornerAt scene (edgeCorner complex e')
