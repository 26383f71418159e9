-- | Scenes in which one thing is wrong, in one place among many or in as many places as can be: a kind for each kind of
-- error that grows with the scene. How messages grow is measured on them.
module Visibility.Test.Mistake
  ( Mistake (..)
  , mistakeName
  , mistaken
  , mistakes
  ) where

import qualified Data.Map.Strict as Map
import Visibility.Exact.Point (Point (..))
import Visibility.Scene.Raw

-- | What is wrong.
data Mistake
  = -- | Polygons of one corner.
    Points
  | -- | A polygon, each corner of which is given twice.
    Repeats
  | -- | Triangles with all corners on a line.
    FlatTriangles
  | -- | A polygon with spikes on a side.
    Spikes
  | -- | A polygon that touches its own side with the tips of its teeth.
    SawOnItself
  | -- | The same triangle, again and again: each overlaps each.
    Twins
  | -- | The same thin wall, again and again.
    TwinWalls
  | -- | Thin walls along one way, and as many along another, all of which cross.
    Lattice
  | -- | Parallel walls of which one crosses another one, at one end of the scene.
    OneCrossing
  | -- | Squares in squares: each lies inside all those before it.
    Dolls
  | -- | Triangles in one square.
    Swallowed
  | -- | Triangles outside of a room.
    LockedOut
  | -- | Triangles of which one side more is said than they have.
    FourthSides
  | -- | Triangles that emit less than nothing.
    Dark
  | -- | Triangles that reflect all light.
    Mirrors
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | The name that the tables of the ladder give it.
mistakeName :: Mistake -> String
mistakeName kind = case kind of
  Points -> "points"
  Repeats -> "repeats"
  FlatTriangles -> "flat-triangles"
  Spikes -> "spikes"
  SawOnItself -> "saw-on-itself"
  Twins -> "twins"
  TwinWalls -> "twin-walls"
  Lattice -> "lattice"
  OneCrossing -> "one-crossing"
  Dolls -> "dolls"
  Swallowed -> "swallowed"
  LockedOut -> "locked-out"
  FourthSides -> "fourth-sides"
  Dark -> "dark"
  Mirrors -> "mirrors"

-- | The scene with so many of what is wrong, or of what something is wrong with: in 'Lattice' walls along each way, in
-- 'OneCrossing' walls besides the one that crosses.
--
-- /Requires/ at least 3.
--
-- /Cost/ O(n).
--
-- /Laws/ it is not valid, has as many errors as 'mistakes' says, and all are of one kind.
mistaken :: Mistake -> Int -> RawScene
mistaken kind n = case kind of
  Points -> under [[Point k 0] | k <- parts]
  Repeats -> under [[p | k <- parts, p <- replicate 2 (Point k (k * k))]]
  FlatTriangles -> under [[Point (3 * k) 0, Point (3 * k + 1) 0, Point (3 * k + 2) 0] | k <- parts]
  Spikes -> under [[Point (2 * m) (-1), Point 0 (-1)] <> concatMap spike parts]
  SawOnItself -> under [around <> concat [[Point (2 * k + 1) 0, Point (2 * k + 2) 1] | k <- parts]]
  Twins -> under (replicate n (triangle 0))
  TwinWalls -> under (replicate n [Point 0 0, Point 1 0])
  Lattice -> under ([[Point (-1) k, Point m k] | k <- parts] <> [[Point k (-1), Point k m] | k <- parts])
  OneCrossing ->
    under ([Point 10 (2 * m + 19), Point 20 (2 * m + 17)] : [[Point 0 (2 * k), Point e6 (e6 + 2 * k)] | k <- parts])
  Dolls -> under [square (m - k) | k <- parts]
  Swallowed -> under (square (3 * m) : map triangle parts)
  LockedOut -> (under (map triangle parts)) {rawEnclosure = Just (rawPolygon (map (moved (-2)) (square 1)))}
  FourthSides -> each (\p -> p {rawSides = Map.singleton 3 (MaterialOverride Nothing Nothing)})
  Dark -> each (\p -> p {rawMaterial = Material (-1) 0})
  Mirrors -> each (\p -> p {rawMaterial = Material 0 1})
  where
    under = RawScene Nothing Nothing . map rawPolygon
    each change = let raw = under (map triangle parts) in raw {rawPolygons = map change (rawPolygons raw)}
    parts = map fromIntegral [0 .. n - 1] :: [Rational]
    m = fromIntegral n
    e6 = 1000000
    triangle k = [Point (3 * k) 0, Point (3 * k + 2) 0, Point (3 * k + 1) 1]
    square r = [Point (-r) (-r), Point r (-r), Point r r, Point (-r) r]
    moved by (Point x y) = Point (x + by) (y + by)
    spike k = [Point (2 * k) 0, Point (2 * k) 2, Point (2 * k) 1, Point (2 * k + 1) 0]
    around =
      [Point (2 * m) 2, Point (-2) 2, Point (-2) (-1), Point (2 * m) (-1), Point (2 * m) 0, Point (-1) 0, Point (-1) 1]

-- | How many errors there are in the scene with so many.
mistakes :: Mistake -> Int -> Int
mistakes kind n
  | kind `elem` [Twins, TwinWalls, Dolls] = n * (n - 1) `div` 2
  | kind == Lattice = n * n
  | kind == OneCrossing = 1
  | otherwise = n
