-- | What is seen from a point, a corner or a side.
module Command.View
  ( From (..)
  , runView
  , drawView
  ) where

import Command.Address (cornerNamed, sideNamed)
import Data.ByteString.Builder (Builder, lazyByteString)
import Data.List (intercalate)
import Options.Common
import Options.Reader (Address)
import Run (printed, refuse, sweeping, withScene, written)
import Visibility.Complex (build)
import Visibility.Complex.Locate (boundariesAt)
import Visibility.Complex.Walk
import Visibility.Complex.Walk.Side
import Visibility.Draw.Render (renderSvg)
import Visibility.Draw.View (ViewFigure (..), viewDrawing)
import Visibility.Exact.Point (Point)
import Visibility.Exact.Predicate (Direction)
import Visibility.Exact.Rounding (Digits)
import Visibility.Format.Factors (Detail)
import Visibility.Format.View (elementDocument, regionDocument, sideDocument)
import Visibility.FormFactor (FormFactor (..))
import Visibility.Scene
import Visibility.Sight
import Visibility.Sweep (Vertex)

-- | Whose view is asked for.
data From
  = -- | A point, with the normal of an element there.
    FromPoint !Point !(Maybe Direction)
  | FromCorner !Address !(Maybe Direction)
  | FromSide !Address

-- | As JSON.
runView :: Common -> From -> Digits -> Detail -> IO ()
runView common from wanted detail = seeing common from printed document
  where
    document scene seen = case seen of
      SeenRegion viewpoint sights -> regionDocument viewpoint (region scene (viewpointAt viewpoint) sights)
      SeenByElement viewpoint normal sights ->
        elementDocument detail wanted viewpoint normal (elementFactors scene normal sights)
      SeenBySide side factors -> sideDocument detail wanted side factors

-- | As a figure.
drawView :: From -> Common -> Maybe FilePath -> IO ()
drawView from common file = seeing common from (written file) document
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

-- | What is seen from somewhere, once the scene is swept.
looking :: Scene -> From -> Either String ([Vertex] -> Either String Sighting)
looking scene from = case from of
  FromPoint point normal -> Right (around (AtPoint point) normal)
  FromCorner named normal -> (`around` normal) . uncurry AtCorner <$> cornerNamed scene "--corner" named
  FromSide named -> along <$> sideNamed scene "--side" named
  where
    along side swept = Right (SeenBySide side (concat (sees (build scene swept) side)))
    around viewpoint normal swept = case lookAround (build scene swept) viewpoint of
      Left solid -> Left ("--from: " <> inSolid (boundariesAt scene (viewpointAt viewpoint)) solid)
      Right look -> Right (maybe (SeenRegion viewpoint) (SeenByElement viewpoint) normal (lookSights look))
    inSolid touching solid = case (touching, solid) of
      ([], Enclosure) -> "the point lies outside the enclosure; give one inside it"
      ([], polygon) ->
        "the point lies inside polygon " <> polygonText polygon <> "; give one in free space or on a boundary"
      _ -> "polygons meet in the point and leave no free space around it: " <> listed <> "; give one in free space"
      where
        listed = intercalate ", " (map polygonText touching)
