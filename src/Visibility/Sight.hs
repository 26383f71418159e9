-- | What is seen from one point: sights, the visibility polygon that they make, and the form factors of an infinitely
-- small element there. Pure geometry: how the sights were found does not matter.
module Visibility.Sight
  ( -- * Viewpoints
    Viewpoint (..)
  , viewpointAt
    -- * Sights
  , Sight (..)
  , joined
    -- * The visibility polygon
  , Region (..)
  , region
  , Bend (..)
  , bends
  , rayMeets
    -- * Form factors of an element
  , elementFactors
    -- * Directions around a point
  , compareAround
  , compareFrom
  , sameDirection
  ) where

import Data.Function (on)
import Data.List (sortBy)
import qualified Data.Map.Strict as Map
import Data.Ratio ((%))
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Exact.RootSum (RootSum)
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Scene

-- | Where somebody stands.
data Viewpoint
  = -- | A corner of the file: all cones of free space in its place.
    AtCorner !CornerName !Point
  | -- | In the file's coordinates. It may be the place of a corner.
    AtPoint !Point
  deriving (Eq, Ord, Show)

-- | The place of a viewpoint, in the file's coordinates.
viewpointAt :: Viewpoint -> Point
viewpointAt (AtCorner _ point) = point
viewpointAt (AtPoint point) = point

-- | The rays from a point, counter-clockwise from one direction to another, that all end at one object.
--
-- /Shape/ all sights of a point are listed counter-clockwise, each beginning where the one before ends. Where that is
-- not so, in the middle or from the last to the first, the rays between lead into the solid: in one place, or in
-- several where polygons touch.
--
-- /Degenerate cases/ equal directions stand for a full turn, never for none.
data Sight = Sight
  { sightFrom :: !Direction
  -- ^ Of a ray: any vector other than (0, 0).
  , sightTo :: !Direction
  , sightObject :: !Object
  }
  deriving (Eq, Ord, Show)

-- | All sights of a point in one form: neighbours that end at one object are one sight, directions are primitive, the
-- list begins after a gap of solid rays if there is one, else with any sight: of those to choose from, with the one
-- that begins first, turning from (1, 0) on.
--
-- /Degenerate cases/ one object all around has the directions (1, 0) and (1, 0).
--
-- /Cost/ O(k log k) for k sights.
joined :: [Sight] -> [Sight]
joined sights = case (sortBy compareAround afterGaps, splitAround unlike plain) of
  (first : _, _) -> merged (startingWith ((== first) . sightFrom) plain)
  ([], Just fromChange) -> sortBy (compareAround `on` sightFrom) (merged fromChange)
  ([], Nothing) -> [Sight (Direction 1 0) (Direction 1 0) (sightObject s) | s <- take 1 plain]
  where
    afterGaps = [sightFrom b | (a, b) <- zip (lastFirst plain) plain, apart a b]
    plain = [Sight (primitive from) (primitive to) object | Sight from to object <- sights]
    apart a b = sightTo a /= sightFrom b
    unlike a b = sightObject a /= sightObject b
    merged = foldr attach []
    attach a (b : rest) | not (apart a b), not (unlike a b) = a {sightTo = sightTo b} : rest
    attach a rest = a : rest

-- | A cyclic list, begun at the first element that stands in a relation to the one before it.
splitAround :: (a -> a -> Bool) -> [a] -> Maybe [a]
splitAround related items = case break (uncurry related) (zip (lastFirst items) items) of
  (_, []) -> Nothing
  (early, late) -> Just (map snd (late <> early))

-- | A cyclic list, begun at the first element that is wanted.
startingWith :: (a -> Bool) -> [a] -> [a]
startingWith wanted items = let (early, late) = break wanted items in late <> early

-- | A cyclic list, begun one element earlier.
lastFirst :: [a] -> [a]
lastFirst items = drop (length items - 1) items <> items

-- | The part of the plane that is seen from a point, without what hangs on it as mere lines: the closure of its
-- interior.
data Region = Region
  { regionPoints :: ![Point]
  -- ^ The corners of its boundary, counter-clockwise, in the file's coordinates; none twice, none flat.
  , regionUnbounded :: ![(Direction, Direction)]
  -- ^ Where it reaches the sky: the rays from one direction counter-clockwise to another, primitive vectors. The
  -- boundary leads to infinity along the first and comes back along the second.
  }
  deriving (Eq, Ord, Show)

-- | A corner of the boundary of a region, or a way to infinity in one direction and back in another.
data Bend = Here !Point | Beyond !Direction !Direction
  deriving (Eq)

-- | The visibility polygon, from all sights of a point.
--
-- /Shape/ the list of points begins after the first unbounded part if there is one, the first when turning from (1, 0)
-- on; else with the least point.
--
-- /Degenerate cases/ where some rays from the point are solid, it is on the boundary; where they are in several parts,
-- as where polygons touch, it may be there several times. Where only sky is seen there is no point, and the one pair of
-- directions is (1, 0), (1, 0). Where the sky fills a half plane, the one point is where one stands, though it is flat.
--
-- /Cost/ O(k log k) for k sights.
--
-- /Laws/ the same for sights that are cut in two, and where a side is cut by a flat corner.
region :: Scene -> Point -> [Sight] -> Region
region scene eye sights = Region [p | Here p <- around] [(from, to) | Beyond from to <- around]
  where
    around = bends scene eye sights

