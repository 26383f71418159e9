{-# LANGUAGE BangPatterns #-}

-- | A horizon tree: for every corner, the least-slope elementary pair not yet swept that leaves it forward.
--
-- There is one implementation. Seen 'Rightward' it is the tree of the pairs that leave a corner to the right; seen
-- 'Leftward' the scene is turned by 180° and it is the tree of those that leave to the left.
--
-- /Source/ Rivière, Topologically sweeping the visibility complex of polygonal scenes (upper and lower horizon trees,
-- convex chains with double pointers); Overmars and Welzl (rotation trees). The scan from both ends, the sky as a
-- target and the treatment of collinear corners are this project's.
module Visibility.Sweep.HorizonTree
  ( -- * The tree
    Target (..)
  , targetOf
  , chainSteps
    -- * One step
  , advance
  , sweepLine
    -- * To plant it
  , relink
  , insertAfter
    -- * For checks
  , linkable
  ) where

import Control.Monad (forM_, unless, when)
import Control.Monad.ST (ST)
import Data.Int (Int32)
import Data.Primitive.PrimArray (MutablePrimArray, readPrimArray)
import Visibility.Exact.Predicate
import Visibility.Law (broken)
import Visibility.Scene
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
-- of linked edges. Its leaf (the edge furthest from the target) points to its top and its top to its leaf, so that a
-- tangent to it can be searched from both ends. Equality matters: were collinear corners not linked, aligned scenes
-- would be scanned corner by corner, in quadratic time.

-- | What a tree edge leads to.
data Target
  = -- | The far end of an elementary pair.
    ToCorner !CornerId
  | -- | All forward pairs are swept; the rays meet this side from below until they are vertical.
    ToCeiling !SideId
  | -- | All forward pairs are swept; the rays meet the sky until they are vertical.
    ToSky
  | -- | The remaining forward rays are solid.
    NoTarget
  deriving (Eq, Ord, Show)

-- | The target of a corner's tree edge.
targetOf :: Scene -> Table -> CornerId -> Target
targetOf scene table (CornerId p)
  | l == noList = NoTarget
  | isCornerList l = ToCorner (CornerId (listOwner l))
  | l == skyList (cornerCount scene) = ToSky
  | otherwise = ToCeiling (SideId (listOwner l))
  where
    l = listAt table (target p)

-- | How many edges of convex chains have been looked at since the start.
chainSteps :: Scene -> Table -> Int
chainSteps scene table = at table (counter (cornerCount scene))

-- | Sweeps one vertex of more than two corners: so many pairs, the k-th of them from its source to its target in the
-- order of the heading as given, each pair being the tree edge of its source, or the next one after that along a wall's
-- other face. The sources stand in a table, the first at the given place, each at so many places from the one before.
--
-- /Requires/ the vertex is ready in both trees. /Cost/ O(1) per pair besides the chain steps, which are counted.
sweepLine :: Frame -> Growing s -> MutablePrimArray s Int32 -> Int -> Int -> Int -> ST s ()
sweepLine f tree table !size !begin !stride = do
  forM_ [1 .. size - 1] separate
  advanceFrom (size - 1)
  where
    sourceOf k = fromIntegral <$> readPrimArray table (begin + k * stride)
    -- Makes the last edge into the source of a pair the leaf of its chain, as every edge of the line must be.
    separate k = do
      q <- sourceOf k
      isLinked <- get tree (link q)
      when (isLinked == 1) $ do
        e <- getNode tree (final (cornerList q))
        highest <- getNode tree (top e)
        cut tree q e highest
    -- All pairs, the furthest first. When the first of a wall's two faces has been swept, its corner may have been
    -- linked to the second one.
    advanceFrom k
      | k < 0 = pure ()
      | otherwise = do
          when (k > 0 && k < size - 1) $ separate k
          sourceOf k >>= advance f tree
          advanceFrom (k - 1)

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

-- | Follows the convex chains that hide the target l from p, where e is the last edge into l below p's ray; makes the
-- corner at which the tangent from p touches the last of them the target, or l if nothing hides it. Each chain is
-- searched from both of its ends by turns, so the cost is at most twice the distance to the nearer one.
settle :: Frame -> Growing s -> Int -> List -> Node -> ST s ()
settle f tree !p !l !e = do
  countStep f tree
  hidden <- if e == noNode then pure False else hidesAsEdge f tree p e
  if hidden
    then do
      deepest <- getNode tree (leaf e)
      alongChain f tree p e deepest deepest e
    else attach f tree p l e

-- Note [Jumps]
-- ~~~~~~~~~~~~
-- 'alongChain' and 'touching' go on by calling each other last. Were the corner that is touched a result instead, it
-- would be a boxed number, allocated for every chain.

-- | Searches the chain with this top and leaf for the corner where the tangent from p touches it. The far end goes down
-- from the top, the near end up from the leaf; hiding is monotone along the chain. The last two nodes are the ends
-- reached.
alongChain :: Frame -> Growing s -> Int -> Node -> Node -> Node -> Node -> ST s ()
alongChain f tree !p !highest !deepest !near !e = do
  countStep f tree
  !t <- getSource tree e
  isLinked <- get tree (link t)
  if isLinked == 0
    then touching f tree p highest deepest t
    else do
      e' <- getNode tree (final (cornerList t))
      far <- hides f tree p e'
      if not far
        then touching f tree p highest deepest t
        else do
          found <- if near == e' then pure True else hides f tree p near
          !s <- getSource tree near
          if found
            then touching f tree p highest deepest s
            else do
              l <- getList tree (target s)
              near' <- getNode tree (edge (listOwner l))
              alongChain f tree p highest deepest near' e'

-- | The tangent from p touches the chain with this top and leaf at t: that is p's target, unless another chain, which
-- ends at t, hides it.
touching :: Frame -> Growing s -> Int -> Node -> Node -> Int -> ST s ()
touching f tree !p !highest !deepest !t = do
  e <- getNode tree (final (cornerList t))
  isLinked <- get tree (link t)
  if isLinked == 1
    then do
      cut tree t deepest highest
      attach f tree p (cornerList t) e
    else do
      countStep f tree
      hidden <- if e == noNode then pure False else hidesAsEdge f tree p e
      if hidden
        then do
          deepest' <- getNode tree (leaf e)
          alongChain f tree p e deepest' deepest' e
        else attach f tree p (cornerList t) e

-- | Is this node a tree edge that hides its end from p?
hidesAsEdge :: Frame -> Growing s -> Int -> Node -> ST s Bool
hidesAsEdge f tree !p !e = do
  s <- getSource tree e
  own <- getNode tree (edge s)
  if own == e then hidesFrom f tree p s else pure False

-- | Does this tree edge hide its end from p?
hides :: Frame -> Growing s -> Int -> Node -> ST s Bool
hides f tree !p !e = getSource tree e >>= hidesFrom f tree p
{-# INLINE hides #-}

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

countStep :: Frame -> Growing s -> ST s ()
countStep f tree = get tree (counter (frameSize f)) >>= put tree (counter (frameSize f)) . (+ 1)
{-# INLINE countStep #-}

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

-- | What 'link' must say of t.
linkable :: Frame -> Table -> Int -> Bool
linkable f table t =
  e /= noNode
    && nodeAt table (edge t) /= noNode
    && nodeAt table (edge (sourceAt table e)) == e
    && continues f (sourceAt table e) t (listAt table (target t))
  where
    e = nodeAt table (final (cornerList t))

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
