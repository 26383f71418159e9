{-# LANGUAGE OverloadedStrings #-}

-- | Named families of scenes by size and seed: inputs for trials, tests and benchmarks.
--
-- A scene is a pure function of family, size and seed, the same for all time. All coordinates are integers; up to 2¹⁴
-- corners they stay below 2³¹, so that machine integers decide. The exception is 'Kettner': its coordinates are
-- Doubles, and too fine for machine integers. Every scene is valid by construction: each polygon has a cell of its own
-- and stays strictly inside it, but in the families that are made to touch, and in 'Ceiling' and 'Tower'.
module Visibility.Scene.Family
  ( -- * Families
    Family (..)
  , familyName
  , familyNamed
  , familyPurpose
    -- * Scenes
  , Size
  , size
  , sizeCount
  , Seed (..)
  , family
  ) where

import Control.Monad (replicateM)
import Data.List (find)
import Data.Text (Text)
import qualified Data.Text as Text
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.IntegerRoot (exactSquareRoot, integerSquareRoot)
import Visibility.Scene.Family.Ceiling
import Visibility.Scene.Family.Draw
import Visibility.Scene.Family.Kettner (kettner, kettnerUnit)
import Visibility.Scene.Raw

-- | A kind of scene. 'familyPurpose' says in a line what each is.
data Family
  = -- | Of random shape and orientation, one in each cell of a jittered grid.
    Random
  | -- | The number of visible pairs grows nearly with the square of the size.
    Sparse
  | Grid
  | -- | The piers stand along the walls.
    Room
  | -- | Full of parallels.
    Comb
  | ThinWalls
  | Needles
  | -- | Near (1/2, 1/2), with a corner at (12, 12) and one at (24, 24). See "Visibility.Scene.Family.Kettner".
    Kettner
  | -- | As the dark squares of a chessboard do.
    Checkerboard
  | -- | With alleys between the rows.
    Terraces
  | -- | Of unit length in a square lattice; they may close off pockets.
    Maze
  | -- | Each wall sees the right part of the ceiling: a long chain for searches that go from the wrong end. See
    -- "Visibility.Scene.Family.Ceiling".
    Ceiling
  | Tower
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | The family's name on the command line.
familyName :: Family -> Text
familyName = fst . inWords

-- | /Law/ @familyNamed (familyName f) == Just f@.
familyNamed :: Text -> Maybe Family
familyNamed name = find ((== name) . familyName) [minBound ..]

-- | What the family is for, and what its size counts, in a line.
familyPurpose :: Family -> Text
familyPurpose = snd . inWords

inWords :: Family -> (Text, Text)
inWords kind = case kind of
  Random -> ("random", "N convex quadrilaterals; a corner sees about as many others whatever N is")
  Sparse -> ("sparse", "N small quadrilaterals far apart; nearly all see each other")
  Grid -> ("grid", "N unit squares in a square lattice; many corners on one line")
  Room -> ("room", "a room with piers, and N quadrilaterals in it")
  Comb -> ("comb", "two combs of N rectangular teeth each, facing each other; non-convex")
  ThinWalls -> ("thin-walls", "N thin walls in random directions")
  Needles -> ("needles", "N long slender triangles, nearly parallel")
  Kettner -> ("kettner", "N tiny triangles in line with two others, nearly or exactly: where Doubles go wrong")
  Checkerboard -> ("checkerboard", "N unit squares that touch at their corners")
  Terraces -> ("terraces", "N unit squares that touch along their sides, in rows")
  Maze -> ("maze", "N thin walls that meet at their ends")
  Ceiling -> ("ceiling", "a convex ceiling of N*N + N corners above a column of N walls; a long chain")
  Tower -> ("tower", "the same ceiling beside one tower; two polygons")

-- | How many polygons a scene has ('Comb': teeth of each comb; 'Room': obstacles in the room; 'Kettner': tiny ones, two
-- large ones come before them; 'Ceiling' and 'Tower': corners of the column). At least 1.
newtype Size = Size Int
  deriving (Eq, Ord, Show)

-- | The smart constructor; 'Nothing' below 1.
size :: Int -> Maybe Size
size n = if n >= 1 then Just (Size n) else Nothing

-- | The number that a size is.
sizeCount :: Size -> Int
sizeCount (Size n) = n

-- | The scene of a family, named by family, size and seed.
--
-- /Degenerate cases/ 'Grid', 'Checkerboard', 'Terraces', 'Ceiling' and 'Tower' do not depend on the seed.
--
-- /Cost/ O(n) in n corners.
--
-- /Laws/ the scene is valid; except for 'Comb', 'Ceiling' and 'Tower', its obstacles are the first ones of every larger
-- scene of the same family and seed.
family :: Family -> Size -> Seed -> RawScene
family kind (Size n) seed@(Seed s) =
  RawScene
    { rawName = Just (Text.intercalate "-" [familyName kind, Text.pack (show n), Text.pack (show s)])
    , rawEnclosure = case kind of
        Room -> Just (rawPolygon (map point (enclosure n seed)))
        _ -> Nothing
    , rawPolygons = map (rawPolygon . map point) (obstacles kind n seed)
    }
  where
    point (x, y) = Point (unit * fromInteger x) (unit * fromInteger y)
    unit = case kind of
      Kettner -> kettnerUnit
      _ -> 1

-- | The coordinates of a point or a vector, in units of the family.
type Pair = (Integer, Integer)

obstacles :: Family -> Int -> Seed -> [[Pair]]
obstacles kind n seed = case kind of
  Random -> scattered 4640000 (quadrilateral 700 1000)
  Sparse -> scattered (2 * randomCell) (quadrilateral 90 130)
  Grid -> squares (\(i, j) -> (2 * i, 2 * j))
  Room -> map (map (moved (roomMargin, roomMargin))) (scattered (2 * randomCell) (quadrilateral 700 1000))
  Comb -> combs n seed
  ThinWalls -> scattered randomCell wall
  Needles -> [runDraw seed k (needle (cell k)) | k <- [0 .. n - 1]]
  Kettner -> kettner n seed
  Checkerboard -> squares (\(i, j) -> (i + j, i - j))
  Terraces -> squares (\(i, j) -> (i, 2 * j))
  Maze -> [runDraw seed k (latticeWall (cell k)) | k <- [0 .. n - 1]]
  Ceiling -> aboveColumn (toInteger n)
  Tower -> aboveTower (toInteger n)
  where
    squares place = [map (moved (place (cell k))) [(0, 0), (1, 0), (1, 1), (0, 1)] | k <- [0 .. n - 1]]
    scattered edge shape = [runDraw seed k (shape >>= turnedAtRandom >>= within edge (cell k)) | k <- [0 .. n - 1]]

-- | The cell of a polygon: cells fill growing squares, so that n of them lie in a square of ⌈√n⌉ columns and rows, and
-- the first ones do not depend on n.
cell :: Int -> Pair
cell k = if r < s then (s, r) else (2 * s - r, s)
  where
    s = integerSquareRoot (toInteger k)
    r = toInteger k - s * s

-- | A convex quadrilateral, no three corners on a line: one corner inside each side of a rectangle about the origin
-- whose half sides are drawn from this range.
quadrilateral :: Integer -> Integer -> Draw [Pair]
quadrilateral least most = do
  a <- between least most
  b <- between least most
  south <- between (1 - a) (a - 1)
  east <- between (1 - b) (b - 1)
  north <- between (1 - a) (a - 1)
  west <- between (1 - b) (b - 1)
  pure [(south, -b), (a, east), (north, b), (-a, west)]

-- | A thin wall about the origin, some 1000 to 2000 long.
wall :: Draw [Pair]
wall = do
  a <- between 500 1000
  left <- between (-100) 100
  right <- between (-100) 100
  pure [(-a, left), (a, right)]

-- | One of the two walls of unit length that lead to the right and up from a point of the lattice.
latticeWall :: Pair -> Draw [Pair]
latticeWall (i, j) = do
  up <- between 0 1
  pure [(i, j), (i + 1 - up, j + up)]

-- | Turns a shape by one of 108 exact angles, and makes it 1105 times as large.
turnedAtRandom :: [Pair] -> Draw [Pair]
turnedAtRandom shape = do
  (c, s) <- oneOf (1105, 0) (drop 1 headings)
  pure [(c * x - s * y, s * x + c * y) | (x, y) <- shape]

-- | All integer vectors of length 1105 = 5·13·17.
headings :: [Pair]
headings =
  [ (x, y)
  | x <- [-1105 .. 1105]
  , Just r <- [exactSquareRoot (1105 * 1105 - x * x)]
  , y <- if r == 0 then [0] else [r, -r]
  ]

-- | Puts a shape at random strictly inside a cell of the given edge. /Requires/ an edge that leaves room for it.
within :: Integer -> Pair -> [Pair] -> Draw [Pair]
within edge (i, j) shape = do
  x <- place (map fst shape)
  y <- place (map snd shape)
  pure (map (moved (edge * i + x, edge * j + y)) shape)
  where
    place coordinates = between (1 - minimum coordinates) (edge - 1 - maximum coordinates)

moved :: Pair -> Pair -> Pair
moved (dx, dy) (x, y) = (x + dx, y + dy)

-- | An edge into which every shape fits however it is turned: half sides up to 1000, enlarged by 1105, times √2,
-- doubled.
randomCell :: Integer
randomCell = 3130000

-- | How far the walls of a room stand from the cells of its obstacles.
roomMargin :: Integer
roomMargin = randomCell

-- | The corners of a square room, counter-clockwise, with a pier in front of each cell along each wall.
enclosure :: Int -> Seed -> [Pair]
enclosure n seed = concat [map (onWall quarter) (runDraw seed (-1 - quarter) along) | quarter <- [0 .. 3]]
  where
    columns = integerSquareRoot (toInteger n - 1) + 1
    edge = 2 * randomCell * columns + 2 * roomMargin
    -- A wall from its first corner on, as distances along it and inward.
    along = ((0, 0) :) . concat <$> mapM pier [0 .. columns - 1]
    pier k = do
      from <- between 300000 2500000
      to <- between 3500000 6000000
      depth <- between (roomMargin `div` 4) (roomMargin - roomMargin `div` 4)
      let x = roomMargin + 2 * randomCell * k
      pure [(x + from, 0), (x + from, depth), (x + to, depth), (x + to, 0)]
    onWall :: Int -> Pair -> Pair
    onWall 0 (s, d) = (s, d)
    onWall 1 (s, d) = (edge - d, s)
    onWall 2 (s, d) = (edge - s, edge - d)
    onWall _ (s, d) = (d, edge - s)

-- | Two combs with teeth of random heights, the upper one upside down, a gap between the highest teeth.
combs :: Int -> Seed -> [[Pair]]
combs n seed = [comb (runDraw seed 0 heights), [(x, top - y) | (x, y) <- comb (runDraw seed 1 heights)]]
  where
    top = 2 * (spine + tallest) + 40
    (spine, pitch, shortest, tallest) = (10, 20, 40, 100)
    width = pitch * toInteger n
    heights = replicateM n (between shortest tallest)
    comb hs = [(0, spine), (0, 0), (width, 0), (width, spine)] <> concat (reverse (zipWith tooth [0 ..] hs))
    tooth k h =
      let (left, right) = (pitch * k + 3, pitch * k + 17)
       in [(right, spine), (right, spine + h), (left, spine + h), (left, spine)]

-- | A triangle as long as a cell, in cells laid like bricks.
needle :: Pair -> Draw [Pair]
needle (i, j) = do
  left <- between 1 600
  right <- between 3400 3990
  tip <- between 1 29
  base <- between 1 28
  thickness <- between 1 2
  let offset = if even j then 0 else 2000
      place (x, y) = (4000 * i + offset + x, 30 * j + y)
  backwards <- between 0 1
  let mirrored (x, y) = if backwards == 1 then (4000 - x, 30 - y) else (x, y)
  pure (map (place . mirrored) [(left, tip), (right, base), (right, min 29 (base + thickness))])
