-- | Commands on the elements of sides: mesh and radiosity.
module Command.Elements
  ( runMesh
  , meshed
  , divided
  , runRadiosity
  , solved
  ) where

import Data.List (intercalate)
import Data.Maybe (fromMaybe)
import Options.Common
import Options.Mesh
import Progress (stage)
import Run (complain, ends, measuring, printed, streamed, sweeping, withScene)
import Visibility.Error (Outcome (..))
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Exact.Rounding (decimal, defaultDigits, digits, outwardDecimals)
import Visibility.Format.Mesh (meshDocument, uniformDocument)
import Visibility.Format.Radiosity (radiosityDocument)
import Visibility.Mesh
import Visibility.Radiosity
import Visibility.Scene (Scene)

-- | The break points of all sides, as JSON.
runMesh :: Common -> MeshOptions -> IO ()
runMesh common options = withScene common $ \scene -> case options of
  MeshOptions (Uniform parts) Nothing -> streamed (uniformDocument parts scene)
  _ -> meshed common options scene (\kept -> printed . meshDocument kept)

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
runRadiosity :: Common -> Elements -> Closeness -> IO ()
runRadiosity common elements close = withScene common $ \scene ->
  divided common elements scene $ \cut ->
    solved common ["--digits for exact form factors"] close cut (printed . radiosityDocument)

-- | Works on the radiosities of elements; or ends the program where bounds cannot be as close as asked. Given is what
-- the command may be told besides a tolerance.
solved :: Common -> [String] -> Closeness -> Refined -> (Radiosity -> IO ()) -> IO ()
solved common ways closeness cut work = do
  sums <- measuring common (refinedScene cut)
  stage "solving for radiosities"
  case radiosityOfElements closeness cut sums of
    Right found -> work found
    Left shortfall -> do
      complain [sceneFile common <> ": " <> shortfallText ways closeness shortfall]
      ends WrongUsage

-- | What was asked for, what can be had, and what to ask for.
shortfallText :: [String] -> Closeness -> Shortfall -> String
shortfallText ways closeness (Shortfall spread passes) = case (closeness, spread) of
  (WithinTolerance x, Just proved) ->
    "bounds cannot be proved to be within "
      <> short (toleranceValue x)
      <> " with Doubles, but within "
      <> upper (proved * 10 / 9)
      <> afterwards
      <> given (["--tolerance " <> upper (proved * 10 / 9) <> " or more" | proved < 4 / 5] <> ways)
  (ToDigits _, Just proved) ->
    "bounds came within " <> upper proved <> afterwards <> ", no closer" <> given ["fewer --digits" | proved < 1 / 100]
  (_, Nothing) -> "no bounds can be proved" <> afterwards <> ": a reflectivity is too near to 1; give lower ones"
  where
    given advice = "; give " <> intercalate ", or " (advice <> ["lower reflectivities"])
    afterwards = " after " <> show passes <> " passes over the form factors"
    short = decimal two . RootSum.rational
    upper q = snd (outwardDecimals two (q, q))
    two = fromMaybe defaultDigits (digits 2)
