-- | Figures.
module Command.Draw
  ( Figure
  , drawScene
  , drawDual
  , drawMatrix
  , drawView
  , drawMesh
  , drawLight
  , drawMoment
  , drawFrames
  ) where

import Command.Address (sideNamed)
import Command.Elements (divided, meshed, solved)
import Command.View (drawView)
import Control.Monad (unless, when)
import Data.ByteString.Builder (lazyByteString)
import Data.Foldable (for_)
import Options.Common
import Options.Mesh
import Options.Reader (Address)
import Run (measuring, orComplain, refuse, sweeping, withScene, written)
import System.Directory (createDirectoryIfMissing)
import System.FilePath ((</>))
import Visibility.Draw.Drawing (Drawing)
import Visibility.Draw.Dual (dualDrawing)
import Visibility.Draw.Matrix (elementMatrix, factorMatrix, matrixDrawing)
import Visibility.Draw.Mesh (CastingLines, meshDrawing)
import Visibility.Draw.Radiosity (lightFigure, radiosityDrawing)
import Visibility.Draw.Render (renderSvg)
import Visibility.Draw.Scene (sceneDrawing)
import Visibility.Draw.Sweep (Moment (..), moments, sweepDrawing)
import Visibility.Draw.Values (Scaling)
import Visibility.FormFactor (nearestFactors)
import Visibility.Mesh (refinedScene)
import Visibility.Radiosity (Closeness (..), Tolerance)
import Visibility.Scene (Scene)
import Visibility.Sweep (Vertex, vertices)
import Visibility.View (events)

-- | Draws a figure of a scene as SVG, into a file or to standard output.
type Figure = Common -> Maybe FilePath -> IO ()

drawScene, drawDual :: Figure
drawScene = drawSwept sceneDrawing
drawDual = drawSwept (\scene swept -> dualDrawing scene (events scene swept))

drawSwept :: (Scene -> [Vertex] -> Drawing) -> Figure
drawSwept drawing common file = withScene common $ \scene -> sweeping common scene (drawnTo file . drawing scene)

drawMatrix :: Elements -> Figure
drawMatrix elements common file = withScene common $ \scene -> divided common elements scene $ \cut -> do
  rows <- nearestFactors (refinedScene cut) <$> measuring common (refinedScene cut)
  drawnTo file . matrixDrawing $ case elements of
    WholeSides -> factorMatrix scene rows
    ElementsOf _ -> elementMatrix cut rows

drawMesh :: CastingLines -> MeshOptions -> Figure
drawMesh cast wanted common file = withScene common $ \scene ->
  meshed common wanted scene (\kept _ -> drawnTo file (meshDrawing cast kept))

-- | With a profile along some sides.
drawLight :: Elements -> Scaling -> Tolerance -> [Address] -> Figure
drawLight elements scaling close wanted common file = withScene common $ \scene -> do
  profiles <- either refuse pure (mapM (sideNamed scene "--profile") wanted)
  divided common elements scene $ \cut ->
    solved common [] (WithinTolerance close) cut $ \found ->
      drawnTo file (radiosityDrawing scene (lightFigure scaling profiles cut found))

-- | The state of the sweep after so many vertices.
drawMoment :: Integer -> Figure
drawMoment k common file = withScene common $ \scene -> do
  let total = length (vertices scene)
  unless (k <= toInteger total) . refuse $
    "--at " <> show k <> ": this sweep has " <> show total <> " vertices; give 0 to that"
  mapM_ (drawnTo file . sweepDrawing scene total) (take 1 (drop (fromInteger k) (moments scene)))

-- | So many states of the sweep from the first to the last, a file each in a folder, named by the number of vertices
-- before it.
drawFrames :: Integer -> Figure
drawFrames n common file = withScene common $ \scene -> do
  let total = length (vertices scene)
      chosen = among [k * total `div` (fromInteger n - 1) | k <- [0 .. fromInteger n - 1]] (moments scene)
      name k = replicate (length (show total) - length (show k)) '0' <> show k <> ".svg"
  folder <- maybe (refuse noFolder) pure file
  unless (n <= toInteger total + 1) . refuse $
    "--frames " <> show n <> ": this sweep has " <> show (total + 1) <> " states; give 2 to that"
  when (folder == "-") $ refuse noFolder
  orComplain folder (createDirectoryIfMissing True folder)
  for_ chosen $ \m -> drawnTo (Just (folder </> name (momentCount m))) (sweepDrawing scene total m)
  where
    noFolder = "--frames needs a folder: --output FOLDER"
    among (k : ks) (m : ms) = if momentCount m == k then m : among ks ms else among (k : ks) ms
    among _ _ = []

drawnTo :: Maybe FilePath -> Drawing -> IO ()
drawnTo file = written file . lazyByteString . renderSvg
