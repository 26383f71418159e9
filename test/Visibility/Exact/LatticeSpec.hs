module Visibility.Exact.LatticeSpec (spec) where

import Data.Ratio (denominator, (%))
import qualified Data.Vector.Unboxed as U
import Test.Hspec
import Test.QuickCheck
import Visibility.Exact.IntegerRoot (bitLength)
import Visibility.Exact.Lattice
import Visibility.Exact.SomePoints

-- | Points whose denominators have little in common.
newtype OwnDenominators = OwnDenominators [Point]
  deriving (Show)

instance Arbitrary OwnDenominators where
  arbitrary = OwnDenominators <$> vectorOf 12 (Point <$> coordinate <*> coordinate)
    where
      coordinate = (%) <$> choose (-(2 ^ bits), 2 ^ bits) <*> choose (2 ^ bits, 2 ^ (bits + 1))
      bits = 100 :: Int

spec :: Spec
spec = do
  describe "the lattice" $ do
    it "takes a point there and back" $
      property $ \(SomePoints ps) -> let l = latticeFor ps in map (fromLattice l . ontoLattice l) ps === ps
    it "takes every other point there and back" $
      property $ \(SomePoints ps) (SomePoints qs) ->
        let l = latticeFor ps in map (fromLattice l . ontoLattice l) qs === qs
    it "has all points above and to the right of its origin, some by less than a unit" $
      property $ \(SomePoints ps) -> let l = latticeFor ps in lowest l ps
    it "enlarges displacements by its scale" $
      property $ \(SomePoints ps) ->
        let l = latticeFor ps
            factor = fromInteger (latticeScale l) :: Rational
         in conjoin
              [ let Way (Vector2 dx dy) w = way (ontoLattice l a) (ontoLattice l b)
                 in (dx % w, dy % w) === (factor * (bx - ax), factor * (by - ay))
              | a@(Point ax ay) <- take 4 ps
              , b@(Point bx by) <- take 4 ps
              ]
    it "has the least common denominator as its scale where that is not far longer than one's own" $
      property $ \(SomePoints ps) ->
        let l = latticeFor ps
            own (Point x y) = denominator x `lcm` denominator y
            common = foldr (lcm . own) 1 ps
            close = bitLength common <= 64 + 4 * maximum (map (bitLength . own) ps)
         in cover 20 close "close" $
              latticeScale l === (if close then common else 1) .&&. (close ==> all (isWhole . ontoLattice l) ps)
    it "is that of integers, and points have denominators of their own, where the common one is far longer" $
      property $ \(OwnDenominators ps) ->
        let l = latticeFor ps
         in latticeScale l === 1 .&&. map (fromLattice l . ontoLattice l) ps === ps .&&. lowest l ps
    it "is the integers themselves for integer points" $
      latticeScale (latticeFor [Point 3 4, Point (-1) 7]) `shouldBe` 1
  describe "points" $ do
    it "are in lowest terms: equal exactly where their coordinates are" $
      property $ \(Few a b) (Few c d) -> (latticePoint a b == latticePoint c d) === ((a, b) == (c, d))
    it "have the coordinates that they are made from" $
      property $ \(Few a b) -> coordinates (latticePoint a b) === (a, b)
    it "are ordered lexicographically" $
      property $ \(Few a b) (Few c d) -> comparePlaces (latticePoint a b) (latticePoint c d) === compare (a, b) (c, d)
    it "have a way between them, and a vector towards each other that is a positive multiple of it" $
      property $ \(Few a b) (Few c d) ->
        let (p, q) = (latticePoint a b, latticePoint c d)
            Way (Vector2 x y) w = way p q
         in (x % w, y % w) === (c - a, d - b) .&&. towards p q === Vector2 x y .&&. w > 0
  describe "many points" $ do
    it "are where they were put, small or not" $
      property $ \(SomePoints ps) ->
        let l = latticeFor ps
            places = placesOn l ps
         in cover 20 (isSmall places) "small" $ cover 20 (not (isSmall places)) "large" $
              placeList places === map (ontoLattice l) ps
    it "are small exactly where they are whole and below 2^31" $
      [ isSmall (placesFrom [LatticePoint 0 0 1, p])
      | k <- [2 ^ (31 :: Int) - 1, 2 ^ (31 :: Int)]
      , p <- [LatticePoint k 0 1, LatticePoint 0 k 1, LatticePoint 1 k 2]
      ]
        `shouldBe` [True, True, False, False, False, False]
    it "can be rearranged" $
      property $ \(SomePoints ps) -> forAll (listOf (choose (0, length ps - 1))) $ \order ->
        let places = placesOn (latticeFor ps) ps
         in placeList (rearranged (U.fromList (map fromIntegral order)) places) === map (placeList places !!) order
  where
    isSmall places = case places of SmallPlaces _ -> True; LargePlaces _ -> False
    lowest l ps =
      let (xs, ys) = unzip (map (coordinates . ontoLattice l) ps)
       in counterexample (show (xs, ys)) (all (>= 0) (xs <> ys) && minimum xs < 1 && minimum ys < 1)

-- | Coordinates of which many are equal.
data Few = Few Rational Rational
  deriving (Show)

instance Arbitrary Few where
  arbitrary = Few <$> few <*> few
    where
      few = (%) <$> choose (-4, 4) <*> choose (1, 4)
