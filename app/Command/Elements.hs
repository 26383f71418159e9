-- | Commands on the elements of sides: mesh and radiosity.
module Command.Elements
  ( runMesh
  , meshed
  , divided
  , runRadiosity
  , solved
  ) where

import Data.Maybe (fromMaybe)
import Options
import Run (complain, ends, measuring, printed, sweeping, withScene)
import Visibility.Error (Outcome (..))
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Exact.Rounding (decimal, defaultDigits, digits, outwardDecimals)
import Visibility.Format.Mesh (meshDocument)
import Visibility.Format.Radiosity (radiosityDocument)
import Visibility.Mesh
import Visibility.Radiosity
import Visibility.Scene (Scene)

-- | The break points of all sides, as JSON.
runMesh :: Common -> MeshOptions -> IO ()
runMesh common options = withScene common $ \scene -> meshed common options scene (\kept -> printed . meshDocument kept)

-- | Works on the elements asked for and the scene in which they are the sides.
divided :: Common -> Elements -> Scene -> (Refined -> IO ()) -> IO ()
divided common wanted scene work = case wanted of
  WholeSides -> work (unrefined scene)
  ElementsOf options -> meshed common options scene (\kept _ -> work (refined kept))

-- | Works on the mesh asked for, and on what was dropped of it.
meshed :: Common -> MeshOptions -> Scene -> (Mesh -> Mesh -> IO ()) -> IO ()
meshed common options scene work = case meshBreaks options of
  AllBreaks -> sweeping common scene (within . discontinuityMesh scene)
  OnlyShadowLimits -> sweeping common scene (within . shadowLimits . discontinuityMesh scene)
  Uniform parts -> within (uniformMesh parts scene)
  where
    within mesh = uncurry work (maybe (mesh, emptyMesh scene) (`bounded` mesh) (mostElements options))

-- | Radiosities with their bounds; or how close bounds can be, where they cannot be as close as asked.
runRadiosity :: Common -> RadiosityOptions -> IO ()
runRadiosity common options = withScene common $ \scene ->
  divided common (radiosityElements options) scene $ \cut ->
    solved common (radiosityCloseness options) cut (printed . radiosityDocument)

-- | Works on the radiosities of elements; or ends the program where bounds cannot be as close as asked.
solved :: Common -> Closeness -> Refined -> (Radiosity -> IO ()) -> IO ()
solved common closeness cut work = do
  sums <- measuring common (refinedScene cut)
  case radiosityOfElements closeness cut sums of
    Right found -> work found
    Left shortfall -> do
      complain [sceneFile common <> ": " <> shortfallText closeness shortfall]
      ends WrongUsage

-- | What was asked for, what can be had, and what to ask for.
shortfallText :: Closeness -> Shortfall -> String
shortfallText closeness (Shortfall spread passes) = case (closeness, spread) of
  (WithinTolerance x, Just proved) ->
    "bounds cannot be proved to be within "
      <> short (toleranceValue x)
      <> " with Doubles, but within "
      <> upper (proved * 10 / 9)
      <> afterwards
      <> "; give --tolerance "
      <> upper (proved * 10 / 9)
      <> " or more, or --digits for exact form factors"
  (ToDigits _, Just proved) ->
    "bounds came within " <> upper proved <> afterwards <> ", no closer; give fewer --digits, or lower reflectivities"
  (_, Nothing) -> "no bounds can be proved" <> afterwards <> ": a reflectivity is too near to 1; give lower ones"
  where
    afterwards = " after " <> show passes <> " passes over the form factors"
    short = decimal two . RootSum.rational
    upper q = snd (outwardDecimals two (q, q))
    two = fromMaybe defaultDigits (digits 2)
