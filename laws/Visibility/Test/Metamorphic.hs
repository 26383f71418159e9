-- | Changes of a scene that must change nothing but names: maps of raw scenes, each with the new name of every old
-- corner and side, and results in a form that can be compared under them.
module Visibility.Test.Metamorphic
  ( -- * Changes
    Change (..)
  , similarity
  , affinity
  , relabelling
  , translated
  , scaledBy
  , turnedByThreeFourFive
  , mirrored
  , sheared
  , permutedPolygons
  , rotatedCorners
  , reversedOrientation
  , Split (..)
  , splitSide
    -- * Results
  , Graph
  , graphOf
  , renamedGraph
  , Factors
  , factorsOf
  , renamedFactors
  , measuresOf
  , doublesOf
  , roundedOf
  ) where

import Data.Bifunctor (bimap)
import Data.List (elemIndex)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Set as Set
import Test.QuickCheck
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.RootSum (RootSum)
import Visibility.Exact.Rounding (nearestDouble)
import Visibility.FormFactor
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Sweep
import Visibility.View (statedPairs)

-- | A map of scenes, and what it does to names.
data Change = Change
  { changeText :: String
  , changedScene :: RawScene
  , newCorner :: CornerName -> CornerName
  , newSide :: SideName -> SideName
  }

instance Show Change where
  show = changeText

-- | Any change that keeps angles, and so the form factors.
similarity :: RawScene -> Gen Change
similarity raw = oneof [translated raw, scaledBy raw, pure (turnedByThreeFourFive raw), pure (mirrored raw)]

-- | Any change that keeps lines, and so the graph.
affinity :: RawScene -> Gen Change
affinity raw = oneof [similarity raw, sheared raw]

-- | Any change of names only.
relabelling :: RawScene -> Gen Change
relabelling raw = oneof [permutedPolygons raw, rotatedCorners raw, reversedOrientation raw]

onPoints :: String -> (Point -> Point) -> RawScene -> Change
onPoints text f raw =
  Change text raw {rawEnclosure = polygon <$> rawEnclosure raw, rawPolygons = map polygon (rawPolygons raw)} id id
  where
    polygon p = p {rawCorners = map f (rawCorners p)}

translated :: RawScene -> Gen Change
translated raw = do
  a <- arbitrary
  b <- arbitrary
  pure (onPoints ("translate by " <> show (a, b)) (\(Point x y) -> Point (x + a) (y + b)) raw)

scaledBy :: RawScene -> Gen Change
scaledBy raw = do
  k <- elements [1 / 3, 7 / 5, 2, 1 / 1000003, 10 ^ (12 :: Int), 3 ^ (100 :: Int)]
  pure (onPoints ("scale by " <> show k) (\(Point x y) -> Point (k * x) (k * y)) raw)

turnedByThreeFourFive :: RawScene -> Change
turnedByThreeFourFive =
  onPoints "rotate by (3/5, 4/5)" (\(Point x y) -> Point ((3 * x - 4 * y) / 5) ((4 * x + 3 * y) / 5))

-- | The two faces of a thin wall change places: its side 0 is the one to the right of the way from corner 0 to corner
-- 1.
mirrored :: RawScene -> Change
mirrored raw = (onPoints "mirror" (\(Point x y) -> Point (negate x) y) raw) {newSide = faces}
  where
    faces (SideName p k) = SideName p (case formIn raw p of Polyline -> 2 * countOf raw p - 3 - k; Ring -> k)

sheared :: RawScene -> Gen Change
sheared raw = do
  k <- elements [1, -2, 1 / 3]
  pure (onPoints ("shear by " <> show k) (\(Point x y) -> Point (x + k * y) y) raw)

permutedPolygons :: RawScene -> Gen Change
permutedPolygons raw = do
  order <- shuffle [0 .. length (rawPolygons raw) - 1]
  let polygon (Obstacle p) = Obstacle (fromMaybe p (elemIndex p order))
      polygon Enclosure = Enclosure
  pure
    Change
      { changeText = "permute polygons " <> show order
      , changedScene = raw {rawPolygons = [p | i <- order, p <- take 1 (drop i (rawPolygons raw))]}
      , newCorner = \(CornerName p k) -> CornerName (polygon p) k
      , newSide = \(SideName p k) -> SideName (polygon p) k
      }

-- | Each polygon begins with another corner; a thin wall of three corners or more does not.
rotatedCorners :: RawScene -> Gen Change
rotatedCorners raw = do
  r <- choose (1, 7)
  let rotate p
        | rawForm p == Polyline && length (rawCorners p) > 2 = p
        | otherwise = let (a, b) = splitAt (r `mod` length (rawCorners p)) (rawCorners p) in p {rawCorners = b <> a}
      index p k
        | formIn raw p == Polyline && countOf raw p > 2 = k
        | otherwise = (k - r) `mod` countOf raw p
  pure (onLoops ("rotate corner lists by " <> show r) rotate index index raw)

-- | All polygons the other way round in the file. A face of a thin wall is named by the corner from which it is on the
-- right.
reversedOrientation :: RawScene -> Gen Change
reversedOrientation raw =
  pure (onLoops "reverse corner lists" (\p -> p {rawCorners = reverse (rawCorners p)}) corner side raw)
  where
    corner p k = countOf raw p - 1 - k
    side p k = case formIn raw p of
      Polyline -> (k + countOf raw p - 1) `mod` (2 * countOf raw p - 2)
      Ring -> (countOf raw p - 2 - k) `mod` countOf raw p

