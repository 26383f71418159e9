{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE HexFloatLiterals #-}

-- | Proved bounds of the true radiosities, from any guess at them.
module Visibility.Radiosity.Certificate
  ( -- * The residual
    Residual (..)
  , residuals
    -- * Bounds
  , Enclosure (..)
  , enclosureFrom
  ) where

import Control.Monad (foldM)
import Control.Monad.ST (runST)
import Data.Bits (shift, shiftR)
import Data.List (foldl')
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.IntegerRoot (bitLength)
import Visibility.Exact.Interval
import Visibility.Radiosity.System
import Visibility.Scene.Raw (Material (..))

-- Note [Why the bounds hold]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~~
-- Let B be the true radiosities, B = E + gFB with g_i Σ_j F_ij <= ρ_i < 1, and X any vector. e = B − X obeys
-- e = r + gFe with the residual r = E + gFX − X. Where |e_i| is largest, |e_i| <= |r_i| + ρ_i |e_i|; so all |e| <= c
-- where c (1 − ρ_i) >= |r_i| for all i. If v >= |e| everywhere, then |e_i| <= |r_i| + g_i Σ_j F_ij v_j, by F >= 0: each
-- such step keeps v a bound, one element after the other, and makes it smaller where neighbours are better. An element
-- that is not lit has B = 0 = X, e = 0; one that sees none that are lit is reached by no light.
-- In the end Σ F_ij B_j is Σ F_ij X_j within Σ F_ij v_j, and B_i = E_i + g_i Σ F_ij B_j.
--
-- X is an integer for each element, in units of the system; E, and gain times light, are bounded by integers too. A sum
-- of products is made of integers rounded down, n terms lose less than n. With the factors as the nearest Doubles x,
-- |F − x| <= 2^-53 F, so <= 2^-53 (1 + 2^-52) x, or 2^-1075: the sum S of all xX is off by less than
-- S 2^-53 + S 2^-104 + n max X 2^-1075. Enclosed factors are at most 2 units above what is known of them, so the sum is
-- at most 2 n max X units of units too low.
--
-- v is computed in Doubles, in units of 2^s for which |r| <= 1, as long as c <= 2^400. Products and sums lose a factor
-- (1 − 2^-53)^n at most, or 2^-1075 for each product; F <= x (1 + 2^-52) + 2^-1074. So with the computed sum σ,
-- ΣFv <= (σ + n 2^-600)(1 + (n + 8) 2^-52), its own roundings included; and two more operations lose less than the
-- factor 1 + 2^-50. Where something is reflected the residual is an interval of some width, so r is 2^-900 at least,
-- and a product below the range of Doubles is nothing beside it.

-- | What an equation lacks, and the light that a guess sends: Σ F_ij X_j.
data Residual = Residual
  { residualWithin :: !Interval
  , lightWithin :: !Interval
  }

-- | The residual of a guess in units, which must not be negative, and must be zero where an element is not lit.
--
-- /Cost/ a product of integers for each factor.
residuals :: System -> V.Vector Integer -> V.Vector Residual
residuals system x = V.imap residual (systemPatches system)
  where
    Matrix starts cols doubles precision = systemMatrix system
    BinaryPlaces w = systemPlaces system
    largest = V.foldl' max 0 x
    residual i patch
      | systemLit system U.! i = Residual (Interval (low - at) (high - at)) light
      | otherwise = Residual (Interval 0 0) light
      where
        Interval low high = patchEmission patch `plus` multiple (patchGain patch) light
        at = x V.! i
        light
          | systemReached system U.! i = sumOver [starts U.! i .. starts U.! (i + 1) - 1]
          | otherwise = Interval 0 0
    sumOver entries = case precision of
      CorrectlyRounded ->
        let total = foldl' (\acc k -> acc + byDouble (doubles U.! k) (from k)) 0 entries
            high = total + n
            loose = (high `shiftR` 53) + (high `shiftR` 104) + ((n * largest) `shiftR` 1075) + 3
         in Interval (max 0 (total - loose)) (high + loose)
      Enclosed lower ->
        let total = foldl' (\acc k -> acc + (lower V.! k * from k) `shiftR` w) 0 entries
         in Interval total (total + n + ((2 * n * largest) `shiftR` w) + 1)
      where
        n = toInteger (length entries)
    from k = x V.! fromIntegral (cols U.! k)
    -- A factor is at most 1.
    byDouble f y = let (m, e) = decodeFloat f in (m * y) `shift` e

-- | Bounds of the true radiosities, and of the light Σ F_ij B_j, in units of the system.
data Enclosure = Enclosure
  { radiosityWithin :: !(V.Vector Interval)
  , arrivingWithin :: !(V.Vector Interval)
  }

-- | The bounds that the residuals of a guess prove; 'Nothing' where reflectivities are so near to 1 that none can be
-- computed.
--
-- /Cost/ O(factors) for each pass, of which there are some tens, at most 1000; fewer where little is reflected.
enclosureFrom :: System -> V.Vector Residual -> Maybe Enclosure
enclosureFrom system found = do
  slack <- lightErrors system (V.map (size . residualWithin) found)
  let arriving = V.zipWith wider slack (V.map lightWithin found)
  Just (Enclosure (V.zipWith3 radiosity (V.convert (systemLit system)) (systemPatches system) arriving) arriving)
  where
    size (Interval low high) = max (abs low) (abs high)
    wider t (Interval low high) = Interval (max 0 (low - t)) (high + t)
    radiosity False _ _ = Interval 0 0
    radiosity True patch light = patchEmission patch `plus` multiple (patchGain patch) light

-- | Bounds of Σ F_ij |e_j|, from the sizes of the residuals.
lightErrors :: System -> V.Vector Integer -> Maybe (V.Vector Integer)
lightErrors system sizes
  | V.all (== 0) sizes = Just (V.map (const 0) sizes)
  | not (most <= 0x1p400) = Nothing
  | otherwise = Just (V.map inUnits (V.convert errors))
  where
    matrix = systemMatrix system
    n = V.length sizes
    scale = V.maximum (V.map bitLength sizes)
    r = U.generate n (upwards scale . (sizes V.!))
    most = U.maximum (U.imap (\i y -> if y == 0 then 0 else y / kept i * above) r)
    -- At most 1 − ρ.
    kept i = fromRational (1 - reflectivity (patchMaterial (systemPatches system V.! i))) * (1 - 0x1p-51) :: Double
    gain = U.generate n (\i -> upper (patchGain (systemPatches system V.! i)))
    upper q = if q == 0 then 0 else max 0x1p-900 (fromRational q * (1 + 0x1p-51))
    above = 1 + 0x1p-50 :: Double
    slackOf i =
      let terms = fromIntegral (rowStarts matrix U.! (i + 1) - rowStarts matrix U.! i) :: Double
       in (terms * 0x1p-600, 1 + (terms + 8) * 0x1p-52)
    errors = runST $ do
      v <- U.thaw (U.map (\isLit -> if isLit then most else 0) (systemLit system))
      let
        light i
          | systemReached system U.! i = do
              total <- rowDot matrix v i
              let (least, factor) = slackOf i
              pure ((total + least) * factor)
          | otherwise = pure 0
        tighten !total i
          | systemLit system U.! i = do
              old <- M.read v i
              t <- light i
              let new = min old ((r U.! i + gain U.! i * t) * above)
              M.write v i new
              pure (total + new)
          | otherwise = pure total
        go !count !before = do
          now <- foldM tighten 0 [0 .. n - 1]
          if now > 0.99 * before || count >= 1000 then pure () else go (count + 1) now
      go (1 :: Int) (0x1p1000 :: Double)
      U.generateM n light
    inUnits t
      | t == 0 = 0
      | otherwise =
          let (m, e) = decodeFloat t
              k = e + scale
           in m `shift` k + (if k >= 0 then 0 else 1)

-- | An integer by a power of two as a Double that is no smaller, and as little larger as matters. /Requires/ that both
-- are not negative, and the quotient at most 1.
upwards :: Int -> Integer -> Double
upwards scale m
  | m == 0 = 0
  | otherwise = max 0x1p-900 (encodeFloat ((m `shiftR` k) + 1) (k - scale))
  where
    k = max 0 (bitLength m - 52)
