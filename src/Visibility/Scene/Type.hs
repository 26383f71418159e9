-- | The valid scene, as tables by 'CornerId'. "Visibility.Scene" shows it to the rest of the project without its
-- constructor; only "Visibility.Scene.Validate" makes one.
module Visibility.Scene.Type
  ( -- * The scene
    Scene
  , Surroundings (..)
  , ValidPolygon (..)
  , assemble
  , sceneTitle
  , surroundings
  , scenePoints
  , sceneLattice
  , sceneArithmetic
  , underArithmetic
    -- * Polygons
  , Polygon (..)
  , scenePolygons
    -- * Corners
  , cornerCount
  , corners
  , cornerName
  , cornerNamed
  , cornerAt
  , cornerPoint
  , nextCorner
  , previousCorner
  , neighbourTable
  , isWallCorner
    -- * Sides
  , sides
  , sideName
  , sideNamed
  , sideStart
  , sideEnd
  , sideMaterial
  , objectText
  , objectOrder
  ) where

import Data.Char (isControl)
import Data.Int (Int32)
import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Scene.Id
import Visibility.Scene.Raw (Material)

-- | What lies beyond all polygons.
data Surroundings
  = -- | The sky, infinitely far.
    OpenSky
  | -- | An enclosure whose outside is opaque.
    Room
  deriving (Eq, Ord, Show)

-- | A scene whose polygons are simple and pairwise disjoint, and lie inside the enclosure if there is one.
-- Everything is indexed by 'CornerId', the rank in lexicographic order.
data Scene = Scene
  { sceneTitle :: !(Maybe Text)
  -- ^ The name that the file gives, fit to be shown: control characters are replaced by U+FFFD, here as in names of
  -- polygons.
  , surroundings :: !Surroundings
  , sceneLattice :: !Lattice
  , sceneArithmetic :: !Arithmetic
  , scenePoints :: !Points
  -- ^ Lattice coordinates of the corners, by 'CornerId'.
  , neighbourTable :: !(U.Vector Int32)
  -- ^ 'nextCorner' and 'previousCorner' of corner i at 2i and 2i+1: close together, as the sweep asks for both.
  , cornerNames :: !(V.Vector CornerName)
  , sideNames :: !(V.Vector SideName)
  , materials :: !(V.Vector Material)
  , cornersByName :: !(Map.Map CornerName CornerId)
  , scenePolygons :: ![Polygon]
  -- ^ In the file's order, the enclosure last.
  }

-- | A polygon of a scene, its corners so that the solid lies on the left of each side (an obstacle counter-clockwise,
-- the enclosure clockwise), beginning with the file's corner 0. Two corners: a thin wall.
data Polygon = Polygon
  { polygonId :: !PolygonId
  , polygonName :: !(Maybe Text)
  , polygonCorners :: ![CornerId]
  }
  deriving (Eq, Show)

-- | A polygon that has passed every check: its corners in the file's order, and the material of each of the file's
-- sides.
data ValidPolygon = ValidPolygon
  { validId :: !PolygonId
  , validName :: !(Maybe Text)
  , validCorners :: ![Point]
  , validMaterials :: ![Material]
  }

-- | Puts checked polygons into tables.
--
-- /Requires/ what "Visibility.Scene.Validate" checks: at least one polygon, each with two or more distinct corners,
-- simple, without spikes, all disjoint. /Cost/ O(n log n).
assemble :: Maybe Text -> [ValidPolygon] -> Scene
assemble title polygons =
  Scene
    { sceneTitle = shown <$> title
    , surroundings = if any ((== Enclosure) . validId) polygons then Room else OpenSky
    , sceneLattice = lattice
    , sceneArithmetic = Filtered
    , scenePoints = points
    , neighbourTable = U.replicate (2 * n) 0 U.// concatMap (beside . map raw . polygonCorners) placed
    , cornerNames = V.fromList [name | (_, name) <- ordered]
    , sideNames = V.replicate n (SideName Enclosure 0) V.// [(c, name) | (c, name, _) <- faces]
    , materials = V.fromList [m | (_, _, m) <- sortOn (\(c, _, _) -> c) faces]
    , cornersByName = ranks
    , scenePolygons = placed
    }
  where
    lattice = latticeFor (concatMap validCorners polygons)
    ordered =
      sortOn
        id
        [ (ontoLattice lattice point, CornerName (validId polygon) k)
        | polygon <- polygons
        , (k, point) <- zip [0 ..] (validCorners polygon)
        ]
    n = length ordered
    points = pointsOn Filtered (map fst ordered)
    ranks = Map.fromList [(name, CornerId i) | (i, (_, name)) <- zip [0 ..] ordered]
    oriented = [(polygon, solidLeft polygon) | polygon <- polygons]
    placed =
      [ Polygon (validId polygon) (shown <$> validName polygon) [c | (c, _, _) <- loop]
      | (polygon, loop) <- oriented
      ]
    faces = [(c, name, material) | (_, loop) <- oriented, (CornerId c, name, material) <- loop]
    beside loop =
      concat
        [ [(2 * c, fromIntegral after), (2 * c + 1, fromIntegral before)]
        | (before, c, after) <- zip3 (rotated (-1) loop) loop (rotated 1 loop)
        ]
    raw (CornerId c) = c
    shown = Text.map (\c -> if isControl c then '\xFFFD' else c)

    -- The corners of a polygon with the solid on their left, each with the name and material of the side it starts.
    solidLeft polygon
      | length loop > 2, orientation (map fst loop) /= wanted = backwardLoop
      | otherwise = [(c, SideName p k, m) | ((c, k), m) <- zip loop (validMaterials polygon)]
      where
        p = validId polygon
        loop =
          [ (ranks Map.! CornerName p k, k)
          | k <- [0 .. length (validCorners polygon) - 1]
          ]
        wanted = if p == Enclosure then RightTurn else LeftTurn
        -- Backwards from corner 0: the side that starts at file corner k is then file side k − 1.
        backwardLoop =
          let backwards = take 1 loop <> reverse (drop 1 loop)
              sidesBack = reverse (zip [0 ..] (validMaterials polygon))
           in [(c, SideName p k, m) | ((c, _), (k, m)) <- zip backwards sidesBack]

    -- The turn at the lexicographically least corner, which is convex and not flat in a simple polygon.
    orientation loop = case [(b, a, c) | (a, b, c) <- zip3 (rotated (-1) loop) loop (rotated 1 loop)] of
      [] -> Collinear
      turns -> let (CornerId b, CornerId a, CornerId c) = minimum turns in turn points a b c
    rotated k loop = take (length loop) (drop (k `mod` length loop) (cycle loop))

