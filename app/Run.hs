-- | What all commands share: scenes in, results out, exit codes.
module Run
  ( withScene
  , printed
  , written
  ) where

import Control.Exception
  ( IOException
  , SomeAsyncException
  , SomeException
  , displayException
  , evaluate
  , fromException
  , handleJust
  )
import Control.Monad (when)
import Data.ByteString.Builder (Builder, hPutBuilder, toLazyByteString)
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_)
import Data.Maybe (isJust)
import Options (Common (..))
import System.Exit (ExitCode (..), exitWith)
import System.IO (hPutStrLn, hSetBinaryMode, stderr, stdout)
import System.IO.Error (ioeGetErrorString, tryIOError)
import Visibility.Error
import Visibility.Exact.Point (Arithmetic (..))
import Visibility.Format.Json (readRawSceneFile, sceneDocument)
import Visibility.Scene (Scene, underArithmetic)
import Visibility.Scene.Raw (RawScene)
import Visibility.Scene.Validate (validate)

-- | Reads and checks the scene of a command and works on it, under the arithmetic asked for. All problems of the scene
-- are reported; then the program ends with their exit code. A law that breaks in the work ends it with exit code 70,
-- after a dump of the scene.
withScene :: Common -> (Scene -> IO ()) -> IO ()
withScene common work = do
  reading <- readRawSceneFile (sceneFile common)
  raw <- either failed pure reading
  scene <- either (failed . fmap (InvalidScene label)) pure (validate raw)
  handleJust broken (dump common raw) (work (underArithmetic (arithmeticChoice common) scene))
  where
    label = if sceneFile common == "-" then "standard input" else sceneFile common
    failed problems = do
      for_ problems (hPutStrLn stderr . ("viscomplex: " <>) . errorText)
      ends (problemsOutcome problems)

-- | Everything but a wish to end, trouble with files, or what comes from outside is an error of this program.
broken :: SomeException -> Maybe SomeException
broken exception
  | isJust (fromException exception :: Maybe ExitCode) = Nothing
  | isJust (fromException exception :: Maybe IOException) = Nothing
  | isJust (fromException exception :: Maybe SomeAsyncException) = Nothing
  | otherwise = Just exception

dump :: Common -> RawScene -> SomeException -> IO a
dump common raw exception = do
  hPutStrLn stderr ("viscomplex: " <> displayException exception)
  when (arithmeticChoice common == UnsafeDouble) $
    hPutStrLn stderr "The arithmetic was double, which is unsafe: filtered and exact do not break laws."
  hPutStrLn stderr "The scene was:"
  hPutBuilder stderr (sceneDocument raw)
  ends LawBroken

-- | Ends the program.
ends :: Outcome -> IO a
ends outcome = exitWith (case exitNumber outcome of 0 -> ExitSuccess; code -> ExitFailure code)

-- | Writes a result to standard output once all of it has been computed.
printed :: Builder -> IO ()
printed document = do
  let bytes = toLazyByteString document
  _ <- evaluate (Lazy.length bytes)
  hSetBinaryMode stdout True
  Lazy.putStr bytes

-- | Writes a result to a file, or to standard output for 'Nothing' and @-@, once all of it has been computed.
written :: Maybe FilePath -> Builder -> IO ()
written Nothing document = printed document
written (Just "-") document = printed document
written (Just path) document = do
  let bytes = toLazyByteString document
  _ <- evaluate (Lazy.length bytes)
  result <- tryIOError (Lazy.writeFile path bytes)
  case result of
    Right () -> pure ()
    Left fault -> do
      hPutStrLn stderr ("viscomplex: " <> path <> ": cannot be written: " <> ioeGetErrorString fault)
      ends UnreadableInput
