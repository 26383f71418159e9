{-# LANGUAGE BangPatterns #-}

-- | The horizon trees at the start of the half turn.
module Visibility.Sweep.HorizonTree.Plant
  ( plant
  ) where

import Control.Monad (forM_, unless, when)
import Control.Monad.ST (ST)
import Data.Int (Int32)
import qualified Data.Vector.Algorithms.Intro as Intro
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.Predicate
import Visibility.Sweep.HorizonTree
import Visibility.Sweep.HorizonTree.Frame
import Visibility.Sweep.HorizonTree.Table
import Visibility.Sweep.Vertical

-- | The tree at the start of the half turn, in which the sweep can go on, from the 'firstTargets' of its heading.
--
-- /Cost/ O(n log n).
plant :: Frame -> Heading -> U.Vector Int32 -> ST s (Growing s)
plant f heading targets = do
  tree <- emptyTable n
  -- Edges to a ceiling come in the order of the heading, those to a corner by slope.
  eachCorner $ \p -> do
    let !l = targetFrom p
        !marker = if isCornerList l then markerOf f p (listOwner l) else noNode
    put tree (source p) (firstEnd p)
    putList tree (target p) l
    unless (l == noList) $ putNode tree (edge p) (if marker == noNode then edgeNode p else marker)
    unless (l == noList || isCornerList l) $ append tree l (edgeNode p)
  ends <- M.replicate (n + 1) (0 :: Int)
  eachInCorner tree $ \q _ -> M.unsafeModify ends (+ 1) (q + 1)
  forM_ [1 .. n] $ \q -> M.unsafeRead ends (q - 1) >>= \k -> M.unsafeModify ends (+ k) q
  total <- M.unsafeRead ends n
  nodes <- M.new total
  eachInCorner tree $ \q (Node e) -> do
    k <- M.unsafeRead ends q
    M.unsafeWrite nodes k e
    M.unsafeWrite ends q (k + 1)
  -- Now the nodes of q end at its entry, and begin at that of q − 1.
  forM_ [0 .. n - 1] $ \q -> do
    from <- if q == 0 then pure 0 else M.unsafeRead ends (q - 1)
    to <- M.unsafeRead ends q
    when (to - from > 1) $ Intro.sortByBounds (ascending q) nodes from to
    forM_ [from .. to - 1] $ \k -> M.unsafeRead nodes k >>= append tree (cornerList q) . Node
  eachCorner (relink f tree)
  pure tree
  where
    n = frameSize f
    eachCorner visit = case heading of
      Rightward -> forM_ [0 .. n - 1] visit
      Leftward -> forM_ [0 .. n - 1] (\k -> visit (n - 1 - k))
    targetFrom p
      | t == solid = noList
      | t == n = skyList n
      | otherwise = cornerList t
      where
        t = fromIntegral (targets U.! p)
    firstEnd i = let q = following f i in if comesBefore f i q then i else q
    -- All nodes in the lists of corners: tree edges, and the markers of sides.
    eachInCorner tree visit = forM_ [0 .. n - 1] $ \i -> do
      l <- getList tree (target i)
      own <- getNode tree (edge i)
      when (isCornerList l && own == edgeNode i) $ visit (listOwner l) own
      -- The two faces of a wall that stands alone have one marker.
      let q = following f i
      when (preceding f i /= q || comesBefore f i q) $ visit (i + q - firstEnd i) (markerNode i)
    ascending q a b = case turnIn f q (sourceOf a) (sourceOf b) of
      LeftTurn -> LT
      Collinear -> compare (isLowerFace q a) (isLowerFace q b)
      RightTurn -> GT
    sourceOf e = let i = nodeOwner (Node e) in if isEdgeNode (Node e) then i else firstEnd i
    -- Of the two faces of one piece of a wall, the upper one comes first.
    isLowerFace q e = following f (sourceOf e) == q
    append tree l node = getNode tree (final l) >>= \e -> insertAfter tree l e node
