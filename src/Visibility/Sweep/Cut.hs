-- | The faces around every corner while the direction turns: what a vertex does to them, in O(1) per incidence.
--
-- A cut is the state of the complex at one direction, or in one state of a topological sweep: for each corner its view
-- and the faces on the four quarters around its line. All sweeps that know faces share this one handling of vertices.
module Visibility.Sweep.Cut
  ( -- * Cuts
    Cut
  , FaceKeeper (..)
  , openCut
  , cross
    -- * What a cut says
  , quartersNow
  , quarterTable
  ) where

import Control.Monad (forM_, when)
import Control.Monad.ST (ST)
import Data.Bits (shiftR)
import Data.Int (Int32)
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Incidence
import Visibility.Law (broken)
import Visibility.Scene
import Visibility.Sweep.Sights
import Visibility.Sweep.Vertex
import Visibility.Sweep.Vertical (skyCode)

-- Note [Faces at a vertex]
-- ~~~~~~~~~~~~~~~~~~~~~~~~
-- Turn the line of a vertex a little. Between two of its corners' curves the line is cut
-- into free pieces, each with its label. One line meets a side at most once, and then sees it from its free flank; so
-- among the pieces of one line an object is at the back of at most one. Going down from above all curves to below
-- them, a face is therefore known by the object at its back, as long as it lasts: a curve that bounds it from below
-- ends it, one that bounds a piece from above begins another.
--
-- Just before the vertex the corners lie from top to bottom in the reverse of their order along the line. A face that
-- ends there without having begun lies above all curves: it goes on past the vertex. One that begins and does not end
-- lies below all: it goes on too. One that begins and ends is closed by the vertex. Just after the vertex the corners
-- lie from top to bottom in their order; what begins and ends now is opened by the vertex, and everything else is one
-- of the faces that go on, of the same label. No face is opened and closed by one vertex, so each has an interior.

-- | What is seen from the corners, the faces on the quarters around them, and three tables by object that are empty
-- between vertices: faces above the vertex at hand, faces below it, and quarters whose face is not known yet.
data Cut s = Cut
  { cutSights :: !(Changing s)
  , cutQuarters :: !(M.MVector s Int32)
  , facesAbove :: !(M.MVector s Int32)
  , facesBelow :: !(M.MVector s Int32)
  , unsettled :: !(M.MVector s Int32)
  }

-- | What is to be done when a face is opened, with the objects at its back and front, and when it is closed. An open
-- face has a number of the keeper's choice, at least 0.
data FaceKeeper s = FaceKeeper
  { opened :: Int -> Int -> ST s Int
  , closed :: Int -> ST s ()
  }

