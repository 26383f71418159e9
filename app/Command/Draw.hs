-- | Figures.
module Command.Draw
  ( runDraw
  ) where

import Command.Address (sideNamed)
import Command.Elements (divided, meshed, solved)
import Command.View (runDrawView)
import Data.ByteString.Builder (lazyByteString)
import Options hiding (lightFigure)
import Run (measuring, orComplain, refuse, sweeping, withScene, written)
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
import Visibility.FormFactor (nearestFactors)
import Visibility.Mesh (refinedScene)
import Visibility.Radiosity (Closeness (..))
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
  LightFigure light -> withScene common $ \scene -> do
    profiles <- either refuse pure (mapM (sideNamed scene "--profile") (lightProfiles light))
    divided common (lightElements light) scene $ \cut ->
      solved common [] (WithinTolerance (lightTolerance light)) cut $ \found ->
        figured (radiosityDrawing scene (lightFigure (lightScaling light) profiles cut found))
  SweepFigure frames -> withScene common (runSweep (figureFile options) frames)
  where
    drawn drawing = withScene common $ \scene -> sweeping common scene (figured . drawing scene)
    figured :: Drawing -> IO ()
    figured = written (figureFile options) . lazyByteString . renderSvg

-- | One state of the sweep, or several into a folder, each named by the number of vertices before it.
runSweep :: Maybe FilePath -> Frames -> Scene -> IO ()
runSweep file frames scene = case (frames, file) of
  (After k, _)
    | k <= toInteger total -> mapM_ (written file . document) (take 1 (drop (fromInteger k) (moments scene)))
    | otherwise -> refuse ("--at " <> show k <> ": this sweep has " <> show total <> " vertices; give 0 to that")
  (Spread n, Just folder)
    | n > toInteger total + 1 ->
        refuse ("--frames " <> show n <> ": this sweep has " <> show (total + 1) <> " states; give 2 to that")
    | folder /= "-" -> do
        orComplain folder (createDirectoryIfMissing True folder)
        mapM_ (into folder) (chosen (fromInteger n))
  (Spread _, _) -> refuse "--frames needs a folder: --output FOLDER"
  where
    total = length (vertices scene)
    chosen n = among [k * total `div` (n - 1) | k <- [0 .. n - 1]] (moments scene)
    among (k : ks) (m : ms) = if momentCount m == k then m : among ks ms else among (k : ks) ms
    among _ _ = []
    into folder moment = written (Just (folder </> name (momentCount moment))) (document moment)
    name k = replicate (length (show total) - length (show k)) '0' <> show k <> ".svg"
    document = lazyByteString . renderSvg . sweepDrawing scene total
