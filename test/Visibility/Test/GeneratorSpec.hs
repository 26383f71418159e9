module Visibility.Test.GeneratorSpec (spec) where

import Data.Either (isRight)
import Data.List (nub)
import Test.Hspec
import Test.QuickCheck hiding (sample)
import Visibility.Scene
import Visibility.Scene.Validate (validate)
import Visibility.Test.Feature
import Visibility.Test.Generator
import Visibility.Test.Shape

spec :: Spec
spec = do
  describe "generated scenes" $ do
    it "are valid" $
      property $ \(AnyScene s) -> isRight (validate (sampleRaw s))
    it "show as what they were made from" $
      property $ \(AnyScene s) -> sampleText (sampleRaw s) === show s
    it "have everything that is hard, often enough" $
      checked $ \(AnyScene s) ->
        let found = features s
            often percent feature = cover percent (feature `elem` found) (show feature)
         in often 30 DegenerateVertex
              . often 10 BothFlanks
              . often 10 LongVertex
              . often 30 VerticalVertex
              . often 30 ParallelVertices
              . often 15 InRoom
              . often 5 NonConvexRoom
              . often 20 ThinWall
              . often 3 WallInLine
              . often 5 NonConvexObstacle
              . often 8 FlatCorner
              . often 50 ByMachine
              . often 8 ByFilter
              . often 3 ByIntegers
              . often 4 Fractions
              . often 2 Alone
              . often 30 CornerOnCorner
              . often 10 ManyCorners
              . often 20 CornerOnSide
              . often 20 SideOnSide
              . often 20 CoveredSide
              . often 9 Pocket
              . often 8 AtEnclosure
              . often 6 BentWall
              . often 2.5 WallJunction
              . often 20 WallOnPolygon
              . often 13 SplitEnd
              $ True
    it "that touch have all kinds of contacts, often enough, and all else that is hard" $
      checked $ \(TouchingScene s) ->
        let found = features s
            often percent feature = cover percent (feature `elem` found) (show feature)
         in often 80 CornerOnCorner
              . often 35 ManyCorners
              . often 45 CornerOnSide
              . often 60 SideOnSide
              . often 60 CoveredSide
              . often 30 Pocket
              . often 22 AtEnclosure
              . often 22 BentWall
              . often 8 WallJunction
              . often 55 WallOnPolygon
              . often 32 SplitEnd
              . often 7 NonConvexRoom
              . often 6 NonConvexObstacle
              . often 50 FlatCorner
              . often 11 WallInLine
              . often 35 BothFlanks
              . often 40 LongVertex
              $ True
    it "that are hard are beyond machine integers or fractional, often enough" $
      checked $ \(HardScene s) ->
        let found = features s
            often percent feature = cover percent (feature `elem` found) (show feature)
         in often 40 ByFilter . often 20 ByIntegers . often 20 Fractions $ True
    it "that are small have few corners" $
      property $ \(SmallScene s) -> cornerCount (sampleScene s) <= 40
    it "that are convex turn left at every corner" $
      property $ \(ConvexScene s) -> [f | f <- features s, f `elem` [NonConvexObstacle, FlatCorner, InRoom]] === []
  describe "shrunk scenes" $ do
    it "are valid and other than before" $
      property $ \(AnyScene s) ->
        conjoin
          [ counterexample (show t) (isRight (validate (sampleRaw t)) && sampleRaw t /= sampleRaw s)
          | t <- shrinkSample s
          ]
    it "come to an end" $
      property $ \(AnyScene s) -> forAll (choose (0, 5)) $ \k ->
        let once' = concatMap (take 1 . drop k . cycle' . shrinkSample)
         in length (takeWhile (not . null) (take 3000 (iterate once' [s]))) < 3000
  describe "shapes" $ do
    it "hulls hold all points and turn left" $
      property $ \points ->
        let loop = hull points
         in length loop > 2 ==>
              conjoin
                [ counterexample (show (a, b, c)) (leftOf a b c || onLine a b c)
                | (a, b) <- zip loop (drop 1 (cycle loop))
                , c <- points
                ]
    it "untangling loses no corner" $
      property $ \points -> let ps = take 8 (nub points) in length (nub (untangled ps)) === length ps
  where
    -- Wrong once in 100 000 times that the rates are as they should be, which takes half as many scenes as the
    -- library's once in 10⁹.
    checked :: Testable property => property -> Property
    checked = checkCoverageWith stdConfidence {certainty = 10 ^ (5 :: Int)}
    cycle' xs = if null xs then [] else cycle xs
    leftOf (ax, ay) (bx, by) (cx, cy) = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) > (0 :: Integer)
    onLine (ax, ay) (bx, by) (cx, cy) = (bx - ax) * (cy - ay) == (by - ay) * (cx - ax)
