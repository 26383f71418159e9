{-# LANGUAGE BangPatterns #-}

-- | Form factors by quadrature of the double integral, in Doubles.
--
-- /Source/ Orti, Rivière, Durand, Puech, Using the visibility complex for radiosity computation, equation 3: the inner
-- integral over what a point sees of a side is half the difference of two sines.
module Estimate.Points
  ( pointQuadrature
  ) where

import Control.Monad (forM_, when)
import Control.Monad.ST (ST)
import Data.List (sort)
import qualified Data.Vector.Unboxed as U
import Estimate.Matrix

-- | So many points on each side, the middles of equal parts; what each sees is found in Doubles, ray by ray.
--
-- /Cost/ O(n²) for each point.
pointQuadrature :: Int -> Sides -> Matrix
pointQuadrature count sides = matrixFrom (U.length (lengths sides)) $ \put ->
  forM_ [0 .. n - 1] $ \i ->
    forM_ [0 .. count - 1] $ \k -> seenFrom sides i ((fromIntegral k + 0.5) / fromIntegral count) count put
  where
    n = U.length (startX sides)

-- | Adds what a point of a side sees, by angles from the normal of the side, which points to its right.
seenFrom :: Sides -> Int -> Double -> Int -> (Int -> Int -> Double -> ST s ()) -> ST s ()
seenFrom sides !i !t !count put =
  forM_ (zip angles (drop 1 angles)) $ \(low, high) ->
    when (high > low) $ put own (hit ((low + high) / 2)) (weight * (sin high - sin low) / 2)
  where
    n = U.length (startX sides)
    own = sideNumber sides U.! i
    (x0, y0, x1, y1) = ends i
    ends j = (startX sides U.! j, startY sides U.! j, endX sides U.! j, endY sides U.! j)
    px = x0 + t * (x1 - x0)
    py = y0 + t * (y1 - y0)
    size = sqrt ((x1 - x0) ^ (2 :: Int) + (y1 - y0) ^ (2 :: Int))
    -- Along the side, and its normal.
    (ax, ay) = ((x1 - x0) / size, (y1 - y0) / size)
    (nx, ny) = (ay, negate ax)
    -- A piece of a side counts by its part of the whole.
    weight = size / (lengths sides U.! own * fromIntegral count)
    angles =
      sort
        ( -(pi / 2)
            : pi / 2
            : [ atan2 (dx * ax + dy * ay) forward
              | j <- [0 .. n - 1]
              , let dx = startX sides U.! j - px
              , let dy = startY sides U.! j - py
              , let forward = dx * nx + dy * ny
              , forward > 0
              ]
        )
    -- The nearest thing on a ray.
    hit angle = nearest 0 (1 / 0) (U.length (lengths sides))
      where
        rx = nx * cos angle + ax * sin angle
        ry = ny * cos angle + ay * sin angle
        nearest !j !best !found
          | j >= n = found
          | j /= i && not otherFace && straddles && distance > 0 && distance < best =
              nearest (j + 1) distance (sideNumber sides U.! j)
          | otherwise = nearest (j + 1) best found
          where
            (ux, uy, vx, vy) = ends j
            -- The other face of a wall is in the same place.
            otherFace = (ux, uy, vx, vy) == (x1, y1, x0, y0)
            -- On which side of the ray the ends are; a ray meets a side from its free flank.
            a = rx * (uy - py) - ry * (ux - px)
            b = rx * (vy - py) - ry * (vx - px)
            straddles = a > 0 && b <= 0
            distance = ((ux - px) * (vy - uy) - (uy - py) * (vx - ux)) / (rx * (vy - uy) - ry * (vx - ux))
