{-# LANGUAGE BangPatterns #-}

-- | The horizon trees at the start of the half turn.
module Visibility.Sweep.HorizonTree.Plant
  ( plant
  ) where

import Control.Monad (unless)
import Control.Monad.ST (ST)
import Data.Int (Int32)
import Data.List (sortBy)
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.Predicate
import Visibility.Sorting
import Visibility.Sweep.HorizonTree
import Visibility.Sweep.HorizonTree.Frame
import Visibility.Sweep.HorizonTree.Table
import Visibility.Sweep.Vertical (solid)

-- | The tree at the start of the half turn, in which the sweep can go on, from the 'firstTargets' of its heading.
--
-- /Cost/ O(n log n).
plant :: Frame -> U.Vector Int32 -> ST s (Growing s)
plant f targets = do
  tree <- emptyTable n
  eachCorner $ \p -> do
    let !l = targetFrom p
    put tree (source p) (firstEnd p)
    putList tree (target p) l
    unless (l == noList) $ putNode tree (edge p) (nodeTo p l)
    -- To the sky, which at most one edge leads to: all corners but the last one under it have one ahead.
    unless (l == noList || isCornerList l) $ append tree l (edgeNode p)
  eachCorner $ \q ->
    mapM_ (append tree (cornerList q)) (sortBy (ascending q) (map nodeCoded (bucketOf arriving q)))
  eachCorner (relink f tree)
  pure tree
  where
    n = frameSize f
    -- Lists of all corners would be shared, and kept.
    eachCorner visit = U.forM_ (U.enumFromN 0 n) visit
    targetFrom p
      | t == solid = noList
      | t == n = skyList n
      | otherwise = cornerList t
      where
        t = fromIntegral (targets U.! p)
    -- The node of the tree edge from p to a target.
    nodeTo p l
      | isCornerList l, marker <- markerOf f p (listOwner l), marker /= noNode = marker
      | otherwise = edgeNode p
    firstEnd i = let q = following f i in if comesBefore f i q then i else q
    -- By corner, all nodes in its list: tree edges that are no sides, and the markers of sides. The former are coded by
    -- 2i, the latter by 2i + 1. Those in no corner's list come last.
    arriving = bucketsBy (n + 1) (U.generate (2 * n) (fromIntegral . arrival))
    arrival k
      | even k = let l = targetFrom i in if isCornerList l && nodeTo i l == edgeNode i then listOwner l else n
      -- The two faces of a wall that stands alone have one marker.
      | preceding f i /= q || comesBefore f i q = i + q - firstEnd i
      | otherwise = n
      where
        i = k `quot` 2
        q = following f i
    nodeCoded code = if even code then edgeNode (code `quot` 2) else markerNode (code `quot` 2)
    ascending q a b = case turnIn f q (sourceOf a) (sourceOf b) of
      LeftTurn -> LT
      Collinear -> compare (isLowerFace q a) (isLowerFace q b)
      RightTurn -> GT
    sourceOf e = let i = nodeOwner e in if isEdgeNode e then i else firstEnd i
    -- Of the two faces of one piece of a wall, the upper one comes first.
    isLowerFace q e = following f (sourceOf e) == q
    append tree l node = getNode tree (final l) >>= \e -> insertAfter tree l e node
