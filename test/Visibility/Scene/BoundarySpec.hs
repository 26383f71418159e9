-- | The boundary of free space against the polygons that a file states, decided on rationals: what of their sides is
-- covered, and where next to their corners it is free.
module Visibility.Scene.BoundarySpec (spec) where

import Data.List (group, nub, sort, sortBy)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Ratio (denominator, numerator)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.Predicate (Direction (..), Turn (..), directionTurn, primitive)
import Visibility.Scene
import Visibility.Scene.Cone
import Visibility.Scene.Raw
import Visibility.Sight (compareAround)
import Visibility.Test.Generator
import Visibility.Test.Metamorphic

spec :: Spec
spec = do
  describe "the walks" $
    modifyMaxSuccess (* 5) $ do
      it "are closed: each corner comes before its following one and after its preceding one, in another place" $
        onScenes $ \scene ->
          conjoin
            [ (previousCorner scene (nextCorner scene c), nextCorner scene (previousCorner scene c)) === (c, c)
                .&&. not (samePlace scene c (nextCorner scene c))
            | c <- corners scene
            ]
      it "go along sides that the file states, free space on the right, each piece once and whole" $
        onScenes $ \scene ->
          conjoin
            [ counterexample (show (sideName scene s)) $
                isAlong face piece
                  .&&. [name | (name, point) <- statedCorners scene, point `between` piece] === []
                  .&&. [piece' | s' <- sides scene, s' /= s, let piece' = ends scene s', runAlong piece piece'] === []
            | s <- sides scene
            , let piece = ends scene s
            , face <- [face | (name, face) <- facesOf scene, name == sideName scene s]
            ]
      it "are those of the same polygons under other names, and in another order" $
        property $ \(TouchingScene s) -> forAll (relabelling (sampleRaw s)) $ \change ->
          case sample (changedScene change) of
            Nothing -> counterexample "not valid" False
            Just t -> told id (sampleScene t) === told (newSide change) (sampleScene s)
      it "have a corner for each of the file's where nothing touches, but two for each between the ends of a wall" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
              n polygon = length (polygonPoints polygon)
              own polygon = if polygonForm polygon == Ring then n polygon else 2 * n polygon - 2
           in sceneContacts scene == 0 ==> cornerCount scene === sum (map own (scenePolygons scene))
  describe "what is not covered of a side" $
    modifyMaxSuccess (* 5) $ do
      it "is what no other polygon lies along, by intervals" $
        onScenes $ \scene ->
          conjoin
            [ counterexample (show name) $ uncovered scene name === 1 - coveredPart scene name face
            | (name, face) <- facesOf scene
            ]
      it "is all of every side where nothing touches" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
           in sceneContacts scene == 0 ==> [name | name <- statedSides scene, uncovered scene name /= 1] === []
      it "is all of both faces of a wall where there are walls only, however they touch" $
        property $ \(TouchingScene s) ->
          case sample (sampleRaw s) {rawEnclosure = Nothing, rawPolygons = filter isWall (rawPolygons (sampleRaw s))} of
            Nothing -> property Discard
            Just t ->
              [name | name <- statedSides (sampleScene t), uncovered (sampleScene t) name /= 1] === []
  describe "the cones of free space in the place of a corner" $
    modifyMaxSuccess (* 5) $ do
      it "hold each direction in which it is free once, and no other" $
        onScenes $ \scene ->
          conjoin
            [ counterexample (show (point, d)) $
                length [c | c <- fromMaybe [] (cornersNamed scene name), not (entersSolid scene JustThen c d)]
                  === (if isFree scene (pointNear scene point d) then 1 else 0)
            | (name, point) : _ <- map snd (Map.toList (byPlace scene))
            , d <- sectors scene point
            ]
      it "have no side of the file inside" $
        onScenes $ \scene ->
          conjoin
            [ counterexample (show (c, u)) (entersSolid scene JustThen c u || any (isSameWay u) (flanks scene c))
            | c <- corners scene
            , let here = cornerPoint scene c
            , (_, (a, b)) <- facesOf scene
            , u <- [towards here e | here == a || here == b || here `between` (a, b), e <- [a, b], e /= here]
            ]
  describe "the names of a corner" $
    modifyMaxSuccess (* 5) $ do
      it "are those of all corners of the file in its place" $
        onScenes $ \scene ->
          conjoin [namesHere scene c === namesAt scene (cornerPoint scene c) | c <- corners scene]
            .&&. conjoin
              [ fmap (sort . map (cornerPoint scene)) (cornersNamed scene name)
                  === Just [cornerPoint scene c | c <- corners scene, cornerPoint scene c == point]
              | (name, point) <- statedCorners scene
              ]
      it "begin with the first that belongs to a polygon on one of its flanks, if one does" $
        onScenes $ \scene ->
          conjoin
            [ counterexample (show c) $ cornerName scene c === minimum (if null own then here else own)
            | c <- corners scene
            , let here = namesAt scene (cornerPoint scene c)
            , let flanking = [p | side <- [c, previousCorner scene c], SideName p _ <- [sideName scene (leaving side)]]
            , let own = [name | name@(CornerName p _) <- here, p `elem` flanking]
            ]
      it "are counted as contacts where there are several, or a side passes" $
        onScenes $ \scene ->
          sceneContacts scene
            === length
              [ ()
              | same@(point : _) <- group (sort (map snd (statedCorners scene)))
              , length same > 1 || or [point `between` side | (_, side) <- facesOf scene]
              ]
  where
    onScenes check =
      property (\(TouchingScene s) -> check (sampleScene s)) .&&. property (\(AnyScene s) -> check (sampleScene s))
    leaving (CornerId c) = SideId c
    namesAt scene point = sort [name | (name, at) <- statedCorners scene, at == point]
    byPlace scene = Map.fromListWith (flip (<>)) [(point, [(name, point)]) | (name, point) <- statedCorners scene]
    ends scene s = (cornerPoint scene (sideStart s), cornerPoint scene (sideEnd scene s))
    flanks scene c = [heading scene c q | q <- [nextCorner scene c, previousCorner scene c]]
    isWall polygon = rawForm polygon == Polyline
    isSameWay u d = directionTurn u d == Collinear && sameWay u d

