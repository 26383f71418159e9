-- | Figures.
module Command.Draw
  ( runDraw
  ) where

import Data.ByteString.Builder (lazyByteString)
import Options
import Run (sweeping, withScene, written)
import Visibility.Draw.Dual (dualDrawing)
import Visibility.Draw.Render (renderSvg)
import Visibility.Draw.Scene (sceneDrawing)
import Visibility.View (events)

-- | Draws a figure as SVG.
runDraw :: Common -> DrawOptions -> IO ()
runDraw common options = withScene common $ \scene ->
  sweeping common scene $ \swept -> do
    let drawing = case figure options of
          SceneFigure -> sceneDrawing scene swept
          DualFigure -> dualDrawing scene (events scene swept)
    written (figureFile options) (lazyByteString (renderSvg drawing))
