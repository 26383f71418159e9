-- | What work costs, told without a clock: the bytes that are allocated for each part of a result, on a scene and on
-- one with four times as many polygons. They are the same in every run, however busy the machine is. What is done over
-- and over allocates: a table made for each sum instead of once, a list gone through for each element.
--
-- Bounded is by what factor they grow, not how many they are, so that the same holds at every level of optimisation.
-- The bound leaves room for the logarithm where one is due: corners grow from about 2⁵ to 2⁷.
module Visibility.GrowthSpec (spec) where

import Control.Exception (evaluate)
import Data.Foldable (for_)
import Data.Int (Int64)
import Data.IORef (newIORef, readIORef)
import Data.ByteString.Builder (Builder, toLazyByteString)
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.Text as Text
import System.Mem (getAllocationCounter)
import Test.Hspec
import Visibility.Complex (complexOf, faceIds)
import Visibility.Complex.Law (violations)
import Visibility.Complex.Type (stretchIds)
import Visibility.Count (count)
import Visibility.Draw.Drawing (Drawing)
import Visibility.Draw.Dual (dualDrawing)
import Visibility.Draw.Matrix (factorMatrix, matrixDrawing)
import Visibility.Draw.Render (renderSvg)
import Visibility.Draw.Scene (sceneDrawing)
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.RootSum (terms)
import Visibility.Exact.Rounding (decimal, defaultDigits)
import Visibility.FormFactor
import Visibility.Format.Complex (complexDocument)
import Visibility.Format.Mesh (meshDocument)
import Visibility.Mesh
import Visibility.Radiosity
import Visibility.Scene
import Visibility.Scene.Family (Family (Ceiling, Grid, Random, Tower), Seed (..), family, size)
import Visibility.Scene.Raw
import Visibility.Scene.Validate (validate)
import Visibility.Sweep
import Visibility.Test.Adversary
import Visibility.Test.Mistake (mistaken, mistakeName)
import Visibility.Test.Part
import Visibility.View (events)

