{-# LANGUAGE BangPatterns #-}

-- | What a corner sees along a line, by shooting rays: written from the definition, without sweep or complex.
--
-- Whether a ray starts in the solid can be told from the two sides of its corner alone. If it does not, it ends at the
-- nearest side that it crosses. A tree of boxes around the sides tells which sides may be crossed, the near ones first.
-- All is decided in integers, in machine integers where the extent of the lattice allows it.
module Visibility.Ray
  ( -- * Rays
    Rays
  , raysIn
  , viewFrom
  , hiders
    -- * The solid at a corner
  , nextFlank
    -- * Directions
  , between
  ) where

import Data.Bits (shiftL, shiftR)
import Data.List (sort)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.IntegerRoot (bitLength)
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Scene.Boxes
import Visibility.Scene.Cone
import Visibility.View

-- | A scene made ready for many rays: the corners' coordinates times a common denominator, x and y of corner i at 2i
-- and 2i+1; and the boxes around the sides.
data Rays = Rays !Scene !Coordinates !BoxTree

-- | In machine integers where all are in [0, 2³⁰); else boxes have a unit, a power of two, given by its exponent.
data Coordinates = Small !(U.Vector Int) | Large !Int !(V.Vector Integer)

-- | /Cost/ O(n log n).
raysIn :: Scene -> Rays
raysIn scene = Rays scene table (boxTree (map (sideBox scene table) (corners scene)))
  where
    places = map (cornerAt scene) (corners scene)
    whole = foldr lcm 1 [w | LatticePoint _ _ w <- places]
    numbers = concat [[x * (whole `div` w), y * (whole `div` w)] | LatticePoint x y w <- places]
    unit = max 0 (bitLength (maximum (0 : numbers)) - 30)
    table
      | unit == 0 = Small (U.fromList (map fromInteger numbers))
      | otherwise = Large unit (V.fromList numbers)

-- | The box around a corner: the corner, or a square of one unit.
cornerBox :: Coordinates -> CornerId -> Box
cornerBox table (CornerId i) = Box (low (2 * i)) (high (2 * i)) (low (2 * i + 1)) (high (2 * i + 1))
  where
    (low, high) = case table of
      Small xs -> (U.unsafeIndex xs, U.unsafeIndex xs)
      Large unit xs ->
        (\k -> fromInteger (xs V.! k `shiftR` unit), \k -> fromInteger (negate (negate (xs V.! k) `shiftR` unit)))

-- | The box around the side that begins at a corner.
sideBox :: Scene -> Coordinates -> CornerId -> Box
sideBox scene table c = enclosingBox (map (cornerBox table) [c, nextCorner scene c])

-- | The view of a corner: what is seen from it against a direction and along it.
--
-- /Requires/ a direction in which, forward and backward, no other corner is seen. /Degenerate cases/ the line may pass
-- through corners that are hidden from this one.
--
-- /Cost/ for each ray O(log n) where the boxes of few sides lie about the way to what it meets, O(n) at worst; where
-- the direction is below 2³¹ too, in machine integers but for the comparison of the distances of sides that the line
-- does cross.
viewFrom :: Rays -> CornerId -> Direction -> View Object
viewFrom rays@(Rays scene table _) c d = case (sight (reversed d), sight d) of
  (Just behind, Just ahead) -> Tangent flank behind ahead
  (Just behind, Nothing) -> Ending Front behind
  (Nothing, Just ahead) -> Ending Back ahead
  (Nothing, Nothing) -> Buried flank
  where
    flank = nextFlank scene JustThen c d
    sight ray@(Direction dx dy)
      | entersSolid scene JustThen c ray = Nothing
      | otherwise = case table of
          Small xs
            | max (abs dx) (abs dy) < 2 ^ (31 :: Int) ->
                end (nearestSide machineProducts rays (U.unsafeIndex xs) id c (fromInteger dx) (fromInteger dy))
            | otherwise -> end (nearestSide exactProducts rays (toInteger . U.unsafeIndex xs) toInteger c dx dy)
          Large unit xs -> end (nearestSide exactProducts rays (V.unsafeIndex xs) (inUnits unit) c dx dy)
    end :: Nearest a -> Maybe Object
    end Nowhere = case surroundings scene of OpenSky -> Just Sky; Room -> Nothing
    end (At _ _ s _) = if s < 0 then Nothing else Just (Side (SideId s))
    machineProducts a b p q = compare (toInteger a * toInteger b) (toInteger p * toInteger q)
    exactProducts a b p q = compare (a * b) (p * q)

-- | A coordinate of a box.
inUnits :: Int -> Int -> Integer
inUnits unit k = toInteger k `shiftL` unit

-- | The nearest side so far: its distance as a fraction, the side, or −1 if it is crossed from the solid, and a box
-- around the way to it.
data Nearest a = Nowhere | At !a !a !Int !Box

-- | The nearest side that a ray from a corner crosses. A side that the ray only touches at a corner is not crossed.
--
-- Asked are the sides whose boxes meet the line and the box around the way to the nearest side so far.
--
-- /Requires/ products of a direction and a coordinate below 2⁶¹ where the numbers are machine integers.
nearestSide
  :: (Num a, Ord a)
  => (a -> a -> a -> a -> Ordering)
  -> Rays
  -> (Int -> a)
  -> (Int -> a)
  -> CornerId
  -> a
  -> a
  -> Nearest a
nearestSide products (Rays scene table tree) coordinate scaled c@(CornerId i) dx dy =
  foldNearer isNearer mayCross nearer Nowhere tree
  where
    !cx = coordinate (2 * i)
    !cy = coordinate (2 * i + 1)
    !own@(Box left right bottom top) = cornerBox table c
    !ahead =
      Box
        (if dx < 0 then minBound else left)
        (if dx > 0 then maxBound else right)
        (if dy < 0 then minBound else bottom)
        (if dy > 0 then maxBound else top)
    isNearer a b = entry a <= entry b
    entry (Box l r b t) = (if dx < 0 then negate r else l) + (if dy < 0 then negate t else b)
    mayCross found box = boxesOverlap (case found of Nowhere -> ahead; At _ _ _ way' -> way') box && crossesBox box
    crossesBox = lineMeetsBox scaled cx cy dx dy
    nearer old s
      | fromAbove == fromBelow || within <= 0 = old
      | otherwise = case old of
          Nowhere -> met
          At p q _ _ -> case products within q p across of
            LT -> met
            EQ | code >= 0 -> met
            _ -> old
      where
        !(CornerId t) = nextCorner scene (CornerId s)
        !ax = coordinate (2 * s)
        !ay = coordinate (2 * s + 1)
        !bx = coordinate (2 * t)
        !by = coordinate (2 * t + 1)
        -- Positive where the ends of the side lie to the left of the line.
        !a = dx * (ay - cy) - dy * (ax - cx)
        !b = dx * (by - cy) - dy * (bx - cx)
        fromAbove = a > 0 && b < 0
        fromBelow = a < 0 && b > 0
        -- The ray meets the side at within / across times the direction, if that is positive.
        !leftOfSide = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        !within = if fromBelow then leftOfSide else negate leftOfSide
        !across = abs (b - a)
        -- The solid is to the left of a side. The direction leads there where it goes to the left of the side.
        code = if fromAbove then s else -1
        met = At within across code (enclosingBox [own, sideBox scene table (CornerId s)])
{-# INLINE nearestSide #-}

-- | Does a line, by a point and a direction, meet a box in units of the boxes?
lineMeetsBox :: (Num a, Ord a) => (Int -> a) -> a -> a -> a -> a -> Box -> Bool
lineMeetsBox scaled x y dx dy (Box l r b t)
  | dy > 0 = between' l r
  | otherwise = between' r l
  where
    -- From the end that lies farthest to the left of the line to the one farthest to the right.
    between' atLeft atRight
      | dx > 0 = leftward t atLeft >= 0 && leftward b atRight <= 0
      | otherwise = leftward b atLeft >= 0 && leftward t atRight <= 0
    leftward v u = dx * (scaled v - y) - dy * (scaled u - x)
{-# INLINE lineMeetsBox #-}

-- | The corners that lie on the open segment between two corners, and those that begin a side which crosses it.
--
-- /Cost/ as that of a ray in 'viewFrom'.
hiders :: Rays -> CornerId -> CornerId -> [CornerId]
hiders rays@(Rays _ table _) p q = map CornerId $ case table of
  Small xs -> hidersBetween rays (U.unsafeIndex xs) id p q
  Large unit xs -> hidersBetween rays (V.unsafeIndex xs) (inUnits unit) p q

-- | /Requires/ two products of coordinates, added up, below 2⁶¹ where the numbers are machine integers.
hidersBetween :: (Num a, Ord a) => Rays -> (Int -> a) -> (Int -> a) -> CornerId -> CornerId -> [Int]
hidersBetween (Rays scene table tree) coordinate scaled c@(CornerId p) d@(CornerId q) =
  sort (foldBoxes mayHide (\found s -> if hides s then s : found else found) [] tree)
  where
    !px = coordinate (2 * p)
    !py = coordinate (2 * p + 1)
    !qx = coordinate (2 * q)
    !qy = coordinate (2 * q + 1)
    !dx = qx - px
    !dy = qy - py
    !way' = enclosingBox (map (cornerBox table) [c, d])
    mayHide box = boxesOverlap way' box && lineMeetsBox scaled px py dx dy box
    hides !s
      | a == 0 = s /= p && s /= q && ahead > 0 && ahead < dx * dx + dy * dy
      | a > 0 = b < 0 && apart
      | otherwise = b > 0 && apart
      where
        !(CornerId t) = nextCorner scene (CornerId s)
        !ax = coordinate (2 * s)
        !ay = coordinate (2 * s + 1)
        !bx = coordinate (2 * t)
        !by = coordinate (2 * t + 1)
        -- Positive where the ends of the side lie to the left of the line.
        !a = dx * (ay - py) - dy * (ax - px)
        !b = dx * (by - py) - dy * (bx - px)
        ahead = dx * (ax - px) + dy * (ay - py)
        sideOf x y = (bx - ax) * (y - ay) - (by - ay) * (x - ax)
        apart = signum (sideOf px py) * signum (sideOf qx qy) < 0
{-# INLINE hidersBetween #-}

-- | The flank of the line through a corner on which the following corner of its polygon lies.
--
-- /Degenerate cases/ 'JustThen', the side to it must not lie in the line.
nextFlank :: Scene -> Moment -> CornerId -> Direction -> Flank
nextFlank scene moment c ray = case directionTurn ray to of
  LeftTurn -> Above
  RightTurn -> Below
  Collinear -> if sameWay ray to == (moment == JustBefore) then Above else Below
  where
    to = heading scene c (nextCorner scene c)

-- | A direction strictly between two others, reached from the first by turning left, before the second.
--
-- /Requires/ that the second is reached from the first by turning left by at most 180°.
between :: Direction -> Direction -> Direction
between (Direction ax ay) (Direction bx by)
  | ax * by == ay * bx = Direction (negate ay) ax
  | otherwise = Direction (ax + bx) (ay + by)

