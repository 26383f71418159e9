{-# LANGUAGE OverloadedStrings #-}

module Visibility.Report.PlotSpec (spec) where

import qualified Data.Text as Text
import Test.Hspec
import Test.QuickCheck
import Visibility.Draw.Drawing
import Visibility.Report.Plot

spec :: Spec
spec =
  describe "a plot" $ do
    it "keeps all marks on its canvas and its labels apart" $
      forAll plots $ \plot ->
        let drawing = plotDrawing plot
         in (strayMarks drawing, [flaw | flaw@(LabelOnLabel _ _) <- labelCollisions drawing]) === ([], [])
    it "has a mark for each point that has a logarithm" $
      forAll plots $ \plot ->
        length (marksIn "points" (plotDrawing plot {plotSeries = map (\s -> s {seriesMarker = Square}) (plotSeries plot)}))
          === length [() | s <- plotSeries plot, (x, y) <- seriesPoints s, x > 0, y > 0]
    it "puts larger values further to the right and higher up" $
      forAll ((,) <$> positive <*> positive) $ \(x, y) ->
        let places = [p | Mark _ _ (Polyline ps) <- marksIn "lines" (plotDrawing (plotOf [[(x, y), (x * 3, y * 7)]])), p <- ps]
         in case places of
              [Place a b, Place c d] -> counterexample (show places) (a < c && b < d)
              _ -> counterexample (show places) False
  where
    positive = (10 **) <$> choose (-12, 12)
    plots = plotOf <$> listOf (listOf ((,) <$> value <*> value)) `suchThat` ((<= 8) . length)
    value = frequency [(9, positive), (1, pure 0)]

plotOf :: [[(Double, Double)]] -> Plot
plotOf found =
  Plot
    { plotTitle = "A plot"
    , plotDescription = "Points."
    , plotAcross = "across"
    , plotUpwards = "upwards"
    , plotSeries = [Series ("series " <> Text.pack (show k)) style marker points | (k, (style, marker), points) <- zip3 [1 :: Int ..] looks found]
    }
  where
    looks = zip [Series1 .. Series8] [minBound .. maxBound]