spec :: Spec
spec = do
  describe "bytes allocated, on squares in a row" $
    it "grow in proportion to the pairs of the topological sweep, most of which are on two lines" $
      growth (Just . adversary Row) checked (\s -> Just (pairsOf s (vertices s))) >>= shouldBeSlow
  for_ [Random, Grid] $ \kind ->
    describe ("bytes allocated, on scenes of the family " <> show kind) $ do
      let grow name prepare work =
            it ("grow in proportion to " <> name) (growth (scenesOf kind) prepare work >>= shouldBeSlow)
      grow "the corners that are checked" Just (fmap cornerCount . checked)
      grow "the pairs of the topological sweep" checked (\s -> Just (pairsOf s (vertices s)))
      grow "the pairs of the straight sweep" checked (\s -> Just (pairsOf s (straightVertices s)))
      grow "the faces of the complex" checked (Just . length . faceIds . complexOf)
      grow "the pairs that are added up to measures" checked $ \s ->
        let swept = vertices s in measures s swept `seq` Just (pairsOf s swept)
      grow "the form factors that are rounded to 17 digits, from exact sums" summed $ \(Summed s sums) ->
        Just (sum (map (signum . length . decimal defaultDigits . factorValue) (formFactors s sums)))
      grow "the form factors that are told with their exact measures" summed $ \(Summed s sums) ->
        Just (sum [signum (length (terms area)) | row <- exactFactors defaultDigits s sums, (_, (_, area)) <- rowFactors row])
      grow "the form factors that are nearest Doubles" summed $ \(Summed s sums) ->
        Just (sum (map (length . rowFactors) (nearestFactors s sums)))
      grow "the form factors of the equations of radiosity" summed $ \(Summed s sums) ->
        either (const Nothing) (Just . nonzeroFactors) (radiosity (WithinTolerance defaultTolerance) s sums)
      grow "the break points of the discontinuity mesh" checked $ \s ->
        Just (breakCount (discontinuityMesh s (vertices s)))
      grow "its elements" checked $ \s ->
        Just (length (refinedElements (refined (discontinuityMesh s (vertices s)))))
  for_ [InOnePoint, InOnePointClosed, WallsInOnePoint, Saw, Row, Slalom, WallRow, FlatCorners] $ \kind ->
    describe ("bytes allocated, where much is in one place or on one line, on scenes of the kind " <> adversaryName kind) $ do
      let grow what times prepare work =
            it ("grow in proportion to " <> what) $
              growth (Just . adversary kind . (times *)) prepare work >>= shouldBeSlow
          statedTotal = length . statedCorners
      grow "the corners that are checked" 1 Just (fmap statedTotal . checked)
      grow "the corners and the pairs that are swept" 1 checked $ \s -> Just (statedTotal s + pairsOf s (vertices s))
      -- To tell a name costs little, so it takes more of them to be seen.
      grow "the corners and the pairs that are counted, whatever they are called" 8 checked $ \s ->
        let swept = vertices s
            counts = count s (events s swept)
         in counts `seq` Just (statedTotal s + pairsOf s swept)
  for_ adversaries $ \kind ->
    describe ("bytes allocated, on scenes of the kind " <> adversaryName kind) $ do
      let grow what prepare work =
            it ("grow in proportion to " <> what) (growth (Just . adversary kind) prepare work >>= shouldBeSlow)
      grow "the stretches that are verified" checked $ \s ->
        let complex = complexOf s in if null (violations complex) then Just (length (stretchIds complex)) else Nothing
      grow "the bytes of the complex" checked $ Just . written . complexDocument . complexOf
      -- A break point is written in about 100 bytes, and in more where it has many digits.
      grow "the pairs that are swept and the break points, by their digits" checked $ \s ->
        let mesh = discontinuityMesh s (vertices s)
         in Just (pairsOf s (vertices s) + written (meshDocument mesh mesh) `div` 100)
      grow "the cells of the matrix" summed $ \(Summed s sums) ->
        let factors = nearestFactors s sums
         in drawn (matrixDrawing (factorMatrix s factors)) `seq` Just (sum (map (length . rowFactors) factors))
      grow "the pairs of the dual figure" checked $ \s ->
        drawn (dualDrawing s (events s (vertices s))) `seq` Just (pairsOf s (vertices s))
  for_ harmless $ \(kind, few, many) ->
    describe ("bytes allocated, on scenes of the kind " <> kind) $ do
      it "grow in proportion to the corners that are checked" $
        growing few many Just (fmap cornerCount . checked) >>= shouldBeSlow
      for_ (filter ((`elem` wholeCommands) . partName) parts) $ \part ->
        it ("grow in proportion to input and output of " <> partName part) $
          growing few many checked (\s -> Just (sceneUnits s + writtenUnits (partBytes part s))) >>= shouldBeSlow
  describe "bytes allocated for all that is wrong with a scene" $ do
    let grow what scenes =
          it (what <> " grow in proportion to its corners and what is wrong") $
            growth (Just . scenes) Just (\raw -> either (Just . (cornersIn raw +) . length) (const Nothing) (validate raw))
              >>= shouldBeSlow
        bodies :: (Int -> [(Int, Int)]) -> Int -> RawScene
        bodies outlineOf n = RawScene Nothing Nothing [rawPolygon (map point (outlineOf k)) | k <- [0 .. n - 1]]
        point (x, y) = Point (fromIntegral x) (fromIntegral y)
        one <+> other = one {rawPolygons = rawPolygons one <> rawPolygons other}
        -- All corners of it are on a parabola, those that follow each other far away.
        jumping n = bodies (const [(x, x * x) | k <- [0 .. n], let x = k * (n `div` 2) `mod` (n + 1)]) 1
        chevron k = [(-400, 4 * k), (0, 4 * k + 800), (400, 4 * k), (0, 4 * k + 802)]
        shifted by = map (\(x, y) -> (x + by, y))
        nested k = shifted (900 + 9 * (k - k `mod` 2)) (if even k then [(0, 0), (8, 0), (0, 8)] else [(1, 1), (2, 1), (1, 2)])
    for_ [minBound .. maxBound] $ \kind -> grow (mistakeName kind) (mistaken kind)
    grow "a polygon of which each side crosses most others" jumping
    grow "triangles in one point of which each overlaps the next" (bodies (\k -> [(0, 0), (2 * k, 999), (2 * k + 3, 999)]))
    grow "bent polygons within the boxes of others, and four that are inside of others" $ \n ->
      bodies chevron n <+> bodies nested 8
  describe "bytes allocated, on scenes with a long name" $
    it "grow in proportion to the name, in a figure that has no room for it" $
      growth (\n -> named (100 * n) <$> scenesOf Random 2) checked namedFigure
        >>= shouldBeSlow
  where
    adversaries = [ConvexRoom, Star, NeedleFan]
    harmless =
      [ (adversaryName kind, Just (adversary kind 16), Just (adversary kind 64))
      | kind <- [OneContact, Column, Slalom, WallRow, Spiral]
      ]
        <> [(show kind, scenesOf kind 4, scenesOf kind 8) | kind <- [Ceiling, Tower]]
    wholeCommands = ["info", "graph", "graph --scheduler straight", "complex", "factors", "factors --exact", "mesh"]
    cornersIn = sum . map cornerTotal . rawPolygons
    written = fromIntegral . Lazy.length . toLazyByteString :: Builder -> Int
    drawn = fromIntegral . Lazy.length . renderSvg :: Drawing -> Int
    namedFigure s = drawn (sceneDrawing s (vertices s)) `seq` (Text.length <$> sceneTitle s)
    named n raw = raw {rawName = Just (Text.replicate n (Text.pack "x"))}
    pairsOf s = sum . map (length . vertexPairs s)
    scenesOf kind n = alight . (\k -> family kind k (Seed 1)) <$> size n

