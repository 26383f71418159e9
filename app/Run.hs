{-# LANGUAGE OverloadedStrings #-}

-- | What all commands share: scenes in, results out, exit codes.
module Run
  ( withScene
  , sweeping
  , sweepingPieces
  , measuring
  , refuse
  , warn
  , module Output
  ) where

import Control.Exception (SomeException, displayException, evaluate, handleJust)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.Char (toLower)
import Data.Foldable (toList)
import Data.List (group, sort)
import qualified Data.List.NonEmpty as NonEmpty
import qualified Data.Text as Text
import Options.Common (Common (..), Telling (..))
import Output
import Progress
import System.FilePath (takeExtension)
import System.IO (stderr)
import System.IO.Error (tryIOError)
import Visibility.Error
import Visibility.Exact.Point (Arithmetic (..))
import Visibility.FormFactor (Measures, measuresInPieces)
import Visibility.Format.File (fileLabel, readSceneBytes, sceneFileBytes)
import Visibility.Scene (Scene, underArithmetic)
import Visibility.Scene.Raw (RawScene (..), RawPolygon (..))
import Visibility.Scene.Validate (validate)
import Visibility.Sweep (Piece, Vertex, pieceLength, piecesBy, verticesBy)

-- | Reads and checks the scene of a command and works on it, under the arithmetic asked for. The problems of the scene
-- are reported; then the program ends with their exit code. A law that breaks in the work ends it with exit
-- code 70, after a dump of the scene.
withScene :: Common -> (Scene -> IO ()) -> IO ()
withScene common work = do
  mapM_ allowMemory (memoryChoice common)
  watching (talk common)
  stage "reading the scene"
  bytes <- sceneFileBytes file >>= either failed pure
  raw <- either failed pure (readSceneBytes label bytes)
  handleJust broken (dump common bytes) $ do
    scene <- either (failed . fmap (InvalidScene label)) pure (validate raw)
    -- In GeoJSON a name is that of a feature, which may be several polygons.
    warn common [label <> ": " <> twins | map toLower (takeExtension file) /= ".geojson", Just twins <- [twinNames raw]]
    stage "working"
    work (underArithmetic (arithmeticChoice common) scene)
  where
    file = sceneFile common
    label = fileLabel file
    -- They are told while they are found, and none is kept. All problems of a file are of one outcome.
    failed problems = do
      outcome <- evaluate (problemOutcome (NonEmpty.head problems))
      complain (told (toList problems))
      ends outcome
    told = case telling common of
      TellBriefly -> briefly
      TellAll -> map errorText

-- Reports a law that broke in work on the scene that these bytes state, and these bytes as they are. To write the scene
-- anew, all that reads scenes would have to stay at hand during the work.
dump :: Common -> ByteString -> SomeException -> IO ()
dump common bytes exception = do
  complain $
    lines (displayException exception)
      <> ["The arithmetic was double, which is unsafe: filtered and exact break no law." | unsafe]
      <> ["The scene was:"]
  _ <- tryIOError (Bytes.hPut stderr (bytes <> "\n"))
  ends LawBroken
  where
    unsafe = arithmeticChoice common == UnsafeDouble

-- Names that several polygons have, if there are any: they name none of them.
twinNames :: RawScene -> Maybe String
twinNames raw = case [twins | twins@(_ : _ : _) <- group (sort names)] of
  [] -> Nothing
  twins@(one : _) ->
    Just
      ( show (length one)
          <> " polygons are named "
          <> concatMap Text.unpack (take 1 one)
          <> concat [", and " <> show (length twins - 1) <> " more names are of several" | length twins > 1]
          <> "; such a name addresses none of them, a number does"
      )
  where
    names = [name | polygon <- rawPolygons raw <> toList (rawEnclosure raw), Just name <- [rawPolygonName polygon]]

-- | Works on the vertices of a scene while they are swept by the scheduler asked for, counting them.
sweeping :: Common -> Scene -> ([Vertex] -> IO a) -> IO a
sweeping common scene act = counting "vertices swept" (const 1) (verticesBy (schedulerChoice common) scene) >>= act

-- | Works on what is made of each piece of the sweep, likewise.
sweepingPieces :: Common -> Scene -> (Piece -> a) -> ([a] -> IO b) -> IO b
sweepingPieces common scene make act =
  counting "vertices swept" fst (map made (piecesBy (schedulerChoice common) scene)) >>= act . map snd
  where
    made piece = let item = make piece in item `seq` (pieceLength piece, item)

-- | Ends the program where the scene is not one for what was asked of it.
refuse :: String -> IO a
refuse problem = complain [problem] >> ends WrongUsage

-- | Writes messages of what is no error, where they are wanted.
warn :: Common -> [String] -> IO ()
warn common messages = case talk common of
  Talkative | not (null messages) -> complain messages >> watching Talkative
  _ -> pure ()

-- | The measures of the lines between what sees each other, from a sweep that shows its progress.
measuring :: Common -> Scene -> IO Measures
measuring common scene = sweepingPieces common scene id (\swept -> pure $! measuresInPieces scene swept)
