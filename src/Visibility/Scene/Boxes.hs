{-# LANGUAGE BangPatterns #-}

-- | A tree of boxes that does not change once it is made: it tells which boxes have a property.
module Visibility.Scene.Boxes
  ( -- * Boxes
    Box (..)
  , boxesOverlap
  , boxSurrounds
  , enclosingBox
    -- * The tree
  , BoxTree
  , boxTree
    -- * Queries
  , foldBoxes
  , foldNearer
  ) where

import Control.Monad.ST (ST, runST)
import Data.Ord (comparing)
import qualified Data.Vector.Algorithms.Intro as Intro
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M

-- | A closed axis-parallel box: from left to right, from bottom to top. It may be a segment or a point.
data Box = Box {boxLeft :: !Int, boxRight :: !Int, boxBottom :: !Int, boxTop :: !Int}
  deriving (Eq, Show)

-- | Do two closed boxes share a point?
boxesOverlap :: Box -> Box -> Bool
boxesOverlap (Box l r b t) (Box l' r' b' t') = l <= r' && l' <= r && b <= t' && b' <= t
{-# INLINE boxesOverlap #-}

-- | Is every point of the second box strictly inside of the first one?
boxSurrounds :: Box -> Box -> Bool
boxSurrounds (Box l r b t) (Box l' r' b' t') = l < l' && r' < r && b < b' && t' < t
{-# INLINE boxSurrounds #-}

-- | The smallest box around others; around none, a box that overlaps nothing finite.
enclosingBox :: [Box] -> Box
enclosingBox = foldr join nowhere

nowhere :: Box
nowhere = Box maxBound minBound maxBound minBound

join :: Box -> Box -> Box
join (Box l r b t) (Box l' r' b' t') = Box (min l l') (max r r') (min b b') (max t t')

-- | Boxes by index, in a tree of groups that are near to each other.
--
-- The indices are in such an order that each group is a slice; then come the boxes in that order.
data BoxTree = BoxTree !(U.Vector Int) !(U.Vector (Int, Int, Int, Int)) !Group

-- | A slice, from the first place to just before the last, or two groups; with the box around it all.
data Group = Slice !Box !Int !Int | Halves !Box !Group !Group

groupBox :: Group -> Box
groupBox (Slice box _ _) = box
groupBox (Halves box _ _) = box

-- | Groups are halved at the median centre, across the direction in which the centres extend farther.
--
-- /Cost/ O(n log n).
boxTree :: [Box] -> BoxTree
boxTree boxes = runST $ do
  order <- U.thaw (U.enumFromN 0 (U.length table))
  root <- grow table order 0 (U.length table)
  final <- U.unsafeFreeze order
  pure (BoxTree final (U.backpermute table final) root)
  where
    table = U.fromList [(l, r, b, t) | Box l r b t <- boxes]

grow :: U.Vector (Int, Int, Int, Int) -> M.MVector s Int -> Int -> Int -> ST s Group
grow table order from to = do
  members <- U.freeze (M.slice from (to - from) order)
  let around = U.foldl' (\box i -> join box (at table i)) nowhere members
      spread centre =
        let (low, high) = U.foldl' (\(!a, !b) i -> let !c = centre i in (min a c, max b c)) (maxBound, minBound) members
         in high - low
      middle = (from + to) `div` 2
      split centre = Intro.selectByBounds (comparing (\i -> (centre i, i))) order (middle - from) from to
  if to - from <= sliceSize
    then pure (Slice around from to)
    else do
      if spread acrossX >= spread acrossY then split acrossX else split acrossY
      Halves around <$> grow table order from middle <*> grow table order middle to
  where
    acrossX i = let Box l r _ _ = at table i in l + r
    acrossY i = let Box _ _ b t = at table i in b + t

-- Groups of up to so many boxes are not halved.
sliceSize :: Int
sliceSize = 8

at :: U.Vector (Int, Int, Int, Int) -> Int -> Box
at table i = let (l, r, b, t) = table U.! i in Box l r b t
{-# INLINE at #-}

-- | Combines all boxes with a property, in no promised order.
--
-- /Requires/ a property that a larger box has if a smaller one in it has it, such as holding a given box.
--
-- /Cost/ O(log n + k) for k boxes in a good case, O(n) at worst.
foldBoxes :: (Box -> Bool) -> (a -> Int -> a) -> a -> BoxTree -> a
foldBoxes has = foldNearer (\_ _ -> True) (const has)
{-# INLINE foldBoxes #-}

-- | The same, where the property may depend on what has been combined, and of two groups that goes first whose box is
-- told to be the nearer one.
--
-- /Requires/ that a box which has not got the property does not get it later.
foldNearer :: (Box -> Box -> Bool) -> (a -> Box -> Bool) -> (a -> Int -> a) -> a -> BoxTree -> a
foldNearer isNearer has combine start (BoxTree order table root) = go start root
  where
    go !acc group
      | not (has acc (groupBox group)) = acc
      | otherwise = case group of
          Halves _ a b
            | isNearer (groupBox a) (groupBox b) -> go (go acc a) b
            | otherwise -> go (go acc b) a
          Slice _ from to -> members acc from to
    members !acc i to
      | i >= to = acc
      | has acc (at table i) = members (combine acc (order U.! i)) (i + 1) to
      | otherwise = members acc (i + 1) to
{-# INLINE foldNearer #-}
