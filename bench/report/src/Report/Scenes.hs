-- | The scenes of the report, each also as a file, so that its figures can be measured again.
module Report.Scenes
  ( Case (..)
  , familyCase
  , rawCase
  , enlarged
  , saved
  ) where

import Data.ByteString.Builder (toLazyByteString)
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.Text as Text
import System.Directory (createDirectoryIfMissing)
import System.FilePath (takeDirectory)
import Visibility.Format.Json (sceneDocument)
import Visibility.Law (broken)
import Visibility.Scene (Scene)
import Visibility.Scene.Family
import Visibility.Exact.Point (Point (..))
import Visibility.Scene.Raw (RawPolygon (..), RawScene (..))
import Visibility.Scene.Validate (validate)

-- | A scene with its name and its file.
data Case = Case
  { caseName :: !String
  , caseFile :: !FilePath
  , caseRaw :: !RawScene
  , caseScene :: !Scene
  }

-- | A scene of a family by its size and seed 1.
familyCase :: FilePath -> Family -> Int -> Case
familyCase place kind n = case size n of
  Just k -> rawCase place (Text.unpack (familyName kind) <> "-" <> show n) (family kind k (Seed 1))
  Nothing -> broken "a scene of the report has a size" (show (kind, n))

-- | The same scene with all coordinates times as much.
enlarged :: Rational -> Case -> RawScene
enlarged factor found = raw {rawPolygons = map larger (rawPolygons raw)}
  where
    raw = caseRaw found
    larger p = p {rawCorners = [Point (factor * x) (factor * y) | Point x y <- rawCorners p]}

-- | Any valid scene.
rawCase :: FilePath -> String -> RawScene -> Case
rawCase place name raw = case validate raw of
  Right scene -> Case name (place <> "/scenes/" <> name <> ".json") raw scene
  Left problems -> broken "a scene of the report is valid" (name <> show problems)

-- | Writes the file.
saved :: Case -> IO Case
saved found = do
  createDirectoryIfMissing True (takeDirectory (caseFile found))
  Lazy.writeFile (caseFile found) (toLazyByteString (sceneDocument (caseRaw found)))
  pure found
