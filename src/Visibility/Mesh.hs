-- | The discontinuity mesh: where the lines of the vertices of the complex land on sides, exactly.
--
-- Along a side, what is seen from a point changes at its break points only. See docs/mesh.md.
--
-- /Source/ Orti, Rivière, Durand, Puech, Using the visibility complex for radiosity computation, §4.2.
module Visibility.Mesh
  ( -- * Break points and meshes
    module Visibility.Mesh.Type
    -- * Elements
  , module Visibility.Mesh.Element
    -- * Making them
  , discontinuityMesh
  , uniformMesh
  , uniformSides
    -- * Fewer break points
  , shadowLimits
  , bounded
  ) where

import Data.Function (on)
import Data.List (sortBy, sortOn)
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.List.NonEmpty as NonEmpty
import Data.Maybe (fromMaybe)
import Data.Ord (Down (..), comparing)
import Data.Ratio ((%))
import qualified Data.Vector as V
import Visibility.Exact.Point (LatticePoint (..))
import Visibility.Law (broken)
import Visibility.Mesh.Bound
import Visibility.Mesh.Element (Refined)
import Visibility.Mesh.Element hiding (Refined (..))
import Visibility.Mesh.Landing
import Visibility.Mesh.Span
import Visibility.Mesh.Type (Mesh)
import Visibility.Mesh.Type hiding (Mesh (..))
import qualified Visibility.Mesh.Type as Inside
import Visibility.Scene
import Visibility.Sweep.Vertex

-- | The break points of all sides: wherever the maximal free segment of a vertex ends strictly inside a side, on the
-- face that is seen.
--
-- /Degenerate cases/ where a segment ends at a corner there is no break point, nor where it is lost in the sky. Where
-- several lines land at one point, it is one break point with all their casters.
--
-- /Requires/ all vertices of the scene, in an order in which each corner's vertices come by increasing direction.
-- /Cost/ O(m log m); the sides are cut one by one, when they are asked for.
--
-- /Laws/ the same for every order of the vertices; within an element all points see the same objects in the same order,
-- and on both sides of a break point they see others.
discontinuityMesh :: Scene -> [Vertex] -> Mesh
discontinuityMesh scene swept = Inside.Mesh scene (V.imap cut (pieceSpans scene))
  where
    found = landings scene swept
    place = cornerAt scene
    cut i piece = map breakPoint (NonEmpty.groupBy ((==) `on` fst) sorted)
      where
        s = SideId i
        along = alongSide piece (place (sideStart s)) (place (sideEnd scene s))
        sorted = sortBy order [(along (place p) (place q), caster) | caster@(Caster _ p q) <- landingsOn found s]
        -- From the start of the piece on.
        order = if spanStart piece < spanEnd piece then comparing fst else comparing (Down . fst)
        breakPoint ((t, caster) :| others) = BreakPoint t (pointOn piece t) (Cast (ordered (caster :| map snd others)))
    ordered casters@(_ :| []) = casters
    ordered casters = NonEmpty.sortWith (\caster -> (casterKind caster, casterNames scene caster)) casters

-- | The parameter of the point of a piece that lies on the line through two points, the ends of the piece being given.
--
-- /Requires/ that the line meets the piece strictly between its ends.
alongSide :: Span -> LatticePoint -> LatticePoint -> LatticePoint -> LatticePoint -> Rational
alongSide piece from to (LatticePoint px py pw) (LatticePoint qx qy qw)
  | signum a /= signum b || a == 0 = broken "a line lands strictly inside a side" (show (a, b))
  | otherwise = case (spanStart piece, spanEnd piece) of
      (0, 1) -> a % (a + b)
      (1, 0) -> b % (a + b)
      (start, end) -> start + (a % (a + b)) * (end - start)
  where
    -- The line through the two points; what its equation says of the ends of the piece has different signs.
    (lx, ly, lw) = (py * qw - pw * qy, pw * qx - px * qw, px * qy - py * qx)
    a = above from * weight to
    b = negate (above to * weight from)
    above (LatticePoint x y w) = lx * x + ly * y + lw * w
    weight (LatticePoint _ _ w) = w

-- | Each side of the file cut into so many equal parts, whatever covers it: points that are covered, or at an end of
-- what is not, are no break points.
--
-- /Cost/ O(1) per break point.
uniformMesh :: ElementCount -> Scene -> Mesh
uniformMesh parts scene = Inside.Mesh scene (V.map cut (pieceSpans scene))
  where
    cut piece = (if spanStart piece < spanEnd piece then id else reverse) (equalParts parts piece)

-- | The sides of the file with the break points of 'uniformMesh', by name. Nothing keeps the points, so they can be
-- printed in constant memory, however many they are.
--
-- /Law/ @uniformSides parts scene == meshSides (uniformMesh parts scene)@
uniformSides :: ElementCount -> Scene -> [(SideName, [BreakPoint])]
uniformSides parts scene = [(side, concatMap (equalParts parts) (spansOf side)) | side <- statedSides scene]
  where
    spans = pieceSpans scene
    spansOf side = sortOn lowEnd [spans V.! s | SideId s <- fromMaybe [] (piecesOf scene side)]
    lowEnd piece = min (spanStart piece) (spanEnd piece)

-- The break points inside a piece, by ascending parameter.
equalParts :: ElementCount -> Span -> [BreakPoint]
equalParts parts piece = [BreakPoint t (pointOn piece t) EqualParts | k <- inside, let t = k % n]
  where
    n = toInteger (countedElements parts)
    (start, end) = (spanStart piece, spanEnd piece)
    inside = [floor (min start end * fromInteger n) + 1 .. ceiling (max start end * fromInteger n) - 1]

-- | Without the kinks.
shadowLimits :: Mesh -> Mesh
shadowLimits mesh =
  mesh {Inside.breakTable = V.map (filter ((== Just ShadowLimit) . breakKind)) (Inside.breakTable mesh)}
