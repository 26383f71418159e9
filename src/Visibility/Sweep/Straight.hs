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
import Control.Monad.ST (ST, runST)
import Data.Bits (shiftR)
import Data.Int (Int32)
import qualified Data.IntMap.Strict as IntMap
import qualified Data.IntSet as IntSet
import Data.List (sortBy)
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
straightVertices scene = go (opening scene)
  where
    go state = case piece scene state of
      ([], _) -> []
      (found, state') -> found <> go state'

-- | The state between two pieces of the list.
data State = State !Frozen !(Faces (U.Vector Int32))

-- | The open faces, by numbers that are used again.
data Faces v = Faces
  { faceBounds :: !v
  -- ^ By face: the corners whose curves bound it from below and from above, at 2f and 2f + 1; −1 where there is none.
  , freeNumbers :: !v
  -- ^ Numbers that no open face has, a stack; its size is the last entry.
  , heap :: !v
  -- ^ Faces whose curves are still to meet; none comes before the one at half its place. Entry 0 is their number.
  , places :: !v
  -- ^ By face: its place in the heap, 0 if it is not there.
  }

instance Functor Faces where
  fmap f (Faces a b c d) = Faces (f a) (f b) (f c) (f d)

instance Foldable Faces where
  foldMap f (Faces a b c d) = f a <> f b <> f c <> f d

instance Traversable Faces where
  traverse f (Faces a b c d) = Faces <$> f a <*> f b <*> f c <*> f d

type Changing s = Faces (M.MVector s Int32)

-- | At most so many faces are open at once: each corner bounds at most two of them from above, and all but one are
-- bounded from above.
faceLimit :: Scene -> Int
faceLimit scene = 2 * cornerCount scene + 1

-- | The state just above −90°.
opening :: Scene -> State
opening scene = runST $ do
  bounds <- M.replicate (2 * limit) (-1)
  free <- U.thaw (U.generate (limit + 1) (\i -> fromIntegral (if i == limit then limit else limit - 1 - i)))
  queue <- M.replicate (limit + 1) 0
  at <- M.replicate limit 0
  let faces = Faces bounds free queue at
  cut <- openCut scene (keeping scene faces)
  forM_ [0 .. cornerCount scene - 1] $ bound scene faces cut
  State <$> freeze cut <*> traverse U.unsafeFreeze faces
  where
    limit = faceLimit scene

-- | Numbers for the faces that are opened, from those that are free.
keeping :: Scene -> Changing s -> FaceKeeper s
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

-- | The vertices of so many directions that there are at least 4n vertices, and the state after them; none only at the
-- end of the half turn.
piece :: Scene -> State -> ([Vertex], State)
piece scene (State frozenCut frozenFaces) = runST $ do
  cut <- thaw frozenCut
  faces <- traverse U.thaw frozenFaces
  let turnPast vertex = do
        line <- cross scene (keeping scene faces) cut vertex
        forM_ line $ \(c, _) -> bound scene faces cut c
      collect wanted
        | wanted <= (0 :: Int) = pure []
        | otherwise = do
            found <- nextDirection scene faces
            mapM_ turnPast found
            if null found then pure [] else (found :) <$> collect (wanted - length found)
  found <- collect (max 64 (4 * cornerCount scene))
  state' <- State <$> freeze cut <*> traverse U.unsafeFreeze faces
  pure (concat found, state')

-- | All vertices of the least direction in the queue, in canonical order.
nextDirection :: Scene -> Changing s -> ST s [Vertex]
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
joined pairs = mapMaybe (fromCorners . map CornerId . IntSet.toAscList) (components (IntMap.keysSet besides))
  where
    besides = IntMap.fromListWith (<>) (concat [[(a, [b]), (b, [a])] | (a, b) <- pairs])
    components left = case IntSet.minView left of
      Nothing -> []
      Just (a, others) -> let line = reached [a] (IntSet.singleton a) in line : components (others IntSet.\\ line)
    reached [] line = line
    reached (a : rest) line =
      let more = filter (`IntSet.notMember` line) (IntMap.findWithDefault [] a besides)
       in reached (more <> rest) (foldr IntSet.insert line more)

-- | Notes that a corner bounds the faces around it, and moves these faces in the queue. One bound is changed at a
-- time, so that all others in the queue are in order.
bound :: Scene -> Changing s -> Cut (M.MVector s Int32) -> Int -> ST s ()
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
boundsAt :: Changing s -> Int -> ST s (Int, Int)
boundsAt faces i = do
  face <- fromIntegral <$> M.read (heap faces) i
  below <- M.read (faceBounds faces) (2 * face)
  above <- M.read (faceBounds faces) (2 * face + 1)
  pure (fromIntegral below, fromIntegral above)
{-# INLINE boundsAt #-}

-- | Puts a face where it belongs in the queue after one of its bounds has changed. Its curves are still to meet if the
-- upper one is that of the corner further to the right.
requeue :: Scene -> Changing s -> Int -> ST s ()
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

putAt :: Changing s -> Int -> Int -> ST s ()
putAt faces place face = do
  M.write (heap faces) place (fromIntegral face)
  M.write (places faces) face (fromIntegral place)

-- | Does the face at the first place end before that at the second one?
endsBefore :: Scene -> Changing s -> Int -> Int -> ST s Bool
endsBefore scene faces i j = do
  (a, b) <- boundsAt faces i
  (c, d) <- boundsAt faces j
  pure $! headingTurn (scenePoints scene) a b c d == LeftTurn

rise :: Scene -> Changing s -> Int -> ST s ()
rise scene faces place = when (place > 1) $ do
  let parent = place `shiftR` 1
  earlier <- endsBefore scene faces place parent
  when earlier $ exchange faces place parent >> rise scene faces parent

sink :: Scene -> Changing s -> Int -> Int -> ST s ()
sink scene faces size place = when (left <= size) $ do
  rightIsFirst <- if left < size then endsBefore scene faces (left + 1) left else pure False
  let child = if rightIsFirst then left + 1 else left
  earlier <- endsBefore scene faces child place
  when earlier $ exchange faces place child >> sink scene faces size child
  where
    left = 2 * place

exchange :: Changing s -> Int -> Int -> ST s ()
exchange faces i j = do
  a <- fromIntegral <$> M.read (heap faces) i
  b <- fromIntegral <$> M.read (heap faces) j
  putAt faces i b
  putAt faces j a
