-- | The only door from what a file says to a 'Scene'.
module Visibility.Scene.Validate
  ( validate
  ) where

import Data.List (sortOn)
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Error (MaterialPlace (..), SceneError (..), sceneErrorPlace)
import Visibility.Exact.Predicate (Turn (Collinear), turn)
import Visibility.Scene.Boundary
import Visibility.Scene.Boxes
import Visibility.Scene.Contact
import Visibility.Scene.Disjoint
import Visibility.Scene.Id
import Visibility.Scene.Outline
import Visibility.Scene.Raw
import Visibility.Scene.Type (Scene, assemble)

-- | The scene, or everything that is wrong with it: sorted by polygon and then by corner or side, nothing twice.
--
-- Polygons may touch, in corners and along sides, but not overlap; so may thin walls, and a thin wall may touch itself,
-- but no two pieces of walls may lie along each other. Reported once: an overlap of two polygons, in however many
-- places. A thin wall has its two faces in one place, and crossings name that on the right of the way along it. What
-- follows from something else is left out: contacts at a spike between the sides that make it, contacts of a polygon of
-- no area with itself, overlaps of solids whose boundaries cross, and whether polygons whose boundaries meet are
-- nested. A polygon of too few corners is looked at no further; overlaps are not looked for while a polygon has
-- something wrong with itself. Of a boundary that crosses itself, the inside is where a ray crosses it an odd number of
-- times.
--
-- /Cost/ of a valid scene without contacts O(n log n), however the sides lie. Of others besides O(1) for each pair of
-- sides whose boxes overlap, what 'overlaps' takes, and for each pair of polygons of which one has its box in the
-- other's a query in a tree of sides, which is O(√n) as a rule and O(n) at worst.
--
-- /Laws/ the set of errors is that of a comparison of all pairs of sides and all pairs of polygons. A valid scene has
-- the corners, sides and materials that the file gives, under the file's names.
validate :: RawScene -> Either (NonEmpty SceneError) Scene
validate raw
  | null shapes = Left (EmptyScene :| [])
  | otherwise = case ordered (statementErrors shapes <> errors) of
      e : es -> Left (e :| es)
      [] -> Right (assemble (rawName raw) (contactTotal o found) shapes o (freeCorners o found))
  where
    shapes = zip (map Obstacle [0 ..]) (rawPolygons raw) <> [(Enclosure, room) | Just room <- [rawEnclosure raw]]
    o = outline [shape | shape@(_, polygon) <- shapes, cornerTotal polygon >= fewestCorners shape]
    (found, errors) = geometry o
    ordered = sortOn (\e -> (sceneErrorPlace e, e)) . Set.toList . Set.fromList

sideTotalOf :: Shape -> Int
sideTotalOf shape@(_, polygon) = sideTotal polygon {rawForm = formOf shape}

