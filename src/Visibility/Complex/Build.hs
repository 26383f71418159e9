{-# LANGUAGE BangPatterns #-}

-- | The tables of the complex, made along a sweep.
--
-- /Source/ incidences: Orti, Rivière, Durand, Puech, Using the visibility complex for radiosity computation, section 3;
-- the handling of degenerate vertices is this project's.
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
  starts <- growing
  faces <- growing
  let keeper =
        FaceKeeper
          { opened = \b f -> do
              i <- reserve faces faceWidth
              v <- filled starts
              table <- content faces
              let put k x = M.write table (i + k) (fromIntegral (x :: Int))
              put 0 b >> put 1 f >> put 2 (v - 1) >> put 3 (-1)
              pure (i `quot` faceWidth)
          , closed = \face -> do
              v <- filled starts
              table <- content faces
              M.write table (faceWidth * face + 3) (fromIntegral (v - 1))
          }
      sweep _ _ [] = pure ()
      sweep cut !size (vertex : rest) = do
        i <- reserve starts 1
        table <- content starts
        M.write table i (fromIntegral size)
        line <- cross scene keeper cut vertex
        mapM_ (record records cut) line
        sweep cut (size + length line) rest
  cut <- openCut scene keeper
  quarters <- quarterTable cut
  atStart <- (`quot` faceWidth) <$> filled faces
  sweep cut 0 vertices
  size <- (`quot` recordWidth) <$> filled records
  end <- reserve starts 1
  startTable <- content starts
  M.write startTable end (fromIntegral size)
  assembled scene quarters atStart <$> frozen starts <*> frozen records <*> frozen faces

-- | A stretch while it is collected: corner, back, front, flank, and four faces.
recordWidth :: Int
recordWidth = 8

-- | A face while it is collected: back, front, first and last vertex.
faceWidth :: Int
faceWidth = 4

-- | Collects the stretch of a corner that begins with an outlook.
record :: Growing s -> Cut s -> (Int, Outlook) -> ST s ()
record records cut (c, Outlook b f up) = do
  (q0, q1, q2, q3) <- quartersNow cut c
  i <- reserve records recordWidth
  table <- content records
  let put k x = M.unsafeWrite table (i + k) (fromIntegral (x :: Int))
  put 0 c >> put 1 b >> put 2 f >> put 3 up >> put 4 q0 >> put 5 q1 >> put 6 q2 >> put 7 q3

-- | Puts together what has been collected along the sweep: the faces around all corners at the start, and their number,
-- since they are the first ones; then where the stretches of each vertex begin, the stretches, and the faces. Links the
-- stretches of each corner, glues the end of the half turn to its start, and collects the chains.
--
-- A stretch cut by the start of the half turn has been collected once, as the last one of its corner. A face cut by
-- it has two numbers: one from the start on, one up to the end. At the end every line is the one at the start read
-- backwards, so quarter k of a corner then is its quarter 3 − k at the start. The lines under the sky that miss
-- everything have the number 0 in both.
assembled :: Scene -> U.Vector Int32 -> Int -> U.Vector Int32 -> U.Vector Int32 -> U.Vector Int32 -> Complex
assembled scene startQuarters fromStart starts records faces =
  Complex
    { sweptScene = scene
    , vertexStarts = Table starts
    , stretchCorners = Table stretchCorner
    , stretchVertices = Table vertexOf
    , stretchesBefore = Table before
    , stretchesAfter = Table after
    , stretchBacks = Table (column 1)
    , stretchFronts = Table (column 2)
    , stretchFlanks = Table (column 3)
    , stretchFaces = Table (U.map (\f -> if f < 0 then -1 else final f) quarters)
    , lastStretches = Table lasts
    , faceFirsts = Table (U.generate tabledFaces (faceColumn 2 . collectedAs))
    , faceLasts = Table (U.generate tabledFaces lastVertex)
    , faceBacks = Table (U.generate tabledFaces (faceColumn 0 . collectedAs))
    , faceFronts = Table (U.generate tabledFaces (faceColumn 1 . collectedAs))
    , upperStarts = Table (U.generate (tabledFaces + 1) (\f -> chainStarts U.! (4 * f)))
    , upperTurns = Table (U.generate tabledFaces (\f -> chainStarts U.! (4 * f + 1)))
    , lowerStarts = Table (U.generate tabledFaces (\f -> chainStarts U.! (4 * f + 2)))
    , lowerTurns = Table (U.generate tabledFaces (\f -> chainStarts U.! (4 * f + 3)))
    , chains = Table chained
    }
  where
    total = U.length records `quot` recordWidth
    column k = U.generate total (\i -> records `U.unsafeIndex` (recordWidth * i + k))
    stretchCorner = column 0
    quarters = U.generate (4 * total) (\i -> records `U.unsafeIndex` (2 * i + 4 - i .&. 3))
    vertexOf = spread starts
    (before, after, lasts) = linked (cornerCount scene) stretchCorner

    -- Faces under the sky that have no first vertex.
    outer = case surroundings scene of OpenSky -> 1; Room -> 0
    tabledFaces = U.length faces `quot` faceWidth - fromStart + outer
    faceColumn k f = faces U.! (faceWidth * f + k)
    -- From the number of a face in the tables to that while it was collected, and back: of faces that begin at a
    -- vertex, and of the outer one. (A face at the start is the rest of one of these.)
    collectedAs f = if f < outer then f else f - outer + fromStart
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
    -- By faces in the tables: the face at the start that is the rest of it, or −1.
    rests =
      U.replicate tabledFaces (-1)
        U.// [(fromIntegral f, s) | (s, f) <- zip [0 ..] (U.toList continued), fromIntegral f >= outer]
    lastVertex f
      | f < outer = -1
      | rest >= 0 = faceColumn 3 rest
      | otherwise = faceColumn 3 (collectedAs f)
      where
        rest = rests U.! f

    -- Chains: per face, the upper one before and after the turn, then the lower one. The chain of the lines that miss
    -- everything is their lower one; read from the end on it is above them.
    part above f
      | fromIntegral f < outer = if above then 2 else 3 :: Int
      | fromIntegral f >= fromStart = if above then 2 else 0
      | otherwise = if above then 1 else 3
    chainOf i f
      | f < 0 || (odd i && quarters `U.unsafeIndex` (i - 1) == f) = -1
      | otherwise = 4 * final f + fromIntegral (part (i .&. 2 == 0) f)
    (chainStarts, chained) = grouped (4 * tabledFaces) (U.imap chainOf quarters) (`shiftR` 2)

-- | For entries that say where the items of each group start: the group of each item.
spread :: U.Vector Int32 -> U.Vector Int32
spread starts = U.create $ do
  table <- M.new (fromIntegral (U.last starts))
  forM_ [0 .. U.length starts - 2] $ \g ->
    forM_ [starts U.! g .. starts U.! (g + 1) - 1] $ \i -> M.write table (fromIntegral i) (fromIntegral g)
  pure table

-- | For items with a corner each, in the order of direction at each corner: the item before it and after it at the same
-- corner, cyclically, and by corner the last one.
linked :: Int -> U.Vector Int32 -> (U.Vector Int32, U.Vector Int32, U.Vector Int32)
linked n owners = runST $ do
  before <- M.replicate total (-1)
  after <- M.replicate total (-1)
  firsts <- M.replicate n (-1)
  lasts <- M.replicate n (-1)
  forM_ [0 .. total - 1] $ \i -> do
    let c = fromIntegral (owners U.! i)
    previous <- M.read lasts c
    if previous < 0
      then M.write firsts c (fromIntegral i)
      else M.write before i previous >> M.write after (fromIntegral previous) (fromIntegral i)
    M.write lasts c (fromIntegral i)
  forM_ [0 .. n - 1] $ \c -> do
    first <- M.read firsts c
    end <- M.read lasts c
    when (first < 0) $ broken "every corner lies on a vertex" (show c)
    M.write before (fromIntegral first) end
    M.write after (fromIntegral end) first
  (,,) <$> U.unsafeFreeze before <*> U.unsafeFreeze after <*> U.unsafeFreeze lasts
  where
    total = U.length owners

-- | Sorts items into so many groups, keeping their order: where each group starts, and what is to be shown of the
-- items, by their groups. Items of a negative group are left out.
grouped :: Int -> U.Vector Int32 -> (Int -> Int) -> (U.Vector Int32, U.Vector Int32)
grouped groups groupOf shown = runST $ do
  sizes <- M.replicate (groups + 1) (0 :: Int32)
  each (\_ g -> M.modify sizes (+ 1) (g + 1))
  forM_ [1 .. groups] $ \g -> do
    size <- M.unsafeRead sizes (g - 1)
    M.unsafeModify sizes (+ size) g
  starts <- U.freeze sizes
  table <- M.new (fromIntegral (U.last starts))
  each $ \i g -> do
    place <- M.unsafeRead sizes g
    M.unsafeWrite table (fromIntegral place) (fromIntegral (shown i))
    M.unsafeWrite sizes g (place + 1)
  (,) starts <$> U.unsafeFreeze table
  where
    each act = U.imapM_ (\i g -> when (g >= 0) (act i (fromIntegral g))) groupOf
{-# INLINE grouped #-}

-- | A table that grows at its end, and how much of it is filled.
data Growing s = Growing !(STRef s (M.MVector s Int32)) !(M.MVector s Int)

growing :: ST s (Growing s)
growing = Growing <$> (M.new 1024 >>= newSTRef) <*> M.replicate 1 0

filled :: Growing s -> ST s Int
filled (Growing _ size) = M.unsafeRead size 0
{-# INLINE filled #-}

content :: Growing s -> ST s (M.MVector s Int32)
content (Growing ref _) = readSTRef ref
{-# INLINE content #-}

-- | Makes room for so many entries at the end and says where they begin. /Cost/ O(1) each, amortised.
reserve :: Growing s -> Int -> ST s Int
reserve (Growing ref size) more = do
  i <- M.unsafeRead size 0
  table <- readSTRef ref
  when (i + more > M.length table) $ M.grow table (M.length table + more) >>= writeSTRef ref
  M.unsafeWrite size 0 (i + more)
  pure i
{-# INLINE reserve #-}

frozen :: Growing s -> ST s (U.Vector Int32)
frozen (Growing ref size) = do
  i <- M.read size 0
  table <- readSTRef ref
  U.unsafeFreeze (M.take i table)