-- | The boundary of the visibility polygon, counter-clockwise.
bends :: Scene -> Point -> [Sight] -> [Bend]
bends scene eye sights = begun (withoutFlat (withoutRepeats (concat (zipWith afterGap (lastFirst whole) whole))))
  where
    whole = joined sights
    afterGap before s = [Here eye | sightTo before /= sightFrom s] <> limits s
    limits (Sight from to object) = case object of
      Sky -> [Beyond from to]
      Side s -> [Here (rayMeets scene eye from s), Here (rayMeets scene eye to s)]
    withoutRepeats found = [m | (before, m) <- zip (lastFirst found) found, before /= m || null (drop 1 found)]
    withoutFlat found =
      [m | (a, m, b) <- zip3 (lastFirst found) found (drop 1 found <> take 1 found), not (isFlat a m b)]
    begun found = case ([from | Beyond from _ <- found], [p | Here p <- found]) of
      (from : others, _) -> startingWith (beginsAt (foldl earlier from others)) found
      ([], p : others) -> startingWith (== Here (foldl min p others)) found
      ([], []) -> []
    earlier a b = if compareAround b a == LT then b else a
    beginsAt from (Beyond a _) = a == from
    beginsAt _ (Here _) = False

-- | Is a bend a point where the boundary goes straight on?
isFlat :: Bend -> Bend -> Bend -> Bool
isFlat before bend after = case (before, bend, after) of
  (_, Beyond _ _, _) -> False
  (Beyond _ _, _, Beyond _ _) -> False
  (Here a, Here p, Here b) -> parallel (to a p) (to p b)
  (Beyond _ back, Here p, Here b) -> parallel (ray back) (to p b)
  (Here a, Here p, Beyond away _) -> parallel (to a p) (ray away)
  where
    to (Point ax ay) (Point bx by) = (bx - ax, by - ay)
    ray (Direction x y) = (fromInteger x, fromInteger y) :: (Rational, Rational)
    parallel (ax, ay) (bx, by) = ax * by == ay * bx

-- | Where a ray meets the line of a side.
--
-- /Requires/ that it is not parallel to it.
rayMeets :: Scene -> Point -> Direction -> SideId -> Point
rayMeets scene (Point x y) (Direction dx dy) side = Point (x + t * along) (y + t * up)
  where
    Point ax ay = cornerPoint scene (sideStart side)
    Point bx by = cornerPoint scene (sideEnd scene side)
    (ex, ey) = (bx - ax, by - ay)
    (along, up) = (fromInteger dx, fromInteger dy)
    t = ((ax - x) * ey - (ay - y) * ex) / (along * ey - up * ex)

-- | The form factors of an infinitely small element with a normal, from all sights of its place: of the light that it
-- gives off, uniform and diffuse, the part that reaches each object, the sky too. Exact sums of roots, by object, those
-- that are zero left out.
--
-- A sight between the angles a and b from the normal counts ½ (sin b − sin a). What lies behind the element is left
-- out.
--
-- /Requires/ a normal other than (0, 0). /Cost/ O(k log k) for k sights.
--
-- /Laws/ they add up to 1 where no ray in front of the element leads into the solid; never negative.
--
-- /Source/ Orti, Rivière, Durand, Puech, Using the visibility complex for radiosity computation, section 2.2.
elementFactors :: Scene -> Direction -> [Sight] -> [(Seen, RootSum)]
elementFactors scene normal sights =
  [ (object, total)
  | (object, added) <- Map.toAscList (RootSum.totalsBy weights)
  , let total = RootSum.merged added
  , not (null (RootSum.terms total))
  ]
  where
    weights = [(seenAs scene (sightObject s), weight s) | s <- sights]
    Direction nx ny = primitive normal
    rightmost = Direction ny (negate nx)
    weight (Sight from to _) = RootSum.scaled (1 % 2) (swept from to)
    -- Angles are taken from the rightmost direction on; what is behind the element counts as its leftmost direction.
    swept from to
      | wraps = (one - sineAt from) + (sineAtEnd to + one)
      | otherwise = sineAtEnd to - sineAt from
      where
        wraps = not (to `sameDirection` rightmost) && compareFrom rightmost from to /= LT
    one = RootSum.rational 1
    sineAtEnd d = if d `sameDirection` rightmost then one else sineAt d
    sineAt d
      | d `sameDirection` rightmost = negate one
      | ahead <= 0 = one
      | otherwise = RootSum.hypotenuse (aside % (ahead * ahead + aside * aside)) ahead aside
      where
        Direction dx dy = primitive d
        ahead = nx * dx + ny * dy
        aside = nx * dy - ny * dx

-- | Do two vectors point the same way?
sameDirection :: Direction -> Direction -> Bool
sameDirection a b = primitive a == primitive b

-- | The order of rays by angle, turning counter-clockwise from (1, 0) on for one full turn.
compareAround :: Direction -> Direction -> Ordering
compareAround = compareFrom (Direction 1 0)

-- | The order of rays by angle, turning counter-clockwise from a direction on for one full turn.
compareFrom :: Direction -> Direction -> Direction -> Ordering
compareFrom start@(Direction sx sy) a b = compare (half a) (half b) <> compareDirections a b
  where
    half d@(Direction x y) = case directionTurn start d of
      LeftTurn -> False
      RightTurn -> True
      Collinear -> sx * x + sy * y < 0
