{-# LANGUAGE OverloadedStrings #-}

module Visibility.Draw.LightSpec (spec) where

import Data.List (nub, sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust)
import qualified Data.Text as Text
import Test.Hspec
import Test.QuickCheck
import Visibility.Draw.Checks
import Visibility.Draw.Drawing
import Visibility.Draw.Gallery
import Visibility.Draw.Matrix
import Visibility.Draw.Radiosity
import Visibility.Draw.Values (Scaling (..))
import Visibility.Exact.RootSum (rational)
import Visibility.Exact.Rounding (nearestDouble)
import Visibility.FormFactor
import Visibility.Mesh
import Visibility.Radiosity
import Visibility.Scene
import Visibility.Sweep
import Visibility.Test.Generator
import Visibility.Test.Light

spec :: Spec
spec = do
  describe "the matrix of elements" $ do
    it "has a group for each side that has elements, and a row for each element, in the order of the file" $
      forAllCuts $ \_ cut ->
        let matrix = matrixOf cut
            groups = [(groupLabel g, map (matrixName matrix) (groupMembers g)) | g <- matrixRows matrix]
         in conjoin
              [ concatMap snd groups === map (Text.pack . elementText) (refinedElements cut)
              , map fst groups === nub (map (Text.pack . sideText . elementSide) (refinedElements cut))
              , conjoin [Text.takeWhile (/= '.') (groupLabel g) === groupWhole g | g <- matrixRows matrix]
              , conjoin [Text.takeWhile (/= '#') name === side | (side, names) <- groups, name <- names]
              ]
    it "has a column for each row, and one for the sky where there is one" $
      forAllCuts $ \_ cut ->
        let matrix = matrixOf cut
         in matrixColumns matrix
              === matrixRows matrix <> [Group "sky" "sky" [TheSky] | surroundings (refinedScene cut) == OpenSky]
    it "has one cell for every form factor that is not exactly zero, all else is blank" $
      forAllCuts $ \_ cut ->
        sort (map markName (marksIn "cells" (matrixDrawing (matrixOf cut))))
          === sort
            [ Text.pack (elementNames cut (factorFrom f) <> " " <> reached (elementNames cut) (factorTo f))
            | f <- formFactors (refinedScene cut) (measured cut)
            ]
    it "has no label that covers anything, and nothing leaves the canvas" $
      forAllCuts $ \_ cut ->
        isLegible (matrixDrawing (matrixOf cut))
  describe "the figure of light" $ do
    it "shows every element where it is, with the Double next to the middle of its bounds" $
      forAllLit $ \scene cut found ->
        let figure = lightFigure Linear (take 1 (statedSides scene)) cut found
            shown e = (litSide e, litFrom e, litTo e, litEnds e)
         in conjoin
              [ map shown (radiosityElements figure)
                  === [(elementSide e, elementFrom e, elementTo e, elementEnds cut e) | e <- refinedElements cut]
              , map litValue (radiosityElements figure)
                  === [ nearestDouble (rational ((low + high) / 2))
                      | l <- litElements found
                      , let (low, high) = litRadiosity l
                      ]
              , (radiosityScaling figure, radiosityProfiles figure) === (Linear, take 1 (statedSides scene))
              ]
    it "has a band for each element in the scene of the file, and nothing covers anything" $
      forAllLit $ \scene cut found ->
        let drawing = radiosityDrawing scene (lightFigure Logarithmic (take 2 (statedSides scene)) cut found)
            count side = (side, 1 :: Int)
         in conjoin
              [ Map.fromListWith (+) (map (count . markName) (marksIn "bands" drawing))
                  === Map.fromListWith (+) (map (count . Text.pack . sideText . elementSide) (refinedElements cut))
              , isLegible drawing
              ]
  where
    reached names seen = case seen of
      TheSide name -> names name
      TheSky -> "sky"

matrixOf :: Refined -> Matrix Seen
matrixOf cut = elementMatrix cut (nearestFactors (refinedScene cut) (measured cut))

measured :: Refined -> Measures
measured cut = measures (refinedScene cut) (vertices (refinedScene cut))

-- | Scenes with light in them, with the elements of a mesh.
forAllCuts :: Testable check => (Scene -> Refined -> check) -> Property
forAllCuts check =
  forAll (resize 15 kinds >>= furnished) $ \s ->
    forAllBlind (choose (1, 4) `suchThatMap` elementCount) $ \parts ->
      let scene = sampleScene s
          full = discontinuityMesh scene (vertices scene)
       in forAllBlind (elements [fst (bounded parts full), uniformMesh parts scene]) (check scene . refined)
  where
    kinds = oneof [(\(AnyScene s) -> s) <$> arbitrary, (\(TouchingScene s) -> s) <$> arbitrary]

forAllLit :: Testable check => (Scene -> Refined -> Radiosity -> check) -> Property
forAllLit check =
  forAllCuts $ \scene cut ->
    let found = either (const Nothing) Just (radiosityOfElements (WithinTolerance defaultTolerance) cut (measured cut))
     in counterexample "no radiosities" (isJust found) .&&. maybe (property False) (property . check scene cut) found
