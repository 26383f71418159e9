-- | The scenes that benchmarks work on.
module Bench.Scenes
  ( rawOf
  , sceneOf
  , fileOf
  ) where

import Data.ByteString (ByteString)
import Data.ByteString.Builder (toLazyByteString)
import qualified Data.ByteString.Lazy as Lazy
import Visibility.Format.Json (sceneDocument)
import Visibility.Law (broken)
import Visibility.Scene (Scene)
import Visibility.Scene.Family
import Visibility.Scene.Raw (RawScene)
import Visibility.Scene.Validate (validate)

-- | A scene of a family, of so many polygons, by seed 1.
sceneOf :: Family -> Int -> Scene
sceneOf kind n = case validate (rawOf kind n) of
  Right scene -> scene
  Left _ -> broken "a generated scene is valid" (show (kind, n))

-- | Its file.
fileOf :: Family -> Int -> ByteString
fileOf kind n = Lazy.toStrict (toLazyByteString (sceneDocument (rawOf kind n)))

rawOf :: Family -> Int -> RawScene
rawOf kind n = case size n of
  Just k -> family kind k (Seed 1)
  Nothing -> broken "a scene has a size" (show (kind, n))
