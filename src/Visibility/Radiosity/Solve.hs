{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE HexFloatLiterals #-}

-- | Radiosities within bounds that are as close as asked: guesses in Doubles, of which nothing is proved, corrected by
-- exact residuals.
module Visibility.Radiosity.Solve
  ( Solution (..)
  , Shortfall (..)
  , solve
  ) where

import Control.Monad (foldM)
import Control.Monad.ST (runST)
import Data.Bits (shift, shiftR)
import Data.Ratio ((%))
import Data.Semigroup (Min (..))
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.IntegerRoot (bitLength)
import Visibility.Exact.Interval
import Visibility.Exact.RootSum (enclosureRelative, scaled)
import Visibility.Radiosity.Certificate
import Visibility.Radiosity.System
import Visibility.Scene.Raw (Material (..))

-- | Proved bounds, and how often the matrix was gone through for them.
data Solution = Solution
  { solutionBounds :: !Enclosure
  , solutionPasses :: !Int
  }

-- | Why bounds are not as close as asked: how close they are, if there are any, and after how many passes.
data Shortfall = Shortfall
  { provedSpread :: !(Maybe Rational)
  , triedPasses :: !Int
  }
  deriving (Eq, Show)

-- | Bounds whose distance is for every element at most this part of the largest radiosity.
--
-- A guess is corrected by the solution in Doubles for its residual, which is bounded exactly, and so on: each round
-- gains some ten digits. It ends when bounds are close enough, or no longer become closer by half: there the factors
-- are not known better, or light is reflected so often that Gauss–Seidel gives up.
--
-- /Degenerate cases/ without any light all radiosities are exactly zero, whatever was asked.
solve :: Rational -> System -> Either Shortfall Solution
solve target system = go Nothing 0 (V.map (const 0) patches) (V.map patchEmission patches)
  where
    patches = systemPatches system
    known = gainsOf system
    goal = max 0x1p-46 (fromRational (target / 64)) :: Double
    go best !passes x residual
      | maybe False (<= target) spread, Just bounds <- enclosed = Right (Solution bounds passes')
      | any (\now -> all (2 * now <) best) spread = go spread passes' x' (V.map residualWithin found)
      | otherwise = Left (Shortfall (fmap getMin (fmap Min spread <> fmap Min best)) passes')
      where
        Guess correction more = correctionFor residual
        passes' = passes + more
        x' = V.zipWith3 corrected (V.convert (systemLit system)) x (V.convert correction)
        found = residuals system x'
        enclosed = enclosureFrom system found
        spread = enclosed >>= spreadOf
        scale = V.foldl' max 0 (V.map (bitLength . middle) residual)
        correctionFor = relax system known goal . U.convert . V.map (\r -> scaledDown scale (middle r))
        corrected isLit old d = if isLit then max 0 (old + scaledUp scale d) else 0
    middle (Interval low high) = (low + high) `div` 2

-- | The largest distance of two bounds as a part of the largest radiosity; 0 where all are zero. 'Nothing' where no
-- radiosity is surely positive, though one may be.
spreadOf :: Enclosure -> Maybe Rational
spreadOf (Enclosure found _)
  | widest == 0 = Just 0
  | largest == 0 = Nothing
  | otherwise = Just (widest % largest)
  where
    widest = V.foldl' max 0 (V.map (\(Interval low high) -> high - low) found)
    largest = V.foldl' max 0 (V.map (\(Interval low _) -> low) found)

-- | About an integer by a power of two.
scaledDown :: Int -> Integer -> Double
scaledDown scale m = encodeFloat (m `shiftR` k) (k - scale)
  where
    k = max 0 (bitLength m - 60)

-- | About a Double times a power of two; 0 for what is no number.
scaledUp :: Int -> Double -> Integer
scaledUp scale d
  | isNaN d || isInfinite d = 0
  | otherwise = let (m, e) = decodeFloat d in m `shift` (e + scale)

-- | What relaxing needs to know of the elements, as Doubles.
data Gains = Gains
  { gains :: !(U.Vector Double)
  , powerWeights :: !(U.Vector Double)
  -- ^ The lengths of what is not covered, the sum being 1.
  , lossWeights :: !(U.Vector Double)
  -- ^ The part of one unit of light everywhere that is not reflected, or reaches the sky, by element: times its length.
  }

gainsOf :: System -> Gains
gainsOf system =
  Gains
    { gains = U.fromList [fromRational (patchGain p) | p <- patches]
    , powerWeights = U.fromList (map fromRational weights)
    , lossWeights = U.fromList [fromRational (w * loss p) | (w, p) <- zip weights patches]
    }
  where
    patches = V.toList (systemPatches system)
    lengths = [fst (enclosureRelative 60 (scaled (patchOpen p) (patchLength p))) | p <- patches]
    total = sum lengths
    weights = if total == 0 then map (const 0) lengths else map (/ total) lengths
    loss p
      | patchOpen p == 0 = 0
      | otherwise =
          let rho = reflectivity (patchMaterial p)
              sky = fst (ends (systemPlaces system) (patchSky p)) / patchOpen p
           in 1 - rho * (1 - sky)

-- | A solution as far as it was looked for, and how often the matrix was gone through.
data Guess = Guess !(U.Vector Double) !Int

-- | Relaxes x = b + gain · F x until what is still to come seems to be less than a part of the largest number; or until
-- roundings are all that changes, or the matrix has been gone through 5000 times.
--
-- It begins with the light of one intensity that would balance b. This is the error that Gauss–Seidel is slowest at
-- where little is absorbed.
--
-- /Degenerate cases/ elements that are not lit stay 0. /Cost/ O(factors) for each pass.
relax :: System -> Gains -> Double -> U.Vector Double -> Guess
relax system known goal b = runST $ do
  x <- U.thaw (U.zipWith3 start (systemLit system) (gains known) b)
  let
    pass = foldM (improve x) (0, 0) [0 .. U.length b - 1]
    go !count !before = do
      (change, largest) <- pass
      let ratio = if before > 0 then min 0.9999 (change / before) else 0.9999
          done = change * ratio <= goal * (1 - ratio) * largest || change <= 0x1p-50 * largest || count >= 5000
      if done || isNaN change then pure count else go (count + 1) change
  count <- go (1 :: Int) 0
  x' <- U.freeze x
  pure (Guess x' count)
  where
    matrix = systemMatrix system
    balanced = if losses > 0 then U.sum (U.zipWith (*) (powerWeights known) b) / losses else 0
    losses = U.sum (U.zipWith pick (systemLit system) (lossWeights known))
    pick isLit loss = if isLit then loss else 0
    start isLit gain y = if isLit then y + min 1 gain * balanced else 0
    improve x (!change, !largest) i
      | systemLit system U.! i = do
          old <- M.read x i
          light <- rowDot matrix x i
          let new = b U.! i + gains known U.! i * light
          M.write x i new
          pure (max change (abs (new - old)), max largest (abs new))
      | otherwise = pure (change, largest)
