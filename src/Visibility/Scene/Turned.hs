-- | The scene turned by a right angle, for sweeps that begin at the horizontal.
module Visibility.Scene.Turned
  ( quarterTurned
  ) where

import Data.Int (Int32)
import qualified Data.Vector as V
import qualified Data.Vector.Algorithms.Intro as Intro
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.Point
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
    stated = sceneStated scene
    -- Of all stated corners too, so that no coordinate is negative there.
    width = rightmost (statedPlaces stated)
    turnedStated = turnedPlaces width (statedPlaces stated)
    -- By the old number of a place, the new one. Any stated corner there tells where it is.
    renumbered = U.update_ (U.replicate total 0) sorted (U.enumFromN 0 total) :: U.Vector Int32
    total = 1 + fromIntegral (U.foldl' max (-1) (statedPlaceNumbers scene))
    sorted = U.modify (Intro.sortBy (\p q -> comparePlacesAt turnedStated (at p) (at q))) (U.enumFromN 0 total)
    at place = standing `U.unsafeIndex` place
    standing =
      U.update_
        (U.replicate total 0)
        (U.map fromIntegral (statedPlaceNumbers scene))
        (U.enumFromN 0 (statedTotal stated))
    renumber = U.map (\place -> renumbered U.! fromIntegral place)
    -- The corners of the scene in the lexicographic order of the turned one, and their places in it.
    numbers = renumber (placeNumbers scene)
    olds = sortedBy total (\c -> fromIntegral (numbers U.! fromIntegral c)) (U.enumFromN 0 n)
    news = U.update_ (U.replicate n 0) (U.map fromIntegral olds) (U.enumFromN 0 n) :: U.Vector Int32
    ofOld :: U.Unbox a => U.Vector a -> U.Vector a
    ofOld table = U.map (\c -> table U.! fromIntegral c) olds
    neighbours = U.generate (2 * n) $ \k ->
      news U.! fromIntegral (neighbourTable scene U.! (2 * fromIntegral (olds U.! (k `quot` 2)) + k `rem` 2))
    Lattice scale (Vector2 originX originY) = sceneLattice scene
    statedNumbers = renumber (statedPlaceNumbers scene)
    facing = ofOld (facedSides scene)
    turned =
      scene
        { sceneLattice = Lattice scale (Vector2 originY (negate width - originX))
        , scenePoints =
            pointsOn (sceneArithmetic scene) (rearranged olds (turnedPlaces width (pointPlaces (scenePoints scene))))
        , neighbourTable = neighbours
        , placeNumbers = ofOld numbers
        , splitEnds = if U.null (splitEnds scene) then U.empty else ofOld (splitEnds scene)
        , sceneStated = stated {statedPlaces = turnedStated}
        , statedPlaceNumbers = statedNumbers
        , namingCorners = ofOld (namingCorners scene)
        , facedSides = facing
        , statedByPlace = bucketsOf statedNumbers
        , piecesBySide = bucketsBy (statedSideTotal stated) facing
        , scenePolygons =
            [p {polygonPoints = [Point y (negate x) | Point x y <- polygonPoints p]} | p <- scenePolygons scene]
        }

-- | A whole number that no x is greater than, 0 at least.
rightmost :: Places -> Integer
rightmost places = case places of
  SmallPlaces xs -> fromIntegral (U.ifoldl' (\most k x -> if even k then max most x else most) 0 xs)
  LargePlaces points -> V.foldl' (\most (LatticePoint x _ w) -> max most ((x + w - 1) `quot` w)) 0 points

-- | Turned by 90° to the right and moved up by so much.
turnedPlaces :: Integer -> Places -> Places
turnedPlaces width places = case places of
  SmallPlaces xs ->
    SmallPlaces (U.generate (U.length xs) (\k -> if even k then xs U.! (k + 1) else fromInteger width - xs U.! (k - 1)))
  LargePlaces points -> placesFrom [LatticePoint y (width * w - x) w | LatticePoint x y w <- V.toList points]
