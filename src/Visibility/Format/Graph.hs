{-# LANGUAGE BangPatterns #-}

-- | The visibility graph as lines of text.
--
-- Names are copied into the lines in words of eight bytes: put together by bytestring's builder, @graph --unsorted@
-- takes 1.5 times as long, on 1 000 quadrilaterals as on 400 squares.
module Visibility.Format.Graph
  ( -- * Which pairs
    PairSelection (..)
  , selectedPairs
    -- * As text
  , Names
  , namesOf
  , Key
  , pairKeys
  , linesOf
  , sortedLines
  ) where

import Control.Monad (when)
import qualified Data.ByteString as ByteString
import Data.ByteString.Builder (Builder, byteString, char7, string7, toLazyByteString)
import Data.ByteString.Internal (ByteString, unsafeCreateUptoN)
import qualified Data.ByteString.Lazy as Lazy
import Data.Int (Int32)
import Data.Primitive.PrimArray
import qualified Data.Vector.Unboxed as U
import Data.Word (Word8)
import Foreign.Ptr (Ptr, minusPtr, plusPtr)
import Foreign.Storable (poke)
import Visibility.Scene
import Visibility.Sorting
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

-- | The lines of many pairs, sorted by the names of both corners: polygon number, then corner number, the enclosure
-- last.
--
-- /Cost/ O(m + n) time and memory.
sortedLines :: Names -> [U.Vector Key] -> Builder
sortedLines names found = go (sortedPairs (nameTotal names) id (U.concat found))
  where
    go ks
      | U.null ks = mempty
      | otherwise = let (now, later) = U.splitAt 4096 ks in byteString (linesOf names now) <> go later

-- | A number for a pair that sorts as its line does: the rank of the first name, and that of the second in the lower
-- half.
type Key = Pair

-- | The selected pairs of a piece, in its order.
--
-- /Cost/ O(1) for each, besides a table for the scene.
pairKeys :: Scene -> Names -> PairSelection -> Piece -> U.Vector Key
pairKeys scene names selection = case selection of
  AllPairs | not (hasSharedPlaces scene) -> pieceNeighbours direct
  _ -> U.fromList . map named . selectedPairs scene selection . pieceVertices
  where
    named (a, b) = pairOf (rankOf names a) (rankOf names b)
    -- Where no places are shared, each corner has one name.
    direct p q = let a = ranks U.! p; b = ranks U.! q in pairOf (min a b) (max a b)
    ranks = U.map fromIntegral (namingCorners scene)

-- | The texts of all corners of the file, in order, each with a space after it, and 'slack' behind them; where each
-- begins and the last ends; and by polygon, the enclosure last, the rank of its corner 0.
data Names = Names
  { nameBytes :: !(PrimArray Word8)
  , nameStarts :: !(U.Vector Int32)
  , firstRanks :: !(U.Vector Int)
  }

-- | The names of a scene. /Cost/ O(n).
namesOf :: Scene -> Names
namesOf scene = Names {nameBytes = bytes, nameStarts = starts, firstRanks = firsts}
  where
    polygons = polygonSizes scene
    firsts = U.fromList (scanl (+) 0 (map snd polygons))
    texts =
      Lazy.toStrict . toLazyByteString . mconcat $
        [ string7 (cornerText (CornerName polygon k)) <> char7 ' '
        | (polygon, size) <- polygons
        , k <- [0 .. size - 1]
        ]
    size' = ByteString.length texts
    starts = U.cons 0 (U.map (+ 1) (U.filter endsName (U.enumFromN 0 size')))
    endsName i = ByteString.index texts (fromIntegral i) == space
    bytes = generatePrimArray (size' + slack) (\i -> if i < size' then ByteString.index texts i else 0)

space, newline :: Word8
space = 32
newline = 10

nameTotal :: Names -> Int
nameTotal names = U.length (nameStarts names) - 1

-- | The rank of a corner among all. /Requires/ a corner of the scene. /Cost/ O(1).
rankOf :: Names -> CornerName -> Int
rankOf names (CornerName polygon k) = k + firstRanks names U.! place
  where
    place = case polygon of
      Obstacle p -> p
      Enclosure -> U.length (firstRanks names) - 2

-- | Names are copied in words of so many bytes, so that up to one byte less is read and written behind them.
slack :: Int
slack = 8

-- | A line for each key: the two names, a space between them.
linesOf :: Names -> U.Vector Key -> ByteString
linesOf names ks = unsafeCreateUptoN (total + slack) (\begin -> (`minusPtr` begin) <$> go begin 0)
  where
    total = U.foldl' (\sum' k -> let (a, b) = parts k in sum' + long a + long b) 0 ks
    from k = fromIntegral (nameStarts names U.! k)
    -- With the space after it.
    long k = from (k + 1) - from k
    go !place !k
      | k >= U.length ks = pure place
      | otherwise = do
          let (a, b) = parts (ks U.! k)
              between = place `plusPtr` long a
              end = between `plusPtr` long b
          copied place (from a) (from (a + 1))
          copied between (from b) (from (b + 1))
          poke (end `plusPtr` (-1)) newline
          go end (k + 1)
    copied :: Ptr Word8 -> Int -> Int -> IO ()
    copied !place !i !end = do
      copyPrimArrayToPtr place (nameBytes names) i slack
      when (i + slack < end) $ copied (place `plusPtr` slack) (i + slack) end
