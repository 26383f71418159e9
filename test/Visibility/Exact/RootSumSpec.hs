module Visibility.Exact.RootSumSpec (spec) where

import Control.Exception (ArithException (..), evaluate)
import Control.Monad (forM_)
import Data.List (foldl', nub)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isJust)
import Data.Ratio ((%))
import qualified Data.Set as Set
import System.Timeout (timeout)
import Test.Hspec
import Test.QuickCheck hiding (Negative, Positive)
import Visibility.Exact.Bisection (bisected)
import Visibility.Exact.IntegerRoot (exactSquareRoot)
import Visibility.Exact.RootSum
import Visibility.Exact.SomeRoots

-- | c √(k² · product of distinct primes): the square class is known by construction.
data Spelt = Spelt Rational Integer (Set.Set Integer)
  deriving (Show)

newtype Spelling = Spelling [Spelt]
  deriving (Show)

instance Arbitrary Spelt where
  arbitrary = Spelt <$> coefficient <*> oneof [choose (1, 12), (101 ^) <$> choose (1, 20 :: Int)] <*> core
    where
      core = frequency [(4, subsetOf [2, 3, 5]), (2, subsetOf (2 : 3 : hugePrimes))]
      subsetOf ps = Set.fromList <$> sublistOf ps
  shrink (Spelt c k ps) = [Spelt c 1 ps | k /= 1] ++ [Spelt c k (Set.delete p ps) | p <- Set.toList ps]

instance Arbitrary Spelling where
  arbitrary = Spelling <$> oneof [listOf arbitrary, cancelling]
    where
      -- Each term comes with its opposite in another spelling, and a few without.
      cancelling = do
        base <- listOf arbitrary
        factors <- vectorOf (length base) (choose (1, 9))
        rest <- resize 2 (listOf arbitrary)
        shuffle (base ++ zipWith cancel factors base ++ rest)
      cancel f (Spelt c k ps) = Spelt (negate c / fromInteger f) (k * f) ps
  shrink (Spelling ts) = Spelling <$> shrink ts

coefficient :: Gen Rational
coefficient = (%) <$> choose (-9, 9) <*> choose (1, 9)

-- | Mersenne primes, and two primes just above the ones whose squares are taken out of radicands.
hugePrimes :: [Integer]
hugePrimes = [53, 59, 2 ^ (61 :: Int) - 1, 2 ^ (89 :: Int) - 1, 2 ^ (521 :: Int) - 1]

-- | The primes whose squares are taken out, 2 left aside.
smallOddPrimes :: [Integer]
smallOddPrimes = [3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47]

-- | The value by linear algebra: coefficients by square-free core, zeros left out.
model :: Spelling -> Map Integer Rational
model (Spelling ts) = Map.filter (/= 0) (Map.fromListWith (+) [(product ps, c * fromInteger k) | Spelt c k ps <- ts])

build :: Spelling -> RootSum
build (Spelling ts) = summed [(c, k * k * product ps) | Spelt c k ps <- ts]

-- | A sum from radicands that are not negative; a negative one would show as a wrong value.
summed :: [(Rational, Integer)] -> RootSum
summed ts = fromMaybe (rational (10 ^ (400 :: Int))) (fromTerms ts)

-- | What a term is worth whatever its spelling.
worth :: [(Rational, Integer)] -> Set.Set (Rational, Rational)
worth ts = Set.fromList [(signum c, c * c * fromInteger n) | (c, n) <- ts]

-- | Bounds of a sum of known cores to d decimal places per unit of coefficient.
bounds :: Int -> Map Integer Rational -> (Rational, Rational)
bounds d m = (sum (map fst parts), sum (map snd parts))
  where
    parts = [if c > 0 then (c * low n, c * high n) else (c * high n, c * low n) | (n, c) <- Map.toList m]
    unit = 10 ^ d :: Integer
    low n = bisected (n * unit * unit) % unit
    high n = low n + 1 % unit

modelSign :: Map Integer Rational -> Sign
modelSign m
  | Map.null m = Zero
  | otherwise = go 30
  where
    go d = case bounds d m of
      (low, high)
        | low > 0 -> Positive
        | high < 0 -> Negative
        | otherwise -> go (2 * d)

opposite :: Sign -> Sign
opposite s = case s of
  Negative -> Positive
  Zero -> Zero
  Positive -> Negative

signOf :: Sign -> RootSum
signOf s = case s of
  Negative -> -1
  Zero -> 0
  Positive -> 1

-- | Few terms with few primes.
small :: Gen Spelling
small = do
  Spelling ts <- resize 4 arbitrary
  pure (Spelling [Spelt c k (Set.filter (< 60) ps) | Spelt c k ps <- take 5 ts])

quickly :: a -> IO (Maybe a)
quickly = timeout 20000000 . evaluate

-- | Reproducible integers below 2^48.
scrambled :: Integer -> [Integer]
scrambled = map (`div` 65536) . drop 1 . iterate step
  where
    step x = (x * 6364136223846793005 + 1442695040888963407) `mod` 2 ^ (64 :: Int)

spec :: Spec
spec = do
  describe "merged" $ do
    it "keeps the value: terms pair off with those of the square-free form" $
      property $ \s -> worth (terms (merged (build s))) === worth [(c, n) | (n, c) <- Map.toList (model s)]
    it "has one term per class that is left" $
      property $ \s -> length (terms (merged (build s))) === Map.size (model s)
    it "is idempotent" $
      property $ \s -> let m = merged (build s) in terms (merged m) === terms m
    it "does not depend on the order of the terms" $
      property $ \s@(Spelling ts) -> forAll (shuffle ts) $ \us ->
        terms (merged (build s)) === terms (merged (build (Spelling us)))
    it "has rising radicands without the squares of small primes, and perfect squares as 1" $
      property $ \s ->
        let ns = map snd (terms (merged (build s)))
         in (ns === Set.toAscList (Set.fromList ns))
              .&&. ([(n, p) | n <- ns, p <- 2 : smallOddPrimes, n `rem` (p * p) == 0] === [])
              .&&. ([n | n <- ns, n > 1, isJust (exactSquareRoot n)] === [])
    it "turns lone perfect squares into 1, whatever their primes" $
      forM_ [4, 9, 53, 101 * 103, 2 ^ (61 :: Int) - 1] $ \k ->
        terms (merged (summed [(1 % 2, k * k)])) `shouldBe` [(fromInteger k / 2, 1)]
    it "takes common cofactors out: √12 + √75 + √4 is 2 + 7√3" $
      terms (merged (summed [(1, 12), (1, 75), (1, 4)])) `shouldBe` [(2, 1), (7, 3)]
    it "represents a class of huge radicands by their greatest common divisor" $
      let q = 2 ^ (89 :: Int) - 1; p = 2 ^ (61 :: Int) - 1
       in terms (merged (summed [(1, 53 * 53 * q), (1, 59 * 59 * q), (1, p * p * q)]))
            `shouldBe` [(fromInteger (53 + 59 + p), q)]
    it "tells classes apart that agree modulo 8 and modulo all small primes" $ do
      let step = 8 * product smallOddPrimes
          ns = [1 + j * step | j <- [1 .. 40]]
          together a b = let r = bisected (a * b) in r * r == a * b
          representatives = foldl' (\known n -> if any (together n) known then known else n : known) [] ns
      length representatives `shouldSatisfy` (> 30)
      length (terms (merged (summed [(1, n) | n <- ns]))) `shouldBe` length representatives

  describe "arithmetic" $ do
    it "adds, subtracts and negates as the model does" $
      property $ \s@(Spelling a) t@(Spelling b) ->
        let flipped = [Spelt (negate c) k ps | Spelt c k ps <- b]
         in (build s + build t === build (Spelling (a ++ b)))
              .&&. (build s - build t === build (Spelling (a ++ flipped)))
              .&&. (negate (build t) === build (Spelling flipped))
    it "is a commutative group" $
      property $ \r s t ->
        let (a, b, c) = (build r, build s, build t)
         in ((a <> b) <> c === a <> (b <> c)) .&&. (a <> b === b <> a) .&&. (mconcat [a, b, mempty, c] === c <> b <> a)
              .&&. (terms (a - a) === [])
    it "adds many as it adds two, their terms in the order of radicands" $
      property $ \ss ->
        let sums = map build ss
            radicands = map snd (terms (mconcat sums))
         in (terms (mconcat sums) === terms (foldl' (+) zero sums)) .&&. (and (zipWith (<) radicands (drop 1 radicands)) === True)
    it "adds up by keys" $
      property $ \ss ->
        let keyed = [(k :: Int, build s) | (k, s) <- ss]
         in fmap terms (totalsBy keyed) === Map.map terms (Map.fromListWith (flip (+)) keyed)
    it "scales linearly" $
      property $ \s t -> forAll ((,) <$> coefficient <*> coefficient) $ \(p, q) ->
        let (a, b) = (build s, build t)
         in (scaled p (a <> b) === scaled p a <> scaled p b) .&&. (scaled (p + q) a === scaled p a <> scaled q a)
              .&&. (scaled p (scaled q a) === scaled (p * q) a)
    it "gives its terms back" $
      property $ \s -> let a = build s in fmap terms (fromTerms (terms a)) === Just (terms a)
    it "keeps no zero coefficient and no radicand 0" $ do
      terms (summed [(1, 5), (-1, 5), (0, 7), (3, 0), (2, 6)]) `shouldBe` [(2, 6)]
      terms (rational 0) `shouldBe` []
      terms (scaled 0 (rational 3)) `shouldBe` []
    it "refuses negative radicands" $ do
      fmap terms (root 1 (-1)) `shouldBe` Nothing
      fmap terms (fromTerms [(1, 2), (1, -1)]) `shouldBe` Nothing
      fmap terms (timesRoot 1 (-2) (rational 1)) `shouldBe` Nothing
      rootOfRational (-1 % 4) `shouldBe` Nothing
    it "measures integer vectors, by the primitive ones along them" $
      property $ \x y ->
        let g = max 1 (gcd x y)
            whole = root 3 (x * x + y * y)
            primitive = root (3 * fromInteger g) (x * x `quot` (g * g) + y * y `quot` (g * g))
         in (Just (hypotenuse 3 x y) === whole) .&&. (terms (hypotenuse 3 x y) === maybe [] terms primitive)
    it "has roots of rationals whose square is the rational" $
      property $ \(NonNegative q) -> (rootOfRational q >>= \r -> timesRootOf r r) === Just (rational q)
    it "multiplies roots" $
      property $ \(NonNegative m) (NonNegative n) -> forAll ((,) <$> coefficient <*> coefficient) $ \(c, r) ->
        (root c m >>= timesRoot r n) === root (c * r) (m * n)
    it "divides what it multiplied" $
      property $ \s (Spelt c k ps) ->
        c /= 0 ==>
          let n = k * k * product ps
           in (quotientByRoot (build s) c n === quotientByRoot (build s) (c * fromInteger k) (product ps))
                .&&. ((quotientByRoot (build s) c n >>= timesRoot c n) === Just (build s))
    it "divides (√6 + √10) by 2√2" $
      fmap (terms . merged) (quotientByRoot (summed [(1, 6), (1, 10)]) 2 2) `shouldBe` Just [(1 % 2, 3), (1 % 2, 5)]
    it "does not divide by zero" $
      [quotientByRoot (rational 1) c n | (c, n) <- [(0, 2), (1, 0), (1, -3)]] `shouldBe` [Nothing, Nothing, Nothing]

  describe "numbers" $ do
    it "multiply as the model does" $
      property $ forAll ((,) <$> small <*> small) $ \(s, t) ->
        let product' =
              Map.fromListWith (+) $
                [ (m * n `div` (g * g), c * d * fromInteger g)
                | (m, c) <- Map.toList (model s)
                , (n, d) <- Map.toList (model t)
                , let g = gcd m n
                ]
         in worth (terms (merged (build s * build t))) === worth [(c, n) | (n, c) <- Map.toList product', c /= 0]
    it "are a field: quotients undo products" $
      property $ forAll ((,) <$> small <*> small) $ \(s, t) ->
        let (a, b) = (build s, build t) in if b == 0 then a * b === 0 else a * b / b === a
    it "divide also where radicands share squares and factors: 1 / (√12 + √18 + √50 + √60 + 3)" $
      let x = summed [(1, 12), (1, 18), (1, 50), (1, 60), (3, 1)] in (x * recip x, recip (recip x)) `shouldBe` (1, x)
    it "have no quotient by zero, however it is spelt" $
      evaluate (1 / summed [(1, 8), (-2, 2)]) `shouldThrow` (== RatioZeroDenominator)
    it "are their absolute values times their signs, and compare with literals" $
      property $ \s ->
        let a = build s in (abs a * signum a, abs a >= 0, signum a) === (a, True, signOf (modelSign (model s)))
    it "come from rationals" $
      property $ \p q -> (fromRational p + fromRational (q * q), 3) === (rational (p + q * q), rational 3)
  describe "sign" $ do
    it "agrees with slow enclosures of the square-free form" $
      property $ \s -> sign (build s) === modelSign (model s)
    it "is antisymmetric, and turned by negative factors only" $
      property $ \s -> forAll coefficient $ \c ->
        (sign (negate (build s)) === opposite (sign (build s)))
          .&&. (sign (scaled c (build s)) === turnedBy (compare c 0) (sign (build s)))
    it "is the order of the reals" $
      property $ \s t@(Spelling b) ->
        let difference = Spelling (unspelt s ++ [Spelt (negate c) k ps | Spelt c k ps <- b])
         in (compare (build s) (build t) === compare (modelSign (model difference)) Zero)
              .&&. ((build s == build t) === Map.null (model difference))
    it "knows true zeros" $
      forM_
        [ [(1, 8), (-2, 2)]
        , [(1, 18), (1, 2), (-1, 32)]
        , [(1, 4), (1, 9), (-1, 25)]
        , [(1 % 3, 3), (-1, 3), (2 % 9, 27)]
        , [(1, 2 * (10 ^ (100 :: Int) + 7) ^ (2 :: Int)), (negate (10 ^ (100 :: Int) + 7), 2)]
        , []
        ]
        $ \ts -> sign (summed ts) `shouldBe` Zero
    it "knows near zeros of the literature" $ do
      sign (summed [(1, 10), (1, 11), (-1, 5), (-1, 18)]) `shouldBe` Positive
      let five = [(1, 5), (1, 6), (1, 18), (-1, 4), (-2, 12)]
          fibonacci = [(1, 75025), (1, 121393), (1, 196418), (1, 317811), (-1, 514229), (-1, 832040)]
      sign (summed five) `shouldBe` signBySlowBounds five
      sign (summed fibonacci) `shouldBe` signBySlowBounds fibonacci
    it "separates √(n² + 1) from n at any size" $
      forM_ [1, 10, 64, 100, 300, 1000 :: Int] $ \e -> do
        let n = 10 ^ e
        sign (summed [(1, n * n + 1), (negate (fromInteger n), 1)]) `shouldBe` Positive
        sign (summed [(1, n * n - 1), (negate (fromInteger n), 1)]) `shouldBe` Negative
    it "separates √(n+2) − 2√(n+1) + √n from zero for huge n" $
      forM_ [20, 100, 400 :: Int] $ \e ->
        sign (summed [(1, 10 ^ e + 2), (-2, 10 ^ e + 1), (1, 10 ^ e)]) `shouldBe` Negative

  describe "asRational" $ do
    it "is found exactly when only the class of 1 is left" $
      property $ \s ->
        asRational (build s) === if all (== 1) (Map.keys (model s)) then Just (sum (Map.elems (model s))) else Nothing
    it "finds a third hidden among roots" $
      asRational (summed [(1, 2), (-1 % 2, 8), (1 % 6, 4)]) `shouldBe` Just (1 % 3)

  describe "enclosure" $ do
    it "contains the value and is narrow" $
      property $ \s -> forAll (choose (-20, 300)) $ \k ->
        let (low, high) = enclosure k (build s)
            (a, b) = bounds 260 (model s)
         in counterexample (show (low, high)) ((low <= b) .&&. (a <= high) .&&. ((high - low) * 2 ^^ k <= 1))
    it "contains a single root, by squaring" $
      property $ forAll ((,,) <$> choose (1, 10000) <*> coefficient <*> choose (-5, 200)) $ \(n, c, k) ->
        let (low, high) = enclosure k (summed [(abs c, n)]); square = c * c * fromInteger n
         in (low * abs low <= square) .&&. (square <= high * abs high) .&&. ((high - low) * 2 ^^ k <= 1)
    it "contains a single root of long numbers, of which only the leading bits count" $
      property $ forAll ((,,,) <$> long <*> long <*> long <*> choose (-700, 700)) $ \(a, b, n, k) ->
        let (low, high) = enclosure k (summed [(a % b, n)])
            square = (a % b) * (a % b) * fromInteger n
            (low', high') = enclosure k (summed [(negate a % b, n)])
         in (low * abs low <= square)
              .&&. (square <= high * abs high)
              .&&. ((high - low) * 2 ^^ k <= 1)
              .&&. (low' * abs low' <= negate square)
              .&&. (negate square <= high' * abs high')
              .&&. ((high' - low') * 2 ^^ k <= 1)
    it "is relative to the largest term if wanted" $
      property $ \s -> forAll (choose (1, 300)) $ \p ->
        let a = build s
            (low, high) = enclosureRelative p a
            (c, d) = bounds 260 (model s)
            square (x, n) = x * x * fromInteger n
         in (low <= d) .&&. (c <= high) .&&. ((high - low) ^ (2 :: Int) * 4 ^ p <= maximum (0 : map square (terms a)))
    it "is the point 0 for the empty sum" $ enclosure 10 zero `shouldBe` (0, 0)

  describe "size" $ do
    it "accumulates 100000 terms and merges what is left" $ do
      let radicand x y = x `mod` 200 + y `mod` 200 + 1
          ts = [(c % n, n) | (x, y, c) <- take 100000 vectors, let n = radicand x y]
      found <- quickly (let ns = map snd (terms (merged (summed ts))) in sum ns `seq` ns)
      let squareFree n = null [p | p <- takeWhile (\q -> q * q <= n) [2 ..], n `rem` (p * p) == 0]
      found `shouldBe` Just (filter squareFree [1 .. 399])
    it "decides a zero of 2000 terms of a hundred bits" $ do
      let ts = [(c % n, n) | (x, y, c) <- take 1000 vectors, let n = x * x + y * y]
          us = respelt (map ((+ 2) . (`mod` 1000)) (scrambled 4)) ts
      length (nub (map snd us)) `shouldBe` 1000
      quickly (sign (summed (ts ++ us))) `shouldReturn` Just Zero
      quickly (sign (summed ((1 % 10 ^ (100 :: Int), 2) : ts ++ us))) `shouldReturn` Just Positive
    it "decides sums whose coordinates have hundreds of digits" $ do
      let digits seed = map (\x -> (x + 1) ^ (21 :: Int) `div` (seed + 2)) (scrambled seed)
          ts = [(c % n, n) | (x, y, c) <- take 60 (zip3 (digits 1) (digits 2) (digits 3)), let n = x * x + y * y]
          us = respelt (digits 4) ts
      quickly (sign (summed (ts ++ us))) `shouldReturn` Just Zero
      quickly (sign (summed (ts ++ us ++ [(-1 % 10 ^ (1000 :: Int), 3)]))) `shouldReturn` Just Negative
  where
    unspelt (Spelling ts) = ts
    -- Positive, of up to 700 bits; often all ones, or a one and zeros.
    long = do
      bits <- choose (1, 700 :: Int)
      oneof [choose (2 ^ (bits - 1), 2 ^ bits - 1), pure (2 ^ bits - 1), pure (2 ^ (bits - 1)), pure 1]
    turnedBy order s = case order of
      LT -> opposite s
      EQ -> Zero
      GT -> s
    vectors = zip3 (scrambled 1) (scrambled 2) (scrambled 3)
    -- The opposite terms, each in another spelling.
    respelt factors ts = [(negate c / fromInteger k, n * k * k) | ((c, n), k) <- zip ts factors]
    timesRootOf r s = fmap mconcat (traverse (\(c, n) -> timesRoot c n s) (terms r))
    signBySlowBounds ts = modelSign (Map.fromList [(n, c) | (c, n) <- ts])
