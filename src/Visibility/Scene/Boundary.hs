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
  , Boundary (..)
  , freeCorners
  ) where

import Control.Monad (forM_)
import Control.Monad.ST (runST)
import Data.Function (on)
import Data.Int (Int32)
import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl', sortBy, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, listToMaybe)
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.Predicate
import Visibility.Scene.Boxes
import Visibility.Scene.Contact
import Visibility.Scene.Id
import Visibility.Scene.Outline
import Visibility.Scene.Raw (Form (..))
import Visibility.Sorting

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
        p = ownerOf o s
        q = ownerOf o t
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
      | p /= q && (sameWay o x a c || insideArc (turn points x) (a, b) c || insideArc (turn points x) (c, d) a) = [solids p q]
    clashOf x (Arc p a b) (Ray q c) = [solids p q | insideArc (turn points x) (a, b) c]
    clashOf x (Ray p a) (Arc q c d) = [solids p q | insideArc (turn points x) (c, d) a]
    clashOf x (Ray p a) (Ray q c) = [WallsOverlap (min p q) (max p q) | sameWay o x a c]
    clashOf _ _ _ = []
    points = rankedPoints (outlineRanked o)
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
        p = ownerOf o i
        first = outlineFirst o U.! p
        last' = outlineFirst o U.! (p + 1) - 1
    onSegment s = case outlineForms o V.! p of
      Ring -> let (to, from) = solidLeft o p (around o 1 s) s in [Arc p to from]
      Polyline -> [Ray p s, Ray p (around o 1 s)]
      where
        p = ownerOf o s

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
    inner = turn (rankedPoints (outlineRanked o)) (around o (-1) least) least (around o 1 least)
    least = foldl' (\i j -> if numberOf o j < numberOf o i then j else i) (outlineFirst o U.! p) (cornersOf o p)

-- | Do two corners lie in the same direction from a third?
sameWay :: Outline -> Int -> Int -> Int -> Bool
sameWay o x a b =
  turn (rankedPoints (outlineRanked o)) x a b == Collinear && (placeOf o a > placeOf o x) == (placeOf o b > placeOf o x)

-- | The corners of the boundary of free space, in the places of stated corners: where the face of a side, or what is
-- not covered of it, begins if free space is kept on the right. In the order of places; in one place by name, and then
-- by side.
data Boundary = Boundary
  { statedNumbers :: !(U.Vector Int32)
  -- ^ By stated corner: the number of its place among all places with corners, in lexicographic order.
  , freePlaces :: !(U.Vector Int32)
  -- ^ By corner of the boundary: a stated corner in its place.
  , freeNames :: !(U.Vector Int32)
  -- ^ The first of the stated corners in its place that belong to a polygon on one of its flanks.
  , freeSides :: !(U.Vector Int32)
  -- ^ The number of the side that begins there.
  , freeNexts :: !(U.Vector Int32)
  -- ^ The corner where that ends.
  }

-- | A face of a side, or an uncovered piece of it: from one place to another, free space on its right, with the number
-- of the side. Places are given by stated corners.
type Face = (Int32, Int32, Int32)

-- | All corners of the boundary.
--
-- /Degenerate cases/ a stated corner that is all covered has none, one in several cones of free space has several.
-- Where all of a room is filled, there are none.
--
-- /Requires/ a valid scene, and its contacts. /Cost/ O(n) where there are none, else O(n log n), and at each place of
-- contact quadratic in the number of sides there.
freeCorners :: Outline -> [Contact] -> Boundary
freeCorners o [] = wholeSides o
freeCorners o found =
  Boundary
    { statedNumbers = places
    , freePlaces = U.map (U.unsafeIndex froms) ordered
    , freeNames = U.map (fromIntegral . nameOf) ordered
    , freeSides = U.map (U.unsafeIndex sides) ordered
    , freeNexts = U.map (U.unsafeIndex newNumbers . U.unsafeIndex followers) ordered
    }
  where
    faces = U.fromList (exposed o found)
    (froms, tos, sides) = U.unzip3 faces
    total = U.length faces
    places = outlineNumbers o
    -- By place: the faces that begin there.
    starting = bucketsBy (placeTotal o) (U.map (U.unsafeIndex places . fromIntegral) froms)
    named = bucketsBy (placeTotal o) places
    from, to :: Int -> Int
    from f = fromIntegral (froms U.! f)
    to f = fromIntegral (tos U.! f)
    -- The faces by where they begin, place by place and by name in each.
    ordered = U.fromListN total (concatMap (inNameOrder . bucketOf starting) [0 .. placeTotal o - 1])
    newNumbers = U.update_ (U.replicate total 0) ordered (U.enumFromN 0 total) :: U.Vector Int32
    inNameOrder fs@[_] = fs
    inNameOrder fs = sortOn (\f -> (nameOf f, sides U.! f)) fs
    inAngleOrder fs@[_] = fs
    inAngleOrder fs = sortBy (byAngle `on` (\f -> (from f, to f))) fs
    byAngle = angleOrder o
    -- The next face counter-clockwise from the one that arrives: between them is a cone of free space. One that leads
    -- back the same way comes last, after a full turn.
    follower f = case inAngleOrder (bucketOf starting (numberOf o (to f))) of
      [g] -> g
      here -> fromMaybe f (listToMaybe (filter later here <> here))
      where
        later g = byAngle (to f, from f) (to f, to g) == LT
    followers = U.generate total follower
    leaders = U.update_ (U.replicate total 0) followers (U.enumFromN 0 total)
    -- Of a face, the corner that names where it begins.
    nameOf f = case bucketOf named (numberOf o (from f)) of
      [only] -> only
      names -> case filter (`isOnFlankOf` f) names of
        [] -> minimum names
        own -> minimum own
    isOnFlankOf i f = any ((== ownerOf o i) . fromIntegral . sideOwner) [f, leaders U.! f]
    sideOwner f = sideOwners U.! fromIntegral (sides U.! f)
    sideOwners = ownersFrom (sideFirsts o)

