-- | The boundary of free space, and what is wrong where polygons touch.
--
-- Where polygons touch, free space comes near to a place in several cones, or in none. Nothing is seen from one cone
-- into another: so the boundary is cut at the place, and each cone gets a corner of its own, with the sides of its own
-- two flanks. What sides cover of each other is no boundary. So the boundary becomes closed walks that share places but
-- never meet, and all that follows is the same for touching polygons as for others.
module Visibility.Scene.Boundary
  ( -- * Contacts
    Contact (..)
  , contacts
  , contactTotal
    -- * What is wrong at contacts
  , Overlap (..)
  , overlaps
    -- * The boundary
  , FreeCorner (..)
  , freeCorners
  ) where

import Data.List (sortBy, sortOn)
import qualified Data.IntMap.Strict as IntMap
import qualified Data.Map.Strict as Map
import Data.Function (on)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Ord (comparing)
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Algorithms.Intro as Intro
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.Predicate
import Visibility.Scene.Boxes
import Visibility.Scene.Contact
import Visibility.Scene.Id
import Visibility.Scene.Outline
import Visibility.Scene.Raw (Form (..))

-- | A meeting of boundaries, by the indices of corners and of the corners that start segments.
data Contact
  = -- | Corners of two polygons in one place.
    AtCorners !Int !Int
  | -- | A corner between the ends of a segment.
    OnSegment !Int !Int
  | -- | Two segments that cross in a point that is an end of neither.
    Cross !Int !Int

-- | All contacts of the polygons of an outline, some of them several times; of a polygon with itself those that its
-- own angles do not explain.
--
-- /Requires/ a set of polygons whose contacts with themselves are not asked for: those of no area. /Cost/ O(1) for each
-- pair of segments whose boxes overlap.
contacts :: Outline -> Set.Set Int -> [Contact]
contacts o flat = foldOverlaps collect [] (boxTree (map (segmentBox r . segmentFrom o) starts))
  where
    r = outlineRanked o
    starts = concatMap (segmentStarts o) (polygonIndices o)
    table = U.fromList starts
    ends = U.map (around o 1) table
    collect found i j
      | p /= q = met <> found
      | p `Set.member` flat = found
      | otherwise = filter (isOwn p) met <> found
      where
        met = meetings s t (meeting r (Segment s s') (Segment t t'))
        s = table U.! i
        s' = ends U.! i
        t = table U.! j
        t' = ends U.! j
        p = outlineOwner o U.! s
        q = outlineOwner o U.! t
    meetings s t how = case how of
      Apart -> []
      Crossing -> [Cross s t]
      Touching touches -> map (touch s t) touches
    touch _ _ (Ends a b) = AtCorners a b
    touch _ t (FirstOnSecond a) = OnSegment a t
    touch s _ (SecondOnFirst b) = OnSegment b s
    -- Corners of one ring in one place are the end of one side and the start of the next, or repeated corners. In a
    -- ring, a corner on a side next but one comes from a spike between.
    isOwn p (AtCorners i j) = outlineForms o V.! p == Polyline && i /= j
    isOwn _ (Cross _ _) = True
    isOwn p (OnSegment i s) = case outlineForms o V.! p of
      Ring -> i /= around o (-1) s && i /= around o 2 s
      Polyline -> True

-- | What may not be where boundaries meet, by the places of polygons in the outline.
data Overlap
  = -- | Inside one polygon there is some of the other one.
    SolidsOverlap !Int !Int
  | -- | Two thin walls, or two pieces of one, lie along each other.
    WallsOverlap !Int !Int
  deriving (Eq, Ord, Show)

-- | What leads away from a place: the open arc of directions that lead into a ring, from one direction
-- counter-clockwise to another, or the direction of a piece of a thin wall. Directions are those to other corners.
data Limb = Arc !Int !Int !Int | Ray !Int !Int

