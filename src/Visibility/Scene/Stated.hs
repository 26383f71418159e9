-- | What a file states, by number: its corners and its sides, polygon by polygon, the enclosure last.
module Visibility.Scene.Stated
  ( Stated (..)
  , statedFrom
    -- * Corners
  , statedTotal
  , statedName
  , statedNumber
    -- * Sides
  , statedSideTotal
  , statedSideName
  , statedSideNumber
  , statedWay
  ) where

import Data.Int (Int32)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.Point
import Visibility.Scene.Contact (rankedPoints)
import Visibility.Scene.Id
import Visibility.Scene.Outline
import Visibility.Scene.Raw

-- | Tables by number.
data Stated = Stated
  { statedIds :: !(V.Vector PolygonId)
  -- ^ By polygon.
  , statedPlaces :: !Places
  -- ^ By corner, on the lattice of the scene.
  , statedFirsts :: !(U.Vector Int)
  -- ^ By polygon: the number of its corner 0; then the number of corners.
  , statedOwners :: !(U.Vector Int32)
  -- ^ By corner: its polygon.
  , statedSideFirsts :: !(U.Vector Int)
  -- ^ By polygon: the number of its side 0; then the number of sides.
  , statedSideOwners :: !(U.Vector Int32)
  -- ^ By side: its polygon.
  , statedSideEnds :: !(U.Vector Int32)
  -- ^ The corners that side i joins at 2i and 2i+1.
  , statedMaterials :: !(V.Vector Material)
  -- ^ By side, overrides applied.
  }

-- | /Requires/ the shapes of the outline. /Cost/ O(n).
statedFrom :: [Shape] -> Outline -> Stated
statedFrom shapes o =
  Stated
    { statedIds = outlineIds o
    , statedPlaces = pointPlaces (rankedPoints (outlineRanked o))
    , statedFirsts = outlineFirst o
    , statedOwners = outlineOwner o
    , statedSideFirsts = firsts
    , statedSideOwners = owners
    , statedSideEnds = U.generate (2 * U.length owners) (\k -> fromIntegral (end (k `quot` 2) (k `rem` 2)))
    , statedMaterials = V.foldr seq materials materials
    }
  where
    firsts = sideFirsts o
    owners = ownersFrom firsts
    end s k = case outlineForms o V.! p of
      Ring -> if start + k == outlineFirst o U.! (p + 1) then first else start + k
      -- The second face goes back.
      Polyline
        | start + 1 < outlineFirst o U.! (p + 1) -> start + k
        | otherwise -> 2 * outlineFirst o U.! (p + 1) - 2 - start - k
      where
        p = fromIntegral (owners U.! s)
        first = outlineFirst o U.! p
        start = first + s - firsts U.! p
    materials = V.concat (zipWith materialsOf (map snd shapes) (polygonIndices o))
    materialsOf polygon p
      | Map.null (rawSides polygon) = V.replicate count material
      | otherwise = V.generate count (\k -> maybe material overridden (Map.lookup k (rawSides polygon)))
      where
        count = firsts U.! (p + 1) - firsts U.! p
        material = rawMaterial polygon
        overridden (MaterialOverride e r) =
          Material (fromMaybe (emission material) e) (fromMaybe (reflectivity material) r)

-- | The number of corners.
statedTotal :: Stated -> Int
statedTotal = U.length . statedOwners

statedName :: Stated -> Int -> CornerName
statedName stated i = CornerName (statedIds stated V.! p) (i - statedFirsts stated U.! p)
  where
    p = fromIntegral (statedOwners stated U.! i)

-- | 'Nothing' if there is no such corner.
statedNumber :: Stated -> CornerName -> Maybe Int
statedNumber stated (CornerName polygon k) = numberIn (statedFirsts stated) (polygonNumber stated polygon) k

-- | The number of sides.
statedSideTotal :: Stated -> Int
statedSideTotal = U.length . statedSideOwners

statedSideName :: Stated -> Int -> SideName
statedSideName stated i = SideName (statedIds stated V.! p) (i - statedSideFirsts stated U.! p)
  where
    p = fromIntegral (statedSideOwners stated U.! i)

-- | 'Nothing' if there is no such side.
statedSideNumber :: Stated -> SideName -> Maybe Int
statedSideNumber stated (SideName polygon k) = numberIn (statedSideFirsts stated) (polygonNumber stated polygon) k

-- | The way along a side, by number.
statedWay :: Stated -> Int -> Way
statedWay stated i = way (end 0) (end 1)
  where
    end k = placeAt (statedPlaces stated) (fromIntegral (statedSideEnds stated U.! (2 * i + k)))

numberIn :: U.Vector Int -> Maybe Int -> Int -> Maybe Int
numberIn firsts polygon k = case polygon of
  Just p | k >= 0, k < firsts U.! (p + 1) - firsts U.! p -> Just (firsts U.! p + k)
  _ -> Nothing

-- | Obstacles are numbered in order, the enclosure comes last.
polygonNumber :: Stated -> PolygonId -> Maybe Int
polygonNumber stated polygon = case polygon of
  Obstacle p | p >= 0, p < V.length ids, ids V.! p == polygon -> Just p
  Enclosure | not (V.null ids), V.last ids == Enclosure -> Just (V.length ids - 1)
  _ -> Nothing
  where
    ids = statedIds stated
