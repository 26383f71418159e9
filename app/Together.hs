-- | Work on several lists at once.
module Together
  ( inTurns
  ) where

import Control.Concurrent (forkOn, getNumCapabilities, killThread, setNumCapabilities)
import Control.Concurrent.QSem (newQSem, signalQSem, waitQSem)
import Control.Concurrent.Chan (newChan, readChan, writeChan)
import Control.Exception (SomeException, bracket, evaluate, throwIO, try)
import Control.Monad (zipWithM)
import System.IO.Unsafe (unsafeInterleaveIO)

-- | Runs an action on the items of several lists, taken in turns, an item of each; where one has ended, of the others.
-- Each list is evaluated by a thread of its own, item by item, and no more than a few items ahead of what the action
-- has consumed. What goes wrong in an item does so where the action reaches it.
inTurns :: [[a]] -> ([a] -> IO b) -> IO b
inTurns lists act = do
  capabilities <- getNumCapabilities
  setNumCapabilities (max capabilities (length lists))
  bracket (zipWithM start [0 ..] lists) (mapM_ (killThread . fst)) (\threads -> merged (map snd threads) [] >>= act)
  where
    start k items = do
      found <- newChan
      free <- newQSem ahead
      let work rest = do
            waitQSem free
            next <- try (evaluate (forced rest))
            case next of
              Right (item : more) -> writeChan found (Right (Just item)) >> work more
              Right [] -> writeChan found (Right Nothing)
              Left problem -> writeChan found (Left (problem :: SomeException))
      thread <- forkOn k (work items)
      pure (thread, readChan found <* signalQSem free)
    forced rest = case rest of
      item : _ -> item `seq` rest
      [] -> rest
    merged [] [] = pure []
    merged [] later = merged (reverse later) []
    merged (next : rest) later = unsafeInterleaveIO $ do
      found <- next
      case found of
        Right (Just item) -> (item :) <$> merged rest (next : later)
        Right Nothing -> merged rest later
        Left problem -> throwIO problem

-- | So many items wait to be consumed.
ahead :: Int
ahead = 4
