-- | How polygons may not lie: all that is wrong with their geometry, found where "Visibility.Scene.Touching" finds that
-- something is.
module Visibility.Scene.Fault
  ( placed
  ) where

import qualified Data.IntMap.Strict as IntMap
import qualified Data.IntSet as IntSet
import qualified Data.Map.Strict as Map
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Error (SceneError (..))
import Visibility.Exact.Predicate
import Visibility.Scene.Boxes
import Visibility.Scene.Contact
import Visibility.Scene.Id
import Visibility.Scene.Outline
import Visibility.Scene.Raw
import Visibility.Scene.Touching

-- | Where polygons touch; or what is wrong, by polygon, in no promised order and some of it several times. A fault of
-- two polygons is given with the first one; that of a polygon inside of another one, or outside of the enclosure, with
-- that polygon. The shapes are those of the outline.
--
-- /Cost/ O(n log n) where nothing is wrong. Else, while what is wrong is consumed, besides O(1) for each pair of sides
-- whose boxes overlap, and for each pair of polygons of which one has its box in the other's a query in a tree of
-- sides, which is O(√n) as a rule and O(n) at worst. If 'culprits' finds a few polygons, only pairs with one of those
-- count.
placed :: [Shape] -> Outline -> Either [[SceneError]] Contacts
placed shapes o = case touching o of
  Right found | IntSet.null marred -> Right found
  _ -> Left (faults (V.fromList shapes) o (V.fromList wrongs) (culprits shapes marred))
  where
    wrongs = map wrong polygons
    wrong p = if placeTotal o < outlineTotal o || goesStraight o p then alone o p else []
    -- Those that have something wrong at their own corners.
    marred = IntSet.fromList [p | (p, _ : _) <- zip polygons wrongs]
    polygons = polygonIndices o

-- | A few polygons without which nothing would be wrong, those given among them; 'Nothing' if it takes more tries to
-- find them than a few.
--
-- /Cost/ that of some times 'touching'.
culprits :: [Shape] -> IntSet.IntSet -> Maybe IntSet.IntSet
culprits shapes = go (3 :: Int)
  where
    go tries found = case touching (outline (map snd others)) of
      Right _ -> Just found
      Left ps
        | tries > 1 -> go (tries - 1) (foldr (IntSet.insert . fst . (V.fromList others V.!)) found ps)
        | otherwise -> Nothing
      where
        others = [(p, shape) | (p, shape) <- zip [0 ..] shapes, p `IntSet.notMember` found]

-- | A meeting of boundaries, by the indices of corners and of the corners that start segments.
data Contact
  = -- | Two corners in one place.
    AtCorners !Int !Int
  | -- | A corner between the ends of a segment.
    OnSegment !Int !Int
  | -- | Two segments that cross in a point that is an end of neither.
    Cross !Int !Int

