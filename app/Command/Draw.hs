-- | Figures.
module Command.Draw
  ( runDraw
  ) where

import Command.View (runDrawView)
import Data.ByteString.Builder (lazyByteString)
import Options
import Run (sweeping, withScene, written)
import Visibility.Draw.Dual (dualDrawing)
import Visibility.Draw.Render (renderSvg)
import Visibility.Draw.Scene (sceneDrawing)
import Visibility.View (events)

-- | Draws a figure as SVG.
runDraw :: Common -> DrawOptions -> IO ()
runDraw common options = case figure options of
  SceneFigure -> drawn sceneDrawing
  DualFigure -> drawn (\scene swept -> dualDrawing scene (events scene swept))
  ViewFigure from -> runDrawView common from (figureFile options)
  where
    drawn drawing = withScene common $ \scene ->
      sweeping common scene (written (figureFile options) . lazyByteString . renderSvg . drawing scene)
