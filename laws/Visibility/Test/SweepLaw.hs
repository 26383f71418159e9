{-# LANGUAGE BangPatterns #-}

-- | What must hold of the state of the topological sweep before and after every step, said of the state of
-- "Visibility.Sweep.Reference".
module Visibility.Test.SweepLaw
  ( violations
  , searchWork
  ) where

import Data.List (foldl', nub, sort, unfoldr)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.Predicate
import Visibility.Law
import Visibility.Scene
import Visibility.Sweep.Reference
import Visibility.Sweep.Vertical
import Visibility.Test.BruteForce (isElementary)

-- | All laws that a state breaks; none for a state that the sweep reaches.
--
-- /Cost/ O(n³): for tests.
--
-- /Source/ the lemmas on planarity and readiness of horizon trees, Rivière; the chains are this project's.
violations :: Scene -> State -> [Violation]
violations scene state =
  concat
    [ concatMap (treeViolations scene . (`treeOf` state)) [Rightward, Leftward]
    , planarity scene state
    , readiness scene state
    , ensure "each pending corner is on the stack once" (show (pending state)) $
        sort (pending state) == Set.toAscList (isPending state)
    ]

-- | The laws of one tree.
treeViolations :: Scene -> Tree -> [Violation]
treeViolations scene tree =
  concatMap corner (corners scene) <> concatMap list (Map.toList (arrivals tree)) <> chains
  where
    way = heading tree
    vertical = verticalSweep scene
    roof = (case way of Rightward -> ceilings; Leftward -> floors) vertical
    law name place' = ensure (name <> ", " <> show way <> " tree at " <> show place')

    corner p@(CornerId c) =
      concat
        [ law "a tree edge arrives at its target" p (show target) (maybe True (\t -> p `elem` arrivalsAt t) target)
        , law "a side arrives at the later one of its corners" p "" $
            and [p `elem` arrivalsAt (ToCorner q) | q <- besides scene p, isBefore p q]
        , law "corners are linked where their edges continue each other" p "" $
            Set.member p (linked tree) == linkable scene tree p
        , case target of
            Just (ToCorner q) ->
              law "a tree edge is an elementary pair that leads forward" p (show q) $
                isBefore p q && isElementary scene (min p q) (max p q)
            Just (ToCeiling s) -> law "a ceiling is what the upward ray meets" p (show s) (meets (Side s))
            Just ToSky -> law "the sky is what the upward ray meets" p "" (meets Sky)
            Nothing -> []
        ]
      where
        target = Map.lookup p (targets tree)
        meets object = objectOf scene (fromIntegral (roof U.! c)) == Just object

    isBefore (CornerId p) (CornerId q) = before way p q
    arrivalsAt t = maybe [] Map.elems (Map.lookup t (arrivals tree))

    list (t, here) =
      concat
        [ law "arrivals are in ascending order" t (show inside) (and (zipWith ascending inside (drop 1 inside)))
        , law "arrivals are tree edges and sides" t (show inside) (all belongs inside)
        ]
      where
        inside = Map.elems here
        -- Of the two faces of one piece of a wall, the upper one comes first.
        ascending a b = case t of
          ToCorner c -> case turned scene c a b of
            LeftTurn -> True
            Collinear -> previousCorner scene a == c && nextCorner scene b == c
            RightTurn -> False
          _ -> isBefore a b
        belongs p = Map.lookup p (targets tree) == Just t || or [isSide p c && isBefore p c | ToCorner c <- [t]]
        isSide p c = c `elem` besides scene p

    -- The leaf and the top of each chain know each other, and no other corner is the end of one.
    chains =
      ensure ("top and leaf of a chain know each other, " <> show way <> " tree") (show (otherEnd tree)) $
        otherEnd tree == Map.fromList (concat [[(leaf, top), (top, leaf)] | top <- tops, let leaf = leafBelow top])
    tops = [p | (p, t) <- Map.toList (targets tree), not (goesOn p t)]
    goesOn p t = or [Set.member q (linked tree) && lastArrival tree t == Just p | ToCorner q <- [t]]
    leafBelow p = last (take (1 + cornerCount scene) (p : downFrom p))
    downFrom p = case lastArrival tree (ToCorner p) of
      Just e | Set.member p (linked tree) -> e : downFrom e
      _ -> []

-- | No two tree edges cross, whichever trees they belong to.
planarity :: Scene -> State -> [Violation]
planarity scene state =
  [ Violation "tree edges do not cross" (show ((a, b), (c, d)))
  | (a, b) <- segments
  , (c, d) <- segments
  , (a, b) < (c, d)
  , apart a b c d
  , apart c d a b
  ]
  where
    segments =
      nub
        [ (min p q, max p q)
        | tree <- [rightTree state, leftTree state]
        , p <- corners scene
        , Just q <- [cornerAhead tree p]
        ]
    apart a b c d = turned scene a b c /= Collinear && turned scene a b d == opposite (turned scene a b c)

-- | Wherever a pair is the next of both its corners and no unswept pair at them has a lesser or the same slope, one of
-- the two is pending: so the sweep cannot stop too early. Where the pair is along one face of a wall whose other face
-- leads to another corner, that must be so of the pair along the other face, too, and its corner counts as well.
readiness :: Scene -> State -> [Violation]
readiness scene state =
  [ Violation "a pair that may be swept has a pending corner" (show (p, q))
  | p <- corners scene
  , Just q <- [right p]
  , isReady (p, q)
  , all isReady (twins p q)
  , and [Set.notMember c (isPending state) | (a, b) <- (p, q) : twins p q, c <- [a, b]]
  ]
  where
    right = cornerAhead (rightTree state)
    left = cornerAhead (leftTree state)
    isReady (p, q) =
      and [any (isNext p q) (right p), any (isNext q p) (left q), all (later p q) (right q), all (later q p) (left p)]
    -- Of a wall's two faces one is swept first.
    isNext p q next = next == q || (isSplitEnd scene p && all (`elem` besides scene p) [q, next])
    twins p q =
      [(p, r) | isSplitEnd scene p, q `elem` besides scene p, r <- besides scene p]
        <> [(r, q) | isSplitEnd scene q, p `elem` besides scene q, r <- besides scene q]
    later a b c = turned scene a b c == LeftTurn

-- | How many pairs a sweep of the scene has, and how many edges of chains both trees look at in it.
searchWork :: Scene -> (Int, Int)
searchWork scene = foldl' add (0, 0) (concat (unfoldr changed (start scene)))
  where
    changed = fmap (\(_, state) -> (changes state, state)) . step scene
    add (!pairs, !edges) change =
      (if changedHeading change == Rightward then pairs + 1 else pairs, edges + maybe 0 edgesTested (search change))
