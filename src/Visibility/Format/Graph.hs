{-# LANGUAGE BangPatterns #-}

-- | The visibility graph as lines of text.
module Visibility.Format.Graph
  ( -- * Which pairs
    PairSelection (..)
  , selectedPairs
    -- * As text
  , graphLines
  , sortedGraphLines
  ) where

import Control.Monad (foldM_)
import Data.ByteString.Builder (Builder, byteString)
import Data.ByteString.Internal (ByteString, unsafeCreate)
import Data.Char (ord)
import qualified Data.Vector.Algorithms.Intro as Intro
import qualified Data.Vector.Unboxed as U
import Data.Word (Word8)
import Foreign.Ptr (plusPtr)
import Foreign.Storable (poke)
import Visibility.Scene
import Visibility.Sweep
import Visibility.View

-- | Which elementary visible pairs are asked for.
data PairSelection
  = AllPairs
  | -- | Only those whose line is tangent at both corners, sides of polygons left out.
    FreeBitangents
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | The selected pairs of a stream of vertices, in its order, as the file calls them: smaller name first.
--
-- /Degenerate cases/ where corners of the file are in one place, each of them is seen; they do not see each other.
selectedPairs :: Scene -> PairSelection -> [Vertex] -> [(CornerName, CornerName)]
selectedPairs scene selection = concatMap (concatMap (statedPairs scene) . chosen)
  where
    chosen = case selection of
      AllPairs -> vertexPairs scene
      FreeBitangents -> freeBitangents scene

-- | A line per selected pair, in the order of the stream.
--
-- /Cost/ O(1) per pair, in constant memory besides a table of names.
graphLines :: Scene -> PairSelection -> [Vertex] -> Builder
graphLines scene selection = go
  where
    names = namesOf scene
    keys = pairKeys scene names selection
    go found = case splitAt chunkSize found of
      ([], _) -> mempty
      (now, later) -> byteString (linesOf names (concatMap keys now)) <> go later

-- | The same lines, sorted by the names of both corners: polygon number, then corner number, the enclosure last.
--
-- /Cost/ O(m log m) time, O(m) memory.
sortedGraphLines :: Scene -> PairSelection -> [Vertex] -> Builder
sortedGraphLines scene selection found = go (U.toList sorted)
  where
    names = namesOf scene
    sorted = U.modify Intro.sort (U.fromList (concatMap (pairKeys scene names selection) found))
    go ks = case splitAt chunkSize ks of
      ([], _) -> mempty
      (now, later) -> byteString (linesOf names now) <> go later

-- | So many vertices or pairs are written at a time.
chunkSize :: Int
chunkSize = 4096

-- | A number for each selected pair of a vertex that sorts as its line does: (rank of the first name) · n + rank of the
-- second.
pairKeys :: Scene -> Names -> PairSelection -> Vertex -> [Int]
pairKeys scene names selection = case selection of
  AllPairs | not (hasSharedPlaces scene) -> map direct . vertexPairs scene
  _ -> map (\(a, b) -> rankOf names a * n + rankOf names b) . selectedPairs scene selection . pure
  where
    n = nameTotal names
    -- Where no places are shared, each corner has one name.
    direct (CornerId p, CornerId q) = let a = ranks U.! p; b = ranks U.! q in min a b * n + max a b
    ranks = U.fromList [rankOf names (cornerName scene c) | c <- corners scene]

-- | The texts of all corners of the file, in order, one after the other, and where each begins and the last ends; and
-- by polygon, the enclosure last, the rank of its corner 0.
data Names = Names
  { nameBytes :: !(U.Vector Word8)
  , nameStarts :: !(U.Vector Int)
  , firstRanks :: !(U.Vector Int)
  }

nameTotal :: Names -> Int
nameTotal names = U.length (nameStarts names) - 1

namesOf :: Scene -> Names
namesOf scene =
  Names
    { nameBytes = U.fromList (map (fromIntegral . ord) (concat texts))
    , nameStarts = U.fromList (scanl (+) 0 (map length texts))
    , firstRanks = U.fromList (scanl (+) 0 (map (length . polygonPoints) (scenePolygons scene)))
    }
  where
    texts = map (cornerText . fst) (statedCorners scene)

-- | The rank of a corner among all. /Requires/ a corner of the scene. /Cost/ O(1).
rankOf :: Names -> CornerName -> Int
rankOf names (CornerName polygon k) = k + firstRanks names U.! place
  where
    place = case polygon of
      Obstacle p -> p
      Enclosure -> U.length (firstRanks names) - 2

-- | A line for each key: the two names, a space between them.
linesOf :: Names -> [Int] -> ByteString
linesOf names ks = unsafeCreate (sum (map size ks)) (\begin -> foldM_ line begin ks)
  where
    n = nameTotal names
    from k = nameStarts names U.! k
    long k = from (k + 1) - from k
    size k = let (a, b) = k `quotRem` n in long a + long b + 2
    line !place k = do
      let (a, b) = k `quotRem` n
      place' <- name place a
      poke place' 32
      place'' <- name (place' `plusPtr` 1) b
      poke place'' 10
      pure (place'' `plusPtr` 1)
    name place k = copied place (from k) (from (k + 1))
    copied !place !i !end
      | i >= end = pure place
      | otherwise = poke place (nameBytes names U.! i) >> copied (place `plusPtr` 1) (i + 1) end