-- | A scene with its measures.
data Summed = Summed !Scene !Measures

checked :: RawScene -> Maybe Scene
checked = either (const Nothing) Just . validate

summed :: RawScene -> Maybe Summed
summed raw = do
  scene <- checked raw
  Just (Summed scene (measures scene (vertices scene)))

-- | The bytes allocated for each part, few polygons first.
data Growth = Growth Double Double
  deriving (Show)

-- | Less than a quarter more.
shouldBeSlow :: Maybe Growth -> Expectation
shouldBeSlow found = found `shouldSatisfy` maybe False (\(Growth few many) -> few > 0 && many < 1.25 * few)

-- | Of a piece of work, which tells of how many parts its result is. What it begins with is made before.
growth :: (Int -> Maybe RawScene) -> (RawScene -> Maybe a) -> (a -> Maybe Int) -> IO (Maybe Growth)
growth scenes = growing (scenes 12) (scenes 48)

-- | The same, from a small scene to a large one.
growing :: Maybe RawScene -> Maybe RawScene -> (RawScene -> Maybe a) -> (a -> Maybe Int) -> IO (Maybe Growth)
growing small large prepare work = do
  few <- bytes small
  many <- bytes large
  pure (Growth <$> few <*> many)
  where
    bytes scene = case scene >>= prepare of
      Nothing -> pure Nothing
      Just begun -> do
        (allocated, pieces) <- allocation begun work
        pure (fmap (\k -> fromIntegral allocated / fromIntegral k) pieces)

-- | How many bytes a thread allocates for a result, and the result. What it begins with comes out of a cell, so that
-- nothing is known of it beforehand.
allocation :: a -> (a -> Maybe b) -> IO (Int64, Maybe b)
allocation argument work = do
  cell <- evaluate argument >>= newIORef
  begun <- getAllocationCounter
  result <- readIORef cell >>= evaluate . work
  mapM_ evaluate result
  finished <- getAllocationCounter
  -- It counts downwards.
  pure (begun - finished, result)
