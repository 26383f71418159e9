-- | The valid scene, as tables by 'CornerId'. "Visibility.Scene" shows it to the rest of the project without its
-- constructor; only "Visibility.Scene.Validate" makes one.
module Visibility.Scene.Type
  ( -- * The scene
    Scene (..)
  , Surroundings (..)
  , StatedPolygon (..)
  , assemble
  , underArithmetic
    -- * Polygons
  , Polygon (..)
  , statedCorners
    -- * Corners
  , cornerCount
  , corners
  , cornerAt
  , cornerPoint
  , nextCorner
  , previousCorner
  , samePlace
  , placeGroups
  , isWallEnd
  , isSplitEnd
  , hasSplitEnds
    -- ** Their names
  , cornerName
  , namesHere
  , cornersNamed
  , statedPoint
    -- * Sides
  , sides
  , sideStart
  , sideEnd
  , sideMaterial
    -- ** Their names
  , sideName
  , statedSides
  , piecesOf
  , sideSpan
  , uncovered
  , seenAs
  , objectText
  ) where

import Data.Char (isControl)
import Data.Int (Int32)
import Data.List (groupBy)
import Data.Function (on)
import qualified Data.Map.Strict as Map
import Data.Ratio ((%))
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Law (broken)
import Visibility.Scene.Boundary (FreeCorner (..))
import Visibility.Scene.Id
import Visibility.Scene.Raw (Form (..), Material)

-- | What lies beyond all polygons.
data Surroundings
  = -- | The sky, infinitely far.
    OpenSky
  | -- | An enclosure whose outside is opaque.
    Room
  deriving (Eq, Ord, Show)

-- | A scene whose polygons are simple and do not overlap, and lie inside the enclosure if there is one; they may touch.
-- Everything is indexed by 'CornerId'. The tables by name are made when they are first needed.
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
  , placeNumbers :: !(U.Vector Int32)
  -- ^ By corner, the number of its place in lexicographic order; places without free space are counted too.
  , hasSharedPlaces :: !Bool
  -- ^ Are several corners in one place, of the file or of free space?
  , splitEnds :: !(U.Vector Bool)
  -- ^ By corner: see 'isSplitEnd'. Empty if there are none.
  , cornerNames :: !(V.Vector CornerName)
  , sideNames :: !(V.Vector SideName)
  , cornersByName :: (Map.Map CornerName [CornerId])
  , namesByCorner :: (V.Vector [CornerName])
  , piecesByName :: (Map.Map SideName [SideId])
  , sceneContacts :: !Int
  -- ^ How many places there are where stated corners touch other corners or sides.
  , statedByName :: (Map.Map SideName (Vector2, Material))
  -- ^ Every side of the file, covered or not: the way along it on the lattice, and its material.
  , scenePolygons :: ![Polygon]
  -- ^ In the file's order, the enclosure last.
  }

-- | A polygon of a scene as the file states it: its corners in the file's order.
data Polygon = Polygon
  { polygonId :: !PolygonId
  , polygonName :: !(Maybe Text)
  , polygonForm :: !Form
  , polygonPoints :: ![Point]
  }
  deriving (Eq, Show)

-- | A polygon that has passed every check: its corners in the file's order, and the material of each of the file's
-- sides.
data StatedPolygon = StatedPolygon
  { statedId :: !PolygonId
  , statedTitle :: !(Maybe Text)
  , statedForm :: !Form
  , statedPoints :: ![Point]
  , statedMaterials :: ![Material]
  }

