-- | Results and messages out, and how the program ends. What must be done at any moment stands in cbits/system.c.
module Output
  ( -- * Results
    printed
  , streamed
  , written
    -- * Messages
  , complain
  , visible
  , ends
  , orComplain
    -- * The run
  , prepare
  , allowMemory
  , guarded
  , broken
  ) where

import Control.Exception
import Control.Monad (void, (>=>))
import Data.ByteString.Builder (Builder, stringUtf8, toLazyByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.ByteString.Unsafe (unsafeUseAsCStringLen)
import Data.Char (isPrint, ord)
import Data.Maybe (isJust)
import Data.Word (Word64)
import Foreign.C (CInt (..), CSize (..), CString, throwErrnoIfMinus1, throwErrnoIfMinus1_)
import GHC.IO.Encoding (mkTextEncoding, setFileSystemEncoding, setLocaleEncoding, utf8)
import Numeric (showHex)
import Progress (counting)
import System.Exit (ExitCode (..), exitWith)
import System.IO (hFlush, hSetEncoding, stderr, stdout)
import System.IO.Error (ioeGetHandle, tryIOError)
import System.Posix.Internals (withFilePath)
import Visibility.Error

foreign import ccall "viscomplex_begin" begin :: CString -> IO CInt

foreign import ccall "viscomplex_write" write :: CInt -> CString -> CSize -> IO CInt

foreign import ccall "viscomplex_end" end :: CInt -> IO CInt

foreign import ccall "viscomplex_exhausted" exhausted :: CInt -> IO ()

foreign import ccall "viscomplex_heed_interrupts" heedInterrupts :: IO ()

-- | Bounds what the program may take of memory, in bytes; beyond it, it ends with exit code 6.
foreign import ccall "viscomplex_allow" allowMemory :: Word64 -> IO ()

-- | To be done before all else. Then texts are UTF-8 in every locale. Names of files are bytes: those that are not
-- UTF-8 go through as they are. An interrupt ends the program as any other signal does.
prepare :: IO ()
prepare = do
  heedInterrupts
  setLocaleEncoding utf8
  bytes <- mkTextEncoding "UTF-8//ROUNDTRIP"
  setFileSystemEncoding bytes
  hSetEncoding stderr bytes

-- | Ends the program with the exit code of what went wrong, if nothing did so before: 70 where a law breaks.
guarded :: IO () -> IO ()
guarded work = handle fault (work >> flushed)
  where
    -- What has been printed without us, as the help is, is seen to be printed.
    flushed = orComplain "standard output" (hFlush stdout)
    fault exception = case exception of
      _ | Just code <- fromException exception -> flushed >> throwIO (code :: ExitCode)
      _ | Just trouble <- fromException exception ->
            -- Nobody can be told of a mistake in the arguments.
            if ioeGetHandle trouble == Just stderr
              then ends WrongUsage
              else orComplain "standard output" (ioError trouble)
      _ | Just HeapOverflow <- fromException exception -> exhausted 0
      _ | Just StackOverflow <- fromException exception -> exhausted 0
      _ -> complain (lines (displayException exception)) >> ends LawBroken

-- | Everything but a wish to end, trouble with files, or what comes from outside is an error of this program.
broken :: SomeException -> Maybe SomeException
broken exception
  | isJust (fromException exception :: Maybe ExitCode) = Nothing
  | isJust (fromException exception :: Maybe IOException) = Nothing
  | isJust (fromException exception :: Maybe SomeAsyncException) = Nothing
  | otherwise = Just exception

-- | Writes messages to standard error, a line each, 'visible'.
complain :: [String] -> IO ()
complain messages = void (tryIOError (put 2 (toLazyByteString (foldMap line messages))))
  where
    line message = stringUtf8 ("viscomplex: " <> visible message <> "\n")

-- | A text in which what would not be seen, or would do something to a terminal, is shown as an escape.
visible :: String -> String
visible = concatMap shown
  where
    shown c
      | isPrint c = [c]
      | c == '\n' = "\\n"
      | c == '\t' = "\\t"
      -- A byte of the name of a file that is not UTF-8.
      | '\xdc80' <= c && c <= '\xdcff' = "\\x" <> showHex (ord c - 0xdc00) ""
      | c < '\x100' = "\\x" <> digits 2 c
      | otherwise = "\\u" <> digits 4 c
    digits n c = let hex = showHex (ord c) "" in replicate (n - length hex) '0' <> hex

-- | Ends the program.
ends :: Outcome -> IO a
ends outcome = exitWith (case exitNumber outcome of 0 -> ExitSuccess; code -> ExitFailure code)

-- | Writes a result to standard output once all of it has been computed.
printed :: Builder -> IO ()
printed = computed >=> orComplain "standard output" . put 1

-- | Writes a result to standard output while it is computed, in constant memory. Should a law break on the way, part of
-- it has been written.
streamed :: Builder -> IO ()
streamed document = orComplain "standard output" (put 1 (toLazyByteString document))

-- | Writes a result to a file, or to standard output for 'Nothing' and @-@, once all of it has been computed. The file
-- is then whole, or what it was before.
written :: Maybe FilePath -> Builder -> IO ()
written Nothing document = printed document
written (Just "-") document = printed document
written (Just path) document = do
  bytes <- computed document
  orComplain path $ do
    file <- throwErrnoIfMinus1 "" (withFilePath path begin)
    put file bytes
    throwErrnoIfMinus1_ "" (end file)

computed :: Builder -> IO Lazy.ByteString
computed document = do
  let bytes = toLazyByteString document
  chunks <- counting "bytes made" Bytes.length (Lazy.toChunks bytes)
  bytes <$ mapM_ evaluate chunks

put :: CInt -> Lazy.ByteString -> IO ()
put file = mapM_ chunk . Lazy.toChunks
  where
    chunk bytes = unsafeUseAsCStringLen bytes $ \(start, size) ->
      throwErrnoIfMinus1_ "" (write file start (fromIntegral size))

-- | Ends the program with a message where writing to a place fails.
orComplain :: FilePath -> IO () -> IO ()
orComplain place work = tryIOError work >>= either failed pure
  where
    failed fault = do
      complain [place <> ": cannot be written: " <> systemText fault <> "; give a place that can be"]
      ends UnreadableInput
