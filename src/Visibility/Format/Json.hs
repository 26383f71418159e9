-- | Scenes as JSON, both ways.
module Visibility.Format.Json
  ( readScene
  , sceneDocument
  ) where

import Visibility.Format.Json.Scene
