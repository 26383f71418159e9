{-# LANGUAGE OverloadedStrings #-}

-- | What all commands share: scenes in, results out, exit codes.
module Run
  ( withScene
  , sweeping
  , sweepingPieces
  , measuring
  , module Output
  ) where

import Control.Exception (SomeException, displayException, handleJust)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.Foldable (toList)
import Options (Common (..))
import Output
import Progress (withProgress)
import System.IO (stderr)
import System.IO.Error (tryIOError)
import Visibility.Error
import Visibility.Exact.Point (Arithmetic (..))
import Visibility.FormFactor (Measures, measuresInPieces)
import Visibility.Format.File (fileLabel, readSceneBytes, sceneFileBytes)
import Visibility.Scene (Scene, underArithmetic)
import Visibility.Scene.Validate (validate)
import Visibility.Sweep (Piece, Vertex, pieceLength, piecesBy, verticesBy)

-- | Reads and checks the scene of a command and works on it, under the arithmetic asked for. All problems of the
-- scene are reported; then the program ends with their exit code. A law that breaks in the work ends it with exit
-- code 70, after a dump of the scene.
withScene :: Common -> (Scene -> IO ()) -> IO ()
withScene common work = do
  mapM_ allowMemory (memoryChoice common)
  bytes <- sceneFileBytes file >>= either failed pure
  raw <- either failed pure (readSceneBytes label bytes)
  handleJust broken (dump common bytes) $ do
    scene <- either (failed . fmap (InvalidScene label)) pure (validate raw)
    work (underArithmetic (arithmeticChoice common) scene)
  where
    file = sceneFile common
    label = fileLabel file
    failed problems = complain (map errorText (toList problems)) >> ends (problemsOutcome problems)

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

-- | Works on the vertices of a scene while they are swept by the scheduler asked for, showing progress.
sweeping :: Common -> Scene -> ([Vertex] -> IO a) -> IO a
sweeping common scene = withProgress "vertices swept" (const 1) (verticesBy (schedulerChoice common) scene)

-- | Works on what is made of each piece of the sweep, likewise.
sweepingPieces :: Common -> Scene -> (Piece -> a) -> ([a] -> IO b) -> IO b
sweepingPieces common scene make act =
  withProgress "vertices swept" fst (map made (piecesBy (schedulerChoice common) scene)) (act . map snd)
  where
    made piece = let item = make piece in item `seq` (pieceLength piece, item)

-- | The measures of the lines between what sees each other, from a sweep that shows its progress.
measuring :: Common -> Scene -> IO Measures
measuring common scene = sweepingPieces common scene id (\swept -> pure $! measuresInPieces scene swept)
