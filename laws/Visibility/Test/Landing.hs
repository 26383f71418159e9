-- | Where the lines of vertices land, by the definition and in rationals: an oracle for meshes.
module Visibility.Test.Landing
  ( Landed (..)
  , Cast
  , landedByRays
  , landedIn
  , positionOn
  ) where

import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Visibility.Exact.Point (Point (..))
import Visibility.Mesh
import Visibility.Scene
import Visibility.Scene.Cone
import Visibility.Scene.Raw (Form (..))
import Visibility.Test.BruteForce (isElementary)

-- | A break point in names: where it is on the side, and all its casters in their order.
data Landed = Landed
  { landedParameter :: Rational
  , landedPoint :: Point
  , landedCasts :: [Cast]
  }
  deriving (Eq, Ord, Show)

-- | A kind, the nearer corner and the farther one.
type Cast = (Kind, (CornerName, CornerName))

-- | A mesh in names.
landedIn :: Mesh -> Map.Map SideName [Landed]
landedIn mesh = Map.map (map landed) (Map.fromList (meshSides mesh))
  where
    landed point =
      Landed
        (breakParameter point)
        (breakAt point)
        [(casterKind caster, casterNames (meshScene mesh) caster) | caster <- breakCasters point]

-- | All break points of all sides: every elementary pair is lengthened until it meets something.
--
-- /Cost/ O(n³).
landedByRays :: Scene -> Map.Map SideName [Landed]
landedByRays scene = Map.union found (Map.fromList [(side, []) | side <- statedSides scene])
  where
    found =
      Map.fromListWith
        (flip (<>))
        [ (side, [Landed t point (Set.toAscList casts)])
        | ((side, t, point), casts) <- Map.toAscList byPlace
        ]
    byPlace =
      Map.fromListWith
        Set.union
        [ ((name, positionOn scene name point, point), Set.singleton (castOf scene (`at` pairsAt) pair))
        | pair <- Set.toList seen
        , Just (s, point) <- [lengthened scene pair]
        , let name = sideName scene s
        ]
    seen = Set.fromList (concat [[(p, q), (q, p)] | p <- corners scene, q <- corners scene, p < q, isSeen p q])
    isSeen = isElementary scene
    pairsAt = Map.fromListWith (<>) [(c, [(p, q)]) | (p, q) <- Set.toList seen, c <- [p, q]]
    at c = Map.findWithDefault [] c

-- | Where the ray from the second corner over the first one ends, if it goes on there and ends strictly inside a side.
lengthened :: Scene -> (CornerId, CornerId) -> Maybe (SideId, Point)
lengthened scene (near, far)
  | not (goesOn scene near (far, near)) = Nothing
  | otherwise = case [s | (t, Just s) <- hits, t == nearest] of
      [s] | null [() | (t, Nothing) <- hits, t == nearest] -> Just (s, Point (x + nearest * dx) (y + nearest * dy))
      _ -> Nothing
  where
    Point x y = cornerPoint scene near
    (dx, dy) = cornerPoint scene far `to` cornerPoint scene near
    nearest = minimum (map fst hits)
    -- Corners, and sides that are met from their free side strictly between their ends.
    hits =
      [ (t, Nothing)
      | c <- corners scene
      , let (ex, ey) = Point x y `to` cornerPoint scene c
      , dx * ey == dy * ex
      , let t = (ex * dx + ey * dy) / (dx * dx + dy * dy)
      , t > 0
      ]
        <> [ (t, Just s)
           | s <- sides scene
           , let (ax, ay) = Point x y `to` cornerPoint scene (sideStart s)
           , let (ex, ey) = cornerPoint scene (sideStart s) `to` cornerPoint scene (sideEnd scene s)
           , let across = dx * ey - dy * ex
           , across /= 0
           , let t = (ax * ey - ay * ex) / across
           , let u = (ax * dy - ay * dx) / across
           , t > 0
           , u > 0
           , u < 1
           , ex * dy - ey * dx > 0
           ]

to :: Point -> Point -> (Rational, Rational)
to (Point ax ay) (Point bx by) = (bx - ax, by - ay)

-- | Is the ray from a corner in the direction from one corner to another free at first?
goesOn :: Scene -> CornerId -> (CornerId, CornerId) -> Bool
goesOn scene c (from, towards) = not (entersSolid scene JustThen c (heading scene from towards))

-- | The caster of the line of an elementary pair at its first end, by the pairs at each corner: of all those that hang
-- together with this one, the nearest free bitangent, or if there is none the nearest one; of several that join the
-- same places that with the smaller names.
castOf :: Scene -> (CornerId -> [(CornerId, CornerId)]) -> (CornerId, CornerId) -> Cast
castOf scene pairsAt pair@(near, far)
  | null free = (Kink, nearestOf line)
  | otherwise = (ShadowLimit, nearestOf free)
  where
    line = connected (Set.singleton pair) [pair]
    free = [(p, q) | (p, q) <- line, not (isSide p q), goesOn scene p (far, near), goesOn scene q (near, far)]
    isSide p q = nextCorner scene p == q || nextCorner scene q == p
    nearestOf = minimum . map named . closest
    closest found = let d = minimum (map (distance . fst) found) in [(p, q) | (p, q) <- found, distance p == d]
    named (p, q) = (cornerName scene p, cornerName scene q)
    (dx, dy) = cornerPoint scene near `to` cornerPoint scene far
    distance c = let (ex, ey) = cornerPoint scene near `to` cornerPoint scene c in ex * dx + ey * dy
    connected found [] = Set.toList found
    connected found ((p, q) : rest) =
      let more =
            [ (a, b)
            | (a, b) <- pairsAt p <> pairsAt q
            , all onLine [a, b]
            , distance a < distance b
            , (a, b) `Set.notMember` found
            ]
       in connected (Set.union found (Set.fromList more)) (more <> rest)
    onLine c = let (ex, ey) = cornerPoint scene near `to` cornerPoint scene c in dx * ey == dy * ex

-- | Where a point is on a side of the file: 0 at corner k, 1 at corner k + 1; of a thin wall of n corners, side
-- n − 1 + k begins at corner n − 1 − k.
positionOn :: Scene -> SideName -> Point -> Rational
positionOn scene (SideName p k) point = case [polygon | polygon <- scenePolygons scene, polygonId polygon == p] of
  polygon : _ ->
    let points = polygonPoints polygon
        n = length points
        (i, j) = case polygonForm polygon of
          Ring -> (k, (k + 1) `mod` n)
          Polyline | k < n - 1 -> (k, k + 1)
          Polyline -> (2 * n - 2 - k, 2 * n - 3 - k)
     in case (drop i points, drop j points) of
          (a : _, b : _) ->
            let ((ex, ey), (px, py)) = (a `to` b, a `to` point) in (ex * px + ey * py) / (ex * ex + ey * ey)
          _ -> -1
  [] -> -1
