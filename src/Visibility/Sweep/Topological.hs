{-# LANGUAGE BangPatterns #-}

-- | The topological sweep: every vertex of the visibility complex, once, in an order in which each corner's vertices
-- come by increasing direction.
--
-- A pure step from state to state. A state is an immutable value of O(n) numbers; many steps are taken at a time on a
-- copy of it, so the copying costs O(1) per vertex and 'vertices' has O(n) live memory while the list is consumed.
--
-- /Source/ Rivière, Topologically sweeping the visibility complex of polygonal scenes; Rafalin, Souvaine, Streinu for
-- taking all collinear corners in one step.
module Visibility.Sweep.Topological
  ( -- * The whole sweep
    vertices
    -- * Step by step
  , Sweep (..)
  , start
  , step
  , trace
  , finish
  , stepsTaken
  ) where

import Control.Monad (forM_)
import Control.Monad.ST (ST, runST)
import Data.Bits (complement)
import Data.Int (Int32)
import qualified Data.IntSet as IntSet
import Data.List (unfoldr)
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Law (broken)
import Visibility.Exact.Point (Points)
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Sweep.HorizonTree
import Visibility.Sweep.HorizonTree.Frame
import Visibility.Sweep.HorizonTree.Table
import Visibility.Sweep.Vertex
import Visibility.Sweep.Vertical

-- | The state of the sweep: what has been swept is implied by the two trees.
data Sweep = Sweep
  { rightTree :: !Table
  -- ^ For each corner its next pair to the right.
  , leftTree :: !Table
  -- ^ For each corner its next pair to the left.
  , pending :: !(U.Vector Int32)
  -- ^ The corners at which a vertex may be ready, each once. Empty when the half turn is done.
  , isPending :: !(U.Vector Int32)
  -- ^ By corner: 1 where pending.
  , pairsSwept :: !Int
  -- ^ Elementary pairs so far.
  }
  deriving (Eq, Show)

-- | The state just above −90°. /Cost/ O(n log n).
start :: Scene -> Sweep
start scene =
  Sweep
    { rightTree = planted Rightward
    , leftTree = planted Leftward
    , pending = U.generate (cornerCount scene) fromIntegral
    , isPending = U.replicate (cornerCount scene) 1
    , pairsSwept = 0
    }
  where
    planted heading = plant scene heading (verticalSweep scene heading)

-- | All vertices of the complex, lazily. Which of the many topological orders it is depends on nothing but the scene.
--
-- /Degenerate cases/ all corners on a maximal free segment make one vertex, however many there are.
--
-- /Cost/ O(n log n) to start, then O(1) per elementary pair and chain step; O(n) live memory. Measured, there are about
-- three chain steps per pair; that there are O(m) is proved by Rivière for another scan of the chains, not for this
-- one.
--
-- /Laws/ the set equals that of brute force; @vertices s == unfoldr (step s) (start s)@.
vertices :: Scene -> [Vertex]
vertices scene = go (start scene)
  where
    go state = case steps scene (pieceSize scene) state of
      ([], _) -> []
      (found, state') -> found <> go state'

-- | The state at the end of the half turn. /Cost/ that of 'vertices'.
finish :: Scene -> Sweep
finish scene = go (start scene)
  where
    go state = case steps scene (pieceSize scene) state of
      ([], state') -> state'
      (_, state') -> go state'

-- | How many vertices are swept on one copy of the state: enough for the copy to cost little beside them.
pieceSize :: Scene -> Int
pieceSize scene = max 64 (4 * cornerCount scene)

-- | The next vertex and the state after it, 'Nothing' at the end of the half turn. /Cost/ O(n), for copying the state.
step :: Scene -> Sweep -> Maybe (Vertex, Sweep)
step scene state = case steps scene 1 state of
  (vertex : _, state') -> Just (vertex, state')
  ([], _) -> Nothing

-- | Every vertex with the state after it. /Cost/ O(n) per vertex.
trace :: Scene -> [(Vertex, Sweep)]
trace scene = unfoldr (fmap (\(vertex, state) -> ((vertex, state), state)) . step scene) (start scene)

-- | Chain steps of both trees: the work of the sweep besides O(1) per pair.
stepsTaken :: Scene -> Sweep -> Int
stepsTaken scene state = chainSteps scene (rightTree state) + chainSteps scene (leftTree state)

-- | Up to so many vertices and the state after them; none only at the end.
steps :: Scene -> Int -> Sweep -> ([Vertex], Sweep)
steps scene count state = (decoded found, state')
  where
    n = cornerCount scene
    (found, state') = runST $ do
      right <- thawed (rightTree state)
      left <- thawed (leftTree state)
      waiting <- U.thaw (isPending state)
      stack <- U.thaw (pending state <> U.replicate (n - U.length (pending state)) 0)
      written <- M.new (2 * count + n)
      (size, depth, swept) <-
        run scene (Running right left waiting stack written) count (U.length (pending state)) (pairsSwept state)
      right' <- frozen right
      left' <- frozen left
      waiting' <- U.unsafeFreeze waiting
      stack' <- U.unsafeFreeze stack
      written' <- U.unsafeFreeze written
      pure (U.take size written', Sweep right' left' (U.force (U.take depth stack')) waiting' swept)

-- | The state while it changes: both trees; which corners are pending; the pending corners; and the vertices found,
-- their corners one after the other, the last of each as its complement, so that nothing of it is traced by the garbage
-- collector.
data Running s
  = Running !(Growing s) !(Growing s) !(M.MVector s Int32) !(M.MVector s Int32) !(M.MVector s Int32)

-- | The vertices written by 'run', lazily.
decoded :: U.Vector Int32 -> [Vertex]
decoded written = from 0
  where
    from i
      | i >= U.length written = []
      | next < 0 = Vertex a (CornerId (complement next)) [] : from (i + 2)
      | otherwise = let rest = others (i + 2) in Vertex a (CornerId next) rest : from (i + 2 + length rest)
      where
        a = CornerId (at' i)
        next = at' (i + 1)
    others i
      | c < 0 = [CornerId (complement c)]
      | otherwise = CornerId c : others (i + 1)
      where
        c = at' i
    at' i = fromIntegral (written U.! i) :: Int

-- | Takes corners off the stack until so many vertices have been swept, or there is no room to write another. Gives the
-- size of what has been written, the depth of the stack and the number of pairs swept.
run :: Scene -> Running s -> Int -> Int -> Int -> ST s (Int, Int, Int)
run scene (Running right left waiting stack written) = go 0
  where
    n = cornerCount scene
    rightward = frame scene Rightward
    leftward = frame scene Leftward
    room = M.length written - n

    go !size !count !depth !swept
      | count <= 0 || depth <= 0 || size > room = pure (size, depth, swept)
      | swept > n * (n - 1) `div` 2 = broken "each elementary pair is swept once" (show swept)
      | otherwise = do
          top' <- M.read stack (depth - 1)
          let !p = fromIntegral top'
          M.write waiting p 0
          found <- readyAt scene right left p
          case found of
            NotReady -> go size count (depth - 1) swept
            Ready leftmost k -> do
              write size leftmost k
              let line i = M.read written i >>= \c -> pure $! fromIntegral c
              sweepLine rightward right (k - 1) (\i -> line (size + i))
              sweepLine leftward left (k - 1) (\i -> line (size + k - 1 - i))
              finished size k (k - 1)
            ReadyTracks line -> do
              let k = length line
                  pairs = maybe [] (vertexPairs scene) (fromCorners (map CornerId line))
                  m = length pairs
                  sources = U.fromList [c | (CornerId c, _) <- pairs]
                  targets = U.fromList [c | (_, CornerId c) <- pairs]
              forM_ (zip [size ..] line) $ \(i, c) -> M.write written i (fromIntegral c)
              sweepLine rightward right m (\i -> pure $! sources U.! i)
              sweepLine leftward left m (\i -> pure $! targets U.! (m - 1 - i))
              finished size k m
      where
        -- A vertex of k corners and m pairs has been swept and written at this place.
        finished here k m = do
          depth' <- push (depth - 1) here (here + k)
          M.modify written complement (here + k - 1)
          go (here + k) (count - 1) depth' (swept + m)

    write !i !c !k
      | k <= 0 = pure ()
      | otherwise = do
          M.write written i (fromIntegral c)
          l <- getList right (target c)
          write (i + 1) (listOwner l) (k - 1 :: Int)

    push !depth !i !end
      | i >= end = pure depth
      | otherwise = do
          p <- M.read written i
          already <- M.read waiting (fromIntegral p)
          if already == 1
            then push depth (i + 1) end
            else do
              M.write waiting (fromIntegral p) 1
              M.write stack depth p
              push (depth + 1) (i + 1) end

-- | Is there a vertex to be swept at a corner?
data Readiness
  = NotReady
  | -- | With this leftmost corner and so many corners, each the next one of the corner before.
    Ready !Int !Int
  | -- | With these corners; the line runs along both faces of a wall somewhere.
    ReadyTracks ![Int]

-- | Looks at the next pair of p to the right, then at that to the left.
readyAt :: Scene -> Growing s -> Growing s -> Int -> ST s Readiness
readyAt scene right left !p = do
  l <- getList right (target p)
  onRight <- if isCorner l then readyLine scene right left p (listOwner l) else pure NotReady
  case onRight of
    NotReady -> do
      l' <- getList left (target p)
      if isCorner l' then readyLine scene right left (listOwner l') p else pure NotReady
    _ -> pure onRight

isCorner :: List -> Bool
isCorner l = l /= noList && isCornerList l
{-# INLINE isCorner #-}

-- | The line of p and q, if this is a vertex that may be swept now: each edge of the line is the next pair of both of
-- its corners, and no other unswept pair at its ends has a lesser slope.
readyLine :: Scene -> Growing s -> Growing s -> Int -> Int -> ST s Readiness
readyLine scene right left !p !q
  | hasSplitEnds scene = maybe NotReady ReadyTracks <$> readyTracks scene right left p q
  | otherwise = do
      there <- getList right (target p)
      back <- getList left (target q)
      if there /= cornerList q || back /= cornerList p
        then pure NotReady
        else do
          onRight <- beyond points right left p q
          case onRight of
            Wait -> pure NotReady
            Further _ i -> do
              onLeft <- beyond points left right q p
              pure $ case onLeft of
                Wait -> NotReady
                Further leftmost j -> Ready leftmost (i + j + 2)
  where
    points = scenePoints scene

-- | All corners of the line of p and q, in order, if it is a vertex that may be swept now; where it runs along both
-- faces of a wall, the pairs at a free end of the wall come one after the other, but are swept together.
--
-- /Cost/ O(log k) for each of k corners.
readyTracks :: Scene -> Growing s -> Growing s -> Int -> Int -> ST s (Maybe [Int])
readyTracks scene right left !p !q = fmap IntSet.toAscList <$> go [p] (IntSet.singleton p)
  where
    points = scenePoints scene
    go [] line = pure (Just line)
    go (c : rest) line = do
      ahead <- neighboursOn right left LeftTurn c
      behind <- neighboursOn left right RightTurn c
      case (<>) <$> ahead <*> behind of
        Nothing -> pure Nothing
        Just found ->
          let more = filter (`IntSet.notMember` line) found
           in go (more <> rest) (foldr IntSet.insert line more)
    -- The corners next to c on the line in the direction of a tree, the other one being the opposite one; nothing if
    -- something else must be swept first. The first turn is that to corners that are to be swept later.
    neighboursOn tree other later c = do
      l <- getList tree (target c)
      let d = listOwner l
      if not (isCorner l)
        then pure (Just [])
        else case turn points p q d of
          Collinear -> do
            let found = if isSplitEnd scene (CornerId c) && d `elem` besides c then besides c else [d]
            mutual <- and <$> mapM (leadsBack other c) found
            pure (if mutual then Just found else Nothing)
          t | t == later -> pure (Just [])
          _ -> pure Nothing
    leadsBack tree c d = do
      l <- getList tree (target d)
      pure (l == cornerList c || (isSplitEnd scene (CornerId d) && c `elem` besides d && l `elem` firstOf d))
    firstOf d = map cornerList (take 1 (besides d))
    -- The corners at the other ends of a wall's two faces, that of the face which is swept first before the other.
    besides c = [d | CornerId d <- [nextCorner scene (CornerId c), previousCorner scene (CornerId c)]]

-- | What follows on a line.
data Beyond
  = -- | Something else must be swept first.
    Wait
  | -- | The last corner, and how many there are beyond the one asked about.
    Further !Int !Int

-- | The corners beyond b on the line from a to b, in the direction of the first tree; the second is the opposite one.
beyond :: Points -> Growing s -> Growing s -> Int -> Int -> ST s Beyond
beyond points ahead behind !a !b = do
  l <- getList ahead (target b)
  let !c = listOwner l
  if not (isCorner l)
    then pure (Further b 0)
    else case turn points a b c of
      LeftTurn -> pure (Further b 0)
      RightTurn -> pure Wait
      Collinear -> do
        mutual <- getList behind (target c)
        if mutual /= cornerList b
          then pure Wait
          else oneMore <$> beyond points ahead behind b c
  where
    oneMore Wait = Wait
    oneMore (Further d count) = Further d (count + 1)
