{-# LANGUAGE BangPatterns #-}

-- | What a corner sees along a line, by shooting rays: written from the definition, without sweep or complex.
--
-- Whether a ray starts in the solid can be told from the two sides of its corner alone. If it does not, it ends at the
-- nearest side that it crosses. All is decided in integers, in machine integers where the extent of the lattice allows
-- it.
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

import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.Point
import Visibility.Exact.Predicate (Direction (..), directionTurn, reversed)
import Visibility.Scene
import Visibility.Scene.Cone
import Visibility.View

-- | A scene made ready for many rays: the corners' coordinates times a common denominator, x and y of corner i at 2i
-- and 2i+1.
data Rays = Rays !Scene !Coordinates

-- | In machine integers where all are in [0, 2³⁰).
data Coordinates = Small !(U.Vector Int) | Large !(V.Vector Integer)

-- | /Cost/ O(n).
raysIn :: Scene -> Rays
raysIn scene
  | all (< 2 ^ (30 :: Int)) numbers = Rays scene (Small (U.fromList (map fromInteger numbers)))
  | otherwise = Rays scene (Large (V.fromList numbers))
  where
    places = map (cornerAt scene) (corners scene)
    whole = foldr lcm 1 [w | LatticePoint _ _ w <- places]
    numbers = concat [[x * (whole `div` w), y * (whole `div` w)] | LatticePoint x y w <- places]

-- | The view of a corner: what is seen from it against a direction and along it.
--
-- /Requires/ a direction in which, forward and backward, no other corner is seen. /Degenerate cases/ the line may pass
-- through corners that are hidden from this one.
--
-- /Cost/ O(n), one pass for both rays; where the direction is below 2³¹ too, in machine integers but for the
-- comparison of the distances of sides that the line does cross.
viewFrom :: Rays -> CornerId -> Direction -> View Object
viewFrom (Rays scene table) c@(CornerId i) d@(Direction dx dy) = case (sight (reversed d) back, sight d front) of
  (Just behind, Just ahead) -> Tangent flank behind ahead
  (Just behind, Nothing) -> Ending Front behind
  (Nothing, Just ahead) -> Ending Back ahead
  (Nothing, Nothing) -> Buried flank
  where
    flank = nextFlank scene JustThen c d
    (back, front) = case table of
      Small xs
        | max (abs dx) (abs dy) < 2 ^ (31 :: Int) ->
            nearestSides machineProducts scene (U.unsafeIndex xs) i (fromInteger dx) (fromInteger dy)
        | otherwise -> nearestSides exactProducts scene (toInteger . U.unsafeIndex xs) i dx dy
      Large xs -> nearestSides exactProducts scene (V.unsafeIndex xs) i dx dy
    machineProducts a b p q = compare (toInteger a * toInteger b) (toInteger p * toInteger q)
    exactProducts a b p q = compare (a * b) (p * q)
    sight ray met
      | entersSolid scene JustThen c ray = Nothing
      | otherwise = case met of
          Nothing -> case surroundings scene of OpenSky -> Just Sky; Room -> Nothing
          Just s -> Side <$> s

-- | The nearest side so far: its distance as a fraction, and the side, or −1 if it is crossed from the solid.
data Nearest a = Nowhere | At !a !a !Int

-- | The nearest sides that the line through a corner crosses, backward and forward; 'Nothing' inside where such a
-- side is crossed from the solid. A side that the line only touches at a corner is not crossed.
--
-- /Requires/ products of a direction and a coordinate below 2⁶¹ where the numbers are machine integers.
nearestSides
  :: (Num a, Ord a)
  => (a -> a -> a -> a -> Ordering)
  -> Scene
  -> (Int -> a)
  -> Int
  -> a
  -> a
  -> (Maybe (Maybe SideId), Maybe (Maybe SideId))
nearestSides products scene coordinate i dx dy = go 0 Nowhere Nowhere
  where
    n = cornerCount scene
    !cx = coordinate (2 * i)
    !cy = coordinate (2 * i + 1)
    go !s !back !front
      | s == n = (found back, found front)
      | otherwise = side s back front
    side !s !back !front
      | fromAbove == fromBelow = go (s + 1) back front
      | ahead > 0 = go (s + 1) back (nearer front)
      | otherwise = go (s + 1) (nearer back) front
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
        -- Positive where the corner lies to the left of the side.
        within = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        across = b - a
        -- The line meets the side at within / across times the direction.
        ahead = if fromBelow then within else negate within
        -- The solid is to the left of a side. The direction leads there where it goes to the left of the side.
        code = if fromAbove == (ahead > 0) then s else -1
        nearer Nowhere = At (abs within) (abs across) code
        nearer old@(At p q _) = case products (abs within) q p (abs across) of
          LT -> At (abs within) (abs across) code
          EQ | code >= 0 -> At (abs within) (abs across) code
          _ -> old
    found Nowhere = Nothing
    found (At _ _ s) = Just (if s < 0 then Nothing else Just (SideId s))
{-# INLINE nearestSides #-}

-- | The corners that lie on the open segment between two corners, and those that begin a side which crosses it.
--
-- /Cost/ O(n), in machine integers as 'viewFrom'.
hiders :: Rays -> CornerId -> CornerId -> [CornerId]
hiders (Rays scene table) (CornerId p) (CornerId q) = map CornerId $ case table of
  Small xs -> hidersBetween scene (U.unsafeIndex xs) p q
  Large xs -> hidersBetween scene (V.unsafeIndex xs) p q

-- | /Requires/ two products of coordinates, added up, below 2⁶¹ where the numbers are machine integers.
hidersBetween :: (Num a, Ord a) => Scene -> (Int -> a) -> Int -> Int -> [Int]
hidersBetween scene coordinate p q = go 0
  where
    n = cornerCount scene
    !px = coordinate (2 * p)
    !py = coordinate (2 * p + 1)
    !qx = coordinate (2 * q)
    !qy = coordinate (2 * q + 1)
    !dx = qx - px
    !dy = qy - py
    go !s
      | s == n = []
      | hides s = s : go (s + 1)
      | otherwise = go (s + 1)
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

