-- | The only door from what a file says to a 'Scene'.
module Visibility.Scene.Validate
  ( validate
  ) where

import Data.List (sortOn)
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Error (MaterialPlace (..), SceneError (..), sceneErrorPlace)
import Visibility.Exact.Point (Point, latticeFor, ontoLattice)
import Visibility.Exact.Predicate (Turn (Collinear), turn)
import Visibility.Scene.Boxes
import Visibility.Scene.Contact
import Visibility.Scene.Disjoint
import Visibility.Scene.Id
import Visibility.Scene.Raw
import Visibility.Scene.Type

-- | The scene, or everything that is wrong with it: sorted by polygon and then by corner or side, nothing twice.
--
-- Reported once: a contact of two corners, or of a corner and a side, though up to four pairs of sides meet there.
-- Sides that overlap are reported as the contacts of their ends. A thin wall has its two sides in one place, and
-- contacts name side 0. What follows from something else is left out: contacts at a spike between the sides that make
-- it, contacts of a polygon of no area with itself, and whether polygons whose boundaries meet are nested. A polygon of
-- too few corners is looked at no further. Of a boundary that crosses itself, the inside is where a ray crosses it an
-- odd number of times.
--
-- /Cost/ of a valid scene O(n log² n) for its boundaries, however they lie, and for each pair of polygons of which one
-- has its box in the other's a query in a tree of sides, which is O(√n) as a rule and O(n) at worst. Of an invalid
-- scene besides O(1) for each pair of sides whose boxes overlap.
--
-- /Laws/ the set of errors is that of a comparison of all pairs of sides and all pairs of polygons. A valid scene has
-- the corners, sides and materials that the file gives, under the file's names.
validate :: RawScene -> Either (NonEmpty SceneError) Scene
validate raw = case ordered (statementErrors shapes <> geometryErrors shapes) of
  _ | null shapes -> Left (EmptyScene :| [])
  e : es -> Left (e :| es)
  [] -> Right (assemble (rawName raw) (map valid shapes))
  where
    shapes = zip (map Obstacle [0 ..]) (rawPolygons raw) <> [(Enclosure, room) | Just room <- [rawEnclosure raw]]
    ordered = sortOn (\e -> (sceneErrorPlace e, e)) . Set.toList . Set.fromList

type Shape = (PolygonId, RawPolygon)

valid :: Shape -> ValidPolygon
valid (p, polygon) =
  ValidPolygon p (rawPolygonName polygon) points [side k | k <- [0 .. length points - 1]]
  where
    points = rawCorners polygon
    side k = maybe material overridden (Map.lookup k (rawSides polygon))
    material = rawMaterial polygon
    overridden (MaterialOverride e r) = Material (fromMaybe (emission material) e) (fromMaybe (reflectivity material) r)

-- Numbers of corners, side numbers, materials.
statementErrors :: [Shape] -> [SceneError]
statementErrors shapes = concat [few shape <> sideNumbers shape <> materials shape | shape <- shapes]
  where
    few (p, polygon) = [TooFewCorners p n | let n = length (rawCorners polygon), n < fewest p]
    sideNumbers (p, polygon) =
      [ NoSuchSide (SideName p k) n
      | let n = length (rawCorners polygon)
      , k <- Map.keys (rawSides polygon)
      , k < 0 || k >= n
      ]
    materials (p, polygon) =
      stated (OfPolygon p) (Just (emission whole)) (Just (reflectivity whole))
        <> concat [stated (OfSide (SideName p k)) e r | (k, MaterialOverride e r) <- Map.toList (rawSides polygon)]
      where
        whole = rawMaterial polygon
    stated place e r =
      [BadEmission place x | Just x <- [e], x < 0] <> [BadReflectivity place x | Just x <- [r], x < 0 || x >= 1]

-- So many corners at least.
fewest :: PolygonId -> Int
fewest Enclosure = 3
fewest (Obstacle _) = 2

-- | The corners of all polygons that have enough of them, by one index, in the file's order.
data Outline = Outline
  { outlineIds :: !(V.Vector PolygonId)
  , outlineFirst :: !(U.Vector Int)
  -- ^ By polygon: the index of its corner 0; then the number of corners.
  , outlineOwner :: !(U.Vector Int)
  -- ^ By corner: the place of its polygon in 'outlineIds'.
  , outlinePoints :: !(V.Vector Point)
  , outlineRanked :: !Ranked
  }

