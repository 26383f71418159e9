module Visibility.Exact.SquareClassSpec (spec) where

import Data.List (nub, sort)
import Data.Ratio ((%))
import Test.Hspec
import Test.QuickCheck
import Visibility.Exact.RootSum
import Visibility.Exact.SquareClass

-- | The primes whose squares leave a radicand.
smallPrimes :: [Integer]
smallPrimes = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47]

-- | A positive integer of up to so many bits, often with squares in it.
positive :: Int -> Gen Integer
positive bits = oneof [choose (1, limit), (\k n -> k * k * n) <$> choose (1, root3) <*> choose (1, root3)]
  where
    limit = 2 ^ bits - 1
    root3 = 2 ^ (bits `div` 3) - 1

spec :: Spec
spec = do
  describe "a prepared root" $ do
    it "is the root of its integer" $
      property $ forAll (positive 200) $ \n ->
        let PreparedRoot _ k m = preparedRoot n in k * k * m === n
    it "has no square of a small prime in its radicand" $
      property $ forAll (positive 200) $ \n ->
        let PreparedRoot _ _ m = preparedRoot n in [p | p <- smallPrimes, m `rem` (p * p) == 0] === []
    it "is the same in machine integers, to the largest" $
      property $ forAll (oneof [positive 63, pure (2 ^ (63 :: Int) - 1), pure (2 ^ (62 :: Int))]) $ \n ->
        let PreparedRoot key k m = preparedRoot n
         in prepared (fromInteger n) === (key, k, m)
    it "loses the squares of just the small primes" $
      [n | p <- [2 .. 60], let PreparedRoot _ _ n = preparedRoot (p * p * 61 :: Integer), (n == 61) == (p `elem` [53, 59])]
        `shouldBe` []
    it "has one key for each square class" $
      property $ forAll ((,) <$> positive 100 <*> positive 100) $ \(n, k) ->
        classKey (preparedRoot (n * k * k)) === classKey (preparedRoot n)
    it "has the key 0 for perfect squares" $
      property $ forAll (positive 100) $ \k -> classKey (preparedRoot (k * k)) === 0
    it "tells the 8 classes in ℚ₂ and the 4 in each other field apart" $
      [ (p, length keys)
      | p <- smallPrimes
      , -- Squares in all fields but that of p.
      let numbers = [1 + j * (8 * product (drop 1 smallPrimes) `quot` if p == 2 then 8 else p) | j <- [0 .. 8 * p * p]]
      , let keys = nub (map (classKey . preparedRoot) numbers)
      , length keys /= if p == 2 then 8 else 4
      ]
        `shouldBe` []
    it "has different keys for products of different small primes" $
      property $ forAll ((,) <$> sublistOf smallPrimes <*> sublistOf smallPrimes) $ \(ps, qs) ->
        (classKey (preparedRoot (product ps)) == classKey (preparedRoot (product qs))) === (ps == qs)
  describe "merged terms" $ do
    it "are the same in machine integers" $
      property $ forAll someTerms $ \found ->
        [(toInteger n, c) | (n, c) <- mergedTerms [(c, preparedRoot (fromInteger n :: Int)) | (c, n) <- found]]
          === mergedTerms [(c, preparedRoot n) | (c, n) <- found]
    it "have rising radicands, each once, and no zero coefficient" $
      property $ forAll someTerms $ \found ->
        let made = mergedTerms [(c, preparedRoot n) | (c, n) <- found]
         in (strictly (map fst made) === True) .&&. (filter ((== 0) . snd) made === [])
    it "are those of the sum, divided" $
      property $ forAll ((,) <$> someTerms <*> choose (1, 12)) $ \(found, d) ->
        let made = mergedSum d [(c, preparedRoot n) | (c, n) <- found]
         in fmap ((=== made) . scaled (1 % d)) (fromTerms [(fromInteger c, n) | (c, n) <- found]) `orElse` False
    it "of terms that cancel in pairs are none, though their radicands differ" $
      property $ forAll (listOf ((,) <$> choose (-9, 9) <*> positive 20)) $ \found ->
        mergedTerms
          (concat [[(2 * c, preparedRoot n), (negate c, preparedRoot (4 * n))] | (c, n) <- found])
          === ([] :: [(Integer, Integer)])
    it "of a lone square of a large prime is a multiple of 1" $
      mergedTerms [(3 :: Integer, preparedRoot (53 * 53 :: Int))] `shouldBe` [(1, 159)]
  where
    prepared :: Int -> (Int, Integer, Integer)
    prepared n = let PreparedRoot key k m = preparedRoot n in (key, toInteger k, toInteger m)
    strictly ns = ns == sort ns && and (zipWith (/=) ns (drop 1 ns))
    orElse found other = maybe (property other) property found

-- | Terms of machine size, of which many share a square class.
someTerms :: Gen [(Integer, Integer)]
someTerms = listOf ((,) <$> choose (-9, 9) <*> frequency [(3, shared), (1, positive 62)])
  where
    shared = (\n k -> n * k * k) <$> elements [1, 2, 3, 6, 53 * 59] <*> choose (1, 60)
