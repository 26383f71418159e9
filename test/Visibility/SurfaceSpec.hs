{-# LANGUAGE OverloadedStrings #-}

-- | What others see of the values they hold.
module Visibility.SurfaceSpec (spec) where

import Test.Hspec
import Visibility
import qualified Visibility.Mesh as Mesh
import qualified Visibility.Surface.Scene as Surface

spec :: Spec
spec =
  describe "values are shown in a few words" $ do
    read' <- runIO (readSceneFile "scenes/two-squares.json")
    case read' of
      Left problems -> it "reads the scene" $ foldMap errorText problems `shouldBe` ""
      Right scene -> do
        let swept = vertices scene
            sums = measures scene swept
            mesh = discontinuityMesh scene swept
        it "scenes" $ show scene `shouldBe` "<scene: 2 polygons, 8 corners>"
        it "complexes" $ show (complexOf scene) `shouldBe` "<complex: 8 vertices, 20 edges, 13 faces>"
        it "measures" $ show sums `shouldBe` "<measures: 12 distances>"
        it "form factors" $
          map show (take 1 (formFactors scene sums)) `shouldBe` ["<0.0 to sky: 1.0000000000000000>"]
        it "meshes" $ show mesh `shouldBe` "<mesh: 0 break points>"
        it "scenes of elements" $ show (Mesh.refined mesh) `shouldBe` "<refined: 8 elements>"
        it "radiosities" $
          either show show (radiosity (WithinTolerance defaultTolerance) scene sums)
            `shouldBe` "<radiosity: 8 elements, 2 passes>"
        it "and a scene is as it was inside" $
          (Surface.sceneTitle scene, map Surface.polygonId (Surface.scenePolygons scene))
            `shouldBe` (Just "two unit squares, a unit apart", [Obstacle 0, Obstacle 1])
