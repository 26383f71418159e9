module Visibility.Draw.MeshSpec (spec) where

import Data.Foldable (for_)
import Data.List (sort)
import qualified Data.Text as Text
import Test.Hspec
import Test.QuickCheck hiding (sample)
import Visibility.Draw.Checks
import Visibility.Draw.Drawing
import Visibility.Draw.Gallery
import Visibility.Draw.Mesh
import Visibility.Exact.Rounding (rationalText)
import Visibility.Mesh
import Visibility.Scene
import Visibility.Sweep
import Visibility.Test.Generator

spec :: Spec
spec = do
  describe "every scene in scenes/" $
    withGallery $ \name scene ->
      for_ [WithoutLines, WithLines] $ \wanted ->
        legible (name <> ", " <> show wanted) (meshDrawing wanted (meshOf scene))
  describe "of any scene" $ do
    it "no label covers anything, and nothing leaves the canvas" $
      onMeshes $ \wanted mesh ->
        isLegible (meshDrawing wanted mesh)
    it "every polygon has one mark" $
      onMeshes $ \wanted mesh ->
        map markName (marksIn (Text.pack "polygons") (meshDrawing wanted mesh))
          === map (Text.pack . polygonText . polygonId) (scenePolygons (meshScene mesh))
    it "every break point has one mark, as its kind has it" $
      onMeshes $ \wanted mesh ->
        sort [(Text.unpack name, style) | Mark name style _ <- marksIn (Text.pack "breaks") (meshDrawing wanted mesh)]
          === sort
            [ (sideText side <> " " <> rationalText (breakParameter point), style)
            | (side, points) <- meshSides mesh
            , point <- points
            , let style = maybe EqualPartsTick (pick ShadowLimitTick KinkTick) (breakKind point)
            ]
    it "every caster has one line if lines are wanted, else none" $
      onMeshes $ \wanted mesh ->
        sort [(Text.unpack name, style) | Mark name style _ <- marksIn (Text.pack "lines") (meshDrawing wanted mesh)]
          === sort
            [ (cornerText p <> " " <> cornerText q, pick ShadowLine KinkLine (casterKind caster))
            | wanted == WithLines
            , (_, points) <- meshSides mesh
            , caster <- concatMap breakCasters points
            , let (p, q) = casterNames (meshScene mesh) caster
            ]
  describe "golden drawings" $
    for_ goldenScenes $ \(name, raw) ->
      it name $
        withValid raw $ \scene ->
          meshDrawing WithLines (meshOf scene) `shouldBeListedIn` (name <> "-mesh.txt")
  where
    pick limit kink kind = case kind of
      ShadowLimit -> limit
      Kink -> kink

meshOf :: Scene -> Mesh
meshOf scene = discontinuityMesh scene (vertices scene)

-- | With lines and without, discontinuity meshes and uniform ones.
onMeshes :: (CastingLines -> Mesh -> Property) -> Property
onMeshes check =
  property $ \(AnyScene s) ->
    forAll (elements [minBound .. maxBound]) $ \wanted ->
      forAllBlind (elements [meshOf (sampleScene s), uniform (sampleScene s)]) (check wanted)
  where
    uniform scene = maybe (emptyMesh scene) (`uniformMesh` scene) (elementCount 5)
