{-# LANGUAGE OverloadedStrings #-}

module Visibility.Draw.ViewSpec (spec) where

import Data.Foldable (for_)
import Data.List (sort)
import qualified Data.Text as Text
import Test.Hspec
import Test.QuickCheck hiding (sample)
import Visibility.Draw.Checks
import Visibility.Draw.Drawing hiding (Region)
import Visibility.Draw.Gallery
import Visibility.Draw.View
import Visibility.Exact.Point
import Visibility.Exact.Predicate (Direction (..))
import Visibility.Exact.RootSum (RootSum)
import Visibility.FormFactor
import Visibility.Scene
import Visibility.Sight
import Visibility.Sweep
import Visibility.Test.Generator

spec :: Spec
spec = do
  describe "every scene in scenes/" $
    withGallery $ \name scene ->
      for_ (zip [0 :: Int ..] (figures scene)) $ \(k, (kind, figure)) ->
        legible (name <> ", " <> kind <> " " <> show k) (viewDrawing scene figure)
  describe "of any scene" $ do
    it "no label covers anything, and nothing leaves the canvas" $
      forAllFigures $ \scene figure ->
        isLegible (viewDrawing scene figure)
    it "every polygon has one mark" $
      forAllFigures $ \scene figure ->
        map markName (marksIn "polygons" (viewDrawing scene figure))
          === map (Text.pack . polygonText . polygonId) (scenePolygons scene)
    it "marks every side that a side sees, and that side last" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
         in forAllBlind (elements (statedSides scene)) $ \side ->
              let factors = factorsFrom scene side
                  drawing = viewDrawing scene (SideFigure side factors)
                  marks style t = [(style, Text.pack (sideText t)) | _ <- concat (piecesOf scene t)]
               in [(markStyle mark, markName mark) | mark <- marksIn "seen" drawing]
                    === concatMap (marks SeenSide) (sort [t | (TheSide t, _) <- factors]) <> marks SeeingSide side
    it "shows a viewpoint beyond the scene" $
      property $ \(AnyScene s) (NonZero i) ->
        let scene = sampleScene s
            Point x y = case corners scene of
              c : _ -> cornerPoint scene c
              [] -> Point 0 0
            away = Point (x + 1000 * fromInteger i) (y - 7 / 3)
            drawing = viewDrawing scene (RegionFigure away [Sight (Direction 1 0) (Direction 1 0) Sky])
         in (length (marksIn "viewpoint" drawing), labelCollisions drawing, strayMarks drawing) === (1, [], [])
    it "shows the same at the same place wherever the file has it" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            figureOf moved = take 1 (map snd (figures moved))
            shapes moved =
              [ markShape mark
              | figure <- figureOf moved
              , layer <- drawingLayers (viewDrawing moved figure)
              , layerName layer /= "legend"
              , mark <- layerMarks layer
              ]
         in fmap shapes (displaced (10 ^ (60 :: Int) + 1 / 7) (sampleRaw s)) === Right (shapes scene)
  describe "golden drawings" $
    for_ goldenScenes $ \(name, raw) ->
      for_ [0, 1, 2] $ \k ->
        it (name <> " " <> show k) $
          withValid raw $ \scene ->
            for_ (take 1 (drop k (figures scene))) $ \(kind, figure) ->
              viewDrawing scene figure `shouldBeListedIn` (name <> "-view-" <> kind <> ".txt")

-- | A region, an element and a side of a scene; a second region.
figures :: Scene -> [(String, ViewFigure)]
figures scene =
  concat
    [ [ ("region", RegionFigure q sights)
      , ("element", ElementFigure q (Direction 1 (-2)) sights (elementFactors scene (Direction 1 (-2)) sights))
      , ("side", let side = sideName scene (sides scene !! (k `div` 2)) in SideFigure side (factorsFrom scene side))
      ]
    | (c, sights) <- take 1 (drop k found) <> take 1 found
    , let q = cornerPoint scene c
    ]
  where
    found = cornerSights scene
    k = length found `div` 2

-- | The three figures, of any viewpoint and side.
forAllFigures :: (Scene -> ViewFigure -> Property) -> Property
forAllFigures check =
  property $ \(AnyScene s) ->
    let scene = sampleScene s
     in forAllViewpoints scene $ \q sights ->
          forAllBlind (elements (statedSides scene)) $ \side ->
            forAll (arbitrary `suchThat` (/= (0, 0))) $ \(x, y) ->
              let normal = Direction x y
               in conjoin
                    [ check scene (RegionFigure q sights)
                    , check scene (ElementFigure q normal sights (elementFactors scene normal sights))
                    , counterexample (sideText side) $
                        check scene (SideFigure side (factorsFrom scene side))
                    ]

factorsFrom :: Scene -> SideName -> [(Seen, RootSum)]
factorsFrom scene side =
  [ (factorTo factor, factorValue factor)
  | factor <- formFactors scene (measures scene (vertices scene))
  , factorFrom factor == side
  ]
