-- | What a point sees, by an exact angular scan written from the definition in rationals: an oracle for walks in the
-- complex. Also the points to look from.
module Visibility.Test.Scan
  ( -- * Scans
    scan
  , shootFrom
  , Hit (..)
    -- * Viewpoints
  , somePoint
  , pointsOfInterest
  ) where

import Data.List (nub, sortBy)
import Data.Ratio ((%))
import Test.QuickCheck
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.Predicate (Direction (..))
import Visibility.Scene
import Visibility.Scene.Raw (Form (..))
import Visibility.Sight (Sight (..))

-- | What a ray meets first: an object, or a side from behind, and then it was in the solid from its beginning on.
data Hit = Meets !Object | Solid
  deriving (Eq, Show)

-- | The ray from any point in a direction in which no corner lies.
shootFrom :: Scene -> Point -> Direction -> Hit
shootFrom scene (Point x y) (Direction dx dy)
  | null hits = case surroundings scene of
      OpenSky -> Meets Sky
      Room -> Solid
  | otherwise = case [s | (t, s, True) <- hits, t == nearest] of
      s : _ -> Meets (Side s)
      [] -> Solid
  where
    nearest = minimum [t | (t, _, _) <- hits]
    hits =
      [ (t, s, inward > 0)
      | s <- sides scene
      , let Point ax ay = cornerPoint scene (sideStart s)
      , let Point bx by = cornerPoint scene (sideEnd scene s)
      , let (ex, ey) = (bx - ax, by - ay)
      , let inward = ex * fromInteger dy - ey * fromInteger dx
      , inward /= 0
      , let t = ((ax - x) * ey - (ay - y) * ex) / negate inward
      , let u = ((ax - x) * fromInteger dy - (ay - y) * fromInteger dx) / negate inward
      , t > 0
      , u > 0
      , u < 1
      ]

