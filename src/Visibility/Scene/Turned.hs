-- | The scene turned by a right angle, for sweeps that begin at the horizontal.
module Visibility.Scene.Turned
  ( quarterTurned
  ) where

import Data.Int (Int32)
import qualified Data.Map.Strict as Map
import qualified Data.Vector as V
import qualified Data.Vector.Algorithms.Intro as Intro
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.Point
import Visibility.Scene.Id
import Visibility.Scene.Type

-- | The scene turned by 90° to the right around the origin, (x, y) to (y, −x), under the same names and arithmetic; and
-- for each of its corners the corner of the given scene that it is.
--
-- A line at an angle θ above 0° lies at θ − 90° there, with its corners in the same order.
--
-- /Degenerate cases/ corners in one place keep their order.
--
-- /Cost/ O(n log n).
--
-- /Laws/ it is the scene that the turned file would give, but for the order of corners in one place where names decide
-- it; @map original (vertices turned)@ are the vertices of the scene.
quarterTurned :: Scene -> (Scene, U.Vector Int32)
quarterTurned scene = (turned, U.map fromIntegral olds)
  where
    n = cornerCount scene
    at c = cornerAt scene (CornerId c)
    width = maximum (0 : [x | c <- [0 .. n - 1], let Vector2 x _ = at c])
    onLattice c = let Vector2 x y = at c in Vector2 y (width - x)
    -- The corners of the scene in the lexicographic order of the turned one, and their places in it.
    olds = U.modify (Intro.sortBy earlier) (U.enumFromN 0 n)
    news = U.update_ (U.replicate n 0) olds (U.enumFromN 0 n)
    earlier c d
      | samePlace scene (CornerId c) (CornerId d) = compare c d
      | otherwise = let Vector2 x y = at c; Vector2 x' y' = at d in compare (y, x') (y', x)
    renumbered i = news U.! i
    ofOld table = V.map (table V.!) (V.convert olds)
    neighbour part i = fromIntegral (renumbered (let CornerId j = part scene (CornerId (olds U.! i)) in j))
    moved (CornerId c) = CornerId (renumbered c)
    startingAt (SideId s) = SideId (renumbered s)
    Lattice scale (Vector2 originX originY) = sceneLattice scene
    turned =
      scene
        { sceneLattice = Lattice scale (Vector2 originY (negate width - originX))
        , scenePoints = pointsOn (sceneArithmetic scene) [onLattice c | c <- U.toList olds]
        , neighbourTable =
            U.generate (2 * n) (\k -> neighbour (if even k then nextCorner else previousCorner) (k `div` 2))
        , placeNumbers = U.take n (U.scanl (+) 0 (U.zipWith apart olds (U.drop 1 olds)))
        , splitEnds = U.map (splitEnds scene U.!) (if U.null (splitEnds scene) then U.empty else olds)
        , cornerNames = ofOld (cornerNames scene)
        , sideNames = ofOld (sideNames scene)
        , cornersByName = Map.map (map moved) (cornersByName scene)
        , namesByCorner = ofOld (namesByCorner scene)
        , piecesByName = Map.map (map startingAt) (piecesByName scene)
        , statedByName = Map.map (\(Vector2 x y, material) -> (Vector2 y (negate x), material)) (statedByName scene)
        , scenePolygons =
            [p {polygonPoints = [Point y (negate x) | Point x y <- polygonPoints p]} | p <- scenePolygons scene]
        }
    apart c d = if samePlace scene (CornerId c) (CornerId d) then 0 else 1
