-- | What a scene has that is worth testing: labels for the distribution of the generators.
module Visibility.Test.Feature
  ( Feature (..)
  , features
  , flanksOf
  ) where

import Data.List (partition, tails)
import Data.Ratio (denominator)
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Sweep.BruteForce (bruteForce)
import Visibility.Sweep.Vertex
import Visibility.Test.Generator

-- | A property of a scene that some code has to take care of.
data Feature
  = -- | Three or more corners on a maximal free segment.
    DegenerateVertex
  | -- | On such a segment, solid on both flanks.
    BothFlanks
  | -- | Four or more corners on a maximal free segment.
    LongVertex
  | -- | Corners above each other that see each other.
    VerticalVertex
  | -- | Two vertices of one direction.
    ParallelVertices
  | -- | An enclosure.
    InRoom
  | -- | An enclosure that is not convex.
    NonConvexRoom
  | -- | A thin wall.
    ThinWall
  | -- | A thin wall with other corners in its line, seen from it.
    WallInLine
  | -- | An obstacle with a reflex corner.
    NonConvexObstacle
  | -- | A corner of 180°.
    FlatCorner
  | -- | Machine integers decide.
    ByMachine
  | -- | The floating-point filter decides.
    ByFilter
  | -- | The filter has to leave a decision to the integers.
    ByIntegers
  | -- | Coordinates that are no integers.
    Fractions
  | -- | One polygon only.
    Alone
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | All features of a scene. /Cost/ O(n³).
features :: Sample -> [Feature]
features (Sample raw scene) = [feature | feature <- [minBound .. maxBound], has feature]
  where
    found = bruteForce scene
    (rooms, obstacles) = partition ((== Enclosure) . polygonId) (scenePolygons scene)
    statedCorners = concatMap rawCorners (maybe id (:) (rawEnclosure raw) (rawPolygons raw))
    isWall s (p, q) = isWallCorner s p && nextCorner s p == q
    degenerate = filter isDegenerate found
    points = scenePoints scene
    has feature = case feature of
      DegenerateVertex -> not (null degenerate)
      BothFlanks -> any (onBoth . flanksOf scene) degenerate
      LongVertex -> any ((>= 4) . length . vertexCorners) found
      VerticalVertex -> any isVertical found
      ParallelVertices -> or [parallel v w | (v, others) <- zip found (drop 1 (tails found)), w <- others]
      InRoom -> surroundings scene == Room
      NonConvexRoom -> any ((== LeftTurn) . bend) (concatMap polygonCorners rooms)
      ThinWall -> any (isWallCorner scene) (corners scene)
      WallInLine -> any (any (isWall scene) . vertexPairs) degenerate
      NonConvexObstacle -> any ((== RightTurn) . bend) (concatMap polygonCorners obstacles)
      FlatCorner -> or [bend c == Collinear | c <- corners scene, not (isWallCorner scene c)]
      ByMachine -> kernel == "machine"
      ByFilter -> kernel == "filter"
      ByIntegers -> kernel == "filter" && not (null degenerate)
      Fractions -> any (\(Point x y) -> denominator x /= 1 || denominator y /= 1) statedCorners
      Alone -> length (scenePolygons scene) == 1
    kernel = case pointsKernel points of
      MachineKernel _ -> "machine"
      FilterKernel _ -> "filter"
      _ -> "other"
    isVertical v = let Direction dx _ = vertexDirection scene v in dx == 0
    parallel v w = compareDirections (vertexDirection scene v) (vertexDirection scene w) == EQ
    bend c = turnAt (previousCorner scene c) c (nextCorner scene c)
    turnAt (CornerId a) (CornerId b) (CornerId c) = turn points a b c
    onBoth flanks = LeftTurn `elem` flanks && RightTurn `elem` flanks

-- | On which flanks of a vertex's line each of its corners has solid: of a tangent corner one, of both ends of a wall
-- on the line, or of corners where the line ends, none.
flanksOf :: Scene -> Vertex -> [Turn]
flanksOf scene vertex = concatMap flank line
  where
    line = vertexCorners vertex
    CornerId a = case vertex of Vertex c _ _ -> c
    CornerId b = vertexLast vertex
    flank c = case filter (/= Collinear) (map side [nextCorner scene c, previousCorner scene c]) of
      [t] -> [t]
      [t, u] | t == u -> [t]
      _ -> []
    side (CornerId q) = turn (scenePoints scene) a b q