-- | All that overlaps at places where boundaries meet.
--
-- /Requires/ the contacts of simple rings and of thin walls without zero lengths, none of which cross each other: then
-- polygons whose boundaries meet overlap if and only if they do at some place of contact. /Cost/ at each place of
-- contact quadratic in the number of sides there.
overlaps :: Outline -> [Contact] -> Set.Set Overlap
overlaps o found = Set.fromList (concatMap (clashes . uncurry (limbs o)) (Map.elems (contactPlaces o found)))
  where
    clashes (x, around') =
      [ clash
      | (k, one) <- zip [0 :: Int ..] around'
      , (l, other) <- zip [0 ..] around'
      , k < l
      , clash <- clashOf x one other
      ]
    clashOf x (Arc p a b) (Arc q c d)
      | p /= q && (sameWay o x a c || insideArc o x (a, b) c || insideArc o x (c, d) a) = [solids p q]
    clashOf x (Arc p a b) (Ray q c) = [solids p q | insideArc o x (a, b) c]
    clashOf x (Ray p a) (Arc q c d) = [solids p q | insideArc o x (c, d) a]
    clashOf x (Ray p a) (Ray q c) = [WallsOverlap (min p q) (max p q) | sameWay o x a c]
    clashOf _ _ _ = []
    solids p q = SolidsOverlap (min p q) (max p q)

-- | The places where something meets: a corner there, all corners there, and the segments that pass through.
contactPlaces :: Outline -> [Contact] -> Map.Map (Int, Int) (Int, ([Int], [Int]))
contactPlaces o found = Map.map whole (Map.fromListWith (<>) (concatMap touched found))
  where
    touched (AtCorners i j) = [(placeOf o i, (Set.fromList [i, j], Set.empty))]
    touched (OnSegment i s) = [(placeOf o i, (Set.singleton i, Set.singleton s))]
    touched (Cross _ _) = []
    whole (here, passing) = (Set.findMin here, (Set.toList here, Set.toList passing))

-- | The number of places where something meets.
contactTotal :: Outline -> [Contact] -> Int
contactTotal o = Map.size . contactPlaces o

-- | What leads away from a place, with the place.
limbs :: Outline -> Int -> ([Int], [Int]) -> (Int, [Limb])
limbs o x (here, passing) = (x, concatMap atCorner here <> concatMap onSegment passing)
  where
    atCorner i = case outlineForms o V.! p of
      Ring -> let (to, from) = solidLeft o p (around o 1 i) (around o (-1) i) in [Arc p to from]
      Polyline -> [Ray p (around o 1 i) | i /= last'] <> [Ray p (around o (-1) i) | i /= first]
      where
        p = outlineOwner o U.! i
        first = outlineFirst o U.! p
        last' = outlineFirst o U.! (p + 1) - 1
    onSegment s = case outlineForms o V.! p of
      Ring -> let (to, from) = solidLeft o p (around o 1 s) s in [Arc p to from]
      Polyline -> [Ray p s, Ray p (around o 1 s)]
      where
        p = outlineOwner o U.! s

-- | Two corners that follow each other at a place of a ring's boundary in the file's order, exchanged if that order has
-- the solid on the right.
solidLeft :: Outline -> Int -> Int -> Int -> (Int, Int)
solidLeft o p ahead behind = case solidFlank o p of
  LeftTurn -> (ahead, behind)
  _ -> (behind, ahead)

-- | Where the solid of a ring lies on the way around it in the file's order. The turn at the least corner, which is
-- convex and not flat in a simple polygon; the solid of an enclosure lies outside.
solidFlank :: Outline -> Int -> Turn
solidFlank o p = case outlineIds o V.! p of
  Enclosure -> opposite inner
  Obstacle _ -> inner
  where
    inner = case sortOn (placeOf o) (cornersOf o p) of
      i : _ -> turn (rankedPoints (outlineRanked o)) (around o (-1) i) i (around o 1 i)
      [] -> Collinear

-- | Do two corners lie in the same direction from a third?
sameWay :: Outline -> Int -> Int -> Int -> Bool
sameWay o x a b =
  turn (rankedPoints (outlineRanked o)) x a b == Collinear && (placeOf o a > placeOf o x) == (placeOf o b > placeOf o x)

-- | Does the direction to a corner lie inside an open arc?
insideArc :: Outline -> Int -> (Int, Int) -> Int -> Bool
insideArc o x (a, b) c = case to a b of
  LeftTurn -> to a c == LeftTurn && to c b == LeftTurn
  Collinear -> to a c == LeftTurn
  RightTurn -> not (to b c /= RightTurn && to c a /= RightTurn)
  where
    to = turn (rankedPoints (outlineRanked o)) x

-- | A corner of the boundary of free space, in the place of stated corners: where the face of a side, or what is not
-- covered of it, begins if free space is kept on the right.
data FreeCorner = FreeCorner
  { freePlace :: !Int
  -- ^ A stated corner in its place.
  , freeNumber :: !Int
  -- ^ The number of its place among all places with corners, in lexicographic order.
  , freeName :: !CornerName
  -- ^ The first of the stated corners in its place that belong to a polygon on one of its flanks.
  , freeSide :: !SideName
  -- ^ The side that begins there.
  , freeNext :: !Int
  -- ^ The corner where that ends, by its place in the list.
  }

-- | A face of a side, or an uncovered piece of it: from one place to another, free space on its right. Places are given
-- by stated corners.
data Face = Face !Int !Int !SideName

-- | All corners of the boundary, by place in lexicographic order; in one place by name, and then by side.
--
-- /Degenerate cases/ a stated corner that is all covered has none, one in several cones of free space has several.
-- Where all of a room is filled, there are none.
--
-- /Requires/ a valid scene, and its contacts. /Cost/ O(n log n), and at each place of contact quadratic in the number
-- of sides there.
freeCorners :: Outline -> [Contact] -> [FreeCorner]
freeCorners o found =
  [ FreeCorner from (placeId U.! from) name side (ranks U.! (followers U.! f))
  | (name, f) <- ordered
  , let Face from _ side = faces V.! f
  ]
  where
    -- The faces by where they begin, place by place and by name in each, with the names of the corners there.
    ordered = concatMap (inNameOrder . map named') (V.toList starting)
    inNameOrder fs@[_] = fs
    inNameOrder fs = sortOn (\(name, f) -> let Face _ _ side = faces V.! f in (name, side)) fs
    named' f = (nameAt from [side, arriving], f)
      where
        Face from _ side = faces V.! f
        Face _ _ arriving = faces V.! (leaders U.! f)
    ranks = U.replicate (V.length faces) 0 U.// zip (map snd ordered) [0 ..]
    faces = V.fromList (exposed o found)
    placeId = placeIds o
    -- By place: the faces that begin there, in the order of their angles if there are several.
    starting = V.map inOrder (byPlace [(placeId U.! from, f) | (f, Face from _ _) <- V.toList (V.indexed faces)])
    byPlace :: [(Int, a)] -> V.Vector [a]
    byPlace = V.accumulate (flip (:)) (V.replicate (U.length placeId) []) . V.fromList
    inOrder [] = []
    inOrder fs@[_] = fs
    inOrder fs = sortBy (byAngle `on` (\f -> let Face from to _ = faces V.! f in (from, to))) fs
    byAngle = angleOrder o
    -- The next face counter-clockwise from the one that arrives: between them is a cone of free space. One that leads
    -- back the same way comes last, after a full turn.
    follower f = fromMaybe f (listToMaybe (filter later here <> here))
      where
        Face from to _ = faces V.! f
        here = starting V.! (placeId U.! to)
        later g = let Face _ away _ = faces V.! g in byAngle (to, from) (to, away) == LT
    followers = U.generate (V.length faces) follower
    leaders = U.replicate (V.length faces) 0 U.// zip (U.toList followers) [0 ..]
    named = byPlace [(placeId U.! i, cornerNameOf o i) | i <- concatMap (cornersOf o) (polygonIndices o)]
    nameAt x flanks = case filter (`ownedBy` flanks) names of
      [] -> minimum (cornerNameOf o x : names)
      own -> minimum own
      where
        names = named V.! (placeId U.! x)
    ownedBy (CornerName p _) flanks = p `elem` [q | SideName q _ <- flanks]

-- | Places by number, in lexicographic order.
placeIds :: Outline -> U.Vector Int
placeIds o = U.replicate total 0 U.// zip (U.toList order) (U.toList numbers)
  where
    total = V.length (outlinePoints o)
    order = U.modify (Intro.sortBy (comparing (placeOf o))) (U.enumFromN 0 total)
    numbers = U.take total (U.scanl' (+) 0 (U.zipWith step order (U.drop 1 order)))
    step i j = if placeOf o i == placeOf o j then 0 else 1

-- | The order of directions from a place, each given by the place and another one: counter-clockwise, from the one that
-- leads down, and from there on to the right.
angleOrder :: Outline -> (Int, Int) -> (Int, Int) -> Ordering
angleOrder o (x, a) (_, b) = compare (half a) (half b) <> byTurn
  where
    half c = placeOf o c < placeOf o x
    byTurn = case turn (rankedPoints (outlineRanked o)) x a b of
      LeftTurn -> LT
      Collinear -> EQ
      RightTurn -> GT

-- | What lies along a piece between two places, the first the lesser one.
data Occupant
  = -- | A side of a ring with its solid to the left of the way from the lesser place.
    SolidLeft !SideName
  | SolidRight !SideName
  | -- | A thin wall with its left and its right face.
    Wall !SideName !SideName

-- | The faces of sides that are not covered, cut where something touches them.
exposed :: Outline -> [Contact] -> [Face]
exposed o found
  | null found = concatMap (faces . pure) pieces
  | otherwise = concatMap faces (Map.elems together)
  where
    cuts = IntMap.fromListWith (<>) [(s, [i]) | OnSegment i s <- found]
    -- What lies along one piece; each is alone where nothing meets.
    together = Map.fromListWith (<>) [((placeOf o low, placeOf o high), [piece]) | piece@(low, high, _) <- pieces]
    pieces =
      [ (low, high, occupant)
      | p <- polygonIndices o
      , s <- segmentStarts o p
      , let t = around o 1 s
      , let onwards = placeOf o s < placeOf o t
      , let occupant = occupantOf p s onwards
      , let between = case IntMap.lookup s cuts of
              Nothing -> if onwards then [s, t] else [t, s]
              Just corners -> sortOn (placeOf o) (s : t : corners)
      , (low, high) <- zip between (drop 1 between)
      , placeOf o low /= placeOf o high
      ]
    flanks = V.generate (V.length (outlineIds o)) (solidFlank o)
    occupantOf p s onwards = case outlineForms o V.! p of
      Polyline
        | onwards -> Wall (backSideOf o s) (sideNameOf o s)
        | otherwise -> Wall (sideNameOf o s) (backSideOf o s)
      Ring
        | (flanks V.! p == LeftTurn) == onwards -> SolidLeft (sideNameOf o s)
        | otherwise -> SolidRight (sideNameOf o s)
    faces [] = []
    faces occupants@((low, high, _) : _) =
      [Face high low face | null leftSolids, face <- take 1 (map fst walls <> rightSolids)]
        <> [Face low high face | null rightSolids, face <- take 1 (map snd walls <> leftSolids)]
      where
        leftSolids = [side | (_, _, SolidLeft side) <- occupants]
        rightSolids = [side | (_, _, SolidRight side) <- occupants]
        walls = [(left, right) | (_, _, Wall left right) <- occupants]
