-- | Random scenes for the tests of reading and validating: valid ones, and small ones with anything wrong.
module Visibility.Scene.Sample
  ( -- * Valid scenes
    validScenes
  , similar
    -- * Scenes with defects
  , clutteredScenes
    -- * Helpers
  , polygonsOf
  , at
  , doubledArea
  ) where

import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust)
import Data.Ratio ((%))
import qualified Data.Text as Text
import Test.QuickCheck
import Visibility.Exact.Point (Point (..))
import Visibility.Scene.Id
import Visibility.Scene.Raw

-- | All polygons with their ids, the enclosure last.
polygonsOf :: RawScene -> [(PolygonId, RawPolygon)]
polygonsOf raw = zip (map Obstacle [0 ..]) (rawPolygons raw) <> [(Enclosure, room) | Just room <- [rawEnclosure raw]]

at :: Rational -> Rational -> Point
at = Point

-- | Twice the area, positive for counter-clockwise corners.
doubledArea :: [Point] -> Rational
doubledArea corners = sum (zipWith (\(Point x y) (Point x' y') -> x * y' - x' * y) corners (drop 1 (cycle corners)))

-- | A polygon to a cell of a grid, in a room or in the open, with materials and names. None touches another, no wall
-- touches itself.
validScenes :: Gen RawScene
validScenes = do
  k <- choose (1, 8)
  cells <- take k <$> shuffle [(10 * i, 10 * j) | i <- [0 .. 3], j <- [0 .. 3]]
  obstacles <- mapM (\(x, y) -> shape >>= disguised . placedAt x y) cells
  room <- oneof [pure Nothing, Just <$> (elements rooms >>= disguised . rawPolygon)]
  alone <- frequency [(9, pure False), (1, pure True)]
  name <- names
  similar (RawScene name room (if alone && isJust room then [] else obstacles))
  where
    rooms =
      [ [at (-1) (-1), at 41 (-1), at 41 41, at (-1) 41]
      , [at (-1) (-1), at 20 (-1), at 41 (-1), at 45 20, at 41 41, at (-1) 41]
      , [at (-1) (-1), at (19 % 2) (-1), at (19 % 2) (-9), at 41 (-9), at 41 41, at (-5) 41]
      ]
    placedAt x y polygon = polygon {rawCorners = [Point (x + x') (y + y') | Point x' y' <- rawCorners polygon]}

-- | A translated, scaled and turned copy with the same names.
similar :: RawScene -> Gen RawScene
similar raw = do
  factor <- elements [1, 1 % 3, 7, 10 ^ (25 :: Int) + 1 % 7]
  dx <- elements [0, -20, 1 % 11, 10 ^ (30 :: Int)]
  dy <- elements [0, -3, 5 % 13]
  (c, s) <- elements [(1, 0), (0, 1), (-1, 0), (3 % 5, 4 % 5), (5 % 13, -12 % 13)]
  let moved (Point x y) = Point (factor * (c * x - s * y) + dx) (factor * (s * x + c * y) + dy)
      movedPolygon p = p {rawCorners = map moved (rawCorners p)}
  pure raw {rawEnclosure = movedPolygon <$> rawEnclosure raw, rawPolygons = map movedPolygon (rawPolygons raw)}

-- A simple polygon or a wall within [0, 9]².
shape :: Gen RawPolygon
shape =
  frequency
    [ (8, rawPolygon <$> simple)
    , (1, (\a b -> rawWall [at 0 a, at 4 9, at 9 b]) <$> elements [0, 1, 2] <*> elements [0, 5 % 3])
    , (1, (\a -> rawWall [at 0 0, at 4 0, at 9 0, at 9 9, at a 5, at 1 1]) <$> elements [0, 1 % 2])
    ]

simple :: Gen [Point]
simple =
  oneof
    [ (\a b c d -> [at 0 a, at 9 b, at (9 - c) 9, at d 8]) <$> small <*> small <*> small <*> small
    , (\a b -> [at a 0, at 9 b]) <$> small <*> small
    , (\a b -> [at a 0, at a (8 + b)]) <$> small <*> halves
    , (\a b c -> [at a 0, at 9 b, at 4 (5 + c)]) <$> small <*> small <*> halves
    , (\a b -> [at 0 0, at 4 0, at 5 0, at 9 0, at 9 9, at a (5 + b)]) <$> small <*> halves
    , pure [at 0 0, at 8 0, at 8 3, at 3 3, at 3 8, at 0 8]
    , (\t -> [at 0 0, at 9 0] <> concat [[at (2 * i + 1) 8, at (2 * i) t] | i <- [4, 3, 2, 1]]) <$> fmap (+ 1) halves
    , star
    ]
  where
    small = elements [0, 1, 2, 1 % 2, 5 % 3]
    halves = elements [0, 1 % 2, 1]
    star = do
      directions <- sortOn angle <$> (take <$> choose (3, 8) <*> shuffle rim)
      radii <- mapM (const (elements [1, 2 % 3, 1 % 2, 3 % 4])) directions
      let corners = [at (4 + x * r) (4 + y * r) | ((x, y), r) <- zip directions radii]
      -- The centre must be inside, or the corners are not in order around it.
      if and (zipWith turnsLeft directions (drop 1 (cycle directions))) then pure corners else star
    rim = [(x, y) | x <- [-4 .. 4], y <- [-4 .. 4], abs x + abs y == 4]
    turnsLeft (x, y) (x', y') = x * y' - y * x' > (0 :: Rational)
    angle (x, y) = atan2 (fromRational y) (fromRational x) :: Double

