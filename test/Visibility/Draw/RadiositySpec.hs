{-# LANGUAGE OverloadedStrings #-}

module Visibility.Draw.RadiositySpec (spec) where

import Data.Foldable (for_)
import Data.List (nub, partition, sort, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Text as Text
import Test.Hspec
import Test.QuickCheck
import Visibility.Draw.Colour
import Visibility.Draw.DirectLight
import Visibility.Draw.Checks
import Visibility.Draw.Drawing
import Visibility.Draw.Gallery
import Visibility.Draw.Radiosity
import Visibility.Draw.Values
import Visibility.Scene
import Visibility.Scene.Raw hiding (Polyline)
import Visibility.Scene.Validate (validate)
import Visibility.Test.Generator

spec :: Spec
spec = do
  describe "every scene in scenes/" $
    withGallery $ \name scene ->
      for_ [minBound .. maxBound] $ \scaling ->
        legible (name <> ", " <> show scaling) $
          radiosityDrawing scene (directFigure scaling (take 2 (statedSides scene)) (directLight scene))
  describe "of any scene" $ do
    it "an element has a band on each uncovered piece of its side, and a covered one has none" $
      forAllFigures $ \scene figure ->
        sort (map markName (marksIn "bands" (radiosityDrawing scene figure)))
          === sort [sideName' side | side <- map litSide (radiosityElements figure), _ <- pieces scene side]
    it "a larger value is not darker" $
      forAllFigures $ \scene figure ->
        let byValue = map snd (sortOn (litValue . fst) (coloured scene figure))
         in counterexample (show byValue) (and (zipWith (<=) byValue (drop 1 byValue)))
    it "only what gives light on a linear scale is beyond it" $
      forAllFigures $ \scene figure ->
        let found = coloured scene figure
            (full, others) = partition (shines scene . litSide . fst) found
            brightest = maximum (0 : map (litValue . fst) others)
         in brightest > 0 && radiosityScaling figure == Linear ==>
              conjoin
                [ nub [shade | (e, shade) <- others, litValue e == brightest] === [shadeAt 1]
                , [shade | (e, shade) <- full, litValue e >= brightest, shade /= shadeAt 1] === []
                ]
    it "every polygon has one mark, every side that gives light has rays, no other has" $
      forAllFigures $ \scene figure ->
        let drawing = radiosityDrawing scene figure
         in conjoin
              [ map markName (marksIn "polygons" drawing)
                  === map (Text.pack . polygonText . polygonId) (scenePolygons scene)
              , nub (sort (map markName (marksIn "lights" drawing)))
                  === nub (sort [sideName' (sideName scene s) | s <- sides scene, emission (sideMaterial scene s) > 0])
              ]
    it "no label covers anything, and nothing leaves the canvas" $
      forAllFigures $ \scene figure ->
        isLegible (radiosityDrawing scene figure)
    it "a panel belongs to each chosen side, with an area for each of its elements" $
      forAllFigures $ \scene figure ->
        map markName (marksIn "areas" (radiosityDrawing scene figure))
          === [sideName' side | side <- radiosityProfiles figure, e <- radiosityElements figure, litSide e == side]
    it "shows the same at the same place wherever the file has it" $
      property $ \(AnyScene s) ->
        let lit scene = [element {litValue = 1} | element <- wholeSides scene]
            shapes scene =
              [ markShape mark
              | layer <- drawingLayers (radiosityDrawing scene (directFigure Linear [] (lit scene)))
              , layerName layer /= "legend"
              , mark <- layerMarks layer
              ]
         in fmap shapes (displaced (10 ^ (60 :: Int) + 1 / 7) (sampleRaw s)) === Right (shapes (sampleScene s))
  describe "sides divided in elements" $
    it "have bands side by side that make up those of whole sides" $
      for_ goldenScenes $ \(_, raw) ->
        withValid raw $ \scene -> case validate (divided 3 raw) of
          Left problems -> expectationFailure (show problems)
          Right finer -> do
            let bandsOf found = marksIn "bands" (radiosityDrawing scene (directFigure Linear [] found))
                (coarse, fine) = (bandsOf (directLight scene), bandsOf (map (undivided 3) (directLight finer)))
            length fine `shouldBe` 3 * length coarse
            -- But for what lies below the next.
            let areas found = Map.fromListWith (+) [(markName mark, areaOf (markShape mark)) | mark <- found]
                differences = Map.elems (Map.intersectionWith (-) (areas fine) (areas coarse))
            Map.keys (areas fine) `shouldBe` Map.keys (areas coarse)
            filter (\d -> d < -1e-6 || d > 2 * 0.3 * 8 + 1e-6) differences `shouldBe` []
  describe "golden drawings" $
    for_ goldenScenes $ \(name, raw) ->
      it name $ withValid raw $ \scene ->
        radiosityDrawing scene (directFigure Linear (take 1 (statedSides scene)) (directLight scene))
          `shouldBeListedIn` (name <> "-radiosity.txt")

-- | The elements that have bands, with the colours of these.
coloured :: Scene -> RadiosityFigure -> [(LitElement, Shade)]
coloured scene figure =
  [(e, shade) | e <- radiosityElements figure, Just shade <- [Map.lookup (sideName' (litSide e)) shadesOf]]
  where
    shadesOf =
      Map.fromList [(name, shade) | Mark name (Band shade) _ <- marksIn "bands" (radiosityDrawing scene figure)]

areaOf :: Shape -> Double
areaOf shape = case shape of
  Region places -> abs (sum [x * y' - x' * y | (Place x y, Place x' y') <- zip places (drop 1 places <> places)]) / 2
  _ -> 0

sideName' :: SideName -> Text.Text
sideName' = Text.pack . sideText

shines :: Scene -> SideName -> Bool
shines scene side = or [emission (sideMaterial scene s) > 0 | s <- pieces scene side]

pieces :: Scene -> SideName -> [SideId]
pieces scene = fromMaybe [] . piecesOf scene

-- | Figures of any values, on sides that are covered too.
forAllFigures :: Testable check => (Scene -> RadiosityFigure -> check) -> Property
forAllFigures check =
  property $ \(AnyScene s) ->
    let scene = sampleScene s
        elements' = wholeSides scene
     in forAll (vectorOf (length elements') (frequency [(1, pure 0), (5, (10 **) <$> choose (-4, 2))])) $ \values ->
          forAll (elements [minBound .. maxBound]) $ \scaling ->
            forAll (take 2 <$> sublistOf (statedSides scene)) $ \chosen ->
              check scene (directFigure scaling chosen (zipWith (\e v -> e {litValue = v}) elements' values))
