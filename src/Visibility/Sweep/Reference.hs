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
  , module Visibility.Sweep.Reference.Next
  ) where

import Data.List (foldl', mapAccumL)
import Data.Maybe (catMaybes, mapMaybe)
import Data.Set (Set)
import qualified Data.Set as Set
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Sweep.Reference.Next
import Visibility.Sweep.Reference.Plant
import Visibility.Sweep.Reference.Tree
import Visibility.Sweep.Vertex
import Visibility.Sweep.Vertical

-- Note [Order]
-- ~~~~~~~~~~~~
-- An elementary pair is two corners whose open segment is in free space and has no corner on it; a side is one too.
-- At each corner, the pairs that leave to the right and those that arrive from the left are ordered together by
-- slope; a vertical has the greatest slope of all. The sweep takes every pair once, so that at no corner a pair comes
-- after one of greater slope. It asks for no more. Two pairs without a common corner may come in either order, unless
-- a row of pairs leads from one to the other, each sharing a corner with the next. So no queue is needed. Pairs of
-- one slope at one corner are on one line, and are swept in one step.
--
-- Note [Ready]
-- ~~~~~~~~~~~~
-- Let (p, q) be the next pair of p to the right and of q to the left. Let the next pair that arrives at p and the
-- next one that leaves q have greater slopes, where there are such. Then (p, q) may be swept. This can violate the
-- order at p and at q only. Of the unswept pairs that leave p it has the least slope, by the definition of the tree;
-- those that arrive at p have no less slope than the next one of them, so a greater one; and so it is at q. Both
-- trees are needed. Take four tiny polygons with corners s = (0, 0), t = (1, -1), p = (10, 0) and q = (11, 1/20). As
-- long as (s, t) is unswept, the right tree alone says s → t and p → q, and does not show that (s, p) must come
-- before (p, q).
--
-- The sweep does not end too early. Among the unswept pairs of least slope take one, with all that hang together with
-- it on its line. At the corners of this line all other unswept pairs have greater slopes, so it may be swept. And a
-- line that may be swept has a pending corner. Whether it may depends on the tree edges of its own corners alone; in
-- the step that made it ready, one of these has changed, so that corner was swept and is pending, as all are at the
-- start. Until the line is swept it stays ready: its tree edges change only when they are swept, and a pair of
-- greater slope at one of its corners is not ready. When that corner is taken off the stack, one of its next pairs is
-- on the line, and the other is on it too, or is not ready. So the line is found.
--
-- Note [Line]
-- ~~~~~~~~~~~
-- Pairs that hang together on one line are swept in one step, as one vertex. So they are all swept or all unswept.
-- The line may be swept if at each of its corners, both ways, the next pair is mutual and on the line, or has a
-- greater slope, or there is none. For then no other unswept pair at its corners has less slope, as in Note [Ready].
-- All of the line is seen so: if the line goes on from a corner, the pair with the neighbour is unswept, so the next
-- pair has no greater slope; hence it is that pair, or the line waits. So from any corner one comes to all others,
-- from next pair to next pair, which is how the line is collected; and the corner asked about is among them. Both
-- ways are gone by turns. If the line has to wait, this is found out after as many corners as the nearer reason for
-- it is away, and all questions about a line of k corners take O(k log k) steps.
--
-- Note [Within a step]
-- ~~~~~~~~~~~~~~~~~~~~
-- In each tree the pairs of a vertex are swept one by one, an event each, and until the step is over each tree counts
-- those as swept that it has done. In the right tree the rightmost comes first: the next pair of a corner is found
-- along the tree edge of its right neighbour, which must have left the line by then. In the left tree the leftmost
-- comes first. So the order of Note [Order] holds after each event, and of two pairs on one line the right one is
-- swept first in the right tree.
--
-- Where a wall has corners between its ends, or something touches it, its faces may lead from a free end to two
-- corners in one place: always to one place, since a contact cuts both faces. Then the end has two pairs of one
-- slope, and the line runs along both. A ray that turns about the left end of a wall comes from free space below it,
-- and meets the lower face first; about the right end it comes from above. So the right tree leads along the lower
-- face first and the left tree along the upper one, and where one of the two is met, both are taken. A wall that
-- stands alone has two faces and one pair.

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
-- /Cost/ O(log n) for each elementary pair, each corner of a chain that is looked at, and each corner of a line that is
-- asked whether it is ready. So O(m log n) for all searches, by docs/scan-bound.md, and O(k log k log n) for a line of
-- k corners.
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
