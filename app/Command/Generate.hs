-- | Scenes of named families.
module Command.Generate
  ( runGenerate
  ) where

import Options
import Run (printed)
import Visibility.Format.Json (sceneDocument)
import Visibility.Scene.Family (family)

-- | Prints a generated scene.
runGenerate :: GenerateOptions -> IO ()
runGenerate options =
  printed (sceneDocument (family (generatedFamily options) (generatedSize options) (generatedSeed options)))
