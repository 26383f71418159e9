-- | Scenes from files, in each of the formats.
module Visibility.Format.File
  ( readSceneFile
  , readRawSceneFile
    -- * In two steps
  , sceneFileBytes
  , readSceneBytes
  , fileLabel
  ) where

import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.Char (toLower)
import Data.List (isSuffixOf)
import Data.List.NonEmpty (NonEmpty (..))
import System.IO.Error (isDoesNotExistError, isPermissionError, tryIOError)
import Visibility.Error
import Visibility.Format.GeoJson (readGeoJson)
import Visibility.Format.Json (readScene)
import Visibility.Format.Wkt (readWkt)
import Visibility.Scene (Scene)
import Visibility.Scene.Raw (RawScene)
import Visibility.Scene.Validate (validate)

-- | The valid scene in a file; @-@ is standard input, in JSON. All problems of the first kind met are given: the file
-- cannot be read, or not parsed, or states no valid scene.
readSceneFile :: FilePath -> IO (Either (NonEmpty Problem) Scene)
readSceneFile path = (>>= first (fmap (InvalidScene (fileLabel path))) . validate) <$> readRawSceneFile path

-- | The same before validation.
readRawSceneFile :: FilePath -> IO (Either (NonEmpty Problem) RawScene)
readRawSceneFile path = (>>= readSceneBytes (fileLabel path)) <$> sceneFileBytes path

-- | The bytes of a file, or of standard input.
sceneFileBytes :: FilePath -> IO (Either (NonEmpty Problem) ByteString)
sceneFileBytes path = first unreadable <$> tryIOError bytes
  where
    bytes = if path == "-" then Bytes.getContents else Bytes.readFile path
    unreadable fault = UnreadableFile (fileLabel path) (readFault fault) :| []
    readFault fault
      | isDoesNotExistError fault = NoSuchFile
      | isPermissionError fault = NotPermitted
      | otherwise = ReadFailed (systemText fault)

-- | What the text of a file says of a scene. The ending of the path tells the format, in capitals or not: @.geojson@ is
-- GeoJSON, @.wkt@ is WKT, all else JSON.
readSceneBytes :: FilePath -> ByteString -> Either (NonEmpty Problem) RawScene
readSceneBytes path
  | ".geojson" `isSuffixOf` lowered = readGeoJson path
  | ".wkt" `isSuffixOf` lowered = readWkt path
  | otherwise = readScene path
  where
    lowered = map toLower path

-- | What problems call a file.
fileLabel :: FilePath -> String
fileLabel "-" = "standard input"
fileLabel path = path
