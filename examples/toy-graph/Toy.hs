-- | A visibility graph as one writes it first, and as it is right: what this example tests.
--
-- It knows convex polygons and thin walls that do not touch, each a list of corners with rational coordinates.
module Toy
  ( Corner
  , Pairs
  , firstTry
  , secondTry
  ) where

import Data.Set (Set)
import qualified Data.Set as Set

type Corner = (Rational, Rational)

-- | Pairs of corners that see each other, with nothing in between; the lesser corner comes first.
type Pairs = Set (Corner, Corner)

-- | Two corners see each other where no side crosses the segment between them.
--
-- This is wrong twice. A diagonal of a polygon crosses none of its sides; and a segment that passes through a corner
-- crosses neither of the sides that meet there.
firstTry :: [[Corner]] -> Pairs
firstTry polygons = pairsWhere (\p q -> not (any (crosses (p, q)) (concatMap sidesOf polygons))) polygons

-- | Two corners see each other where no side crosses the segment between them, no corner is on it, and its middle is
-- in no polygon.
secondTry :: [[Corner]] -> Pairs
secondTry polygons = pairsWhere sees polygons
  where
    sees p q =
      not (any (crosses (p, q)) (concatMap sidesOf polygons))
        && not (any (isBetween p q) (concat polygons))
        && not (any (isInside (middle p q)) polygons)

pairsWhere :: (Corner -> Corner -> Bool) -> [[Corner]] -> Pairs
pairsWhere sees polygons = Set.fromList [(p, q) | p <- corners, q <- corners, p < q, sees p q]
  where
    corners = concat polygons

sidesOf :: [Corner] -> [(Corner, Corner)]
sidesOf polygon = zip polygon (drop 1 polygon <> take 1 polygon)

-- | Positive where the way from p by q to r turns left, negative where it turns right, zero where it is straight.
turn :: Corner -> Corner -> Corner -> Rational
turn (px, py) (qx, qy) (rx, ry) = signum ((qx - px) * (ry - py) - (qy - py) * (rx - px))

-- | Whether each of two segments has its ends on both sides of the other.
crosses :: (Corner, Corner) -> (Corner, Corner) -> Bool
crosses (a, b) (p, q) = turn a b p * turn a b q < 0 && turn p q a * turn p q b < 0

-- | Whether the third point is on the segment between the others, and is none of them.
isBetween :: Corner -> Corner -> Corner -> Bool
isBetween p q r = turn p q r == 0 && min p q < r && r < max p q

-- | Whether a point is in the interior of a convex polygon; a wall has none.
isInside :: Corner -> [Corner] -> Bool
isInside point polygon = all (> 0) turns || all (< 0) turns
  where
    turns = [turn a b point | (a, b) <- sidesOf polygon]

middle :: Corner -> Corner -> Corner
middle (px, py) (qx, qy) = ((px + qx) / 2, (py + qy) / 2)
