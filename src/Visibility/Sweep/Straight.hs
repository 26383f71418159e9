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
import Data.Graph (flattenSCC, stronglyConnComp)
import qualified Data.IntMap.Strict as IntMap
import qualified Data.IntSet as IntSet
import Data.List (sort, sortBy)
import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)
import Data.STRef (STRef, modifySTRef', newSTRef, readSTRef, writeSTRef)
import Visibility.Exact.Point (Points)
import Visibility.Exact.Predicate
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
  faces <- Lazy.strictToLazyST (newSTRef (Faces 0 IntMap.empty IntMap.empty Map.empty))
  cut <- Lazy.strictToLazyST $ do
    cut <- openCut scene (keeping scene faces)
    forM_ [0 .. cornerCount scene - 1] $ bound scene faces cut
    pure cut
  let go = do
        found <- Lazy.strictToLazyST (nextDirection scene faces cut)
        if null found then pure [] else (found :) <$> go
  go

-- | The open faces by number.
data Faces = Faces
  { nextNumber :: !Int
  -- ^ No face has had this number.
  , lowerBounds :: !(IntMap.IntMap Int)
  -- ^ The corner whose curve bounds a face from below, if there is one.
  , upperBounds :: !(IntMap.IntMap Int)
  , queue :: !(Map.Map Heading IntSet.IntSet)
  -- ^ The faces whose curves are still to meet, by the direction in which they do.
  }

-- | The direction from one corner to another, to the right.
data Heading = Heading !Points !Int !Int

instance Eq Heading where
  a == b = compare a b == EQ

instance Ord Heading where
  compare (Heading points a b) (Heading _ c d) = turnOrder (headingTurn points a b c d)

-- | The two corners whose curves end a face, if they are still to meet: then the upper one is that of the corner
-- further to the right.
ending :: Faces -> Int -> Maybe (Int, Int)
ending faces face = case (IntMap.lookup face (lowerBounds faces), IntMap.lookup face (upperBounds faces)) of
  (Just a, Just b) | a < b -> Just (a, b)
  _ -> Nothing

-- | Changes what bounds a face, and puts it where it then belongs in the queue.
rebounded :: Scene -> Int -> (Faces -> Faces) -> Faces -> Faces
rebounded scene face change = entered . change . left
  where
    left = queued (Map.update (others . IntSet.delete face))
    others found = if IntSet.null found then Nothing else Just found
    entered = queued (\heading -> Map.insertWith IntSet.union heading (IntSet.singleton face))
    queued at faces = case ending faces face of
      Just (a, b) -> faces {queue = at (Heading (scenePoints scene) a b) (queue faces)}
      Nothing -> faces

-- | Numbers faces as they are opened, and forgets those that are closed.
keeping :: Scene -> STRef s Faces -> FaceKeeper s
keeping scene faces =
  FaceKeeper
    { opened = \_ _ -> do
        now <- readSTRef faces
        nextNumber now <$ writeSTRef faces now {nextNumber = nextNumber now + 1}
    , closed = \face -> modifySTRef' faces $ rebounded scene face $ \now ->
        now {lowerBounds = IntMap.delete face (lowerBounds now), upperBounds = IntMap.delete face (upperBounds now)}
    }
{-# INLINE keeping #-}

-- | All vertices of the least direction in the queue, in canonical order; turns the cut past them.
nextDirection :: Scene -> STRef s Faces -> Cut s -> ST s [Vertex]
nextDirection scene faces cut = do
  now <- readSTRef faces
  case Map.minView (queue now) of
    Nothing -> pure []
    Just (least, others) -> case mapMaybe (ending now) (IntSet.toList least) of
      -- Unsafe arithmetic may leave faces in the queue that are closed.
      [] -> writeSTRef faces now {queue = others} >> nextDirection scene faces cut
      pairs -> do
        let found = sortBy (compareVertices scene) (joined pairs)
        forM_ found $ \vertex -> do
          line <- cross scene (keeping scene faces) cut vertex
          forM_ line $ \(c, _) -> bound scene faces cut c
        pure found

-- | The vertices of one direction from their elementary pairs, which may be repeated: pairs with a corner in common are
-- on one vertex.
joined :: [(Int, Int)] -> [Vertex]
joined [(a, b)] = [Vertex (CornerId a) (CornerId b) []]
joined pairs = mapMaybe (fromCorners . map CornerId . sort . flattenSCC) (stronglyConnComp besides)
  where
    besides = [(c, c, own) | (c, own) <- IntMap.toList (IntMap.fromListWith (<>) (concatMap bothWays pairs))]
    bothWays (a, b) = [(a, [b]), (b, [a])]

-- | Notes that a corner bounds the faces around it.
bound :: Scene -> STRef s Faces -> Cut s -> Int -> ST s ()
bound scene faces cut c = do
  (q0, q1, q2, q3) <- quartersNow cut c
  forM_ [q0, q1] $ set (\face now -> now {lowerBounds = IntMap.insert face c (lowerBounds now)})
  forM_ [q2, q3] $ set (\face now -> now {upperBounds = IntMap.insert face c (upperBounds now)})
  where
    set change face = when (face >= bounded) $ modifySTRef' faces (rebounded scene face (change face))
    -- The lines that miss everything have number 0 under the sky, and never end.
    bounded = case surroundings scene of OpenSky -> 1; Room -> 0
