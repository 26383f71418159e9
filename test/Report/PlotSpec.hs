{-# LANGUAGE OverloadedStrings #-}

module Report.PlotSpec (spec) where

import qualified Data.Text as Text
import Test.Hspec
import Test.QuickCheck
import Visibility.Draw.Checks
import Visibility.Draw.Drawing
import Report.Plot

spec :: Spec
spec =
  describe "a plot" $ do
    it "keeps all marks on its canvas and its labels apart" $
      forAll plots $ \plot ->
        let drawing = plotDrawing plot
         in (strayMarks drawing, [flaw | flaw@(LabelOnLabel _ _) <- labelCollisions drawing]) === ([], [])
    it "has a mark for each point that has a place on both axes" $
      forAll plots $ \plot ->
        let squares = plot {plotSeries = map (\s -> s {seriesMarker = Square}) (plotSeries plot)}
            expected =
              length
                [ ()
                | s <- plotSeries plot
                , (x, y) <- seriesPoints s
                , hasPlace (plotAcross plot) x
                , hasPlace (plotUpwards plot) y
                ]
         in cover 20 (expected > 0) "points" (length (marksIn "points" (plotDrawing squares)) === expected)
    it "puts larger values further to the right and higher up" $
      forAll ((,) <$> positive <*> positive) $ \(x, y) ->
        forAll ((,) <$> elements [Decades "a", Steps "a"] <*> elements [Decades "b", Steps "b"]) $ \(across, upwards) ->
          case lineOf across upwards [(x, y), (x * 3, y * 7)] of
            [Place a b, Place c d] -> counterexample (show (a, b, c, d)) (a < c && b < d)
            places -> counterexample (show places) False
    it "puts values in proportion where it goes by steps" $
      forAll ((,) <$> choose (1, 70) <*> choose (1, 70)) $ \(x, y) ->
        case lineOf (Steps "a") (Decades "b") [(0, 1), (x, 1), (x + y, 1)] of
          [Place a _, Place b _, Place c _] ->
            counterexample (show (a, b, c)) (abs ((b - a) * (x + y) - (c - a) * x) < 1e-6)
          places -> counterexample (show places) False
    it "keeps points clear of the frame where it goes by steps and by names" $
      forAll (listOf1 ((,) <$> (fromIntegral <$> choose (0, 70 :: Int)) <*> elements [0, 1, 2])) $ \points ->
        let drawing = plotDrawing (plotOf (Steps "a") (Names ["first", "second", "third"]) [points])
            shapes = concat [ps | Mark _ _ (Region ps) <- marksIn "points" drawing]
         in case marksIn "axes" drawing of
              [Mark _ _ (Polyline [Place left top, Place _ bottom, Place right _])] ->
                counterexample (show (left, right, bottom, top, shapes)) $
                  [p | p@(Place x y) <- shapes, not (left < x && x < right && bottom < y && y < top)] === []
              other -> counterexample (show other) False
    it "puts names in their order from the origin on" $
      case lineOf (Steps "a") (Names ["first", "second", "third"]) [(1, 0), (1, 1), (1, 2), (1, 3), (1, 0.5)] of
        [Place _ a, Place _ b, Place _ c] -> (a < b && b < c, abs ((b - a) - (c - b)) < 1e-6) `shouldBe` (True, True)
        places -> expectationFailure (show places)
    it "joins no points that stand apart" $
      forAll plots $ \plot ->
        let apart = plot {plotSeries = map (\s -> s {seriesJoin = Apart}) (plotSeries plot)}
         in length (marksIn "lines" (plotDrawing apart)) === 0
  where
    positive = (10 **) <$> choose (-12, 12)
    lineOf across upwards points =
      [p | Mark _ _ (Polyline ps) <- marksIn "lines" (plotDrawing (plotOf across upwards [points])), p <- ps]
    plots = do
      across <- elements [Decades "across", Steps "across", Names ["left", "middle", "right"]]
      names <- choose (1, 30)
      upwards <- elements [Decades "upwards", Steps "upwards", Names (map named [1 .. names :: Int])]
      plotOf across upwards <$> listOf (listOf ((,) <$> value <*> value)) `suchThat` ((<= 9) . length)
    named k = "name " <> Text.pack (show k)
    value = frequency [(9, positive), (6, fromIntegral <$> choose (-1, 30 :: Int)), (1, pure (1 / 0))]

-- | Has a value a place on an axis?
hasPlace :: Scale -> Double -> Bool
hasPlace axis v = case axis of
  Decades _ -> v > 0 && not (isInfinite v)
  Steps _ -> v >= 0 && not (isInfinite v)
  Names names -> v `elem` map fromIntegral [0 .. length names - 1]

plotOf :: Scale -> Scale -> [[(Double, Double)]] -> Plot
plotOf across upwards found =
  Plot
    { plotTitle = "A plot"
    , plotDescription = "Points."
    , plotAcross = across
    , plotUpwards = upwards
    , plotSeries =
        [ Series ("series " <> Text.pack (show k)) style marker Joined points
        | (k, (style, marker), points) <- zip3 [1 :: Int ..] looks found
        ]
    }
  where
    looks = zip series [minBound .. maxBound]
    series = [series1, series2, series3, series4, series5, series6, series7, series8, series9]
