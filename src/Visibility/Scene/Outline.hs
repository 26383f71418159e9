-- | The corners of all polygons as the file states them, numbered through: what validation works on.
module Visibility.Scene.Outline
  ( Shape
  , formOf
  , fewestCorners
  , Outline (..)
  , outline
    -- * Polygons
  , polygonIndices
  , cornersOf
  , around
  , joinedTo
  , noCorner
  , segmentStarts
  , segmentFrom
  , startOf
  , ownerOf
  , ownersFrom
    -- * Places
  , outlineTotal
  , placeTotal
  , numberOf
  , placeOf
  , angleOrder
  , outlinePoint
    -- * Solids
  , Solid (..)
  , solidFlank
  , solidOf
    -- * Names
  , sideFirsts
  , sideNumberOf
  , backSideNumberOf
  , cornerNameOf
  , sideNameOf
  ) where

import Data.Int (Int32)
import Data.List (foldl')
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.Point
import Visibility.Exact.Predicate (turn, turnOrder)
import Visibility.Scene.Contact
import Visibility.Scene.Id
import Visibility.Scene.Raw

-- | A polygon as it is stated, with its id.
type Shape = (PolygonId, RawPolygon)

-- | How the corners of a polygon are joined. An enclosure is a ring, two corners make a thin wall.
formOf :: Shape -> Form
formOf (Enclosure, _) = Ring
formOf (Obstacle _, polygon)
  | cornerTotal polygon == 2 = Polyline
  | otherwise = rawForm polygon

-- | So many corners at least.
fewestCorners :: Shape -> Int
fewestCorners shape = case formOf shape of
  Ring -> 3
  Polyline -> 2

-- | The corners of polygons by one index, in the file's order.
data Outline = Outline
  { outlineIds :: !(V.Vector PolygonId)
  , outlineForms :: !(V.Vector Form)
  , outlineFirst :: !(U.Vector Int)
  -- ^ By polygon: the index of its corner 0; then the number of corners.
  , outlineOwner :: !(U.Vector Int32)
  -- ^ By corner: see 'ownerOf'.
  , outlineLattice :: !Lattice
  , outlineRanked :: !Ranked
  , outlineOrder :: !(U.Vector Int32)
  -- ^ All corners in the order of their places.
  , outlineNumbers :: !(U.Vector Int32)
  -- ^ By corner: the number of its place among all places with corners, in their order.
  , outlineFlanks :: !(V.Vector Solid)
  -- ^ See 'solidFlank'. Each is found when it is first needed.
  }

-- | /Requires/ at least one corner in each shape. /Cost/ O(n log n).
outline :: [Shape] -> Outline
outline shapes = whole
  where
    whole =
      Outline
        { outlineIds = V.fromList (map fst shapes)
        , outlineForms = V.fromList (map formOf shapes)
        , outlineFirst = firsts
        , outlineOwner = ownersFrom firsts
        , outlineLattice = lattice
        , outlineRanked = r
        , outlineOrder = order
        , outlineNumbers = U.update_ (U.replicate (U.length order) 0) (U.map fromIntegral order) (U.scanl' (+) 0 steps)
        , outlineFlanks = V.generate (length shapes) (flankOf whole)
        }
    firsts = U.fromList (scanl (+) 0 (map (cornerTotal . snd) shapes))
    points = concatMap (rawCorners . snd) shapes
    lattice = latticeFor points
    r = ranked (placesOn lattice points)
    order = lexicographic r
    steps = U.zipWith step order (U.drop 1 order)
    step i j = if samePlace r (fromIntegral i) (fromIntegral j) then 0 else 1

-- | By item, the number of the group that it is in, from where each group begins and the last ends.
--
-- >>> ownersFrom [0, 2, 2, 3]
-- [0,0,2]
ownersFrom :: U.Vector Int -> U.Vector Int32
ownersFrom firsts = U.concat [U.replicate (to - from) k | (k, from, to) <- zip3 [0 ..] ends (drop 1 ends)]
  where
    ends = U.toList firsts

-- | The places of all polygons in 'outlineIds'.
polygonIndices :: Outline -> [Int]
polygonIndices o = [0 .. V.length (outlineIds o) - 1]

-- | The indices of a polygon's corners.
cornersOf :: Outline -> Int -> [Int]
cornersOf o p = [outlineFirst o U.! p .. outlineFirst o U.! (p + 1) - 1]

-- | Corner k steps on around the same polygon.
around :: Outline -> Int -> Int -> Int
around o k i = first + (i - first + k) `mod` (outlineFirst o U.! (p + 1) - first)
  where
    p = ownerOf o i
    first = outlineFirst o U.! p

-- | The corners to which segments lead from a corner: the one that follows it and the one before, or 'noCorner' where a
-- thin wall ends.
joinedTo :: Outline -> Int -> (Int, Int)
joinedTo o i
  | first < i && i < final = (i + 1, i - 1)
  | otherwise = case outlineForms o V.! p of
      Ring -> (if i < final then i + 1 else first, if i > first then i - 1 else final)
      Polyline -> (if i < final then i + 1 else noCorner, if i > first then i - 1 else noCorner)
  where
    p = ownerOf o i
    first = outlineFirst o U.! p
    final = outlineFirst o U.! (p + 1) - 1
{-# INLINE joinedTo #-}

-- | In the place of a corner.
noCorner :: Int
noCorner = -1

-- | The segments of a polygon, by the corners that start them. The two faces of a thin wall are one.
segmentStarts :: Outline -> Int -> [Int]
segmentStarts o p = case outlineForms o V.! p of
  Ring -> cornersOf o p
  Polyline -> drop 1 (map (subtract 1) (cornersOf o p))

-- | The segment that a corner starts.
segmentFrom :: Outline -> Int -> Segment
segmentFrom o i = Segment i (around o 1 i)

-- | The corner that starts a segment of which the ends are given in any order.
startOf :: Outline -> Segment -> Int
startOf o (Segment a b) = if fst (joinedTo o a) == b then a else b

-- | The place of a corner's polygon in 'outlineIds'.
ownerOf :: Outline -> Int -> Int
ownerOf o i = fromIntegral (outlineOwner o U.! i)
{-# INLINE ownerOf #-}

-- | A corner as the file states it.
outlinePoint :: Outline -> Int -> Point
outlinePoint o i = fromLattice (outlineLattice o) (pointAt (rankedPoints (outlineRanked o)) i)

-- | The number of corners.
outlineTotal :: Outline -> Int
outlineTotal = U.length . outlineOrder

-- | The number of places with corners.
placeTotal :: Outline -> Int
placeTotal o
  | U.null (outlineOrder o) = 0
  | otherwise = 1 + numberOf o (fromIntegral (U.last (outlineOrder o)))

-- | The number of a corner's place, see 'outlineNumbers'.
numberOf :: Outline -> Int -> Int
numberOf o i = fromIntegral (outlineNumbers o U.! i)
{-# INLINE numberOf #-}

-- | Where a corner is: the order of places is the lexicographic one.
placeOf :: Outline -> Int -> (Int, Int)
placeOf o i = (column r i, row r i)
  where
    r = outlineRanked o

-- | The order of directions from the place of a corner, given by other corners: counter-clockwise, from the one that
-- leads down, and from there on to the right.
angleOrder :: Outline -> Int -> Int -> Int -> Ordering
angleOrder o x a b
  | numberOf o a == numberOf o b = EQ
  | otherwise = case compare (half a) (half b) of
      EQ -> turnOrder (turn (rankedPoints (outlineRanked o)) x a b)
      order -> order
  where
    half c = numberOf o c < numberOf o x
{-# INLINE angleOrder #-}

-- | Where a polygon has its solid, seen on a way along its boundary. A wall has none.
data Solid = OnLeft | OnRight | Nowhere
  deriving (Eq)

-- | Where a polygon has its solid on the way around it in the file's order, if it does not meet itself. The turn at the
-- least corner, which is convex and not flat in a simple polygon; the solid of an enclosure lies outside.
solidFlank :: Outline -> Int -> Solid
solidFlank o p = outlineFlanks o V.! p
{-# INLINE solidFlank #-}

flankOf :: Outline -> Int -> Solid
flankOf o p
  | outlineForms o V.! p == Polyline = Nowhere
  | (turnThere == LeftTurn) == (outlineIds o V.! p /= Enclosure) = OnLeft
  | otherwise = OnRight
  where
    turnThere = turn (rankedPoints (outlineRanked o)) (around o (-1) least) least (around o 1 least)
    least = foldl' (\i j -> if numberOf o j < numberOf o i then j else i) (outlineFirst o U.! p) (cornersOf o p)

-- | The same on the way along a segment, from its first end to its second.
solidOf :: Outline -> Segment -> Solid
solidOf o side@(Segment a _) = case solidFlank o (ownerOf o a) of
  OnLeft | startOf o side /= a -> OnRight
  OnRight | startOf o side /= a -> OnLeft
  flank -> flank

-- | By polygon: the number of its side 0 among all sides; then the number of sides.
sideFirsts :: Outline -> U.Vector Int
sideFirsts o = U.fromList (scanl (+) 0 (map sides (polygonIndices o)))
  where
    sides p = case outlineForms o V.! p of
      Ring -> size p
      Polyline -> 2 * (size p - 1)
    size p = outlineFirst o U.! (p + 1) - outlineFirst o U.! p

-- | By 'sideFirsts', the number of the side that starts at a corner; of a thin wall, of the face on the right of the
-- way from there.
sideNumberOf :: Outline -> U.Vector Int -> Int -> Int
sideNumberOf o firsts i = firsts U.! p + i - outlineFirst o U.! p
  where
    p = ownerOf o i

-- | That of the face of a thin wall on the left of the way from a corner.
backSideNumberOf :: Outline -> U.Vector Int -> Int -> Int
backSideNumberOf o firsts i = firsts U.! (p + 1) - 1 - (i - outlineFirst o U.! p)
  where
    p = ownerOf o i

cornerNameOf :: Outline -> Int -> CornerName
cornerNameOf o i = CornerName (outlineIds o V.! p) (i - outlineFirst o U.! p)
  where
    p = ownerOf o i

-- | The side that starts at a corner; of a thin wall, the face on the right of the way from there.
sideNameOf :: Outline -> Int -> SideName
sideNameOf o i = let CornerName p k = cornerNameOf o i in SideName p k
