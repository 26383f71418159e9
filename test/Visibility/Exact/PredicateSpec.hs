module Visibility.Exact.PredicateSpec (spec) where

import Control.Monad (forM_)
import Data.Ratio ((%))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Exact.SomePoints (wholePlaces)

-- | Three points of a lattice whose corner is the origin: random, or nearly on a line, of every magnitude.
data Triple = Triple Vector2 Vector2 Vector2
  deriving (Show)

instance Arbitrary Triple where
  arbitrary = do
    extent <- elements ([4, 1000, 10 ^ (30 :: Int)] <> powers)
    a <- point extent
    b <- point extent
    c <- oneof [point extent, onLine a b, nearLine a b, atEdge extent]
    elements [Triple a b c, Triple c a b, Triple b c a, Triple a c b]
    where
      powers = [2 ^ k + d | k <- [31, 32, 33, 52, 53, 54, 60, 63, 106, 200, 1100 :: Int], d <- [-1, 0, 1]]
      coordinate extent =
        frequency
          [ (3, choose (0, extent))
          , (1, elements [0, 1, extent - 1, extent])
          , (1, choose (0, min extent 9))
          ]
      point extent = Vector2 <$> coordinate extent <*> coordinate extent
      atEdge extent = Vector2 <$> elements [0, extent] <*> elements [0, extent]
      -- Exactly on the line: between the two, where the displacement is divisible.
      onLine (Vector2 ax ay) (Vector2 bx by) =
        let g = max 1 (gcd (bx - ax) (by - ay))
         in (\k -> Vector2 (ax + k * ((bx - ax) `quot` g)) (ay + k * ((by - ay) `quot` g))) <$> choose (0, g)
      -- Rounded from the line, and a step beside it or none.
      nearLine (Vector2 ax ay) (Vector2 bx by) = do
        k <- choose (0, 1000)
        dx <- choose (-1, 1)
        dy <- choose (-1, 1)
        pure (Vector2 (max 0 (ax + k * (bx - ax) `div` 1000 + dx)) (max 0 (ay + k * (by - ay) `div` 1000 + dy)))

-- | Two headings of a lattice, from the first corner to the second and from the third to the fourth; often parallel, or
-- nearly so.
data Headings = Headings Vector2 Vector2 Vector2 Vector2
  deriving (Show)

instance Arbitrary Headings where
  arbitrary = do
    Triple a@(Vector2 ax ay) b@(Vector2 bx by) c@(Vector2 cx cy) <- arbitrary
    Triple d _ _ <- arbitrary
    dx <- choose (-1, 1)
    dy <- choose (-1, 1)
    k <- elements [1, 1, 2, -1]
    let beside = Vector2 (cx + k * (bx - ax) + dx) (cy + k * (by - ay) + dy)
        moved (Vector2 x y) = Vector2 (x - min 0 left) (y - min 0 low)
        Vector2 left low = beside
    elements [Headings a b c d, Headings (moved a) (moved b) (moved c) (moved beside)]

placed :: Arithmetic -> [Vector2] -> Points
placed arithmetic = pointsOn arithmetic . wholePlaces

-- | Four points of which some lie between those of the lattice: on lines through two others, or next to them.
newtype Fractions = Fractions [LatticePoint]
  deriving (Show)

instance Arbitrary Fractions where
  arbitrary = do
    width <- elements [4, 50, 2 ^ (33 :: Int)]
    let free = latticePoint <$> coordinate width <*> coordinate width
    a <- free
    b <- free
    onLine <- between a b <$> coordinate 3
    onOther <- between onLine a <$> coordinate 2
    others <- vectorOf 2 free
    Fractions . take 4 <$> shuffle ([a, b, onLine, onOther] <> others)
    where
      coordinate :: Integer -> Gen Rational
      coordinate width = oneof [fromInteger <$> choose (0, width), (%) <$> choose (0, 97 * width) <*> choose (97, 1000)]
      between p q t = latticePoint (abs (px + t * (qx - px))) (abs (py + t * (qy - py)))
        where
          (px, py) = coordinates p
          (qx, qy) = coordinates q

