-- | Meshes of break points.
module Command.Mesh
  ( runMesh
  , meshed
  , divided
  ) where

import Options
import Run (printed, sweeping, withScene)
import Visibility.Format.Mesh (meshDocument)
import Visibility.Mesh
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