-- Numbers of corners, side numbers, materials.
statementErrors :: [Shape] -> [SceneError]
statementErrors shapes = concat [few shape <> sideNumbers shape <> materials shape | shape <- shapes]
  where
    few shape@(p, polygon) = [TooFewCorners p n | let n = cornerTotal polygon, n < fewestCorners shape]
    sideNumbers shape@(p, polygon) =
      [ NoSuchSide (SideName p k) n
      | let n = sideTotalOf shape
      , k <- Map.keys (rawSides polygon)
      , k < 0 || k >= n
      ]
    materials (p, polygon) =
      material' (OfPolygon p) (Just (emission whole)) (Just (reflectivity whole))
        <> concat [material' (OfSide (SideName p k)) e r | (k, MaterialOverride e r) <- Map.toList (rawSides polygon)]
      where
        whole = rawMaterial polygon
    material' place e r =
      [BadEmission place x | Just x <- [e], x < 0] <> [BadReflectivity place x | Just x <- [r], x < 0 || x >= 1]

-- Where boundaries meet, and all that is wrong in the plane. The sweep tells scenes without contacts at a cost that
-- nothing can raise; only if it finds something, all is looked for. It is not made for polygons that have something
-- wrong at their own corners.
geometry :: Outline -> ([Contact], [SceneError])
geometry o = case if null wrong then boundaries o else Meet of
  Disjoint -> ([], [])
  Misplaced -> ([], errors [])
  Meet -> let found = contacts o flat in (found, errors found)
  where
    errors = geometryErrors o flat wrong
    wrong = concatMap (alone o flat) (if placeTotal o < outlineTotal o then polygonIndices o else suspects)
    flat = Set.fromList (filter (isFlat o) suspects)
    suspects = filter (goesStraight o) (polygonIndices o)

-- Does a polygon go straight on or back at a corner, or not away from there? No other one is flat or has a spike.
goesStraight :: Outline -> Int -> Bool
goesStraight o p = any straight (cornersOf o p)
  where
    straight i = case joinedTo o i of
      (after, before) -> after /= noCorner && before /= noCorner && turn points before i after == Collinear
    points = rankedPoints (outlineRanked o)

-- All that is wrong, from the rings that have all corners on one line, what polygons have wrong at their own corners,
-- and all contacts.
geometryErrors :: Outline -> Set.Set Int -> [SceneError] -> [Contact] -> [SceneError]
geometryErrors o flat wrong found = inThemselves <> crossings <> overlapping <> positionErrors o flat met
  where
    inThemselves = wrong <> [e | c <- found, Just e <- [ownContact o c]]
    crossings = [CrossingSides (sideNameOf o (min s t)) (sideNameOf o (max s t)) | Cross s t <- found]
    crossedByThemselves = [() | Cross s t <- found, owner s == owner t]
    crossed = Set.fromList [pairOf (owner s) (owner t) | Cross s t <- found]
    overlapping
      | null inThemselves && null crossedByThemselves = mapMaybe overlapError (Set.toList (overlaps o found))
      | otherwise = []
    overlapError (SolidsOverlap p q)
      | (p, q) `Set.member` crossed = Nothing
      | otherwise = Just (OverlappingPolygons (name p) (name q))
    overlapError (WallsOverlap p q) = Just (OverlappingWalls (name p) (name q))
    met = Set.fromList [pairOf p q | c <- found, let (p, q) = contactPolygons c, p /= q]
    contactPolygons contact = case contact of
      AtCorners i j -> (owner i, owner j)
      OnSegment i s -> (owner i, owner s)
      Cross s t -> (owner s, owner t)
    pairOf p q = (min p q, max p q)
    owner = ownerOf o
    name = (outlineIds o V.!)

-- A ring may not touch itself.
ownContact :: Outline -> Contact -> Maybe SceneError
ownContact o contact = case contact of
  OnSegment i s
    | ownerOf o i == p, Ring <- outlineForms o V.! p ->
        Just (CornerOnSide (cornerNameOf o i) (sideNameOf o s) (outlinePoint o i))
    where
      p = ownerOf o s
  _ -> Nothing

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
alone :: Outline -> Set.Set Int -> Int -> [SceneError]
alone o flat p = [ZeroArea (outlineIds o V.! p) | p `Set.member` flat] <> repeats <> spikes
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
      | p `Set.notMember` flat
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

-- Nested polygons, and polygons outside of the enclosure. Where boundaries do not meet, one corner speaks for all.
positionErrors :: Outline -> Set.Set Int -> Set.Set (Int, Int) -> [SceneError]
positionErrors o flat met =
  [ NestedPolygon (name p) (name q)
  | p <- obstacles
  , q <- foldBoxes (`boxContains` (boxes V.! p)) (flip (:)) [] tree
  , q /= p
  , name q /= Enclosure
  , Ring <- [outlineForms o V.! q]
  , not (meet p q)
  , isInside p q
  ]
    <> [ OutsideEnclosure (name p)
       | room <- polygons
       , name room == Enclosure
       , room `Set.notMember` flat
       , p <- obstacles
       , not (meet p room)
       , not (isInside p room)
       ]
  where
    r = outlineRanked o
    polygons = polygonIndices o
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
        x = column r corner
        y = row r corner
        above box = boxLeft box <= x && x <= boxRight box && boxTop box >= y
        flipped parity k
          | isBelow r corner (segmentFrom o (outlineFirst o U.! q + k)) = other parity
          | otherwise = parity
    other Inside = Outside
    other Outside = Inside

data Parity = Inside | Outside
  deriving (Eq)