-- | All that is wrong, given what polygons have wrong at their own corners, and 'culprits'.
faults :: V.Vector Shape -> Outline -> V.Vector [SceneError] -> Maybe IntSet.IntSet -> [[SceneError]]
faults shapes o wrongs few = [wrongs V.! p <> inItself p <> withLater p <> position p | p <- polygons]
  where
    polygons = polygonIndices o
    owner = ownerOf o
    id' = (outlineIds o V.!)
    isCulprit p = maybe True (IntSet.member p) few
    crossing s t = CrossingSides (sideNameOf o (min s t)) (sideNameOf o (max s t))

    -- Contacts of a polygon with itself that its own angles do not explain.
    inItself p =
      [crossing s t | Cross s t <- own]
        <> [CornerOnSide (cornerNameOf o i) (sideNameOf o s) (outlinePoint o i) | OnSegment i s <- own, isRing p]
        <> [OverlappingWalls (id' p) (id' p) | not (isRing p), areFine, any (overlap o) own]
      where
        own = ownContacts p
    ownContacts p
      | isCulprit p && not (isFlat o p) && isUnsound p =
          [c | s <- segmentStarts o p, t <- ofPolygon p s, s < t, c <- meet o s t, isOwn p c]
      | otherwise = []
    isUnsound p = not (null (wrongs V.! p)) || either (const True) (const False) (touching (outline [shapes V.! p]))
    -- Corners of one ring in one place are the end of one side and the start of the next, or repeated corners. In a
    -- ring, a corner on a side next but one comes from a spike between.
    isOwn p c = case c of
      AtCorners i j -> not (isRing p) && i /= j
      Cross _ _ -> True
      OnSegment i s -> not (isRing p) || i /= around o (-1) s && i /= around o 2 s
    -- Overlaps are told only if no polygon has something wrong with itself.
    areFine = V.all null wrongs && not (any (any isSevere . ownContacts) polygons)
    isSevere c = case c of
      AtCorners _ _ -> False
      Cross _ _ -> True
      OnSegment i _ -> isRing (owner i)
    isRing p = outlineForms o V.! p == Ring

    -- What is wrong with a polygon and others that come after it.
    withLater p = [crossing s t | Cross s t <- met] <> concatMap overlapError (if areFine then others else [])
      where
        met = maybe (contactsOf (> p) p) (const (IntMap.findWithDefault [] p byFirst)) few
        crossed = IntSet.fromList [max (owner s) (owner t) | Cross s t <- met]
        others = [q | c <- met, overlap o c, let q = snd (ownersOf c), not (hasSolid p q && q `IntSet.member` crossed)]
        overlapError q
          | hasSolid p q = [OverlappingPolygons (id' p) (id' q)]
          | otherwise = [OverlappingWalls (id' p) (id' q)]
    hasSolid p q = isRing p || isRing q
    ownersOf c = case c of
      AtCorners i j -> inOrder (owner i) (owner j)
      OnSegment i s -> inOrder (owner i) (owner s)
      Cross s t -> inOrder (owner s) (owner t)
    inOrder p q = (min p q, max p q)
    byFirst =
      IntMap.fromListWith
        (<>)
        [ (fst (ownersOf c), [c])
        | p <- maybe [] IntSet.toList few
        , c <- contactsOf (\q -> q > p || q < p && not (isCulprit q)) p
        ]
    -- The contacts of a polygon with some others.
    contactsOf wanted p =
      [c | s <- segmentStarts o p, t <- near o tree (starts U.!) s, wanted (owner t), c <- meet o s t]
    starts = U.fromList (concatMap (segmentStarts o) polygons)
    tree = boxTree (map (boxFrom o) (U.toList starts))

    -- Is a polygon inside of another one, or outside of the enclosure? Where boundaries do not meet, one corner speaks
    -- for all.
    position p
      | id' p == Enclosure = []
      | otherwise =
          [ NestedPolygon (id' p) (id' q)
          | q <- foldBoxes (`boxContains` (boxes V.! p)) (flip (:)) [] boxesTree
          , q /= p
          , id' q /= Enclosure
          , isRing q
          , isCulprit p || isCulprit q
          , not (touches p q)
          , isInside p q
          ]
            <> [ OutsideEnclosure (id' p)
               | room <- drop (length polygons - 1) polygons
               , id' room == Enclosure
               , isCulprit p || isCulprit room
               , not (isFlat o room)
               , not (touches p room)
               , not (isInside p room)
               ]
    touches p q =
      or [True | s <- segmentStarts o p, t <- ofPolygon q s, _ : _ <- [meet o s t]]
    -- The segments of a polygon that may meet another one.
    ofPolygon p = near o (trees V.! p) (outlineFirst o U.! p +)
    boxes = V.fromList [enclosingBox (map (boxFrom o) (segmentStarts o p)) | p <- polygons]
    boxesTree = boxTree (V.toList boxes)
    trees = V.fromList [boxTree (map (boxFrom o) (segmentStarts o p)) | p <- polygons]
    isInside p q = foldBoxes above passed False (trees V.! q)
      where
        passed inside k = inside /= isBelow r corner (segmentFrom o (outlineFirst o U.! q + k))
        r = outlineRanked o
        corner = outlineFirst o U.! p
        x = column r corner
        y = row r corner
        above box = boxLeft box <= x && x <= boxRight box && boxTop box >= y

boxFrom :: Outline -> Int -> Box
boxFrom o = segmentBox (outlineRanked o) . segmentFrom o

-- | The segments, in a tree where each has a number from which a function makes its start, whose boxes overlap that of
-- a segment.
near :: Outline -> BoxTree -> (Int -> Int) -> Int -> [Int]
near o tree start s = foldBoxes (boxesOverlap (boxFrom o s)) (\found k -> start k : found) [] tree

-- | The contacts of two segments.
meet :: Outline -> Int -> Int -> [Contact]
meet o s t = case meeting (outlineRanked o) (segmentFrom o s) (segmentFrom o t) of
  Apart -> []
  Crossing -> [Cross s t]
  Touching touches -> map touch touches
  where
    touch how = case how of
      Ends a b -> AtCorners a b
      FirstOnSecond a -> OnSegment a t
      SecondOnFirst b -> OnSegment b s

-- | Do two polygons that touch in a place overlap there: does one reach into the solid of the other, or are they walls
-- that lie along each other?
--
-- /Requires/ simple rings, and walls without zero lengths. Polygons whose boundaries meet and do not cross overlap if
-- and only if they do at some place of contact.
overlap :: Outline -> Contact -> Bool
overlap o contact = case contact of
  AtCorners i j -> or [clash i one other | one <- atCorner i, other <- atCorner j]
  OnSegment i s -> or [clash i one other | one <- atCorner i, other <- onSegment s]
  Cross _ _ -> False
  where
    atCorner i = case (solidFlank o (ownerOf o i), joinedTo o i) of
      (Nowhere, (after, before)) -> map Ray (filter (/= noCorner) [after, before])
      (flank, (after, before)) -> [arc flank after before]
    onSegment s = case solidFlank o (ownerOf o s) of
      Nowhere -> [Ray s, Ray (around o 1 s)]
      flank -> [arc flank (around o 1 s) s]
    arc OnLeft ahead behind = Arc ahead behind
    arc _ ahead behind = Arc behind ahead
    clash x (Arc a b) (Arc c d) =
      sameWay x a c || insideArc (turn points x) (a, b) c || insideArc (turn points x) (c, d) a
    clash x (Arc a b) (Ray c) = insideArc (turn points x) (a, b) c
    clash x (Ray a) (Arc c d) = insideArc (turn points x) (c, d) a
    clash x (Ray a) (Ray c) = sameWay x a c
    sameWay x a b = turn points x a b == Collinear && (placeOf o a > placeOf o x) == (placeOf o b > placeOf o x)
    points = rankedPoints (outlineRanked o)

-- | What leads away from a place: the open arc of directions that lead into a ring, from one direction
-- counter-clockwise to another, or the direction of a piece of a thin wall. Directions are those to other corners.
data Limb = Arc !Int !Int | Ray !Int

-- Does a polygon go straight on or back at a corner, or not away from there? No other one is flat or has a spike.
goesStraight :: Outline -> Int -> Bool
goesStraight o p = any straight (cornersOf o p)
  where
    straight i = case joinedTo o i of
      (after, before) -> after /= noCorner && before /= noCorner && turn points before i after == Collinear
    points = rankedPoints (outlineRanked o)

-- Is a polygon a ring that has all corners on one line?
isFlat :: Outline -> Int -> Bool
isFlat o p = outlineForms o V.! p == Ring && not hasArea
  where
    r = outlineRanked o
    hasArea = case cornersOf o p of
      a : rest
        | b : others <- dropWhile (samePlace r a) rest -> any ((/= Collinear) . turn (rankedPoints r) a b) others
      _ -> False

-- What a polygon has wrong at its own corners.
alone :: Outline -> Int -> [SceneError]
alone o p = [ZeroArea (outlineIds o V.! p) | isFlat o p] <> repeats <> spikes
  where
    r = outlineRanked o
    place = placeOf o
    firsts = Map.fromListWith min [(place i, i) | i <- cornersOf o p]
    -- A thin wall may come back to where it has been, but a piece of it needs a length.
    repeats = case outlineForms o V.! p of
      Ring -> [repeated i j | i <- cornersOf o p, Just j <- [Map.lookup (place i) firsts], j /= i]
      Polyline -> [repeated i (i - 1) | i <- drop 1 (cornersOf o p), samePlace r i (i - 1)]
    repeated i j = RepeatedCorner (cornerNameOf o i) (j - outlineFirst o U.! p) (outlinePoint o i)
    spikes =
      [ Spike (cornerNameOf o i) (outlinePoint o i)
      | not (isFlat o p)
      , i <- inner
      , let before = around o (-1) i
            after = around o 1 i
      , turn (rankedPoints r) before i after == Collinear
      , not (samePlace r before i)
      , not (samePlace r i after)
      , (place before < place i) == (place after < place i)
      ]
    inner = case outlineForms o V.! p of
      Ring -> cornersOf o p
      Polyline -> drop 1 (segmentStarts o p)
