-- | The boundary of a visibility region, exact; and as places of a figure, where what is unbounded ends at the margin.
module Visibility.Draw.Outline
  ( inFront
  , Piece (..)
  , boundary
  , isLimit
  , outlinePlaces
  , limitLines
  ) where

import Data.Function (on)
import Data.List (sortBy)
import Visibility.Draw.Drawing hiding (Region)
import Visibility.Draw.Scale (directionAngle)
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Sight

-- | The part of the sights, counter-clockwise, that lies in front of an element with a normal: less than 90° from it.
--
-- /Shape/ a sight may be cut in two. The lists begin with what is farthest to the right; there is another one wherever
-- the rays between lead into the solid.
inFront :: Direction -> [Sight] -> [[Sight]]
inFront (Direction nx ny) =
  foldr connect [] . sortBy rightFirst . filter ahead . concatMap (cutAt leftmost) . concatMap (cutAt rightmost)
  where
    connect a ((b : more) : others) | sameDirection (sightTo a) (sightFrom b) = (a : b : more) : others
    connect a others = [a] : others
    rightmost = Direction ny (negate nx)
    leftmost = Direction (negate ny) nx
    ahead (Sight from _ _) = sameDirection from rightmost || directionTurn rightmost from == LeftTurn
    rightFirst = compareFrom rightmost `on` sightFrom

-- | A sight cut where it contains a direction inside.
cutAt :: Direction -> Sight -> [Sight]
cutAt d sight@(Sight from to object)
  | not (sameDirection from d) && (sameDirection from to || compareFrom from d to == LT) =
    [Sight from d object, Sight d to object]
  | otherwise = [sight]

-- | A piece of the boundary of the region that is seen from a point.
data Piece
  = -- | Of a side.
    OnSide !Point !Point
  | -- | Of a line of sight.
    OnSight !Point !Point
  | -- | From a point to infinity in the first direction, back in the second to another point: the sky is between.
    Beyond !Point !Direction !Direction !Point
  deriving (Eq, Show)

-- | The boundary of a region seen from a point, counter-clockwise.
--
-- /Degenerate cases/ a region without corners, as the whole plane or a half plane: its pieces begin and end at the
-- viewpoint.
--
-- /Laws/ one 'Beyond' for each unbounded interval.
boundary :: Point -> Region -> [Piece]
boundary q (Region points unbounded) = case points of
  [] -> [Beyond q from to q | (from, to) <- unbounded]
  _ -> pieces neighbours (drop 1 unbounded <> take 1 unbounded)
  where
    -- Both are in order, and the points begin after the first unbounded interval.
    pieces ((x, y) : others) (opening@(from, to) : openings)
      | joins (closeness opening) opening (x, y) = Beyond x from to y : pieces others openings
    pieces ((x, y) : others) openings
      | cross (between q x) (between q y) == 0 = OnSight x y : pieces others openings
      | otherwise = OnSide x y : pieces others openings
    pieces [] _ = []
    neighbours = zip points (drop 1 points <> take 1 points)
    -- Next to a viewpoint that is no corner, since the region ends there in a straight line, it is a line that counts.
    closeness opening = if any (joins along opening) neighbours then along else through
    joins lies (from, to) (x, y) = lies q from x && lies q to y

-- | Is a point on the ray, or on the line, from the viewpoint?
along, through :: Point -> Direction -> Point -> Bool
along q d x = through q d x && dot (vector d) (between q x) >= 0
through q d x = cross (vector d) (between q x) == 0

between :: Point -> Point -> (Rational, Rational)
between (Point ax ay) (Point bx by) = (bx - ax, by - ay)

vector :: Direction -> (Rational, Rational)
vector (Direction x y) = (fromInteger x, fromInteger y)

cross, dot :: (Rational, Rational) -> (Rational, Rational) -> Rational
cross (ax, ay) (bx, by) = ax * by - ay * bx
dot (ax, ay) (bx, by) = ax * bx + ay * by

-- | The corners of a region on the canvas, cut off at the border of a box.
--
-- /Requires/ the viewpoint and all corners of the region inside the box.
outlinePlaces :: Box -> (Point -> Place) -> Point -> [Piece] -> [Place]
outlinePlaces box place q = concatMap piecePlaces
  where
    here = place q
    piecePlaces (OnSide x _) = [place x]
    piecePlaces (OnSight x _) = [place x]
    piecePlaces (Beyond x from to _)
      | sameDirection from to = boxArc box here from to
      | otherwise = place x : boxArc box here from to

-- | The lines of sight that bound a region, cut off at the border of a box; not those that have no length.
limitLines :: Box -> (Point -> Place) -> Point -> [Piece] -> [(Place, Place)]
limitLines box place q = filter (uncurry (/=)) . concatMap lines'
  where
    here = place q
    lines' (OnSide _ _) = []
    lines' (OnSight x y) = [(place x, place y)]
    lines' (Beyond x from to y)
      | sameDirection from to = []
      | otherwise = [(place x, exit box here from), (exit box here to, place y)]

-- | Does a piece of the boundary lie on lines of sight?
isLimit :: Piece -> Bool
isLimit piece = case piece of
  OnSide _ _ -> False
  OnSight _ _ -> True
  Beyond _ from to _ -> not (sameDirection from to)

-- | The border of a box from where one ray of a place leaves it, counter-clockwise to where another does.
boxArc :: Box -> Place -> Direction -> Direction -> [Place]
boxArc box@(Box l b r t) here@(Place x y) from to
  | directionTurn from to == LeftTurn = exit box here from : sortBy firstLeft inBetween <> [exit box here to]
  | otherwise = boxArc box here from quarter <> drop 1 (boxArc box here quarter to)
  where
    -- After at most three quarters the rest is less than a half turn.
    quarter = let Direction dx dy = from in Direction (negate dy) dx
    inBetween =
      [ corner
      | corner <- [Place r t, Place l t, Place l b, Place r b]
      , left (unit from) (seen corner)
      , left (seen corner) (unit to)
      ]
    firstLeft a c = if left (seen a) (seen c) then LT else GT
    seen (Place cx cy) = (cx - x, cy - y)
    left (ax, ay) (cx, cy) = ax * cy - ay * cx > 0

-- | Where a ray from a place inside a box leaves it.
exit :: Box -> Place -> Direction -> Place
exit (Box l b r t) (Place x y) d = Place (clamped l r (x + s * dx)) (clamped b t (y + s * dy))
  where
    (dx, dy) = unit d
    s = minimum (across x l r dx <> across y b t dy)
    across v low high dv
      | dv > 0 = [(high - v) / dv]
      | dv < 0 = [(low - v) / dv]
      | otherwise = []
    clamped low high = max low . min high

unit :: Direction -> (Double, Double)
unit d = (cos angle, sin angle)
  where
    angle = directionAngle d
