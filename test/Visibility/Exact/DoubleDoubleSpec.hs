module Visibility.Exact.DoubleDoubleSpec (spec) where

import Data.Maybe (isJust, isNothing)
import Data.Ratio ((%))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (Positive, total)
import Visibility.Exact.DoubleDouble
import Visibility.Exact.RootSum
import Visibility.Exact.Rounding (nearestDouble)

spec :: Spec
spec = modifyMaxSuccess (* 20) $ do
  describe "a length in two Doubles" $ do
    it "is within 8u² of the exact one, the second part small" $
      forAll machineVector $ \(x, y) ->
        isTight (hypotenuse 1 (toInteger x) (toInteger y)) (machineLength x y)
    it "is so for huge vectors, scaled" $
      forAll hugeVector $ \(k, x, y) ->
        isTight (scaled (1 / 2 ^ k) (hypotenuse 1 x y)) (scaledLength k x y 1)
    it "is so for vectors with a denominator" $
      forAll ((,) <$> hugeVector <*> choose (1, 2 ^ (60 :: Int))) $ \((k, x, y), w) ->
        let far = 2 ^ (60 :: Int)
         in isTight
              (scaled (1 / (2 ^ k * fromInteger w)) (hypotenuse 1 x y))
              (scaledLength (k - 60) (far * x) (far * y) (far * far * w))
    it "is no number where it is out of range" $ do
      scaledLength 0 (2 ^ (500 :: Int)) 1 1 `shouldSatisfy` noNumber
      scaledLength 500 1 1 1 `shouldSatisfy` noNumber
      scaledLength 7 0 0 1 `shouldBe` Double2 0 0
  describe "a sum of lengths" $ do
    it "lies in its enclosure" $
      forAll (listOf signedVector) $ \signed ->
        let (low, high) = sumEnclosure (sum2 signed)
         in counterexample (show (low, high)) (rational low <= exactSum signed && exactSum signed <= rational high)
    it "lies in it after cancellation" $
      forAll cancelling $ \signed ->
        let (low, high) = sumEnclosure (sum2 signed)
         in counterexample (show (low, high)) (rational low <= exactSum signed && exactSum signed <= rational high)
  describe "half a quotient" $ do
    it "lies in its enclosure, and is rounded to the nearest Double" $
      forAll ((,) <$> oneof [listOf signedVector, cancelling] <*> divisor) $ \(signed, by) ->
        let exact = halved (exactSum signed) by
            found = quotientEnclosure (sum2 signed) (uncurry machineLength by)
            double = nearestHalfQuotient (sum2 signed) (uncurry machineLength by)
            integers = scaledHalfQuotient (sum2 signed) (uncurry machineLength by)
            covered = cover 30 (isJust integers) "enclosed in integers" . cover 30 (isJust double) "rounded"
         in covered . cover 1 (isNothing double) "in doubt" . conjoin $
              [counterexample (show bounds) (inside exact bounds) | Just bounds <- [found]]
                <> [counterexample (show x) (fmap nearestDouble exact == Just x) | Just x <- [double]]
                <> [ counterexample (show found') (low > 0 && inside exact (times low, times high))
                   | Just found'@(Scaled low high k) <- [integers]
                   , let times m = fromInteger m * 2 ^^ k
                   ]
                <> [counterexample "enclosed one way only" (isJust integers || isNothing double)]
    it "is enclosed by integers as it is by Doubles, of at most four units more" $
      forAll (oneof [(,) <$> (map wide <$> oneof [listOf signedVector, cancelling]) <*> (whole <$> divisor), nearDoubles]) $
        \(signed, (x, y)) ->
          let by = scaledLength 0 x y 1
              total = foldl (\found ((x', y'), k) -> plusLength found (scaledLength 0 x' y' 1) k) noLengths signed
           in conjoin
                [ counterexample (show (ends, bounds)) $
                    units low k <= fst bounds
                      && snd bounds <= units high k
                      && units (high - low) k <= snd bounds - fst bounds + units 4 k
                | Just ends@(Scaled low high k) <- [scaledHalfQuotient total by]
                , Just bounds <- [quotientEnclosure total by]
                ]
    it "is in doubt exactly between two Doubles, and just beside the middle" $ do
      -- (2^54 - 1) / 2^55 has 54 digits; the length of (2^54, 0) is a Double.
      let by = scaledLength 54 (2 ^ (54 :: Int)) 0 1
          near n =
            plusLength (plusLength noLengths (scaledLength 54 (2 ^ (54 :: Int)) 0 1) 1) (scaledLength 54 n 0 1) (-1)
      nearestHalfQuotient (near 1) by `shouldBe` Nothing
      nearestHalfQuotient (near 2) by `shouldBe` Just (fromRational ((2 ^ (54 :: Int) - 2) % 2 ^ (55 :: Int)))
    it "is in doubt for a sum that may be zero" $
      nearestHalfQuotient (sum2 [((3, 4), 2), ((6, 8), -1)]) (machineLength 1 0) `shouldBe` Nothing
  where
    sum2 = foldl (\total ((x, y), k) -> plusLength total (machineLength x y) k) noLengths
    exactSum signed = mconcat [hypotenuse (fromIntegral k) (toInteger x) (toInteger y) | ((x, y), k) <- signed]
    halved total (x, y) = case terms (hypotenuse 2 (toInteger x) (toInteger y)) of
      [(c, n)] -> quotientByRoot total c n
      _ -> Nothing
    whole (x, y) = (toInteger x, toInteger y)
    wide (v, k) = (whole v, k)
    units m k = fromInteger m * 2 ^^ (k :: Int) :: Rational
    inside exact (low, high) = maybe False (\value -> rational low <= value && value <= rational high) exact
    noNumber (Double2 s _) = isNaN s

-- | Is a length near enough to the sum of its parts?
isTight :: RootSum -> Double2 -> Property
isTight exact (Double2 s t) =
  counterexample (show (s, t)) $
    abs (toRational t) <= 2 * u * toRational s
      && scaled (1 - 8 * u * u) exact <= rational both
      && rational both <= scaled (1 + 8 * u * u) exact
  where
    both = toRational s + toRational t
    u = 1 / 2 ^ (53 :: Int)

machineVector, divisor :: Gen (Int, Int)
machineVector = (,) <$> coordinate <*> coordinate
  where
    coordinate = oneof [choose (-20, 20), choose (-limit, limit), elements [limit, -limit, limit - 1]]
    limit = 2 ^ (31 :: Int) - 1
divisor = machineVector `suchThat` (/= (0, 0))

hugeVector :: Gen (Int, Integer, Integer)
hugeVector = do
  k <- oneof [choose (40, 900), choose (120, 136), choose (2000, 3000)]
  -- Also coordinates that lose as much as can be where only leading bits are looked at.
  let coordinate = oneof [choose (-2 ^ k, 2 ^ k), (2 ^ k -) <$> choose (1, 9)]
      shorter = do
        j <- choose (0, k)
        choose (-2 ^ j, 2 ^ j)
  (,,) k <$> coordinate <*> oneof [coordinate, shorter, choose (-9, 9)]

signedVector :: Gen ((Int, Int), Int)
signedVector = (,) <$> machineVector <*> choose (-6, 6)

-- | Sums of lengths, and vectors, of which half the quotient has a second part far below a unit of the last place.
nearDoubles :: Gen ([((Integer, Integer), Int)], (Integer, Integer))
nearDoubles = (,) <$> resize 4 (listOf1 ((,) <$> ((,) <$> multiple <*> choose (1, 9)) <*> choose (1, 2))) <*> pure (3, 0)
  where
    multiple = (6 *) <$> choose (2 ^ (40 :: Int), 2 ^ (44 :: Int))

-- | Sums whose lengths nearly cancel, or do so.
cancelling :: Gen [((Int, Int), Int)]
cancelling = do
  (x, y) <- machineVector
  (dx, dy) <- (,) <$> choose (-1, 1) <*> choose (-1, 1)
  k <- choose (1, 6)
  others <- oneof [pure [], listOf1 ((\v -> [(v, 1), (v, -1)]) <$> machineVector) >>= shuffle . concat]
  shuffle (((x, y), k) : ((inRange (x + dx), inRange (y + dy)), -k) : others)
  where
    inRange = max (-limit) . min limit
    limit = 2 ^ (31 :: Int) - 1

-- | What is known of a sum: a lower and an upper bound.
sumEnclosure :: Sum2 -> (Rational, Rational)
sumEnclosure total@(Sum2 a b _ _) = (middle - slack, middle + slack)
  where
    middle = toRational a + toRational b
    slack = toRational (sumBound total)

-- | What is known of a sum divided by twice a length, if the sum is surely positive.
quotientEnclosure :: Sum2 -> Double2 -> Maybe (Rational, Rational)
quotientEnclosure total by
  | surely = Just (middle - toRational slack, middle + toRational slack)
  | otherwise = Nothing
  where
    Quotient2 surely h g slack = halfQuotient total by
    middle = toRational h + toRational g