-- Any first corner of a ring, either orientation, with a material and a name.
disguised :: RawPolygon -> Gen RawPolygon
disguised polygon = do
  k <- if rawForm polygon == Ring then choose (0, length corners - 1) else pure 0
  turned <- elements [id, reverse]
  sides <- choose (0, n) >>= \m -> take m <$> shuffle [0 .. n - 1]
  overrides <- mapM (const (MaterialOverride <$> perhaps emissions <*> perhaps reflectivities)) sides
  name <- names
  material <- oneof [pure black, Material <$> emissions <*> reflectivities]
  pure
    polygon
      { rawPolygonName = name
      , rawCorners = turned (drop k corners <> take k corners)
      , rawMaterial = material
      , rawSides = Map.fromList (zip sides overrides)
      }
  where
    corners = rawCorners polygon
    n = sideTotal polygon
    emissions = elements [0, 1, 7 % 3]
    reflectivities = elements [0, 1 % 2, 99 % 100]

perhaps :: Gen a -> Gen (Maybe a)
perhaps g = oneof [pure Nothing, Just <$> g]

names :: Gen (Maybe Text.Text)
names = perhaps (Text.pack <$> elements ["lamp", "", "two rooms"])

-- | Few polygons with few corners on a small lattice: all kinds of contacts and defects, alone and together.
clutteredScenes :: Gen RawScene
clutteredScenes = frequency [(3, messy), (2, tidy)]

-- A few polygons and walls on a very small lattice, simple as a rule: they touch and overlap in all ways.
tidy :: Gen RawScene
tidy = do
  k <- choose (1, 4)
  RawScene Nothing <$> frequency [(2, pure Nothing), (1, Just . rawPolygon <$> rectangle)] <*> vectorOf k polygon
  where
    polygon =
      frequency
        [ (3, rawPolygon <$> rectangle)
        , (3, rawPolygon <$> triangle)
        , (1, rawPolygon <$> angle)
        , (1, rawPolygon <$> vectorOf 2 corner)
        , (1, rawWall <$> vectorOf 3 corner)
        , (2, rawPolygon <$> (corner >>= along 1))
        , (5, rawWall <$> (choose (3, 6) >>= \n -> corner >>= along n))
        ]
    corner = at <$> coordinate <*> coordinate
    coordinate = fromInteger <$> choose (0, 4)
    interval = do
      x <- choose (0, 3)
      x' <- choose (x + 1, 4)
      pure (fromInteger x, fromInteger x')
    rectangle = do
      (x, x') <- interval
      (y, y') <- interval
      pure [at x y, at x' y, at x' y', at x y']
    triangle = do
      found <- rectangle >>= shuffle
      apex <- corner
      pure (apex : take 2 found)
    angle = do
      (x, y) <- (,) <$> elements [0, 1, 2] <*> elements [0, 1, 2]
      (dx, dy) <- (,) <$> elements [-2, 2] <*> elements [-2, 2]
      pure [at (x + dx * a) (y + dy * b) | (a, b) <- [(0, 0), (1, 0), (1, 1 % 2), (1 % 2, 1 % 2), (1 % 2, 1), (0, 1)]]
    -- So many steps along the axes by turns.
    along :: Int -> Point -> Gen [Point]
    along n from = elements [False, True] >>= steps n from
    steps n from@(Point x y) across
      | n == 0 = pure [from]
      | otherwise = do
          d <- elements [-2, -1, 1, 2]
          (from :) <$> steps (n - 1) (if across then at (x + d) y else at x (y + d)) (not across)

messy :: Gen RawScene
messy = do
  k <- choose (0, 4)
  RawScene Nothing <$> frequency [(2, pure Nothing), (1, Just <$> room)] <*> vectorOf k polygon
  where
    room = frequency [(3, rawPolygon <$> box (whole 0 1) (whole 6 9)), (1, scribble), (1, placed)]
    polygon = frequency [(3, placed), (2, scribble), (1, straight), (2, boxed), (1, wronged), (1, walled)]
    walled = (\polygon' -> polygon' {rawForm = Polyline}) <$> oneof [placed, scribble, straight]
    boxed = rawPolygon <$> box coordinate coordinate
    -- All corners on a line, in any order.
    straight = do
      (x, dx, dy) <- (,,) <$> coordinate <*> whole 0 1 <*> whole 0 1
      along <- choose (2, 6) >>= \n -> vectorOf n coordinate
      pure (rawPolygon [at (x + t * dx) (t * dy) | t <- along])
    box low high = do
      (x, y, x', y') <- (,,,) <$> low <*> low <*> high <*> high
      pure (map (uncurry at) [(x, y), (x', y), (x', y'), (x, y')])
    coordinate = whole 0 9
    whole low high = fromInteger <$> choose (low, high)
    -- Small ones, so that some lie inside others and some are apart.
    placed = do
      corners <- elements [2, 3, 3, 4] >>= \n -> vectorOf n (at <$> whole 0 2 <*> whole 0 2)
      dx <- whole 0 7
      dy <- whole 0 7
      pure (rawPolygon [at (x + dx) (y + dy) | Point x y <- corners])
    scribble = choose (0, 7) >>= \n -> rawPolygon <$> vectorOf n (at <$> coordinate <*> coordinate)
    wronged = do
      polygon' <- placed
      material <- Material <$> values <*> values
      let override = MaterialOverride <$> perhaps values <*> perhaps values
      sides <- choose (0, 2 :: Int) >>= \n -> vectorOf n ((,) <$> choose (-1, 4) <*> override)
      pure polygon' {rawMaterial = material, rawSides = Map.fromList sides}
    values = elements [0, 1 % 2, 1, -1 % 2, 3]
