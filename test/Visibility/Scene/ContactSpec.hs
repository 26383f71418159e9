module Visibility.Scene.ContactSpec (spec) where

import Data.List (sort, sortOn)
import qualified Data.Vector.Unboxed as U
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck
import Visibility.Exact.Point (Vector2 (..))
import Visibility.Exact.SomePoints (wholePlaces)
import Visibility.Scene.Contact

spec :: Spec
spec = modifyMaxSuccess (* 20) $ do
  prop "meeting follows from where the ends lie" $
    forAll fourCorners $ \places ->
      let (r, s, t) = segments places
       in cover 5 (meeting r s t == Crossing) "crossing" $ tidy (meeting r s t) === expected places
  prop "swapping the ends of a segment changes nothing" $
    forAll fourCorners $ \places ->
      let (r, s, t) = segments places
       in tidy (meeting r s t) === tidy (meeting r (Segment 1 0) t)
            .&&. tidy (meeting r s t) === tidy (meeting r s (Segment 3 2))
  prop "swapping the segments changes nothing but names" $
    forAll fourCorners $ \places ->
      let (r, s, t) = segments places in tidy (meeting r s t) === tidy (swapped (meeting r t s))
  prop "samePlace compares places" $
    forAll fourCorners $ \places ->
      let (r, _, _) = segments places
       in [samePlace r i j | i <- [0 .. 3], j <- [0 .. 3]] === [a == b | a <- places, b <- places]
  prop "lexicographic sorts by place, and keeps the order of corners in one place" $
    forAll (choose (0, 40) >>= \n -> vectorOf n (Vector2 <$> coordinate <*> coordinate)) $ \places ->
      map fromIntegral (U.toList (lexicographic (ranked (wholePlaces places))))
        === map snd (sortOn (\(Vector2 x y, _) -> (x, y)) (zip places [0 :: Int ..]))
  it "isBelow counts a segment's left end, not its right end" $ do
    let (r, _, _) = segments [Vector2 0 5, Vector2 4 5, Vector2 0 0, Vector2 4 0]
    isBelow r 2 (Segment 0 1) `shouldBe` True
    isBelow r 2 (Segment 1 0) `shouldBe` True
    isBelow r 3 (Segment 0 1) `shouldBe` False
    isBelow r 0 (Segment 2 3) `shouldBe` False
  where
    segments places = (ranked (wholePlaces places), Segment 0 1, Segment 2 3)
    coordinate = frequency [(9, choose (0, 4)), (1, elements [0, 2 ^ (70 :: Int), 2 ^ (70 :: Int) + 1])]
    fourCorners = vectorOf 4 (Vector2 <$> coordinate <*> coordinate)
    tidy (Touching touches) = Touching (sort touches)
    tidy other = other
    swapped (Touching touches) = Touching (map swappedTouch touches)
    swapped other = other
    swappedTouch (Ends i j) = Ends j i
    swappedTouch (FirstOnSecond i) = SecondOnFirst i
    swappedTouch (SecondOnFirst i) = FirstOnSecond i

-- By determinants and dot products.
expected :: [Vector2] -> Meeting
expected places
  | cross 0 1 2 * cross 0 1 3 < 0 && cross 2 3 0 * cross 2 3 1 < 0 = Crossing
  | null touches = Apart
  | otherwise = Touching (sort touches)
  where
    touches =
      [Ends i j | i <- [0, 1], j <- [2, 3], place i == place j]
        <> [FirstOnSecond i | i <- [0, 1], liesOn i 2 3]
        <> [SecondOnFirst j | j <- [2, 3], liesOn j 0 1]
    place = (places !!)
    liesOn c a b = cross a b c == 0 && dot c a b < 0
    cross a b c = let (ux, uy) = step a b; (vx, vy) = step a c in ux * vy - uy * vx
    dot o a b = let (ux, uy) = step o a; (vx, vy) = step o b in ux * vx + uy * vy
    step a b = let (Vector2 ax ay, Vector2 bx by) = (place a, place b) in (bx - ax, by - ay)