-- | Puts checked polygons and the boundary of free space between them into tables.
--
-- /Requires/ what "Visibility.Scene.Validate" checks; the corners of the boundary give places as indices of the stated
-- corners of all polygons, in order. The number is that of the places of contact. /Cost/ O(n log n).
assemble :: Maybe Text -> Int -> [StatedPolygon] -> [FreeCorner] -> Scene
assemble title touching polygons boundary =
  Scene
    { sceneTitle = shown <$> title
    , surroundings = if any ((== Enclosure) . statedId) polygons then Room else OpenSky
    , sceneLattice = lattice
    , sceneArithmetic = Filtered
    , scenePoints = points
    , neighbourTable = neighbours
    , placeNumbers = places
    , hasSharedPlaces = touching > 0 || U.or (U.zipWith (==) places (U.drop 1 places))
    , splitEnds = if U.or split then split else U.empty
    , cornerNames = V.map freeName free
    , sideNames = V.map freeSide free
    , cornersByName = Map.fromList [(name, cornersAt at) | (at, names) <- Map.toList namesAt, name <- names]
    , namesByCorner = V.fromList [Map.findWithDefault [] (placeOf f) namesAt | f <- boundary]
    , piecesByName =
        Map.fromListWith (flip (<>)) [(freeSide f, [SideId i]) | (i, f) <- zip [0 ..] (V.toList free)]
    , sceneContacts = touching
    , statedByName = Map.fromList (concatMap sidesOf polygons)
    , scenePolygons =
        [Polygon (statedId p) (shown <$> statedTitle p) (statedForm p) (statedPoints p) | p <- polygons]
    }
  where
    lattice = latticeFor (concatMap statedPoints polygons)
    stated =
      V.fromList
        [ (ontoLattice lattice point, CornerName (statedId polygon) k)
        | polygon <- polygons
        , (k, point) <- zip [0 ..] (statedPoints polygon)
        ]
    placeOf f = fst (stated V.! freePlace f)
    free = V.fromList boundary
    n = V.length free
    points = pointsOn Filtered (map placeOf boundary)
    neighbours =
      U.replicate (2 * n) 0
        U.// concat [[(2 * i, fromIntegral j), (2 * j + 1, fromIntegral i)] | (i, j) <- zip [0 ..] following]
    following = map freeNext boundary
    places = U.fromListN n (map (fromIntegral . freeNumber) boundary)
    byPlace = groupBy ((==) `on` fst) (zip (map placeOf boundary) (map CornerId [0 ..]))
    cornersByPlace = Map.fromList [(at, map snd group) | group@((at, _) : _) <- byPlace]
    cornersAt at = Map.findWithDefault [] at cornersByPlace
    namesAt = Map.fromListWith (flip (<>)) [(at, [name]) | (at, name) <- V.toList stated]
    split = U.generate n isSplit
    isSplit i = before /= after && turn points i before after == Collinear && (before > i) == (after > i)
      where
        after = fromIntegral (neighbours U.! (2 * i))
        before = fromIntegral (neighbours U.! (2 * i + 1))
    sidesOf polygon =
      [ (SideName (statedId polygon) k, (difference (along V.! i) (along V.! j), material))
      | (k, (i, j), material) <- zip3 [0 ..] (sideEnds (statedForm polygon) (V.length along)) (statedMaterials polygon)
      ]
      where
        along = V.fromList (map (ontoLattice lattice) (statedPoints polygon))
    shown = Text.map (\c -> if isControl c then '\xFFFD' else c)

-- | The corners that the sides of a polygon of so many corners join, by the numbers of the sides.
sideEnds :: Form -> Int -> [(Int, Int)]
sideEnds Ring n = zip [0 .. n - 1] ([1 .. n - 1] <> [0])
sideEnds Polyline n = forth <> map (\(i, j) -> (j, i)) (reverse forth)
  where
    forth = zip [0 .. n - 2] [1 ..]

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

-- | A corner on the lattice.
cornerAt :: Scene -> CornerId -> Vector2
cornerAt scene (CornerId c) = pointAt (scenePoints scene) c

-- | A corner in the file's coordinates.
cornerPoint :: Scene -> CornerId -> Point
cornerPoint scene = fromLattice (sceneLattice scene) . cornerAt scene

