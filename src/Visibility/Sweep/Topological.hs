-- | The topological sweep: every vertex of the visibility complex, once, in an order in which each corner's vertices come by
-- increasing direction.
--
-- A pure step from state to state. A state is an immutable value of O(n) numbers; many steps are taken at a time on a copy
-- of it, so the copying costs O(1) per vertex and 'vertices' runs in O(m + n log n) time and O(n) live memory while
-- the list is consumed.
--
-- /Source/ Rivière, Topologically sweeping the visibility complex of polygonal scenes; Rafalin, Souvaine, Streinu for taking
-- all collinear corners in one step.
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

import Control.Monad.ST (ST, runST)
import Data.List (foldl', unfoldr)
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Law (broken)
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Sweep.HorizonTree
import Visibility.Sweep.Vertex
import Visibility.Sweep.Vertical

-- | The state of the sweep: what has been swept is implied by the two trees.
data Sweep = Sweep
  { rightTree :: !(Tree (U.Vector Int))
  -- ^ For each corner its next pair to the right.
  , leftTree :: !(Tree (U.Vector Int))
  -- ^ For each corner its next pair to the left.
  , pending :: ![Int]
  -- ^ The corners at which a vertex may be ready, each once. Empty when the half turn is done.
  , isPending :: !(U.Vector Int)
  -- ^ By corner: 1 where pending.
  , pairsSwept :: !Int
  -- ^ Elementary pairs so far.
  }
  deriving (Eq, Show)

-- | The state just above −90°. /Cost/ O(n log² n).
start :: Scene -> Sweep
start scene =
  Sweep
    { rightTree = planted Rightward
    , leftTree = planted Leftward
    , pending = [0 .. cornerCount scene - 1]
    , isPending = U.replicate (cornerCount scene) 1
    , pairsSwept = 0
    }
  where
    planted heading = plant scene heading (verticalSweep scene heading)

-- | All vertices of the complex, lazily. Which of the many topological orders it is depends on nothing but the scene.
--
-- /Degenerate cases/ all corners on a maximal free segment make one vertex, however many there are.
--
-- /Cost/ O(m + n log² n) time for m elementary pairs, measured as chain steps; O(n) live memory.
--
-- /Laws/ the set equals that of brute force; @vertices s == unfoldr (step s) (start s)@.
vertices :: Scene -> [Vertex]
vertices scene = concatMap fst (pieces scene)

-- | The state at the end of the half turn. /Cost/ that of 'vertices'.
finish :: Scene -> Sweep
finish scene = foldl' (\_ (_, state) -> state) (start scene) (pieces scene)

-- | The sweep in pieces of n vertices, each with the state after it.
pieces :: Scene -> [([Vertex], Sweep)]
pieces scene = unfoldr several (start scene)
  where
    several state = case steps scene (max 64 (cornerCount scene)) state of
      ([], _) -> Nothing
      (found, state') -> Just ((found, state'), state')

-- | The next vertex and the state after it, 'Nothing' at the end of the half turn. /Cost/ O(n), for copying the state.
step :: Scene -> Sweep -> Maybe (Vertex, Sweep)
step scene state = case steps scene 1 state of
  (vertex : _, state') -> Just (vertex, state')
  ([], _) -> Nothing

-- | Every vertex with the state after it. /Cost/ O(n) per vertex.
trace :: Scene -> [(Vertex, Sweep)]
trace scene = unfoldr (fmap (\(vertex, state) -> ((vertex, state), state)) . step scene) (start scene)

-- | Chain steps of both trees: the work of the sweep besides O(1) per pair.
stepsTaken :: Sweep -> Int
stepsTaken state = chainSteps (rightTree state) + chainSteps (leftTree state)

-- | Up to so many vertices and the state after them; fewer only at the end.
steps :: Scene -> Int -> Sweep -> ([Vertex], Sweep)
steps scene count state = runST $ do
  right <- traverse U.thaw (rightTree state)
  left <- traverse U.thaw (leftTree state)
  waiting <- U.thaw (isPending state)
  (found, rest, swept) <- run scene (Running right left waiting) count (pending state) (pairsSwept state)
  right' <- traverse U.unsafeFreeze right
  left' <- traverse U.unsafeFreeze left
  waiting' <- U.unsafeFreeze waiting
  pure (found, Sweep right' left' rest waiting' swept)

-- | The state while it changes.
data Running s = Running !(Tree (M.MVector s Int)) !(Tree (M.MVector s Int)) !(M.MVector s Int)

-- | Takes corners off the stack until so many vertices have been swept.
run :: Scene -> Running s -> Int -> [Int] -> Int -> ST s ([Vertex], [Int], Int)
run scene (Running right left waiting) = go []
  where
    n = cornerCount scene
    rightward = frame scene Rightward
    leftward = frame scene Leftward

    go found count stack swept
      | count <= 0 = pure (reverse found, stack, swept)
      | swept > n * (n - 1) `div` 2 = broken "each elementary pair is swept once" (show swept)
      | otherwise = case stack of
          [] -> pure (reverse found, [], swept)
          p : rest -> do
            M.write waiting p 0
            toRight <- M.read (targets right) p
            ready <- if isCorner toRight then readyLine scene right left p toRight else pure Nothing
            ready' <- case ready of
              Just line -> pure (Just line)
              Nothing -> do
                toLeft <- M.read (targets left) p
                if isCorner toLeft then readyLine scene right left toLeft p else pure Nothing
            case ready' of
              Nothing -> go found count rest swept
              Just line -> do
                sweepLine rightward right line
                sweepLine leftward left (reverse line)
                stack' <- push rest line
                case fromCorners (map CornerId line) of
                  Just vertex -> go (vertex : found) (count - 1) stack' (swept + length line - 1)
                  Nothing -> broken "a vertex has two corners" (show line)

    push stack [] = pure stack
    push stack (p : line) = do
      already <- M.read waiting p
      if already == 1
        then push stack line
        else M.write waiting p 1 >> push (p : stack) line

    isCorner t = t >= 0 && t < n

-- | All corners on the line of p and q, from left to right, if this is a vertex that may be swept now: each edge of the line
-- is the next pair of both of its corners, and no other unswept pair at its ends has a lesser slope.
readyLine :: Scene -> Tree (M.MVector s Int) -> Tree (M.MVector s Int) -> Int -> Int -> ST s (Maybe [Int])
readyLine scene right left p q = do
  there <- M.read (targets right) p
  back <- M.read (targets left) q
  if there /= q || back /= p
    then pure Nothing
    else do
      onRight <- extend right left p q
      case onRight of
        Nothing -> pure Nothing
        Just more -> do
          onLeft <- extend left right q p
          pure (fmap (\others -> reverse others <> (p : q : more)) onLeft)
  where
    n = cornerCount scene
    -- The corners beyond b on the line from a to b, nearest first; 'Nothing' where something must be swept before.
    extend ahead behind a b = do
      c <- M.read (targets ahead) b
      if c < 0 || c >= n
        then pure (Just [])
        else case turn (scenePoints scene) a b c of
          LeftTurn -> pure (Just [])
          RightTurn -> pure Nothing
          Collinear -> do
            mutual <- M.read (targets behind) c
            if mutual /= b
              then pure Nothing
              else fmap (c :) <$> extend ahead behind b c