outline :: [Shape] -> Outline
outline shapes =
  Outline
    { outlineIds = V.fromList (map fst shapes)
    , outlineFirst = U.fromList (scanl (+) 0 sizes)
    , outlineOwner = U.fromList (concat (zipWith replicate sizes [0 ..]))
    , outlinePoints = V.fromList points
    , outlineRanked = ranked (map (ontoLattice (latticeFor points)) points)
    }
  where
    points = concatMap (rawCorners . snd) shapes
    sizes = map (length . rawCorners . snd) shapes

-- The indices of a polygon's corners.
cornersOf :: Outline -> Int -> [Int]
cornersOf o p = [outlineFirst o U.! p .. outlineFirst o U.! (p + 1) - 1]

-- Corner k steps on around the same polygon.
around :: Outline -> Int -> Int -> Int
around o k i = first + (i - first + k) `mod` (outlineFirst o U.! (p + 1) - first)
  where
    p = outlineOwner o U.! i
    first = outlineFirst o U.! p

-- The segments of a polygon, by the corners that start them. The two sides of a thin wall are one.
segmentStarts :: Outline -> Int -> [Int]
segmentStarts o p = case cornersOf o p of
  [a, _] -> [a]
  more -> more

segmentFrom :: Outline -> Int -> Segment
segmentFrom o i = Segment i (around o 1 i)

cornerNameOf :: Outline -> Int -> CornerName
cornerNameOf o i = CornerName (outlineIds o V.! p) (i - outlineFirst o U.! p)
  where
    p = outlineOwner o U.! i

sideNameOf :: Outline -> Int -> SideName
sideNameOf o i = let CornerName p k = cornerNameOf o i in SideName p k

geometryErrors :: [Shape] -> [SceneError]
geometryErrors shapes = inThemselves <> map (contactError o) contacts <> positionErrors o flat met
  where
    o = outline [shape | shape@(p, polygon) <- shapes, length (rawCorners polygon) >= fewest p]
    polygons = [0 .. V.length (outlineIds o) - 1]
    flat = V.fromList (map (areaOf o) polygons)
    inThemselves = concatMap (alone o flat) polygons
    -- The sweep tells valid scenes at a cost that nothing can raise. Only if it finds something, all is looked for.
    contacts
      | null inThemselves, Disjoint <- boundaries (outlineRanked o) segments = []
      | otherwise = contactsOf o flat
    segments = map (segmentFrom o) (concatMap (segmentStarts o) polygons)
    met = Set.fromList [(min p q, max p q) | c <- contacts, let (p, q) = contactPolygons o c, p /= q]

data Area = NoArea | SomeArea
  deriving (Eq)

-- No area: three or more corners, all on one line.
areaOf :: Outline -> Int -> Area
areaOf o p = case cornersOf o p of
  [_, _] -> SomeArea
  a : rest
    | b : others <- dropWhile (samePlace r a) rest
    , any ((/= Collinear) . turn (rankedPoints r) a b) others ->
        SomeArea
  _ -> NoArea
  where
    r = outlineRanked o

-- What a polygon has wrong at its own corners.
alone :: Outline -> V.Vector Area -> Int -> [SceneError]
alone o flat p = [ZeroArea (outlineIds o V.! p) | flat V.! p == NoArea] <> repeats <> spikes
  where
    r = outlineRanked o
    place i = (column r U.! i, row r U.! i)
    firsts = Map.fromListWith min [(place i, i) | i <- cornersOf o p]
    repeats =
      [ RepeatedCorner (cornerNameOf o i) (j - outlineFirst o U.! p) (outlinePoints o V.! i)
      | i <- cornersOf o p
      , Just j <- [Map.lookup (place i) firsts]
      , j /= i
      ]
    spikes = case cornersOf o p of
      [_, _] -> []
      is ->
        [ Spike (cornerNameOf o i) (outlinePoints o V.! i)
        | flat V.! p == SomeArea
        , i <- is
        , let before = around o (-1) i
              after = around o 1 i
        , turn (rankedPoints r) before i after == Collinear
        , not (samePlace r before i)
        , not (samePlace r i after)
        , (place before < place i) == (place after < place i)
        ]

