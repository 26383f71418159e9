-- | Families of valid scenes that are made to cost much: as much as there can be in one place, on one line, or in sight
-- of one another. What is to cost no more than its input and its output is measured on them.
--
-- Beside them stand the families of "Visibility.Scene.Family", of which 'Visibility.Scene.Family.Ceiling' and
-- 'Visibility.Scene.Family.Tower' are made to cost much too, and the scenes of "Visibility.Test.Mistake".
module Visibility.Test.Adversary
  ( Adversary (..)
  , adversaryName
  , adversary
  , adversaryParts
  , alight
  ) where

import Data.Foldable (toList)
import qualified Data.Map.Strict as Map
import Visibility.Exact.Point (Point (..))
import Visibility.Scene.Raw

-- | A kind of scene.
data Adversary
  = -- | Triangles with a corner in one place, and free space between any two of them.
    InOnePoint
  | -- | The same without gaps: neighbours touch along a whole side.
    InOnePointClosed
  | -- | Thin walls that end in one place, two and two in line.
    WallsInOnePoint
  | -- | A polygon that touches the side of another one with the tips of its teeth.
    Saw
  | -- | Long parallel walls, all above one another, and two triangles elsewhere that touch in a corner.
    OneContact
  | -- | Squares side by side with gaps: nearly all pairs are on two lines.
    Row
  | -- | The same, one above another: the two lines are vertical.
    Column
  | -- | Squares by turns above and below a line on which all of them have a side.
    Slalom
  | -- | Thin walls on one line.
    WallRow
  | -- | A side of a polygon that is many sides, with flat corners between them.
    FlatCorners
  | -- | A polygon with points by turns near and far from a place.
    Star
  | -- | A thin wall that goes around and around.
    Spiral
  | -- | A room, all corners of which see each other.
    ConvexRoom
  | -- | Needles that point to one place and end before it.
    NeedleFan
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | The name that the tables of the ladder give it.
adversaryName :: Adversary -> String
adversaryName kind = case kind of
  InOnePoint -> "in-one-point"
  InOnePointClosed -> "in-one-point-closed"
  WallsInOnePoint -> "walls-in-one-point"
  Saw -> "saw"
  OneContact -> "one-contact"
  Row -> "row"
  Column -> "column"
  Slalom -> "slalom"
  WallRow -> "wall-row"
  FlatCorners -> "flat-corners"
  Star -> "star"
  Spiral -> "spiral"
  ConvexRoom -> "convex-room"
  NeedleFan -> "needle-fan"

-- | The scene with so many parts: triangles, walls, teeth, squares, flat corners, points, pieces of the spiral, corners
-- of the room, or needles. All coordinates are integers.
--
-- /Requires/ at least 1 part, in a star 2 and in a room 3; and at most 10⁵ in a star or a fan of needles, where points
-- on circles are rounded.
--
-- /Cost/ O(n).
--
-- /Laws/ the scene is valid. Where 'adversaryParts' is asked for so many corners, it has fewer by less than a part, or
-- more by at most ten.
adversary :: Adversary -> Int -> RawScene
adversary kind n = case kind of
  InOnePoint -> under [[Point 0 0, Point (2 * k - m) (2 * m), Point (2 * k + 1 - m) (2 * m)] | k <- parts]
  InOnePointClosed -> under [[Point 0 0, Point (2 * k - m) (2 * m), Point (2 * k + 2 - m) (2 * m)] | k <- parts]
  WallsInOnePoint ->
    under (take n [[Point 0 0, end] | k <- parts, let out = onCircle 1 (k / m), end <- [out, opposite out]])
  Saw -> under [block 0 (-1) (2 * m) 0, [Point (2 * m) 2, Point 0 2, Point 0 1] <> concatMap tooth parts]
  OneContact -> under (glasses <> [[Point 0 (2 * k), Point 1000000 (1000000 + 2 * k)] | k <- parts])
  Row -> under [block (2 * k) 0 (2 * k + 1) 1 | k <- parts]
  Column -> under [block 0 (2 * k) 1 (2 * k + 1) | k <- parts]
  Slalom -> under (zipWith (\k y -> block (2 * k) y (2 * k + 1) (y + 1)) parts (cycle [0, -1]))
  WallRow -> under [[Point (2 * k) 0, Point (2 * k + 1) 0] | k <- parts]
  FlatCorners -> under [Point m 1 : Point (-1) 1 : map (`Point` 0) (-1 : parts <> [m])]
  Star -> under [concat [[onCircle 10 (k / m), onCircle 3 ((k + 1 / 2) / m)] | k <- parts]]
  Spiral -> RawScene Nothing Nothing [rawWall (scanl along (Point 0 0) (take n (zip windings (cycle ways))))]
  ConvexRoom -> RawScene Nothing (Just (rawPolygon [Point k (k * k) | k <- parts])) []
  NeedleFan -> under [[onCircle 1 (k / m), onCircle 10 (k / m), onCircle 10 ((k + 1 / 4) / m)] | k <- parts]
  where
    under = RawScene Nothing Nothing . map rawPolygon
    parts = map fromIntegral [0 .. n - 1] :: [Rational]
    m = fromIntegral n
    block x y x' y' = [Point x y, Point x' y, Point x' y', Point x y']
    glasses = [[Point (-3) 1, Point (-4) 0, Point (-2) 0], [Point (-3) 1, Point (-2) 2, Point (-4) 2]]
    opposite (Point x y) = Point (-x) (-y)
    tooth k = [Point (2 * k + 1) 0, Point (2 * k + 2) 1]
    windings = concatMap (replicate 2) [1 ..]
    ways = [(1, 0), (0, 1), (-1, 0), (0, -1)]
    along (Point x y) (steps, (dx, dy)) = Point (x + steps * dx) (y + steps * dy)

-- | How many parts have about so many corners; at least 3.
adversaryParts :: Adversary -> Int -> Int
adversaryParts kind count = max 3 (count `div` (total 8 - total 7))
  where
    total n = let raw = adversary kind n in sum (map cornerTotal (toList (rawEnclosure raw) <> rawPolygons raw))

-- | A point near a circle around (0, 0), its radius in millions, by a part of half of it.
onCircle :: Rational -> Rational -> Point
onCircle r part = Point (near (r * (1 - t * t) / (1 + t * t))) (near (r * 2 * t / (1 + t * t)))
  where
    t = 2 * part - 1
    near x = fromInteger (round (1000000 * x))

-- | The same scene in a light: all reflect half of it, and the first polygon shines, or the room where there is none.
alight :: RawScene -> RawScene
alight raw =
  raw
    { rawEnclosure = shining (if null (rawPolygons raw) then 1 else 0) <$> rawEnclosure raw
    , rawPolygons = zipWith shining (1 : repeat 0) (rawPolygons raw)
    }
  where
    shining emitted polygon = described (rawPolygonName polygon) polygon (Material emitted (1 / 2)) Map.empty
