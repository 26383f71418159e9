{-# LANGUAGE BangPatterns #-}

-- | A horizon tree, fast: for every corner, the elementary pair of least slope that leaves it forward and has not been
-- swept. "Visibility.Sweep.Reference.Tree" is the same tree as a text, and says why it is right.
--
-- There is one implementation. Seen 'Rightward' it is the tree of the pairs that leave a corner to the right. Seen
-- 'Leftward' the scene is turned by 180°, and it is the tree of those that leave to the left.
--
-- /Source/ Rivière, Topologically sweeping the visibility complex of polygonal scenes (upper and lower horizon trees,
-- convex chains with double pointers); Overmars and Welzl (rotation trees). The sky as a target and the treatment of
-- collinear corners are this project's.
module Visibility.Sweep.HorizonTree
  ( -- * To sweep pairs
    advance
  , sweepLine
    -- * To plant a tree
  , relink
  , insertAfter
  ) where

import Control.Monad (forM_, unless, when)
import Control.Monad.ST (ST)
import Visibility.Exact.Predicate
import Visibility.Law (broken)
import Visibility.Sweep.HorizonTree.Frame
import Visibility.Sweep.HorizonTree.Table

-- Note [Lists]
-- ~~~~~~~~~~~~
-- The target of a corner is a list: of the corner at the far end of its next pair; or of a ceiling, when all its
-- forward pairs are swept and its rays meet that side, or the sky, until they are vertical; or none, where the
-- remaining rays are solid. Where a tree edge is a side, the permanent marker of the side is its node. The two faces of
-- a thin wall share one. A list holds its nodes by ascending slope, that is from the uppermost source to the lowest.
-- Under a ceiling all edges are vertical and the order is that of the sources along the heading.
--
-- Note [Convex chains]
-- ~~~~~~~~~~~~~~~~~~~~
-- A corner t is linked when the last tree edge into t and the tree edge out of t are consecutive edges of a convex
-- chain: the second turns left or goes straight on, and no forward side of t lies below it. A chain is a maximal path
-- of linked edges. Its leaf (the edge furthest from the target) and its top point to each other, so that the search for
-- a tangent, which comes to the top first, can begin at the leaf. Equality matters: were collinear corners not linked,
-- aligned scenes would be searched corner by corner, in quadratic time.

-- | Sweeps the tree edges of corners on a line, given from the last one to the first. Before, all of them are made the
-- leaves of their chains; and each once more when it is swept, since of a wall's two faces the first one that is swept
-- may leave its corner linked to the second one.
--
-- /Requires/ the vertex is ready in both trees. /Cost/ O(1) per pair besides the chain steps.
sweepLine :: Frame -> Growing s -> [Int] -> ST s ()
sweepLine f tree line = do
  mapM_ (separate tree) (reverse line)
  forM_ line $ \p -> separate tree p >> advance f tree p

-- | Makes the tree edge of a corner the leaf of its chain. /Requires/ that so is what arrives there last.
separate :: Growing s -> Int -> ST s ()
separate tree !p = do
  isLinked <- get tree (link p)
  when (isLinked == 1) $ do
    e <- getNode tree (final (cornerList p))
    highest <- getNode tree (top e)
    cut tree p e highest

-- | The tree edge of p, which leads to a corner, has been swept: find the next one.
advance :: Frame -> Growing s -> Int -> ST s ()
advance f tree !p = do
  into <- getList tree (target p)
  let !q = listOwner into
  swept <- getNode tree (edge p)
  release f tree p q swept
  let !x = preceding f q
  if following f p == q && preceding f p /= q
    then besideSolid f tree p q
    else
      if x /= p && turnIn f p q x == LeftTurn
        then -- The ray turns into the side between x and q.

          if comesBefore f q x
            then getNode tree (lower (markerOf f q x)) >>= settle f tree p (cornerList x)
            else getNode tree (final (ceilingList x)) >>= underCeiling f tree p (ceilingList x)
        else do
          -- The ray passes above q and slides along what q's own next ray meets.
          stop <- getNode tree (edge q)
          when (stop == noNode) $ broken "a ray that passes a corner finds its tree edge" (show (p, q))
          l <- getList tree (target q)
          e <- getNode tree (lower stop)
          if isCornerList l then settle f tree p l e else underCeiling f tree p l e

-- | Takes the swept edge from p to q out of the tree. It is the leaf of its chain; where it is also linked to the edge
-- out of q, that chain is cut first.
release :: Frame -> Growing s -> Int -> Int -> Node -> ST s ()
release f tree !p !q !swept = do
  isLinked <- get tree (link q)
  end <- getNode tree (final (cornerList q))
  when (isLinked == 1 && end == swept) $ getNode tree (top swept) >>= cut tree q swept
  putNode tree (top swept) swept
  putNode tree (leaf swept) swept
  putNode tree (edge p) noNode
  putList tree (target p) noList
  when (isEdgeNode swept) $ unlink tree (cornerList q) swept
  stillLinked <- get tree (link q)
  when (stillLinked == 0) $ relink f tree q

-- | The swept pair is a side with its solid just above: the next free ray is along the other side of p, if that leads
-- forward and lies above, or is the upper face of the same piece of a wall; else there is none.
besideSolid :: Frame -> Growing s -> Int -> Int -> ST s ()
besideSolid f tree p q =
  when (comesBefore f p r && turnIn f p q r /= RightTurn) $ attach f tree p (cornerList r) noNode
  where
    !r = preceding f p

-- | On the underside of a ceiling, e is the nearest vertical edge to the left of the place reached so far.
underCeiling :: Frame -> Growing s -> Int -> List -> Node -> ST s ()
underCeiling f tree !p !l !e
  | e == noNode = beyondEdges
  | otherwise = do
      s <- getSource tree e
      if comesBefore f p s && not (sharePlace f p s) then settle f tree p l e else beyondEdges
  where
    !a = listOwner l
    beyondEdges
      | a < frameSize f
      , comesBefore f p a
      , not (sharePlace f p a) =
          getNode tree (final (cornerList a)) >>= settle f tree p (cornerList a)
      | otherwise = settle f tree p l e

-- | Follows the tangent from p to the chain whose last edge is e, the last edge into the target l below p's ray, where
-- that hides l: the corner at which the tangent touches the chain becomes the target of p. Where nothing hides l, that
-- does. The chain is searched from its leaf on.
settle :: Frame -> Growing s -> Int -> List -> Node -> ST s ()
settle f tree !p !l !e = do
  hidden <- if e == noNode then pure False else hidesAsEdge f tree p e
  if hidden
    then do
      deepest <- getNode tree (leaf e)
      search deepest deepest
    else attach f tree p l e
  where
    search !deepest !near = do
      !c <- getSource tree near
      found <- if near == e then pure True else hidesFrom f tree p c
      if found
        then do
          below <- getNode tree (final (cornerList c))
          when (near /= deepest) $ cut tree c deepest e
          attach f tree p (cornerList c) below
        else do
          ahead <- getList tree (target c)
          getNode tree (edge (listOwner ahead)) >>= search deepest

-- | Is this node a tree edge that hides its end from p?
hidesAsEdge :: Frame -> Growing s -> Int -> Node -> ST s Bool
hidesAsEdge f tree !p !e = do
  s <- getSource tree e
  own <- getNode tree (edge s)
  if own == e then hidesFrom f tree p s else pure False

-- | Does the tree edge from s to t hide t from p? One from the place of p never does: it lies in another cone of free
-- space there.
hidesFrom :: Frame -> Growing s -> Int -> Int -> ST s Bool
hidesFrom f tree !p !s
  | comesBefore f p s = do
      l <- getList tree (target s)
      pure $!
        if isCornerList l
          then case turnIn f s (listOwner l) p of
            LeftTurn -> True
            RightTurn -> False
            Collinear -> not (sharePlace f p s)
          else not (sharePlace f p s)
  | otherwise = pure False
{-# INLINE hidesFrom #-}

-- | Makes l the target of p, just after node e in it.
attach :: Frame -> Growing s -> Int -> List -> Node -> ST s ()
attach f tree !p !l !e = do
  putList tree (target p) l
  when (marker == noNode) $ insertAfter tree l e node
  putNode tree (top node) node
  putNode tree (leaf node) node
  putNode tree (edge p) node
  when (isCornerList l) $ do
    isLinked <- get tree (link t)
    when (isLinked == 0) $ relink f tree t
  relink f tree p
  where
    !t = listOwner l
    !marker = if isCornerList l then markerOf f p t else noNode
    !node = if marker == noNode then edgeNode p else marker

-- | Links t if its edges allow it; t is not linked. See Note [Convex chains].
relink :: Frame -> Growing s -> Int -> ST s ()
relink f tree !t = do
  e <- getNode tree (final (cornerList t))
  g <- getNode tree (edge t)
  unless (e == noNode || g == noNode) $ do
    !s <- getSource tree e
    own <- getNode tree (edge s)
    ahead <- getList tree (target t)
    when (own == e && continues f s t ahead) $ do
      deepest <- getNode tree (leaf e)
      highest <- getNode tree (top g)
      putNode tree (top deepest) highest
      putNode tree (leaf highest) deepest
      put tree (link t) 1

-- | Do the edge from s into t and the edge from t to its target bound a common empty region from below?
continues :: Frame -> Int -> Int -> List -> Bool
continues f !s !t !ahead =
  not (separates f t ahead (following f t))
    && not (separates f t ahead (preceding f t))
    && (not (isCornerList ahead) || turnIn f s t (listOwner ahead) /= RightTurn)

-- | Is the side from t to x a swept forward side below the edge from t to its target?
separates :: Frame -> Int -> List -> Int -> Bool
separates f t ahead x =
  comesBefore f t x && (not (isCornerList ahead) || x /= listOwner ahead && turnIn f t x (listOwner ahead) == LeftTurn)
{-# INLINE separates #-}

-- | Splits the chain with this leaf and top at the linked corner t.
cut :: Growing s -> Int -> Node -> Node -> ST s ()
cut tree !t !deepest !highest = do
  e <- getNode tree (final (cornerList t))
  g <- getNode tree (edge t)
  putNode tree (leaf e) deepest
  putNode tree (top deepest) e
  putNode tree (top g) highest
  putNode tree (leaf highest) g
  put tree (link t) 0

-- | Puts a node into a list after the node e, or in front for 'noNode'.
insertAfter :: Growing s -> List -> Node -> Node -> ST s ()
insertAfter tree !l !e !node = do
  above <- getNode tree (if e == noNode then first l else upper e)
  putNode tree (lower node) e
  putNode tree (upper node) above
  putNode tree (if e == noNode then first l else upper e) node
  putNode tree (if above == noNode then final l else lower above) node

-- | Takes a node out of a list.
unlink :: Growing s -> List -> Node -> ST s ()
unlink tree !l !node = do
  below <- getNode tree (lower node)
  above <- getNode tree (upper node)
  putNode tree (if below == noNode then first l else upper below) above
  putNode tree (if above == noNode then final l else lower above) below
