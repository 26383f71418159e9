-- | The JSON formats, and reading scenes from files.
module Visibility.Format.Json
  ( -- * Scenes
    readScene
  , sceneDocument
    -- * Files
  , readSceneFile
  , readRawSceneFile
  ) where

import Control.Monad ((>=>))
import Data.Bifunctor (first)
import qualified Data.ByteString as Bytes
import Data.Char (toLower)
import Data.List (isSuffixOf)
import Data.List.NonEmpty (NonEmpty (..))
import System.IO.Error (ioeGetErrorString, isDoesNotExistError, isPermissionError, tryIOError)
import Visibility.Error
import Visibility.Format.Json.Scene
import Visibility.Scene (Scene)
import Visibility.Scene.Raw (RawScene)
import Visibility.Scene.Validate (validate)

-- | The valid scene in a file; @-@ is standard input. All problems of the first kind met are given: the file cannot be
-- read, or not parsed, or states no valid scene.
readSceneFile :: FilePath -> IO (Either (NonEmpty Problem) Scene)
readSceneFile path = (>>= first (fmap (InvalidScene (fileLabel path))) . validate) <$> readRawSceneFile path

-- | The same before validation.
readRawSceneFile :: FilePath -> IO (Either (NonEmpty Problem) RawScene)
readRawSceneFile path
  | ".geojson" `isSuffixOf` lowered = pure (notYet GeoJson)
  | ".wkt" `isSuffixOf` lowered = pure (notYet Wkt)
  | otherwise = (first unreadable >=> readScene label) <$> tryIOError bytes
  where
    lowered = map toLower path
    label = fileLabel path
    bytes = if path == "-" then Bytes.getContents else Bytes.readFile path
    notYet format = Left (UnparseableFile label (FormatNotReadYet format) :| [])
    unreadable fault = UnreadableFile label (readFault fault) :| []
    readFault fault
      | isDoesNotExistError fault = NoSuchFile
      | isPermissionError fault = NotPermitted
      | otherwise = ReadFailed (ioeGetErrorString fault)

-- What problems call a file.
fileLabel :: FilePath -> String
fileLabel "-" = "standard input"
fileLabel path = path
