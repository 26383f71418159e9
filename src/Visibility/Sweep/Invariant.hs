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
import Visibility.Sweep.HorizonTree.Frame
import Visibility.Sweep.HorizonTree.Table
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
        (isPending state == flagged (U.toList (pending state)))
    ]
  where
    trees = [(Rightward, rightTree state), (Leftward, leftTree state)]
    flagged ps = U.replicate (cornerCount scene) 0 U.// [(fromIntegral p, 1) | p <- ps]

-- | The laws of one tree.
treeViolations :: Scene -> (Heading, Table) -> [Violation]
treeViolations scene (heading, tree) =
  concatMap corner [0 .. n - 1] <> concatMap list lists <> concatMap chain [0 .. n - 1]
  where
    f = frame (sceneTables scene) heading
    n = cornerCount scene
    lists = skyList n : map cornerList [0 .. n - 1] <> map ceilingList [0 .. n - 1]
    roof = U.map fromIntegral (case heading of Rightward -> ceilings vertical; Leftward -> floors vertical)
    vertical = verticalSweep scene
    place law p = law <> ", " <> show heading <> " tree at " <> p
    next p = let CornerId q = nextCorner scene (CornerId p) in q
    previous p = let CornerId q = previousCorner scene (CornerId p) in q
    forwardSides p = [q | q <- [next p, previous p], before heading p q]

    corner p =
      concat
        [ law "a corner has a node iff it has a target" (show (own, into)) ((own == noNode) == (into == noList))
        , law "a node comes from its corner" (show own) (own == noNode || sourceAt tree own == p)
        , law "a tree edge stands in the list of its target" (show (own, into)) $
            into == noList || own `elem` members into
        , case targetOf scene tree (CornerId p) of
            ToCorner (CornerId q) ->
              law "a tree edge is an elementary pair that leads forward" (show q) $
                before heading p q && isElementary scene (CornerId (min p q)) (CornerId (max p q))
            ToCeiling (SideId s) -> law "a ceiling is what the upward ray meets" (show s) (roof U.! p == s)
            ToSky -> law "the sky is what the upward ray meets" "" (roof U.! p == skyCode scene)
            NoTarget -> []
        , law "a side has its marker in the list of its later corner" "" $
            and [markerOf f p q `elem` members (cornerList q) | q <- forwardSides p]
        , law "corners are linked where their edges continue each other" "" $
            (at tree (link p) == 1) == linkable f tree p
        ]
      where
        law name = ensure (place name (show p))
        own = nodeAt tree (edge p)
        into = listAt tree (target p)

    -- The nodes of a list, from the first on; cut off where it is longer than any list can be.
    members l = take (2 * n + 1) (walk (nodeAt tree (first l)))
    walk node = if node == noNode then [] else node : walk (nodeAt tree (upper node))

    list l =
      concat
        [ law "a list is linked both ways" $
            map (nodeAt tree . lower) inside == take (length inside) (noNode : inside)
              && nodeAt tree (final l) == foldl (\_ node -> node) noNode inside
        , law "a list is in ascending order" (and (zipWith ascending inside (drop 1 inside)))
        , law "a list holds the tree edges to its target and the markers of its sides" (all belongs inside)
        ]
      where
        law name = ensure (place name (show l)) (show inside)
        inside = members l
        -- Of the two faces of one piece of a wall, the upper one comes first.
        ascending a b
          | isCornerList l = case turn (scenePoints scene) (listOwner l) (sourceAt tree a) (sourceAt tree b) of
              LeftTurn -> True
              Collinear -> previous (sourceAt tree a) == listOwner l && next (sourceAt tree b) == listOwner l
              RightTurn -> False
          | otherwise = before heading (sourceAt tree a) (sourceAt tree b)
        belongs node
          | nodeAt tree (edge (sourceAt tree node)) == node = listAt tree (target (sourceAt tree node)) == l
          | otherwise = not (isEdgeNode node) && cornerList (laterEnd node) == l
    laterEnd node = let i = nodeOwner node in if sourceAt tree node == i then next i else i

    -- The chain with its top at the tree edge of p.
    chain p
      | own == noNode || continued = []
      | otherwise =
          ensure (place "top and leaf of a chain know each other" (show p)) (show (own, deepest)) $
            nodeAt tree (leaf own) == deepest && nodeAt tree (top deepest) == own
      where
        own = nodeAt tree (edge p)
        into = listAt tree (target p)
        continued = isCornerList into && at tree (link (listOwner into)) == 1 && nodeAt tree (final into) == own
        deepest = descend (2 * n) own
        descend :: Int -> Node -> Node
        descend count e
          | count > 0, at tree (link s) == 1 = descend (count - 1) (nodeAt tree (final (cornerList s)))
          | otherwise = e
          where
            s = sourceAt tree e

-- | The corner that a corner's tree edge leads to, where it leads to one.
cornerAhead :: Scene -> Table -> Int -> Maybe Int
cornerAhead scene tree p = case targetOf scene tree (CornerId p) of
  ToCorner (CornerId q) -> Just q
  _ -> Nothing

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
    segments =
      [ (min p q, max p q)
      | tree <- [rightTree state, leftTree state]
      , CornerId p <- corners scene
      , Just q <- [cornerAhead scene tree p]
      ]
    side = turn (scenePoints scene)
    apart a b c d = side a b c /= Collinear && side a b d == opposite (side a b c)

-- | Wherever a pair is the next of both its corners and no unswept pair at them has a lesser or the same slope, one of
-- the two is pending: so the sweep cannot stop too early. Where the pair is along one face of a wall whose other face
-- leads to another corner, that must be so of the pair along the other face, too, and its corner counts as well.
readiness :: Scene -> Sweep -> [Violation]
readiness scene state =
  [ Violation "a pair that may be swept has a pending corner" (show (p, q))
  | CornerId p <- corners scene
  , Just q <- [right p]
  , isReady (p, q)
  , all isReady (twins p q)
  , and [isPending state U.! c == 0 | (a, b) <- (p, q) : twins p q, c <- [a, b]]
  ]
  where
    right = cornerAhead scene (rightTree state)
    left = cornerAhead scene (leftTree state)
    isReady (p, q) =
      and [any (isNext p q) (right p), any (isNext q p) (left q), all (later p q) (right q), all (later q p) (left p)]
    -- Of a wall's two faces one is swept first.
    isNext p q next = next == q || (isSplit p && all (`elem` besides p) [q, next])
    twins p q =
      [(p, r) | isSplit p, q `elem` besides p, r <- besides p]
        <> [(r, q) | isSplit q, p `elem` besides q, r <- besides q]
    isSplit = isSplitEnd scene . CornerId
    besides c = [d | CornerId d <- [nextCorner scene (CornerId c), previousCorner scene (CornerId c)]]
    later a b c = turn (scenePoints scene) a b c == LeftTurn
