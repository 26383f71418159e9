{-# LANGUAGE OverloadedStrings #-}

-- | Every kind of figure, of scenes whose parts differ by more than Doubles hold.
module Visibility.Draw.ExtremeSpec (spec) where

import Data.Foldable (for_)
import qualified Data.Text as Text
import Test.Hspec
import Visibility.Draw.Checks
import Visibility.Draw.DirectLight
import Visibility.Draw.Drawing
import Visibility.Draw.Dual
import Visibility.Draw.Gallery
import Visibility.Draw.Matrix
import Visibility.Draw.Mesh
import Visibility.Draw.Radiosity
import Visibility.Draw.Scene
import Visibility.Draw.Values (Scaling (..))
import Visibility.Draw.View
import Visibility.Exact.Predicate (Direction (..))
import Visibility.FormFactor
import Visibility.Mesh
import Visibility.Scene
import Visibility.Sight
import Visibility.Sweep
import Visibility.View

spec :: Spec
spec = for_ extremeScenes $ \(name, long, raw) -> describe name $ do
  it "nothing leaves the canvas, is no number, or covers another thing, in any figure" $
    withValid raw $ \scene ->
      for_ (figures scene) $ \(kind, drawing) ->
        (kind, strayMarks drawing, labelCollisions drawing) `shouldBe` (kind, [], [])
  it "all figures but the matrix say what cannot be told apart" $
    withValid raw $ \scene ->
      for_ [(kind, drawing) | (kind, drawing) <- figures scene, kind /= "matrix"] $ \(kind, drawing) ->
        (kind, Text.isInfixOf " drawn in the place" (drawingDescription drawing)) `shouldBe` (kind, True)
  it "what is smaller than can be seen is a dot" $
    withValid raw $ \scene -> do
      let drawing = sceneDrawing scene (vertices scene)
      length [() | Mark _ _ (Dot _) <- marksIn "polygons" drawing] `shouldBe` 1
  it "axes of length have at least two numbers, which differ" $
    withValid raw $ \scene ->
      for_ [drawing | ("radiosity", drawing) <- figures scene] $ \drawing -> do
        let texts = [text | Mark _ TickLabel (Label MiddleAnchor _ text) <- marksIn "ticks" drawing]
        length texts `shouldSatisfy` (>= 2)
        texts `shouldSatisfy` \found -> and (zipWith (/=) found (drop 1 found))
        texts `shouldSatisfy` all ((<= 8) . Text.length)
        drop (length texts - 1) texts `shouldBe` [Text.pack long]

-- | One of each kind, those of a view from the first corner and side.
figures :: Scene -> [(String, Drawing)]
figures scene =
  [ ("scene", sceneDrawing scene swept)
  , ("dual", dualDrawing scene (events scene swept))
  , ("mesh", meshDrawing WithLines (discontinuityMesh scene swept))
  , ("matrix", matrixDrawing (factorMatrix scene (nearestFactors scene measured)))
  , ("radiosity", radiosityDrawing scene (directFigure Linear (take 1 (statedSides scene)) (directLight scene)))
  , ("side", viewDrawing scene (SideFigure side [(factorTo f, factorValue f) | f <- factors, factorFrom f == side]))
  ]
    <> concat
      [ [ ("region", viewDrawing scene (RegionFigure q sights))
        , ("element", viewDrawing scene (ElementFigure q normal sights (elementFactors scene normal sights)))
        ]
      | (c, sights) <- take 1 (cornerSights scene)
      , let q = cornerPoint scene c
      , let normal = Direction 1 (-2)
      ]
  where
    swept = vertices scene
    measured = measures scene swept
    factors = formFactors scene measured
    side = sideName scene (minimum (sides scene))
