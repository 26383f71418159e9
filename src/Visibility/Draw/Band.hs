-- | Bands along sides, on the face that is seen: as wide as free space beside the side lets them be.
module Visibility.Draw.Band
  ( Strip
  , stripLong
  , stripsOf
  , stripOutline
  , stripPart
  , stripRays
  , stripPlace
  , outwardPlace
    -- * What is near
  , nearTo
  ) where

import Data.List (sort)
import qualified Data.Map.Strict as Map
import qualified Data.Vector as V
import Visibility.Draw.Drawing
import Visibility.Draw.Scenery (freeCone, heading, raySteps)
import Visibility.Exact.Predicate (Turn (..), turn)
import Visibility.Scene
import Visibility.Scene.Boxes (boxTree, boxesOverlap, foldBoxes)
import qualified Visibility.Scene.Boxes as Boxes

-- | Where a band lies along a side: the side's start, the unit vectors along it and out into free space, its length,
-- the width of the band, and how the ends are cut. All in pixels.
data Strip = Strip
  { stripStart :: !Place
  , stripAlong :: !(Double, Double)
  , stripLong :: !Double
  , stripWide :: !Double
  , startCut :: !Cut
  , endCut :: !Cut
  }

-- | How a strip ends.
data Cut
  = -- | At a right angle.
    Square
  | -- | Along the bisector of less than 180° of free space, by its slope over the side.
    Inwards !Double
  | -- | Along the bisector of more, by how far it leads beyond the side for each pixel outwards.
    Beyond !Double

-- | The slopes of ends that take room away.
slopesInwards :: Strip -> [Double]
slopesInwards strip = [slope | Inwards slope <- [startCut strip, endCut strip]]

-- | The strips of all sides, of at most a width.
--
-- Where free space is less than 180° wide at an end, it is cut along the bisector, so that the bands of both sides
-- meet. So it is where free space is at most 270° wide, and a little more, if nothing else is near the corner: round
-- objects have no gaps.
-- Where something is in front of the side, the strip takes at most half of the way there.
--
-- /Degenerate cases/ what touches the side's ends is not in front of it: the bisector lies between. A side that is too
-- short to be seen still has its exact direction, and so has its strip.
--
-- /Requires/ a width of more than 0. /Cost/ O(n log n), times the number of sides that are nearer to one than twice the
-- width. /Laws/ a strip does not cross into the solid; only what is so near makes a difference.
stripsOf :: Scene -> (CornerId -> Place) -> Double -> Map.Map SideId Strip
stripsOf scene placeOf most = Map.fromList [(side, strip side) | side <- sides scene]
  where
    places = V.fromList (map placeOf (corners scene))
    place (CornerId c) = places V.! c
    ends side = (place (sideStart side), place (sideEnd scene side))
    nearby = V.fromList (map (map SideId . nearTo (2 * most) (map ends (sides scene)) . ends) (sides scene))
    near (SideId s) = nearby V.! s
    rooms = V.fromList [roomBeside scene place most side (near side) | side <- sides scene]
    roomOf (SideId s) = rooms V.! s
    strip side = Strip (place start) along long (roomOf side) (cutAt start (previousCorner scene start)) (cutAt end end)
      where
        (start, end) = (sideStart side, sideEnd scene side)
        (along, long) = heading scene place start end
        -- By the corner that the neighbour starts at. Where its band is of another width, going on would leave a spike.
        cutAt corner (CornerId neighbour)
          | isWallEnd scene corner = Square
          | angle < pi = Inwards (tan (angle / 2))
          | angle > pi
          , angle < 1.6 * pi
          , roomOf (SideId neighbour) == roomOf side
          , all (farFrom corner) (near side) =
            Beyond (tan ((angle - pi) / 2))
          | otherwise = Square
          where
            (_, angle) = freeCone scene place corner
    farFrom corner@(CornerId c) other =
      any (samePlace scene corner) [p, q]
        || turn (scenePoints scene) p' q' c == LeftTurn
        || uncurry (distance (place corner)) (ends other) > 2 * most
      where
        (p@(CornerId p'), q@(CornerId q')) = (sideStart other, sideEnd scene other)

