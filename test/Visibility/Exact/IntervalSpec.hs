module Visibility.Exact.IntervalSpec (spec) where

import Test.Hspec hiding (around)
import Test.QuickCheck
import Visibility.Exact.Interval

spec :: Spec
spec = describe "an interval" $ do
  it "around a number contains it, and is a unit wide at most" $
    property $ \(NonNegative k) q ->
      let w = BinaryPlaces k
          (low, high) = ends w (around w q)
       in conjoin [property (low <= q && q <= high), property (high - low <= powerOfTwo (negate k))]
  it "is that around its ends" $
    property $ \(NonNegative k) a b ->
      let i = Interval (min a b) (max a b) in between (BinaryPlaces k) (ends (BinaryPlaces k) i) === i
  it "of sums, products and multiples contains those of all its numbers" $
    property $ \(NonNegative k) (NonNegative a) (NonNegative b) (NonNegative m) ->
      let w = BinaryPlaces k
          (x, y) = (around w a, around w b)
          inside q i = let (low, high) = ends w i in low <= q && q <= high
       in conjoin
            [ counterexample "sum" (inside (a + b) (x `plus` y))
            , counterexample "product" (inside (a * b) (times w x y))
            , counterexample "multiple" (inside (m * a) (multiple m x))
            ]
  it "keeps what has few places" $
    times (BinaryPlaces 4) (around (BinaryPlaces 4) (3 / 2)) (around (BinaryPlaces 4) (5 / 4)) `shouldBe` around (BinaryPlaces 4) (15 / 8)
  it "is scaled to below 1 by halving" $
    property $ \(Positive q) ->
      let r = q * powerOfTwo (negate (halvings q)) in counterexample (show r) (1 / 4 <= r && r <= 1)
