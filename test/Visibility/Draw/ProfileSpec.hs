{-# LANGUAGE OverloadedStrings #-}

module Visibility.Draw.ProfileSpec (spec) where

import Data.List (nub, sort)
import Data.Ratio ((%))
import Test.Hspec
import Test.QuickCheck
import Visibility.Draw.Colour
import Visibility.Draw.Checks
import Visibility.Draw.Drawing
import Visibility.Draw.Radiosity
import Visibility.Draw.Values
import Visibility.Exact.Point
import Visibility.Scene

spec :: Spec
spec = do
  describe "a panel" $ do
    it "has an area for each step, in its colour, as far and as high as its value is" $
      forAll profiles $ \(scaling, profile) ->
        let scale' = scaleOf scaling profile
            steps = profileSteps profile
            found =
              [ (shade, l, r, b, t)
              | Mark _ (Band shade) (Region [Place l b, Place r _, Place _ t, _]) <- panelAreas (panel scaling profile)
              ]
            isDrawn (shade, l, r, b, t) (LitElement _ from to _ value) =
              shade == shadeAt value
                && close (l - left) (fromRational from * (right - left))
                && close (r - left) (fromRational to * (right - left))
                && close (t - b) (placeOn scale' value * (top - bottom))
         in counterexample (show found) (length found == length steps && and (zipWith isDrawn found steps))
    it "has a tick above the axis at each end of a step, once" $
      forAll profiles $ \(scaling, profile) ->
        let axes = panelAxes (panel scaling profile)
            xs = sort [x | Mark _ Tick (Polyline [Place x y, Place _ y']) <- axes, y' > y, y >= bottom]
            at s = left + fromRational s * (right - left)
            breaks = sort (nub [s | part <- profileSteps profile, s <- [litFrom part, litTo part], s > 0, s < 1])
         in counterexample (show (xs, breaks)) $
              length xs == length breaks && and (zipWith close xs (map at breaks))
    it "interrupts its line where steps do not follow each other" $ do
      let lines' steps = length (panelLines (panel Linear (profileOf steps)))
      lines' [step 0 (1 % 3) 1, step (1 % 3) 1 2] `shouldBe` 1
      lines' [step 0 (1 % 3) 1, step (1 % 2) 1 2] `shouldBe` 2
      lines' [] `shouldBe` 0
    it "keeps to its box, and its labels apart" $
      forAll profiles $ \(scaling, profile) ->
        let Panel areas curves axes texts = panel scaling profile
            layers = [Layer "a" Sparse areas, Layer "b" Sparse (curves <> axes), Layer "c" Sparse texts]
            drawing = Drawing "" "" 768 panelHeight layers
         in (strayMarks drawing, labelCollisions drawing) === ([], [])
  where
    panel scaling profile = profilePanel shadeAt (scaleOf scaling profile) 0 panelHeight 768 profile
    scaleOf scaling profile = fitted scaling (map litValue (profileSteps profile))
    -- The ends of the axes.
    (left, bottom, right, top) =
      case [places | Mark _ Axis (Polyline places) <- panelAxes (panel Linear (profileOf []))] of
        [Place l t, Place _ b, Place r _] : _ -> (l, b, r, t)
        _ -> (0, 0, 0, 0)
    close x y = abs (x - y) < 1e-6

profileOf :: [LitElement] -> Profile
profileOf = Profile "E.0" "radiosity B" 3.7

step :: Rational -> Rational -> Double -> LitElement
step from to = LitElement (SideName Enclosure 0) from to (Point from 0, Point to 0)

-- | Steps in order, with gaps between some.
profiles :: Gen (Scaling, Profile)
profiles = do
  ends <- nub . sort <$> listOf ((% 60) <$> choose (0, 60))
  found <- sublistOf (zip ends (drop 1 ends))
  steps <- traverse (\(a, b) -> step a b . (10 **) <$> choose (-6, 2)) found
  (,) <$> elements [minBound .. maxBound] <*> pure (profileOf steps)
