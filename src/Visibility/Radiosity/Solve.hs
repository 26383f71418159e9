{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE HexFloatLiterals #-}

-- | Radiosities within bounds that are as close as asked: guesses in Doubles, corrected by exact residuals.
module Visibility.Radiosity.Solve
  ( Solution (..)
  , Shortfall (..)
  , solve
  ) where

import Data.Bits (shiftL, shiftR)
import Data.Ratio ((%))
import Data.Semigroup (Min (..))
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.IntegerRoot (bitLength)
import Visibility.Exact.Interval
import Visibility.Radiosity.Certificate
import Visibility.Radiosity.Relax
import Visibility.Radiosity.System

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
  | k >= 0 = m `shiftL` k
  | otherwise = m `shiftR` negate k
  where
    (m, e) = decodeFloat d
    k = e + scale
