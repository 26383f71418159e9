-- | Figures.
module Command.Draw
  ( runDraw
  ) where

import Command.Mesh (meshed)
import Command.View (runDrawView)
import Data.ByteString.Builder (lazyByteString)
import Options
import Run (sweeping, sweepingPieces, withScene, written)
import Visibility.Draw.Drawing (Drawing)
import Visibility.Draw.Dual (dualDrawing)
import Visibility.Draw.Matrix (factorMatrix, matrixDrawing)
import Visibility.Draw.Mesh (meshDrawing)
import Visibility.Draw.Render (renderSvg)
import Visibility.Draw.Scene (sceneDrawing)
import Visibility.FormFactor (measuresInPieces, nearestFactors)
import Visibility.View (events)

-- | Draws a figure as SVG.
runDraw :: Common -> DrawOptions -> IO ()
runDraw common options = case figure options of
  SceneFigure -> drawn sceneDrawing
  DualFigure -> drawn (\scene swept -> dualDrawing scene (events scene swept))
  MatrixFigure -> withScene common $ \scene ->
    sweepingPieces common OneProcessor scene id $ \swept ->
      figured (matrixDrawing (factorMatrix scene (nearestFactors scene (measuresInPieces scene swept))))
  ViewFigure from -> runDrawView common from (figureFile options)
  MeshFigure wanted -> withScene common $ \scene ->
    meshed common (figureMesh wanted) scene (\kept _ -> figured (meshDrawing (castingLines wanted) kept))
  where
    drawn drawing = withScene common $ \scene -> sweeping common scene (figured . drawing scene)
    figured :: Drawing -> IO ()
    figured = written (figureFile options) . lazyByteString . renderSvg