-- | The three points under an arithmetic, as corners 0, 1 and 2.
under :: Arithmetic -> Triple -> Points
under arithmetic (Triple a b c) = placed arithmetic [a, b, c]

-- | With coordinates below a number, at least 1.
below :: Integer -> Triple -> Triple
below limit (Triple a b c) = Triple (cut a) (cut b) (cut c)
  where
    cut (Vector2 x y) = Vector2 (min (limit - 1) x) (min (limit - 1) y)

-- | The sign of the determinant, expanded in another way than the kernels compute it.
determinant :: Triple -> Turn
determinant (Triple (Vector2 ax ay) (Vector2 bx by) (Vector2 cx cy)) =
  case compare (ax * by + bx * cy + cx * ay) (ay * bx + by * cx + cy * ax) of
    GT -> LeftTurn
    EQ -> Collinear
    LT -> RightTurn

exactArithmetics :: [Arithmetic]
exactArithmetics = [Exact, Filtered]

spec :: Spec
spec = do
  describe "turn" $ do
    forM_ exactArithmetics $ \arithmetic -> describe (show arithmetic) . modifyMaxSuccess (* 20) $ do
      it "is the sign of the determinant" $
        property $ \t -> turn (under arithmetic t) 0 1 2 === determinant t
      it "is cyclic" $
        property $ \t -> let p = under arithmetic t in turn p 0 1 2 === turn p 1 2 0
      it "is antisymmetric" $
        property $ \t -> let p = under arithmetic t in turn p 0 1 2 === opposite (turn p 1 0 2)
      it "is collinear where two corners are one" $
        property $ \t ->
          let p = under arithmetic t
           in [ turn p i j k
              | i <- [0 .. 2]
              , j <- [0 .. 2]
              , k <- [0 .. 2]
              , i == j || j == k || i == k
              ] === replicate 21 Collinear
      it "sees a difference of one in two hundred bits" $
        let k = 2 ^ (200 :: Int)
            third d = placed arithmetic [Vector2 0 0, Vector2 k k, Vector2 (2 * k) (2 * k + d)]
         in [turn (third d) 0 1 2 | d <- [-1, 0, 1]] `shouldBe` [RightTurn, Collinear, LeftTurn]
      it "sees neighbours in a Farey sequence apart" $
        [ turn (placed arithmetic [Vector2 0 0, Vector2 q p, Vector2 q' p']) 0 1 2
        | ((p, q), (p', q')) <- zip fibonacciFractions (drop 1 fibonacciFractions)
        ]
          `shouldBe` take (length fibonacciFractions - 1) (cycle [LeftTurn, RightTurn])
      it "does not overflow at the largest extent of machine integers" $
        let m = 2 ^ (31 :: Int) - 1
            ends = [0, 1, m - 1, m]
            grid = [Vector2 x y | x <- ends, y <- ends]
            points = placed arithmetic grid
            at i = grid !! i
         in [ (i, j, k)
            | i <- [0 .. 15]
            , j <- [0 .. 15]
            , k <- [0 .. 15]
            , turn points i j k /= determinant (Triple (at i) (at j) (at k))
            ]
              `shouldBe` []
      it "is right on the points that Doubles get wrong" $
        [(x, y) | (x, y) <- classroom, turn (classroomPoints arithmetic x y) 0 1 2 /= compareAsTurn y x] `shouldBe` []
    modifyMaxSuccess (* 20) $ do
      it "is the sign of the determinant where machine integers are given one by one" $
        property $ \triple ->
          let Triple (Vector2 ax ay) (Vector2 bx by) (Vector2 cx cy) = below (2 ^ (31 :: Int)) triple
              i = fromInteger
           in machineTurn (i ax) (i ay) (i bx) (i by) (i cx) (i cy) === determinant (below (2 ^ (31 :: Int)) triple)
      it "is the sign of the determinant under Doubles too, where none of their bits is lost" $
        property $ \triple -> let t = below (2 ^ (25 :: Int)) triple in turn (under UnsafeDouble t) 0 1 2 === determinant t
    it "is wrong under Doubles without a bound: they find corners on a line that are not, and know no better" $
      let wrong = [(x, y) | (x, y) <- classroom, turn (classroomPoints UnsafeDouble x y) 0 1 2 /= compareAsTurn y x]
       in (length wrong > 500, [turn (classroomPoints a 3 4) 0 1 2 | a <- [Exact, Filtered, UnsafeDouble]])
            `shouldBe` (True, [LeftTurn, LeftTurn, Collinear])
  describe "headingTurn" $
    forM_ exactArithmetics $ \arithmetic -> describe (show arithmetic) . modifyMaxSuccess (* 20) $ do
      it "is the turn of the exact directions" $
        property $ \(Headings a b c d) ->
          let p = placed arithmetic [a, b, c, d]
           in headingTurn p 0 1 2 3 === directionTurn (direction p 0 1) (direction p 2 3)
      it "is that also where the headings have a corner in common" $
        property $ \t ->
          let p = under arithmetic t
           in conjoin
                [ headingTurn p i j k l === directionTurn (direction p i j) (direction p k l)
                | (i, j, k, l) <- [(0, 1, 0, 2), (0, 1, 1, 2), (0, 1, 2, 0), (0, 1, 2, 1)]
                ]
      it "is antisymmetric, in the headings and in each of them" $
        property $ \(Headings a b c d) ->
          let p = placed arithmetic [a, b, c, d]
           in [opposite (headingTurn p 2 3 0 1), opposite (headingTurn p 1 0 2 3), headingTurn p 1 0 3 2]
                === replicate 3 (headingTurn p 0 1 2 3)
      it "is the turn of corners where both begin at one" $
        property $ \t -> let p = under arithmetic t in headingTurn p 0 1 0 2 === turn p 0 1 2
      it "is collinear by the corners alone" $
        property $ \(Headings a b c d) ->
          let p = placed arithmetic [a, b, c, d]
           in [headingTurn p i j k l | (i, j, k, l) <- [(0, 0, 2, 3), (0, 1, 2, 2), (0, 1, 0, 1), (0, 1, 1, 0)]]
                === replicate 4 Collinear
      it "is that of the filter where the filter is sure" $
        property $ \(Headings a b c d) ->
          let p = placed arithmetic [a, b, c, d]
           in conjoin
                [ found === headingTurn p i j k l
                | [i, j, k, l] <- sequence (replicate 4 [0 .. 3])
                , Just found <- [filterTurn p i j k l]
                ]
      it "is that of a function that is given" $
        property $ \(Headings a b c d) ->
          let p = placed arithmetic [a, b, c, d]
              given i j k l = opposite (headingTurn p i j k l)
           in [headingTurn (decidedBy given p) 0 1 2 3, turn (decidedBy given p) 0 1 2]
                === [given 0 1 2 3, opposite (turn p 0 1 2)]
  describe "directions" $ do
    it "turn as the corners that make them" $
      property $ \t ->
        let p = under Exact t in directionTurn (direction p 0 1) (direction p 0 2) === turn p 0 1 2
    it "of lines are ordered by angle: totally, upwards last" $
      property $ \(Line a) (Line b) (Line c) ->
        conjoin
          [ compareDirections a b === flipped (compareDirections b a)
          , compareDirections a upwards =/= GT
          , property (compareDirections a b == GT || compareDirections b c == GT || compareDirections a c /= GT)
          , compareDirections a b === compare (angle a) (angle b)
          ]
  describe "the filter" $
    it "leaves close turns to integers, and no clear ones" $
      let far = 2 ^ (40 :: Int)
          beside d = placed Filtered [Vector2 0 far, Vector2 far far, Vector2 (2 * far) (far + d)]
       in [filterTurn (beside d) 0 1 0 2 | d <- [far, -far, 0]] `shouldBe` [Just LeftTurn, Just RightTurn, Nothing]
  describe "an arc" $
    modifyMaxSuccess (* 10) $
      it "has inside what is met on the way from its beginning to its end, and is half a turn between parallels" $
        property $ \(Short a) (Short b) (Short c) ->
          let from d = let angles = fullTurn d - fullTurn a in if angles < 0 then angles + 4 else angles
              size = if directionTurn a b == Collinear then 2 else from b
           in insideArc directionTurn (a, b) c === (0 < from c && from c < size)
  describe "between the lattice's points" $
    it "every exact arithmetic has the sign of the rational determinant" $
      property $ \(Fractions places) ->
        let coordinate i = coordinates (places !! i)
            between i j = let ((x, y), (x', y')) = (coordinate i, coordinate j) in (x' - x, y' - y)
            sign (x, y) (x', y') = case compare (x * y') (y * x') of LT -> RightTurn; EQ -> Collinear; GT -> LeftTurn
            expected = [sign (between a b) (between c d) | [a, b, c, d] <- quadruples]
            quadruples = sequence (replicate 4 [0 .. 3])
         in conjoin
              [ counterexample (show arithmetic) $
                  [headingTurn points a b c d | [a, b, c, d] <- quadruples] === expected
              | arithmetic <- exactArithmetics
              , let points = pointsOn arithmetic (placesFrom places)
              ]
  describe "opposite" $
    it "undoes itself and leaves collinear alone" $
      (map (opposite . opposite) [minBound .. maxBound], opposite Collinear)
        `shouldBe` ([minBound .. maxBound], Collinear)
  where
    flipped o = case o of LT -> GT; EQ -> EQ; GT -> LT

