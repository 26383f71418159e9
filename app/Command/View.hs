-- | What is seen from a point, a corner or a side.
module Command.View
  ( runView
  , runDrawView
  ) where

import Data.ByteString.Builder (Builder, lazyByteString)
import Options
import Run (complain, ends, printed, sweeping, withScene, written)
import Visibility.Complex (build)
import Visibility.Complex.Walk
import Visibility.Complex.Walk.Side
import Visibility.Draw.Render (renderSvg)
import Visibility.Draw.View (ViewFigure (..), viewDrawing)
import Visibility.Error (Outcome (..))
import Visibility.Exact.Predicate (Direction)
import Visibility.Format.View (elementDocument, regionDocument, sideDocument)
import Visibility.FormFactor (FormFactor (..))
import Visibility.Scene
import Visibility.Sight
import Visibility.Sweep (Vertex)

-- | As JSON.
runView :: Common -> ViewOptions -> IO ()
runView common options = seeing common (viewFrom options) printed document
  where
    document scene seen = case seen of
      SeenRegion viewpoint sights -> regionDocument viewpoint (region scene (viewpointAt viewpoint) sights)
      SeenByElement viewpoint normal sights ->
        elementDocument (viewDetail options) (viewDigits options) viewpoint normal (elementFactors scene normal sights)
      SeenBySide side factors -> sideDocument (viewDetail options) (viewDigits options) side factors

-- | As a figure.
runDrawView :: Common -> From -> Maybe FilePath -> IO ()
runDrawView common from file = seeing common from (written file) document
  where
    document scene seen = lazyByteString (renderSvg (viewDrawing scene (figureOf scene seen)))
    figureOf scene seen = case seen of
      SeenRegion viewpoint sights -> RegionFigure (viewpointAt viewpoint) sights
      SeenByElement viewpoint normal sights ->
        ElementFigure (viewpointAt viewpoint) normal sights (elementFactors scene normal sights)
      SeenBySide side factors -> SideFigure side [(factorTo f, factorValue f) | f <- factors]

-- | What there was to see.
data Sighting
  = SeenRegion !Viewpoint ![Sight]
  | SeenByElement !Viewpoint !Direction ![Sight]
  | SeenBySide !SideName ![FormFactor]

-- | Looks from somewhere in a scene and tells it. A place that is not in the scene, or in the solid, is wrong usage.
seeing :: Common -> From -> (Builder -> IO ()) -> (Scene -> Sighting -> Builder) -> IO ()
seeing common from write document = withScene common $ \scene ->
  either refuse (\look -> sweeping common scene (either refuse (write . document scene) . look)) (looking scene from)
  where
    refuse problem = complain [problem] >> ends WrongUsage

-- | What is seen from somewhere, once the scene is swept.
looking :: Scene -> From -> Either String ([Vertex] -> Either String Sighting)
looking scene from = case from of
  FromPoint point normal -> Right (around (AtPoint point) normal)
  FromCorner name normal ->
    maybe (missing "corner" (cornerText name)) (Right . (`around` normal) . AtCorner name) (statedPoint scene name)
  FromSide name -> maybe (missing "side" (sideText name)) (const (Right (along name))) (piecesOf scene name)
  where
    missing what name =
      Left ("--" <> what <> " " <> name <> ": the scene has no such " <> what <> "; give one such as " <> anyName)
    anyName = concatMap (cornerText . fst) (take 1 (statedCorners scene))
    along side swept = Right (SeenBySide side (concat (sees (build scene swept) side)))
    around viewpoint normal swept = case lookAround (build scene swept) viewpoint of
      Left solid -> Left (inSolid solid)
      Right look -> Right (maybe (SeenRegion viewpoint) (SeenByElement viewpoint) normal (lookSights look))
    inSolid Enclosure = "--from: the point lies outside the enclosure; give one inside it"
    inSolid polygon =
      "--from: the point lies inside polygon " <> polygonText polygon <> "; give one in free space or on a boundary"
