-- | The meaning of every error of a scene, stated pair by pair on rationals. Shares nothing with what it checks.
module Visibility.Scene.Oracle
  ( naiveErrors
  ) where

import Data.List (elemIndex, sort)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Visibility.Error
import Visibility.Exact.Point (Point (..))
import Visibility.Scene.Id
import Visibility.Scene.Raw
import Visibility.Scene.Sample

-- | All errors, in time O(n²) besides overlaps, which take O(n³).
naiveErrors :: RawScene -> Set.Set SceneError
naiveErrors raw =
  Set.fromList $
    empty <> concatMap statement everything <> inThemselves <> crossings <> concatMap position pairs <> overlaps
  where
    everything = polygonsOf raw
    empty = [EmptyScene | null everything]
    bodies =
      [ Body p form (rawCorners q)
      | (p, q) <- everything
      , let form = formOf (p, q)
      , length (rawCorners q) >= (if form == Ring then 3 else 2)
      ]
    pairs = [(a, b) | a <- bodies, b <- bodies, bodyId a < bodyId b]
    inThemselves = concatMap own bodies
    crossings = concatMap (uncurry crossingsOf) pairs
    overlaps
      | null inThemselves = concatMap alongItself bodies <> concatMap (uncurry overlap) pairs
      | otherwise = []

-- | A polygon that has corners enough.
data Body = Body
  { bodyId :: PolygonId
  , bodyForm :: Form
  , bodyCorners :: [Point]
  }

-- An enclosure is a ring whatever it says, two corners make a wall.
formOf :: (PolygonId, RawPolygon) -> Form
formOf (p, polygon)
  | p == Enclosure = Ring
  | length (rawCorners polygon) == 2 = Polyline
  | otherwise = rawForm polygon

statement :: (PolygonId, RawPolygon) -> [SceneError]
statement (p, polygon@(RawPolygon _ _ corners material sides)) =
  [TooFewCorners p n | n < (if form == Ring then 3 else 2)]
    <> [NoSuchSide (SideName p k) total | k <- Map.keys sides, k `notElem` [0 .. total - 1]]
    <> [BadEmission place x | (place, Just x, _) <- statements, x < 0]
    <> [BadReflectivity place x | (place, _, Just x) <- statements, x < 0 || x >= 1]
  where
    n = length corners
    form = formOf (p, polygon)
    -- A wall has two faces between each two of its corners.
    total = if form == Ring then n else length (concat [[(), ()] | _ <- drop 1 corners])
    statements =
      (OfPolygon p, Just (emission material), Just (reflectivity material))
        : [(OfSide (SideName p k), e, r) | (k, MaterialOverride e r) <- Map.toList sides]

-- The sign of this is the turn.
cross :: Point -> Point -> Point -> Rational
cross (Point ax ay) (Point bx by) (Point cx cy) = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)

dot :: Point -> Point -> Point -> Rational
dot (Point ox oy) (Point ax ay) (Point bx by) = (ax - ox) * (bx - ox) + (ay - oy) * (by - oy)

-- Strictly between the ends.
liesOn :: Point -> (Point, Point) -> Bool
liesOn c (a, b) = cross a b c == 0 && dot c a b < 0

crosses :: (Point, Point) -> (Point, Point) -> Bool
crosses (a, b) (c, d) = cross a b c * cross a b d < 0 && cross c d a * cross c d b < 0

-- The segments of a polygon with the names of their sides; of a wall, one for both faces.
segmentsOf :: Body -> [(SideName, (Point, Point))]
segmentsOf (Body p form corners) =
  zip (map (SideName p) [0 ..]) (zip corners (drop 1 corners <> (if form == Ring then take 1 corners else [])))

-- What is wrong with a polygon by itself, but for a wall that runs along itself.
own :: Body -> [SceneError]
own body@(Body p form corners) = repeats <> (if isFlat then [ZeroArea p] else spikes <> touches <> crossings)
  where
    n = length corners
    indexed = zip [0 ..] corners
    corner k = corners !! (k `mod` n)
    isFlat = form == Ring && and [cross a b c == 0 | a <- corners, b <- corners, c <- corners]
    repeats = case form of
      Ring -> [RepeatedCorner (CornerName p k) j c | (k, c) <- indexed, Just j <- [elemIndex c corners], j < k]
      Polyline -> [RepeatedCorner (CornerName p k) (k - 1) c | (k, c) <- drop 1 indexed, corner (k - 1) == c]
    spikes =
      [ Spike (CornerName p k) c
      | (k, c) <- indexed
      , form == Ring || (k > 0 && k < n - 1)
      , let a = corner (k - 1)
            b = corner (k + 1)
      , cross a c b == 0
      , dot c a b > 0
      ]
    touches =
      [ CornerOnSide (CornerName p k) (SideName p s) c
      | form == Ring
      , (k, c) <- indexed
      , (SideName _ s, side) <- segmentsOf body
      , k `notElem` map (`mod` n) [s - 1 .. s + 2]
      , liesOn c side
      ]
    crossings =
      [ CrossingSides s t
      | (s, side) <- segmentsOf body
      , (t, other) <- segmentsOf body
      , s < t
      , crosses side other
      ]

