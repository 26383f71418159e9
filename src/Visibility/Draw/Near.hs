-- | Segments on the canvas by where they are, to find those that are near another one.
module Visibility.Draw.Near
  ( Grid
  , gridOf
  , nearTo
  ) where

import Data.List (foldl')
import qualified Data.IntSet as IntSet
import qualified Data.Map.Strict as Map
import Visibility.Draw.Drawing

-- | The squares of a grid as wide as a reach, each with the numbers of the segments that run through it.
data Grid = Grid
  { gridReach :: !Double
  , gridSquares :: !(Map.Map (Int, Int) [Int])
  }

-- | The grid of segments, which are numbered from 0, for a reach in pixels.
--
-- /Requires/ a reach of more than 0. /Cost/ O(n log n) for n segments, times their lengths in reaches.
gridOf :: Double -> [(Place, Place)] -> Grid
gridOf reach segments =
  Grid reach (foldl' add Map.empty [(at, k) | (k, s) <- zip [0 ..] segments, at <- squares reach 0 s])
  where
    add found (at, k) = Map.insertWith (<>) at [k] found

-- | The numbers of at least all segments that come nearer to a segment than the reach, ascending.
--
-- /Cost/ that of the segments in the squares around it. /Laws/ none that is nearer is missing.
nearTo :: Grid -> (Place, Place) -> [Int]
nearTo grid segment =
  IntSet.toAscList . IntSet.fromList $
    concat [Map.findWithDefault [] at (gridSquares grid) | at <- squares reach reach segment]
  where
    reach = gridReach grid

-- | The squares of a width that have a point no further than a margin from a segment, by column and row.
--
-- Rounding is not felt: a little is added on all sides.
squares :: Double -> Double -> (Place, Place) -> [(Int, Int)]
squares width margin (Place x0 y0, Place x1 y1) =
  [ (column, row)
  | column <- [number (left - wider) .. number (right + wider)]
  , let ends = [fromIntegral column * width - wider, fromIntegral (column + 1) * width + wider]
  , let here = map (kept left right) ends
  , let heights = if x0 == x1 then [y0, y1] else map heightAt here
  , row <- [number (minimum heights - wider) .. number (maximum heights + wider)]
  ]
  where
    wider = margin + 1e-3
    number v = floor (v / width) :: Int
    (left, right) = (min x0 x1, max x0 x1)
    kept low high = max low . min high
    heightAt x = kept (min y0 y1) (max y0 y1) (y0 + (y1 - y0) * (x - x0) / (x1 - x0))
