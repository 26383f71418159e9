module Visibility.Scene.OutlineSpec (spec) where

import Data.List (nub, sort)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Test.Hspec hiding (around)
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Visibility.Scene.Id
import Visibility.Scene.Outline
import Visibility.Scene.Raw
import Visibility.Scene.Sample

spec :: Spec
spec = do
  describe "a form" $
    it "is a ring for an enclosure, a wall for two corners, else what is stated" $ do
      let corners n = [at (fromIntegral k) (fromIntegral (k * k)) | k <- [1 .. n :: Int]]
          forms p = [formOf (p, made (corners n)) | made <- [rawPolygon, rawWall], n <- [2, 3]]
      forms (Obstacle 0) `shouldBe` [Polyline, Ring, Polyline, Polyline]
      forms Enclosure `shouldBe` [Ring, Ring, Ring, Ring]
      map (fewestCorners . (,) (Obstacle 0) . rawWall . corners) [2, 3] `shouldBe` [2, 2]
      fewestCorners (Enclosure, rawPolygon (corners 2)) `shouldBe` 3
  describe "an outline" $ do
    prop "has the corners of all polygons, in the file's order, each under its name" $
      forAllOutlines $ \shapes o ->
        [(cornerNameOf o i, outlinePoint o i) | p <- polygonIndices o, i <- cornersOf o p]
          === [(CornerName p k, point) | (p, polygon) <- shapes, (k, point) <- zip [0 ..] (rawCorners polygon)]
    prop "leads around each polygon, and back" $
      forAllOutlines $ \_ o ->
        conjoin
          [ (take (length is) (iterate (around o 1) i) === take (length is) (drop k (cycle is)))
              .&&. around o (-1) (around o 1 i) === i
              .&&. around o (length is) i === i
          | p <- polygonIndices o
          , let is = cornersOf o p
          , (k, i) <- zip [0 ..] is
          ]
    prop "has a segment for each side of a ring, and for each two faces of a wall" $
      forAllOutlines $ \shapes o ->
        let firsts = sideFirsts o
            fromFirst p = map (subtract (firsts U.! p))
         in [ ( map (sideNameOf o) starts
              , fromFirst p (map (sideNumberOf o firsts) starts)
              , [k | Polyline <- [outlineForms o V.! p], k <- fromFirst p (map (backSideNumberOf o firsts) starts)]
              )
            | p <- polygonIndices o
            , let starts = segmentStarts o p
            ]
              === [ case formOf shape of
                      Ring -> (names p [0 .. n - 1], [0 .. n - 1], [])
                      Polyline -> (names p [0 .. n - 2], [0 .. n - 2], [2 * n - 3, 2 * n - 4 .. n - 1])
                  | shape@(p, polygon) <- shapes
                  , let n = length (rawCorners polygon)
                  ]
    prop "joins each corner to the ends of the segments there" $
      forAllOutlines $ \_ o ->
        conjoin
          [ joinedTo o i === (ending [around o 1 s | s <- starts, s == i], ending [s | s <- starts, around o 1 s == i])
          | p <- polygonIndices o
          , let starts = segmentStarts o p
          , i <- cornersOf o p
          ]
    prop "has all corners in the order of their places, and numbers these" $
      forAllOutlines $ \_ o ->
        let is = concatMap (cornersOf o) (polygonIndices o)
            places = sort (map (placeOf o) is)
            order = map fromIntegral (U.toList (outlineOrder o))
         in map (placeOf o) order === places
              .&&. sort order === is
              .&&. map (placeOf o) is === map ((nub places !!) . numberOf o) is
              .&&. (outlineTotal o, placeTotal o) === (length is, length (nub places))
    prop "orders places as points are ordered" $
      forAllOutlines $ \_ o ->
        let is = concatMap (cornersOf o) (polygonIndices o)
            point i = outlinePoint o i
         in conjoin [compare (placeOf o i) (placeOf o j) === compare (point i) (point j) | i <- is, j <- is]
  where
    names p = map (SideName p)
    ending = foldr const noCorner
    forAllOutlines check =
      forAll (clutteredScenes `suchThat` (not . null . bodies)) $ \raw -> check (bodies raw) (outline (bodies raw))
    bodies raw = [shape | shape@(_, polygon) <- polygonsOf raw, length (rawCorners polygon) >= fewestCorners shape]