-- | The width of a side's strip: at most the greatest, and half of the way to what is in front of it, of some sides.
roomBeside :: Scene -> (CornerId -> Place) -> Double -> SideId -> [SideId] -> Double
roomBeside scene place most side near = minimum (most : map (/ 2) (concatMap inFront near))
  where
    (start@(CornerId a), end@(CornerId b)) = (sideStart side, sideEnd scene side)
    Place x0 y0 = place start
    ((ux, uy), long) = heading scene place start end

    -- How far in front of the side another one is, where it is. What is behind is decided exactly: the other face of
    -- a wall is in the same place. What rounding puts a little behind or beside may be in front.
    inFront other
      | other == side || any touches ends || not (any isRight ends) = []
      | otherwise = [max 0 (min h h') | (h, h') <- beside (local (place p)) (local (place q)), max h h' > -slight]
      where
        (p, q) = (sideStart other, sideEnd scene other)
        ends = [p, q]
    touches corner = samePlace scene corner start || samePlace scene corner end
    isRight (CornerId c) = turn (scenePoints scene) a b c == RightTurn
    local (Place x y) = ((x - x0) * ux + (y - y0) * uy, (x - x0) * uy - (y - y0) * ux)
    -- The heights at the ends of the part of a segment that is beside the side.
    beside (s, h) (s', h')
      | max s s' < -slight || min s s' > long + slight = []
      | s == s' = [(h, h')]
      | otherwise = [(at (kept s), at (kept s'))]
      where
        kept = max 0 . min long
        at t = h + (h' - h) * max 0 (min 1 ((t - s) / (s' - s)))
    slight = 1e-9

-- | How far a place is from a segment.
distance :: Place -> Place -> Place -> Double
distance (Place x y) (Place px py) (Place qx qy) = sqrt (squared (x - px - t * dx) (y - py - t * dy))
  where
    (dx, dy) = (qx - px, qy - py)
    squared u v = u * u + v * v
    t
      | squared dx dy > 0 = max 0 (min 1 (((x - px) * dx + (y - py) * dy) / squared dx dy))
      | otherwise = 0

-- | A place by the distance along the side and that out into free space.
outwardPlace :: Strip -> Double -> Double -> Place
outwardPlace strip s out = Place (x + s * ux + out * uy) (y + s * uy - out * ux)
  where
    Place x y = stripStart strip
    (ux, uy) = stripAlong strip

-- | The place just beyond the strip by a position on the side, 0 at its start and 1 at its end.
stripPlace :: Strip -> Double -> Place
stripPlace strip s = outwardPlace strip (s * stripLong strip) (stripWide strip + 1)

-- | The whole strip as a region.
stripOutline :: Strip -> [Place]
stripOutline strip = stripPart strip 0 1

-- | The part of a strip between two positions on the side, 0 at its start and 1 at its end.
stripPart :: Strip -> Double -> Double -> [Place]
stripPart strip from to = map (uncurry (outwardPlace strip)) (cutEnd (cutStart whole))
  where
    long = stripLong strip
    (s, s') = (from * long, to * long)
    wide = stripWide strip
    whole = [(s, 0), (s', 0), (s' + afterwards, wide), (s - before, wide)]
    afterwards = beyond (from < 1 && to >= 1) (endCut strip)
    before = beyond (from <= 0 && to > 0) (startCut strip)
    beyond isLast cut = case cut of
      Beyond reach | isLast -> reach * wide
      _ -> 0
    cutStart = inwards (startCut strip) id
    cutEnd = inwards (endCut strip) (long -)
    inwards cut along = case cut of
      Inwards slope -> keptWhere (\(t, h) -> slope * along t - h)
      _ -> id

-- | The part of a convex region where a linear function is not negative.
keptWhere :: ((Double, Double) -> Double) -> [(Double, Double)] -> [(Double, Double)]
keptWhere f corners' = concat (zipWith piece corners' (drop 1 corners' <> take 1 corners'))
  where
    piece p q
      | f p >= 0 && f q >= 0 = [p]
      | f p >= 0 = [p, crossing p q]
      | f q >= 0 = [crossing p q]
      | otherwise = []
    crossing p@(x, y) q@(x', y') = let t = f p / (f p - f q) in (x + t * (x' - x), y + t * (y' - y))

-- | Short rays for a side that gives light, beyond its band of at most a width; where there is no room beyond, upon it.
--
-- /Laws/ at least one; they do not cross into the solid.
stripRays :: Double -> Strip -> [[Place]]
stripRays most strip
  | stripWide strip < most || null free = [ray middle (0.2 * room) (0.9 * room)]
  | otherwise = [ray s (stripWide strip + 1.5) far | s <- free]
  where
    ray s near end = [outwardPlace strip s near, outwardPlace strip s end]
    -- What is in front is at least twice the width away.
    far = 1.75 * stripWide strip
    (long, middle) = (stripLong strip, stripLong strip / 2)
    room = minimum (stripWide strip : map (* middle) (slopesInwards strip))
    (count, steps) = raySteps long
    free =
      [ s
      | k <- steps
      , let s = long * k / count
      , and [slope * s > far | Inwards slope <- [startCut strip]]
      , and [slope * (long - s) > far | Inwards slope <- [endCut strip]]
      ]

-- | The numbers, from 0, of at least all segments that come nearer to a segment than a reach in pixels, ascending.
--
-- /Cost/ O(n log n) once for n segments; then that of those whose boxes are as near. /Laws/ none that
-- is nearer is missing.
nearTo :: Double -> [(Place, Place)] -> (Place, Place) -> [Int]
nearTo reach segments = \segment -> sort (foldBoxes (boxesOverlap (around reach segment)) (flip (:)) [] tree)
  where
    tree = boxTree (map (around 0) segments)
    around margin (Place x y, Place x' y') = Boxes.Box (low x x') (high x x') (low y y') (high y y')
      where
        low a b = floor (min a b - margin)
        high a b = ceiling (max a b + margin)
