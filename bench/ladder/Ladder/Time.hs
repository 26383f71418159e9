-- | Processor times, and rows of tables.
module Ladder.Time
  ( bestTimes
  , affordable
  , microseconds
  , row
  ) where

import Control.Exception (evaluate)
import Control.Monad (replicateM)
import Data.IORef (IORef, newIORef, readIORef)
import Data.List (transpose)
import Numeric (showFFloat)
import System.CPUTime (getCPUTime)
import System.Mem (performGC)

-- | The least processor time of some work on each scene, in so many turns. The scenes take turns, so that a machine
-- that is slower for a while is so for all of them; small ones are worked on many times in a turn. Each scene comes out
-- of a cell, so that no run can share the result of another.
bestTimes :: Int -> [a] -> (a -> Int) -> IO [Double]
bestTimes rounds scenes work = do
  cells <- mapM newIORef scenes
  turns <- replicateM rounds (mapM turn cells)
  pure (map minimum (transpose turns))
  where
    turn cell = do
      performGC
      (first, _) <- once work cell
      others <- replicateM (min 50 (floor (0.03 / max 1e-6 first))) (fst <$> once work cell)
      pure (minimum (first : others))

-- | The first scenes, as long as the work takes less than so many seconds, and the next one; with what the work gives.
affordable :: Double -> [a] -> (a -> Int) -> IO [(a, Int)]
affordable most scenes work = case scenes of
  [] -> pure []
  scene : larger -> do
    (seconds, result) <- newIORef scene >>= once work
    ((scene, result) :) <$> if seconds < most then affordable most larger work else pure []

once :: (a -> Int) -> IORef a -> IO (Double, Int)
once work cell = do
  scene <- readIORef cell
  begun <- getCPUTime
  result <- evaluate (work scene)
  ended <- getCPUTime
  pure (fromInteger (ended - begun) / 1e12, result)

microseconds :: Double -> String
microseconds seconds = showFFloat (Just 2) (seconds * 1e6) ""

row :: [String] -> String
row = concatMap (\cell -> replicate (13 - length cell) ' ' <> cell)