-- | Every side of the file from the one end to the other, free space on its right.
facesOf :: Scene -> [(SideName, (Point, Point))]
facesOf scene = concatMap faces (scenePolygons scene)
  where
    faces polygon = case polygonForm polygon of
      Ring ->
        [(SideName p k, if solidOnLeft then side else swapped side) | (k, side) <- zip [0 ..] (segmentsOf polygon)]
      Polyline ->
        concat
          [ [(SideName p k, side), (SideName p (2 * n - 3 - k), swapped side)]
          | (k, side) <- zip [0 ..] (segmentsOf polygon)
          ]
      where
        p = polygonId polygon
        n = length (polygonPoints polygon)
        area = sum [ax * by - ay * bx | (Point ax ay, Point bx by) <- segmentsOf polygon]
        solidOnLeft = (area > 0) == (p /= Enclosure)
    swapped (a, b) = (b, a)

segmentsOf :: Polygon -> [(Point, Point)]
segmentsOf polygon = zip points (drop 1 points <> [a | polygonForm polygon == Ring, a <- take 1 points])
  where
    points = polygonPoints polygon

-- | Strictly between two others, on their line.
between :: Point -> (Point, Point) -> Bool
between c (a, b) = cross a b c == 0 && min a b < c && c < max a b

cross :: Point -> Point -> Point -> Rational
cross (Point ax ay) (Point bx by) (Point cx cy) = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)

-- | Is the second way a part of the first?
isAlong :: (Point, Point) -> (Point, Point) -> Bool
isAlong (a, b) (c, d) = all holds [c, d] && (c < d) == (a < b) && c /= d
  where
    holds x = cross a b x == 0 && min a b <= x && x <= max a b

-- | Do two ways on one line have a piece in common, in the same direction?
runAlong :: (Point, Point) -> (Point, Point) -> Bool
runAlong (a, b) (c, d) =
  cross a b c == 0 && cross a b d == 0 && (a < b) == (c < d) && max (min a b) (min c d) < min (max a b) (max c d)

