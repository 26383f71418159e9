-- | Time and child processes, for the report.
module Report.Measure
  ( bestTime
  , timed
  , Outcome (..)
  , Failure (..)
  , failureWord
  , runChild
  , runContained
  , leastClock
  , ended
  ) where

import Control.Exception (evaluate, try)
import Control.Monad (replicateM)
import qualified Data.ByteString.Char8 as Bytes
import Data.IORef (newIORef, readIORef)
import GHC.Clock (getMonotonicTime)
import Report.Paper (Plan (..))
import System.CPUTime (getCPUTime)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.IO (IOMode (WriteMode), withFile)
import System.IO.Temp (withSystemTempDirectory)
import System.Mem (performGC)
import System.Process (CreateProcess (..), StdStream (..), proc, waitForProcess, withCreateProcess)
import Visibility.Law (Violation)

-- | The least processor time of some runs, in seconds, and the result of one; see 'severalTimes'. The argument comes
-- out of a cell, so that no run can share the result of another.
bestTime :: Int -> a -> (a -> b) -> IO (Double, b)
bestTime count argument work = do
  cell <- newIORef argument
  performGC
  results <- severalTimes count fst (timed (readIORef cell >>= evaluate . work))
  case results of
    (_, result) : _ -> pure (minimum (map fst results), result)
    [] -> timed (evaluate (work argument))

-- | The results of so many runs; but where that is more than one and they are short, of as many as take half a second,
-- or fifty: the least of a few short ones says little on a machine that has other work.
severalTimes :: Int -> (a -> Double) -> IO a -> IO [a]
severalTimes count secondsOf action
  | count <= 1 = replicateM 1 action
  | otherwise = go (0 :: Int) 0
  where
    go done spent
      | done >= count && (spent >= 0.5 || done >= 50) = pure []
      | otherwise = do
          result <- action
          (result :) <$> go (done + 1) (spent + secondsOf result)

-- | The processor time of an action, in seconds.
timed :: IO a -> IO (Double, a)
timed action = do
  begun <- getCPUTime
  result <- action
  finished <- getCPUTime
  pure (fromInteger (finished - begun) / 1e12, result)

-- | How a child process ended.
data Outcome
  = -- | It printed a result, in so many seconds of the clock.
    Finished !Double !Bytes.ByteString
  | Failed !Failure

-- | Why there is no result.
data Failure
  = -- | It noticed that a law was broken, and refused to go on.
    Refused
  | -- | Another exit code.
    Crashed !Int
  | -- | It was stopped after the time allowed.
    OutOfTime
  | -- | It wanted more memory than it was allowed.
    OutOfMemory
  deriving (Eq)

failureWord :: Failure -> String
failureWord failure = case failure of
  Refused -> "refused by a law"
  Crashed code -> "crashed with code " <> show code
  OutOfTime -> "not finished in time"
  OutOfMemory -> "out of memory"

-- | Runs the program with arguments where they may never end: with the plan's limits of time and memory.
runContained :: Plan -> [String] -> IO Outcome
runContained plan arguments =
  runProcess "timeout" ([show (timeLimit plan), program plan] <> arguments <> ["--memory", memory])
  where
    memory = show (memoryLimit plan) <> "M"

-- | The time of a whole command by the clock, from the start of the process to its end: the least of some runs, if
-- any ended well.
leastClock :: Plan -> [String] -> IO (Maybe Double)
leastClock plan arguments = do
  outcomes <- severalTimes (runs plan) spentIn (runChild plan arguments)
  pure $ case [seconds | Finished seconds _ <- outcomes] of
    [] -> Nothing
    times -> Just (minimum times)
  where
    spentIn outcome = case outcome of
      Finished seconds _ -> seconds
      -- Not to be tried often.
      Failed _ -> 1

-- | Runs the program with arguments.
runChild :: Plan -> [String] -> IO Outcome
runChild plan = runProcess (program plan)

runProcess :: FilePath -> [String] -> IO Outcome
runProcess command arguments = withSystemTempDirectory "viscomplex-report" $ \place -> do
  let file = place </> "out"
  begun <- getMonotonicTime
  code <- withFile file WriteMode $ \out -> withFile "/dev/null" WriteMode $ \sink ->
    withCreateProcess (proc command arguments) {std_out = UseHandle out, std_err = UseHandle sink} $ \_ _ _ process ->
      waitForProcess process
  finished <- getMonotonicTime
  case code of
    ExitSuccess -> Finished (finished - begun) <$> Bytes.readFile file
    ExitFailure number -> pure . Failed $ case number of
      70 -> Refused
      -- That of timeout.
      124 -> OutOfTime
      6 -> OutOfMemory
      _ -> Crashed number

-- | A value that unsafe arithmetic may not come to: 'Nothing' where a law breaks on the way.
ended :: a -> IO (Maybe a)
ended value = either unlawful Just <$> try (evaluate value)
  where
    unlawful :: Violation -> Maybe a
    unlawful _ = Nothing
