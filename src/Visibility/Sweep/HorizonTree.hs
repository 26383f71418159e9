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
-- remaining rays are solid. Where a tree edge is a side, the permanent marker of the side is its node. The two faces
-- of a thin wall share one. A list holds its nodes by ascending slope, that is from the uppermost source to the
-- lowest. Under a ceiling all edges are vertical and the order is that of the sources along the heading.
--
-- Note [Convex chains]
-- ~~~~~~~~~~~~~~~~~~~~
-- A corner t is linked when the last tree edge into t and the tree edge out of t are consecutive edges of a convex
-- chain: the second turns left or goes straight on, and no forward side of t lies below it. A chain is a maximal path
-- of tree edges through linked corners. Its leaf (the edge furthest from the target) and its top point to each other,
-- so that the search for a tangent, which comes to the top first, can begin at the leaf. Equality matters: were
-- collinear corners not linked, aligned scenes would be searched corner by corner, in quadratic time.

-- | Sweeps the tree edges of corners on a line, given from the last one to the first. Before, all of them are made the
-- leaves of their chains; and each once more when it is swept, since of a wall's two faces the first one that is swept
-- may leave its corner linked to the second one.
--
-- /Requires/ the vertex is ready in both trees. /Cost/ O(1) per pair besides the chain steps.
sweepLine :: Frame -> Growing s -> [Int] -> ST s ()
sweepLine f tree line = do
  mapM_ (separate tree) (reverse line)
  forM_ line $ \p -> separate tree p >> advance f tree p

-- | Cuts the chain at a corner, so that the corner's tree edge is a leaf. /Requires/ that its last arrival is one, if
-- the corner is linked: on a line, the corners before it have been separated.
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
  wayPast f tree p q

-- | Goes the way of the reference that p's ray takes when it has turned past q: 'besideSolid', along a side, under a
-- side, along q's tree edge, or under q's ceiling.
wayPast :: Frame -> Growing s -> Int -> Int -> ST s ()
wayPast f tree !p !q
  | following f p == q && preceding f p /= q = besideSolid f tree p q
  | x /= p && turnIn f p q x == LeftTurn =
      if comesBefore f q x
        then getNode tree (earlier (markerOf f q x)) >>= settle f tree p (cornerList x)
        else getNode tree (final (ceilingList x)) >>= underCeiling f tree p (ceilingList x)
  | otherwise = do
      front <- getNode tree (edge q)
      when (front == noNode) $ broken "a ray that passes a corner finds its tree edge" (show (p, q))
      l <- getList tree (target q)
      e <- getNode tree (earlier front)
      if isCornerList l then settle f tree p l e else underCeiling f tree p l e
  where
    !x = preceding f q
{-# INLINE wayPast #-}

-- | Takes the swept edge from p to q out of the tree. It is the leaf of its chain, which is cut where it goes on beyond
-- q.
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
-- forward and is not below; it may be the other face of the same piece of a wall. Else there is none.
besideSolid :: Frame -> Growing s -> Int -> Int -> ST s ()
besideSolid f tree p q =
  when (comesBefore f p r && turnIn f p q r /= RightTurn) $ attach f tree p (cornerList r) noNode
  where
    !r = preceding f p

-- | Back along the underside of a ceiling, where e is the vertical edge just before the place reached so far: to its
-- source, or else to the ceiling's end.
underCeiling :: Frame -> Growing s -> Int -> List -> Node -> ST s ()
underCeiling f tree !p !l !e
  | e == noNode = toItsEnd
  | otherwise = do
      s <- getSource tree e
      if comesBefore f p s then settle f tree p l e else toItsEnd
  where
    !a = listOwner l
    toItsEnd
      | a < frameSize f && comesBefore f p a =
          getNode tree (final (cornerList a)) >>= settle f tree p (cornerList a)
      | otherwise = settle f tree p l e

-- | The node e, just before the front, may hide from p the target l that it aims at. If it does, it is the last edge of
-- a chain: this is gone along from its leaf to the first edge that hides, the corner at which that begins becomes the
-- target of p, and the chain is cut there. If not, l does.
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
      found <- if near == e then pure True else hides f tree p c
      if found
        then do
          justBefore <- getNode tree (final (cornerList c))
          when (near /= deepest) $ cut tree c deepest e
          attach f tree p (cornerList c) justBefore
        else do
          ahead <- getList tree (target c)
          getNode tree (edge (listOwner ahead)) >>= search deepest

-- | Is this node a tree edge that hides its end from p?
hidesAsEdge :: Frame -> Growing s -> Int -> Node -> ST s Bool
hidesAsEdge f tree !p !e = do
  s <- getSource tree e
  own <- getNode tree (edge s)
  if own == e then hides f tree p s else pure False

-- | Does the tree edge from s to t hide t from p? Of an edge that leaves the place of p this is never asked; see Note
-- [Corners in one place] of the reference.
hides :: Frame -> Growing s -> Int -> Int -> ST s Bool
hides f tree !p !s
  | comesBefore f p s = do
      l <- getList tree (target s)
      pure $! not (isCornerList l) || turnIn f s (listOwner l) p /= RightTurn
  | otherwise = pure False
{-# INLINE hides #-}

-- | Makes l the target of p, just after node e in it: by (3) of Note [Next pair] nothing arrives between.
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
  not (isBelow f t ahead (following f t))
    && not (isBelow f t ahead (preceding f t))
    && (not (isCornerList ahead) || turnIn f s t (listOwner ahead) /= RightTurn)

-- | Does the side from t to x lead forward, below the edge from t to its target?
isBelow :: Frame -> Int -> List -> Int -> Bool
isBelow f t ahead x =
  comesBefore f t x && (not (isCornerList ahead) || x /= listOwner ahead && turnIn f t x (listOwner ahead) == LeftTurn)
{-# INLINE isBelow #-}

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
  above <- getNode tree (if e == noNode then first l else later e)
  putNode tree (earlier node) e
  putNode tree (later node) above
  putNode tree (if e == noNode then first l else later e) node
  putNode tree (if above == noNode then final l else earlier above) node

-- | Takes a node out of a list.
unlink :: Growing s -> List -> Node -> ST s ()
unlink tree !l !node = do
  below <- getNode tree (earlier node)
  above <- getNode tree (later node)
  putNode tree (if below == noNode then first l else later below) above
  putNode tree (if above == noNode then final l else earlier above) below