-- | 'freeCorners' where nothing meets: each corner of a ring begins its one side there, and on the way back along a
-- wall what follows a face that arrives is the other one that begins there.
wholeSides :: Outline -> Boundary
wholeSides o = runST $ do
  corners <- M.new total
  sides <- M.new total
  nexts <- M.new total
  let begins new i side next = do
        M.write corners new (fromIntegral i)
        M.write sides new (fromIntegral side)
        M.write nexts new next
  forM_ (polygonIndices o) $ \p -> case outlineForms o V.! p of
    Ring -> case solidFlank o p of
      LeftTurn -> forM_ (cornersOf o p) $ \i -> begins (front i) i (sideNumberOf o firsts i) (news U.! after i)
      _ -> forM_ (cornersOf o p) $ \i -> begins (front (after i)) (after i) (sideNumberOf o firsts i) (news U.! i)
    Polyline -> forM_ (segmentStarts o p) $ \i -> do
      begins (front i) i (sideNumberOf o firsts i) (news U.! after i)
      begins (back (after i)) (after i) (backSideNumberOf o firsts i) (fromIntegral (back i))
  named <- U.unsafeFreeze corners
  Boundary (outlineNumbers o) named named <$> U.unsafeFreeze sides <*> U.unsafeFreeze nexts
  where
    firsts = sideFirsts o
    total = U.sum faces
    -- In the order of places, how many faces begin at each corner: two between the ends of a wall.
    faces = U.map facesAt (outlineOrder o)
    facesAt i = if hasTwo (fromIntegral i) then 2 else 1
    hasTwo i = outlineForms o V.! ownerOf o i == Polyline && not (isEnd i)
    isEnd i = i == outlineFirst o U.! p || i == outlineFirst o U.! (p + 1) - 1
      where
        p = ownerOf o i
    -- By stated corner, the first of its own. It begins the side with the lesser number.
    news = U.update_ (U.replicate (outlineTotal o) 0) (U.map fromIntegral (outlineOrder o)) starts :: U.Vector Int32
    starts = U.map fromIntegral (U.prescanl' (+) 0 faces)
    front i = fromIntegral (news U.! i) :: Int
    back i = if hasTwo i then front i + 1 else front i
    after = around o 1

-- | The order of directions from a place, each given by the place and another one: counter-clockwise, from the one that
-- leads down, and from there on to the right.
angleOrder :: Outline -> (Int, Int) -> (Int, Int) -> Ordering
angleOrder o (x, a) (_, b) =
  compare (half a) (half b) <> turnOrder (turn (rankedPoints (outlineRanked o)) x a b)
  where
    half c = placeOf o c < placeOf o x

-- | What lies along a piece between two places, the first the lesser one. Sides by number.
data Occupant
  = -- | A side of a ring with its solid to the left of the way from the lesser place.
    SolidLeft !Int
  | SolidRight !Int
  | -- | A thin wall with its left and its right face.
    Wall !Int !Int

-- | The faces of sides that are not covered, cut where something touches them.
exposed :: Outline -> [Contact] -> [Face]
exposed o found = concatMap facesOf (Map.elems together)
  where
    cuts = IntMap.fromListWith (<>) [(s, [i]) | OnSegment i s <- found]
    -- What lies along one piece; each is alone where nothing meets.
    together =
      Map.fromListWith
        (<>)
        [ ((placeOf o low, placeOf o high), [piece])
        | piece@(low, high, _) <- concatMap piecesOf (polygonIndices o)
        ]
    piecesOf p =
      [ (low, high, occupant)
      | s <- segmentStarts o p
      , let t = around o 1 s
      , let onwards = placeOf o s < placeOf o t
      , let occupant = occupantOf s onwards
      , let between = case IntMap.lookup s cuts of
              Nothing -> if onwards then [s, t] else [t, s]
              Just corners -> sortOn (placeOf o) (s : t : corners)
      , (low, high) <- zip between (drop 1 between)
      , placeOf o low /= placeOf o high
      ]
      where
        flank = solidFlank o p
        occupantOf s onwards = case outlineForms o V.! p of
          Polyline
            | onwards -> Wall (back s) (front s)
            | otherwise -> Wall (front s) (back s)
          Ring
            | (flank == LeftTurn) == onwards -> SolidLeft (front s)
            | otherwise -> SolidRight (front s)
    firsts = sideFirsts o
    front = sideNumberOf o firsts
    back = backSideNumberOf o firsts
    facesOf [] = []
    facesOf occupants@((low, high, _) : _) =
      [face high low side | null leftSolids, side <- take 1 (map fst walls <> rightSolids)]
        <> [face low high side | null rightSolids, side <- take 1 (map snd walls <> leftSolids)]
      where
        leftSolids = [side | (_, _, SolidLeft side) <- occupants]
        rightSolids = [side | (_, _, SolidRight side) <- occupants]
        walls = [(left, right) | (_, _, Wall left right) <- occupants]
    face a b side = (fromIntegral a, fromIntegral b, fromIntegral side)
