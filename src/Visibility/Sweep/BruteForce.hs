-- | All vertices of the visibility complex by trying every pair of corners: the oracle of the sweeps.
--
-- Written from the definition, in integers, and sharing nothing with the sweeps but the scene and the type of vertices.
module Visibility.Sweep.BruteForce
  ( bruteForce
  , isElementary
  ) where

import qualified Data.Map.Strict as Map
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Sweep.Vertex

-- | All vertices, ordered by their corners.
--
-- /Cost/ O(n³).
bruteForce :: Scene -> [Vertex]
bruteForce scene =
  [ Vertex p q (continuation p q)
  | (p, q) <- pairs
  , null [o | (o, p') <- pairs, p' == p, collinear o p q]
  ]
  where
    pairs = [(p, q) | p <- corners scene, q <- corners scene, p < q, isElementary scene p q]
    onward = Map.fromListWith (<>) [(p, [q]) | (p, q) <- pairs]
    collinear = turned Collinear scene
    -- The elementary pairs that go on along the line beyond q.
    continuation p q = case [r | r <- Map.findWithDefault [] q onward, collinear p q r] of
      r : _ -> r : continuation q r
      [] -> []

-- | Is the open segment from p to q, p to the left of q, in free space, without a corner on it, and across no thin
-- wall?
--
-- /Cost/ O(n).
isElementary :: Scene -> CornerId -> CornerId -> Bool
isElementary scene p q =
  isFree p q && isFree q p && not (any blocksAsCorner (corners scene)) && not (any blocksAsSide (sides scene))
  where
    -- Does the ray from a towards b start in free space? It may run along a side.
    isFree a b
      | isWallCorner scene a = True
      | otherwise = not (insideWedge scene a b)
    blocksAsCorner r = r /= p && r /= q && p < r && r < q && turned Collinear scene p q r
    blocksAsSide s = separated p q a b && separated a b p q
      where
        a = sideStart s
        b = sideEnd scene s
    -- Do c and d lie strictly on different sides of the line through a and b?
    separated a b c d =
      (turned LeftTurn scene a b c && turned RightTurn scene a b d)
        || (turned RightTurn scene a b c && turned LeftTurn scene a b d)

-- | Does the ray from a corner towards another enter the solid there? The solid lies between the side to the following
-- corner and, counter-clockwise from it, the side to the preceding one.
insideWedge :: Scene -> CornerId -> CornerId -> Bool
insideWedge scene c towards = case directionTurn to from of
  LeftTurn -> left to ray && left ray from
  RightTurn -> not (atMost ray to && atMost from ray)
  Collinear -> left to ray
  where
    CornerId i = c
    heading (CornerId j) = direction (scenePoints scene) i j
    to = heading (nextCorner scene c)
    from = heading (previousCorner scene c)
    ray = heading towards
    left a b = directionTurn a b == LeftTurn
    -- For a reflex corner the free cone runs counter-clockwise from the preceding side to the following one, less than
    -- 180°.
    atMost a b = directionTurn a b /= RightTurn

-- | Is the turn from a over b to c of this kind? In integers, whatever arithmetic the scene is under.
turned :: Turn -> Scene -> CornerId -> CornerId -> CornerId -> Bool
turned wanted scene a b c = directionTurn (heading a b) (heading a c) == wanted
  where
    heading i j = let Vector2 x y = difference (cornerAt scene i) (cornerAt scene j) in Direction x y
