module Visibility.Scene.DisjointSpec (spec) where

import Data.List (nub, tails)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck
import Visibility.Exact.Point (Vector2 (..), wholePlaces)
import Visibility.Scene.Contact
import Visibility.Scene.Disjoint

spec :: Spec
spec = modifyMaxSuccess (* 20) $ do
  prop ("boundaries: Meet exactly when meeting is not Apart for two segments without a common corner, "
         <> "or two corners are in one place") $
    forAll walls $ \places -> agrees places [Segment i (i + 1) | i <- [0, 2 .. length places - 2]]
  prop "the same for triangles" $
    forAll triangles $ \places ->
      agrees places $
        concat [[Segment i (i + 1), Segment (i + 1) (i + 2), Segment (i + 2) i] | i <- [0, 3 .. length places - 3]]
  prop "the same for a line of segments" $
    forAll paths $ \places -> agrees places [Segment i (i + 1) | i <- [0 .. length places - 2]]
  where
    agrees places segments =
      let r = ranked (wholePlaces places)
          used = [0 .. length places - 1]
          meets =
            or [samePlace r i j | i <- used, j <- used, i < j]
              || or [meeting r s t /= Apart | s : later <- tails segments, t <- later, apart s t]
       in cover 5 meets "meet" $
            cover 10 (not meets) "disjoint" $
              boundaries r segments === (if meets then Meet else Disjoint)
    apart (Segment a b) (Segment c d) = all (`notElem` [c, d]) [a, b]
    place width = Vector2 <$> choose (0, width) <*> choose (0, width)
    walls = do
      (n, width) <- elements [(3, 3), (6, 9), (6, 60), (30, 100), (30, 2 ^ (40 :: Int))]
      k <- choose (0, n)
      concat <$> vectorOf k (near width 2)
    triangles = do
      n <- choose (0, 4)
      width <- elements [6, 12, 60]
      concat <$> vectorOf n (near width 3 `suchThat` hasArea)
    -- Corners near to each other, so that some scenes are disjoint.
    near :: Integer -> Int -> Gen [Vector2]
    near width n = do
      Vector2 x y <- place width
      reach <- elements [2, 4, 9]
      let corner = (\(Vector2 dx dy) -> Vector2 (x + dx) (y + dy)) <$> place reach
      vectorOf n corner `suchThat` (\c -> length (nub c) == n)
    paths = do
      n <- choose (2, 7)
      width <- elements [4, 9]
      (scanl1 plus <$> vectorOf n (place width)) `orJumble` vectorOf n (place width) `suchThat` hasNoSpike
    orJumble a b = oneof [a, b]
    plus (Vector2 x y) (Vector2 dx dy) = Vector2 (x + dx) (y + 4 - dy)
    hasArea [a, b, c] = cross a b c /= 0
    hasArea _ = False
    hasNoSpike path = and (zipWith3 isOpen path (drop 1 path) (drop 2 path)) && and (zipWith (/=) path (drop 1 path))
    isOpen a b c = cross a b c /= 0 || dot b a c < 0
    cross (Vector2 ax ay) (Vector2 bx by) (Vector2 cx cy) = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    dot (Vector2 ox oy) (Vector2 ax ay) (Vector2 bx by) = (ax - ox) * (bx - ox) + (ay - oy) * (by - oy)
