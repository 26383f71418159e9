-- | All vertices of the visibility complex by trying every pair of corners: the oracle of the sweeps.
--
-- Written from the definition, in integers, and sharing nothing with the sweeps but the scene and the type of vertices.
module Visibility.Test.BruteForce
  ( bruteForce
  , isElementary
  ) where

import Data.List (sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)
import qualified Data.Set as Set
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Sweep.Vertex

-- | All vertices, ordered by their corners.
--
-- /Degenerate cases/ pairs on one line that have a corner in common are on one vertex: so the two faces of a piece of a
-- wall are where they lead to the same free end.
--
-- /Cost/ O(n³).
bruteForce :: Scene -> [Vertex]
bruteForce scene = sort (mapMaybe fromCorners (lines' (Set.fromList pairs)))
  where
    pairs = [(p, q) | p <- corners scene, q <- corners scene, p < q, isElementary scene p q]
    atCorner = Map.fromListWith (<>) [(c, [(p, q)]) | (p, q) <- pairs, c <- [p, q]]
    lines' left = case Set.minView left of
      Nothing -> []
      Just (pair, others) ->
        let line = connected [pair] (Set.singleton pair)
         in Set.toAscList (Set.fromList (concat [[p, q] | (p, q) <- Set.toList line])) : lines' (others Set.\\ line)
    -- All pairs on the line of those found that hang together with them.
    connected [] found = found
    connected ((p, q) : rest) found = connected (more <> rest) (Set.union found (Set.fromList more))
      where
        more =
          [ pair
          | c <- [p, q]
          , pair@(a, b) <- Map.findWithDefault [] c atCorner
          , turned Collinear scene p q a && turned Collinear scene p q b
          , pair `Set.notMember` found
          ]

-- | Is the open segment from p to q, p to the left of q, in free space, without a corner on it, and across no thin
-- wall? Two corners in one place are no pair. A segment along a side joins the two corners of that side only: it runs
-- along one face.
--
-- /Cost/ O(n).
isElementary :: Scene -> CornerId -> CornerId -> Bool
isElementary scene p q =
  cornerAt scene p /= cornerAt scene q
    && isFree p q
    && isFree q p
    && alongSides
    && not (any blocksAsCorner (corners scene))
    && not (any blocksAsSide (sides scene))
  where
    -- Does the ray from a towards b start in the cone of a? It may run along a side.
    isFree a b = isWallEnd scene a || not (insideWedge scene a b)
    alongSides = faces p q && faces q p
    faces a b = null (ahead a b) || b `elem` ahead a b
    -- The corners that sides of a towards b lead to.
    ahead a b = [r | r <- besides a, (a < r) == (a < b), turned Collinear scene a b r]
    besides a = [nextCorner scene a, previousCorner scene a]
    blocksAsCorner r = between r && turned Collinear scene p q r
    between r = p < r && r < q && cornerAt scene r `notElem` [cornerAt scene p, cornerAt scene q]
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
insideWedge scene c target = case directionTurn to from of
  LeftTurn -> left to ray && left ray from
  RightTurn -> not (atMost ray to && atMost from ray)
  Collinear -> left to ray
  where
    CornerId i = c
    heading (CornerId j) = direction (scenePoints scene) i j
    to = heading (nextCorner scene c)
    from = heading (previousCorner scene c)
    ray = heading target
    left a b = directionTurn a b == LeftTurn
    -- For a reflex corner the free cone runs counter-clockwise from the preceding side to the following one, less than
    -- 180°.
    atMost a b = directionTurn a b /= RightTurn

-- | Is the turn from a over b to c of this kind? In integers, whatever arithmetic the scene is under.
turned :: Turn -> Scene -> CornerId -> CornerId -> CornerId -> Bool
turned wanted scene a b c = directionTurn (heading a b) (heading a c) == wanted
  where
    heading i j = let Vector2 x y = towards (cornerAt scene i) (cornerAt scene j) in Direction x y
