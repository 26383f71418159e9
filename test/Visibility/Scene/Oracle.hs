-- | The meaning of every error of a scene, stated pair by pair on rationals. Shares nothing with what it checks.
module Visibility.Scene.Oracle
  ( naiveErrors
  ) where

import Data.List (elemIndex)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Visibility.Error
import Visibility.Exact.Point (Point (..))
import Visibility.Scene.Id
import Visibility.Scene.Raw
import Visibility.Scene.Sample

-- | All errors, in time O(n²).
naiveErrors :: RawScene -> Set.Set SceneError
naiveErrors raw = Set.fromList (empty <> concatMap statement everything <> concatMap own solid <> concat mutual)
  where
    everything = polygonsOf raw
    empty = [EmptyScene | null everything]
    solid = [(p, rawCorners q) | (p, q) <- everything, length (rawCorners q) >= (if p == Enclosure then 3 else 2)]
    mutual = [between a b | a <- solid, b <- solid, fst a < fst b]

statement :: (PolygonId, RawPolygon) -> [SceneError]
statement (p, RawPolygon _ corners material sides) =
  [TooFewCorners p n | n < 2 || (p == Enclosure && n < 3)]
    <> [NoSuchSide (SideName p k) n | k <- Map.keys sides, k `notElem` [0 .. n - 1]]
    <> [BadEmission place x | (place, Just x, _) <- statements, x < 0]
    <> [BadReflectivity place x | (place, _, Just x) <- statements, x < 0 || x >= 1]
  where
    n = length corners
    statements =
      (OfPolygon p, Just (emission material), Just (reflectivity material))
        : [(OfSide (SideName p k), e, r) | (k, MaterialOverride e r) <- Map.toList sides]

-- The sign of this is the turn.
cross :: Point -> Point -> Point -> Rational
cross (Point ax ay) (Point bx by) (Point cx cy) = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)

dot :: Point -> Point -> Point -> Rational
dot (Point ox oy) (Point ax ay) (Point bx by) = (ax - ox) * (bx - ox) + (ay - oy) * (by - oy)

-- Strictly between the ends.
liesOn :: Point -> (Point, Point) -> Bool
liesOn c (a, b) = cross a b c == 0 && dot c a b < 0

crosses :: (Point, Point) -> (Point, Point) -> Bool
crosses (a, b) (c, d) = cross a b c * cross a b d < 0 && cross c d a * cross c d b < 0

sidesOf :: [Point] -> [(Int, (Point, Point))]
sidesOf [a, b] = [(0, (a, b))]
sidesOf corners = zip [0 ..] (zip corners (drop 1 (cycle corners)))

own :: (PolygonId, [Point]) -> [SceneError]
own (p, corners) = repeats <> (if isFlat then [ZeroArea p] else spikes <> touches <> crossings)
  where
    n = length corners
    indexed = zip [0 ..] corners
    corner k = corners !! (k `mod` n)
    isFlat = n > 2 && and [cross a b c == 0 | a <- corners, b <- corners, c <- corners]
    repeats = [RepeatedCorner (CornerName p k) j c | (k, c) <- indexed, Just j <- [elemIndex c corners], j < k]
    spikes =
      [ Spike (CornerName p k) c
      | n > 2
      , (k, c) <- indexed
      , let a = corner (k - 1)
            b = corner (k + 1)
      , cross a c b == 0
      , dot c a b > 0
      ]
    touches =
      [ CornerOnSide (CornerName p k) (SideName p s) c
      | (k, c) <- indexed
      , (s, side) <- sidesOf corners
      , k `notElem` map (`mod` n) [s - 1 .. s + 2]
      , liesOn c side
      ]
    crossings =
      [ CrossingSides (SideName p s) (SideName p t)
      | (s, side) <- sidesOf corners
      , (t, other) <- sidesOf corners
      , s < t
      , crosses side other
      ]

between :: (PolygonId, [Point]) -> (PolygonId, [Point]) -> [SceneError]
between (p, as) (q, bs)
  | null contacts = positions
  | otherwise = contacts
  where
    contacts =
      [CornerOnCorner (CornerName p j) (CornerName q k) a | (j, a) <- zip [0 ..] as, (k, b) <- zip [0 ..] bs, a == b]
        <> cornersOnSides p as q bs
        <> cornersOnSides q bs p as
        <> [ CrossingSides (SideName p s) (SideName q t)
           | (s, side) <- sidesOf as
           , (t, other) <- sidesOf bs
           , crosses side other
           ]
    cornersOnSides c cs s ss =
      [ CornerOnSide (CornerName c j) (SideName s k) corner
      | (j, corner) <- zip [0 ..] cs
      , (k, side) <- sidesOf ss
      , liesOn corner side
      ]
    positions
      | q == Enclosure = [OutsideEnclosure p | not (all collinear bs), not (as `inside` bs)]
      | otherwise = [NestedPolygon p q | as `inside` bs] <> [NestedPolygon q p | bs `inside` as]
    collinear b = and [cross b c d == 0 | c <- bs, d <- bs]

-- Does a ray to the right from the first corner cross the other polygon an odd number of times? A wall has no inside.
inside :: [Point] -> [Point] -> Bool
inside (Point x y : _) others = length others > 2 && odd (length (filter hit (map snd (sidesOf others))))
  where
    hit (Point ax ay, Point bx by) = (ay <= y) /= (by <= y) && ax + (y - ay) / (by - ay) * (bx - ax) > x
inside [] _ = False
