{-# LANGUAGE BangPatterns #-}

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
  , materialOf
  ) where

import Data.Int (Int32)
import qualified Data.IntMap.Strict as IntMap
import qualified Data.Map.Strict as Map
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
  , statedSideEnds :: U.Vector Int32
  -- ^ The corners that side i joins at 2i and 2i+1. Made when it is first needed.
  , statedMaterials :: !(V.Vector Material)
  -- ^ By polygon: the material of all its sides but for the next ones.
  , statedOverrides :: !(IntMap.IntMap Material)
  -- ^ By side, if it has a material of its own.
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
    , statedSideEnds = sideEndsFrom forms cornerFirsts firsts owners
    , statedMaterials = V.foldr seq materials materials
    , statedOverrides =
        IntMap.fromList
          [ (firsts U.! p + k, materialWith (rawMaterial polygon) own)
          | (p, (_, polygon)) <- zip [0 ..] shapes
          , (k, own) <- Map.toList (rawSides polygon)
          ]
    }
  where
    !firsts = sideFirsts o
    !owners = ownersFrom firsts
    -- What is made later holds no more of the outline.
    !forms = outlineForms o
    !cornerFirsts = outlineFirst o
    materials = V.fromListN (length shapes) (map (shared . rawMaterial . snd) shapes)
    -- Of the most frequent one there is one only in memory.
    shared material = if material == black then black else material

-- 'statedSideEnds' from the forms of polygons, their first corners and sides, and the polygons of sides.
sideEndsFrom :: V.Vector Form -> U.Vector Int -> U.Vector Int -> U.Vector Int32 -> U.Vector Int32
sideEndsFrom forms cornerFirsts firsts owners =
  U.generate (2 * U.length owners) (\k -> fromIntegral (end (k `quot` 2) (k `rem` 2)))
  where
    end s k = case forms V.! p of
      Ring -> if start + k == cornerFirsts U.! (p + 1) then first else start + k
      -- The second face goes back.
      Polyline
        | start + 1 < cornerFirsts U.! (p + 1) -> start + k
        | otherwise -> 2 * cornerFirsts U.! (p + 1) - 2 - start - k
      where
        p = fromIntegral (owners U.! s)
        first = cornerFirsts U.! p
        start = first + s - firsts U.! p

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

-- | The material of a side, by number.
materialOf :: Stated -> Int -> Material
materialOf stated i = IntMap.findWithDefault whole i (statedOverrides stated)
  where
    whole = statedMaterials stated V.! fromIntegral (statedSideOwners stated U.! i)

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
