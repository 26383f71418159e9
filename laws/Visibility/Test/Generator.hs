-- | Valid scenes that aim at degeneracy, for QuickCheck.
--
-- A scene grows by proposals: a polygon is kept if the scene with it passes "Visibility.Scene.Validate". So the
-- generators do not decide what is valid, and cannot make anything else. Shrinking keeps validity in the same way.
module Visibility.Test.Generator
  ( -- * Samples
    Sample (..)
  , sample
  , sampleOf
  , sampleText
    -- * Kinds of scenes
  , AnyScene (..)
  , LatticeScene (..)
  , SmallScene (..)
  , ConvexScene (..)
  , TouchingScene (..)
  , HardScene (..)
    -- * Generators
  , latticeScene
  , gridScene
  , touchingScene
  , needleScene
  , familyScene
  , sizeOfCorners
  , dressed
    -- * Shrinking
  , shrinkSample
  ) where

import Control.Applicative ((<|>))
import Control.Monad (foldM)
import Data.List (intercalate)
import Data.Maybe (fromMaybe, mapMaybe)
import Data.Ratio (denominator, numerator, (%))
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Point (Point (..))
import Visibility.Law (broken)
import Visibility.Scene (Scene, sceneContacts)
import Visibility.Scene.Family
import Visibility.Scene.Raw
import Visibility.Scene.Validate (validate)
import Visibility.Test.Shape

-- | A valid scene with what it was made from.
data Sample = Sample {sampleRaw :: RawScene, sampleScene :: Scene}

instance Show Sample where
  show = sampleText . sampleRaw

-- | The sample of a raw scene, if it is valid.
sample :: RawScene -> Maybe Sample
sample raw = either (const Nothing) (Just . Sample raw) (validate raw)

-- | The sample of polygons with integer corners under the sky, if it is valid.
sampleOf :: [[Corner]] -> Maybe Sample
sampleOf = sample . RawScene Nothing Nothing . map ring

