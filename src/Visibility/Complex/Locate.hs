-- | Where a point lies in the scene, and where the curve of a free point begins in the complex.
module Visibility.Complex.Locate
  ( -- * Points
    Eye
  , eyeRank
  , eyeFrom
  , directionFrom
    -- * Places
  , Place (..)
  , Start (..)
  , locate
  , boundariesAt
  ) where

import Data.List (minimumBy)
import Data.Ord (comparing)
import Visibility.Complex.Reading (Reading (..))
import Visibility.Complex.Type
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Law (broken)
import Visibility.Scene
import Visibility.Scene.Raw (Form (..))
import Visibility.Sorting (firstWhere)
import Visibility.View (Flank (..))

-- | A point on the lattice, in homogeneous integers of its own, and the number of corners before it in lexicographic
-- order.
data Eye = Eye !LatticePoint !Int

-- | How many corners come before a point in lexicographic order: it lies to the right of those.
eyeRank :: Eye -> Int
eyeRank (Eye _ k) = k

-- | A point in the file's coordinates, and the corners that are in the same place. /Cost/ O(log n).
eyeAt :: Scene -> Point -> (Eye, [CornerId])
eyeAt scene point = (eye rank, here)
  where
    place = ontoLattice (sceneLattice scene) point
    eye = Eye place
    n = cornerCount scene
    rank = firstWhere ((/= LT) . comparison) 0 n
    -- Of a corner to the point.
    comparison k = comparePlaces (cornerAt scene (CornerId k)) place
    here = map CornerId (takeWhile (\k -> comparison k == EQ) [rank .. n - 1])

-- | From a corner to the point: a vector of the right direction, (0, 0) where they are in one place.
eyeFrom :: Scene -> Eye -> CornerId -> Direction
eyeFrom scene (Eye place _) c = Direction x y
  where
    Vector2 x y = cornerAt scene c `towards` place

-- | The direction of the line through the point and a corner, right-going.
--
-- /Requires/ that the point is not at the corner.
directionFrom :: Scene -> Eye -> CornerId -> Direction
directionFrom scene eye c@(CornerId k)
  | k < eyeRank eye = there
  | otherwise = Direction (negate x) (negate y)
  where
    there@(Direction x y) = eyeFrom scene eye c

-- | The face in which the curve of a point begins, at the start of the half turn; and how it is read if it is that of
-- the lines that miss everything: backwards to the left of all corners, forwards to the right of them.
data Start = Start !FaceId !Reading

-- | Where a point lies.
data Place
  = -- | All corners in its place.
    OnCorners ![CornerId]
  | -- | In the interior of a side, or of both sides of a thin wall: those sides, each with the start of the piece of
    -- the point's curve on that side.
    OnSides ![(SideId, Start)]
  | InFree !Start
  | -- | In an obstacle, the first one if it is where several cover each other, or outside the enclosure.
    InSolid !PolygonId

-- | Finds a point.
--
-- /Degenerate cases/ verticals lean a little to the right, so one through corners lies between two of them, too. A
-- point on a side is the end of two pieces of its vertical, of which those are counted that are not in the solid.
--
-- /Cost/ O(n) comparisons of numbers for n corners, and a turn for each side that the vertical of the point meets.
locate :: Complex -> Point -> (Eye, Place)
locate complex point = (eye, if null here then elsewhere else OnCorners here)
  where
    (eye, here) = eyeAt scene point
    scene = complexScene complex
    rank = eyeRank eye
    -- The sides that the vertical meets, with the flank of each, from left to right, on which the point lies.
    met = [(s, seenFrom a b) | s <- sides scene, let (a, b) = endsOf s, a < rank, rank <= b]
    seenFrom a b = directionTurn (direction (scenePoints scene) a b) (eyeFrom scene eye (CornerId a))
    endsOf s = (min a b, max a b)
      where
        CornerId a = sideStart s
        CornerId b = sideEnd scene s
    on = [s | (s, Collinear) <- met]
    -- A side keeps its solid on the left.
    isFreeBelow s = sideStart s < sideEnd scene s
    elsewhere = case (on, [s | (s, RightTurn) <- met]) of
      ([], []) | surroundings scene == Room -> solid'
               | otherwise -> InFree (startBelow Sky)
      ([], above) | isFreeBelow (lowest above) -> InFree (startBelow (Side (lowest above)))
                  | otherwise -> solid'
      (_, above) ->
        OnSides
          ( [(s, startBelow (if null above then Sky else Side (lowest above))) | s <- on, not (isFreeBelow s)]
              <> [(s, startBelow (Side s)) | s <- on, isFreeBelow s]
          )
    solid' = InSolid (solidAt scene point)
    lowest = minimumBy upwards'
    -- The order along the vertical. Of a wall's two faces, that which has free space below it comes first.
    upwards' s t
      | c < a = compare EQ (upwards' t s)
      | otherwise = case filter (/= Collinear) (map (turn (scenePoints scene) a b) [c, d]) of
          LeftTurn : _ -> LT
          RightTurn : _ -> GT
          _ -> comparing (not . isFreeBelow) s t
      where
        (a, b) = endsOf s
        (c, d) = endsOf t
    -- In the face under an object: that of the nearest corner to the right which has a face under it on its left, read
    -- at the end of the half turn.
    startBelow back
      | Just outer <- outerFace complex, rank == 0 = Start outer Backwards
      | Just outer <- outerFace complex, rank == cornerCount scene = Start outer Forwards
      | otherwise = case filter ((== back) . faceFront complex) (concatMap onTheLeft (drop rank (corners scene))) of
          face : _ -> Start face Backwards
          [] -> broken "every free piece of a vertical is in a face" (show (rank, back))
    onTheLeft c = edgeFacesOn complex (lastEdgeOf complex c) Above

-- | The first obstacle that holds a point of the solid, with its boundary; the enclosure if none does.
--
-- Which one cannot be told from the boundary of free space, as what obstacles cover of each other is no part of that.
--
-- /Cost/ O(n).
solidAt :: Scene -> Point -> PolygonId
solidAt scene point@(Point x _) = case filter holds (scenePolygons scene) of
  polygon : _ -> polygonId polygon
  [] -> Enclosure
  where
    holds polygon =
      polygonId polygon /= Enclosure
        && polygonForm polygon == Ring
        && (isOnBoundary point polygon || isInside (ways polygon))
    isInside around = odd (length (filter isAbove around))
    -- Does the vertical ray upwards from the point meet a side?
    isAbove (a@(Point ax _), b@(Point bx _)) = (ax <= x) /= (bx <= x) && (aside point a b > 0) == (ax > bx)

-- | The polygons on whose boundaries a point lies, whether others cover it there or not. /Cost/ O(n).
boundariesAt :: Scene -> Point -> [PolygonId]
boundariesAt scene point = [polygonId polygon | polygon <- scenePolygons scene, isOnBoundary point polygon]

isOnBoundary :: Point -> Polygon -> Bool
isOnBoundary point = any isOn . ways
  where
    isOn (a, b) = aside point a b == 0 && min a b <= point && point <= max a b

-- The ways along the sides of a polygon, those of a thin wall once.
ways :: Polygon -> [(Point, Point)]
ways polygon = zip corners' (drop 1 corners' <> [a | Ring <- [polygonForm polygon], a <- take 1 corners'])
  where
    corners' = polygonPoints polygon

-- Positive where the point lies to the left of the way.
aside :: Point -> Point -> Point -> Rational
aside (Point x y) (Point ax ay) (Point bx by) = (bx - ax) * (y - ay) - (by - ay) * (x - ax)
