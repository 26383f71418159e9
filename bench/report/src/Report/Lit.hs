-- | Lit scenes for the report, their radiosities on several meshes, and how far these are apart.
module Report.Lit
  ( litScenes
    -- * Meshes
  , Way (..)
  , wayName
  , wayParameter
  , refinedBy
  , litBy
    -- * Errors
  , Shine
  , shineOf
  , shineSize
  , widestBounds
  , Distance (..)
  , distanceFrom
  ) where

import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import qualified Data.Text as Text
import Report.Scenes
import Report.Union (meshUnion)
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.Rounding (nearestDouble)
import Visibility.FormFactor (measuresInPieces, sideLength)
import Visibility.Law (broken)
import Visibility.Mesh
import Visibility.Radiosity
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Sweep

-- | A room with a pier and two obstacles under a lamp; two round objects before a round lamp in a room; three rooms
-- with doors between them, one with a lamp and one with a window.
litScenes :: FilePath -> [Case]
litScenes place =
  [ lit "room" (ring 0.7 [(0, 0), (12, 0), (12, 8), (7, 8), (7, 6), (5, 6), (5, 8), (0, 8)]) $
      [ ring 0.5 [(2, 2), (4, 2), (4, 4), (2, 4)]
      , ring 0.4 [(8, 3), (10, 2), (9, 5)]
      , lamp [(5.5, 5), (6.5, 5), (6.5, 5.25), (5.5, 5.25)]
      ]
  , lit "round" (ring 0.6 [(0, 0), (12, 0), (12, 8), (0, 8)]) $
      [lamp (circle 2 4 1), ring 0.5 (circle 6 5 1), ring 0.5 (circle 8 2.5 (3 / 4))]
  , lit "flat" (ring 0.7 [(0, 0), (12, 0), (12, 8), (0, 8)]) $
      [ ring 0.7 [(4, 0), (4.2, 0), (4.2, 2.5), (4, 2.5)]
      , ring 0.7 [(4, 3.5), (4.2, 3.5), (4.2, 5.5), (4, 5.5)]
      , ring 0.7 [(4, 6.5), (4.2, 6.5), (4.2, 8), (4, 8)]
      , ring 0.7 [(4.2, 4.5), (7, 4.5), (7, 4.7), (4.2, 4.7)]
      , ring 0.7 [(8, 4.5), (12, 4.5), (12, 4.7), (8, 4.7)]
      , ring 0.4 [(1, 1), (2.5, 1.5), (2, 3), (0.5, 2.5)]
      , ring 0.4 [(9, 2), (10.5, 1.5), (11, 2.5), (9.5, 3)]
      , lamp [(6, 2), (6.2, 2), (6.2, 2.2), (6, 2.2)]
      , wall 1 [(12, 5.5), (12, 7)]
      ]
  ]
  where
    lit name around inside = rawCase place name (RawScene (Just (Text.pack name)) (Just around) inside)
    ring part corners' = described Nothing (rawPolygon (points corners')) (Material 0 part) Map.empty
    lamp corners' = described Nothing (rawPolygon (points corners')) (Material 1 0) Map.empty
    -- A wall one face of which shines.
    wall face ends =
      described Nothing (rawWall (points ends)) black (Map.singleton face (MaterialOverride (Just 1) Nothing))
    points = map (uncurry Point)
    -- Twelve corners, all exactly on the circle.
    circle x y r =
      [(x + r * a, y + r * b) | (a, b) <- quarter]
        <> [(x - r * b, y + r * a) | (a, b) <- quarter]
        <> [(x - r * a, y - r * b) | (a, b) <- quarter]
        <> [(x + r * b, y - r * a) | (a, b) <- quarter]
    quarter = [(1, 0), (15 / 17, 8 / 17), (8 / 17, 15 / 17)]

-- | What the elements are.
data Way
  = WholeSides
  | -- | Each side in equal parts.
    EqualPartsOf !Int
  | -- | Where shadows end.
    WhereShadowsEnd
  | -- | All break points, but at most so many elements on a side.
    AtMost !Int
  | AllBreaks
  | -- | All break points, and those of each side in equal parts.
    BreaksAndParts !Int
  deriving (Eq)