crossingsOf :: Body -> Body -> [SceneError]
crossingsOf a b = [CrossingSides s t | (s, side) <- segmentsOf a, (t, other) <- segmentsOf b, crosses side other]

-- Is there a point of both boundaries?
meet :: Body -> Body -> Bool
meet a b =
  or [crosses s t || touches s t || touches t s | (_, s) <- segmentsOf a, (_, t) <- segmentsOf b]
  where
    touches (c, d) side@(e, f) = any (\x -> x == e || x == f || liesOn x side) [c, d]

-- Of two polygons whose boundaries do not meet.
position :: (Body, Body) -> [SceneError]
position (a@(Body p _ as), b@(Body q _ bs))
  | meet a b = []
  | q == Enclosure = [OutsideEnclosure p | not (all collinear bs), not (firstIn as b)]
  | otherwise = [NestedPolygon p q | firstIn as b] <> [NestedPolygon q p | firstIn bs a]
  where
    collinear x = and [cross x c d == 0 | c <- bs, d <- bs]
    firstIn corners body = case corners of
      c : _ -> c `isInside` body
      [] -> False

-- Does a ray to the right from a point cross the polygon an odd number of times? A wall has no inside.
isInside :: Point -> Body -> Bool
isInside (Point x y) body = bodyForm body == Ring && odd (length (filter (hit . snd) (segmentsOf body)))
  where
    hit (Point ax ay, Point bx by) = (ay <= y) /= (by <= y) && ax + (y - ay) / (by - ay) * (bx - ax) > x

-- A wall that runs along itself.
alongItself :: Body -> [SceneError]
alongItself body =
  [ OverlappingWalls (bodyId body) (bodyId body)
  | bodyForm body == Polyline
  , (s, side) <- segmentsOf body
  , (t, other) <- segmentsOf body
  , s < t
  , runAlong side other
  ]

-- Have two segments a piece in common?
runAlong :: (Point, Point) -> (Point, Point) -> Bool
runAlong (a, b) (c, d) =
  cross a b c == 0 && cross a b d == 0 && max (min a b) (min c d) < min (max a b) (max c d)

-- Two polygons that overlap though they do not cross. Cut at all points where they touch, each piece of one lies all
-- inside, all outside or all on the boundary of the other one.
overlap :: Body -> Body -> [SceneError]
overlap a@(Body p form _) b@(Body q form' _)
  | (form, form') == (Polyline, Polyline) =
      [OverlappingWalls p q | or [runAlong s t | (_, s) <- segmentsOf a, (_, t) <- segmentsOf b]]
  | not (meet a b) || not (null (crossingsOf a b)) = []
  | otherwise = [OverlappingPolygons p q | any (`reachesInto` b) (pieces a b) || any (`reachesInto` a) (pieces b a)]

-- The segments of a polygon, cut where a corner of another one lies on them. With each, the side on which it has the
-- solid: 1 for the left, −1 for the right, 0 if it is a wall.
pieces :: Body -> Body -> [((Point, Point), Integer)]
pieces a b =
  [ (piece, solid)
  | (_, side@(c, d)) <- segmentsOf a
  , let between = filter (`liesOn` side) (bodyCorners b)
  , let places = (if c <= d then id else reverse) (sort (c : d : between))
  , piece@(e, f) <- zip places (drop 1 places)
  , e /= f
  , let solid = solidSide a piece
  ]

-- The polygon's area tells on which side of a piece of its boundary it has its solid, in the order of its corners.
solidSide :: Body -> (Point, Point) -> Integer
solidSide (Body p form corners) _
  | form == Polyline = 0
  | (doubledArea corners > 0) == (p /= Enclosure) = 1
  | otherwise = -1

-- Does a piece reach into the solid of a polygon, or lie along its boundary with the solid on the same side?
reachesInto :: ((Point, Point), Integer) -> Body -> Bool
reachesInto ((a@(Point ax ay), b@(Point bx by)), solid) body
  | bodyForm body == Polyline = False
  | otherwise = case [(c, d) | (_, (c, d)) <- segmentsOf body, middle == c || middle == d || liesOn middle (c, d)] of
      [] -> isInside middle body /= (bodyId body == Enclosure)
      along -> or [runAlong (a, b) side && solid /= 0 && sameSide side | side <- along]
  where
    middle = Point ((ax + bx) / 2) ((ay + by) / 2)
    sameSide side@(c, d) = (solidSide body side == solid) == (dot a b (moved d c) > 0)
    -- The corner a, moved by the way from c to d.
    moved (Point dx dy) (Point cx cy) = Point (ax + dx - cx) (ay + dy - cy)
