-- | All figures, as others see them: the package shows this module as @Visibility.Draw@.
module Visibility.Surface.Draw
  ( -- * Figures
    Drawing
  , sceneDrawing
  , dualDrawing
  , viewDrawing
  , ViewFigure (..)
  , meshDrawing
  , CastingLines (..)
  , radiosityDrawing
  , RadiosityFigure (..)
  , LitElement (..)
  , Scaling (..)
  , matrixDrawing
  , Matrix (..)
  , Group (..)
  , factorMatrix
  , withSky
    -- * As files
  , renderSvg
  ) where

import Visibility.Draw.Drawing (Drawing)
import Visibility.Draw.Dual (dualDrawing)
import Visibility.Draw.Matrix (Group (..), Matrix (..), factorMatrix, matrixDrawing, withSky)
import Visibility.Draw.Mesh (CastingLines (..), meshDrawing)
import Visibility.Draw.Radiosity (LitElement (..), RadiosityFigure (..), radiosityDrawing)
import Visibility.Draw.Render (renderSvg)
import Visibility.Draw.Scene (sceneDrawing)
import Visibility.Draw.Values (Scaling (..))
import Visibility.Draw.View (ViewFigure (..), viewDrawing)
