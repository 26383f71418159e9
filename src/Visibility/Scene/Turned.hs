-- | The scene turned by a right angle, for sweeps that begin at the horizontal.
module Visibility.Scene.Turned
  ( quarterTurned
  ) where

import Data.Int (Int32)
import qualified Data.Vector.Algorithms.Intro as Intro
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.Point
import Visibility.Scene.Id
import Visibility.Scene.Stated
import Visibility.Scene.Type
import Visibility.Sorting

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
quarterTurned scene = (turned, olds)
  where
    n = cornerCount scene
    -- Of all stated corners too, so that no coordinate is negative there.
    width = maximum (0 : [ceilingOf p | p <- placeList (statedPlaces stated)])
    ceilingOf (LatticePoint x _ w) = (x + w - 1) `quot` w
    turnedPlaces = placesFrom . map (\(LatticePoint x y w) -> LatticePoint y (width * w - x) w) . placeList
    turnedCorners = turnedPlaces (pointPlaces (scenePoints scene))
    -- The corners of the scene in the lexicographic order of the turned one, and their places in it.
    olds = U.map fromIntegral order
    order = U.modify (Intro.sortBy earlier) (U.enumFromN 0 n)
    news = U.update_ (U.replicate n 0) order (U.enumFromN 0 n) :: U.Vector Int32
    earlier c d
      | samePlace scene (CornerId c) (CornerId d) = compare c d
      | otherwise = comparePlacesAt turnedCorners c d
    neighbour part i = fromIntegral (news U.! (let CornerId j = part scene (CornerId (order U.! i)) in j))
    ofOld table = U.map (table U.!) order
    Lattice scale (Vector2 originX originY) = sceneLattice scene
    stated = sceneStated scene
    -- By the old number of a place, the new one.
    places = denseRanks (comparePlacesAt turnedStated) (placeCount turnedStated)
    turnedStated = turnedPlaces (statedPlaces stated)
    renumbered = U.update_ (U.replicate (U.length places) 0) (U.map fromIntegral (statedPlaceNumbers scene)) places
    facing = ofOld (facedSides scene)
    turned =
      scene
        { sceneLattice = Lattice scale (Vector2 originY (negate width - originX))
        , scenePoints = pointsOn (sceneArithmetic scene) (rearranged olds turnedCorners)
        , neighbourTable =
            U.generate (2 * n) (\k -> neighbour (if even k then nextCorner else previousCorner) (k `div` 2))
        , placeNumbers = U.map ((renumbered U.!) . fromIntegral) (ofOld (placeNumbers scene))
        , splitEnds = if U.null (splitEnds scene) then U.empty else ofOld (splitEnds scene)
        , sceneStated = stated {statedPlaces = turnedStated}
        , statedPlaceNumbers = places
        , namingCorners = ofOld (namingCorners scene)
        , facedSides = facing
        , statedByPlace = bucketsOf places
        , piecesBySide = bucketsBy (statedSideTotal stated) facing
        , scenePolygons =
            [p {polygonPoints = [Point y (negate x) | Point x y <- polygonPoints p]} | p <- scenePolygons scene]
        }