-- | A meeting of boundaries, by the indices of corners and of the corners that start segments.
data Contact = AtCorners !Int !Int | OnSegment !Int !Int | Cross !Int !Int

contactPolygons :: Outline -> Contact -> (Int, Int)
contactPolygons o contact = case contact of
  AtCorners i j -> (owner i, owner j)
  OnSegment i s -> (owner i, owner s)
  Cross s t -> (owner s, owner t)
  where
    owner = (outlineOwner o U.!)

contactError :: Outline -> Contact -> SceneError
contactError o contact = case contact of
  AtCorners i j -> CornerOnCorner (cornerNameOf o (min i j)) (cornerNameOf o (max i j)) (outlinePoints o V.! i)
  OnSegment i s -> CornerOnSide (cornerNameOf o i) (sideNameOf o s) (outlinePoints o V.! i)
  Cross s t -> CrossingSides (sideNameOf o (min s t)) (sideNameOf o (max s t))

-- All contacts, some of them several times.
contactsOf :: Outline -> V.Vector Area -> [Contact]
contactsOf o flat = foldOverlaps collect [] (boxTree (map (segmentBox r . segmentFrom o) starts))
  where
    r = outlineRanked o
    starts = concatMap (segmentStarts o) [0 .. V.length (outlineIds o) - 1]
    table = U.fromList starts
    ends = U.map (around o 1) table
    collect found i j
      | p /= q = case meeting r (Segment s s') (Segment t t') of
          Apart -> found
          Crossing -> Cross s t : found
          Touching touches -> map (touch s t) touches <> found
      | flat V.! p == NoArea = found
      | otherwise = case meeting r (Segment s s') (Segment t t') of
          Apart -> found
          Crossing -> Cross s t : found
          Touching touches -> filter isOwn (map (touch s t) touches) <> found
      where
        s = table U.! i
        s' = ends U.! i
        t = table U.! j
        t' = ends U.! j
        p = outlineOwner o U.! s
        q = outlineOwner o U.! t
    touch _ _ (Ends a b) = AtCorners a b
    touch _ t (FirstOnSecond a) = OnSegment a t
    touch s _ (SecondOnFirst b) = OnSegment b s
    -- Corners of one polygon in one place are the end of one side and the start of the next, or repeated corners. A
    -- corner on a side next but one comes from a spike between.
    isOwn (OnSegment i s) = i /= around o (-1) s && i /= around o 2 s
    isOwn (AtCorners _ _) = False
    isOwn (Cross _ _) = True

-- Nested polygons, and polygons outside of the enclosure. Where boundaries do not meet, one corner speaks for all.
positionErrors :: Outline -> V.Vector Area -> Set.Set (Int, Int) -> [SceneError]
positionErrors o flat met =
  [ NestedPolygon (name p) (name q)
  | p <- obstacles
  , q <- foldBoxes (`boxContains` (boxes V.! p)) (flip (:)) [] tree
  , q /= p
  , name q /= Enclosure
  , length (cornersOf o q) > 2
  , not (meet p q)
  , isInside p q
  ]
    <> [ OutsideEnclosure (name p)
       | room <- polygons
       , name room == Enclosure
       , flat V.! room == SomeArea
       , p <- obstacles
       , not (meet p room)
       , not (isInside p room)
       ]
  where
    r = outlineRanked o
    polygons = [0 .. V.length (outlineIds o) - 1]
    obstacles = filter ((/= Enclosure) . name) polygons
    name = (outlineIds o V.!)
    meet p q = (min p q, max p q) `Set.member` met
    boxes = V.map enclosingBox sideBoxes
    sideBoxes = V.fromList [map (segmentBox r . segmentFrom o) (segmentStarts o p) | p <- polygons]
    tree = boxTree (V.toList boxes)
    -- Made only for polygons that others may be inside of.
    trees = V.map boxTree sideBoxes
    isInside p q = foldBoxes above flipped Outside (trees V.! q) == Inside
      where
        corner = outlineFirst o U.! p
        x = column r U.! corner
        y = row r U.! corner
        above box = boxLeft box <= x && x <= boxRight box && boxTop box >= y
        flipped parity k
          | isBelow r corner (segmentFrom o (outlineFirst o U.! q + k)) = other parity
          | otherwise = parity
    other Inside = Outside
    other Outside = Inside

data Parity = Inside | Outside
  deriving (Eq)
