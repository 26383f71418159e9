{-# LANGUAGE BangPatterns #-}

-- | Vertices written as numbers, many in one array, so that the garbage collector has nothing to trace in them.
module Visibility.Sweep.Piece
  ( Piece (..)
  , closing
  , pieceOf
  , inPieces
  , pieceLength
  , pieceCorners
  , pieceVertices
  , pieceNeighbours
  ) where

import Data.Bits (complement)
import Data.Int (Int32)
import Data.Primitive.PrimArray
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Scene
import Visibility.Sweep.Vertex

-- | Vertices that follow each other in a sweep: their corners one after the other, the last of each vertex as its
-- 'closing'.
newtype Piece = Piece (PrimArray Int32)
  deriving (Eq, Show)

-- | How the last corner of a vertex is written.
closing :: Int -> Int32
closing = complement . fromIntegral
{-# INLINE closing #-}

-- | Some vertices as a piece.
--
-- /Laws/ @pieceVertices (pieceOf found) == found@.
pieceOf :: [Vertex] -> Piece
pieceOf found = Piece (primArrayFromList (concatMap written found))
  where
    written vertex = [fromIntegral c | CornerId c <- init' (vertexCorners vertex)] <> [closing (lastOf vertex)]
    lastOf vertex = let CornerId c = vertexLast vertex in c
    init' line = zipWith const line (drop 1 line)

-- | A stream of vertices in pieces of many vertices each, none of them empty, lazily.
inPieces :: [Vertex] -> [Piece]
inPieces found = case splitAt 4096 found of
  ([], _) -> []
  (now, later) -> pieceOf now : inPieces later

-- | The number of vertices. /Cost/ linear.
pieceLength :: Piece -> Int
pieceLength (Piece written) = foldlPrimArray' (\count c -> if c < 0 then count + 1 else count) 0 written

-- | The number of corners on all its vertices.
pieceCorners :: Piece -> Int
pieceCorners (Piece written) = sizeofPrimArray written

-- | The vertices of a piece, lazily, in their order.
pieceVertices :: Piece -> [Vertex]
pieceVertices (Piece written) = from 0
  where
    from i
      | i >= sizeofPrimArray written = []
      | next < 0 = Vertex a (CornerId (complement next)) [] : from (i + 2)
      | otherwise = let rest = others (i + 2) in Vertex a (CornerId next) rest : from (i + 2 + length rest)
      where
        a = CornerId (at' i)
        next = at' (i + 1)
    others i
      | c < 0 = [CornerId (complement c)]
      | otherwise = CornerId c : others (i + 1)
      where
        c = at' i
    at' i = fromIntegral (indexPrimArray written i) :: Int

-- | Something for every two corners that follow each other in a vertex, vertex by vertex, from left to right.
--
-- /Degenerate cases/ where no wall has split ends, these are the elementary pairs; see 'vertexPairs'.
pieceNeighbours :: U.Unbox a => (Int -> Int -> a) -> Piece -> U.Vector a
pieceNeighbours make piece@(Piece written) = U.create $ do
  found <- M.unsafeNew (sizeofPrimArray written - pieceLength piece)
  let go !i !k
        | k >= M.length found = pure ()
        | a < 0 = go (i + 1) k
        | otherwise = M.unsafeWrite found k (make a (max b (complement b))) >> go (i + 1) (k + 1)
        where
          a = fromIntegral (indexPrimArray written i)
          b = fromIntegral (indexPrimArray written (i + 1))
  go 0 0
  pure found
{-# INLINE pieceNeighbours #-}
