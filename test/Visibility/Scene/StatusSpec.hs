module Visibility.Scene.StatusSpec (spec) where

import Control.Monad (foldM, forM_)
import Control.Monad.ST (ST, runST)
import Data.List (delete, insert)
import Data.STRef
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck
import Visibility.Scene.Status

spec :: Spec
spec = do
  it "asks O(log n) questions a search on average, also where a tree that is turned one step at a time asks n" $
    [ (name, n)
    | n <- [512, 2048, 8192]
    , let most = 4 * n * ceiling (logBase 2 (fromIntegral n) :: Double)
    , (name, order) <- orders n
    , questions n order > most
    ]
      `shouldBe` []
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

-- Orders in which n slots come in, n being even: by their own order, from one end, from both, and every second one
-- first.
orders :: Int -> [(String, [Int])]
orders n =
  [ ("rising", [0 .. n - 1])
  , ("falling", [n - 1, n - 2 .. 0])
  , ("from both ends", concat [[k, n - 1 - k] | k <- [0 .. n `div` 2 - 1]])
  , ("rising twice", [0, 2 .. n - 1] <> [1, 3 .. n - 1])
  , ("rising, then falling", [0, 2 .. n - 1] <> reverse [1, 3 .. n - 1])
  , ("by halves", [k * odd' `mod` n | k <- [0 .. n - 1]])
  ]
  where
    odd' = n `div` 2 + 1

-- How many questions are asked while slots come in, by their own order.
questions :: Int -> [Int] -> Int
questions bound slots = runST $ do
  asked <- newSTRef 0
  status <- newStatus bound
  forM_ slots $ \s -> do
    (low, high) <- lookupGap status (\t -> modifySTRef' asked (+ 1) >> pure (t < s))
    insertBetween status low high s
  readSTRef asked

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
