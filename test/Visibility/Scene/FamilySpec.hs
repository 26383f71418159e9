module Visibility.Scene.FamilySpec (spec) where

import Control.Monad (forM_)
import Data.Either (isRight)
import Data.List (nub)
import Data.Maybe (isJust, mapMaybe)
import Data.Ratio (denominator)
import qualified Data.Text as Text
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck
import Visibility.Exact.Point
import Visibility.Scene (sceneContacts)
import Visibility.Scene.Family
import Visibility.Scene.Raw
import Visibility.Scene.Validate (validate)
import Visibility.Sweep
import Visibility.Test.Generator (sizeOfCorners)

spec :: Spec
spec = do
  describe "names" $ do
    it "lead back to their families" $
      map (familyNamed . familyName) [minBound ..] `shouldBe` map Just [minBound ..]
    it "are the promised ones, and no others" $ do
      map familyName [minBound ..]
        `shouldBe` map Text.pack ["random", "sparse", "grid", "room", "comb", "thin-walls", "needles", "kettner"
            , "checkerboard", "terraces", "maze", "ceiling", "tower"]
      familyNamed (Text.pack "Random") `shouldBe` Nothing
    it "come with a line of purpose each" $
      [ Text.length (Text.strip (familyPurpose kind)) > 10 && not (Text.any (== '\n') (familyPurpose kind))
      | kind <- [minBound ..]
      ]
        `shouldBe` map (const True) [minBound .. maxBound :: Family]
  describe "a size" $
    it "is at least 1" $
      map (fmap sizeCount . size) [-1, 0, 1, 2] `shouldBe` [Nothing, Nothing, Just 1, Just 2]
  describe "a scene" $ do
    forM_ [minBound ..] $ \kind -> describe (Text.unpack (familyName kind)) $ do
      modifyMaxSuccess (`div` 2) $
        it "is valid" $
          property $ \seed -> forAll (choose (1, sizeOfCorners kind 600)) $ \n -> onSize n $ \s ->
            isRight (validate (family kind s (Seed seed)))
      it "has as many polygons as its size says" $
        property $ \seed -> forAll (choose (1, 60)) $ \n -> onSize n $ \s ->
          length (rawPolygons (family kind s (Seed seed)))
            === (case kind of Comb -> 2; Kettner -> n + 2; Ceiling -> n + 2; Tower -> 2; _ -> n)
      it "depends on its seed, if it is drawn at random" $
        [ allCorners (family kind s (Seed 1)) == allCorners (family kind s (Seed 2))
        | s <- mapMaybe size [5]
        ]
          `shouldBe` [kind `elem` [Grid, Checkerboard, Terraces, Ceiling, Tower]]
      it "carries its family, size and seed as its name" $
        [rawName (family kind s (Seed 7)) | s <- mapMaybe size [5]]
          `shouldBe` [Just (Text.append (familyName kind) (Text.pack "-5-7"))]
    forM_ (filter (/= Kettner) [minBound ..]) $ \kind -> describe (Text.unpack (familyName kind)) $ do
      it "has integer coordinates" $
        property $ \seed -> forAll (choose (1, 60)) $ \n -> onSize n $ \s ->
          all (\(Point x y) -> denominator x == 1 && denominator y == 1) (allCorners (family kind s (Seed seed)))
      it "stays within machine integers up to 2^14 corners" $
        [ extent (family kind s (Seed seed)) < 2 ^ (31 :: Int)
        | seed <- [0, 1]
        , s <- mapMaybe size [sizeOfCorners kind (2 ^ (14 :: Int))]
        ]
          `shouldBe` [True, True]
    forM_ (filter (`notElem` [Comb, Ceiling, Tower]) [minBound ..]) $ \kind ->
      it (Text.unpack (familyName kind) <> " begins with the polygons of the smaller ones") $
        property $ \seed -> forAll (choose (1, 40)) $ \n -> forAll (choose (1, 40)) $ \more ->
          onSize n $ \s -> onSize (n + more) $ \t ->
            let loops = map rawCorners (rawPolygons (family kind s (Seed seed)))
             in loops === take (length loops) (map rawCorners (rawPolygons (family kind t (Seed seed))))
  describe "the kinds" $ do
    it "are what they are called" $ do
      turnsOf Random `shouldBe` [4]
      turnsOf Sparse `shouldBe` [4]
      turnsOf Grid `shouldBe` [4]
      turnsOf ThinWalls `shouldBe` [2]
      turnsOf Needles `shouldBe` [3]
      turnsOf Kettner `shouldBe` [3]
      turnsOf Checkerboard `shouldBe` [4]
      turnsOf Terraces `shouldBe` [4]
      turnsOf Maze `shouldBe` [2]
      turnsOf Comb `shouldBe` [4 * 9 + 4]
      turnsOf Ceiling `shouldBe` [9 * 9 + 9 + 2, 2]
      turnsOf Tower `shouldBe` [9 * 9 + 9 + 2, 9 + 1 + 3]
      map (isJust . rawEnclosure . sceneOf) [minBound ..] `shouldBe` map (== Room) [minBound ..]
    it "touch where they are made to touch, and nowhere else" $
      [kind | kind <- [minBound ..], Right scene <- [validate (sceneOf kind)], sceneContacts scene > 0]
        `shouldBe` [Checkerboard, Terraces, Maze]
    it "random has some 150 000 visible pairs at size 1000" $
      [pairs | pairs <- map (pairsOf Random 1000) [1], pairs < 135000 || pairs > 165000] `shouldBe` []
    it "random keeps its pairs per corner, sparse multiplies them" $ do
      growth Random `shouldSatisfy` (< 1.6)
      growth Sparse `shouldSatisfy` (> 3)
    it "ceiling and tower have 2.5 to 6 pairs for each of N*N corners" $
      [ (kind, n, pairs)
      | kind <- [Ceiling, Tower]
      , n <- [8, 16, 32]
      , let pairs = pairsOf kind n 1
      , 2 * pairs < 5 * n * n || pairs > 6 * n * n
      ]
        `shouldBe` []
    it "are the same for all time" $
      [take 2 (allCorners (family kind s (Seed 1))) | s <- mapMaybe size [3], kind <- [Random, Needles]]
        `shouldBe` [[Point 2480261 2848757, Point 1888991 1468827], [Point 3931 13, Point 218 16]]
  where
    onSize n f = maybe (property False) (property . f) (size n)
    allCorners raw = concatMap rawCorners (maybe id (:) (rawEnclosure raw) (rawPolygons raw))
    extent raw = (maximum xs - minimum xs) `max` (maximum ys - minimum ys)
      where
        xs = [x | Point x _ <- allCorners raw]
        ys = [y | Point _ y <- allCorners raw]
    sceneOf kind = maybe (RawScene Nothing Nothing []) (\s -> family kind s (Seed 3)) (size 9)
    turnsOf kind = nub (map (length . rawCorners) (rawPolygons (sceneOf kind)))
    pairsOf kind n seed =
      sum
        [ length (vertexPairs scene v)
        | Just s <- [size n]
        , Right scene <- [validate (family kind s (Seed seed))]
        , v <- vertices scene
        ]
    growth kind = fromIntegral (pairsOf kind 200 1) / fromIntegral (4 * pairsOf kind 50 1) :: Double
