{-# LANGUAGE BangPatterns #-}

-- | The tables of the complex, made along a sweep.
module Visibility.Complex.Build
  ( build
  ) where

import Control.Monad (forM_, when)
import Control.Monad.ST (ST, runST)
import Data.Bits (shiftR, (.&.))
import Data.Int (Int32)
import Data.STRef (STRef, newSTRef, readSTRef, writeSTRef)
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Complex.Table
import Visibility.Complex.Type
import Visibility.Incidence (Outlook (..))
import Visibility.Law (broken)
import Visibility.Scene
import Visibility.Sorting
import Visibility.Sweep.Cut
import Visibility.Sweep.Vertex

-- | The complex of a scene from all its vertices, numbered in their order.
--
-- /Degenerate cases/ a vertex with many corners is one vertex with all its incidences; faces without interior do not
-- arise (see Note [Faces at a vertex] in "Visibility.Sweep.Cut").
--
-- /Requires/ the vertices of the scene, all of them, in an order in which each corner's vertices come by increasing
-- direction. /Cost/ O(n log n + m); O(1) per incidence.
--
-- /Laws/ those of "Visibility.Complex.Law"; the order of the stream changes numbers only.
build :: Scene -> [Vertex] -> Complex
build scene vertices = runST $ do
  records <- growing
  faces <- growing
  let keeper =
        FaceKeeper
          { opened = \b f -> (`quot` faceWidth) <$> push faces [b, f]
          , closed = const (pure ())
          }
      sweep _ _ [] = pure ()
      sweep cut !v (vertex : rest) = do
        line <- cross scene keeper cut vertex
        forM_ line $ \(c, Outlook b f up) -> do
          (q0, q1, q2, q3) <- quartersNow cut c
          push records [c, b, f, up, q0, q1, q2, q3, v]
        sweep cut (v + 1) rest
  cut <- openCut scene keeper
  quarters <- quarterTable cut
  atStart <- (`quot` faceWidth) <$> filled faces
  sweep cut 0 vertices
  assembled scene quarters atStart <$> frozen records <*> frozen faces

-- | A stretch while it is collected: corner, back, front, flank, four faces, and the vertex where it begins.
recordWidth :: Int
recordWidth = 9

-- | A face while it is collected: back and front.
faceWidth :: Int
faceWidth = 2

-- | Puts together what has been collected along the sweep: the faces around all corners at the start, and their number,
-- since they are the first ones; then the stretches, vertex by vertex, and the faces. Links the stretches of each
-- corner, glues the end of the half turn to its start, and collects the chains; a face begins and ends where its upper
-- chain does.
--
-- A stretch cut by the start of the half turn has been collected once, as the last one of its corner. A face cut by
-- it has two numbers: one from the start on, one up to the end. At the end every line is the one at the start read
-- backwards, so quarter k of a corner then is its quarter 3 − k at the start. The lines under the sky that miss
-- everything have the number 0 in both.
assembled :: Scene -> U.Vector Int32 -> Int -> U.Vector Int32 -> U.Vector Int32 -> Complex
assembled scene startQuarters fromStart records faces =
  Complex
    { sweptScene = scene
    , vertexStarts = Table (U.map fromIntegral (runs id vertexOf))
    , stretchCorners = Table stretchCorner
    , stretchVertices = Table vertexOf
    , stretchesBefore = Table before
    , stretchesAfter = Table after
    , stretchBacks = Table (column 1)
    , stretchFronts = Table (column 2)
    , stretchFlanks = Table (column 3)
    , stretchFaces = Table (U.map (\f -> if f < 0 then -1 else final f) quarters)
    , lastStretches = Table lasts
    , faceFirsts = Table (U.generate tabledFaces firstVertex)
    , faceLasts = Table (U.generate tabledFaces lastVertex)
    , faceBacks = Table (U.generate tabledFaces (faceColumn 0))
    , faceFronts = Table (U.generate tabledFaces (faceColumn 1))
    , chainStarts = Table starts
    , chains = Table chained
    }
  where
    total = U.length records `quot` recordWidth
    column k = U.generate total (\i -> records `U.unsafeIndex` (recordWidth * i + k))
    stretchCorner = column 0
    quarters = U.generate (4 * total) (\i -> records `U.unsafeIndex` (recordWidth * (i `shiftR` 2) + 4 + i .&. 3))
    vertexOf = column 8

    -- By corner: its stretches, in the order of direction. The next one of each, cyclically, and the one before it.
    rows =
      [ if U.null row then broken "every corner lies on a vertex" (show c) else row
      | c <- [0 .. cornerCount scene - 1]
      , let row = bucketSlice byCorner c
      ]
    byCorner = bucketsBy (cornerCount scene) stretchCorner
    after = instead (U.concat rows) (U.concat [U.drop 1 row <> U.take 1 row | row <- rows])
    before = instead after (U.enumFromN 0 total)
    instead places = U.update_ (U.replicate total 0) (U.map fromIntegral places)
    lasts = U.concat [U.drop (U.length row - 1) row | row <- rows]

    -- Faces under the sky that have no first vertex.
    outer = case surroundings scene of OpenSky -> 1; Room -> 0
    tabledFaces = U.length faces `quot` faceWidth - fromStart + outer
    -- From the number of a face in the tables to that while it was collected, and back: of faces that begin at a
    -- vertex, and of the outer one. (A face at the start is the rest of one of these.)
    faceColumn k f = faces U.! (faceWidth * (if f < outer then f else f - outer + fromStart) + k)
    tabled f = if f < fromStart then f else f - fromStart + outer
    final f
      | fromIntegral f >= fromStart = fromIntegral (tabled (fromIntegral f))
      | otherwise = continued U.! fromIntegral f
    -- By faces at the start: the face that they are the rest of.
    continued =
      U.replicate fromStart (-1)
        U.// [ (fromIntegral f, continuing (quarters U.! (4 * fromIntegral (lasts U.! c) + 3 - k)))
             | c <- [0 .. cornerCount scene - 1]
             , k <- [0 .. 3]
             , let f = startQuarters U.! (4 * c + k)
             , f >= 0
             ]
    continuing f
      | fromIntegral f >= max outer fromStart || fromIntegral f < outer = fromIntegral (tabled (fromIntegral f))
      | otherwise = broken "a face spans less than half a turn" (show f)

    -- Chains: per face, the upper one before and after the turn, then the lower one. The chain of the lines that miss
    -- everything is their lower one; read from the end on it is above them.
    part above f
      | fromIntegral f < outer = if above then 2 else 3 :: Int
      | fromIntegral f >= fromStart = if above then 2 else 0
      | otherwise = if above then 1 else 3
    chainOf i f
      | f < 0 || (odd i && quarters `U.unsafeIndex` (i - 1) == f) = -1
      | otherwise = 4 * final f + fromIntegral (part (i .&. 2 == 0) f)
    Buckets starts quartered = bucketsBy (4 * tabledFaces) (U.imap chainOf quarters)
    chained = U.map (`shiftR` 2) quartered
    firstVertex f = if f < outer then -1 else vertexOf U.! chainEntry (starts U.! (4 * f))
    lastVertex f
      | f < outer = -1
      | otherwise = vertexOf U.! fromIntegral (after U.! chainEntry (starts U.! (4 * f + 2) - 1))
    chainEntry i = fromIntegral (chained U.! fromIntegral i)

-- | A table that grows at its end, and how much of it is filled.
data Growing s = Growing !(STRef s (M.MVector s Int32)) !(M.MVector s Int)

growing :: ST s (Growing s)
growing = Growing <$> (M.new 1024 >>= newSTRef) <*> M.replicate 1 0

filled :: Growing s -> ST s Int
filled (Growing _ size) = M.unsafeRead size 0

-- | Adds some numbers at the end, and says where they begin. /Cost/ O(1) each, amortised.
push :: Growing s -> [Int] -> ST s Int
push (Growing ref size) items = do
  i <- M.unsafeRead size 0
  table <- readSTRef ref
  let end = i + length items
  when (end > M.length table) $ M.grow table (M.length table) >>= writeSTRef ref
  roomy <- readSTRef ref
  forM_ (zip [i ..] items) $ \(k, x) -> M.write roomy k (fromIntegral x)
  M.unsafeWrite size 0 end
  pure i
{-# INLINE push #-}

frozen :: Growing s -> ST s (U.Vector Int32)
frozen (Growing ref size) = U.unsafeFreeze =<< M.take <$> M.read size 0 <*> readSTRef ref
