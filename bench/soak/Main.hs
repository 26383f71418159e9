-- | Random scenes aimed at degeneracy, as many as one has patience for: @soak SCENES SEED@ asks of each what
-- "Visibility.Test.Soak" asks, a family after the other, says how many of each were tried, and shows every scene that
-- fails.
module Main (main) where

import Control.Monad (foldM, unless, when)
import System.Environment (getArgs)
import System.Exit (exitFailure)
import System.IO
import Test.QuickCheck.Gen (unGen)
import Test.QuickCheck.Random (mkQCGen)
import Text.Read (readMaybe)
import Visibility.Test.Generator (sampleText, Sample (..))
import Visibility.Test.Soak

main :: IO ()
main = do
  arguments <- getArgs
  case mapM readMaybe arguments of
    Just [scenes, seed] -> do
      hSetBuffering stdout LineBuffering
      failed <- sum <$> mapM (family (shareOf scenes) seed) soakFamilies
      unless (failed == 0) exitFailure
    _ -> hPutStrLn stderr "soak SCENES SEED" >> exitFailure
  where
    shareOf scenes = (scenes + length soakFamilies - 1) `div` length soakFamilies

-- | Tries so many scenes of a family and gives the number of those that fail.
family :: Int -> Int -> SoakFamily -> IO Int
family count seed kind = do
  failed <- foldM try (0 :: Int) [1 .. count]
  putStrLn (soakName kind <> ": " <> show count <> " scenes, " <> show failed <> " failed")
  pure failed
  where
    try failed i = do
      let scene = unGen (soakScenes kind) (mkQCGen (seed * 1000003 + i)) (1 + i `mod` 100)
          wrong = faults scene
      when (i `mod` 10000 == 0) $ hPutStrLn stderr (soakName kind <> ": " <> show i)
      case wrong of
        [] -> pure failed
        _ -> do
          mapM_ putStrLn wrong
          putStrLn ("seed " <> show seed <> ", scene " <> show i <> ": " <> sampleText (sampleRaw scene))
          pure $! failed + 1
