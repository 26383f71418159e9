-- | Where a point lies in the scene, and where the curve of a free point begins in the complex.
module Visibility.Complex.Locate
  ( -- * The index
    Locator
  , locator
  , locatorComplex
    -- * Points
  , Eye
  , eyeRank
  , eyeFrom
  , directionFrom
    -- * Places
  , Place (..)
  , Start (..)
  , locate
  ) where

import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl', scanl')
import Data.Maybe (mapMaybe)
import Data.Set (Set)
import qualified Data.Set as Set
import qualified Data.Vector as V
import Visibility.Complex.Slabs
import Visibility.Complex.Type
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Law (broken)
import Visibility.Scene
import Visibility.Scene.Raw (Form (..))
import Visibility.Sweep.Vertical

-- | A complex with what it takes to find a point in it.
--
-- At the start of the half turn lines are vertical, all but, and lie in the order of the corners from left to right. So
-- between two consecutive corners the same sides are met, and the same faces, one for each piece of a vertical.
data Locator = Locator
  { locatorComplex :: !Complex
  , crossings :: !(V.Vector (Set Crossing))
  , facesByBack :: !(V.Vector (IntMap.IntMap FaceId))
  -- ^ For the verticals between the corners k − 1 and k, read downwards: the faces by the object at their back, which
  -- is the back of one piece of a line only.
  }

-- | /Cost/ O(n log n) time and memory for n corners.
locator :: Complex -> Locator
locator complex = Locator complex (slabs scene) (V.fromListN (n + 1) (reverse fromTheRight))
  where
    scene = complexScene complex
    n = cornerCount scene
    sky = skyCode scene
    outside = IntMap.fromList [(sky, face) | Just face <- [outerFace complex]]
    fromTheRight = scanl' passed outside (map CornerId [n - 1, n - 2 .. 0])
    -- A last stretch is read here from the end of the half turn on, backwards: what is above its curve where it begins
    -- is then below, and the front is then the back.
    passed found c = foldl' enter (foldl' leave found (around BelowBack BelowFront)) (around AboveBack AboveFront)
      where
        e = lastEdgeOf complex c
        around a b = mapMaybe (faceAt complex e) [a, b]
    leave found f = IntMap.delete (backOf f) found
    enter found f = IntMap.insert (backOf f) f found
    backOf f = case faceFront complex f of
      Side (SideId s) -> s
      Sky -> sky

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
    rank = search 0 n
    search low high
      | low >= high = low
      | comparison middle == LT = search (middle + 1) high
      | otherwise = search low middle
      where
        middle = (low + high) `quot` 2
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

-- | Where the curve of a point begins, at the start of the half turn.
data Start
  = -- | Beyond all corners, under the sky: to the left of them, or to the right.
    LeftOfAll
  | RightOfAll
  | -- | In this face.
    InFace !FaceId

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
-- /Cost/ O(log n) for n corners, O(n) in the solid.
locate :: Locator -> Point -> (Eye, Place)
locate found point = (eye, if null here then elsewhere else OnCorners here)
  where
    (eye, here) = eyeAt scene point
    scene = complexScene (locatorComplex found)
    rank = eyeRank eye
    (_, from) = Set.spanAntitone (\side -> seenFrom side == LeftTurn) (crossings found V.! rank)
    (on, above) = Set.spanAntitone (\side -> seenFrom side == Collinear) from
    seenFrom (Crossing a b) = directionTurn (direction (scenePoints scene) a b) (eyeFrom scene eye (CornerId a))
    ceiling' = maybe (beyondAll scene) (freeBelow scene) (Set.lookupMin above)
    -- The two faces of a wall may be two crossings here, if they join different corners.
    elsewhere = case Set.toAscList on of
      [] | ceiling' == solid -> InSolid (solidAt scene point)
         | otherwise -> InFree (startAt ceiling')
      found' ->
        OnSides
          ( [(SideId s, startAt ceiling') | s <- map (freeAbove scene) found', s /= solid]
              <> [(SideId s, startAt s) | s <- map (freeBelow scene) found', s /= solid]
          )
    startAt back
      | isOpen && rank == 0 = LeftOfAll
      | isOpen && rank == cornerCount scene = RightOfAll
      | otherwise = case IntMap.lookup back (facesByBack found V.! rank) of
          Just face -> InFace face
          Nothing -> broken "every free piece of a vertical is in a face" (show (rank, back))
    isOpen = surroundings scene == OpenSky

-- | The first obstacle that holds a point of the solid, with its boundary; the enclosure if none does.
--
-- Which one cannot be told from the boundary of free space, as what obstacles cover of each other is no part of that.
--
-- /Cost/ O(n).
solidAt :: Scene -> Point -> PolygonId
solidAt scene point@(Point x y) = case filter holds (scenePolygons scene) of
  polygon : _ -> polygonId polygon
  [] -> Enclosure
  where
    holds polygon =
      polygonId polygon /= Enclosure && polygonForm polygon == Ring && (any isOn around || isInside around)
      where
        around = zip (polygonPoints polygon) (drop 1 (cycle (polygonPoints polygon)))
    isInside around = odd (length (filter isAbove around))
    isOn (a, b) = aside a b == 0 && min a b <= point && point <= max a b
    -- Does the vertical ray upwards from the point meet a side?
    isAbove (a@(Point ax _), b@(Point bx _)) = (ax <= x) /= (bx <= x) && (aside a b > 0) == (ax > bx)
    -- Positive where the point lies to the left of the way.
    aside (Point ax ay) (Point bx by) = (bx - ax) * (y - ay) - (by - ay) * (x - ax)