-- | A direction of few others.
newtype Short = Short Direction
  deriving (Show)

instance Arbitrary Short where
  arbitrary = Short <$> elements [Direction x y | x <- [-2 .. 2], y <- [-2 .. 2], (x, y) /= (0, 0)]

-- | An order-preserving stand-in for the angle of any direction, below 4, of which half a turn is 2.
fullTurn :: Direction -> Rational
fullTurn (Direction x y) = if y >= 0 then 1 - part else 3 + part
  where
    part = x % (abs x + abs y)

-- | A right-going direction.
newtype Line = Line Direction
  deriving (Show)

instance Arbitrary Line where
  arbitrary = Line <$> oneof [Direction <$> choose (1, 5) <*> choose (-5, 5), nearlyLevel, pure upwards]
    where
      nearlyLevel = Direction <$> choose (1, 10 ^ (30 :: Int)) <*> choose (-10, 10)

-- | An order-preserving stand-in for the angle: the slope, infinite upwards.
angle :: Direction -> Either Rational ()
angle (Direction 0 _) = Right ()
angle (Direction x y) = Left (fromInteger y / fromInteger x)

-- | Quotients of Fibonacci numbers: neighbours differ by as little as their denominators allow. Beyond 2³¹.
fibonacciFractions :: [(Integer, Integer)]
fibonacciFractions = take 80 (zip fibonacci (drop 1 fibonacci))
  where
    fibonacci = 1 : 2 : zipWith (+) fibonacci (drop 1 fibonacci)

-- | Kettner, Mehlhorn, Pion, Schirra, Yap, Classroom examples of robustness problems in geometric computations: a
-- corner a few units of the last place beside (1/2, 1/2), seen against (12, 12) and (24, 24).
classroom :: [(Integer, Integer)]
classroom = [(x, y) | x <- [0, 5 .. 255], y <- [0, 3 .. 255]]

classroomPoints :: Arithmetic -> Integer -> Integer -> Points
classroomPoints arithmetic x y = pointsOn arithmetic (placesOn (latticeFor points) points)
  where
    unit = 2 ^ (53 :: Int) :: Rational
    points = [Point (1 / 2 + fromInteger x / unit) (1 / 2 + fromInteger y / unit), Point 12 12, Point 24 24]

-- | The turn from a point (x, y) beside the diagonal over (12, 12) to (24, 24) is left where the point lies above the
-- diagonal.
compareAsTurn :: Integer -> Integer -> Turn
compareAsTurn y x = case compare y x of
  LT -> RightTurn
  EQ -> Collinear
  GT -> LeftTurn
