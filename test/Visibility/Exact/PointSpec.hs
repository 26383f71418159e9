module Visibility.Exact.PointSpec (spec) where

import Data.Ratio ((%))
import qualified Data.Vector.Unboxed as U
import Test.Hspec
import Test.QuickCheck
import Visibility.Exact.Point
import Visibility.Exact.SomePoints

spec :: Spec
spec = do
  describe "the arithmetic" $ do
    it "is that of machine integers up to the extent 2^31 - 1 and not beyond" $
      [ (k, kernelName (pointsOn Filtered (wholePlaces [Vector2 0 0, v])))
      | k <- [2 ^ (31 :: Int) - 1, 2 ^ (31 :: Int), 2 ^ (31 :: Int) + 1]
      , v <- [Vector2 k 0, Vector2 0 k]
      ]
        `shouldBe` [ (2 ^ (31 :: Int) + d, name)
                   | (d, name) <- [(-1, "machine"), (0, "filter"), (1, "filter")]
                   , _ <- [(), ()]
                   ]
    it "is what is asked for" $
      map (kernelName . (`pointsOn` wholePlaces [Vector2 0 0, Vector2 1 2])) [minBound .. maxBound]
        `shouldBe` ["machine", "integer", "double"]
    it "can be chosen anew without touching the points" $
      property $ \a b (SomePoints ps) ->
        let l = latticeFor ps
            qs = map (ontoLattice l) ps
            points = withArithmetic (arithmetic b) (pointsOn (arithmetic a) (placesFrom qs))
         in (map (pointAt points) [0 .. length qs - 1], kernelName points)
              === (qs, kernelName (pointsOn (arithmetic b) (placesFrom qs)))
    it "bounds the rounding of every Double of the filter, and knows where nothing was rounded" $
      property $ \(BeyondMachine extents) -> case pointsKernel (pointsOn Filtered (wholePlaces extents)) of
        FilterKernel xs ->
          let order extent = length (takeWhile (<= extent) (iterate (* 2) 1))
              orderX = order (maximum [x | Vector2 x _ <- extents])
              orderY = order (maximum [y | Vector2 _ y <- extents])
              exact = concat [[x % 2 ^ orderX, y % 2 ^ orderY] | Vector2 x y <- extents]
              stored = concat [[pair i, pair (i + 1)] | i <- [0, 4 .. U.length xs - 4]]
              pair i = (xs U.! i, xs U.! (i + 2))
           in conjoin
                [ counterexample (show (q, d, e)) $
                    let off = abs (q - toRational d) in off <= toRational e && (off /= 0 || e == 0) && d <= 1
                | (q, (d, e)) <- zip exact stored
                ]
        _ -> counterexample "no filter" False
    it "bounds the rounding of points between the lattice's, too" $
      property $ \(SomePoints ps) -> let l = latticeFor [Point 0 0] in fractionsBounded (map (moved . ontoLattice l) ps)
  where
    moved (LatticePoint x y w) = latticePoint (abs (x % w)) (abs (y % w))
    fractionsBounded places = case pointsKernel (pointsOn Filtered (placesFrom (latticePoint 0 (1 % 2) : places))) of
      FilterKernel xs ->
        let stored = [[(xs U.! i, xs U.! (i + 2)), (xs U.! (i + 1), xs U.! (i + 3))] | i <- [4, 8 .. U.length xs - 4]]
            column k = zip (map ((!! k) . both . coordinates) places) (map (!! k) stored)
            both (x, y) = [x, y]
            -- The scale is a power of two that brings all below 1: recovered from one that is not zero.
            scaled k power = [(q * 2 ^^ power, d, e) | (q, (d, e)) <- column k]
            fits k =
              or
                [ and [abs (q - toRational d) <= toRational e && d <= 1 | (q, d, e) <- scaled k power]
                | power <- [-150 .. 150 :: Int]
                ]
         in counterexample (show stored) (fits 0 && fits 1)
      _ -> counterexample "no filter" False

-- | Lattice points with an extent beyond machine integers.
newtype BeyondMachine = BeyondMachine [Vector2]
  deriving (Show)

instance Arbitrary BeyondMachine where
  arbitrary = do
    top <- elements [2 ^ (31 :: Int), 2 ^ (60 :: Int) + 1, 3 ^ (80 :: Int), 10 ^ (400 :: Int)]
    others <- listOf (Vector2 <$> below top <*> below top)
    pure (BeyondMachine (Vector2 top 0 : others))
    where
      below top = oneof [choose (0, top), choose (0, 9), (top -) <$> choose (0, 9)]

kernelName :: Points -> String
kernelName points = case pointsKernel points of
  MachineKernel _ -> "machine"
  FilterKernel _ -> "filter"
  IntegerKernel -> "integer"
  DoubleKernel _ -> "double"
  GivenKernel _ -> "given"

newtype SomeArithmetic = SomeArithmetic {arithmetic :: Arithmetic}
  deriving (Show)

instance Arbitrary SomeArithmetic where
  arbitrary = SomeArithmetic <$> arbitraryBoundedEnum