-- | The same scene, its signs decided in another way.
underArithmetic :: Arithmetic -> Scene -> Scene
underArithmetic arithmetic scene =
  scene {sceneArithmetic = arithmetic, scenePoints = withArithmetic arithmetic (scenePoints scene)}

-- | n, the number of corners.
cornerCount :: Scene -> Int
cornerCount = V.length . cornerNames

-- | All corners in lexicographic order.
corners :: Scene -> [CornerId]
corners scene = map CornerId [0 .. cornerCount scene - 1]

-- | What the file calls this corner.
cornerName :: Scene -> CornerId -> CornerName
cornerName scene (CornerId c) = cornerNames scene V.! c

-- | The corner that the file calls so.
cornerNamed :: Scene -> CornerName -> Maybe CornerId
cornerNamed scene name = Map.lookup name (cornersByName scene)

-- | A corner on the lattice.
cornerAt :: Scene -> CornerId -> Vector2
cornerAt scene (CornerId c) = pointAt (scenePoints scene) c

-- | A corner in the file's coordinates.
cornerPoint :: Scene -> CornerId -> Point
cornerPoint scene = fromLattice (sceneLattice scene) . cornerAt scene

-- | The following corner of the same polygon, the solid being on the left on the way to it.
nextCorner :: Scene -> CornerId -> CornerId
nextCorner scene (CornerId c) = CornerId (fromIntegral (neighbourTable scene U.! (2 * c)))
{-# INLINE nextCorner #-}

-- | The preceding corner of the same polygon. For an end of a thin wall it is the same as the following one.
previousCorner :: Scene -> CornerId -> CornerId
previousCorner scene (CornerId c) = CornerId (fromIntegral (neighbourTable scene U.! (2 * c + 1)))
{-# INLINE previousCorner #-}

-- | Is this an end of a thin wall?
isWallCorner :: Scene -> CornerId -> Bool
isWallCorner scene c = nextCorner scene c == previousCorner scene c
{-# INLINE isWallCorner #-}

-- | All sides, by their starting corners.
sides :: Scene -> [SideId]
sides scene = map SideId [0 .. cornerCount scene - 1]

-- | What the file calls this side.
sideName :: Scene -> SideId -> SideName
sideName scene (SideId s) = sideNames scene V.! s

-- | The side that the file calls so. /Cost/ O(n).
sideNamed :: Scene -> SideName -> Maybe SideId
sideNamed scene name = SideId <$> V.elemIndex name (sideNames scene)

-- | Where a side starts when the solid is kept on its left.
sideStart :: SideId -> CornerId
sideStart (SideId s) = CornerId s

-- | Where it ends.
sideEnd :: Scene -> SideId -> CornerId
sideEnd scene = nextCorner scene . sideStart

-- | The material of a side, overrides applied.
sideMaterial :: Scene -> SideId -> Material
sideMaterial scene (SideId s) = materials scene V.! s

-- | @3.0@, @E.2@ or @sky@.
objectText :: Scene -> Object -> String
objectText scene (Side s) = sideText (sideName scene s)
objectText _ Sky = "sky"

-- | What to sort objects by: sides by their names, the sky last.
objectOrder :: Scene -> Object -> (Int, Maybe SideName)
objectOrder scene (Side s) = (0, Just (sideName scene s))
objectOrder _ Sky = (1, Nothing)
