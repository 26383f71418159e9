{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE OverloadedStrings #-}

-- | Paths of SVG in few characters: places in hundredths of a pixel, without what readers of SVG do without, as leading
-- and trailing zeros, spaces, and commands that are repeated.
--
-- Places of drawings are in pixels with y upwards, those of paths with y downwards from the height of the drawing.
module Visibility.Draw.Path
  ( linePath
  , regionPath
  , circlePath
  , squarePath
  , groundPath
  ) where

import Data.ByteString.Builder
import Visibility.Draw.Drawing (Place (..))

-- | A step from one place to the next: along a line, or an arc by its two control points and its end, all of them from
-- where it begins.
data Step = Along !Char !Double !Double | Arc ![(Double, Double)]

-- | The lines that join places. /Laws/ every place is off by half a hundredth at most, and by a ten-thousandth for each
-- place before it.
linePath :: Double -> [Place] -> Builder
linePath height places = case places of
  [] -> mempty
  start : others -> subpath height start (zipWith line places others)

-- | The closed line around a region. Its last piece is not written.
regionPath :: Double -> [Place] -> Builder
regionPath height places = linePath height places <> char7 'Z'

line :: Place -> Place -> Step
line (Place x y) (Place x' y') = Along (if dy == 0 then 'h' else if dx == 0 then 'v' else 'l') dx dy
  where
    (dx, dy) = (x' - x, y - y')

-- | A circle around a place: four arcs, as Bézier curves that are off by less than a thousandth of the radius.
circlePath :: Double -> Double -> Place -> Builder
circlePath height r (Place x y) =
  subpath height (Place (x + r) y) (map quarter [(0, -1), (-1, 0), (0, 1), (1, 0)]) <> char7 'Z'
  where
    -- Along the circle, beginning in a direction; then turning by a right angle to the right.
    quarter (ux, uy) =
      Arc [(k * ux, k * uy), (r * ux + (r - k) * uy, r * uy - (r - k) * ux), (r * (ux + uy), r * (uy - ux))]
    k = r * 4 * (sqrt 2 - 1) / 3

-- | A square around a place, by half the length of its sides.
squarePath :: Double -> Double -> Place -> Builder
squarePath height r (Place x y) = box height (Place (x + r) (y - r)) (2 * r) (2 * r)

-- | All of a drawing, by its width and its height.
groundPath :: Double -> Double -> Builder
groundPath width height = box height (Place width 0) width height

-- | From the lower right corner upwards.
box :: Double -> Place -> Double -> Double -> Builder
box height corner across up =
  subpath height corner [Along 'l' 0 (negate up), Along 'h' (negate across) 0, Along 'l' 0 up] <> char7 'Z'

-- Steps are rounded to ten-thousandths of a pixel, then the places to which they lead to hundredths. So nothing adds up
-- that can be seen.
subpath :: Double -> Place -> [Step] -> Builder
subpath height (Place x0 y0) = go 'M' startX startY begun
  where
    startX = tenThousandths x0
    startY = tenThousandths (height - y0)
    begun = char7 'M' <> first (hundredths startX) <> next (hundredths startY)
    go _ _ _ !written [] = written
    go before !x !y !written (step : others) = case step of
      Along letter dx dy ->
        let !x' = x + tenThousandths dx
            !y' = y + tenThousandths dy
            (!across, !down) = (hundredths x' - hundredths x, hundredths y' - hundredths y)
            said = case letter of
              'h' -> value across
              'v' -> value down
              _ -> value across <> next down
            value = if letter == before then next else \v -> char7 letter <> first v
         in go letter x' y' (written <> said) others
      Arc points ->
        let tos = [(x + tenThousandths dx, y + tenThousandths dy) | (dx, dy) <- points]
            ways = concat [[hundredths a - hundredths x, hundredths b - hundredths y] | (a, b) <- tos]
            (x', y') = last' tos
         in go 'c' x' y' (written <> list (before == 'c') ways) others
    last' = foldl (\_ to -> to) (startX, startY)
    list isSame ways = case ways of
      v : vs | not isSame -> char7 'c' <> first v <> foldMap next vs
      _ -> foldMap next ways
    -- A number after a letter, and after another number.
    first v = if v < 0 then char7 '-' <> decimal (negate v) else decimal v
    next v = if v < 0 then first v else char7 ' ' <> decimal v

-- | To the nearest.
tenThousandths :: Double -> Int
tenThousandths v = if v < 0 then negate (magnitude (negate v)) else magnitude v
  where
    magnitude a = truncate (a * 10000 + 0.5)

hundredths :: Int -> Int
hundredths v = (v + 50) `div` 100

-- | A number of hundredths that is not negative.
decimal :: Int -> Builder
decimal v = case v `quotRem` 100 of
  (whole, 0) -> intDec whole
  (whole, part) -> (if whole == 0 then mempty else intDec whole) <> char7 '.' <> digits part
  where
    digits part = case part `quotRem` 10 of
      (tens, 0) -> intDec tens
      (tens, ones) -> intDec tens <> intDec ones
