-- | What a scene has that is worth testing: labels for the distribution of the generators.
module Visibility.Test.Feature
  ( Feature (..)
  , features
  , flanksOf
  ) where

import Data.List (group, nub, partition, sort, tails)
import Data.Ratio (denominator)
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Sweep.Vertex
import Visibility.Test.BruteForce (bruteForce)
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
  | -- | Corners of two polygons in one place.
    CornerOnCorner
  | -- | Three or more of them.
    ManyCorners
  | -- | A corner between the ends of a side.
    CornerOnSide
  | -- | Sides that cover a part of each other.
    SideOnSide
  | -- | A side that is covered from end to end.
    CoveredSide
  | -- | Free space that is closed off between touching polygons.
    Pocket
  | -- | An obstacle that touches the enclosure.
    AtEnclosure
  | -- | A thin wall of three corners or more.
    BentWall
  | -- | An end of a thin wall on the side of a thin wall.
    WallJunction
  | -- | A thin wall that touches a polygon with an area.
    WallOnPolygon
  | -- | A thin wall whose line is a vertex and that something touches: its faces have pairs of their own.
    SplitEnd
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | All features of a scene. /Cost/ O(n³).
features :: Sample -> [Feature]
features (Sample raw scene) = [feature | feature <- [minBound .. maxBound], has feature]
  where
    found = bruteForce scene
    (rooms, obstacles) = partition ((== Enclosure) . polygonId) (scenePolygons scene)
    allCorners = concatMap rawCorners (maybe id (:) (rawEnclosure raw) (rawPolygons raw))
    isWall s (p, q) = isWallEnd s p && nextCorner s p == q
    degenerate = filter (isDegenerate scene) found
    loops = [(polygonId polygon, polygonForm polygon, polygonPoints polygon) | polygon <- scenePolygons scene]
    segments = [((p, form), (a, b)) | (p, form, loop) <- loops, (a, b) <- zip loop (drop 1 (around form loop))]
    around form loop = if form == Ring then cycle loop else loop
    here = [(a, length names) | names@(a : _) <- group (sort [point | (_, _, loop) <- loops, point <- nub loop])]
    onSegment point (a, b) =
      point /= a && point /= b && crossOf a b point == 0 && min a b < point && point < max a b
    crossOf (Point ax ay) (Point bx by) (Point cx cy) = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    touches =
      [((p, f), (q, g)) | (p, f, loop) <- loops, ((q, g), side) <- segments, p /= q, any (`onSegment` side) loop]
    meets p q = or [a == b | (p', _, loop) <- loops, p' == p, (q', _, other) <- loops, q' == q, a <- loop, b <- other]
      || or [True | ((p', _), (q', _)) <- touches, (p', q') `elem` [(p, q), (q, p)]]
    kinds = [(p, form) | (p, form, _) <- loops]
    bends loop = [signum (crossOf a b c) | (a, b, c) <- zip3 loop (drop 1 (cycle loop)) (drop 2 (cycle loop))]
    isNonConvex polygon = let found' = bends (polygonPoints polygon) in 1 `elem` found' && (-1) `elem` found'
    partly = [part | s <- statedSides scene, let part = uncovered scene s, part < 1]
    walks = [walk | c <- corners scene, let walk = walkFrom c, all (>= c) walk]
    walkFrom c = c : takeWhile (/= c) (drop 1 (iterate (nextCorner scene) c))
    -- Around free space, clockwise; the others go around what is solid.
    isAroundFree walk = sum (zipWith crossProduct places (drop 1 places <> take 1 places)) < 0
      where
        places = map (coordinates . cornerAt scene) walk
    crossProduct (ax, ay) (bx, by) = ax * by - ay * bx
    points = scenePoints scene
    has feature = case feature of
      DegenerateVertex -> not (null degenerate)
      BothFlanks -> any (onBoth . flanksOf scene) degenerate
      LongVertex -> any ((>= 4) . length . vertexCorners) found
      VerticalVertex -> any isVertical found
      ParallelVertices -> or [parallel v w | (v, others) <- zip found (drop 1 (tails found)), w <- others]
      InRoom -> surroundings scene == Room
      NonConvexRoom -> any isNonConvex rooms
      ThinWall -> or [True | (_, Polyline) <- kinds]
      WallInLine -> any (any (isWall scene) . vertexPairs scene) degenerate
      NonConvexObstacle -> or [isNonConvex polygon | polygon <- obstacles, polygonForm polygon == Ring]
      FlatCorner -> or [bend c == Collinear | c <- corners scene, not (isWallEnd scene c)]
      ByMachine -> kernel == "machine"
      ByFilter -> kernel == "filter"
      ByIntegers -> kernel == "filter" && not (null degenerate)
      Fractions -> any (\(Point x y) -> denominator x /= 1 || denominator y /= 1) allCorners
      Alone -> length (scenePolygons scene) == 1
      CornerOnCorner -> any ((>= 2) . snd) here
      ManyCorners -> any ((>= 3) . snd) here
      CornerOnSide -> not (null touches)
      SideOnSide -> not (null partly)
      CoveredSide -> 0 `elem` partly
      Pocket -> length (filter isAroundFree walks) > length rooms
      AtEnclosure -> or [meets p Enclosure | (p@(Obstacle _), _) <- kinds]
      BentWall -> or [length loop > 2 | (_, Polyline, loop) <- loops]
      WallJunction -> or [True | ((_, Polyline), (_, Polyline)) <- touches]
      WallOnPolygon -> or [meets p q | (p, Polyline) <- kinds, (q, Ring) <- kinds]
      SplitEnd -> or [length (vertexPairs scene v) >= length (placesOf v) | v <- found]
    kernel = case pointsKernel points of
      MachineKernel _ -> "machine"
      FilterKernel _ -> "filter"
      _ -> "other"
    placesOf = nub . map (cornerAt scene) . vertexCorners
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
    CornerId a = vertexFirst vertex
    CornerId b = vertexLast vertex
    flank c = case filter (/= Collinear) (map side [nextCorner scene c, previousCorner scene c]) of
      [t] -> [t]
      [t, u] | t == u -> [t]
      _ -> []
    side (CornerId q) = turn (scenePoints scene) a b q
