{-# LANGUAGE BangPatterns #-}

-- | Form factors from lines in Doubles: at random, or as areas in the dual.
--
-- /Source/ Orti, Rivière, Durand, Puech, Using the visibility complex for radiosity computation, propositions 1 and 2
-- and equation 4: the form factor is a ratio of measures of lines, du dθ.
module Estimate.Lines
  ( randomLines
  , dualAreas
  ) where

import Control.Monad (forM_)
import Control.Monad.ST (ST)
import Data.List (insertBy, sort)
import qualified Data.Vector.Unboxed as U
import Data.Word (Word64)
import System.Random.SplitMix (SMGen, mkSMGen, nextDouble)
import Estimate.Matrix

-- | So many lines of a generator, uniform among those that meet a disc around the scene: each free piece of a line
-- counts for the two sides that it joins.
--
-- /Cost/ O(n) for each line.
randomLines :: Word64 -> Int -> Sides -> Matrix
randomLines seed count sides = matrixFrom (U.length (lengths sides)) (go (mkSMGen seed) count)
  where
    (cx, cy, radius) = disc sides
    weight = 2 * radius * pi / fromIntegral count
    go :: SMGen -> Int -> (Int -> Int -> Double -> ST s ()) -> ST s ()
    go !generator !left put
      | left <= 0 = pure ()
      | otherwise = do
          let (a, generator') = nextDouble generator
              (b, generator'') = nextDouble generator'
              theta = pi * a
          along sides (cos theta) (sin theta) (cx * sin theta - cy * cos theta + radius * (2 * b - 1)) weight put
          go generator'' (left - 1) put

-- | So many directions at equal distances, each with all its lines: between two corners' offsets the line sees the
-- same, so a direction gives exact widths, up to rounding. Directions are sampled: the faces of the complex, whose
-- areas the propositions have in closed form, are not used.
--
-- /Cost/ O(n²) for each direction.
dualAreas :: Int -> Sides -> Matrix
dualAreas count sides = matrixFrom (U.length (lengths sides)) $ \put ->
  forM_ [0 .. count - 1] $ \k -> do
    let theta = pi * (fromIntegral k + 0.5) / fromIntegral count
        c = cos theta
        s = sin theta
        offsets = sort (U.toList (U.zipWith (\x y -> x * s - y * c) (startX sides) (startY sides)))
    forM_ (zip offsets (drop 1 offsets)) $ \(low, high) ->
      along sides c s ((low + high) / 2) ((high - low) * pi / fromIntegral count) put

-- | A disc around all corners: its centre and radius.
disc :: Sides -> (Double, Double, Double)
disc sides = (cx, cy, U.maximum (U.cons 0 (U.zipWith far (startX sides) (startY sides))))
  where
    cx = middle (startX sides)
    cy = middle (startY sides)
    middle xs = if U.null xs then 0 else (U.minimum xs + U.maximum xs) / 2
    far x y = sqrt ((x - cx) ^ (2 :: Int) + (y - cy) ^ (2 :: Int))

-- | Where a line meets a side: how far along it, whether it goes into the solid there or out of it, and the side.
data Crossing = Crossing !Double !Passage !Int

data Passage = Enters | Leaves
  deriving (Eq, Ord)

-- | Adds a weight, divided by twice the length of the side, for every two things that the line with this direction and
-- offset x·sin − y·cos joins in free space.
along :: Sides -> Double -> Double -> Double -> Double -> (Int -> Int -> Double -> ST s ()) -> ST s ()
along sides !c !s !u !weight put = follow Nothing crossings
  where
    n = U.length (startX sides)
    sky = U.length (lengths sides)
    crossings = collect 0 []
    collect !i found
      | i >= n = found
      | (d < 0) == (d' < 0) = collect (i + 1) found
      | otherwise = collect (i + 1) (insertBy before crossing found)
      where
        d = startX sides U.! i * s - startY sides U.! i * c - u
        d' = endX sides U.! i * s - endY sides U.! i * c - u
        -- The solid is on the left: a side that comes from the right of the line has it behind. Offsets grow to the
        -- right.
        crossing = Crossing (meeting i) (if d > 0 then Leaves else Enters) (sideNumber sides U.! i)
    -- How far along the line a side is met: the same for both faces of a wall, which have the same ends.
    meeting i
      | (startX sides U.! i, startY sides U.! i) <= (endX sides U.! i, endY sides U.! i) =
          between (startX, startY) (endX, endY)
      | otherwise = between (endX, endY) (startX, startY)
      where
        between (ax, ay) (bx, by) =
          let x = ax sides U.! i
              y = ay sides U.! i
              x' = bx sides U.! i
              y' = by sides U.! i
              d = x * s - y * c - u
              d' = x' * s - y' * c - u
           in (x * c + y * s) + ((x' - x) * c + (y' - y) * s) * (d / (d - d'))
    before (Crossing a p _) (Crossing b q _) = compare (a, p) (b, q)
    -- What is behind on the line, if it is free there.
    follow back list = case list of
      [] -> maybe (pure ()) (`joined` sky) back
      Crossing _ Enters side : rest -> joined (maybe sky id back) side >> follow Nothing rest
      Crossing _ Leaves side : rest -> follow (Just side) rest
    joined a b = half a b >> half b a
    half from to
      | from < sky = put from to (weight / (2 * lengths sides U.! from))
      | otherwise = pure ()
{-# INLINE along #-}
