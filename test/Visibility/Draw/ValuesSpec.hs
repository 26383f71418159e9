module Visibility.Draw.ValuesSpec (spec) where

import Data.Foldable (for_)
import Data.List (sort)
import qualified Data.Text as Text
import Test.Hspec
import Test.QuickCheck hiding (scale)
import Visibility.Draw.Colour
import Visibility.Draw.Drawing
import Visibility.Draw.Values

spec :: Spec
spec = do
  describe "a scale" $ do
    it "holds the values that it was made for, the greatest at its end" $
      forAll scalings $ \scaling ->
        forAll (listOf1 positive) $ \values ->
          let places = map (placeOn (fitted scaling values)) values
           in counterexample (show places) (all (\t -> t >= 0 && t <= 1) places && maximum places >= 1 - 1e-9)
    it "begins at 0 if it is linear, and at the least value or a tenth of the greatest if it is logarithmic" $
      forAll (listOf1 positive) $ \values -> do
        let least = min (minimum values) (maximum values / 10)
        placeOn (fitted Linear values) 0 `shouldBe` 0
        placeOn (fitted Linear values) (maximum values / 4) `shouldSatisfy` close 0.25
        placeOn (fitted Logarithmic values) least `shouldSatisfy` close 0
        placeOn (fitted Logarithmic values) (sqrt least * sqrt (maximum values)) `shouldSatisfy` close 0.5
    it "is monotone, whatever the values" $
      forAll scalings $ \scaling ->
        forAll ((,,) <$> listOf anyValue <*> anyValue <*> anyValue) $ \(values, x, y) ->
          let scale = fitted scaling values in x <= y ==> placeOn scale x <= placeOn scale y
  describe "its ticks" $ do
    it "rise, are on it, and are not too many, but several" $
      forAll scalings $ \scaling ->
        forAll ((,) <$> listOf anyValue <*> choose (4, 9)) $ \(values, most) ->
          let places = map fst (ticks (fitted scaling values) most)
           in counterexample (show places) $
                sort places == places
                  && all (\t -> t >= 0 && t <= 1) places
                  && length places >= 2
                  && length places <= most + 1
    it "are where their values are" $ do
      let linear = fitted Linear [0.3, 2]
          logarithmic = fitted Logarithmic [0.0009, 1]
      map (Text.unpack . snd) (ticks linear 4) `shouldBe` ["0", "0.5", "1", "1.5", "2"]
      map (Text.unpack . snd) (ticks logarithmic 4) `shouldBe` ["0.001", "0.01", "0.1", "1"]
      for_ [linear, logarithmic] $ \scale ->
        [text | (t, text) <- ticks scale 4, not (close t (placeOn scale (read (Text.unpack text))))] `shouldBe` []
    it "keep their texts apart across a width, and are among those without one" $
      forAll scalings $ \scaling ->
        forAll ((,) <$> listOf anyValue <*> choose (60, 900)) $ \(values, width) ->
          let scale = fitted scaling values
              found = ticksAcross width (ticks scale)
              boxes = [textBoxAt TickLabel MiddleAnchor (Place (t * width) 0) text | (t, text) <- found]
           in conjoin
                [ counterexample (show boxes) (not (or (zipWith boxesMeet boxes (drop 1 boxes))))
                , counterexample "no tick" (not (null boxes))
                , counterexample "other ticks" (or [take (length found) (ticks scale most) == found | most <- [1 .. 8]])
                ]
  describe "the colour of a value" $
    it "is monotone in it, in the direction of the tone" $
      forAll scalings $ \scaling ->
        forAll ((,,) <$> listOf anyValue <*> anyValue <*> anyValue) $ \(values, x, y) ->
          let scale = fitted scaling values
           in x <= y ==>
                shadeOf MoreIsBrighter scale x <= shadeOf MoreIsBrighter scale y
                  && shadeOf MoreIsDarker scale x >= shadeOf MoreIsDarker scale y
  describe "the colour bar" $
    it "has every colour once, side by side, in the order of the values" $
      forAll scalings $ \scaling ->
        forAll ((,) <$> listOf anyValue <*> elements [MoreIsBrighter, MoreIsDarker]) $ \(values, tone) ->
          let scale = fitted scaling values
              (cells, _) = colourBar tone scale (Box 10 20 414 32)
              found = [(shade, x, x') | Mark _ (Cell shade) (Region [Place x _, Place x' _, _, _]) <- cells]
              inOrder = if tone == MoreIsBrighter then shades else reverse shades
           in conjoin
                [ [shade | (shade, _, _) <- found] === inOrder
                , counterexample (show found) (and (zipWith (\(_, _, a) (_, b, _) -> close a b) found (drop 1 found)))
                ]
  where
    scalings = elements [minBound .. maxBound]
    positive = (10 **) <$> choose (-12, 12)
    anyValue = frequency [(8, positive), (1, pure 0), (1, negate <$> positive), (1, (10 **) <$> choose (-320, 320))]
    close x y = abs (x - y) < 1e-9
