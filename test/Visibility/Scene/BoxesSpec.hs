module Visibility.Scene.BoxesSpec (spec) where

import Data.List (sort)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck
import Visibility.Scene.Boxes

spec :: Spec
spec = modifyMaxSuccess (* 5) $ do
  prop "boxesOverlap: they share a point" $
    forAll ((,) <$> box 4 <*> box 4) $ \(a, b) -> boxesOverlap a b === any (`elem` pointsIn b) (pointsIn a)
  prop "boxSurrounds: every point of the one is in the other, and on no side of it" $
    forAll ((,) <$> box 4 <*> box 2) $ \(Box l r b t, inner) ->
      let a = Box l r b t
       in cover 5 (boxSurrounds a inner) "surrounds" $
            boxSurrounds a inner === all (`elem` pointsIn (Box (l + 1) (r - 1) (b + 1) (t - 1))) (pointsIn inner)
  prop "foldBoxes gives the boxes around a box" $
    forAll ((,) <$> manyBoxes <*> box 20) $ \(boxes, inner) ->
      sort (foldBoxes (`boxSurrounds` inner) (flip (:)) [] (boxTree boxes))
        === [i | (i, b) <- zip [0 ..] boxes, b `boxSurrounds` inner]
  prop "enclosingBox contains all, and is the smallest that does" $
    forAll (listOf1 (box 9)) $ \boxes ->
      let least part = minimum (map part boxes)
          greatest part = maximum (map part boxes)
       in enclosingBox boxes === Box (least boxLeft) (greatest boxRight) (least boxBottom) (greatest boxTop)
  it "a box around nothing overlaps nothing" $
    boxesOverlap (enclosingBox []) (Box (-1000) 1000 (-1000) 1000) `shouldBe` False
  where
    pointsIn (Box l r b t) = [(x, y) | x <- [l .. r], y <- [b .. t]]
    manyBoxes = do
      n <- choose (0, 80)
      width <- elements [3, 20, 200]
      vectorOf n (box width)
    box :: Int -> Gen Box
    box width = do
      x <- choose (0, width)
      y <- choose (0, width)
      w <- choose (0, 4)
      h <- choose (0, 4)
      pure (Box x (x + w) y (y + h))
