{-# LANGUAGE OverloadedStrings #-}

module Visibility.Draw.MatrixSpec (spec) where

import Data.Foldable (for_)
import Data.List (nub, sort, sortOn)
import qualified Data.Map.Strict as Map
import qualified Data.Text as Text
import Test.Hspec
import Test.QuickCheck hiding (total)
import Visibility.Draw.Colour
import Visibility.Draw.Checks
import Visibility.Draw.Drawing
import Visibility.Draw.Gallery
import Visibility.Draw.Matrix
import Visibility.FormFactor
import Visibility.Scene
import Visibility.Sweep
import Visibility.Test.Generator

spec :: Spec
spec = do
  describe "every scene in scenes/" $
    withGallery $ \name scene -> legible name (drawn scene)
  describe "of any scene" $ do
    it "every factor that is not exactly zero has one cell, all else is blank" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            exact = map factorName (exactly scene)
         in sort (map markName (marksIn "cells" (drawn scene))) === sort exact
    it "a larger factor is not lighter" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            coloured = Map.fromList [(name, shade) | Mark name (Cell shade) _ <- marksIn "cells" (drawn scene)]
            byValue = [Map.lookup (factorName factor) coloured | factor <- sortOn factorValue (exactly scene)]
         in counterexample (show byValue) (and (zipWith (>=) byValue (drop 1 byValue)))
    it "no label covers anything, and nothing leaves the canvas" $
      property $ \(AnyScene s) ->
        isLegible (drawn (sampleScene s))
  describe "of any matrix" $ do
    it "cells are squares of one size, in the row and the column of their names" $
      forAllShow matrices shown $ \matrix ->
        let squares =
              [ (words (Text.unpack name), Box l b r t)
              | Mark name (Cell _) (Region [Place l b, Place r _, Place _ t, _]) <- cellsOf matrix
              ]
            sizes = concat [[r - l, t - b] | (_, Box l b r t) <- squares]
            lefts = nub (sort [(read column :: Int, rounded l) | ([_, column], Box l _ _ _) <- squares])
            tops = nub (sort [(read row :: Int, rounded (negate t)) | ([row, _], Box _ _ _ t) <- squares])
         in conjoin
              [ length squares === length (matrixEntries matrix)
              , counterexample (show sizes) (and [abs (a - b) < 1e-6 && a > 0 | (a, b) <- zip sizes (drop 1 sizes)])
              , counterexample (show (lefts, tops)) (all (all rising . neighbours) [lefts, tops])
              ]
    it "no line between groups runs through the inside of a cell" $
      forAllShow (oneof [matrices, crowded]) shown $ \matrix ->
        [ (name, segment)
        | Mark name (Cell _) (Region [Place l b, Place r _, Place _ t, _]) <- cellsOf matrix
        , segment <- concatMap strokes (marksIn "groups" (matrixDrawing matrix))
        , segmentMeetsBox (Box l b r t) segment
        ]
          === []
    it "has a line between any two neighbouring groups, where all cells are large" $
      forAllShow matrices shown $ \matrix ->
        length (marksIn "groups" (matrixDrawing matrix))
          === length (drop 1 (matrixRows matrix)) + length (drop 1 (matrixColumns matrix))
    it "has lines that are at least six pixels from each other, however small its groups" $
      forAllShow (oneof [matrices, crowded]) shown $ \matrix ->
        let (across, down) = linesOf matrix
            apart list = and (zipWith (\a b -> b - a >= 6) list (drop 1 list))
         in counterexample (show (across, down)) (apart (sort across) && apart (sort down))
    it "has lines between wholes, and between large parts of them, but none that hatch small parts" $ do
      let object = [Group (Text.pack ("0." <> show k)) "0" [k] | k <- [0 .. 99 :: Int]]
          wall = [Group (Text.pack ("E." <> show k)) "E" [100 + 50 * k .. 149 + 50 * k] | k <- [0 .. 3]]
          matrix = matrixOf (object <> wall) (object <> wall) []
          -- The lines are as far from each other as the groups between them, but for their own room.
          (across, down) = linesOf matrix
          steps list = zipWith (\a b -> round ((b - a) / 10) :: Int) list (drop 1 list)
      map (steps . sort) [across, down] `shouldBe` replicate 2 [12, 12, 12]
    it "an entry that is too small for a Double is as light as can be, but not blank" $ do
      let groups = [Group "a" "a" [0, 1 :: Int]]
          matrix = matrixOf groups groups [(0, 0, 0), (0, 1, 1e-5), (1, 0, 1)]
          found = Map.fromList [(name, position shade) | Mark name (Cell shade) _ <- cellsOf matrix]
      found `shouldBe` Map.fromList [("0 0", 1), ("0 1", 1), ("1 0", 0)]
    it "labels a matrix of a thousand groups where there is room" $ do
      let groups = [Group (Text.pack (show k)) (Text.pack (show k)) [k] | k <- [0 .. 999 :: Int]]
          drawing = matrixDrawing (matrixOf groups groups [(k, k, 1) | k <- [0 .. 999]])
      labelCollisions drawing `shouldBe` []
      strayMarks drawing `shouldBe` []
      length (marksIn "groups" drawing) `shouldBe` 0
      length (marksIn "labels" drawing) `shouldSatisfy` (> 40)
    it "is an empty square without rows" $ do
      let drawing = matrixDrawing (matrixOf [] [] ([] :: [(Int, Int, Double)]))
      (labelCollisions drawing, strayMarks drawing) `shouldBe` ([], [])
  describe "golden drawings" $
    for_ goldenScenes $ \(name, raw) ->
      it name $ withValid raw $ \scene -> drawn scene `shouldBeListedIn` (name <> "-matrix.txt")
  where
    drawn scene = matrixDrawing (factorMatrix scene (nearestFactors scene (swept scene)))
    swept scene = measures scene (vertices scene)
    exactly scene = formFactors scene (swept scene)
    factorName factor = Text.pack (sideText (factorFrom factor) <> " " <> seenText (factorTo factor))
    cellsOf matrix = marksIn "cells" (matrixDrawing matrix)
    -- The lines between columns by how far they are to the right, and those between rows by how far they are down.
    linesOf matrix =
      let ways = [way | Mark _ _ (Polyline way) <- marksIn "groups" (matrixDrawing matrix)]
       in ([x | [Place x _, Place x' _] <- ways, x == x'], [negate y | [Place _ y, Place _ y'] <- ways, y == y'])
    shown matrix = show (matrixRows matrix, matrixColumns matrix, matrixEntries matrix)
    rounded x = fromIntegral (round (x * 1e6) :: Int) / 1e6 :: Double
    neighbours list = zip list (drop 1 list)
    rising ((i, x), (j, y)) = i < j && x < y

-- | Numbers in groups, of which some neighbours are parts of one whole.
matrices :: Gen (Matrix Int)
matrices = do
  rows <- grouped (resize 8 (listOf1 (choose (1, 7))))
  columns <- grouped (resize 8 (listOf1 (choose (1, 7))))
  entries <- sublistOf [(r, c) | r <- concatMap groupMembers rows, c <- concatMap groupMembers columns]
  matrixOf rows columns <$> traverse (\(r, c) -> (,,) r c . (10 **) <$> choose (-9, 0)) entries

-- | Hundreds of numbers in large and in small groups, with few entries.
crowded :: Gen (Matrix Int)
crowded = do
  rows <- grouped sizes
  columns <- grouped sizes
  let members = concatMap groupMembers
  matrixOf rows columns . map (\(r, c) -> (r, c, 1))
    <$> (nub <$> vectorOf 20 ((,) <$> elements (members rows) <*> elements (members columns)))
  where
    sizes = choose (2, 80) >>= \n -> vectorOf n (frequency [(3, choose (1, 4)), (1, choose (5, 60))])

grouped :: Gen [Int] -> Gen [Group Int]
grouped someSizes = do
  sizes <- someSizes
  wholes <- scanl1 (+) <$> vectorOf (length sizes) (choose (0, 1 :: Int))
  pure
    [ Group (Text.pack ("g" <> show s)) (Text.pack ("w" <> show w)) [s .. s + n - 1]
    | (s, n, w) <- zip3 (scanl (+) 0 sizes) sizes wholes
    ]

matrixOf :: [Group Int] -> [Group Int] -> [(Int, Int, Double)] -> Matrix Int
matrixOf rows columns =
  Matrix "a matrix" "quantity" "numbers" "groups" rows columns (Text.pack . show)
