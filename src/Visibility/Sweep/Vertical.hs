-- | The start of the sweep: what each corner sees along the vertical, and its first target, by a plane sweep.
--
-- Everything is written for a heading. Seen by 'Leftward' the scene is turned by 180°: right is left, above is below,
-- while turns stay what they are. So the left-going half of the sweep is the same code on the same tables.
--
-- Verticals need no care: order is lexicographic, which is the same as turning the scene by an infinitely small angle
-- to the right.
module Visibility.Sweep.Vertical
  ( -- * Headings
    Heading (..)
  , before
  , along
    -- * Codes in tables
  , solid
  , skyCode
  , objectOf
    -- * The plane sweep
  , Vertical (..)
  , verticalSweep
    -- * Its states
  , Crossing (..)
  , freeAbove
  , freeBelow
  , beyondAll
  , slabs
  ) where

import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl', sortBy)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Set (Set)
import qualified Data.Set as Set
import qualified Data.Set.Internal as Set (link, merge)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Law (broken)
import Visibility.Exact.Predicate
import Visibility.Scene

-- | Which way a sweep's rays go along the line.
data Heading = Rightward | Leftward
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | Does the first corner come before the second, seen by the heading?
before :: Heading -> Int -> Int -> Bool
before Rightward a b = a < b
before Leftward a b = a > b
{-# INLINE before #-}

-- | All indices below n in the order of the heading.
along :: Heading -> Int -> [Int]
along Rightward n = [0 .. n - 1]
along Leftward n = [n - 1, n - 2 .. 0]

-- | In a table of objects: no free ray.
solid :: Int
solid = -1

-- | In a table of objects of a scene with n corners: the sky. Sides have their own numbers.
skyCode :: Scene -> Int
skyCode = cornerCount

-- | What a number in a table of objects stands for, 'Nothing' for 'solid'.
objectOf :: Scene -> Int -> Maybe Object
objectOf scene code
  | code == solid = Nothing
  | code == skyCode scene = Just Sky
  | otherwise = Just (Side (SideId code))
{-# INLINE objectOf #-}

-- | The situation at the start of the half turn, seen by a heading.
data Vertical = Vertical
  { floors :: !(U.Vector Int)
  -- ^ By corner: the object met by its downward ray, or 'solid'.
  , ceilings :: !(U.Vector Int)
  -- ^ By corner: the object met by its upward ray, or 'solid'.
  , firstTargets :: !(U.Vector Int)
  -- ^ By corner: the corner at the far end of its elementary pair of least slope that leaves forward, −1 where its
  -- forward rays are solid, n where there is no such corner and it sees the sky.
  }
  deriving (Eq, Show)

-- | A side that crosses the vertical, from its end that comes first by the heading to the other. Both sides of a thin
-- wall are one crossing.
data Crossing = Crossing !Int !Int

-- | The side of a crossing that is free above it, or 'solid'.
--
-- Sides keep their solid on the left: one that leads forward has free space below it, one that leads back has it
-- above. A thin wall has a side of each kind.
freeAbove :: Scene -> Crossing -> Int
freeAbove scene (Crossing a b) = if following scene b == a then b else solid

-- | The side of a crossing that is free below it, or 'solid'.
freeBelow :: Scene -> Crossing -> Int
freeBelow scene (Crossing a b) = if following scene a == b then a else solid

following :: Scene -> Int -> Int
following scene p = let CornerId q = nextCorner scene (CornerId p) in q
{-# INLINE following #-}

-- | What lies above and below all crossings: the sky, or 'solid' in a room.
beyondAll :: Scene -> Int
beyondAll scene = case surroundings scene of
  OpenSky -> skyCode scene
  Room -> solid

-- | What the plane sweep carries from corner to corner: the sides that the vertical meets, from below upwards; and for
-- each floor the convex chain of corners seen above it so far, nearest first, down to the end of the floor.
--
-- The set is a balanced tree in which a place is found by asking of sides whether they lie below a corner, and which is
-- cut and joined there. Its elements are never compared with each other: an order of theirs would hold at one vertical
-- only.
data Status = Status !(Set Crossing) !(IntMap.IntMap [Int])

-- | What the plane sweep finds at a corner: floor, ceiling and first target.
data Row = Row !Int !Int !Int

-- | The situation at the start of the half turn, for all corners.
--
-- /Cost/ O(n log n) time, O(n) memory.
--
-- /Source/ the start of the horizon trees, Rivière; the sky in place of a bounding box is this project's.
verticalSweep :: Scene -> Heading -> Vertical
verticalSweep scene heading = Vertical (column floorOf) (column ceilingOf) (column targetOf)
  where
    n = cornerCount scene
    rows = [(p, row) | (p, row, _) <- visits scene heading]
    column part = U.replicate n solid U.// [(p, part row) | (p, row) <- rows]
    floorOf (Row x _ _) = x
    ceilingOf (Row _ x _) = x
    targetOf (Row _ _ x) = x

-- | The sides that a vertical meets, from below upwards: entry k for the verticals between the corners k − 1 and k,
-- from before all corners, entry 0, to behind them, entry n. Each is found by asking of sides whether they lie below
-- a point.
--
-- /Cost/ O(n log n) time and memory: the sets share most of their nodes.
slabs :: Scene -> V.Vector (Set Crossing)
slabs scene = V.reverse (V.fromListN (cornerCount scene + 1) (Set.empty : [s | (_, _, s) <- visits scene Rightward]))

-- | Visits the places of corners against the heading and keeps the sides that cross the vertical: each corner with what
-- is found there, and the sides that cross the vertical after its place.
--
-- /Degenerate cases/ corners on one vertical are visited in the order of their ids, like all others. Corners collinear
-- with p on a chain stay, so that the first target is the nearest. Of the corners in one place, at most one sees down
-- and at most one sees up: those whose cones contain these directions.
--
-- /Cost/ O(n log n) for the status, O(n) for the chains.
visits :: Scene -> Heading -> [(Int, Row, Set Crossing)]
visits scene heading = visit (Status Set.empty (IntMap.singleton sky [])) (places heading (placeGroups scene))
  where
    sky = skyCode scene
    beyond = beyondAll scene
    places Rightward = reverse
    places Leftward = id
    visit _ [] = []
    visit status (group : rest) =
      let (rows, status'@(Status crossing _)) = meet status [p | CornerId p <- group]
       in crossing `seq` [(p, row, crossing) | (p, row) <- rows] <> visit status' rest

    next = following scene
    previous p = let CornerId q = previousCorner scene (CornerId p) in q
    turnOf = turn (scenePoints scene)

    meet status [] = ([], status)
    meet (Status crossing chains) here@(x : _)
      | length leaving /= Set.size ending = broken "status of the plane sweep" ("at corner " <> show x)
      | otherwise = (map row here, Status crossing' chains')
      where
        arriving = upwards' RightTurn [(q, p) | p <- here, q <- neighbours p, before heading q p]
        leaving = upwards' LeftTurn [(p, q) | p <- here, q <- neighbours p, before heading p q]
        (below, from) = Set.spanAntitone (\(Crossing a b) -> turnOf a b x == LeftTurn) crossing
        (ending, above) = Set.spanAntitone (\(Crossing a _) -> samePlace scene (CornerId a) (CornerId x)) from
        crossing' = case map (uncurry Crossing) arriving of
          [] -> Set.merge below above
          side : others -> Set.link side below (foldr (`Set.link` Set.empty) above others)
        floorSide = maybe beyond (freeAbove scene) (Set.lookupMax below)
        ceilingSide = maybe beyond (freeBelow scene) (Set.lookupMin above)
        chain = tangentChain x (IntMap.findWithDefault [] floorSide chains)
        row p = (p, Row (if seesDown then floorSide else solid) (if seesUp then ceilingSide else solid) target)
          where
            (seesDown, seesUp) = verticals p
            target
              | seesDown = fromMaybe sky (listToMaybe chain)
              | otherwise = fromMaybe solid (listToMaybe [q | (p', q) <- leaving, p' == p])
        extended = foldl' (\hulls p -> IntMap.insert floorSide (p : chain) hulls) chains (filter (fst . verticals) here)
        chains' = foldl' begin (foldl' end extended leaving) arriving
        end hull (p, q) = IntMap.delete (freeAbove scene (Crossing p q)) hull
        begin hull (q, p)
          | side == solid = hull
          | otherwise = IntMap.insert side [p] hull
          where
            side = freeAbove scene (Crossing q p)

    neighbours p = if next p == previous p then [next p] else [next p, previous p]
    -- Sides at one place, from the lowest to the uppermost, seen from their ends there: the first ends of those that
    -- arrive, for which lower means that the turn to the next one is to the right, or the second ends of those that
    -- leave. Of the two faces of one piece of a wall the lower one, which has free space on its right, comes first.
    upwards' _ [] = []
    upwards' _ [side] = [side]
    upwards' wanted found = sortBy order found
      where
        order (a, b) (c, d) = case wanted of
          RightTurn -> rank (turnOf b a c) <> faces (a, b) (c, d)
          _ -> rank (turnOf a b d) <> faces (a, b) (c, d)
        rank found'
          | found' == wanted = LT
          | found' == Collinear = EQ
          | otherwise = GT
        faces (a, b) _ = if next a == b then LT else GT
    -- Does the cone of a corner hold the direction down, and that up?
    verticals p = case (before heading (previous p) p, before heading (next p) p) of
      (True, False) -> (True, False)
      (False, True) -> (False, True)
      _ -> let around = turnOf p (previous p) (next p) /= LeftTurn in (around, around)

    -- The chain without the corners that the tangent from p leaves out; collinear ones stay.
    tangentChain p (a : b : rest) | turnOf p a b == RightTurn = tangentChain p (b : rest)
    tangentChain _ chain = chain
