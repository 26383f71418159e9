-- | Figures.
module Command.Draw
  ( runDraw
  ) where

import Command.Mesh (divided, meshed)
import Command.Radiosity (solved)
import Command.View (runDrawView)
import Data.ByteString.Builder (lazyByteString)
import Options
import Run (measuring, sweeping, withScene, written)
import Visibility.Draw.Drawing (Drawing)
import Visibility.Draw.Dual (dualDrawing)
import Visibility.Draw.Light (elementMatrix, lightFigure)
import Visibility.Draw.Matrix (factorMatrix, matrixDrawing)
import Visibility.Draw.Mesh (meshDrawing)
import Visibility.Draw.Radiosity (radiosityDrawing)
import Visibility.Draw.Render (renderSvg)
import Visibility.Draw.Scene (sceneDrawing)
import Visibility.FormFactor (nearestFactors)
import Visibility.Mesh (Refined (..))
import Visibility.Radiosity (Closeness (..), defaultTolerance)
import Visibility.View (events)

-- | Draws a figure as SVG.
runDraw :: Common -> DrawOptions -> IO ()
runDraw common options = case figure options of
  SceneFigure -> drawn sceneDrawing
  DualFigure -> drawn (\scene swept -> dualDrawing scene (events scene swept))
  MatrixFigure elements -> withScene common $ \scene -> divided common elements scene $ \cut -> do
    rows <- nearestFactors (refinedScene cut) <$> measuring common (refinedScene cut)
    case elements of
      WholeSides -> figured (matrixDrawing (factorMatrix scene rows))
      ElementsOf _ -> figured (matrixDrawing (elementMatrix cut rows))
  ViewFigure from -> runDrawView common from (figureFile options)
  MeshFigure cast wanted -> withScene common $ \scene ->
    meshed common wanted scene (\kept _ -> figured (meshDrawing cast kept))
  LightFigure light -> withScene common $ \scene -> divided common (lightElements light) scene $ \cut ->
    solved common (WithinTolerance defaultTolerance) cut $ \found ->
      figured (radiosityDrawing scene (lightFigure (lightScaling light) (lightProfiles light) cut found))
  where
    drawn drawing = withScene common $ \scene -> sweeping common scene (figured . drawing scene)
    figured :: Drawing -> IO ()
    figured = written (figureFile options) . lazyByteString . renderSvg