onLoops
  :: String
  -> (RawPolygon -> RawPolygon)
  -> (PolygonId -> Int -> Int)
  -> (PolygonId -> Int -> Int)
  -> RawScene
  -> Change
onLoops text f corner side raw =
  Change
    { changeText = text
    , changedScene = raw {rawEnclosure = f <$> rawEnclosure raw, rawPolygons = map f (rawPolygons raw)}
    , newCorner = \(CornerName p k) -> CornerName p (corner p k)
    , newSide = \(SideName p k) -> SideName p (side p k)
    }

countOf :: RawScene -> PolygonId -> Int
countOf raw p = maximum (1 : map (length . rawCorners) (polygonIn raw p))

formIn :: RawScene -> PolygonId -> Form
formIn raw p = if any ((== Polyline) . rawForm) (polygonIn raw p) then Polyline else Ring

polygonIn :: RawScene -> PolygonId -> [RawPolygon]
polygonIn raw p = case p of
  Enclosure -> maybe [] pure (rawEnclosure raw)
  Obstacle i -> take 1 (drop i (rawPolygons raw))

-- | A side cut by a flat corner: the scene with it, the side, its two parts, the new corner, and new names for all
-- else.
data Split = Split
  { splitScene :: RawScene
  , splitOld :: SideName
  , splitParts :: (SideName, SideName)
  , splitCorner :: CornerName
  , splitNames :: CornerName -> CornerName
  , splitSides :: SideName -> SideName
  }

instance Show Split where
  show s = "split " <> sideText (splitOld s)

-- | A side of an obstacle with three or more corners, or of the enclosure, cut at a rational point; 'Nothing' if there
-- are only thin walls.
splitSide :: RawScene -> Gen (Maybe Split)
splitSide raw
  | null choices = pure Nothing
  | otherwise = do
      (p, k, at) <- elements choices
      t <- elements [1 / 2, 1 / 3, 4 / 7, 1 / 1000]
      pure (Just (splitAtPoint raw p k (at t)))
  where
    loops = [ (Obstacle i, rawCorners p)
            | (i, p) <- zip [0 ..] (rawPolygons raw)
            , rawForm p == Ring
            ] <> [(Enclosure, rawCorners p) | Just p <- [rawEnclosure raw]]
    choices =
      [ (p, k, \t -> Point (ax + t * (bx - ax)) (ay + t * (by - ay)))
      | (p, loop) <- loops
      , (k, (Point ax ay, Point bx by)) <- zip [0 ..] (zip loop (drop 1 (cycle loop)))
      ]

splitAtPoint :: RawScene -> PolygonId -> Int -> Point -> Split
splitAtPoint raw p k point =
  Split
    { splitScene = case p of
        Enclosure -> raw {rawEnclosure = insert <$> rawEnclosure raw}
        Obstacle i -> raw {rawPolygons = [if i == j then insert q else q | (j, q) <- zip [0 ..] (rawPolygons raw)]}
    , splitOld = SideName p k
    , splitParts = (SideName p k, SideName p (k + 1))
    , splitCorner = CornerName p (k + 1)
    , splitNames = \(CornerName q j) -> CornerName q (shifted q j)
    , splitSides = \(SideName q j) -> SideName q (shifted q j)
    }
  where
    insert q = let (a, b) = splitAt (k + 1) (rawCorners q) in q {rawCorners = a <> [point] <> b}
    shifted q j = if q == p && j > k then j + 1 else j

-- | The elementary visible pairs by name, the lesser first.
type Graph = Set.Set (CornerName, CornerName)

graphOf :: Scene -> Graph
graphOf scene = Set.fromList (concatMap (statedPairs scene) (concatMap (vertexPairs scene) (vertices scene)))

renamedGraph :: (CornerName -> CornerName) -> Graph -> Graph
renamedGraph f = Set.map (\(p, q) -> inOrder (f p) (f q))

inOrder :: Ord a => a -> a -> (a, a)
inOrder a b = (min a b, max a b)

-- | The form factors by name, 'Nothing' standing for the sky.
type Factors = Map.Map (SideName, Maybe SideName) RootSum

factorsOf :: Scene -> Factors
factorsOf = tableOf factorValue

-- | The measures 2 L_s F_st by name.
measuresOf :: Scene -> Factors
measuresOf = tableOf factorMeasure

tableOf :: (FormFactor -> RootSum) -> Scene -> Factors
tableOf part scene =
  Map.fromList
    [ ((factorFrom f, target (factorTo f)), part f)
    | f <- formFactors scene (measures scene (vertices scene))
    ]
  where
    target (TheSide s) = Just s
    target TheSky = Nothing

-- | The form factors as Doubles, in their order: as 'nearestFactors' has them, and the exact ones rounded.
doublesOf, roundedOf :: Scene -> [(SideName, Seen, Double)]
doublesOf scene = [(from, to, x) | FactorRow from found _ <- nearestFactors scene swept, (to, x) <- found]
  where
    swept = measures scene (vertices scene)
roundedOf scene = [(factorFrom f, factorTo f, nearestDouble (factorValue f)) | f <- formFactors scene swept]
  where
    swept = measures scene (vertices scene)

renamedFactors :: (SideName -> SideName) -> Factors -> Factors
renamedFactors f = Map.mapKeys (bimap f (fmap f))
