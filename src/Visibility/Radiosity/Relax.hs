{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE HexFloatLiterals #-}

-- | Gauss–Seidel in Doubles: a good guess at a solution, of which nothing is proved.
module Visibility.Radiosity.Relax
  ( Gains (..)
  , gainsOf
  , rowDot
  , Guess (..)
  , relax
  ) where

import Control.Monad (foldM)
import Control.Monad.ST (ST, runST)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.Interval
import Visibility.Exact.RootSum (enclosureRelative, scaled)
import Visibility.Radiosity.System
import Visibility.Scene.Raw (Material (..))

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

-- | A row of the matrix by a vector.
rowDot :: Matrix -> M.STVector s Double -> Int -> ST s Double
rowDot matrix x i = go (rowStarts matrix U.! i) 0
  where
    end = rowStarts matrix U.! (i + 1)
    go !k !total
      | k == end = pure total
      | otherwise = do
          value <- M.read x (fromIntegral (columns matrix U.! k))
          go (k + 1) (total + factorDoubles matrix U.! k * value)
{-# INLINE rowDot #-}

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
