-- | A horizon tree as a text, over persistent maps: what its edges are, what arrives where, and its convex chains.
--
-- The proofs are for polygons that do not touch; Note [Corners in one place] says how they are to be read where
-- polygons do. Right and left, below and above are those of the scene turned by an infinitely small angle
-- to the right, in which no two corners are one above the other: a vertical pair has the greatest slope of all.
--
-- /Source/ Rivière, Topologically sweeping the visibility complex of polygonal scenes. The proofs are this project's.
module Visibility.Sweep.Reference.Tree
  ( -- * The tree
    Tree (..)
  , Target (..)
  , cornerAhead
    -- * Arrivals
  , Rank
  , rankOf
  , lastArrival
  , arrivalBefore
    -- * To grow a tree
  , bareTree
  , grownBy
    -- * Chains
  , linkable
  , relink
  , separate
  , cut
    -- * The scene as a heading sees it
  , turned
  , comesBefore
  , goesTo
  , besides
  ) where

import Data.List (foldl')
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Set (Set)
import qualified Data.Set as Set
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Scene.Cone (besides, turned)
import Visibility.Sweep.Vertical

-- Note [Taut paths]
-- ~~~~~~~~~~~~~~~~~
-- Let P be a path in free space from x to w, of two legs or more, that makes a convex polygon with the segment wx.
-- Let no side cross its open legs, no corner be on them, and the angles of P inside the polygon be free near its
-- inner points. Take the convex hull of x, w and all corners in the polygon, the inner points of P left out. Let W be
-- the part of its boundary that faces P, with all corners on it: the taut path from x to w. Neighbours on W see each
-- other, and between P and W there is neither a corner nor anything solid. For there is no corner by definition. A
-- side there would have to leave the region at both ends: not through an open leg, nor at an inner point of P. So it
-- would leave twice through W; but what lies between two points of W lies on its other side. So no side is there, and
-- the region is free, as it is near P. What crosses an edge of W would come into it.
--
-- If P goes to the right and turns right, so does W, or it goes straight on: slopes do not increase along it, the
-- first one is less than that of the first leg of P, and the last one greater than that of the last leg. Then, if the
-- first pair of W is swept, all are. At each corner of W the following pair has no greater slope, so it has been
-- swept too: by the order at that corner, or if both are on one line, since the right one is swept first.
--
-- Note [Trees]
-- ~~~~~~~~~~~~
-- After each event: an unswept pair (y, w) that crosses a tree edge, say that of x, in a point z, has a greater
-- slope. For let it have less. Neither is a side, since sides cross no pair. So it is free around z, and the path x →
-- z → w turns right. The first pair of its taut path leaves x with less slope than the tree edge, so it is swept, and
-- then the last one is, too. That arrives at w with a greater slope than (y, w), which is not swept, against the
-- order at w. So tree edges do not cross, neither two of one tree nor two of both: they are unswept pairs, and each
-- would have a greater slope than the other.
--
-- The same holds with a vertical first leg. If all pairs that leave x are swept, no unswept pair crosses the vertical
-- from x up to its ceiling, since the first pair of the taut path would leave x. So vertical edges are not crossed by
-- other edges either.
--
-- Note [Chains]
-- ~~~~~~~~~~~~~
-- A corner may be linked when its last arrival is a tree edge, its own tree edge turns left there or goes straight
-- on, and no side of it leads to the right below that. A chain is a maximal path of tree edges through linked
-- corners; its first edge is its leaf, its last one its top. Straight on counts: else the corners of a line would be
-- searched one by one, in quadratic time. The two ends of a chain know each other, so a search begins at the leaf at
-- once. That all searches of a sweep look at O(m) edges is proved in docs/scan-bound.md, which also says what is
-- measured only.
--
-- After each event: every tree edge and every side is listed at its end, in the order of ranks; and a corner that may
-- be linked is linked, but for corners of the line being swept that have been separated. An event of p changes tree
-- edges and lists at p, at q and at p's new target only, and looks at these.
--
-- Note [Corners in one place]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~~~
-- Where polygons touch, a place has one corner for each cone of free space. Complete the inside of free space by its
-- inner distance: a place becomes as many points as it has cones, and a piece of a wall gets two faces. In this space
-- nothing touches. The inner corners of a taut path have angles of 180° or more on the side of P, so each belongs to
-- one cone; and regions in the proofs are free inside, so they are as in the plane. Ids order corners in one place,
-- though neither is before the other in the plane. That does no harm: no search asks an edge that leaves the place of
-- p, and no corner that is looked at under a ceiling is there. docs/scan-bound.md proves it.

-- | The next pairs of all corners in one heading. Seen 'Leftward' the scene is turned by 180°: right is left, above is
-- below; slopes and turns stay. So one tree serves both, and all that is said of it here is said of the rightward one.
data Tree = Tree
  { heading :: !Heading
  , targets :: !(Map CornerId Target)
  -- ^ What the tree edge of a corner leads to. A corner whose remaining rays to the right are solid has none.
  , arrivals :: !(Map Target (Map Rank CornerId))
  -- ^ What arrives at a target, by the corner it comes from, in the order of slopes, so from the highest source to the
  -- lowest: tree edges, and at a corner also the sides that lead to it from the left. A tree edge that is a side is
  -- listed once. /Before/ an arrival means less slope than it, so from higher up; under a ceiling, further to the left.
  , linked :: !(Set CornerId)
  -- ^ The corners inside of convex chains, see Note [Chains].
  , otherEnd :: !(Map CornerId CornerId)
  -- ^ From the corner at which the first edge of a chain begins to the corner at which its last edge begins, and back.
  }
  deriving (Eq, Show)

-- | What a tree edge leads to.
data Target
  = -- | The far corner of the next pair.
    ToCorner !CornerId
  | -- | All pairs to the right are swept. The ray meets this side from below until it is vertical, as the edge is.
    ToCeiling !SideId
  | -- | The same with the sky in place of a side.
    ToSky
  deriving (Eq, Ord, Show)

-- | The order of arrivals: by ascending slope, of a wall's two faces the upper one first; vertical ones from left to
-- right.
data Rank = Rank !Slope !Int
  deriving (Eq, Ord, Show)

newtype Slope = Slope Direction
  deriving (Show)

instance Eq Slope where
  a == b = compare a b == EQ

instance Ord Slope where
  compare (Slope d) (Slope e) = compareDirections d e

-- | The tree without tree edges: only the sides arrive.
bareTree :: Scene -> Heading -> Tree
bareTree scene way = Tree way Map.empty (foldl' withSide Map.empty sidesAhead) Set.empty Map.empty
  where
    sidesAhead = [(p, q) | p <- corners scene, q <- besides scene p, comesBefore way p q]
    withSide lists (p, q) = arriving scene way (ToCorner q) p lists

-- | Cuts the chain at a corner, so that the corner's tree edge is a leaf. /Requires/ that its last arrival, which is a
-- tree edge if the corner is linked, is a leaf itself: on a line, the corners before it have been separated.
separate :: Tree -> CornerId -> Tree
separate tree p = case lastArrival tree (ToCorner p) of
  Just e | p `Set.member` linked tree -> cut tree p e
  _ -> tree

-- | The tree with one more edge, a chain of its own.
grownBy :: Scene -> Tree -> CornerId -> Target -> Tree
grownBy scene tree p t =
  tree
    { targets = Map.insert p t (targets tree)
    , arrivals = arriving scene (heading tree) t p (arrivals tree)
    , otherEnd = Map.insert p p (otherEnd tree)
    }

-- | Joins the chain that ends at a corner and the one that begins there, if they may be joined.
relink :: Scene -> Tree -> CornerId -> Tree
relink scene tree t
  | t `Set.notMember` linked tree && linkable scene tree t
  , Just e <- lastArrival tree (ToCorner t)
  , Just leaf <- Map.lookup e ends
  , Just top <- Map.lookup t ends =
      tree {linked = Set.insert t (linked tree), otherEnd = chain leaf top (Map.delete e (Map.delete t ends))}
  | otherwise = tree
  where
    ends = otherEnd tree

-- | May a chain pass through a corner? See Note [Chains].
linkable :: Scene -> Tree -> CornerId -> Bool
linkable scene tree t = case (lastArrival tree (ToCorner t), Map.lookup t (targets tree)) of
  (Just s, Just ahead) -> cornerAhead tree s == Just t && bends s && not (any (isBelow ahead) (besides scene t))
  _ -> False
  where
    bends s = maybe True (\x -> turned scene s t x /= RightTurn) (cornerAhead tree t)
    isBelow ahead x =
      goesTo tree t x && ahead /= ToCorner x && maybe True (\y -> turned scene t x y == LeftTurn) (cornerAhead tree t)

-- | Cuts a chain, given its leaf, at a linked corner.
cut :: Tree -> CornerId -> CornerId -> Tree
cut tree t leaf = tree {linked = Set.delete t (linked tree), otherEnd = chain t top (chain leaf end (otherEnd tree))}
  where
    end = fromMaybe leaf (lastArrival tree (ToCorner t))
    top = Map.findWithDefault t leaf (otherEnd tree)

-- | A chain from its leaf to its top.
chain :: CornerId -> CornerId -> Map CornerId CornerId -> Map CornerId CornerId
chain leaf top = Map.insert leaf top . Map.insert top leaf

-- | The arrival of greatest slope, from the lowest source.
lastArrival :: Tree -> Target -> Maybe CornerId
lastArrival tree t = Map.lookup t (arrivals tree) >>= fmap snd . Map.lookupMax

-- | The arrival at a target that is just before that from a corner.
arrivalBefore :: Scene -> Tree -> Target -> CornerId -> Maybe CornerId
arrivalBefore scene tree t q =
  snd <$> (Map.lookup t (arrivals tree) >>= Map.lookupLT (rankOf scene (heading tree) t q))

-- | With one more arrival, if it is not there.
arriving
  :: Scene -> Heading -> Target -> CornerId -> Map Target (Map Rank CornerId) -> Map Target (Map Rank CornerId)
arriving scene way t p = Map.insertWith Map.union t (Map.singleton (rankOf scene way t p) p)

rankOf :: Scene -> Heading -> Target -> CornerId -> Rank
rankOf scene way t p@(CornerId s) = case t of
  ToCorner q@(CornerId c) -> Rank (slope (min s c) (max s c)) (if nextCorner scene p == q then 1 else 0)
  _ -> Rank (Slope upwards) (case way of Rightward -> s; Leftward -> negate s)
  where
    slope a b = Slope (direction (scenePoints scene) a b)

-- | The corner that a corner's tree edge leads to, where it leads to one.
cornerAhead :: Tree -> CornerId -> Maybe CornerId
cornerAhead tree p = case Map.lookup p (targets tree) of
  Just (ToCorner q) -> Just q
  _ -> Nothing

-- | Is the second corner ahead of the first, seen by the heading?
goesTo :: Tree -> CornerId -> CornerId -> Bool
goesTo tree = comesBefore (heading tree)

comesBefore :: Heading -> CornerId -> CornerId -> Bool
comesBefore way (CornerId p) (CornerId q) = before way p q
