-- | A line on the terminal that says how far long work has come.
module Progress
  ( withProgress
  ) where

import Control.Exception (finally)
import Control.Monad (when)
import Data.IORef (newIORef, readIORef, writeIORef)
import Data.Word (Word64)
import GHC.Clock (getMonotonicTimeNSec)
import System.IO (hFlush, hIsTerminalDevice, hPutStr, stderr)
import System.IO.Unsafe (unsafeInterleaveIO)

-- | Runs an action on a list that shows, while it is consumed, how much of it has been, each item counting as much as
-- the function says; then clears the line. Nothing is shown in the first second, nor where standard error is no
-- terminal.
--
-- The list is read lazily, as standard input would be, so that memory stays what the action needs.
withProgress :: String -> (a -> Int) -> [a] -> ([a] -> IO b) -> IO b
withProgress what amount items act = do
  terminal <- hIsTerminalDevice stderr
  if not terminal
    then act items
    else do
      begun <- getMonotonicTimeNSec
      shown <- newIORef begun
      let cleared = do
            final <- readIORef shown
            when (final > begun) $ hPutStr stderr "\r\ESC[K" >> hFlush stderr
      (watched shown 0 items >>= act) `finally` cleared
  where
    watched shown done rest = unsafeInterleaveIO $ case together 0 rest of
      ([], _) -> pure []
      (now, later) -> do
        let done' = done + sum (map amount now)
        tick shown done'
        (now <>) <$> watched shown done' later
    -- Items up to the next look at the clock.
    together counted rest = case rest of
      item : more | counted < piece -> let (now, later) = together (counted + amount item) more in (item : now, later)
      _ -> ([], rest)
    tick shown done = do
      time <- getMonotonicTimeNSec
      latest <- readIORef shown
      when (time - latest > second) $ do
        writeIORef shown time
        hPutStr stderr ("\r\ESC[K" <> show (done :: Int) <> " " <> what) >> hFlush stderr

-- | The amount between two looks at the clock.
piece :: Int
piece = 4096

second :: Word64
second = 1000000000