-- | The part of a face that is covered: by the face of a ring that runs against it, or, of a ring's side, by a wall.
coveredPart :: Scene -> SideName -> (Point, Point) -> Rational
coveredPart scene (SideName p _) (a@(Point ax ay), b@(Point bx by)) =
  added (sort (concatMap lyingOn (scenePolygons scene)))
  where
    formAt q = [polygonForm polygon | polygon <- scenePolygons scene, polygonId polygon == q]
    lyingOn polygon
      | polygonId polygon == p = []
      | otherwise =
          [ (low, high)
          | (SideName q _, (c, d)) <- facesOf scene
          , q == polygonId polygon
          , cross a b c == 0 && cross a b d == 0
          , formAt q == [Ring] && opposed (c, d) || formAt q == [Polyline] && formAt p == [Ring]
          , let low = max 0 (min (along c) (along d))
          , let high = min 1 (max (along c) (along d))
          , low < high
          ]
    opposed (c, d) = (c < d) /= (a < b)
    along (Point x y) = if ax == bx then (y - ay) / (by - ay) else (x - ax) / (bx - ax)
    added = sum . map (\(low, high) -> high - low) . foldr merge []
    merge (low, high) ((low', high') : rest) | low' <= high = merge (low, max high high') rest
    merge interval rest = interval : rest

-- | The middles between all directions that lead from a point to corners of the file: in between, nothing changes.
sectors :: Scene -> Point -> [Direction]
sectors scene here = zipWith middle ways (drop 1 ways <> take 1 ways)
  where
    ways = nub (sortBy compareAround [towards here point | (_, point) <- statedCorners scene, point /= here])
    middle a@(Direction ax ay) b@(Direction bx by) = case directionTurn a b of
      LeftTurn -> Direction (ax + bx) (ay + by)
      RightTurn -> Direction (negate (ax + bx)) (negate (ay + by))
      Collinear
        | a == b -> Direction (negate ax) (negate ay)
        | otherwise -> Direction (negate ay) ax

-- | The primitive direction from one point to another.
towards :: Point -> Point -> Direction
towards (Point ax ay) (Point bx by) = primitive (Direction (whole (bx - ax)) (whole (by - ay)))
  where
    whole q = numerator q * (unit `div` denominator q)
    unit = lcm (denominator (bx - ax)) (denominator (by - ay))


-- | A point in a direction from another one, so near that no side of the file comes between, nor on it.
pointNear :: Scene -> Point -> Direction -> Point
pointNear scene (Point x y) (Direction dx dy) = Point (x + t * fromInteger dx) (y + t * fromInteger dy)
  where
    t = minimum (2 : hits) / 2
    hits =
      [ s
      | (_, (Point ax ay, Point bx by)) <- facesOf scene
      , let (ex, ey) = (bx - ax, by - ay)
      , let across = fromInteger dx * ey - fromInteger dy * ex
      , across /= 0
      , let s = ((ax - x) * ey - (ay - y) * ex) / across
      , let u = ((ax - x) * fromInteger dy - (ay - y) * fromInteger dx) / across
      , s > 0
      , u >= 0
      , u <= 1
      ]

-- | Does a point that is on no boundary lie in no ring, and in the enclosure if there is one?
isFree :: Scene -> Point -> Bool
isFree scene (Point x y) =
  and
    [ isInside polygon == (polygonId polygon == Enclosure)
    | polygon <- scenePolygons scene
    , polygonForm polygon == Ring
    ]
  where
    isInside = odd . length . filter hit . segmentsOf
    hit (Point ax ay, Point bx by) = (ay <= y) /= (by <= y) && ax + (y - ay) / (by - ay) * (bx - ax) > x

-- | The pieces of all walks by their ends, with their names, and what follows what.
told :: (SideName -> SideName) -> Scene -> ([(Point, Point, SideName)], [(Point, Point, Point)])
told rename scene =
  ( sort [(at (sideStart s), at (sideEnd scene s), rename (sideName scene s)) | s <- sides scene]
  , sort [(at (previousCorner scene c), at c, at (nextCorner scene c)) | c <- corners scene]
  )
  where
    at = cornerPoint scene
