{-# LANGUAGE BangPatterns #-}

-- | The status of a plane sweep: numbers in an order that is known only to the one who asks, with the neighbours of
-- each at hand.
module Visibility.Scene.Status
  ( Status
  , newStatus
  , Slot
  , noSlot
    -- * Looking
  , below
  , above
  , lookupGap
    -- * Changing
  , insertBetween
  , remove
  ) where

import Control.Monad (when)
import Control.Monad.ST (ST)
import Data.Int (Int32)
import qualified Data.Vector.Unboxed.Mutable as M

-- | Some of the numbers from 0 to below a bound, called slots, in an order: a splay tree, and a list that is linked
-- both ways.
--
-- Of slot s, from 5s on: the roots of its subtrees below and above it, its parent, the slots just below and just above
-- it. Then the root.
newtype Status s = Status (M.MVector s Int32)

data Link = LowerTree | UpperTree | Parent | Below | Above

-- | The number of a slot, or 'noSlot'.
type Slot = Int

-- | In the place of a slot.
noSlot :: Slot
noSlot = -1

-- | Without any slot in it, for slots below a bound.
newStatus :: Int -> ST s (Status s)
newStatus bound = Status <$> M.replicate (5 * bound + 1) (fromIntegral noSlot)

at :: Link -> Int -> Int
at link s = case link of
  LowerTree -> 5 * s
  UpperTree -> 5 * s + 1
  Parent -> 5 * s + 2
  Below -> 5 * s + 3
  Above -> 5 * s + 4
{-# INLINE at #-}

get :: Status s -> Link -> Int -> ST s Int
get (Status table) link s = fromIntegral <$> M.read table (at link s)
{-# INLINE get #-}

-- Nothing is written of no slot.
set :: Status s -> Link -> Int -> Int -> ST s ()
set (Status table) link s value = when (s /= noSlot) $ M.write table (at link s) (fromIntegral value)
{-# INLINE set #-}

getRoot :: Status s -> ST s Int
getRoot (Status table) = fromIntegral <$> M.read table (M.length table - 1)
{-# INLINE getRoot #-}

setRoot :: Status s -> Int -> ST s ()
setRoot (Status table) s = M.write table (M.length table - 1) (fromIntegral s)
{-# INLINE setRoot #-}

-- | The slot just below one that is in the status, or 'noSlot'. /Cost/ O(1).
below :: Status s -> Int -> ST s Int
below status = get status Below
{-# INLINE below #-}

-- | The slot just above one that is in the status, or 'noSlot'. /Cost/ O(1).
above :: Status s -> Int -> ST s Int
above status = get status Above
{-# INLINE above #-}

-- | The last slot with a property, and the first without it, or 'noSlot'.
--
-- /Requires/ a property that a lower slot has if a higher one has it. /Cost/ O(log n) questions on average over a row
-- of searches and changes, if 'insertBetween' follows each.
lookupGap :: Status s -> (Int -> ST s Bool) -> ST s (Int, Int)
lookupGap status has = getRoot status >>= go noSlot noSlot
  where
    go !low !high s
      | s == noSlot = pure (low, high)
      | otherwise = do
          passed <- has s
          if passed then get status UpperTree s >>= go s high else get status LowerTree s >>= go low s
{-# INLINE lookupGap #-}

-- | Puts a slot between two that follow each other, or 'noSlot' at the ends.
--
-- /Requires/ a slot that is not in the status. /Cost/ O(log n) on average, see 'lookupGap'.
insertBetween :: Status s -> Int -> Int -> Int -> ST s ()
insertBetween status low high s = do
  set status LowerTree s noSlot
  set status UpperTree s noSlot
  set status Below s low
  set status Above s high
  set status Above low s
  set status Below high s
  -- One of two that follow each other has no subtree on the side of the other.
  isFree <- if low == noSlot then pure False else (== noSlot) <$> get status UpperTree low
  if isFree
    then set status UpperTree low s >> set status Parent s low
    else set status LowerTree high s >> set status Parent s high
  splay status s
  setRoot status s

-- | Takes a slot out, and gives the two that then follow each other.
--
-- /Requires/ one that is in the status. /Cost/ O(log n) on average, see 'lookupGap'.
remove :: Status s -> Int -> ST s (Int, Int)
remove status s = do
  splay status s
  lower <- get status LowerTree s
  upper <- get status UpperTree s
  low <- get status Below s
  high <- get status Above s
  set status Above low high
  set status Below high low
  set status Parent lower noSlot
  set status Parent upper noSlot
  if lower == noSlot
    then setRoot status upper
    else do
      -- Now the greatest one of them has nothing above it.
      splay status low
      set status UpperTree low upper
      set status Parent upper low
      setRoot status low
  pure (low, high)

-- Turns a tree until a slot of it is its root. Sleator and Tarjan, Self-adjusting binary search trees, 1985.
splay :: Status s -> Int -> ST s ()
splay status s = go
  where
    go = do
      p <- get status Parent s
      when (p /= noSlot) $ do
        g <- get status Parent p
        if g == noSlot
          then lift status s p
          else do
            alike <- (==) <$> isLower p s <*> isLower g p
            if alike then lift status p g >> lift status s p else lift status s p >> lift status s g
            go
    isLower p q = (== q) <$> get status LowerTree p

-- Exchanges a slot with its parent.
lift :: Status s -> Int -> Int -> ST s ()
lift status s p = do
  g <- get status Parent p
  isLower <- (== s) <$> get status LowerTree p
  if isLower
    then do
      middle <- get status UpperTree s
      set status LowerTree p middle
      set status Parent middle p
      set status UpperTree s p
    else do
      middle <- get status LowerTree s
      set status UpperTree p middle
      set status Parent middle p
      set status LowerTree s p
  set status Parent p s
  set status Parent s g
  when (g /= noSlot) $ do
    wasLower <- (== p) <$> get status LowerTree g
    set status (if wasLower then LowerTree else UpperTree) g s