-- | All that is seen from a point: one ray in the middle between all directions to corners. Neighbours that see the
-- same are one sight. Where polygons touch there may be solid rays in several places. The list begins with the first
-- sight from (1, 0) on that comes after solid rays, if there are some, else with the first of all. For a point in the
-- solid, the first obstacle that it is in, or the enclosure.
--
-- /Cost/ O(n²).
scan :: Scene -> Point -> Either PolygonId [Sight]
scan scene eye = case (nub (map snd shots), changes) of
  ([Meets object], _) -> Right [Sight (Direction 1 0) (Direction 1 0) object]
  (_, _ : _) -> Right [Sight a b object | ((a, Meets object), (b, _)) <- afterSolid (zip changes (rotated changes))]
  _ -> Left (solidAt scene eye)
  where
    directions = nub (sortBy around [towards (cornerPoint scene c) | c <- corners scene, cornerPoint scene c /= eye])
    shots = [(a, shootFrom scene eye (middle a b)) | (a, b) <- zip directions (rotated directions)]
    -- Where the ray just before sees something else than the ray just after.
    changes = [(a, hit) | ((_, before), (a, hit)) <- zip (last' shots <> shots) shots, before /= hit]
    last' items = drop (length items - 1) items
    rotated items = drop 1 items <> take 1 items
    -- The changes are in order from (1, 0) on, and no two that lead to the solid follow each other.
    afterSolid pairs = case [i | (i, ((_, Solid), _)) <- zip [0 ..] (last' pairs <> pairs)] of
      [] -> pairs
      i : _ -> drop i pairs <> take i pairs
    towards (Point x y) = let Point ex ey = eye in wholeDirection (x - ex) (y - ey)
    around a b = compare (quadrant a) (quadrant b) <> compare 0 (cross a b)
    quadrant (Direction x y)
      | x > 0 && y >= 0 = 0 :: Int
      | x <= 0 && y > 0 = 1
      | x < 0 && y <= 0 = 2
      | otherwise = 3
    middle a@(Direction ax ay) b@(Direction bx by) = case compare (cross a b) 0 of
      GT -> Direction (ax + bx) (ay + by)
      LT -> Direction (negate (ax + bx)) (negate (ay + by))
      EQ
        | a == b -> Direction (negate ax) (negate ay)
        | otherwise -> Direction (negate ay) ax
    cross (Direction ax ay) (Direction bx by) = ax * by - ay * bx

-- | The first obstacle that holds a point with its boundary, by the turns that its corners make around the point; the
-- enclosure if there is none.
solidAt :: Scene -> Point -> PolygonId
solidAt scene (Point x y) =
  foldr const Enclosure [p | Polygon p@(Obstacle _) _ Ring loop <- scenePolygons scene, holds (map seen loop)]
  where
    seen (Point px py) = (px - x, py - y)
    holds loop = any onSide (joined loop) || sum (map quarters (joined loop)) /= 0
    joined loop = zip loop (drop 1 loop <> take 1 loop)
    onSide (a@(ax, ay), b@(bx, by)) = cross a b == 0 && ax * bx + ay * by <= 0
    -- From quarter to quarter of the plane, counter-clockwise positive; through the opposite one by the turn.
    quarters (a, b) = case (quarter b - quarter a) `mod` 4 of
      3 -> -1
      2 -> if cross a b > 0 then 2 else -2
      turned -> turned
    quarter (dx, dy)
      | dx > 0 && dy >= 0 = 0 :: Int
      | dx <= 0 && dy > 0 = 1
      | dx < 0 && dy <= 0 = 2
      | otherwise = 3
    cross (ax, ay) (bx, by) = ax * by - ay * bx

-- | The primitive vector of a rational one.
wholeDirection :: Rational -> Rational -> Direction
wholeDirection x y = Direction (truncate (x / unit)) (truncate (y / unit))
  where
    unit = commonMeasure (abs x) (abs y)
    commonMeasure a b
      | b == 0 = a
      | otherwise = commonMeasure b (a - b * fromInteger (floor (a / b)))

-- | A point to look from: of interest, or anywhere near the scene. In a room that is filled, all lie in the solid.
somePoint :: Scene -> Gen Point
somePoint scene =
  frequency
    [ (1, elements places)
    , (2, if null (sides scene) then onLine else between)
    , (2, crossing)
    , (2, aligned)
    , (2, onLine)
    , (2, lattice)
    ]
  where
    places = map snd (statedCorners scene)
    fraction = elements [1 % 2, 1 % 3, 2 % 3, 1 % 7, -1, -1 % 2, 2, 3 % 2, 5]
    on t (Point ax ay) (Point bx by) = Point (ax + t * (bx - ax)) (ay + t * (by - ay))
    -- On a side, or, where there is none that is not covered, on any line.
    between
      | null (sides scene) = onLine
      | otherwise = do
          s <- elements (sides scene)
          t <- elements [1 % 2, 1 % 3, 3 % 4]
          pure (on t (cornerPoint scene (sideStart s)) (cornerPoint scene (sideEnd scene s)))
    onLine = on <$> fraction <*> elements places <*> elements places
    aligned = (\(Point x _) (Point _ y) -> Point x y) <$> elements places <*> elements places
    lattice = do
      Point x y <- elements places
      Point a b <- elements places
      (u, v) <- (,) <$> choose (-3, 3) <*> choose (-3, 3)
      k <- elements [1, 1 % 2, 1 % 3, 1 % 10]
      pure (Point (x + k * fromInteger u * scaleOf x a) (y + k * fromInteger v * scaleOf y b))
    scaleOf p q = if p == q then 1 else abs (p - q) / 4
    crossing = do
      (a, b, c, d) <- (,,,) <$> elements places <*> elements places <*> elements places <*> elements places
      maybe onLine pure (meet a b c d)
    meet (Point ax ay) (Point bx by) (Point cx cy) (Point dx dy)
      | det == 0 = Nothing
      | otherwise = Just (Point (ax + t * (bx - ax)) (ay + t * (by - ay)))
      where
        det = (bx - ax) * (dy - cy) - (by - ay) * (dx - cx)
        t = ((cx - ax) * (dy - cy) - (cy - ay) * (dx - cx)) / det

-- | All corners and the middles of all sides, and of what is not covered of them.
pointsOfInterest :: Scene -> [Point]
pointsOfInterest scene =
  map snd (statedCorners scene)
    <> [ Point ((ax + bx) / 2) ((ay + by) / 2)
       | (Point ax ay, Point bx by) <-
           [(cornerPoint scene (sideStart s), cornerPoint scene (sideEnd scene s)) | s <- sides scene]
             <> concat [zip loop (drop 1 loop <> take 1 loop) | loop <- map polygonPoints (scenePolygons scene)]
       ]
