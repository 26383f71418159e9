-- | The straight sweep: every vertex of the visibility complex in order of direction, from a priority queue over the
-- open faces.
--
-- An open face lies between two curves at the current direction, and ends where these two meet. The queue holds the
-- faces whose curves are still to meet in this half turn, by the direction in which they do. Every elementary pair of
-- a vertex closes a face that lies between the two corners, so the faces that end in one direction give all vertices
-- of that direction. What a vertex does to the faces is "Visibility.Sweep.Cut", for this sweep as for the tables of
-- the complex.
--
-- /Source/ Orti, Rivière, Durand, Puech, Using the visibility complex for radiosity computation, section 3.3.
module Visibility.Sweep.Straight
  ( straightVertices
  ) where

import Control.Monad (forM_, when)
import Control.Monad.ST (ST)
import qualified Control.Monad.ST.Lazy as Lazy
import Data.Bits (shiftR)
import Data.Int (Int32)
import Data.Graph (flattenSCC, stronglyConnComp)
import qualified Data.IntMap.Strict as IntMap
import Data.List (sort, sortBy)
import Data.Maybe (mapMaybe)
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.Predicate
import Visibility.Law (broken)
import Visibility.Scene
import Visibility.Sweep.Cut
import Visibility.Sweep.Vertex

-- | All vertices in canonical order, lazily: by direction, then by offset (from right to left of the direction), then
-- along the line.
--
-- /Degenerate cases/ all vertices of one direction are found together, each with all its corners; no tie is broken.
--
-- /Cost/ O(n log n + m log n) time, O(n) live memory while the list is consumed.
--
-- /Laws/ @straightVertices s == sortBy (compareVertices s) (vertices s)@.
straightVertices :: Scene -> [Vertex]
straightVertices scene = concat $ Lazy.runST $ do
  faces <- Lazy.strictToLazyST (noFaces scene)
  cut <- Lazy.strictToLazyST $ do
    cut <- openCut scene (keeping scene faces)
    forM_ [0 .. cornerCount scene - 1] $ bound scene faces cut
    pure cut
  let go = do
        found <- Lazy.strictToLazyST (some scene faces cut)
        if null found then pure [] else (found :) <$> go
  go

-- | The open faces, by numbers that are used again.
data Faces s = Faces
  { faceBounds :: !(M.MVector s Int32)
  -- ^ By face: the corners whose curves bound it from below and from above, at 2f and 2f + 1; −1 where there is none.
  , freeNumbers :: !(M.MVector s Int32)
  -- ^ Numbers that no open face has, a stack; its size is the last entry.
  , heap :: !(M.MVector s Int32)
  -- ^ Faces whose curves are still to meet; none comes before the one at half its place. Entry 0 is their number.
  , places :: !(M.MVector s Int32)
  -- ^ By face: its place in the heap, 0 if it is not there.
  }

-- | At most so many faces are open at once: each corner bounds at most two of them from above, and all but one are
-- bounded from above.
faceLimit :: Scene -> Int
faceLimit scene = 2 * cornerCount scene + 1

-- | Before any face is opened.
noFaces :: Scene -> ST s (Faces s)
noFaces scene =
  Faces
    <$> M.replicate (2 * limit) (-1)
    <*> U.thaw (U.generate (limit + 1) (\i -> fromIntegral (if i == limit then limit else limit - 1 - i)))
    <*> M.replicate (limit + 1) 0
    <*> M.replicate limit 0
  where
    limit = faceLimit scene

