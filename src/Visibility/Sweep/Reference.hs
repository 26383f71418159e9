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
  , treeOf
  , module Visibility.Sweep.Reference.Tree
  ) where

import Data.List (foldl', mapAccumL)
import Data.Maybe (mapMaybe)
import Data.Set (Set)
import qualified Data.Set as Set
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Sweep.Reference.Tree
import Visibility.Sweep.Vertex
import Visibility.Sweep.Vertical

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
      collected (new <> rest) (foldr Set.insert line new)
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
