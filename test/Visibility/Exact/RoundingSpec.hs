module Visibility.Exact.RoundingSpec (spec) where

import Control.Monad (forM_)
import Data.Char (isDigit)
import Data.Maybe (fromMaybe, isJust)
import Data.Ratio (denominator, numerator, (%))
import GHC.Float (castDoubleToWord64, castWord64ToDouble)
import Test.Hspec
import Test.QuickCheck
import Visibility.Exact.DoubleDouble (Scaled (..))
import Visibility.Exact.RootSum
import Visibility.Exact.Rounding

-- | A sum from radicands that are not negative; a negative one would show as a wrong value.
summed :: [(Rational, Integer)] -> RootSum
summed ts = fromMaybe (rational (10 ^ (400 :: Int))) (fromTerms ts)

-- | A decimal to n digits; below one digit it would show as a wrong text.
text :: Int -> RootSum -> String
text n s = maybe "no digits" (`decimal` s) (digits n)

-- | A decimal read back: all its digits as an integer, and the power of ten of the last one.
readBack :: String -> (Integer, Int)
readBack ('-' : rest) = let (m, e) = readBack rest in (negate m, e)
readBack cs = (read (whole ++ part), (if null exponentText then 0 else read (drop 1 exponentText)) - length part)
  where
    (mantissa, exponentText) = break (== 'e') cs
    (whole, fraction) = break (== '.') mantissa
    part = drop 1 fraction

-- | The notation: digits, leading zeros, point and exponent, each where they belong.
wellFormed :: Int -> String -> Bool
wellFormed n ('-' : cs) = wellFormed n cs
wellFormed n cs = all isDigit (whole ++ part) && length significant == n && fraction /= "." && notation
  where
    (mantissa, exponentText) = break (== 'e') cs
    (whole, fraction) = break (== '.') mantissa
    part = drop 1 fraction
    significant = dropWhile (== '0') (whole ++ part)
    leading = if whole == "0" then negate (1 + length (takeWhile (== '0') part)) else length whole - 1
    notation
      | null exponentText = -2 <= leading && leading < n && (whole == "0" || take 1 whole /= "0")
      | otherwise =
          let e = read (drop 1 exponentText) :: Int
           in length whole == 1 && whole /= "0" && (e < -2 || e >= n) && drop 1 exponentText == show e

-- | Whether an integer is the nearest one to √q, ties to even, by squaring alone.
isNearestToRoot :: Integer -> Rational -> Bool
isNearestToRoot m q = (below < 4 * q || tie below) && (4 * q < above || tie above)
  where
    below = fromInteger ((2 * m - 1) * abs (2 * m - 1))
    above = fromInteger ((2 * m + 1) * (2 * m + 1))
    tie square = square == 4 * q && even m

-- | Whether a Double is the nearest one to a rational, by its two neighbours; the infinities count as ±2¹⁰²⁴.
isNearestDouble :: Double -> Rational -> Bool
isNearestDouble d q
  | q < 0 = isNearestDouble (negate d) (negate q)
  | d < 0 = False
  | otherwise = all closer ([bits - 1 | bits > 0] ++ [bits + 1 | not (isInfinite d)])
  where
    bits = castDoubleToWord64 (abs d)
    exact w = let e = castWord64ToDouble w in if isInfinite e then 2 ^ (1024 :: Int) else toRational e
    closer other = case compare (abs (q - exact bits)) (abs (q - exact other)) of
      LT -> True
      EQ -> even bits
      GT -> exact bits == 2 ^ (1024 :: Int) && q > exact bits

-- | The square root of a rational between two decimals of d places, by bisection.
slowRoot :: Int -> Rational -> (Rational, Rational)
slowRoot d q = (m % unit, (m + 1) % unit)
  where
    unit = 10 ^ d :: Integer
    target = q * fromInteger (unit * unit)
    m = go 0 (1 + ceiling target)
    go a b
      | b - a <= 1 = a
      | fromInteger (c * c) <= target = go c b
      | otherwise = go a c
      where
        c = (a + b) `div` 2

someRational :: Gen Rational
someRational = (%) <$> choose (-1000, 1000) <*> choose (1, 1000)

-- | Rationals of all sizes.
scaledRational :: Gen Rational
scaledRational = (\q e -> q * 10 ^^ e) <$> someRational <*> choose (-40, 40 :: Int)

-- | All bit patterns but infinities and what is no number, so subnormal numbers too.
someDouble :: Gen Double
someDouble = fmap castWord64ToDouble (oneof [chooseAny, choose (0, 2 ^ (53 :: Int))]) `suchThat` finite
  where
    finite d = not (isNaN d || isInfinite d)