wayName :: Way -> String
wayName way = case way of
  WholeSides -> "no mesh"
  EqualPartsOf _ -> "uniform"
  WhereShadowsEnd -> "shadow limits"
  AtMost _ -> "bounded discontinuity mesh"
  AllBreaks -> "discontinuity mesh"
  BreaksAndParts _ -> "discontinuity and uniform"

wayParameter :: Way -> Maybe Int
wayParameter way = case way of
  EqualPartsOf n -> Just n
  AtMost n -> Just n
  BreaksAndParts n -> Just n
  _ -> Nothing

-- | The elements, swept anew where they depend on what is seen.
refinedBy :: Way -> Scene -> Refined
refinedBy way scene = case way of
  WholeSides -> unrefined scene
  EqualPartsOf n -> refined (uniform n)
  WhereShadowsEnd -> refined (shadowLimits swept)
  AtMost n -> refined (fst (bounded (counted n) swept))
  AllBreaks -> refined swept
  BreaksAndParts n -> refined (meshUnion swept (uniform n))
  where
    swept = discontinuityMesh scene (vertices scene)
    uniform n = uniformMesh (counted n) scene
    counted n = case elementCount n of
      Just count -> count
      Nothing -> broken "a side of a scene of the report has an element" (show n)

-- | Everything from the scene to the radiosities.
litBy :: Way -> Scene -> Radiosity
litBy way scene =
  case radiosityOfElements (WithinTolerance defaultTolerance) cut (measuresInPieces inside (verticesInPieces inside)) of
    Right found -> found
    Left shortfall -> broken "the radiosities of a scene of the report can be bounded" (show shortfall)
  where
    cut = refinedBy way scene
    inside = refinedScene cut

-- | Radiosity along each side of the file: what is between two parameters, by ascending parameter.
data Shine = Shine
  { shineSize :: !Int
  -- ^ How many elements.
  , shineSteps :: !(Map.Map SideName [Step])
  }

data Step = Step !Rational !Rational !Double

shineOf :: Radiosity -> Shine
shineOf found = Shine (length (litElements found)) (Map.map (sortOn from) (Map.fromListWith (<>) steps))
  where
    steps = map stepOf (litElements found)
    from (Step a _ _) = a
    stepOf l = (elementSide e, [Step (elementFrom e) (elementTo e) (middle (litRadiosity l))])
      where
        e = litElement l
    middle (low, high) = fromRational ((low + high) / 2)

-- | The largest distance of the bounds of an element, as a part of the largest radiosity.
widestBounds :: Radiosity -> Double
widestBounds found = fromRational (maximum (0 : map width bounds) / max (maximum (0 : map snd bounds)) least)
  where
    bounds = map litRadiosity (litElements found)
    width (low, high) = high - low
    -- Nothing shines less: no light, no distance.
    least = 1 / 10 ^ (30 :: Int)

-- | How far radiosities are from those of a reference, as parts of the mean of the reference over its elements.
data Distance = Distance
  { meanDistance :: !Double
  -- ^ Over the length of all elements of the reference.
  , largestDistance :: !Double
  }

-- | The distance of radiosities from a reference, which comes first. It is integrated over what elements of both have
-- in common; where these begin and end is exact. What is covered of a side belongs to no element of the reference, so
-- it does not count.
--
-- /Requires/ that the reference has no covered elements, as on a mesh.
distanceFrom :: Scene -> Shine -> Shine -> Distance
distanceFrom scene reference found =
  Distance (sum [l * d | (l, d, _) <- common] / lit) (maximum (0 : [d | (_, d, _) <- common]) * boundary / lit)
  where
    common = concatMap along (Map.toList (shineSteps reference))
    boundary = sum [l | (l, _, _) <- common]
    lit = sum [l * b | (l, _, b) <- common]
    along (side, steps) =
      [ (fromRational part * whole, abs (b - other), b)
      | let whole = nearestDouble (sideLength scene side)
      , (part, b, other) <- overlaps steps (Map.findWithDefault [] side (shineSteps found))
      ]

-- | What steps have in common: its part of the side, and both values.
overlaps :: [Step] -> [Step] -> [(Rational, Double, Double)]
overlaps (s@(Step a b x) : rest) (t@(Step c d y) : others) =
  [(high - low, x, y) | high > low]
    <> (if b <= d then overlaps rest (t : others) else overlaps (s : rest) others)
  where
    low = max a c
    high = min b d
overlaps _ _ = []
