-- | The boundary of a visibility region, exact; and as places of a figure, where what is unbounded ends at the margin.
module Visibility.Draw.Outline
  ( inFront
  , outlinePlaces
  , sightLimits
  , limitLine
  ) where

import Data.Function (on)
import Data.List (sortBy)
import Visibility.Draw.Drawing
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

-- | The corners of a region seen from a place on the canvas, cut off at the border of a box.
--
-- /Requires/ the place and all corners of the region inside the box.
outlinePlaces :: Box -> (Point -> Place) -> Place -> [Bend] -> [Place]
outlinePlaces box place here = concatMap bendPlaces . beginningHere
  where
    bendPlaces (Here x) = [place x]
    bendPlaces (Beyond from to) = boxArc box here from to

-- | The lines of sight that bound a region seen from a point, each between two bends that follow each other.
sightLimits :: Point -> [Bend] -> [(Bend, Bend)]
sightLimits (Point qx qy) seen = filter isLimit (zip around (drop 1 around <> take 1 around))
  where
    around = beginningHere seen
    isLimit (Here (Point ax ay), Here (Point bx by)) = (ax - qx) * (by - qy) == (ay - qy) * (bx - qx)
    isLimit (Beyond _ _, Beyond _ _) = False
    isLimit _ = True

-- | A line of sight on the canvas, cut off at the border of a box, for a region seen from a place; nothing where it has
-- no length.
limitLine :: Box -> (Point -> Place) -> Place -> (Bend, Bend) -> Maybe (Place, Place)
limitLine box place here (a, b) = if from == to then Nothing else Just (from, to)
  where
    from = case a of Here x -> place x; Beyond _ back -> exit box here back
    to = case b of Here x -> place x; Beyond away _ -> exit box here away

-- | The way to infinity that a region's boundary may begin with comes last.
beginningHere :: [Bend] -> [Bend]
beginningHere seen = case seen of
  first@(Beyond _ _) : others -> others <> [first]
  _ -> seen

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