-- | The cut just above −90°. Under the sky the lines that miss everything are opened first.
--
-- /Cost/ O(n log n).
openCut :: Scene -> FaceKeeper s -> ST s (Cut s)
openCut scene keeper = do
  sights <- traverse U.thaw (startSights scene)
  let n = cornerCount scene
      table size = M.replicate size (-1)
  cut <- Cut sights <$> table (4 * n) <*> table (n + 1) <*> table (n + 1) <*> table (n + 1)
  when (surroundings scene == OpenSky) $ do
    outer <- opened keeper (skyCode scene) (skyCode scene)
    M.write (facesAbove cut) (skyCode scene) (fromIntegral outer)
    M.write (facesBelow cut) (skyCode scene) (fromIntegral outer)
  mapM (\c -> (,) c <$> outlookFrom sights c) [n - 1, n - 2 .. 0] >>= settle scene keeper cut
  pure cut
{-# INLINE openCut #-}

-- Tables are read and written below without checks of their bounds: corners are below n, quarters below 4n, and
-- objects, where they are no solid, at most n.

-- | Turns the cut through a vertex, and tells of each of its corners what it sees after it.
--
-- /Requires/ vertices in an order in which each corner's vertices come by increasing direction.
-- /Cost/ O(1) per incidence of the vertex with a face.
cross :: Scene -> FaceKeeper s -> Cut s -> Vertex -> ST s [(Int, Outlook)]
cross scene keeper cut vertex = passing scene (cutSights cut) vertex $ \passed -> do
  foldr (\(Passage c before _) above -> above >> leave scene keeper cut c before) (pure ()) passed
  let after = [(c, outlook) | Passage c _ outlook <- passed]
  settle scene keeper cut after
  pure after
{-# INLINE cross #-}

-- | The faces on the quarters of a corner, −1 in the solid: above at the back, above in front, below at the back,
-- below in front.
quartersNow :: Cut s -> Int -> ST s (Int, Int, Int, Int)
quartersNow cut c = (,,,) <$> quarter 0 <*> quarter 1 <*> quarter 2 <*> quarter 3
  where
    quarter k = fromIntegral <$> M.unsafeRead (cutQuarters cut) (4 * c + k)
{-# INLINE quartersNow #-}

-- | The faces on the quarters of all corners now, four each, as in 'quartersNow'. /Cost/ O(n).
quarterTable :: Cut s -> ST s (U.Vector Int32)
quarterTable = U.freeze . cutQuarters

-- | Where a face lies at a corner: twice the number of its first quarter, and 1 more if it lies on both of a flank.
type Place = Int32

placeOf :: Int -> Flank -> Part -> Place
placeOf c flank part = fromIntegral $ case part of
  AtBack -> 2 * first
  InFront -> 2 * first + 2
  Throughout -> 2 * first + 1
  where
    first = case flank of
      Above -> 4 * c
      Below -> 4 * c + 2
{-# INLINE placeOf #-}

firstQuarter :: Place -> Int
firstQuarter place = fromIntegral place `shiftR` 1
{-# INLINE firstQuarter #-}

-- | Takes a corner of a vertex out of the faces around it, after those above it: closes those that end here, and leaves
-- those that go on in 'facesAbove' and 'facesBelow'.
leave :: Scene -> FaceKeeper s -> Cut s -> Int -> Outlook -> ST s ()
leave scene keeper cut c before = do
  foldFaces scene (\flank part b _ rest -> from flank (placeOf c flank part) b >> rest) (pure ()) c before
  forM_ [4 * c .. 4 * c + 3] $ \q -> M.unsafeWrite (cutQuarters cut) q (-1)
  where
    from flank place b = do
      face <- M.unsafeRead (cutQuarters cut) (firstQuarter place)
      case flank of
        Below -> M.unsafeWrite (facesBelow cut) b face
        Above -> do
          begun <- M.unsafeRead (facesBelow cut) b
          if begun == face
            then M.unsafeWrite (facesBelow cut) b (-1) >> closed keeper (fromIntegral face)
            else M.unsafeWrite (facesAbove cut) b face
{-# INLINE leave #-}

-- | Finds the faces around the corners of a vertex, from top to bottom, just after it: opens those that begin here, and
-- takes all others from 'facesAbove' and 'facesBelow'.
settle :: Scene -> FaceKeeper s -> Cut s -> [(Int, Outlook)] -> ST s ()
settle scene keeper cut line = around found >> around remaining
  where
    around act = forM_ line $ \(c, after) ->
      foldFaces scene (\flank part b f rest -> act flank (placeOf c flank part) b f >> rest) (pure ()) c after
    found Above place b f = do
      waiting <- M.unsafeRead (unsettled cut) b
      face <-
        if waiting >= 0
          then do
            M.unsafeWrite (unsettled cut) b (-1)
            face <- fromIntegral <$> opened keeper b f
            put waiting face
            pure face
          else taken (facesAbove cut) b
      put place face
    found Below place b _ = M.unsafeWrite (unsettled cut) b place
    remaining Above _ _ _ = pure ()
    remaining Below place b _ = do
      waiting <- M.unsafeRead (unsettled cut) b
      when (waiting == place) $ do
        M.unsafeWrite (unsettled cut) b (-1)
        taken (facesBelow cut) b >>= put place
    put place face = do
      M.unsafeWrite (cutQuarters cut) (firstQuarter place) face
      when (odd place) $ M.unsafeWrite (cutQuarters cut) (firstQuarter place + 1) face
    taken table b = do
      face <- M.unsafeRead table b
      when (face < 0) $ broken "a face that goes on past a vertex was there before it" (show (map fst line, b))
      M.unsafeWrite table b (-1)
      pure face
{-# INLINE settle #-}
