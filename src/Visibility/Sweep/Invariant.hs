-- | What must hold of the state of the topological sweep before and after every step.
module Visibility.Sweep.Invariant
  ( violations
  ) where

import qualified Data.Vector.Unboxed as U
import Visibility.Exact.Predicate
import Visibility.Law
import Visibility.Scene
import Visibility.Sweep.BruteForce (isElementary)
import Visibility.Sweep.HorizonTree
import Visibility.Sweep.Topological
import Visibility.Sweep.Vertical

-- | All laws that a state breaks; none for a state that the sweep reaches.
--
-- /Cost/ O(n³): for tests.
--
-- /Source/ the lemmas on planarity and readiness of horizon trees, Rivière; the chains are this project's.
violations :: Scene -> Sweep -> [Violation]
violations scene state =
  concat
    [ concatMap (treeViolations scene) trees
    , planarity scene state
    , readiness scene state
    , ensure
        "pending corners are flagged"
        (show (pending state))
        (isPending state == U.replicate (cornerCount scene) 0 U.// [(p, 1) | p <- pending state])
    ]
  where
    trees = [(Rightward, rightTree state), (Leftward, leftTree state)]

type Table = U.Vector Int

-- | The laws of one tree.
treeViolations :: Scene -> (Heading, Tree Table) -> [Violation]
treeViolations scene (heading, tree) = concat [concatMap corner [0 .. n - 1], concatMap list [0 .. 2 * n], concatMap chain [0 .. n - 1]]
  where
    f = frame scene heading
    n = cornerCount scene
    roof = ceilings (verticalSweep scene heading)
    at law place = law <> ", " <> show heading <> " tree at " <> show place
    next p = let CornerId q = nextCorner scene (CornerId p) in q
    previous p = let CornerId q = previousCorner scene (CornerId p) in q
    forwardSides p = [q | q <- [next p, previous p], before heading p q]

    corner p =
      concat
        [ ensure (at "a corner has a node iff it has a target" p) (show (node, target)) ((node == none) == (target == none))
        , ensure (at "a node comes from its corner" p) (show node) (node == none || nodeSource f node == p)
        , ensure (at "a tree edge stands in the list of its target" p) (show (node, target)) (target == none || node `elem` members target)
        , case targetOf scene tree (CornerId p) of
            ToCorner (CornerId q) ->
              ensure (at "a tree edge is an elementary pair that leads forward" p) (show q) $
                before heading p q && isElementary scene (CornerId (min p q)) (CornerId (max p q))
            ToCeiling (SideId s) -> ensure (at "a ceiling is what the upward ray meets" p) (show s) (roof U.! p == s)
            ToSky -> ensure (at "the sky is what the upward ray meets" p) "" (roof U.! p == skyCode scene)
            NoTarget -> []
        , ensure (at "a side has its marker in the list of its later corner" p) "" $
            and [markerOf f p q `elem` members q | q <- forwardSides p]
        , ensure (at "corners are linked where their edges continue each other" p) "" ((links tree U.! p == 1) == linkable f tree p)
        ]
      where
        node = nodes tree U.! p
        target = targets tree U.! p

    -- The nodes of a list, from the first on; cut off where it is longer than any list can be.
    members t = take (2 * n + 1) (walk (firstIn tree U.! t))
    walk node = if node == none then [] else node : walk (upperNode tree U.! node)

    list t =
      concat
        [ ensure (at "a list is linked both ways" t) (show inside) $
            map (lowerNode tree U.!) inside == take (length inside) (none : inside)
              && lastIn tree U.! t == (if null inside then none else last inside)
        , ensure (at "a list is in ascending order" t) (show inside) (and (zipWith ascending sources (drop 1 sources)))
        , ensure (at "a list holds the tree edges to its target and the markers of its sides" t) (show inside) (all belongs inside)
        ]
      where
        inside = members t
        sources = map (nodeSource f) inside
        ascending a b
          | t < n = turn (scenePoints scene) t a b == LeftTurn
          | otherwise = before heading a b
        belongs node
          | isTreeEdge f tree node = targets tree U.! nodeSource f node == t
          | otherwise = node >= n && laterEnd node == t
    laterEnd node = let i = node - n in if nodeSource f node == i then next i else i

    -- The chain with its top at the tree edge of p.
    chain p
      | node == none || target == none || (target < n && links tree U.! target == 1 && lastIn tree U.! target == node) = []
      | otherwise =
          ensure (at "top and leaf of a chain know each other" p) (show (node, leaf)) $
            leaves tree U.! node == leaf && tops tree U.! leaf == node
      where
        node = nodes tree U.! p
        target = targets tree U.! p
        leaf = descend (2 * n) node
        descend :: Int -> Int -> Int
        descend steps e
          | steps > 0, links tree U.! s == 1 = descend (steps - 1) (lastIn tree U.! s)
          | otherwise = e
          where
            s = nodeSource f e

-- | No two tree edges cross, whichever trees they belong to.
planarity :: Scene -> Sweep -> [Violation]
planarity scene state =
  [ Violation "tree edges do not cross" (show ((a, b), (c, d)))
  | (a, b) <- segments
  , (c, d) <- segments
  , (a, b) < (c, d)
  , apart a b c d
  , apart c d a b
  ]
  where
    n = cornerCount scene
    segments = [(min p q, max p q) | tree <- [rightTree state, leftTree state], (p, q) <- zip [0 ..] (U.toList (targets tree)), q >= 0, q < n]
    side = turn (scenePoints scene)
    apart a b c d = side a b c /= Collinear && side a b d == opposite (side a b c)

-- | Wherever a pair is the next of both its corners and no unswept pair at them has a lesser slope, one of the two is pending: so the
-- sweep cannot stop too early.
readiness :: Scene -> Sweep -> [Violation]
readiness scene state =
  [ Violation "a pair that may be swept has a pending corner" (show (p, q))
  | p <- [0 .. n - 1]
  , let q = right U.! p
  , q >= 0
  , q < n
  , left U.! q == p
  , notBefore (right U.! q) (turnOf p q)
  , notBefore (left U.! p) (turnOf q p)
  , isPending state U.! p == 0 && isPending state U.! q == 0
  ]
  where
    n = cornerCount scene
    right = targets (rightTree state)
    left = targets (leftTree state)
    turnOf = turn (scenePoints scene)
    -- Only strictly later neighbours: a collinear one makes a longer line, which may have to wait.
    notBefore t turning = t < 0 || t >= n || turning t == LeftTurn
