-- | How polygons may not lie: all that is wrong with their geometry, found where "Visibility.Scene.Touching" finds that
-- something is.
module Visibility.Scene.Fault
  ( placed
  ) where

import Data.Either (isLeft)
import qualified Data.IntMap.Strict as IntMap
import qualified Data.IntSet as IntSet
import Data.List (foldl')
import qualified Data.Map.Strict as Map
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Error (SceneError (..))
import Visibility.Exact.Predicate
import Visibility.Scene.Boxes
import Visibility.Scene.Contact
import Visibility.Scene.Id
import Visibility.Scene.Limb
import Visibility.Scene.Outline
import Visibility.Scene.Raw
import Visibility.Scene.Touching

-- Note [Few to compare]
-- ~~~~~~~~~~~~~~~~~~~~~
-- What is wrong is found without a comparison of all with all. Of two sides that cross, one is 'tangled'. Of two
-- polygons of which one is inside of the other, one is a culprit of 'touching'. Parts of polygons that overlap in a
-- place are found as intervals of directions that do. There are at most about twice as many tangled sides and culprits
-- as there are faults, so little is compared that has nothing wrong.

-- | Where polygons touch; or what is wrong. By polygon: what it has wrong at its own corners; then what else is wrong
-- with it and with polygons that come after it, first as a whole and then by corner or side, each in no promised order
-- and some of it several times. A polygon inside of another one, or outside of the enclosure, comes with itself. The
-- shapes are those of the outline.
--
-- /Cost/ O(n log n) where nothing is wrong. Else what is wrong is found while it is consumed, in O(n) memory. Each
-- tangled side is compared with what has a box that overlaps its own, and each culprit with what has a box around its
-- own or inside of it, see Note [Few to compare].
placed :: [Shape] -> Outline -> Either [([SceneError], [[SceneError]])] Contacts
placed shapes o = case touching o of
  Right found | IntSet.null marred -> Right found
  Left ps | IntSet.null marred -> wrongBy (culprits shapes (IntSet.fromList ps))
  _ -> wrongBy (culprits shapes marred)
  where
    wrongBy = Left . faults (V.fromList shapes) o (V.fromList wrongs)
    wrongs = map wrong polygons
    wrong p = if placeTotal o < outlineTotal o || goesStraight o p then alone o p else []
    -- Those that have something wrong at their own corners.
    marred = IntSet.fromList [p | (p, _ : _) <- zip polygons wrongs]
    polygons = polygonIndices o

-- | Polygons without which nothing would be wrong, those given among them.
--
-- /Cost/ that of a few times 'touching': once for boundaries, once for where polygons are.
culprits :: [Shape] -> IntSet.IntSet -> IntSet.IntSet
culprits shapes found = case touching (outline (map snd others)) of
  Right _ -> found
  Left ps -> culprits shapes (foldr (IntSet.insert . fst . (V.fromList others V.!)) found ps)
  where
    others = [(p, shape) | (p, shape) <- zip [0 ..] shapes, p `IntSet.notMember` found]

-- | Of two polygons whose boundaries meet: do these cross, do the polygons overlap in a place where they meet?
data Relation = Relation !Bool !Bool

-- | All that is wrong, given what polygons have wrong at their own corners, and 'culprits'.
faults :: V.Vector Shape -> Outline -> V.Vector [SceneError] -> IntSet.IntSet -> [([SceneError], [[SceneError]])]
faults shapes o wrongs guilty =
  [ (wrongs V.! p, (alongItself p <> overlaps p relations <> position p relations) : map (atCorner p) (cornersOf o p))
  | p <- polygons
  , let relations = related p
  ]
  where
    polygons = polygonIndices o
    owner = ownerOf o
    id' = (outlineIds o V.!)
    isRing p = outlineForms o V.! p == Ring
    isGuilty p = p `IntSet.member` guilty
    crossing s t = CrossingSides (sideNameOf o (min s t)) (sideNameOf o (max s t))

    -- A side is compared with all others if it is tangled, else with those that are.
    (knots, cuts) = tangled o
    isKnot = let these = IntSet.fromList knots in (`IntSet.member` these)
    passing = IntMap.fromListWith (<>) [(numberOf o c, [s]) | (c, s) <- cuts]
    partners sides s = near o (if isKnot s then allOf sides else knotsOf sides) (segment s)
    segment s = Segment s (nexts U.! s)
    nexts = U.generate (outlineTotal o) (around o 1)
    meet s t = meeting (outlineRanked o) (segment s) (segment t)
    inAll = sidesFrom (concatMap (segmentStarts o) polygons)
    inOne = V.fromList (map (sidesFrom . segmentStarts o) polygons)
    sidesFrom starts = Sides (gathered (boxFrom o) starts) (gathered (boxFrom o) (filter isKnot starts))

    -- What is wrong at a corner, or with the side from there.
    atCorner p i =
      [crossing i t | startsSide p i, t <- partners inAll i, owner t > p, Crossing <- [meet i t]]
        <> [crossing i t | unsound V.! p, t <- ownCrossings p i]
        <> [ CornerOnSide (cornerNameOf o i) (sideNameOf o s) (outlinePoint o i)
           | unsound V.! p
           , isRing p
           , s <- ownTouching p i
           ]

    -- Contacts of a polygon with itself that its own angles do not explain. In a ring, a corner on a side next but one
    -- comes from a spike between.
    ownCrossings p i = [t | startsSide p i, t <- partners (inOne V.! p) i, t > i, Crossing <- [meet i t]]
    ownTouching p i = filter (\s -> i /= around o (-1) s && i /= around o 2 s) (loose <> tight)
      where
        loose = filter ((== p) . owner) (IntMap.findWithDefault [] (numberOf o i) passing)
        tight = [s | s <- near o (knotsOf (inOne V.! p)) (Segment i i), isOn i s]
    isOn i s = case meeting (outlineRanked o) (Segment i i) (segment s) of
      Touching found -> FirstOnSecond i `elem` found
      _ -> False
    startsSide p i = isRing p || i + 1 < outlineFirst o U.! (p + 1)
    unsound = V.fromList (map isUnsound polygons)
    isUnsound p =
      isGuilty p && not (isFlat o p) && (not (null (wrongs V.! p)) || isLeft (touching (outline [shapes V.! p])))

    -- Overlaps are told only if no polygon has something wrong with itself, but that a wall runs along itself.
    areFine = V.all null wrongs && not (any isSevere polygons)
    isSevere p = unsound V.! p && (isRing p || any (not . null . ownCrossings p) (cornersOf o p))
    alongItself p = [OverlappingWalls (id' p) (id' p) | unsound V.! p, areFine]
    overlaps p relations =
      [ if hasSolid p q then OverlappingPolygons (id' p) (id' q) else OverlappingWalls (id' p) (id' q)
      | areFine
      , (q, Relation cross True) <- IntMap.toList (snd (IntMap.split p relations))
      , not (hasSolid p q && cross)
      ]
    hasSolid p q = isRing p || isRing q
    limbs = limbsOf o isGuilty passing

    -- The polygons that one crosses or overlaps in places where they meet, and some that it touches.
    related p = foldl' met (IntMap.fromSet (const (Relation False True)) here) pairs
      where
        here = if areFine then IntSet.fromList (overlapping limbs p) else IntSet.empty
        pairs = [(s, t) | s <- segmentStarts o p, t <- partners inAll s, owner t /= p]
        met known (s, t) = case meet s t of
          Apart -> known
          Crossing -> IntMap.insertWith both (owner t) (Relation True False) known
          Touching found ->
            IntMap.insertWith both (owner t) (Relation False (areFine && any (overlap s t) found)) known
    both (Relation a b) (Relation c d) = Relation (a || c) (b || d)
    overlap s t touch = case touch of
      Ends _ _ -> False
      FirstOnSecond i -> overlapsOn o i t
      SecondOnFirst i -> overlapsOn o i s

    -- Is a polygon inside of another one, or outside of the enclosure? Where boundaries do not meet, one corner speaks
    -- for all.
    position p relations
      | id' p == Enclosure = []
      | otherwise =
          [ NestedPolygon (id' p) (id' q)
          | q <- those (`boxSurrounds` (boxes V.! p)) (if isGuilty p then allOf inScene else knotsOf inScene)
          , id' q /= Enclosure
          , isRing q
          , q `IntMap.notMember` relations
          , isInside p q
          , not (touches p q)
          ]
            <> [ OutsideEnclosure (id' p)
               | room <- drop (length polygons - 1) polygons
               , id' room == Enclosure
               , isGuilty p || isGuilty room
               , not (isFlat o room)
               , not (isInside p room)
               , not (touches p room)
               ]
    touches p q = or [meet s t /= Apart | s <- segmentStarts o p, t <- near o (allOf (inOne V.! q)) (segment s)]
    boxes = V.fromList [enclosingBox (map (boxFrom o) (segmentStarts o p)) | p <- polygons]
    inScene = Sides (gathered (boxes V.!) polygons) (gathered (boxes V.!) (IntSet.toList guilty))
    isInside p q = odd (length (filter (isBelow r corner . segment) (those above (allOf (inOne V.! q)))))
      where
        r = outlineRanked o
        corner = outlineFirst o U.! p
        x = column r corner
        y = row r corner
        above box = boxLeft box <= x && x <= boxRight box && boxTop box >= y

boxFrom :: Outline -> Int -> Box
boxFrom o = segmentBox (outlineRanked o) . segmentFrom o

-- | Items by number, in a tree of their boxes.
data Gathered = Gathered !BoxTree !(U.Vector Int)

gathered :: (Int -> Box) -> [Int] -> Gathered
gathered boxOf items = Gathered (boxTree (map boxOf items)) (U.fromList items)

-- | The items whose box has a property, as 'foldBoxes' requires it.
those :: (Box -> Bool) -> Gathered -> [Int]
those has (Gathered tree items) = foldBoxes has (\found k -> items U.! k : found) [] tree
{-# INLINE those #-}

-- | All of some sides or polygons, and those among them that must be compared with all.
data Sides = Sides {allOf :: Gathered, knotsOf :: Gathered}

-- | The sides whose boxes overlap that of a segment.
near :: Outline -> Gathered -> Segment -> [Int]
near o sides segment = those (boxesOverlap (segmentBox (outlineRanked o) segment)) sides

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
