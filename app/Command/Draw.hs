-- | Figures.
module Command.Draw
  ( runDraw
  ) where

import Command.Elements (divided, meshed, solved)
import Command.View (runDrawView)
import Data.ByteString.Builder (lazyByteString)
import Options
import Run (complain, ends, measuring, orComplain, sweeping, withScene, written)
import System.Directory (createDirectoryIfMissing)
import System.FilePath ((</>))
import Visibility.Draw.Drawing (Drawing)
import Visibility.Draw.Dual (dualDrawing)
import Visibility.Draw.Matrix (elementMatrix, factorMatrix, matrixDrawing)
import Visibility.Draw.Mesh (meshDrawing)
import Visibility.Draw.Radiosity (lightFigure, radiosityDrawing)
import Visibility.Draw.Render (renderSvg)
import Visibility.Draw.Scene (sceneDrawing)
import Visibility.Draw.Sweep (Moment (..), moments, sweepDrawing)
import Visibility.Error (Outcome (..))
import Visibility.FormFactor (nearestFactors)
import Visibility.Mesh (refinedScene)
import Visibility.Radiosity (Closeness (..), defaultTolerance)
import Visibility.Scene (Scene)
import Visibility.Sweep (vertices)
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
  SweepFigure frames -> withScene common (runSweep (figureFile options) frames)
  where
    drawn drawing = withScene common $ \scene -> sweeping common scene (figured . drawing scene)
    figured :: Drawing -> IO ()
    figured = written (figureFile options) . lazyByteString . renderSvg

-- | One state of the sweep, or several into a folder, each named by the number of vertices before it.
runSweep :: Maybe FilePath -> Frames -> Scene -> IO ()
runSweep file frames scene = case (frames, file) of
  (After k, _)
    | k <= total -> mapM_ (written file . document) (take 1 (drop k (moments scene)))
    | otherwise -> refuse ("this sweep has " <> show total <> " vertices: --at goes from 0 to " <> show total)
  (Spread n, Just folder) | folder /= "-" -> do
    orComplain folder (createDirectoryIfMissing True folder)
    mapM_ (into folder) (chosen n)
  (Spread _, _) -> refuse "--frames needs a folder: --output FOLDER"
  where
    total = length (vertices scene)
    chosen n = filter ((`elem` [k * total `div` (n - 1) | k <- [0 .. n - 1]]) . momentCount) (moments scene)
    into folder moment = written (Just (folder </> name (momentCount moment))) (document moment)
    name k = replicate (length (show total) - length (show k)) '0' <> show k <> ".svg"
    document = lazyByteString . renderSvg . sweepDrawing scene total
    refuse problem = complain [problem] >> ends WrongUsage