-- | The scene as a file would state it, without materials: can be pasted into one.
sampleText :: RawScene -> String
sampleText raw =
  "{" <> maybe "" (\room -> "\"enclosure\": {\"corners\": " <> loop room <> "}, ") (rawEnclosure raw)
    <> "\"polygons\": "
    <> list (map polygonText' (rawPolygons raw))
    <> "}"
  where
    polygonText' polygon
      | rawForm polygon == Polyline = "{\"wall\": " <> loop polygon <> "}"
      | otherwise = loop polygon
    loop polygon = list [list [number x, number y] | Point x y <- rawCorners polygon]
    list parts = "[" <> intercalate "," parts <> "]"
    number q
      | denominator q == 1 = show (numerator q)
      | otherwise = show (show (numerator q) <> "/" <> show (denominator q))

-- | All kinds mixed, lattice scenes most often, some with huge or rational coordinates.
newtype AnyScene = AnyScene Sample

-- | Integer coordinates of a small lattice, everything of this kind: walls, non-convex polygons, rooms, flat corners.
newtype LatticeScene = LatticeScene Sample

-- | At most about twelve corners, for what costs much.
newtype SmallScene = SmallScene Sample

-- | Convex polygons and thin walls under the sky, without flat corners.
newtype ConvexScene = ConvexScene Sample

-- | Polygons and walls that touch, on a small lattice: everything of this kind.
newtype TouchingScene = TouchingScene Sample

-- | Beyond machine integers: huge coordinates, nearly collinear corners, rationals with unrelated denominators.
newtype HardScene = HardScene Sample

instance Show AnyScene where show (AnyScene s) = show s
instance Show LatticeScene where show (LatticeScene s) = show s
instance Show SmallScene where show (SmallScene s) = show s
instance Show ConvexScene where show (ConvexScene s) = show s
instance Show TouchingScene where show (TouchingScene s) = show s
instance Show HardScene where show (HardScene s) = show s

instance Arbitrary AnyScene where
  arbitrary =
    AnyScene
      <$> frequency
        [ (9, latticeScene)
        , (6, touchingScene)
        , (2, gridScene)
        , (1, needleScene)
        , (1, familyScene)
        , (3, latticeScene >>= dressed)
        , (2, touchingScene >>= dressed)
        , (1, gridScene >>= dressed)
        ]
  shrink (AnyScene s) = map AnyScene (shrinkSample s)

instance Arbitrary LatticeScene where
  arbitrary = LatticeScene <$> latticeScene
  shrink (LatticeScene s) = map LatticeScene (shrinkSample s)

instance Arbitrary SmallScene where
  arbitrary = SmallScene <$> (choose (1, 4) >>= \count -> grown (Growth 5 count [3, 4, 5, 6, 8]))
  shrink (SmallScene s) = map SmallScene (shrinkSample s)

instance Arbitrary TouchingScene where
  arbitrary = TouchingScene <$> touchingScene
  shrink (TouchingScene s) = map TouchingScene (shrinkSample s)

instance Arbitrary ConvexScene where
  arbitrary = do
    edge <- elements [5, 8, 12, 1000]
    count <- choose (1, 7)
    loops <- vectorOf (2 * count) (placed edge >>= \box -> oneof [wall box, hull <$> vectorOf 5 (points box)])
    pure (ConvexScene (valid (foldl apart (alone Nothing) (map ring loops))))
    where
      points (Box (x, y) w h) = (,) <$> choose (x, x + w) <*> choose (y, y + h)
      apart now polygon
        | maybe False ((== 0) . sceneContacts . sampleScene) (sample next) = next
        | otherwise = now
        where
          next = added now polygon
  shrink (ConvexScene s) = [ConvexScene t | t <- shrinkSample s, polygons t < polygons s]
    where
      polygons = length . rawPolygons . sampleRaw

instance Arbitrary HardScene where
  arbitrary = HardScene <$> (oneof [latticeScene, gridScene, needleScene] >>= dressed)
  shrink (HardScene s) = map HardScene (shrinkSample s)

-- | How a lattice scene grows: at most this many corners each, this many polygons, a lattice of one of these extents.
data Growth = Growth !Int !Int ![Integer]

-- | A scene on a small lattice: everything mixed.
latticeScene :: Gen Sample
latticeScene = do
  n <- getSize
  count <- choose (1, 2 + n `div` 12)
  most <- elements [3, 4, 6, 8]
  grown (Growth most count [4, 6, 8, 12, 20, 50, 1000])

grown :: Growth -> Gen Sample
grown (Growth most count extents) = do
  edge <- elements extents
  room <- frequency [(3, pure Nothing), (2, Just . ring <$> roomShape (Box (0, 0) edge edge))]
  valid <$> foldM (propose edge) (alone room) [1 .. 2 * count]
  where
    propose edge now _
      | length (rawPolygons now) >= count = pure now
      | otherwise = do
          box <- placed edge
          loop <- frequency [(4, shape most box), (1, onLine edge now)]
          pure (added now (ring loop))
    onLine edge now = case concatMap rawCorners (rawPolygons now) of
      [] -> shape most (Box (0, 0) edge edge)
      found -> do
        Point ax ay <- elements found
        Point bx by <- elements found
        box <- placed edge
        throughTwo (numerator ax, numerator ay) (numerator bx, numerator by) box

-- | A scene that grows by polygons and walls put against what is there already: corner on corner, corner on side, along
-- sides, from one thing to another; or a grid of squares side by side.
touchingScene :: Gen Sample
touchingScene = frequency [(5, growing), (1, kept . map ring <$> sideBySide)]
  where
    growing = do
      n <- getSize
      edge <- elements [3, 4, 6, 8, 12]
      count <- choose (2, 3 + n `div` 12)
      room <- frequency [(3, pure Nothing), (2, Just . ring <$> roomShape (Box (1, 1) (edge - 2) (edge - 2)))]
      valid <$> foldM (against edge count) (alone room) [1 .. 4 * count :: Int]
    against edge count now _
      | length (rawPolygons now) >= count = pure now
      | otherwise = do
          box <- placed edge
          let everything = maybe id (:) (rawEnclosure now) (rawPolygons now)
              whole (Point x y) = (numerator x, numerator y)
              loops = map (map whole . rawCorners) everything
              sides' = concat [zip loop (drop 1 loop <> take 1 loop) | loop <- loops]
          added now <$> proposal box sides'
    proposal box [] = ring <$> shape 5 box
    proposal box sides' =
      frequency
        [ (2, ring <$> shape 5 box)
        , (3, ring <$> atPoints sides' box)
        , (3, elements sides' >>= \(a, b) -> ring <$> alongSegment a b box)
        , (2, wallOf <$> wallFrom sides' box)
        , (1, wallOf . closed <$> (roomShape box >>= \loop -> pure (take 5 loop)))
        ]
    wallOf points = rawWall [Point (x % 1) (y % 1) | (x, y) <- points]
    closed loop = loop <> take 1 loop

-- | A part of a square lattice, of any size down to three points wide.
placed :: Integer -> Gen Box
placed edge = do
  extent <- elements (filter (<= edge) [2, 3, 4, 6, edge `div` 2, edge])
  x <- choose (0, edge - extent)
  y <- choose (0, edge - extent)
  pure (Box (x, y) extent extent)

-- | Squares in a lattice.
gridScene :: Gen Sample
gridScene = kept . map ring <$> squareGrid

-- | Slender triangles.
needleScene :: Gen Sample
needleScene = kept . map ring <$> slimTriangles

-- | A small scene of one of the named families.
familyScene :: Gen Sample
familyScene = do
  kind <- elements [minBound .. maxBound]
  n <- choose (1, if kind `elem` [Ceiling, Tower] then 3 else 8)
  seed <- arbitrary
  pure (valid (maybe (alone Nothing) (\s -> family kind s (Seed seed)) (size n)))

-- | The size at which a scene of the family has about so many corners; at least 1.
sizeOfCorners :: Family -> Int -> Int
sizeOfCorners kind count = max 1 $ case kind of
  Comb -> count `div` 8
  ThinWalls -> count `div` 2
  Maze -> count `div` 2
  Needles -> count `div` 3
  Ceiling -> side
  Tower -> side
  _ -> count `div` 4
  where
    side = 1 + length (takeWhile (\k -> k * k + 2 * k + 6 < count) [1 ..])

ring :: [Corner] -> RawPolygon
ring loop = rawPolygon [Point (x % 1) (y % 1) | (x, y) <- loop]

-- | A scene of those polygons of a list that do not spoil it, one after the other.
kept :: [RawPolygon] -> Sample
kept = valid . foldl added (alone Nothing)

-- | The room, if it is valid, and nothing in it.
alone :: Maybe RawPolygon -> RawScene
alone room = maybe (RawScene Nothing Nothing []) sampleRaw (sample (RawScene Nothing room []))

added :: RawScene -> RawPolygon -> RawScene
added raw polygon = maybe raw sampleRaw (sample raw {rawPolygons = rawPolygons raw <> [polygon]})

-- | The sample, or a triangle where no proposal was valid.
valid :: RawScene -> Sample
valid raw = case sample raw <|> sampleOf [[(0, 0), (1, 0), (0, 1)]] of
  Just found -> found
  Nothing -> broken "a triangle is a valid scene" ""

-- | The same scene in hard coordinates: enlarged, moved, mapped by a rational affine map, or with its corners moved by
-- next to nothing, so that what was collinear is nearly so.
dressed :: Sample -> Gen Sample
dressed plain = do
  large <- elements [2 ^ (31 :: Int), 3 ^ (25 :: Int), 10 ^ (40 :: Int), 3 ^ (150 :: Int), 7 ^ (400 :: Int)]
  small <- elements [1 % 3, 1 % 7, 22 % 7, 1 % 1000]
  shift <- (,) <$> elements [0, 1 % 2, -large] <*> elements [0, 1 % 3, large]
  shear <- elements [0, 1, 1 % 3, -2 % 5]
  next <- oneof [pure (const (pure (0, 0))), pure (const nudge), pure (const unrelated)]
  let step = 1 / large
  moved <-
    oneof
      [ onCorners (affine large 0 shift) plain (const (pure (0, 0)))
      , onCorners (affine small shear shift) plain (const (pure (0, 0)))
      , onCorners (affine 1 0 (0, 0)) plain (fmap (both (* step)) . next)
      , onCorners (affine large 0 (0, 0)) plain next
      ]
  pure (fromMaybe plain (sample moved))
  where
    nudge = (,) <$> elements [-1, 0, 0, 1] <*> elements [-1, 0, 0, 1]
    unrelated = (,) <$> ((% 100) <$> choose (-1, 1)) <*> (((1 % 1000) *) . (1 %) <$> elements [3, 7, 11, 13])
    both f (a, b) = (f a, f b)
    affine k shear (dx, dy) (Point x y) = Point (k * (x + shear * y) + dx) (k * y + dy)

-- | Maps every corner and adds what is drawn for it.
onCorners :: (Point -> Point) -> Sample -> (Point -> Gen (Rational, Rational)) -> Gen RawScene
onCorners f (Sample raw _) extra =
  RawScene (rawName raw) <$> traverse polygon (rawEnclosure raw) <*> traverse polygon (rawPolygons raw)
  where
    polygon p = (\points -> p {rawCorners = points}) <$> traverse corner (rawCorners p)
    corner point = do
      (dx, dy) <- extra point
      let Point x y = f point
      pure (Point (x + dx) (y + dy))

-- | Fewer polygons, no room, fewer corners, smaller coordinates; valid ones only.
shrinkSample :: Sample -> [Sample]
shrinkSample (Sample raw _) =
  mapMaybe sample $
    [raw {rawPolygons = few} | few <- shrinkList (const []) (rawPolygons raw)]
      <> [raw {rawEnclosure = Nothing} | Just _ <- [rawEnclosure raw]]
      <> [raw {rawEnclosure = Just room} | Just big <- [rawEnclosure raw], room <- lessCorners 3 big]
      <> [raw {rawPolygons = ps} | ps <- oneShrunk (lessCorners 2) (rawPolygons raw)]
      <> [smaller | smaller <- map (mapped raw) simpler, smaller /= raw]
  where
    lessCorners least p =
      [p {rawForm = formOf' p points, rawCorners = points} | points <- dropOne (rawCorners p), length points >= least]
    formOf' p points = if length points == 2 then Polyline else rawForm p
    dropOne xs = [take i xs <> drop (i + 1) xs | i <- [0 .. length xs - 1]]
    oneShrunk f xs = [take i xs <> [y] <> drop (i + 1) xs | (i, x) <- zip [0 ..] xs, y <- f x]
    simpler = [rounded, halved, toOrigin]
    rounded q = fromInteger (round q)
    halved q = fromInteger (truncate (q / 2))
    toOrigin q = q - fromInteger (floor (minimum (q : coordinates)))
    coordinates = concat [[x, y] | p <- maybe id (:) (rawEnclosure raw) (rawPolygons raw), Point x y <- rawCorners p]
    mapped scene f =
      scene
        { rawEnclosure = mapPolygon f <$> rawEnclosure scene
        , rawPolygons = map (mapPolygon f) (rawPolygons scene)
        }
    mapPolygon f p = p {rawCorners = [Point (f x) (f y) | Point x y <- rawCorners p]}
