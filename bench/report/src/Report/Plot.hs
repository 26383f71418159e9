{-# LANGUAGE OverloadedStrings #-}

-- | Plots by logarithms, in proportion or by names, as drawings.
module Report.Plot
  ( Plot (..)
  , Scale (..)
  , Series (..)
  , series1, series2, series3, series4, series5, series6, series7, series8, series9
  , Join (..)
  , Marker (..)
  , plotDrawing
  ) where

import Data.Maybe (mapMaybe)
import Data.Text (Text)
import Visibility.Draw.Drawing
import Visibility.Draw.Legend
import Visibility.Draw.Scale (decimalText, thinned)

-- | What is plotted.
data Plot = Plot
  { plotTitle :: !Text
  , plotDescription :: !Text
  , plotAcross :: !Scale
  , plotUpwards :: !Scale
  , plotSeries :: ![Series]
  }
  deriving (Eq, Show)

-- | What an axis tells, with its unit, and where a value has its place; points without one are left out.
data Scale
  = -- | By logarithms: in whole decades, or from 1, 2 or 5 times a power of ten to another where these are few; around
    -- 1 without values. What is not positive has no place.
    Decades !Text
  | -- | In proportion, from 0 on, a tick at each multiple of a power of ten; both ends keep clear of the frame, so that
    -- no point lies across it. What is negative has no place.
    Steps !Text
  | -- | Names at equal distances from the origin on, for the values 0, 1 and so on. Other values have no place.
    Names ![Text]
  deriving (Eq, Show)

-- | Points that belong together, from left to right as listed.
data Series = Series
  { seriesName :: !Text
  , seriesStyle :: !Style
  -- ^ One of the series styles.
  , seriesMarker :: !Marker
  , seriesJoin :: !Join
  , seriesPoints :: ![(Double, Double)]
  }
  deriving (Eq, Show)

-- | Whether a line joins the points of a series.
data Join = Joined | Apart
  deriving (Eq, Show)

-- | The shape of a point, so that series can be told apart without colour.
data Marker = Circle | Square | Triangle | Diamond | Cross | Plus | Wedge | Bar | Star
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | The plot: a faint line at each step of either axis, the legend below.
plotDrawing :: Plot -> Drawing
plotDrawing plot =
  Drawing
    { drawingTitle = plotTitle plot
    , drawingDescription = plotDescription plot
    , drawingWidth = width
    , drawingHeight = height
    , drawingLayers =
        [ Layer "grid" Sparse (map (plain Reference . Polyline) (vertical <> horizontal))
        , Layer "axes" Sparse [plain Axis (Polyline [at 0 1, at 0 0, at 1 0])]
        , Layer
            "lines"
            Sparse
            [Mark (seriesName s) (seriesStyle s) (Polyline places) | (s, places@(_ : _ : _)) <- shown, joined s]
        , Layer "points" Sparse [mark | (s, places) <- shown, p <- places, mark <- marker s p]
        , Layer "labels" Sparse labels
        , Layer "legend" Sparse (legend legendLeft legendTop legendWidth entries)
        ]
    }
  where
    width = 760
    -- Names keep clear of points on the axis.
    (left, gap) = case plotUpwards plot of
      Names names -> (maximum (78 : map ((+ 24) . textWidth TickLabel) names), 12)
      _ -> (78, 6)
    -- Half of the last number stands beyond its tick.
    right = width - maximum (24 : [textWidth TickLabel text / 2 + 6 | (_, text) <- take 1 (reverse (ticks across))])
    legendLeft = 24
    legendWidth = width - legendLeft - 12
    entries = map entry (plotSeries plot)
    legendTop = legendHeight legendWidth entries + 8
    bottom = legendTop + 56
    top = bottom + case plotUpwards plot of
      Names names -> max 120 (17 * fromIntegral (length names))
      _ -> 360
    height = top + 54
    across = rulerFor (plotAcross plot) (map fst points)
    upwards = rulerFor (plotUpwards plot) (map snd points)
    points = concatMap seriesPoints (plotSeries plot)
    shown = [(s, mapMaybe toPlace (seriesPoints s)) | s <- plotSeries plot]
    toPlace (a, b) = at <$> place across a <*> place upwards b
    joined s = seriesJoin s == Joined
    -- A place by the parts of both axes.
    at x y = Place (left + (right - left) * x) (bottom + (top - bottom) * y)
    vertical = [[at x 0, at x 1] | x <- steps across]
    horizontal = [[at 0 y, at 1 y] | y <- steps upwards]
    labels =
      [plain FigureTitle (Label StartAnchor (Place 14 (height - 22)) (plotTitle plot))]
        <> [ plain TickLabel (Label MiddleAnchor (Place x (bottom - 18)) text)
           | (part, text) <- ticks across
           , let Place x _ = at part 0
           ]
        <> [ plain TickLabel (Label EndAnchor (Place (left - gap) (y - 4)) text)
           | (part, text) <- ticks upwards
           , let Place _ y = at 0 part
           ]
        <> [plain AxisTitle (Label EndAnchor (Place right (bottom - 40)) text) | text <- titleOf (plotAcross plot)]
        <> [plain AxisTitle (Label StartAnchor (Place left (top + 8)) text) | text <- titleOf (plotUpwards plot)]
    entry s = Entry (\(Box l b r t) -> swatch s l b r t) (seriesName s)
    swatch s l b r t =
      [plain (seriesStyle s) (Polyline [Place l ((b + t) / 2), Place r ((b + t) / 2)]) | joined s]
        <> marker s (Place ((l + r) / 2) ((b + t) / 2))

titleOf :: Scale -> [Text]
titleOf scale = case scale of
  Decades title -> [title]
  Steps title -> [title]
  Names _ -> []

-- | An axis, all places on it as parts of its length.
data Ruler = Ruler
  { place :: Double -> Maybe Double
  , steps :: [Double]
  -- ^ Where the faint lines are.
  , ticks :: [(Double, Text)]
  }

-- | The axis that has room for all these values, as far as they have a place.
rulerFor :: Scale -> [Double] -> Ruler
rulerFor scale values = case scale of
  Decades _ ->
    Ruler
      { place = \v -> if positive v then Just (between (logBase 10 v)) else Nothing
      , steps = map (between . exponent10) (drop 1 marks)
      , -- Not more labels than there is room for.
        ticks =
          [ (between (exponent10 r), roundText r)
          | (k, r) <- zip [0 ..] marks
          , k `elem` thinned 12 0 (length marks - 1)
          ]
      }
  Steps _ ->
    Ruler
      { place = \v -> if v >= 0 && finite v then Just (inset (v / end)) else Nothing
      , steps = multiples
      , ticks = [(part, multiple k) | (part, k) <- zip multiples [0 :: Int ..]]
      }
  Names names ->
    let count = length names
        part k = (fromIntegral k + 0.5) / fromIntegral count
        known = zip [0 :: Int ..] names
     in Ruler
          { place = \v -> case [k | (k, _) <- known, fromIntegral k == v] of
              k : _ -> Just (part k)
              [] -> Nothing
          , steps = [fromIntegral k / fromIntegral count | (k, _) <- drop 1 known]
          , ticks = [(part k, name) | (k, name) <- known]
          }
  where
    finite v = not (isInfinite v || isNaN v)
    positive v = v > 0 && finite v
    marks = roundNumbers (filter positive values)
    (low, high) = (minimum heights, maximum heights)
    heights = map exponent10 marks
    between l = (l - low) / (high - low)
    largest = maximum (1 : filter finite values)
    power = max 0 (ceiling (logBase 10 (largest / 12))) :: Int
    step = 10 ^ power :: Double
    count' = max 1 (ceiling (largest / step)) :: Int
    end = fromIntegral count' * step
    multiple k = decimalText (fromIntegral k * 10 ^ power)
    multiples = [inset (fromIntegral k / fromIntegral count') | k <- [0 .. count']]
    inset part = 0.015 + 0.97 * part

-- | A round number: 1, 2 or 5 times a power of ten.
data Round = Round !Int !Int

-- | The logarithm.
exponent10 :: Round -> Double
exponent10 (Round m k) = logBase 10 (fromIntegral m) + fromIntegral k

-- | Ascending round numbers, at least two, with all values between the first and the last and none at an end: powers of
-- ten, or also 2 and 5 times these where that makes at most ten.
roundNumbers :: [Double] -> [Round]
roundNumbers values
  | null logs = [Round 1 (-1), Round 1 0, Round 1 1]
  | length fine <= 10 = fine
  | otherwise = around [1]
  where
    logs = map (logBase 10) values
    (least, most) = (minimum logs - 0.1, maximum logs + 0.05)
    fine = around [1, 2, 5]
    around factors =
      let all' = [Round m k | k <- [floor least - 1 .. ceiling most + 1], m <- factors]
          below = [r | r <- all', exponent10 r <= least]
          inside = [r | r <- all', exponent10 r > least, exponent10 r < most]
          above = [r | r <- all', exponent10 r >= most]
       in drop (length below - 1) below <> inside <> take 1 above

-- | As all figures have numbers.
roundText :: Round -> Text
roundText (Round m k) = decimalText (fromIntegral m * 10 ^^ k)

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
      Star ->
        [ Polyline [at (-6 * cos a) (-6 * sin a), at (6 * cos a) (6 * sin a)]
        | k <- [0 .. 2 :: Int]
        , let a = pi * (fromIntegral k + 0.5) / 3
        ]
    at dx dy = Place (x + dx) (y + dy)

-- | The styles of series, which differ in lightness too.
series1, series2, series3, series4, series5, series6, series7, series8, series9 :: Style
series1 = PlotLine "#1f1f1f"
series2 = PlotLine "#1f62a8"
series3 = PlotLine "#b3122a"
series4 = PlotLine "#2b7a3d"
series5 = PlotLine "#a8641b"
series6 = PlotLine "#6b4a9e"
series7 = PlotLine "#7a7a7a"
series8 = PlotLine "#00808c"
series9 = PlotLine "#b5308c"
