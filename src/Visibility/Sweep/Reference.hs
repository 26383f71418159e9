-- | The topological sweep as a text: every vertex of the visibility complex, by a pure step over persistent maps.
--
-- Around each corner a line turns through half a turn, at one corner faster than at another. Two trees say for each
-- corner which pair it meets next: of its elementary pairs that have not been swept, the one of least slope that leaves
-- to the right, and the one of least slope that leaves to the left. A pair that is the next one of both its corners,
-- and has less slope than whatever else is next at them, may be swept. Then both corners need another next pair, which
-- is found from the trees alone, without a test of visibility. Notes [Order], [Trees], [Ready], [Line] and [Next pair]
-- say why. "Visibility.Sweep.Topological" is the same sweep, fast; the tests ask that both agree in every state.
--
-- /Source/ Rivière, Topologically sweeping the visibility complex of polygonal scenes, for the two trees and their
-- convex chains; Rafalin, Souvaine, Streinu for sweeping all corners of a line at once. The proofs are this project's.
module Visibility.Sweep.Reference
  ( -- * The sweep
    State (..)
  , start
  , step
  , readyVertices
  , treeOf
  , module Visibility.Sweep.Reference.Tree
  ) where

import Data.List (foldl', mapAccumL)
import Data.Maybe (catMaybes, mapMaybe)
import Data.Set (Set)
import qualified Data.Set as Set
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Sweep.Reference.Plant
import Visibility.Sweep.Reference.Tree
import Visibility.Sweep.Vertex
import Visibility.Sweep.Vertical

-- Note [Order]
-- ~~~~~~~~~~~~
-- An elementary pair is two corners whose open segment is in free space and has no corner on it; a side is one too.
-- At each corner the pairs that leave to the right and those that arrive from the left are ordered together, by
-- slope. The sweep takes every pair once, so that at each corner pairs come in this order. It asks for no more: of
-- two pairs without a common corner either may come first, unless a row of others between them decides it. So no
-- queue is needed.
--
-- Note [Ready]
-- ~~~~~~~~~~~~
-- Let (p, q) be the next pair of p to the right and of q to the left. Let the next pair that arrives at p and the
-- next one that leaves q have greater slopes, where there are such. Then (p, q) may be swept. For the unswept pairs
-- that leave p have slopes no less than that of (p, q), which is the least by the definition of the tree; those that
-- arrive at p have slopes no less than that of the next one of them, so greater ones; and so it is at q. Sweeping (p,
-- q) concerns no other corner. Both trees are needed. Let s = (0, 0), t = (1, -1), p = (10, 0) and q = (11, 1/20).
-- The right tree alone says p → q and s → t, and does not show that (s, p), which is swept after (s, t), must come
-- before (p, q).
--
-- The sweep does not end too early. Among the unswept pairs of least slope take one, with all others on its line. At
-- the corners of this line all other unswept pairs have greater slopes, so it may be swept. And a line that may be
-- swept has a pending corner. Whether it may depends on the tree edges of its own corners alone. In the step that
-- made it ready, one of these has changed, so that corner was swept and is pending, as all are at the start. When it
-- is taken off the stack, one of its two next pairs is on the line, since the line is ready; so the line is found,
-- and it stays ready until it is swept, since a tree edge changes only when its own pair is swept.
--
-- Note [Line]
-- ~~~~~~~~~~~
-- Several pairs on one line, of which neighbours share a corner, have one slope. Neither of two neighbours comes
-- before the other at their corner, so all are swept in one step: they are one vertex. They are ready together. If no
-- unswept pair at any corner of the line has less slope than the line, nor the same without being on it, then the
-- next pairs of all its corners are the neighbours on it, both ways; so from any corner of the line one comes to all
-- others from next pair to next pair, which is how the line is collected. If at one corner another pair is next, and
-- has less slope, or if a neighbour's own next pair is another one, then the whole line waits. As no step sweeps a
-- part of a line, its pairs are all swept or all unswept.
--
-- Within the step the pairs are swept one by one. In the right tree the rightmost one comes first: to find the next
-- pair of a corner, the tree edge of its neighbour is followed (Note [Next pair]), and that has to have left the
-- line.
--
-- /Degenerate cases/ A wall that stands alone has two faces and one pair, which is on the line once. Where a wall has
-- corners in between, or where something touches it, its two faces may lead from a free end to two corners in one
-- place. Then the end has two pairs of one slope, and the line runs along both: the right tree leads along the lower
-- face first, the left tree along the upper one, as the ray turns from there into free space. So where one is met,
-- both are taken.

-- | The state between two steps. What has been swept is implied by the trees. /Cost/ O(n) memory.
data State = State
  { rightTree :: !Tree
  , leftTree :: !Tree
  , pending :: ![CornerId]
  -- ^ A stack of the corners at which a vertex may be ready, each once. Empty when the half turn is done.
  , isPending :: !(Set CornerId)
  -- ^ The same corners.
  , changes :: ![Change]
  -- ^ What the last step did to the right tree, and then to the left one, in this order.
  }
  deriving (Eq, Show)

-- | The state just above −90°, all corners pending. /Cost/ O(n log n).
start :: Scene -> State
start scene =
  State
    { rightTree = planted scene vertical Rightward
    , leftTree = planted scene vertical Leftward
    , pending = reverse (corners scene)
    , isPending = Set.fromAscList (corners scene)
    , changes = []
    }
  where
    vertical = verticalSweep scene

-- | The next vertex and the state after it; 'Nothing' at the end of the half turn.
--
-- /Degenerate cases/ all corners on a maximal free segment are one vertex, swept in one step.
--
-- /Cost/ O(log n) for each elementary pair and each corner of a chain that is looked at; so O(m log n) in all, by the
-- bound of docs/scan-bound.md.
--
-- /Laws/ the vertices are those of brute force, each once, at each corner by increasing direction.
step :: Scene -> State -> Maybe (Vertex, State)
step scene state = case pending state of
  [] -> Nothing
  p : others -> case mapMaybe (uncurry (readyVertex scene state)) (nextPairs p) of
    [] -> step scene popped
    vertex : _ -> Just (vertex, sweepVertex scene popped vertex)
    where
      popped = state {pending = others, isPending = Set.delete p (isPending state)}
  where
    nextPairs p =
      [(p, q) | Just q <- [cornerAhead (rightTree state) p]] <> [(o, p) | Just o <- [cornerAhead (leftTree state) p]]

-- | The vertex that this pair is on, if it may be swept. See Notes [Ready] and [Line].
readyVertex :: Scene -> State -> CornerId -> CornerId -> Maybe Vertex
readyVertex scene state p q = collected [p] (Set.singleton p) >>= fromCorners . Set.toAscList
  where
    collected [] line = Just line
    collected (c : rest) line = do
      onwards <- mapM (nextOnLine c) [Rightward, Leftward]
      let new = filter (`Set.notMember` line) (concat onwards)
      collected (rest <> new) (foldr Set.insert line new)
    -- The corners next to c on the line; 'Nothing' where a pair of less slope is next, or one that is not mutual.
    nextOnLine c way = case cornerAhead (treeOf way state) c of
      Nothing -> Just []
      Just d
        | side == Collinear -> if all (c `isNextOf`) onwards then Just onwards else Nothing
        | (side == LeftTurn) == (way == Rightward) -> Just []
        | otherwise -> Nothing
        where
          side = turned scene p q d
          onwards = if isSplitEnd scene c && d `elem` besides scene c then besides scene c else [d]
          back = treeOf (if way == Rightward then Leftward else Rightward) state
          c' `isNextOf` e = case cornerAhead back e of
            Just r -> r == c' || isSplitEnd scene e && c' `elem` besides scene e && r == nextCorner scene e
            Nothing -> False

-- | All vertices that may be swept now.
readyVertices :: Scene -> State -> [Vertex]
readyVertices scene state =
  Set.toAscList . Set.fromList $
    catMaybes [readyVertex scene state p q | p <- corners scene, Just q <- [cornerAhead (rightTree state) p]]

-- | Sweeps a vertex pair by pair: in the right tree the rightmost pair first, in the left tree the leftmost one.
sweepVertex :: Scene -> State -> Vertex -> State
sweepVertex scene state vertex = foldl' pushed after (vertexCorners vertex)
  where
    pairs = vertexPairs scene vertex
    (right, changesRight) = sweepLine scene (rightTree state) (reverse (map fst pairs))
    (left, changesLeft) = sweepLine scene (leftTree state) (map snd pairs)
    after =
      state
        { rightTree = right
        , leftTree = left
        , changes = changesRight <> changesLeft
        }
    pushed s c
      | c `Set.member` isPending s = s
      | otherwise = s {pending = c : pending s, isPending = Set.insert c (isPending s)}

-- | Sweeps the tree edges of corners on a line, given from the last one to the first. Before, all of them are made the
-- leaves of their chains; and each once more when it is swept, since of a wall's two faces the first one that is swept
-- may leave its corner linked to the second one.
sweepLine :: Scene -> Tree -> [CornerId] -> (Tree, [Change])
sweepLine scene tree line = mapAccumL sweep (foldl' separate tree (reverse line)) line
  where
    sweep grown p = advance scene (separate grown p) p

treeOf :: Heading -> State -> Tree
treeOf Rightward = rightTree
treeOf Leftward = leftTree
