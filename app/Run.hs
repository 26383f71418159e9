{-# LANGUAGE OverloadedStrings #-}

-- | What all commands share: scenes in, results out, exit codes.
module Run
  ( guarded
  , withScene
  , sweeping
  , sweepingPieces
  , measuring
  , printed
  , streamed
  , written
  , orComplain
  , complain
  , ends
  ) where

import Control.Exception
  (IOException, SomeAsyncException, SomeException, displayException, evaluate, fromException, handleJust)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.ByteString.Builder (Builder, hPutBuilder, stringUtf8, toLazyByteString)
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (toList)
import Data.Maybe (isJust)
import Options (Common (..))
import Progress (withProgress)
import System.Exit (ExitCode (..), exitWith)
import System.IO (BufferMode (..), Handle, hFlush, hSetBinaryMode, hSetBuffering, stderr, stdout)
import System.IO.Error (ioeGetErrorString, ioeGetErrorType, isResourceVanishedErrorType, tryIOError)
import Visibility.Error
import Visibility.Exact.Point (Arithmetic (..))
import Visibility.FormFactor (Measures, measuresInPieces)
import Visibility.Format.File (fileLabel, readSceneBytes, sceneFileBytes)
import Visibility.Scene (Scene, underArithmetic)
import Visibility.Scene.Validate (validate)
import Visibility.Sweep (Piece, Vertex, pieceLength, piecesBy, verticesBy)

-- | Ends the program with exit code 70 and the law's name where a law breaks.
guarded :: IO () -> IO ()
guarded = handleJust broken (\exception -> complain [displayException exception] >> ends LawBroken)

-- | Reads and checks the scene of a command and works on it, under the arithmetic asked for. All problems of the
-- scene are reported; then the program ends with their exit code. A law that breaks in the work ends it with exit
-- code 70, after a dump of the scene.
withScene :: Common -> (Scene -> IO ()) -> IO ()
withScene common work = do
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
    displayException exception
      : ["The arithmetic was double, which is unsafe: filtered and exact break no law." | unsafe]
        <> ["The scene was:"]
  Bytes.hPut stderr (bytes <> "\n")
  hFlush stderr
  ends LawBroken
  where
    unsafe = arithmeticChoice common == UnsafeDouble

-- | Everything but a wish to end, trouble with files, or what comes from outside is an error of this program.
broken :: SomeException -> Maybe SomeException
broken exception
  | isJust (fromException exception :: Maybe ExitCode) = Nothing
  | isJust (fromException exception :: Maybe IOException) = Nothing
  | isJust (fromException exception :: Maybe SomeAsyncException) = Nothing
  | otherwise = Just exception

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

-- | Writes messages to standard error, a line or more each.
complain :: [String] -> IO ()
complain messages = do
  hSetBuffering stderr (BlockBuffering Nothing)
  hPutBuilder stderr (foldMap (\message -> stringUtf8 ("viscomplex: " <> message <> "\n")) messages)
  hFlush stderr

-- | Ends the program.
ends :: Outcome -> IO a
ends outcome = exitWith (case exitNumber outcome of 0 -> ExitSuccess; code -> ExitFailure code)

-- | Writes a result to standard output once all of it has been computed.
printed :: Builder -> IO ()
printed document = do
  let bytes = toLazyByteString document
  _ <- evaluate (Lazy.length bytes)
  toStandardOutput (`Lazy.hPut` bytes)

-- | Writes a result to standard output while it is computed, in constant memory. Should a law break on the way, part of
-- it has been written.
streamed :: Builder -> IO ()
streamed document = toStandardOutput (`hPutBuilder` document)

-- | Writes a result to a file, or to standard output for 'Nothing' and @-@, once all of it has been computed.
written :: Maybe FilePath -> Builder -> IO ()
written Nothing document = printed document
written (Just "-") document = printed document
written (Just path) document = do
  let bytes = toLazyByteString document
  _ <- evaluate (Lazy.length bytes)
  orComplain path (Lazy.writeFile path bytes)

toStandardOutput :: (Handle -> IO ()) -> IO ()
toStandardOutput write = do
  hSetBinaryMode stdout True
  hSetBuffering stdout (BlockBuffering (Just 65536))
  orComplain "standard output" (write stdout >> hFlush stdout)

-- | Ends the program with a message where writing fails; silently where nobody reads any longer.
orComplain :: FilePath -> IO () -> IO ()
orComplain place write = do
  result <- tryIOError write
  case result of
    Right () -> pure ()
    Left fault
      | isResourceVanishedErrorType (ioeGetErrorType fault) -> ends Success
      | otherwise -> do
          complain [place <> ": cannot be written: " <> ioeGetErrorString fault <> "; give a place that can be"]
          ends UnreadableInput