-- | The following corner of the same walk, the solid being on the left on the way to it.
nextCorner :: Scene -> CornerId -> CornerId
nextCorner scene (CornerId c) = CornerId (fromIntegral (neighbourTable scene U.! (2 * c)))
{-# INLINE nextCorner #-}

-- | The preceding corner of the same walk. For an end of a thin wall that stands alone it is the same as the following
-- one.
previousCorner :: Scene -> CornerId -> CornerId
previousCorner scene (CornerId c) = CornerId (fromIntegral (neighbourTable scene U.! (2 * c + 1)))
{-# INLINE previousCorner #-}

-- | Are two corners in one place, though in different cones of free space there?
samePlace :: Scene -> CornerId -> CornerId -> Bool
samePlace scene (CornerId c) (CornerId d) = placeNumbers scene U.! c == placeNumbers scene U.! d
{-# INLINE samePlace #-}

-- | All corners, those of one place together.
placeGroups :: Scene -> [[CornerId]]
placeGroups scene = groupBy (samePlace scene) (corners scene)

-- | Is free space all around this corner, so that both of its sides are the faces of one piece of a thin wall?
isWallEnd :: Scene -> CornerId -> Bool
isWallEnd scene c = nextCorner scene c == previousCorner scene c || isSplitEnd scene c
{-# INLINE isWallEnd #-}

-- | Is this a free end of a thin wall whose faces lead to two different corners, because something touches the wall, or
-- because it has a corner there?
isSplitEnd :: Scene -> CornerId -> Bool
isSplitEnd scene (CornerId c) = not (U.null (splitEnds scene)) && splitEnds scene U.! c
{-# INLINE isSplitEnd #-}

-- | Is there any such end?
hasSplitEnds :: Scene -> Bool
hasSplitEnds = not . U.null . splitEnds
{-# INLINE hasSplitEnds #-}

-- | What the file calls this corner: of the stated corners in its place, the first that belongs to a polygon on one of
-- its flanks. Different corners in one place may have one name.
cornerName :: Scene -> CornerId -> CornerName
cornerName scene (CornerId c) = cornerNames scene V.! c

-- | All corners of the file in the place of this one, in order.
namesHere :: Scene -> CornerId -> [CornerName]
namesHere scene (CornerId c) = namesByCorner scene V.! c

-- | The corners of free space in the place of a corner of the file: one for each cone, none where it is all covered;
-- 'Nothing' if the file has no such corner.
cornersNamed :: Scene -> CornerName -> Maybe [CornerId]
cornersNamed scene name = Map.lookup name (cornersByName scene)

-- | All corners of the file, polygon by polygon.
statedCorners :: Scene -> [(CornerName, Point)]
statedCorners scene =
  [ (CornerName (polygonId polygon) k, point)
  | polygon <- scenePolygons scene
  , (k, point) <- zip [0 ..] (polygonPoints polygon)
  ]

-- | Where a corner of the file is.
statedPoint :: Scene -> CornerName -> Maybe Point
statedPoint scene (CornerName p k) =
  case [drop k (polygonPoints polygon) | k >= 0, polygon <- scenePolygons scene, polygonId polygon == p] of
    (point : _) : _ -> Just point
    _ -> Nothing

-- | All sides and uncovered pieces of sides, by their starting corners.
sides :: Scene -> [SideId]
sides scene = map SideId [0 .. cornerCount scene - 1]

-- | Where a side starts when the solid is kept on its left.
sideStart :: SideId -> CornerId
sideStart (SideId s) = CornerId s

-- | Where it ends.
sideEnd :: Scene -> SideId -> CornerId
sideEnd scene = nextCorner scene . sideStart

-- | The material of a side, overrides applied.
sideMaterial :: Scene -> SideId -> Material
sideMaterial scene s = snd (statedSide scene (sideName scene s))

statedSide :: Scene -> SideName -> (Vector2, Material)
statedSide scene name = case Map.lookup name (statedByName scene) of
  Just found -> found
  Nothing -> broken "a side has the name of one of the file" (sideText name)

-- | What the file calls this side, or the one that it is a piece of.
sideName :: Scene -> SideId -> SideName
sideName scene (SideId s) = sideNames scene V.! s

-- | All sides of the file, by name, those that are all covered too.
statedSides :: Scene -> [SideName]
statedSides = Map.keys . statedByName

-- | What is not covered of a side of the file: the side itself, or pieces of it, or nothing; 'Nothing' if the file has
-- no such side.
piecesOf :: Scene -> SideName -> Maybe [SideId]
piecesOf scene name
  | name `Map.member` statedByName scene = Just (Map.findWithDefault [] name (piecesByName scene))
  | otherwise = Nothing

-- | The way along a side of the file on the lattice, whole, whatever covers it. /Requires/ the name of a side.
sideSpan :: Scene -> SideName -> Vector2
sideSpan scene = fst . statedSide scene

-- | The part of a side that nothing covers, from 0 to 1. /Requires/ the name of a side.
uncovered :: Scene -> SideName -> Rational
uncovered scene name = sum [along (pieceSpan s) % along whole | s <- Map.findWithDefault [] name (piecesByName scene)]
  where
    whole@(Vector2 dx _) = sideSpan scene name
    along (Vector2 x y) = abs (if dx == 0 then y else x)
    pieceSpan s = difference (cornerAt scene (sideStart s)) (cornerAt scene (sideEnd scene s))

-- | What the file calls an object.
seenAs :: Scene -> Object -> Seen
seenAs scene (Side s) = TheSide (sideName scene s)
seenAs _ Sky = TheSky

-- | @3.0@, @E.2@ or @sky@.
objectText :: Scene -> Object -> String
objectText scene = seenText . seenAs scene
