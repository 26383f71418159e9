module Visibility.Scene.StatusSpec (spec) where

import Control.Monad (foldM)
import Control.Monad.ST (ST, runST)
import Data.List (delete, insert)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck
import Visibility.Scene.Status

spec :: Spec
spec =
  modifyMaxSuccess (* 5) $
    prop "a status is the list of what was put in and not taken out, in the order of the one who asks" $
      forAll changes $ \(bound, slots) ->
        runST (newStatus bound >>= \status -> reverse . snd <$> foldM (changed status) ([], []) slots)
          === reverse (snd (foldl expected ([], []) slots))
  where
    -- Slots to be put in if they are out, and to be taken out if they are in, their order being that of numbers.
    changes = do
      bound <- elements [1, 3, 10, 60]
      k <- choose (0, 4 * bound)
      slots <- vectorOf k (choose (0, bound - 1))
      rising <- frequency [(3, pure False), (1, pure True)]
      pure (bound, if rising then [0 .. bound - 1] <> slots else slots)

-- What there is after each change, upwards and downwards, with the neighbours of what was changed.
type Record = ([Int], [Int], (Int, Int))

expected :: ([Int], [Record]) -> Int -> ([Int], [Record])
expected (held, records) s = (held', (held', reverse held', (low, high)) : records)
  where
    held' = if s `elem` held then delete s held else insert s held
    low = last (noSlot : filter (< s) held)
    high = head (filter (> s) held <> [noSlot])

changed :: Status s -> ([Int], [Record]) -> Int -> ST s ([Int], [Record])
changed status (held, records) s = do
  gap <-
    if s `elem` held
      then remove status s
      else do
        (low, high) <- lookupGap status (pure . (< s))
        insertBetween status low high s
        pure (low, high)
  (_, lowest) <- lookupGap status (const (pure False))
  (highest, _) <- lookupGap status (const (pure True))
  up <- follow (above status) lowest
  down <- follow (below status) highest
  pure (up, (up, down, gap) : records)
  where
    follow next t = if t == noSlot then pure [] else (t :) <$> (next t >>= follow next)
