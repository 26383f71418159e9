-- | A horizon tree as a text, over persistent maps: the tree edges of "Visibility.Sweep.Reference", and how the next
-- one of a corner is found without a test of visibility.
--
-- What is proved here of all scenes is proved of polygons that do not touch; Note [Corners in one place] says how it is
-- to be read where they do. Right and left, below and above are those of the scene turned by an infinitely small angle
-- to the right, in which no two corners are one above the other: a vertical pair has the greatest slope of all.
--
-- /Source/ Rivière, Topologically sweeping the visibility complex of polygonal scenes. The proofs are this project's.
module Visibility.Sweep.Reference.Tree
  ( -- * The tree
    Tree (..)
  , Target (..)
  , Rank
  , cornerAhead
    -- * To sweep a pair
  , advance
  , separate
  , Change (..)
  , Search (..)
  , Way (..)
    -- * To grow a tree
  , bareTree
  , grownBy
  , relink
    -- * Chains
  , linkable
  , lastArrival
  , hides
  , rankOf
  , turned
  , comesBefore
  , besides
  ) where

import Data.List (foldl')
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Set (Set)
import qualified Data.Set as Set
import Visibility.Exact.Predicate
import Visibility.Law (broken)
import Visibility.Scene
import Visibility.Sweep.Vertical

-- Note [Taut paths]
-- ~~~~~~~~~~~~~~~~~
-- Let P be a path from x to w that makes a convex polygon with the segment wx. Let no side cross its open legs, no
-- corner be on them, and the angles of P inside the polygon be free near its inner points. Let W be the part of the
-- boundary of the convex hull of x, w and all other corners in the polygon that faces P, with all corners on it: the
-- taut path. Neighbours on W see each other, and between P and W there is neither a corner nor anything solid. For
-- there is no corner by definition. Were a side there, it would have to leave the region at both of its ends: not
-- through an open leg, nor at an inner point of P, where the angle is free. So it would leave through W twice, but
-- then it would be on the other side of W. So no side is there, and the region, free near P, is free. What would
-- cross an edge of W would come into it.
--
-- If P goes to the right and turns right, slopes do not increase along W. Then, if the first pair of W is swept, all
-- are: at each corner of W the following pair has no greater slope, so by the order at that corner it has been swept
-- too.
--
-- Note [Trees]
-- ~~~~~~~~~~~~
-- In every state tree edges do not cross. More: an unswept pair (y, w) that crosses a tree edge, that of x, in a
-- point z, has a greater slope. For let it be less. Neither of the two is a side, since sides cross no pair, so it is
-- free around z, and the path x → z → w turns right. The first pair of its taut path leaves x with less slope than
-- the tree edge, so it is swept, and then so is the last one. That arrives at w with a greater slope than (y, w),
-- which is not swept, against the order at w. Now tree edges are unswept pairs: of two that cross each would have a
-- greater slope than the other, by the tree of one and by that of the other, whichever these are. The same with a
-- vertical first leg: if all pairs that leave x are swept, no unswept pair crosses the vertical from x up to its
-- ceiling, since the first pair of the taut path leaves x.
--
-- Note [Next pair]
-- ~~~~~~~~~~~~~~~~
-- (p, q) has just been swept, and what is just above it is free, or else the way is 'BesideSolid'. Turn around q
-- clockwise from the direction back to p: what is met first, within 180°, is the /front/: a side of q, or else the
-- tree edge of q. Four ways, by what the front is. An unswept pair that starts to the right, above (p, q) and before
-- the front, does not leave the region there through (p, q) or the front (N): it would cross a side, or a tree edge
-- of less slope, or the vertical at q, against Note [Trees]; (p, q) was a tree edge before this step.
--
-- 'AlongSide', 'AlongEdge'. The front leads from q to x. The path p → q → x turns left: a pair (q, x) that is not
-- swept has a greater slope than (p, q). Let p, r₁, …, rₖ, x be its taut path; slopes do not decrease along it. Then
-- (1) r₁, or x if k = 0, is the next target of p. The pair is unswept, as its slope is greater than that of (p, q). A
-- pair of p with less slope would start into the region between both paths, where no corner is, and could not leave
-- it, by (N).
-- (2) Each (rᵢ, rᵢ₊₁) is a tree edge. It is unswept, by the order at r₁, then at r₂, and so on. An unswept pair of rᵢ
-- with less slope would start into the region, and could only end in q; but (rᵢ, q) has less slope than (p, q), so it
-- is swept.
-- (3) Nothing arrives at rᵢ below the taut path, nor at x between it and the front: a side or tree edge that did
-- would come from a corner on the boundary of the region, not crossing it; not from the taut path, which is convex,
-- nor from q.
-- (4) No side leaves rᵢ below the taut path: it could only end in q, and be met before the front.
-- So all edges of the taut path but the first one are tree edges, each the last arrival at its end, but for the one
-- at x, which is the next arrival below the front. Where it is linked, rᵢ is inside of a chain, and by (2) to (4) r₂,
-- …, rₖ are. So r₁ → … → x is the upper end of the chain whose last edge arrives next below the front; its edges hide
-- their ends from p, by convexity; an edge of the chain before them ends at r₁ with less slope than (p, r₁), by (3),
-- so it does not hide. Hence the search finds r₁, and there is no second chain to look at: what arrives last at r₁
-- does not hide it.
--
-- 'UnderSide', 'UnderCeiling'. The front is a side s = (a, q), or the vertical from q up to its ceiling s and then s.
-- Let Z be the region above (p, q), below s, to the right of p and a and to the left of q. If there is a corner in Z,
-- take the rightmost one, r. To the right of it Z is free, so no pair leaves r unswept: it would leave Z against (N),
-- or end in q. So r has a vertical edge to s, and it is the nearest one: any other source between r and q is below
-- (p, q), and its vertical would cross (p, q), which was unswept just now. So p aims at s, and with r in the place of
-- rₖ and a point of s above it in that of x, (1) to (4) hold as before. If there is no corner in Z, there is no
-- vertical edge to s from between p and q either. If a is to the left of p, p has no unswept pair, by (N): s is its
-- target. If a is to the right of p, p aims at a, and (1) to (4) hold with a for x. What arrives last at a is the
-- last edge of its chain, that is, a is not linked: the side (a, b) of the ceiling has been swept, since b is q, or
-- since by the taut path of q → b all is; so that side is below the tree edge of a.
--
-- Note [Chains]
-- ~~~~~~~~~~~~~
-- A corner is linked when its last arrival is a tree edge, its own tree edge turns left there or goes straight on,
-- and no side to the right is below that. A maximal path of tree edges through linked corners is a chain, its first
-- edge its leaf, its last one its top. Straight on counts: else the corners of a line would be searched one by one,
-- in quadratic time. The ends of a chain know each other, so the search of Note [Next pair] begins at the leaf at
-- once. That all searches take O(m) steps is proved in docs/scan-bound.md, which also tells what is measured only.
--
-- Note [Corners in one place]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~~~
-- Where polygons touch, a place has one corner for each cone of free space. Complete the inside of free space by its
-- inner distance: a place becomes as many points as it has cones, and a piece of a wall gets two faces. In this space
-- nothing touches. The inner corners of a taut path turn by 180° or more on the side of P, so each belongs to one
-- cone; regions in the proofs are free inside, so they are as in the plane. A corner in the place of p is in another
-- cone, so its edge hides nothing from p. Of a wall's two faces with one slope the lower one is swept first, and then
-- nothing is to be searched.

-- | The next pairs of all corners in one heading. Seen 'Leftward' the scene is turned by 180°: right is left, above is
-- below; slopes and turns stay. So one tree serves both, and all that is said of it here is said of the rightward one.
data Tree = Tree
  { heading :: !Heading
  , targets :: !(Map CornerId Target)
  -- ^ What the tree edge of a corner leads to. A corner whose remaining rays to the right are solid has none.
  , arrivals :: !(Map Target (Map Rank CornerId))
  -- ^ Whence something arrives at a target, from the uppermost to the lowest: tree edges, and at a corner the sides too
  -- that lead to it from the left. What is both is there once.
  , linked :: !(Set CornerId)
  -- ^ The corners inside of convex chains, see Note [Chains].
  , otherEnd :: !(Map CornerId CornerId)
  -- ^ By the corner where the first edge of a chain begins, that where its last one does, and the other way round.
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

-- | How the next pair of p is found when (p, q) has been swept: by what the ray of p is up against when it has turned
-- past q. The first three look at sides, the others at the tree edge of q.
data Way
  = -- | (p, q) is a side with its solid just above. The next free ray of p is along its other side, if that leads to
    -- the right and is not below; if not, all is solid up to the vertical.
    BesideSolid
  | -- | A side of q stands in the way and leads on to the right, to this corner. The ray slides along it.
    AlongSide !CornerId
  | -- | A side of q stands in the way and leads back to the left, above p. The ray slides along its underside.
    UnderSide !SideId
  | -- | The ray passes q. The next pair of q leads to this corner, and nothing unswept comes from below it: so the ray
    -- slides along it as along a side.
    AlongEdge !CornerId
  | -- | The ray passes q, of which all pairs to the right are swept. It slides along what q's own rays meet, up to the
    -- vertical: the underside of a ceiling, or the sky.
    UnderCeiling !Target
  deriving (Eq, Ord, Show)

-- | One pair swept, in one tree.
data Change = Change
  { changedHeading :: !Heading
  , changedCorner :: !CornerId
  , sweptTo :: !CornerId
  , foundBy :: !Way
  , search :: !(Maybe Search)
  -- ^ Nothing where the remaining rays are solid.
  }
  deriving (Eq, Show)

-- | How the tangent from a corner was searched.
data Search = Search
  { passed :: ![CornerId]
  -- ^ The near set: the corners of a chain before the one that the tangent touches, the leaf's first.
  , edgesTested :: !Int
  -- ^ Of how many tree edges it was asked whether they hide their targets.
  , touching :: !Target
  -- ^ The next target of the corner.
  }
  deriving (Eq, Show)

-- | The tree without tree edges: only the sides arrive.
bareTree :: Scene -> Heading -> Tree
bareTree scene way = Tree way Map.empty (foldl' withSide Map.empty sidesAhead) Set.empty Map.empty
  where
    sidesAhead = [(p, q) | p <- corners scene, q <- besides scene p, comesBefore way p q]
    withSide lists (p, q) = arriving scene way (ToCorner q) p lists

-- | Makes the tree edge of a corner the leaf of its chain. /Requires/ that so is what arrives there last.
separate :: Tree -> CornerId -> Tree
separate tree p = case lastArrival tree (ToCorner p) of
  Just e | p `Set.member` linked tree -> cut tree p e
  _ -> tree

-- | The tree edge of p has been swept: finds the next one. See Note [Next pair].
advance :: Scene -> Tree -> CornerId -> (Tree, Change)
advance scene tree p = case cornerAhead tree p of
  Nothing -> broken "what is swept is a tree edge" (show p)
  Just q -> case aim scene bare p q way of
    Nothing -> (bare, change Nothing)
    Just (first, below) -> (attach scene opened p (touching tangent), change (Just tangent))
      where
        (opened, tangent) = settle scene bare p first below
    where
      change = Change (heading tree) p q way
      bare = release scene tree p q
      way = wayPast scene bare p q

-- | The tree without the edge from p to q. That is the leaf of its chain, which is cut where it goes on beyond q.
release :: Scene -> Tree -> CornerId -> CornerId -> Tree
release scene tree p q = relink scene bare q
  where
    atQ = ToCorner q
    apart = if q `Set.member` linked tree && lastArrival tree atQ == Just p then cut tree q p else tree
    bare =
      apart
        { targets = Map.delete p (targets apart)
        , arrivals = if q `elem` besides scene p then arrivals apart else Map.adjust without atQ (arrivals apart)
        , otherEnd = Map.delete p (otherEnd apart)
        }
    without = Map.delete (rankOf scene (heading tree) atQ p)

-- | What the ray of p is up against when it has turned past q.
wayPast :: Scene -> Tree -> CornerId -> CornerId -> Way
wayPast scene tree p q
  | nextCorner scene p == q && previousCorner scene p /= q = BesideSolid
  | x /= p && turned scene p q x == LeftTurn = if goesTo tree q x then AlongSide x else UnderSide (sideFrom x)
  | otherwise = case Map.lookup q (targets tree) of
      Just (ToCorner y) -> AlongEdge y
      Just roof -> UnderCeiling roof
      Nothing -> broken "a ray that passes a corner finds its tree edge" (show (p, q))
  where
    -- Solid is on the left of the way from x to q: where two sides of q are in the way, this one is met first.
    x = previousCorner scene q
    sideFrom (CornerId c) = SideId c

-- | What the ray would meet if no chain hid it, and what arrives there next below it.
aim :: Scene -> Tree -> CornerId -> CornerId -> Way -> Maybe (Target, Maybe CornerId)
aim scene tree p q way = case way of
  BesideSolid
    | goesTo tree p r && turned scene p q r /= RightTurn -> Just (ToCorner r, Nothing)
    | otherwise -> Nothing
    where
      r = previousCorner scene p
  AlongSide x -> Just (ToCorner x, before' (ToCorner x))
  AlongEdge x -> Just (ToCorner x, before' (ToCorner x))
  UnderSide s -> Just (underCeiling (ToCeiling s) (lastArrival tree (ToCeiling s)))
  UnderCeiling roof -> Just (underCeiling roof (before' roof))
  where
    before' t = snd <$> Map.lookupLT (rankOf scene (heading tree) t q) (Map.findWithDefault Map.empty t (arrivals tree))
    -- Going back to the left along a ceiling: to the last corner under it, or else to its left end.
    underCeiling roof below = case (below, roof) of
      (Just e, _) | isAhead e -> (roof, below)
      (_, ToCeiling (SideId a)) | end <- CornerId a, isAhead end -> (ToCorner end, lastArrival tree (ToCorner end))
      _ -> (roof, below)
    isAhead c = goesTo tree p c && not (samePlace scene p c)

-- | Follows the tangent from p to the chain whose last edge arrives, from below the ray of p, at what p aims at, if
-- that hides it: the corner where the tangent touches the chain is found, and the chain is cut there. Where nothing
-- hides what p aims at, that is found itself. The chain is searched from its leaf on.
settle :: Scene -> Tree -> CornerId -> Target -> Maybe CornerId -> (Tree, Search)
settle scene tree p first below = case below of
  Just top
    | Map.lookup top (targets tree) /= Just first -> unhidden 0
    | hides scene tree top p -> onward [] leaf
    | otherwise -> unhidden 1
    where
      leaf = Map.findWithDefault top top (otherEnd tree)
      onward near c
        | c /= top && not (hides scene tree c p), Just c' <- cornerAhead tree c = onward (c : near) c'
        | otherwise = (apart, Search (reverse near) (length near + 2) (ToCorner c))
        where
          apart = if null near then tree else cut tree c leaf
  Nothing -> unhidden 0
  where
    unhidden tests = (tree, Search [] tests first)

-- | Does the tree edge of s hide its target from p? One from the place of p never does: it lies in another cone of free
-- space there.
hides :: Scene -> Tree -> CornerId -> CornerId -> Bool
hides scene tree s p = goesTo tree p s && not (samePlace scene p s) && isAbove
  where
    isAbove = maybe True (\t -> turned scene s t p /= RightTurn) (cornerAhead tree s)

-- | Gives p this target.
attach :: Scene -> Tree -> CornerId -> Target -> Tree
attach scene tree p t = foldl' (relink scene) (grownBy scene tree p t) ([c | ToCorner c <- [t]] <> [p])

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

-- | The lowest arrival.
lastArrival :: Tree -> Target -> Maybe CornerId
lastArrival tree t = Map.lookup t (arrivals tree) >>= fmap snd . Map.lookupMax

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

-- | The corners at the other ends of the two sides of a corner.
besides :: Scene -> CornerId -> [CornerId]
besides scene c = [nextCorner scene c, previousCorner scene c]

-- | Is the second corner ahead of the first, seen by the heading?
goesTo :: Tree -> CornerId -> CornerId -> Bool
goesTo tree = comesBefore (heading tree)

comesBefore :: Heading -> CornerId -> CornerId -> Bool
comesBefore way (CornerId p) (CornerId q) = before way p q

turned :: Scene -> CornerId -> CornerId -> CornerId -> Turn
turned scene (CornerId a) (CornerId b) (CornerId c) = turn (scenePoints scene) a b c
