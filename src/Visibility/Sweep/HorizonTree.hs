{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DeriveTraversable #-}

-- | A horizon tree: for every corner, the least-slope elementary pair not yet swept that leaves it forward.
--
-- There is one implementation. Seen 'Rightward' it is the tree of the pairs that leave a corner to the right; seen
-- 'Leftward' the scene is turned by 180° and it is the tree of those that leave to the left.
--
-- /Source/ Rivière, Topologically sweeping the visibility complex of polygonal scenes (upper and lower horizon trees, convex
-- chains with double pointers); Overmars and Welzl (rotation trees). The scan from both ends, the sky as a target and the
-- treatment of collinear corners are this project's.
module Visibility.Sweep.HorizonTree
  ( -- * The tree
    Tree (..)
  , plant
    -- * Reading it
  , Target (..)
  , targetOf
  , chainSteps
    -- * One step
  , sweepLine
    -- * Inside
  , Frame (..)
  , frame
  , nodeSource
  , markerOf
  , isTreeEdge
  , linkable
  , none
  ) where

import Control.Monad (forM_, unless, when)
import Control.Monad.ST (ST, runST)
import Data.List (sortBy)
import qualified Data.Map.Strict as Map
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Law (broken)
import Visibility.Exact.Point (Points)
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Sweep.Vertical

-- Note [Numbers in the tables]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~~~~
-- n corners. A /target/ is a corner t as t, the underside of side s as n + s, the sky as 2n, and 'none' where the forward
-- rays of the corner are solid. Each target but 'none' has a list of incoming nodes.
-- A /node/ is the tree edge of corner p as p, or the permanent marker of the side that starts at corner i as n + i. Where
-- a tree edge is a side, the marker is its node. The two faces of a thin wall share one marker.
-- A list holds its nodes by ascending slope, that is from the uppermost source to the lowest. Under a ceiling all edges
-- are vertical and the order is that of the sources along the heading.
--
-- Note [Convex chains]
-- ~~~~~~~~~~~~~~~~~~~~
-- A corner t is linked when the last tree edge into t and the tree edge out of t are consecutive edges of a convex chain:
-- the second turns left or goes straight on, and no forward side of t lies below it. A chain is a maximal path of linked
-- edges. Its leaf (the edge furthest from the target) points to its top and its top to its leaf, so that a tangent to
-- it can be searched from both ends. Equality matters: were collinear corners not linked, aligned scenes would be scanned
-- corner by corner, in quadratic time.

-- | The tables of a tree, immutable between steps, mutable within one.
data Tree v = Tree
  { targets :: !v
  -- ^ By corner.
  , nodes :: !v
  -- ^ By corner: the node of its tree edge, or 'none'.
  , links :: !v
  -- ^ By corner: 1 where linked.
  , firstIn :: !v
  -- ^ By target: the first node of its list.
  , lastIn :: !v
  -- ^ By target: the last node of its list.
  , lowerNode :: !v
  -- ^ By node: the one before it in its list, of lesser slope.
  , upperNode :: !v
  -- ^ By node: the one after it.
  , tops :: !v
  -- ^ By node, valid at a leaf: the top of its chain.
  , leaves :: !v
  -- ^ By node, valid at a top: the leaf of its chain.
  , counter :: !v
  -- ^ One number: chain steps so far.
  }
  deriving (Eq, Show, Functor, Foldable, Traversable)

-- | No node, no target.
none :: Int
none = -1

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
targetOf :: Scene -> Tree (U.Vector Int) -> CornerId -> Target
targetOf scene tree (CornerId p)
  | t == none = NoTarget
  | t < n = ToCorner (CornerId t)
  | t < 2 * n = ToCeiling (SideId (t - n))
  | otherwise = ToSky
  where
    t = targets tree U.! p
    n = cornerCount scene

-- | How many edges of convex chains have been looked at since the start.
chainSteps :: Tree (U.Vector Int) -> Int
chainSteps tree = counter tree U.! 0

-- | A scene as a heading sees it, with what the steps need at hand.
data Frame = Frame
  { frameHeading :: !Heading
  , frameSize :: !Int
  , framePoints :: !Points
  , frameScene :: !Scene
  }

frame :: Scene -> Heading -> Frame
frame scene heading = Frame heading (cornerCount scene) (scenePoints scene) scene

following, preceding :: Frame -> Int -> Int
following f p = let CornerId q = nextCorner (frameScene f) (CornerId p) in q
preceding f p = let CornerId q = previousCorner (frameScene f) (CornerId p) in q
{-# INLINE following #-}
{-# INLINE preceding #-}

comesBefore :: Frame -> Int -> Int -> Bool
comesBefore = before . frameHeading
{-# INLINE comesBefore #-}

-- | The corner that a node comes from.
nodeSource :: Frame -> Int -> Int
nodeSource f node
  | node < frameSize f = node
  | comesBefore f i j = i
  | otherwise = j
  where
    i = node - frameSize f
    j = following f i
{-# INLINE nodeSource #-}

-- | The marker of the side from s to t, s before t, or 'none' where they are not joined by a side.
markerOf :: Frame -> Int -> Int -> Int
markerOf f s t
  | following f s == t = frameSize f + s
  | preceding f s == t = frameSize f + t
  | otherwise = none
{-# INLINE markerOf #-}

-- | Is this node of a list the tree edge of its source? Markers of sides may also be mere places in the list.
isTreeEdge :: Frame -> Tree (U.Vector Int) -> Int -> Bool
isTreeEdge f tree node = nodes tree U.! nodeSource f node == node

-- | The tree at the start of the half turn.
--
-- /Cost/ O(n log n).
plant :: Scene -> Heading -> Vertical -> Tree (U.Vector Int)
plant scene heading vertical = runST $ do
  let size = frameSize f
  tree <-
    Tree
      <$> U.thaw targets0
      <*> U.thaw nodes0
      <*> M.replicate size 0
      <*> M.replicate (2 * size + 1) none
      <*> M.replicate (2 * size + 1) none
      <*> M.replicate (2 * size) none
      <*> M.replicate (2 * size) none
      <*> U.thaw (U.enumFromN 0 (2 * size))
      <*> U.thaw (U.enumFromN 0 (2 * size))
      <*> M.replicate 1 0
  forM_ (Map.toList incoming) $ \(t, children) -> do
    let ascending a b = case turn (framePoints f) t (nodeSource f a) (nodeSource f b) of
          LeftTurn -> LT
          Collinear -> EQ
          RightTurn -> GT
        ordered = if t < size then sortBy ascending children else children
    forM_ (zip (none : ordered) ordered) $ \(lower, node) -> insertAfter tree t lower node
  forM_ (along heading size) $ \t -> relink f tree t
  traverse U.unsafeFreeze tree
  where
    f = frame scene heading
    n = frameSize f
    targets0 = U.map toTarget (firstTargets vertical)
    toTarget t = if t == skyCode scene then 2 * n else t
    nodes0 = U.imap (\p t -> if t == none then none else edgeNode p t) targets0
    edgeNode p t
      | t < n, markerOf f p t /= none = markerOf f p t
      | otherwise = p
    incoming =
      Map.fromListWith
        (flip (<>))
        ( [ (t, [node])
          | p <- along heading n
          , let t = targets0 U.! p
          , let node = nodes0 U.! p
          , node == p
          ]
            <> [ (q, [markerOf f p q])
               | p <- along heading n
               , q <- neighbours p
               , comesBefore f p q
               ]
        )
    neighbours p
      | following f p == preceding f p = [following f p]
      | otherwise = [following f p, preceding f p]

-- | Sweeps one vertex: its corners in the order of the heading, each edge of the line being the tree edge of its source.
--
-- /Requires/ the vertex is ready in both trees. /Cost/ O(1) per corner besides the chain steps, which are counted.
sweepLine :: Frame -> Tree (M.MVector s Int) -> [Int] -> ST s ()
sweepLine f tree line = do
  forM_ (zip line (drop 1 (withoutLast line))) $ \(p, q) -> do
    isLinked <- get (links tree) q
    when (isLinked == 1) $ do
      leaf <- get (nodes tree) p
      top <- get (tops tree) leaf
      cut tree q leaf top
  mapM_ (advance f tree) (reverse (withoutLast line))
  where
    withoutLast xs = zipWith const xs (drop 1 xs)

-- | The tree edge of p has been swept: find the next one.
advance :: Frame -> Tree (M.MVector s Int) -> Int -> ST s ()
advance f tree p = do
  q <- get (targets tree) p
  swept <- get (nodes tree) p
  release q swept
  if following f p == q && preceding f p /= q
    then besideSolid q
    else do
      let x = preceding f q
      if x /= p && turnOf p q x == LeftTurn then stoppedBy q x else passing q
  where
    turnOf = turn (framePoints f)
    n = frameSize f

    -- Takes the swept edge out of the tree. It is the leaf of its chain; where it is also linked to the edge out of q, that
    -- chain is cut first.
    release q swept = do
      isLinked <- get (links tree) q
      final <- get (lastIn tree) q
      when (isLinked == 1 && final == swept) $ do
        top <- get (tops tree) swept
        cut tree q swept top
      put (tops tree) swept swept
      put (leaves tree) swept swept
      put (nodes tree) p none
      put (targets tree) p none
      when (swept < n) $ unlink tree q swept
      stillLinked <- get (links tree) q
      when (stillLinked == 0) $ relink f tree q

    -- The swept pair is a side with its solid just above: the next free ray is along the other side of p, if that leads
    -- forward and lies above; else there is none.
    besideSolid q = do
      let r = preceding f p
      when (comesBefore f p r && turnOf p q r == LeftTurn) $ attach f tree p r none NoTangent

    -- The ray turns into the side between x and q.
    stoppedBy q x
      | comesBefore f q x = get (lowerNode tree) (markerOf f q x) >>= settle x
      | otherwise = get (lastIn tree) (n + x) >>= underCeiling (n + x)

    -- The ray passes above q and slides along what q's own next ray meets.
    passing q = do
      stop <- get (nodes tree) q
      when (stop == none) $ broken "a ray that passes a corner finds its tree edge" (show (p, q))
      t <- get (targets tree) q
      e <- get (lowerNode tree) stop
      if t < n then settle t e else underCeiling t e

    -- On the underside of the ceiling t, e is the nearest vertical edge to the left of the place reached so far.
    underCeiling t e
      | e /= none, comesBefore f p (nodeSource f e) = settle t e
      | t < 2 * n, comesBefore f p (t - n) = get (lastIn tree) (t - n) >>= settle (t - n)
      | otherwise = settle t e

    settle t e = do
      (t', e', tangent) <- tangentFrom f tree p t e
      attach f tree p t' e' tangent

-- | Where the tangent from a corner touched a convex chain: the leaf and the top of that chain before it is cut there.
data Tangent = NoTangent | Touching !Int !Int

-- | Follows the convex chains that hide the target t from p; e is the last edge into t below p's ray. Each chain is searched
-- from both of its ends by turns, so the cost is at most twice the distance to the nearer one.
tangentFrom :: Frame -> Tree (M.MVector s Int) -> Int -> Int -> Int -> ST s (Int, Int, Tangent)
tangentFrom f tree p = chains NoTangent
  where
    turnOf = turn (framePoints f)
    n = frameSize f

    chains tangent t e = do
      step
      hidden <- if e == none then pure False else isEdge e >>= \edge -> if edge then hides e else pure False
      if not hidden
        then pure (t, e, tangent)
        else do
          leaf <- get (leaves tree) e
          t' <- search leaf e leaf
          e' <- get (lastIn tree) t'
          isLinked <- get (links tree) t'
          if isLinked == 1
            then pure (t', e', Touching leaf e)
            else chains (Touching leaf e) t' e'

    -- The far end goes down from e, the near end up from the leaf; both lie on one chain, along which hiding is monotone.
    search leaf e near = do
      step
      let t = nodeSource f e
      isLinked <- get (links tree) t
      if isLinked == 0
        then pure t
        else do
          e' <- get (lastIn tree) t
          far <- hides e'
          if not far
            then pure t
            else do
              found <- if near == e' then pure True else hides near
              if found
                then pure (nodeSource f near)
                else do
                  up <- get (targets tree) (nodeSource f near)
                  get (nodes tree) up >>= search leaf e'

    isEdge e = (== e) <$> get (nodes tree) (nodeSource f e)

    -- Does this edge, from s to t, hide t from p?
    hides e
      | comesBefore f p s = do
          t <- get (targets tree) s
          pure (t >= n || turnOf s t p /= RightTurn)
      | otherwise = pure False
      where
        s = nodeSource f e

    step = get (counter tree) 0 >>= put (counter tree) 0 . (+ 1)

-- | Makes t the target of p, in the list of t just after node e.
attach :: Frame -> Tree (M.MVector s Int) -> Int -> Int -> Int -> Tangent -> ST s ()
attach f tree p t e tangent = do
  put (targets tree) p t
  when (t < n) $ case tangent of
    NoTangent -> pure ()
    Touching leaf top -> do
      isLinked <- get (links tree) t
      when (isLinked == 1) $ cut tree t leaf top
  let marker = if t < n then markerOf f p t else none
      node = if marker == none then p else marker
  when (marker == none) $ insertAfter tree t e p
  put (tops tree) node node
  put (leaves tree) node node
  put (nodes tree) p node
  when (t < n) $ do
    isLinked <- get (links tree) t
    when (isLinked == 0) $ relink f tree t
  relink f tree p
  where
    n = frameSize f

-- | Links t if its edges allow it; t is not linked. See Note [Convex chains].
relink :: Frame -> Tree (M.MVector s Int) -> Int -> ST s ()
relink f tree t = do
  e <- get (lastIn tree) t
  g <- get (nodes tree) t
  unless (e == none || g == none) $ do
    let s = nodeSource f e
    edge <- get (nodes tree) s
    ahead <- get (targets tree) t
    when (edge == e && continues f s t ahead) $ do
      leaf <- get (leaves tree) e
      top <- get (tops tree) g
      put (tops tree) leaf top
      put (leaves tree) top leaf
      put (links tree) t 1

-- | Do the edge from s into t and the edge from t to its target bound a common empty region from below?
continues :: Frame -> Int -> Int -> Int -> Bool
continues f s t ahead =
  not (separates (following f t))
    && not (separates (preceding f t))
    && (toCeiling || turnOf s t ahead /= RightTurn)
  where
    turnOf = turn (framePoints f)
    toCeiling = ahead >= frameSize f
    -- A swept forward side below the edge out of t.
    separates x = comesBefore f t x && x /= ahead && (toCeiling || turnOf t x ahead == LeftTurn)

-- | What 'links' must say of t.
linkable :: Frame -> Tree (U.Vector Int) -> Int -> Bool
linkable f tree t =
  e /= none && nodes tree U.! t /= none && isTreeEdge f tree e && continues f (nodeSource f e) t (targets tree U.! t)
  where
    e = lastIn tree U.! t

-- | Splits the chain with this leaf and top at the linked corner t.
cut :: Tree (M.MVector s Int) -> Int -> Int -> Int -> ST s ()
cut tree t leaf top = do
  e <- get (lastIn tree) t
  g <- get (nodes tree) t
  put (leaves tree) e leaf
  put (tops tree) leaf e
  put (tops tree) g top
  put (leaves tree) top g
  put (links tree) t 0

-- | Puts a node into the list of t after the node e, or in front for 'none'.
insertAfter :: Tree (M.MVector s Int) -> Int -> Int -> Int -> ST s ()
insertAfter tree t e node = do
  above <- if e == none then get (firstIn tree) t else get (upperNode tree) e
  put (lowerNode tree) node e
  put (upperNode tree) node above
  if e == none then put (firstIn tree) t node else put (upperNode tree) e node
  if above == none then put (lastIn tree) t node else put (lowerNode tree) above node

-- | Takes a node out of the list of t.
unlink :: Tree (M.MVector s Int) -> Int -> Int -> ST s ()
unlink tree t node = do
  below <- get (lowerNode tree) node
  above <- get (upperNode tree) node
  if below == none then put (firstIn tree) t above else put (upperNode tree) below above
  if above == none then put (lastIn tree) t below else put (lowerNode tree) above below

get :: M.MVector s Int -> Int -> ST s Int
get = M.read
{-# INLINE get #-}

put :: M.MVector s Int -> Int -> Int -> ST s ()
put = M.write
{-# INLINE put #-}
