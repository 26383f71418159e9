{-# LANGUAGE OverloadedStrings #-}

module Visibility.Draw.SceneSpec (spec) where

import Data.Foldable (for_)
import Data.List (nub, sort)
import qualified Data.Text as Text
import Test.Hspec
import Test.QuickCheck hiding (sample)
import Visibility.Draw.Checks
import Visibility.Draw.Drawing
import Visibility.Draw.Gallery
import Visibility.Draw.Scene
import Visibility.Scene
import Visibility.Scene.Raw (Material (..))
import Visibility.Sweep
import Visibility.Test.BruteForce (bruteForce)
import Visibility.Test.Generator
import Visibility.View

spec :: Spec
spec = do
  describe "every scene in scenes/" $
    withGallery $ \name scene -> do
      let drawing = sceneDrawing scene (vertices scene)
      legible name drawing
      it (name <> ": all corners are labelled if there are up to 40") $
        sort [markName mark | mark <- marksIn "labels" drawing, markStyle mark == CornerLabel]
          `shouldBe` sort [Text.pack (cornerText (cornerName scene c)) | cornerCount scene <= 40, c <- corners scene]
  describe "of any scene" $ do
    it "every polygon has one mark" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
         in map markName (marksIn "polygons" (drawn scene))
              === map (Text.pack . polygonText . polygonId) (scenePolygons scene)
    it "every free bitangent has one mark, from corner to corner" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            names (p, q) = Text.pack (cornerText (cornerName scene p) <> " " <> cornerText (cornerName scene q))
         in map markName (marksIn "bitangents" (drawn scene))
              === map names (sort (concatMap (freeBitangents scene) (vertices scene)))
    it "every side that gives light has one band, no other has" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            bands = [markName mark | mark <- marksIn "lights" (drawn scene), markStyle mark == LightSource]
            shines side = emission (sideMaterial scene side) > 0
         in bands === [Text.pack (sideText (sideName scene side)) | side <- sides scene, shines side]
    it "no label covers anything, and nothing leaves the canvas" $
      property $ \(AnyScene s) ->
        isLegible (drawn (sampleScene s))
    it "a place of corners that finds no room for its label is counted in the caption" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            drawing = drawn scene
            written = length [() | Mark _ CornerLabel _ <- marksIn "labels" drawing]
            missing = length (nub (map snd (statedCorners scene))) - written
            stated
              | missing == 0 = Text.empty
              | otherwise = Text.pack (show missing <> if missing == 1 then " corner without" else " corners without")
         in cornerCount scene <= 40 ==> stated `Text.isInfixOf` drawingDescription drawing
    it "is the same whatever the order of the vertices" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
         in sceneDrawing scene (bruteForce scene) === drawn scene
    it "shows the same scene at the same place wherever the file has it" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            moved = displaced (10 ^ (60 :: Int) + 1 / 7) (sampleRaw s)
         in fmap (shapes . drawn) moved === Right (shapes (drawn scene))
  describe "golden drawings" $
    for_ goldenScenes $ \(name, raw) ->
      it name $ withValid raw $ \scene -> sceneDrawing scene (vertices scene) `shouldBeListedIn` (name <> "-scene.txt")
  where
    drawn scene = sceneDrawing scene (vertices scene)
    shapes drawing = [markShape mark | mark <- drawingMarks drawing]
