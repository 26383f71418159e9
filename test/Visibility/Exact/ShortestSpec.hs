module Visibility.Exact.ShortestSpec (spec) where

import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Foldable (for_)
import Data.Word (Word64)
import GHC.Float (castDoubleToWord64, castWord64ToDouble)
import Numeric (readFloat)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Visibility.Exact.Shortest

text :: Double -> String
text = Lazy.unpack . Builder.toLazyByteString . shortest

-- | Where a positive Double begins and ends: half-way to its neighbours, the greatest one's upper neighbour being
-- 2¹⁰²⁴.
ends :: Double -> (Rational, Rational)
ends x = (half (value (bits - 1)), half (value (bits + 1)))
  where
    bits = castDoubleToWord64 x
    half y = (toRational x + y) / 2
    value :: Word64 -> Rational
    value w = if w == 0x7ff0000000000000 then 2 ^ (1024 :: Int) else toRational (castWord64ToDouble w)

-- | The shortest decimal of a positive Double by trial, its figures and the power of ten of the last one: with ever
-- more of them, the nearest one on either side, if one is within the ends.
byTrial :: Double -> (Integer, Int)
byTrial x = head [nearest | k <- [most, most - 1 ..], nearest <- take 1 (candidates k)]
  where
    exact = toRational x
    most = ceiling (logBase 10 x) + 1 :: Int
    (low, high) = ends x
    closed = even (castDoubleToWord64 x)
    inside q = if closed then low <= q && q <= high else low < q && q < high
    candidates k =
      let unit = 10 ^^ k :: Rational
          below = floor (exact / unit) :: Integer
          distance m = abs (fromInteger m * unit - exact)
          good m = m > 0 && inside (fromInteger m * unit)
          order = case compare (distance below) (distance (below + 1)) of
            LT -> [below, below + 1]
            GT -> [below + 1, below]
            EQ -> if even below then [below, below + 1] else [below + 1, below]
       in [(m, k) | m <- order, good m]

-- | The text of these figures by the documented notation.
notation :: (Integer, Int) -> String
notation (m, k)
  | e < -6 || e >= 21 = pointed 1 figures <> "e" <> show e
  | e < 0 = "0." <> replicate (-1 - e) '0' <> figures
  | otherwise = pointed (e + 1) (figures <> replicate k '0')
  where
    figures = show m
    e = length figures + k - 1
    pointed n s = case splitAt n s of
      (whole, "") -> whole
      (whole, part) -> whole <> "." <> part

-- | Positive finite Doubles of all exponents alike, often at a power of two or ten, or a short decimal.
positive :: Gen Double
positive =
  oneof
    [ castWord64ToDouble <$> choose (1, 0x7fefffffffffffff)
    , do
        e <- choose (1, 2046)
        d <- choose (-3, 3 :: Int)
        pure (castWord64ToDouble (e * 0x10000000000000 + fromIntegral d))
    , castWord64ToDouble <$> choose (1, 3000)
    , do
        m <- choose (1, 10 ^ (17 :: Int)) :: Gen Integer
        k <- choose (-323, 290 :: Int)
        let x = fromRational (fromInteger m * 10 ^^ k)
        pure (if x > 0 then x else 1)
    , choose (0.001, 1)
    ]

spec :: Spec
spec = describe "shortest" $ do
  prop "is the shortest decimal by trial, in the documented notation" $
    forAll positive $ \x -> text x === notation (byTrial x)
  prop "is read back as the number" $
    forAll positive $ \x -> [fromRational q | (q, "") <- readFloat (text x)] === [x]
  it "writes numbers at the ends of the range and of the notations" $
    for_
      [ (0, "0"), (1, "1"), (0.1, "0.1"), (0.30000000000000004, "0.30000000000000004"), (120, "120")
      , (5.0e-324, "5e-324"), (2.2250738585072014e-308, "2.2250738585072014e-308")
      , (1.7976931348623157e308, "1.7976931348623157e308"), (2 ^ (53 :: Int), "9007199254740992")
      , (1.0e-6, "0.000001"), (9.5e-7, "9.5e-7"), (1.0e20, "100000000000000000000"), (1.0e21, "1e21")
      , (1.0e23, "1e23"), (18014398509481988, "18014398509481988"), (18014398509481992, "18014398509481990")
      ]
      $ \(x, wanted) -> text x `shouldBe` wanted