-- | Numbers for the faces that are opened, from those that are free.
keeping :: Scene -> Faces s -> FaceKeeper s
keeping scene faces =
  FaceKeeper
    { opened = \_ _ -> do
        size <- M.read free limit
        when (size <= 0) $ broken "a cut has at most 2n + 1 faces" (show limit)
        M.write free limit (size - 1)
        fromIntegral <$> M.read free (fromIntegral size - 1)
    , closed = \face -> do
        M.write (faceBounds faces) (2 * face) (-1)
        requeue scene faces face
        M.write (faceBounds faces) (2 * face + 1) (-1)
        size <- M.read free limit
        M.write free (fromIntegral size) (fromIntegral face)
        M.write free limit (size + 1)
    }
  where
    free = freeNumbers faces
    limit = faceLimit scene
{-# INLINE keeping #-}

-- | The vertices of so many directions that there are at least 64; none only at the end of the half turn.
some :: Scene -> Faces s -> Cut s -> ST s [Vertex]
some scene faces cut = collect (64 :: Int)
  where
    collect wanted
      | wanted <= 0 = pure []
      | otherwise = do
          found <- nextDirection scene faces
          forM_ found $ \vertex -> do
            line <- cross scene (keeping scene faces) cut vertex
            forM_ line $ \(c, _) -> bound scene faces cut c
          if null found then pure [] else (found <>) <$> collect (wanted - length found)

-- | All vertices of the least direction in the queue, in canonical order.
nextDirection :: Scene -> Faces s -> ST s [Vertex]
nextDirection scene faces = do
  size <- fromIntegral <$> M.read (heap faces) 0
  if size == 0
    then pure []
    else do
      least <- boundsAt faces 1
      pairs <- sameDirection least size [1]
      pure $! case pairs of
        [(a, b)] -> [Vertex (CornerId a) (CornerId b) []]
        _ -> sortBy (compareVertices scene) (joined pairs)
  where
    -- The faces that end in one direction are a tree at the top of the heap.
    sameDirection _ _ [] = pure []
    sameDirection least@(a, b) size (i : rest)
      | i > size = sameDirection least size rest
      | otherwise = do
          (c, d) <- boundsAt faces i
          if headingTurn (scenePoints scene) a b c d == Collinear
            then ((c, d) :) <$> sameDirection least size (2 * i : 2 * i + 1 : rest)
            else sameDirection least size rest

-- | The vertices of one direction from their elementary pairs, which may be repeated: pairs with a corner in common are
-- on one vertex.
joined :: [(Int, Int)] -> [Vertex]
joined pairs = mapMaybe (fromCorners . map CornerId . sort . flattenSCC) (stronglyConnComp besides)
  where
    besides = [(c, c, own) | (c, own) <- IntMap.toList (IntMap.fromListWith (<>) (concatMap bothWays pairs))]
    bothWays (a, b) = [(a, [b]), (b, [a])]

-- | Notes that a corner bounds the faces around it, and moves these faces in the queue. One bound is changed at a
-- time, so that all others in the queue are in order.
bound :: Scene -> Faces s -> Cut s -> Int -> ST s ()
bound scene faces cut c = do
  (q0, q1, q2, q3) <- quartersNow cut c
  set 0 q0
  when (q1 /= q0) $ set 0 q1
  set 1 q2
  when (q3 /= q2) $ set 1 q3
  where
    set k face = when (face >= bounded) $ do
      M.write (faceBounds faces) (2 * face + k) (fromIntegral c)
      requeue scene faces face
    -- The lines that miss everything have number 0 under the sky, and never end.
    bounded = case surroundings scene of OpenSky -> 1; Room -> 0

-- | The corners that bound the face at a place of the heap from below and from above.
boundsAt :: Faces s -> Int -> ST s (Int, Int)
boundsAt faces i = do
  face <- fromIntegral <$> M.read (heap faces) i
  below <- M.read (faceBounds faces) (2 * face)
  above <- M.read (faceBounds faces) (2 * face + 1)
  pure (fromIntegral below, fromIntegral above)
{-# INLINE boundsAt #-}

-- | Puts a face where it belongs in the queue after one of its bounds has changed. Its curves are still to meet if the
-- upper one is that of the corner further to the right.
requeue :: Scene -> Faces s -> Int -> ST s ()
requeue scene faces face = do
  below <- M.read (faceBounds faces) (2 * face)
  above <- M.read (faceBounds faces) (2 * face + 1)
  place <- fromIntegral <$> M.read (places faces) face
  size <- fromIntegral <$> M.read (heap faces) 0
  if below >= 0 && below < above
    then
      if place == 0
        then do
          M.write (heap faces) 0 (fromIntegral (size + 1))
          putAt faces (size + 1) face
          rise scene faces (size + 1)
        else rise scene faces place >> sink scene faces size place
    else when (place /= 0) $ do
      M.write (heap faces) 0 (fromIntegral (size - 1))
      M.write (places faces) face 0
      when (place /= size) $ do
        other <- fromIntegral <$> M.read (heap faces) size
        putAt faces place other
        rise scene faces place
        sink scene faces (size - 1) place

putAt :: Faces s -> Int -> Int -> ST s ()
putAt faces place face = do
  M.write (heap faces) place (fromIntegral face)
  M.write (places faces) face (fromIntegral place)

-- | Does the face at the first place end before that at the second one?
endsBefore :: Scene -> Faces s -> Int -> Int -> ST s Bool
endsBefore scene faces i j = do
  (a, b) <- boundsAt faces i
  (c, d) <- boundsAt faces j
  pure $! headingTurn (scenePoints scene) a b c d == LeftTurn

rise :: Scene -> Faces s -> Int -> ST s ()
rise scene faces place = when (place > 1) $ do
  let parent = place `shiftR` 1
  earlier <- endsBefore scene faces place parent
  when earlier $ exchange faces place parent >> rise scene faces parent

sink :: Scene -> Faces s -> Int -> Int -> ST s ()
sink scene faces size place = when (left <= size) $ do
  rightIsFirst <- if left < size then endsBefore scene faces (left + 1) left else pure False
  let child = if rightIsFirst then left + 1 else left
  earlier <- endsBefore scene faces child place
  when earlier $ exchange faces place child >> sink scene faces size child
  where
    left = 2 * place

exchange :: Faces s -> Int -> Int -> ST s ()
exchange faces i j = do
  a <- fromIntegral <$> M.read (heap faces) i
  b <- fromIntegral <$> M.read (heap faces) j
  putAt faces i b
  putAt faces j a
