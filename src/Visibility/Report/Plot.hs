{-# LANGUAGE OverloadedStrings #-}

-- | Plots with logarithmic axes, as drawings.
module Visibility.Report.Plot
  ( Plot (..)
  , Series (..)
  , Marker (..)
  , plotDrawing
  ) where

import Data.Text (Text)
import qualified Data.Text as Text
import Visibility.Draw.Drawing
import Visibility.Draw.Legend

-- | What is plotted. Points with a coordinate that is not positive are left out.
data Plot = Plot
  { plotTitle :: !Text
  , plotDescription :: !Text
  , plotAcross :: !Text
  -- ^ What the horizontal axis tells, with its unit.
  , plotUpwards :: !Text
  , plotSeries :: ![Series]
  }
  deriving (Eq, Show)

-- | Points that belong together, from left to right as listed, and whether a line joins them.
data Series = Series
  { seriesName :: !Text
  , seriesStyle :: !Style
  -- ^ One of the series styles.
  , seriesMarker :: !Marker
  , seriesPoints :: ![(Double, Double)]
  }
  deriving (Eq, Show)

-- | The shape of a point, so that series can be told apart without colour.
data Marker = Circle | Square | Triangle | Diamond | Cross | Plus | Wedge | Bar
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | The plot: both axes in decades, a faint line at each, the legend below.
--
-- /Degenerate cases/ axes span at least one decade; without points, one around 1.
plotDrawing :: Plot -> Drawing
plotDrawing plot =
  Drawing
    { drawingTitle = plotTitle plot
    , drawingDescription = plotDescription plot
    , drawingWidth = width
    , drawingHeight = height
    , drawingLayers =
        [ Layer "grid" Sparse (map (plain Reference . Polyline) (vertical <> horizontal))
        , Layer "axes" Sparse [plain Axis (Polyline [at x0 y1, at x0 y0, at x1 y0])]
        , Layer "lines" Sparse [Mark (seriesName s) (seriesStyle s) (Polyline (map toPlace (seriesPoints s))) | s <- shown, joinedUp s]
        , Layer "points" Sparse [mark | s <- shown, p <- seriesPoints s, mark <- marker s (toPlace p)]
        , Layer "labels" Sparse labels
        , Layer "legend" Sparse (legend left legendTop (width - left - 12) (map entry (plotSeries plot)))
        ]
    }
  where
    width = 760
    left = 78
    right = width - 24
    entries = legendHeight (width - left - 12) (map entry (plotSeries plot))
    legendTop = entries + 8
    bottom = legendTop + 56
    top = bottom + 360
    height = top + 54
    shown = [s {seriesPoints = filter positive (seriesPoints s)} | s <- plotSeries plot]
    positive (x, y) = x > 0 && y > 0 && not (isInfinite x || isInfinite y)
    joinedUp s = length (seriesPoints s) > 1
    points = concatMap seriesPoints shown
    (x0, x1) = decades (map fst points)
    (y0, y1) = decades (map snd points)
    toPlace (x, y) = Place (spread left right x0 x1 x) (spread bottom top y0 y1 y)
    spread low high from to v = low + (high - low) * (logBase 10 v - fromIntegral from) / fromIntegral (to - from)
    vertical = [[at x y0, at x y1] | x <- [x0 + 1 .. x1]]
    horizontal = [[at x0 y, at x1 y] | y <- [y0 + 1 .. y1]]
    at x y = Place (spread left right x0 x1 (10 ^^ x)) (spread bottom top y0 y1 (10 ^^ y))
    labels =
      [plain FigureTitle (Label StartAnchor (Place 14 (height - 22)) (plotTitle plot))]
        <> [plain TickLabel (Label MiddleAnchor (Place x (bottom - 18)) (decade k)) | k <- every x0 x1, let Place x _ = at k y0]
        <> [plain TickLabel (Label EndAnchor (Place (left - 6) (y - 4)) (decade k)) | k <- every y0 y1, let Place _ y = at x0 k]
        <> [ plain AxisTitle (Label EndAnchor (Place right (bottom - 40)) (plotAcross plot))
           , plain AxisTitle (Label StartAnchor (Place left (top + 8)) (plotUpwards plot))
           ]
    -- Not more labels than there is room for.
    every from to = [from, from + max 1 ((to - from + 11) `div` 12) .. to]
    entry s = Entry (\(Box l b r t) -> swatch s l b r t) (seriesName s)
    swatch s l b r t =
      [plain (seriesStyle s) (Polyline [Place l ((b + t) / 2), Place r ((b + t) / 2)])]
        <> marker s (Place ((l + r) / 2) ((b + t) / 2))

-- | The decades that hold all values, at least one.
decades :: [Double] -> (Int, Int)
decades values
  | null logs = (-1, 1)
  | otherwise = let low = floor (minimum logs - 0.1) in (low, max (low + 1) (ceiling (maximum logs + 0.05)))
  where
    logs = map (logBase 10) values

decade :: Int -> Text
decade k
  | k `elem` [0, 1, 2, 3] = Text.pack (show ((10 :: Int) ^ k))
  | k < 0 = "1e−" <> Text.pack (show (negate k))
  | otherwise = "1e" <> Text.pack (show k)

marker :: Series -> Place -> [Mark]
marker s (Place x y) = map (Mark (seriesName s) (seriesStyle s)) shapes
  where
    shapes = case seriesMarker s of
      Circle -> [Region [at (4 * cos a) (4 * sin a) | k <- [0 .. 15 :: Int], let a = pi * fromIntegral k / 8]]
      Square -> [Region [at (-3.6) (-3.6), at 3.6 (-3.6), at 3.6 3.6, at (-3.6) 3.6]]
      Triangle -> [Region [at (-4.4) (-3.2), at 4.4 (-3.2), at 0 4.8]]
      Diamond -> [Region [at 0 (-5), at 5 0, at 0 5, at (-5) 0]]
      Cross -> [Polyline [at (-4) (-4), at 4 4], Polyline [at (-4) 4, at 4 (-4)]]
      Plus -> [Polyline [at (-5) 0, at 5 0], Polyline [at 0 (-5), at 0 5]]
      Wedge -> [Region [at (-4.4) 3.2, at 4.4 3.2, at 0 (-4.8)]]
      Bar -> [Region [at (-5.5) (-1.8), at 5.5 (-1.8), at 5.5 1.8, at (-5.5) 1.8]]
    at dx dy = Place (x + dx) (y + dy)
