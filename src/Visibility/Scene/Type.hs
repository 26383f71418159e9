{-# LANGUAGE BangPatterns #-}

-- | The valid scene, as tables by 'CornerId'. "Visibility.Scene" shows it to the rest of the project without its
-- constructor; only "Visibility.Scene.Validate" makes one.
module Visibility.Scene.Type
  ( -- * The scene
    Scene (..)
  , Surroundings (..)
  , assemble
  , sceneOn
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
  , namesHereTotal
  , cornersNamed
  , polygonSizes
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
  , sideEnds
  , statedMaterial
  , uncovered
  , seenAs
  , objectText
  ) where

import Data.Char (isControl)
import Data.Int (Int32)
import Data.List (groupBy)
import Data.Maybe (fromMaybe)
import Data.Ratio ((%))
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Law (broken)
import Visibility.Scene.Boundary (Boundary (..))
import Visibility.Scene.Id
import Visibility.Scene.Outline
import Visibility.Scene.Raw (Form, Material, RawPolygon (..))
import Visibility.Scene.Stated
import Visibility.Sorting

-- | What lies beyond all polygons.
data Surroundings
  = -- | The sky, infinitely far.
    OpenSky
  | -- | An enclosure whose outside is opaque.
    Room
  deriving (Eq, Ord, Show)

-- | A scene whose polygons are simple and do not overlap, and lie inside the enclosure if there is one; they may touch.
-- Tables are by 'CornerId' where nothing else is said. Shown as @\<scene: 12 polygons, 48 corners\>@, counted as in the
-- file.
data Scene = Scene
  { sceneTitle :: !(Maybe Text)
  -- ^ The name that the file gives, fit to be shown: control characters are replaced by U+FFFD, here as in names of
  -- polygons.
  , surroundings :: !Surroundings
  , sceneLattice :: !Lattice
  , sceneArithmetic :: !Arithmetic
  , scenePoints :: !Points
  -- ^ Lattice coordinates of the corners.
  , neighbourTable :: !(U.Vector Int32)
  -- ^ 'nextCorner' and 'previousCorner' of corner i at 2i and 2i+1: close together, as the sweep asks for both.
  , placeNumbers :: !(U.Vector Int32)
  -- ^ The number of a corner's place in lexicographic order; places without free space are counted too.
  , hasSharedPlaces :: !Bool
  -- ^ Are several corners in one place, of the file or of free space?
  , splitEnds :: !(U.Vector Bool)
  -- ^ See 'isSplitEnd'. Empty if there are none.
  , sceneStated :: !Stated
  , statedPlaceNumbers :: !(U.Vector Int32)
  -- ^ By stated corner, the number of its place.
  , namingCorners :: !(U.Vector Int32)
  -- ^ The stated corner that gives a corner its name, by its place in 'statedCorners'.
  , facedSides :: !(U.Vector Int32)
  -- ^ The stated side that begins at a corner, or of which a piece does, by its place in 'statedSides'.
  , statedByPlace :: Buckets
  -- ^ The stated corners in each place. Made when it is first needed, as is the next one.
  , piecesBySide :: Buckets
  -- ^ By stated side, the corners at which pieces of it begin.
  , sceneContacts :: !Int
  -- ^ How many places there are where stated corners touch other corners or sides.
  , scenePolygons :: [Polygon]
  -- ^ In the file's order, the enclosure last. Made when they are first needed.
  }

instance Show Scene where
  show scene = "<scene: " <> show (length sizes) <> " polygons, " <> show (sum (map snd sizes)) <> " corners>"
    where
      sizes = polygonSizes scene

-- | A polygon of a scene as the file states it: its corners in the file's order, made when they are first needed.
data Polygon = Polygon
  { polygonId :: !PolygonId
  , polygonName :: !(Maybe Text)
  , polygonForm :: !Form
  , polygonPoints :: [Point]
  }
  deriving (Eq, Show)

-- | Puts checked polygons and the boundary of free space between them into tables.
--
-- /Requires/ what "Visibility.Scene.Validate" checks. The number is that of the places of contact. /Cost/ O(n log n).
assemble :: Maybe Text -> Int -> [Shape] -> Outline -> Boundary -> Scene
assemble title touching shapes o = sceneOn (shown <$> title) lattice touching polygons stated
  where
    polygons = polygonsFrom stated lattice forms names
    stated = statedFrom shapes o
    -- What is made later holds no more of the outline than it needs, and nothing of the file.
    !lattice = outlineLattice o
    !forms = outlineForms o
    !names = foldr (\(_, polygon) rest -> let !name = nameOf polygon; !others = rest in name : others) [] shapes
    nameOf polygon = case rawPolygonName polygon of
      Nothing -> Nothing
      Just name -> Just $! shown name
    shown = Text.map (\c -> if isControl c then '\xFFFD' else c)

-- | A scene with all that follows from what is stated and from the boundary of free space. Given are besides its title,
-- its lattice, the number of the places of contact, and its polygons. /Cost/ O(n log n).
sceneOn :: Maybe Text -> Lattice -> Int -> [Polygon] -> Stated -> Boundary -> Scene
sceneOn title lattice touching polygons stated boundary =
  Scene
    { sceneTitle = title
    , surroundings = if Enclosure `V.elem` statedIds stated then Room else OpenSky
    , sceneLattice = lattice
    , sceneArithmetic = Filtered
    , scenePoints = points
    , neighbourTable = neighbours
    , placeNumbers = places
    , hasSharedPlaces = touching > 0 || U.or (U.zipWith (==) places (U.drop 1 places))
    , splitEnds = splitEndsOf points neighbours
    , sceneStated = stated
    , statedPlaceNumbers = numbers
    , namingCorners = freeNames boundary
    , facedSides = faced
    , statedByPlace = bucketsBy (if U.null numbers then 0 else 1 + fromIntegral (U.maximum numbers)) numbers
    , piecesBySide = bucketsBy (statedSideTotal stated) faced
    , sceneContacts = touching
    , scenePolygons = polygons
    }
  where
    points = pointsOn Filtered (rearranged (freePlaces boundary) (statedPlaces stated))
    neighbours = neighboursAlong (freeNexts boundary)
    places = U.map (\i -> numbers U.! fromIntegral i) (freePlaces boundary)
    -- What is made later holds no more of the boundary than it needs.
    !numbers = statedNumbers boundary
    !faced = freeSides boundary

-- Polygons with these forms and names.
polygonsFrom :: Stated -> Lattice -> V.Vector Form -> [Maybe Text] -> [Polygon]
polygonsFrom stated lattice forms = zipWith polygon [0 ..]
  where
    polygon p name = Polygon (statedIds stated V.! p) name (forms V.! p) (map point (members p))
    members p = [statedFirsts stated U.! p .. statedFirsts stated U.! (p + 1) - 1]
    point = fromLattice lattice . placeAt (statedPlaces stated)

-- | 'neighbourTable' from the corner that follows each.
neighboursAlong :: U.Vector Int32 -> U.Vector Int32
neighboursAlong following = U.create $ do
  table <- M.new (2 * U.length following)
  U.forM_ (U.indexed following) $ \(i, j) -> do
    M.write table (2 * i) j
    M.write table (2 * fromIntegral j + 1) (fromIntegral i)
  pure table

-- | 'splitEnds' of a scene.
splitEndsOf :: Points -> U.Vector Int32 -> U.Vector Bool
splitEndsOf points neighbours = if U.or split then split else U.empty
  where
    split = U.generate (U.length neighbours `quot` 2) isSplit
    isSplit i = before /= after && turn points i before after == Collinear && (before > i) == (after > i)
      where
        after = fromIntegral (neighbours U.! (2 * i))
        before = fromIntegral (neighbours U.! (2 * i + 1))

-- | The same scene, its signs decided in another way.
underArithmetic :: Arithmetic -> Scene -> Scene
underArithmetic arithmetic scene =
  scene {sceneArithmetic = arithmetic, scenePoints = withArithmetic arithmetic (scenePoints scene)}

-- | n, the number of corners.
cornerCount :: Scene -> Int
cornerCount = U.length . placeNumbers

-- | All corners in lexicographic order.
corners :: Scene -> [CornerId]
corners scene = map CornerId [0 .. cornerCount scene - 1]

-- | A corner on the lattice.
cornerAt :: Scene -> CornerId -> LatticePoint
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
cornerName scene (CornerId c) = statedName (sceneStated scene) (fromIntegral (namingCorners scene U.! c))

-- | All corners of the file in the place of this one, in order.
namesHere :: Scene -> CornerId -> [CornerName]
namesHere scene = map (statedName (sceneStated scene) . fromIntegral) . U.toList . statedHere scene

-- | How many they are. /Cost/ O(1).
namesHereTotal :: Scene -> CornerId -> Int
namesHereTotal scene = U.length . statedHere scene

-- Those corners, by their places in 'statedCorners'.
statedHere :: Scene -> CornerId -> U.Vector Int32
statedHere scene (CornerId c) = bucketSlice (statedByPlace scene) (fromIntegral (placeNumbers scene U.! c))

-- | The corners of free space in the place of a corner of the file: one for each cone, none where it is all covered;
-- 'Nothing' if the file has no such corner. /Cost/ O(log n).
cornersNamed :: Scene -> CornerName -> Maybe [CornerId]
cornersNamed scene name = cornersIn <$> statedNumber (sceneStated scene) name
  where
    cornersIn i = map CornerId (takeWhile ((== place) . (places U.!)) [first .. n - 1])
      where
        place = statedPlaceNumbers scene U.! i
        first = firstWhere ((>= place) . (places U.!)) 0 n
    places = placeNumbers scene
    n = cornerCount scene

-- | All polygons of the file, the enclosure last, each with the number of its corners.
polygonSizes :: Scene -> [(PolygonId, Int)]
polygonSizes scene = zip (V.toList (statedIds stated)) (zipWith (-) (drop 1 firsts) firsts)
  where
    stated = sceneStated scene
    firsts = U.toList (statedFirsts stated)

-- | All corners of the file, polygon by polygon.
statedCorners :: Scene -> [(CornerName, Point)]
statedCorners scene = [(statedName stated i, fromLattice (sceneLattice scene) place) | (i, place) <- zip [0 ..] places]
  where
    stated = sceneStated scene
    places = placeList (statedPlaces stated)

-- | Where a corner of the file is.
statedPoint :: Scene -> CornerName -> Maybe Point
statedPoint scene name = fromLattice (sceneLattice scene) . placeAt (statedPlaces stated) <$> statedNumber stated name
  where
    stated = sceneStated scene

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
sideMaterial scene (SideId s) = materialOf (sceneStated scene) (fromIntegral (facedSides scene U.! s))

-- | What the file calls this side, or the one that it is a piece of.
sideName :: Scene -> SideId -> SideName
sideName scene (SideId s) = statedSideName (sceneStated scene) (fromIntegral (facedSides scene U.! s))

-- | All sides of the file, by name, those that are all covered too.
statedSides :: Scene -> [SideName]
statedSides scene = map (statedSideName stated) [0 .. statedSideTotal stated - 1]
  where
    stated = sceneStated scene

-- | What is not covered of a side of the file: the side itself, or pieces of it, or nothing; 'Nothing' if the file has
-- no such side.
piecesOf :: Scene -> SideName -> Maybe [SideId]
piecesOf scene name = map SideId . bucketOf (piecesBySide scene) <$> statedSideNumber (sceneStated scene) name

-- | The way along a side of the file on the lattice, whole, whatever covers it. /Requires/ the name of a side.
sideSpan :: Scene -> SideName -> Way
sideSpan scene = statedWay (sceneStated scene) . sideNumber scene

-- | Where a side of the file begins and ends in the order of the file, whatever covers it. /Requires/ the name of a
-- side.
sideEnds :: Scene -> SideName -> (Point, Point)
sideEnds scene name = (end 0, end 1)
  where
    stated = sceneStated scene
    end k = fromLattice (sceneLattice scene) (placeAt (statedPlaces stated) (corner k))
    corner k = fromIntegral (statedSideEnds stated U.! (2 * sideNumber scene name + k))

-- | The material of a side of the file. /Requires/ the name of a side.
statedMaterial :: Scene -> SideName -> Material
statedMaterial scene name = materialOf (sceneStated scene) (sideNumber scene name)

-- | The place in 'statedSides' of a name. /Requires/ the name of a side.
sideNumber :: Scene -> SideName -> Int
sideNumber scene name = fromMaybe (broken "a side has the name of one of the file" (sideText name)) $
  statedSideNumber (sceneStated scene) name

-- | The part of a side that nothing covers, from 0 to 1. /Requires/ the name of a side.
uncovered :: Scene -> SideName -> Rational
uncovered scene name = sum [along (pieceSpan s) / along whole | s <- fromMaybe [] (piecesOf scene name)]
  where
    whole@(Way (Vector2 dx _) _) = sideSpan scene name
    along (Way (Vector2 x y) w) = abs (if dx == 0 then y else x) % w
    pieceSpan s = way (cornerAt scene (sideStart s)) (cornerAt scene (sideEnd scene s))

-- | What the file calls an object.
seenAs :: Scene -> Object -> Seen
seenAs scene (Side s) = TheSide (sideName scene s)
seenAs _ Sky = TheSky

-- | @3.0@, @E.2@ or @sky@.
objectText :: Scene -> Object -> String
objectText scene = seenText . seenAs scene
