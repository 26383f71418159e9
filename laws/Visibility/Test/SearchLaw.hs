-- | What docs/scan-bound.md says of the topological sweep, asked of the reference: of the state after every single
-- event, within vertices too, and of the searches of every corner.
--
-- An event sweeps one pair in one tree, and finds the next pair of its corner. All is said of a heading: a pair leads
-- from its source to its target, which is ahead, and below a line is to the right of it.
module Visibility.Test.SearchLaw
  ( -- * Events
    Pair
  , pairsAhead
  , Moment (..)
  , moments
    -- * Laws
  , stateViolations
  , searchViolations
  , historyViolations
  ) where

import Data.Function (on)
import Data.List (foldl', mapAccumL, sortBy, tails, unfoldr)
import qualified Data.Map.Strict as Map
import Data.Maybe (maybeToList)
import Data.Set (Set)
import qualified Data.Set as Set
import Visibility.Exact.Predicate
import Visibility.Law
import Visibility.Scene
import Visibility.Sweep (Vertex, vertexPairs)
import Visibility.Sweep.Reference
import Visibility.Sweep.Vertical (Heading (..), before)

-- | An elementary pair as a heading sees it: the source, and the target ahead of it.
type Pair = (CornerId, CornerId)

-- | The pairs of some vertices.
pairsAhead :: Scene -> Heading -> [Vertex] -> [Pair]
pairsAhead scene way = map (ahead way) . concatMap (vertexPairs scene)

ahead :: Heading -> Pair -> Pair
ahead Rightward pair = pair
ahead Leftward (p, q) = (q, p)

-- | The state of a tree just after an event.
data Moment = Moment
  { momentTree :: Tree
  , momentSwept :: Set Pair
  , momentChange :: Change
  , momentLine :: Set CornerId
  -- ^ The corners of the vertex under work.
  }

-- | All events of a sweep in one tree, with the trees between the steps and those that the events leave: they must be
-- the same. /Cost/ that of the sweep.
moments :: Scene -> Heading -> ([Moment], [(Tree, Tree)])
moments scene way = (concatMap snd lines', zip (drop 1 trees) (map fst lines'))
  where
    steps = unfoldr (fmap (\(v, s) -> ((v, s), s)) . step scene) (start scene)
    trees = map (treeOf way) (start scene : map snd steps)
    lines' = snd (mapAccumL onLine Set.empty (zip trees (map fst steps)))
    onLine done (tree, vertex) = (Set.union done (Set.fromList pairs), (after, events))
      where
        pairs = inOrder (pairsAhead scene way [vertex])
        apart = foldl' separate tree (map fst (reverse pairs))
        ((after, _), events) = mapAccumL event (apart, done) pairs
        corners' = Set.fromList (concat [[p, q] | (p, q) <- pairs])
        event (grown, swept) pair@(p, _) = ((new, swept'), Moment new swept' change corners')
          where
            (new, change) = advance scene (separate grown p) p
            swept' = Set.insert pair swept
    inOrder = case way of Rightward -> reverse; Leftward -> id

-- | The laws F1 to F4 and Lemma 2, of a state and all pairs of the scene. /Cost/ O(nm).
stateViolations :: Scene -> [Pair] -> Moment -> [Violation]
stateViolations scene pairs moment =
  concat
    [ law "F1, swept pairs have less slope than unswept ones" (concatMap outOfOrder (Map.toList atCorner))
    , law "F2, a tree edge is the first unswept pair" [(b, next b) | b <- corners scene, cornerAhead tree b /= next b]
    , law "F3, lists hold tree edges and sides in order" (if found == expected then [] else [(found, expected)])
    , law "F4, what is linked is linkable" (filter (not . linkable scene tree) (Set.toList (linked tree)))
    , law "F4, what is linkable is linked" (filter isLeftOut (corners scene))
    , law "Lemma 2, an unswept pair that crosses a tree edge has more slope" $
        [ (edge, pair)
        | edge <- edges
        , pair <- filter (`Set.notMember` momentSwept moment) pairs
        , crosses scene edge pair
        , bySlope scene edge pair /= LT
        ]
    ]
  where
    tree = momentTree moment
    way = heading tree
    change = momentChange moment
    (p, q) = (changedCorner change, sweptTo change)
    isSwept pair = Set.member pair (momentSwept moment)
    edges = [(b, t) | (b, ToCorner t) <- Map.toList (targets tree)]
    atCorner = Map.fromListWith (<>) [(b, [pair]) | pair@(s, t) <- pairs, b <- [s, t]]
    -- Unswept pairs for which a swept one comes too early.
    outOfOrder (b, here) =
      [ (b, u, s)
      | s <- take 1 (sortBy (flip (bySlope scene)) (filter isSwept here))
      , u <- filter (not . isSwept) here
      , not (bySlope scene s u == LT || bySlope scene s u == EQ && isException b u)
      ]
    isException b u@(_, t) =
      all onLine [fst u, t] && (t == b && samePlace scene b p || isUpperFace u && samePlaces u (p, q))
    samePlaces (a, b) (c, d) = samePlace scene a c && samePlace scene b d
    onLine c = turned scene p q c == Collinear
    isUpperFace (s, t) = previousCorner scene s == t && nextCorner scene p == q
    leaving = Map.fromListWith (<>) [(s, [pair]) | pair@(s, _) <- filter (not . isSwept) pairs]
    next b = fmap snd (Map.lookup b leaving >>= firstOf . sortBy (bySlope scene <> lowerFirst))
    firstOf xs = if null xs then Nothing else Just (foldr const (p, q) xs)
    lowerFirst a b = compare (not (isLower a)) (not (isLower b))
    isLower (s, t) = nextCorner scene s == t
    found = Map.filter (not . null) (Map.map Map.elems (arrivals tree))
    expected = Map.mapWithKey inOrder (Map.fromListWith Set.union (edgeArrivals <> sideArrivals))
    edgeArrivals = [(t, Set.singleton s) | (s, t) <- Map.toList (targets tree)]
    sideArrivals = [(ToCorner t, Set.singleton s) | s <- corners scene, t <- besides scene s, isAhead way s t]
    inOrder (ToCorner t) sources = map fst (sortBy (bySlope scene <> lowerLast) [(s, t) | s <- Set.toList sources])
    inOrder _ sources = (case way of Rightward -> id; Leftward -> reverse) (Set.toList sources)
    lowerLast a b = compare (isLower a) (isLower b)
    isLeftOut c =
      linkable scene tree c && Set.notMember c (linked tree)
        && not (Set.member c (momentLine moment) && (samePlace scene c p || isAhead way c p))

-- | Lemmas 3 and 4, of the search of an event and all pairs of the scene. /Cost/ O(n) for each corner passed.
searchViolations :: Scene -> Set Pair -> Moment -> [Violation]
searchViolations scene pairs moment =
  concat
    [ law "Lemma 3, nothing hides the target that is found" $
        [ e
        | e <- take 1 previous
        , Map.lookup e (targets tree) == target
        , not (samePlace scene e p)
        , hides scene tree e p
        ]
    , law "a corner passed is seen" [c | c <- near, Set.notMember (facing c) pairs]
    , law "Lemma 4, the corner is below the edges passed" $
        [e | e@(c, d) <- edges, turned scene c d p /= RightTurn]
    , law "Lemma 4, the fan is empty" [(e, c) | e <- edges, c <- corners scene, isInside e c]
    , law "Lemma 4, pairs from behind are swept" $
        [c | c <- near, isAhead way c p, Set.notMember (c, p) (momentSwept moment)]
    , law "the edge found is the last one, after the chain" $
        [t | not (null near), t <- maybeToList target, arrivalsAt t /= ends]
    ]
  where
    tree = momentTree moment
    way = heading tree
    p = changedCorner (momentChange moment)
    near = maybe [] passed (search (momentChange moment))
    target = fmap touching (search (momentChange moment))
    chain = near <> [t | Just (ToCorner t) <- [target]]
    edges = zip near (drop 1 chain)
    facing c = if isAhead way p c then (p, c) else (c, p)
    previous = drop 1 (dropWhile (/= p) (reverse (maybe [] allArrivals target)))
    ends = take 2 (p : reverse near)
    arrivalsAt t = take 2 (reverse (allArrivals t))
    allArrivals t = maybe [] Map.elems (Map.lookup t (arrivals tree))
    isInside (c, d) v =
      not (any (samePlace scene v) [p, c, d])
        && all (/= RightTurn) [turned scene p d v, turned scene d c v, turned scene c p v]

-- | Lemmas 6 and 7 and the theorem, of all events of one tree and the number of pairs. /Cost/ quadratic in the arcs of
-- each corner.
historyViolations :: Scene -> Heading -> [Pair] -> [Change] -> [Violation]
historyViolations scene way pairs changes' =
  concat
    [ concatMap ofCorner (Map.toList nearSets)
    , law "the theorem, at most 8m edges are asked" $
        [asked | let asked = sum (map tests changes'), asked > 8 * length pairs]
    ]
  where
    nearSets = Map.fromListWith (<>) [(changedCorner c, [near]) | c <- changes', Just near <- [passed <$> search c]]
    tests = maybe 0 edgesTested . search
    count ends = Map.fromListWith (+) [(ends pair, 1 :: Int) | pair <- pairs]
    (leaving, arriving) = (count fst, count snd)
    ofCorner (p, sets) =
      concat
        [ law "Lemma 6, two events share at most one corner" $
            [(p, a, b) | (a, b) <- twos sets, length (filter (`elem` b) a) > 1]
        , law "Lemma 7, arcs do not cross" $
            [(p, a, b) | (as, bs) <- twos (map arcs sets), a <- as, b <- bs, interleave a b || interleave b a]
        , law "the theorem, near sets are bounded by pairs" $
            [(p, total) | let total = sum (map length sets), total > bound]
        ]
      where
        bound = 4 * Map.findWithDefault 0 p leaving + 2 * Map.findWithDefault 0 p arriving
        arcs near = [(angle b, angle a) | (a, b) <- zip near (drop 1 near), isAhead way p a == isAhead way p b]
        angle c = length (takeWhile (/= c) around)
        -- All corners by angle, counterclockwise from straight down; a wall's two faces in this order, too.
        around = sortBy (onSide <> bySlope' <> faceFirst) (Set.toList (Set.fromList (concat sets)))
        onSide = compare `on` (not . isAhead way p)
        bySlope' = bySlope scene `on` (,) p
        faceFirst = compare `on` ((/= nextCorner scene p) :: CornerId -> Bool)
    interleave (a, b) (c, d) = a < c && c < b && b < d
    twos xs = [(x, y) | x : rest <- tails xs, y <- rest]

law :: Show a => String -> [a] -> [Violation]
law name found = [Violation name (show x) | x <- take 1 found]

isAhead :: Heading -> CornerId -> CornerId -> Bool
isAhead way (CornerId p) (CornerId q) = before way p q

-- | Two pairs by their slopes.
bySlope :: Scene -> Pair -> Pair -> Ordering
bySlope scene a b = compareDirections (towards' a) (towards' b)
  where
    towards' (CornerId s, CornerId t) = direction (scenePoints scene) (min s t) (max s t)

-- | Do two segments cross in a point inside both?
crosses :: Scene -> Pair -> Pair -> Bool
crosses scene (a, b) (c, d) = apart a b c d && apart c d a b
  where
    apart s t u v = turned scene s t u /= Collinear && turned scene s t v == opposite (turned scene s t u)