-- | Positive, irrational, and about 5·10⁻⁴¹.
speck :: RootSum
speck = summed [(1, 10 ^ (80 :: Int) + 1), (negate (10 ^ (40 :: Int)), 1)]

-- | A zero that only merging finds.
hiddenZero :: RootSum
hiddenZero = summed [(1, 8), (-2, 2), (1, 2 * 101 * 101), (-101, 2)]

-- | A number of digits, and an enclosure that is narrow, with ends of few bits now and then.
narrow :: Gen (Int, Scaled)
narrow = do
  n <- choose (1, 20)
  whole <- choose (10 ^ (n - 1), 10 ^ n - 1)
  zeros <- choose (0, 40)
  (low, k) <-
    frequency
      [ (4, (,) <$> oneof [choose (1, 2 ^ (120 :: Int)), choose (1, 4000)] <*> choose (-130, 0))
      , -- A tie.
        (1, pure ((2 * whole + 1) * 2 ^ zeros, -1 - zeros))
      ]
  width <- elements [0, 1, 2 ^ (10 :: Int), low `div` 10 ^ n, low `div` (3 * 10 ^ n)]
  pure (n, Scaled low (low + width) k)

spec :: Spec
spec = do
  describe "digits" $
    it "are at least one" $ do
      map (isJust . digits) [-1, 0, 1, 30] `shouldBe` [False, False, True, True]
      fmap digitCount (digits 5) `shouldBe` Just 5
      digitCount defaultDigits `shouldBe` 17

  describe "decimalBetween" $ do
    it "is the decimal of both ends, if they have the same one, neither is a tie, and no power of ten is in between" $
      forAll narrow $ \(n, found@(Scaled low high k)) ->
        let value end = fromInteger end * 2 ^^ k :: Rational
            ends = (text n (rational (value low)), text n (rational (value high)))
            result = digits n >>= (`decimalBetween` found)
            -- A tie has one digit more, a 5.
            isTie end =
              let (m, e) = readBack (text (n + 1) (rational (value end)))
               in m `mod` 10 == 5 && fromInteger m * 10 ^^ e == value end
            -- The exponent of the first digit.
            leading end = let (m, e) = readBack (text 60 (rational (value end))) in length (show m) + e
         in cover 20 (isJust result) "decided" . cover 5 (uncurry (/=) ends) "of two decimals" . cover 1 (isTie low) "ties" $
              counterexample (show (result, ends)) $ case result of
                Just shown -> ends == (shown, shown)
                Nothing -> uncurry (/=) ends || isTie low || isTie high || value low >= 10 ^ n || leading low /= leading high
    it "carries, and leaves alone what touches a tie" $
      [ digits n >>= (`decimalBetween` Scaled low high k)
      | (n, low, high, k) <-
          [ (3, 16380, 16383, -14)
          , (3, 1, 1, -2)
          , (1, 10, 10, -2)
          , (1, 10, 11, -2)
          , (1, 9, 10, -2)
          , (1, 9, 9, -2)
          , (1, 11, 11, -2)
          , (1, 104963, 115238, -20)
          , (65, 1, 1, -2)
          , (3, 41, 41, 0)
          ]
      ]
        `shouldBe` [Just "1.00", Just "0.250", Nothing, Nothing, Nothing, Just "2", Just "3", Just "0.1"]
          <> [Just ("0.25" ++ replicate 63 '0'), Just "41.0"]
    it "is none where it is not asked for: of no positive numbers, of large ones, and of multiples of 2" $
      [ digits n >>= (`decimalBetween` Scaled low high k)
      | (n, low, high, k) <- [(3, 0, 4, -3), (3, -4, 4, -3), (3, 8000, 8000, -3), (3, 3, 3, 1)]
      ]
        `shouldBe` [Nothing, Nothing, Nothing, Nothing]
  describe "decimal" $ do
    it "rounds ties to the even digit" $
      forM_
        [ (2, 1 % 8, "0.12")
        , (2, 3 % 8, "0.38")
        , (1, 1 % 2, "0.5")
        , (1, 5 % 2, "2")
        , (1, 7 % 2, "4")
        , (3, 9995 % 1000, "10.0")
        , (3, 9985 % 1000, "9.98")
        , (3, 9995 % 100, "100")
        , (2, 995 % 10, "1.0e2")
        , (2, 125, "1.2e2")
        , (2, 135, "1.4e2")
        ]
        $ \(n, q, expected) -> do
          text n (rational q) `shouldBe` expected
          text n (rational (negate q)) `shouldBe` '-' : expected
          text n (rational q <> hiddenZero) `shouldBe` expected
    it "leaves a tie for the least irrational excess" $ do
      text 2 (rational (1 % 8) <> speck) `shouldBe` "0.13"
      text 2 (rational (1 % 8) - speck) `shouldBe` "0.12"
      text 2 (rational (3 % 8) <> speck) `shouldBe` "0.38"
      text 2 (rational (3 % 8) - speck) `shouldBe` "0.37"
      text 2 (negate (rational (3 % 8)) <> speck) `shouldBe` "-0.37"
      text 30 (rational 1 - speck) `shouldBe` "1." ++ replicate 29 '0'
      text 41 (rational 1 - speck) `shouldBe` "0.9999999999999999999999999999999999999999" ++ "5"
    it "carries" $
      forM_
        [ (2, 9951 % 1000, "10")
        , (2, 9951 % 10000, "1.0")
        , (2, 9951 % 10 ^ (6 :: Int), "0.010")
        , (2, 9951 % 10 ^ (7 :: Int), "1.0e-3")
        , (1, 96 % 10, "1e1")
        ]
        $ \(n, q, expected) -> text n (rational q) `shouldBe` expected
    it "changes notation at 10^-2 and at 10^N" $
      forM_
        [ (3, 1 % 100, "0.0100")
        , (3, 999 % 100000, "9.99e-3")
        , (3, 999, "999")
        , (3, 1000, "1.00e3")
        , (1, 9, "9")
        , (1, 10, "1e1")
        , (30, 1, "1." ++ replicate 29 '0')
        , (4, 1 % 10 ^ (400 :: Int), "1.000e-400")
        ]
        $ \(n, q, expected) -> text n (rational q) `shouldBe` expected
    it "writes zero as 0, hidden or not" $ do
      text 17 zero `shouldBe` "0"
      text 17 hiddenZero `shouldBe` "0"
    it "is nearest to a single root, by squaring" $
      property $ forAll ((,,) <$> choose (1, 40) <*> scaledRational <*> choose (1, 10 ^ (12 :: Int))) $ \(n, c, k) ->
        c /= 0 ==>
          let shown = text n (summed [(c, k)])
              (m, e) = readBack shown
           in counterexample shown $
                wellFormed n shown .&&. (signum m === signum (numerator c))
                  .&&. isNearestToRoot (abs m) (c * c * fromInteger k / 100 ^^ e)
    it "is nearest to a sum of roots, by bisection" $
      property $ forAll ((,) <$> choose (1, 40) <*> vectorOf 4 term) $ \(n, ts) ->
        let s = summed ts
            shown = text n s
            (m, e) = readBack shown
            part (c, k) =
              let (a, b) = slowRoot 150 (c * c * fromInteger k) in if c >= 0 then (a, b) else (negate b, negate a)
            (low, high) = (sum (map (fst . part) ts), sum (map (snd . part) ts))
            (mid, half) = (fromInteger m * 10 ^^ e, 10 ^^ e / 2)
         in counterexample shown $
              if shown == "0"
                then property (low <= 0 && high >= 0 && sign s == Zero)
                else wellFormed n shown .&&. (mid - half <= high) .&&. (low <= mid + half)
    it "is nearest to a rational" $
      property $ forAll ((,) <$> choose (1, 6) <*> oneof [scaledRational, (% 1000) <$> choose (1, 99999)]) $ \(n, q) ->
        q /= 0 ==>
          let shown = text n (rational q)
              (m, e) = readBack shown
           in counterexample shown (wellFormed n shown .&&. isNearestToRoot (abs m) (q * q / 100 ^^ e))
    it "is odd" $
      property $ forAll ((,) <$> choose (1, 20) <*> vectorOf 3 term) $ \(n, ts) ->
        let (shown, other) = (text n (summed ts), text n (negate (summed ts)))
         in case shown of
              "0" -> other === "0"
              '-' : rest -> other === rest
              _ -> other === '-' : shown
    it "reads back as the same Double from 17 digits" $
      property $ forAll someDouble $ \d -> d /= 0 ==> read (decimal defaultDigits (rational (toRational d))) === d
    it "gives the first digits of √2" $
      text 30 (summed [(1, 2)]) `shouldBe` "1.41421356237309504880168872421"

  describe "outwardDecimals" $ do
    it "encloses, each end by less than a unit of the last digit" $
      forAll (choose (1, 30)) $ \n -> property $ \a b ->
        let (low, high) = (min a b, max a b) :: (Rational, Rational)
            (down, up) = maybe ("", "") (`outwardDecimals` (low, high)) (digits n)
            valueOf t = let (m, e) = readBack t in (fromInteger m * 10 ^^ e, if t == "0" then 0 else 10 ^^ e)
            (downValue, downUnit) = valueOf down
            (upValue, upUnit) = valueOf up
         in counterexample (down <> " " <> up) $
              downValue <= low && high <= upValue
                && (low == 0 || low - downValue < downUnit)
                && (high == 0 || upValue - high < upUnit)
    it "keeps what needs no rounding, and says zero" $
      forM_ [(0, "0"), (1 % 4, "0.250"), (-5 % 2, "-2.50"), (999, "999")] $ \(q, t) ->
        fmap (`outwardDecimals` (q, q)) (digits 3) `shouldBe` Just (t, t)
    it "rounds away from the inside, over a power of ten too" $
      map
        (\q -> fmap (`outwardDecimals` (q, q)) (digits 2))
        [1 % 3, -1 % 3, 9991 % 10000, -9991 % 10000]
        `shouldBe` map Just [("0.33", "0.34"), ("-0.34", "-0.33"), ("0.99", "1.0"), ("-1.0", "-0.99")]

  describe "nearestDouble" $ do
    it "keeps Doubles" $
      property $ forAll someDouble $ \d -> nearestDouble (rational (toRational d)) === d
    it "has the nearest Double, by its neighbours" $
      property $ forAll ((*) <$> scaledRational <*> ((2 ^^) <$> choose (-1100, 1000 :: Int))) $ \q ->
        isNearestDouble (nearestDouble (rational q)) q
    it "takes the middle of neighbours to the even one" $
      property $ forAll someDouble $ \d ->
        let bits = castDoubleToWord64 (abs d)
            next = castWord64ToDouble (bits + 1)
            middle = (toRational (abs d) + toRational next) / 2
            chosen = if even bits then abs d else next
         in not (isInfinite next) ==>
              (nearestDouble (rational middle) === chosen)
                .&&. (nearestDouble (rational middle <> hiddenZero) === chosen)
                .&&. (nearestDouble (rational middle <> scaled (2 ^^ (-1200 :: Int)) speck) === next)
                .&&. (nearestDouble (rational middle - scaled (2 ^^ (-1200 :: Int)) speck) === abs d)
    it "agrees with the correctly rounded root of the machine" $
      property $ forAll (choose (1, 2 ^ (53 :: Int))) $ \n -> nearestDouble (summed [(1, n)]) === sqrt (fromInteger n)
    it "becomes infinite from 2^1024 - 2^970 on" $ do
      let edge = rational (2 ^ (1024 :: Int) - 2 ^ (970 :: Int))
          largest = castWord64ToDouble 0x7fefffffffffffff
      nearestDouble edge `shouldBe` 1 / 0
      nearestDouble (negate edge) `shouldBe` -1 / 0
      nearestDouble (edge - speck) `shouldBe` largest
      nearestDouble (rational (10 ^ (5000 :: Int))) `shouldBe` 1 / 0
    it "becomes zero at half the least positive Double" $ do
      let half = rational (2 ^^ (-1075 :: Int))
          least = castWord64ToDouble 1
      nearestDouble half `shouldBe` 0
      isNegativeZero (nearestDouble (negate half)) `shouldBe` True
      nearestDouble (half <> scaled (10 ^^ (-5000 :: Int)) speck) `shouldBe` least
      nearestDouble (scaled 3 half) `shouldBe` 2 * least
      isNegativeZero (nearestDouble hiddenZero) `shouldBe` False
      map (isNegativeZero . nearestDouble . flip scaled speck) [2 ^^ (-3000 :: Int), -2 ^^ (-3000 :: Int)]
        `shouldBe` [False, True]
    it "is monotone" $
      property $ forAll ((,) <$> vectorOf 3 term <*> vectorOf 3 term) $ \(a, b) ->
        let (s, t) = (summed a, summed b)
         in compare s t === EQ .||. compare (nearestDouble s) (nearestDouble t) =/= compare t s

  describe "rationalText" $ do
    it "has no denominator for integers" $ map rationalText [2, 0, -3] `shouldBe` ["2", "0", "-3"]
    it "is in lowest terms" $ map rationalText [2 % 6, -14 % 4] `shouldBe` ["1/3", "-7/2"]
    it "reads back" $
      property $ forAll scaledRational $ \q ->
        let (n, d) = break (== '/') (rationalText q)
         in (read n, if null d then 1 else read (drop 1 d)) === (numerator q, denominator q)
  where
    term = (,) <$> someRational <*> choose (1, 60)
