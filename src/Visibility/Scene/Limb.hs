-- | What leads away from places in which polygons meet: whether polygons overlap there.
module Visibility.Scene.Limb
  ( Limbs
  , limbsOf
  , overlapping
  , overlapsOn
  ) where

import Data.Int (Int32)
import qualified Data.IntMap.Strict as IntMap
import Data.List (groupBy)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Scene.Boxes
import Visibility.Scene.Outline
import Visibility.Sorting

-- | What leads away from a place: the open arc of directions that lead into a ring, from one direction
-- counter-clockwise to another, or the direction of a piece of a thin wall. Directions are those to corners.
data Limb = Arc !Int !Int | Ray !Int

-- | The limbs of polygons in some places, as boxes: for each one its place, its least and its greatest direction, and
-- the polygon; and those of each polygon.
data Limbs = Limbs !BoxTree !(U.Vector (Int, Int, Int, Int32)) !Buckets

-- | The limbs in the places where several polygons may meet and one has a property; given, by place, the corners that
-- start the sides that pass it.
--
-- /Requires/ simple rings, and walls without zero lengths. /Cost/ O(n log n).
limbsOf :: Outline -> (Int -> Bool) -> IntMap.IntMap [Int] -> Limbs
limbsOf o isWanted passing = Limbs (boxTree (map boxOf (U.toList found))) found (bucketsBy total (U.map ownerIn found))
  where
    total = V.length (outlineIds o)
    ownerIn (_, _, _, p) = p
    found =
      U.fromList
        [ (place, low, high, fromIntegral p)
        | corners <- groupBy together (map fromIntegral (U.toList (outlineOrder o)))
        , (p, Box place _ low high) <- inPlace corners
        ]
    together i j = numberOf o i == numberOf o j
    inPlace corners = case corners of
      c : others
        | not (null others && null (sidesAt c)) && any (isWanted . ownerOf o) (corners <> sidesAt c) ->
            boxesAt o c (concatMap (atCorner o) corners <> concatMap (onSide o) (sidesAt c))
      _ -> []
    sidesAt c = IntMap.findWithDefault [] (numberOf o c) passing

-- | The polygons that overlap one in the places of its limbs, some of them several times.
overlapping :: Limbs -> Int -> [Int]
overlapping (Limbs tree found owners) p =
  [ fromIntegral q
  | k <- bucketOf owners p
  , j <- foldBoxes (boxesOverlap (boxOf (found U.! k))) (flip (:)) [] tree
  , let (_, _, _, q) = found U.! j
  , fromIntegral q /= p
  ]

boxOf :: (Int, Int, Int, Int32) -> Box
boxOf (place, low, high, _) = Box place place low high

-- | Do two polygons overlap where a corner of the first lies on the side of the second that a corner starts: does one
-- reach into the solid of the other, or are they walls that lie along each other?
overlapsOn :: Outline -> Int -> Int -> Bool
overlapsOn o i s = or [boxesOverlap one other | (p, one) <- boxes, p == ownerOf o i, (q, other) <- boxes, q /= p]
  where
    boxes = boxesAt o i (atCorner o i <> onSide o s)

-- | Limbs in the place of a corner as boxes, of which two overlap if and only if the limbs do. An arc through the
-- direction down is two.
boxesAt :: Outline -> Int -> [(Int, Limb)] -> [(Int, Box)]
boxesAt o c limbs = concat (zipWith boxes [0 ..] limbs)
  where
    boxes k (p, limb) = [(p, Box place place low high) | (low, high) <- spans limb (rank (2 * k)) (rank (2 * k + 1))]
    spans (Ray _) a _ = [(2 * a, 2 * a)]
    spans (Arc _ _) a b
      | a < b = [(2 * a + 1, 2 * b - 1)]
      | otherwise = [(2 * a + 1, 2 * U.length ends), (-1, 2 * b - 1)]
    place = numberOf o c
    rank k = fromIntegral (ranks U.! k)
    ranks = denseRanks (\i j -> angleOrder o c (ends U.! i) (ends U.! j)) (U.length ends)
    ends = U.fromList (concatMap (directions . snd) limbs)
    directions (Arc a b) = [a, b]
    directions (Ray a) = [a, a]

-- | The limbs of the polygon of a corner there.
atCorner :: Outline -> Int -> [(Int, Limb)]
atCorner o i = case (solidFlank o p, joinedTo o i) of
  (Nowhere, (after, before)) -> [(p, Ray c) | c <- [after, before], c /= noCorner]
  (flank, (after, before)) -> [(p, arc flank after before)]
  where
    p = ownerOf o i

-- | Those of the polygon of a side, given by the corner that starts it, in a place that it passes.
onSide :: Outline -> Int -> [(Int, Limb)]
onSide o s = case solidFlank o p of
  Nowhere -> [(p, Ray s), (p, Ray (around o 1 s))]
  flank -> [(p, arc flank (around o 1 s) s)]
  where
    p = ownerOf o s

arc :: Solid -> Int -> Int -> Limb
arc OnLeft ahead behind = Arc ahead behind
arc _ ahead behind = Arc behind ahead
