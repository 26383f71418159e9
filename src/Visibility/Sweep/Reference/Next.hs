-- | How the next pair of a corner is found from a horizon tree, without a test of visibility.
--
-- /Source/ Rivière, Topologically sweeping the visibility complex of polygonal scenes. The proofs are this project's.
module Visibility.Sweep.Reference.Next
  ( advance
    -- * What a step does
  , Change (..)
  , Search (..)
  , Way (..)
  , hides
  ) where

import Data.List (foldl')
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Visibility.Exact.Predicate
import Visibility.Law (broken)
import Visibility.Scene
import Visibility.Sweep.Reference.Tree
import Visibility.Sweep.Vertical

-- Note [Next pair]
-- ~~~~~~~~~~~~~~~~
-- The pair (p, q) has just been swept in the right tree. The ray of p turns on to the left, past q.
--
-- /BesideSolid./ The side (p, q) has its solid on the left. Turning on, the ray is in the solid until it meets the
-- other side of p. If that leads to the right and is not below (p, q), it is the next pair: nothing lies between a
-- corner and the end of a side of it. If not, the solid goes on to the vertical.
--
-- /The front./ Otherwise it is free just above (p, q), all along, since no side ends on the pair. Turn around q
-- clockwise from the direction back to p, by less than 180°: the side of q that is met first is the front. If none is
-- met, q has a tree edge: its rays just above the line are free. Then that edge is the front, or if it is vertical,
-- the vertical and then its ceiling. The sky counts as a ceiling above everything, whose left end is far to the left.
--
-- (N) Let an unswept pair leave to the right, from a point above (p, q) and before the front. It crosses neither (p,
-- q) nor the front. For it would cross a side, which nothing does; or a tree edge, (p, q) or that of q, with less
-- slope than that, against Note [Trees]; or the vertical of q.
--
-- /AlongSide, AlongEdge./ The front leads from q to x. The pair (q, x) is unswept and not on the line, so it has more
-- slope than (p, q), and the path p → q → x turns left. Let p, r₁, …, rₖ, x be its taut path, and Ω the region
-- between both. Slopes do not decrease along the taut path, and are greater than that of (p, q).
-- (1) The next target of p is r₁, or x if k = 0. That pair is unswept, by the order at p. An unswept pair of p with
-- less slope would start into Ω, where no corner is, and could not leave it, by (N).
-- (2) Each (rᵢ, rᵢ₊₁) is a tree edge. It is unswept, by the order at r₁, at r₂, and so on. An unswept pair of rᵢ with
-- less slope would start into Ω, and could end in q only; but rᵢ is above (p, q), so (rᵢ, q) has less slope than (p,
-- q), and is swept.
-- (3) No tree edge and no side arrives at rᵢ out of Ω, nor at x between the taut path and the front. It would come
-- from a corner on the boundary of Ω, since it can cross neither the front nor (p, q). Not from one of the taut path,
-- which is convex. Not from q: its tree edge does not lead above the front, and it has no side before the front.
-- (4) No side leads from rᵢ into Ω: it could end in q only, and would be met before the front. By (2) to (4), r₂, …,
-- rₖ may be linked. They are above the line being swept, so they are linked. So r₁ → … → rₖ → x is the upper end of a
-- chain. Its top is the arrival at x just before the front: it is not the last arrival there, so the chain ends. All
-- these edges hide their ends from p, by convexity. An edge further down the chain ends in r₁ with less slope than
-- (p, r₁), by (3), and does not hide; those before it do not either, since slopes do not decrease. So the first edge
-- from the leaf on that hides begins at r₁. If k = 0, what arrives at x just before the front has less slope than (p,
-- x) by (3), does not hide, and x is found. One chain is looked at: the last arrival at r₁ does not hide it from p.
--
-- /UnderSide, UnderCeiling./ The front is a side s = (a, q), or the vertical from q up to a point q' of its ceiling s
-- = (a, b); in the first case let q' = q. The line of s is above p: in the second case the rays of q above the line
-- of (p, q) meet no corner, so they all meet s, and s has no more slope than (p, q). Let Z be the region above (p, q)
-- and below s, to the right of p and of a, to the left of q. No pair comes into it from the right. If there is a
-- corner in Z, take the rightmost one, r. To the right of it Z is free, so no unswept pair leaves r: it would leave Z
-- against (N), or end in q and be swept, as in (2). So r has a vertical edge to a point r' of s. It is the nearest
-- one: another one between r and q would come from below (p, q), and cross it, which was unswept just now. So p aims
-- at s. The path p → q → q' → r' goes left around Z; it makes a convex polygon with r'p, and its taut path goes to
-- the right up to r, since no corner is further right. So (1) to (4) hold with r for rₖ, and the vertical edge of r
-- is the top. If there is none, there is no vertical edge to s from between p and q either. If a is not to the right
-- of p, no unswept pair leaves p, by (N), and s is its target. Otherwise p aims at a, and the path p → q → q' → a has
-- a taut path that goes to the right. (1) to (4) hold with a for x, the arrival just before the front being the last
-- one at a, since (a, b) leaves it. That is a top, as a is not linked: (a, b) is swept and below the tree edge of a.
-- For if q = b, it has less slope than (p, q). Else all pairs that leave q are swept, so the last pair of the taut
-- path of q → q' → b is swept, and it arrives at b with more slope than (a, b).

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

-- | The tree edge of p has been swept: finds the next one. See Note [Next pair].
advance :: Scene -> Tree -> CornerId -> (Tree, Change)
advance scene tree p = case cornerAhead tree p of
  Nothing -> broken "what is swept is a tree edge" (show p)
  Just q -> case aim scene bare p q way of
    Nothing -> (bare, change Nothing)
    Just (first, justBefore) -> (attach scene opened p (touching tangent), change (Just tangent))
      where
        (opened, tangent) = settle scene bare p first justBefore
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

-- | What the ray aims at: what it would meet if no chain hid that; and what arrives there just before the front.
aim :: Scene -> Tree -> CornerId -> CornerId -> Way -> Maybe (Target, Maybe CornerId)
aim scene tree p q way = case way of
  BesideSolid
    | goesTo tree p r && turned scene p q r /= RightTurn -> Just (ToCorner r, Nothing)
    | otherwise -> Nothing
    where
      r = previousCorner scene p
  AlongSide x -> Just (ToCorner x, arrivalBefore scene tree (ToCorner x) q)
  AlongEdge x -> Just (ToCorner x, arrivalBefore scene tree (ToCorner x) q)
  UnderSide s -> Just (underCeiling (ToCeiling s) (lastArrival tree (ToCeiling s)))
  UnderCeiling roof -> Just (underCeiling roof (arrivalBefore scene tree roof q))
  where
    -- Going back to the left along a ceiling: to the last corner under it, or else to its left end.
    underCeiling roof justBefore = case (justBefore, roof) of
      (Just e, _) | isAhead e -> (roof, justBefore)
      (_, ToCeiling (SideId a)) | end <- CornerId a, isAhead end -> (ToCorner end, lastArrival tree (ToCorner end))
      _ -> (roof, justBefore)
    isAhead = goesTo tree p

-- | What arrives just before the front may hide what p aims at. If it does, it is the last edge of a chain: this is
-- gone along from its leaf to the first edge that hides, the next target is the corner at which that begins, and the
-- chain is cut there. If not, the next target is what p aims at.
settle :: Scene -> Tree -> CornerId -> Target -> Maybe CornerId -> (Tree, Search)
settle scene tree p first justBefore = case justBefore of
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

-- | Does the tree edge of s hide its target from p? Of an edge that leaves the place of p this is never asked; see Note
-- [Corners in one place].
hides :: Scene -> Tree -> CornerId -> CornerId -> Bool
hides scene tree s p = goesTo tree p s && isAbove
  where
    isAbove = maybe True (\t -> turned scene s t p /= RightTurn) (cornerAhead tree s)

-- | Gives p this target.
attach :: Scene -> Tree -> CornerId -> Target -> Tree
attach scene tree p t = foldl' (relink scene) (grownBy scene tree p t) ([c | ToCorner c <- [t]] <> [p])
