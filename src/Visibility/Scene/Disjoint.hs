-- | Whether the boundaries of polygons meet at all, and whether one lies where it may not, decided by a sweep. For
-- valid scenes without contacts it is the whole check of how polygons lie to each other, and unlike a comparison of
-- boxes its cost does not depend on how the sides lie; it does not say what meets.
module Visibility.Scene.Disjoint
  ( Boundaries (..)
  , boundaries
  ) where

import Control.Monad (when)
import Control.Monad.ST (ST, runST)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Scene.Contact
import Visibility.Scene.Id
import Visibility.Scene.Outline
import Visibility.Scene.Raw (Form (..))
import Visibility.Scene.Scan

-- | How the polygons of an outline lie to each other.
data Boundaries
  = -- | Apart, none inside of an obstacle, and all inside the enclosure if there is one.
    Disjoint
  | -- | Apart, but not all where they may be.
    Misplaced
  | -- | Segments meet elsewhere than in corners that they share.
    Meet
  deriving (Eq, Show)

-- Note [The sweep]
-- ~~~~~~~~~~~~~~~~
-- It is the scan of "Visibility.Scene.Scan": the status holds the segments with one end visited, ordered upwards.
-- Segments that become neighbours in the status are compared. Let p be the least point, in the order of corners, in
-- which segments meet that do not share a corner there; no two corners are in one place, which is checked at the start.
-- Until p the status is in order. If two of the segments through p are in the status just before p, then all that are
-- follow each other, and two neighbours among them that do not share p were compared when the last event made them
-- neighbours. Otherwise one of them starts at p and one at most comes from before: it is next to p in the status, and
-- so to those that start there. So the sweep stops at p or before, and what it relies on is right until then: that
-- segments which end at a corner follow each other in the status, so that one which starts there takes the slot of the
-- one that ends, or both leave theirs.
--
-- Note [What lies where]
-- ~~~~~~~~~~~~~~~~~~~~~~
-- With each slot goes whether it is free above it, by the number of rings around: beyond all rings it is free if there
-- is no enclosure, and each ring is a change. This is the same all along a boundary, as long as none meet. A polygon
-- counts as misplaced if it is not free around its least corner, an enclosure if it is.
--
-- A polygon that is where it may be has no ring around it, or, if there is an enclosure, just that; an enclosure has
-- none. So it does not count as misplaced. Conversely, of all misplaced polygons take one with the fewest rings around
-- it. These are where they may be, for they have fewer. So if there is no enclosure, there is one of them. Else it is
-- no obstacle alone, for that is outside of the enclosure; so there are the enclosure and one obstacle in it, or none;
-- and none is right for the enclosure. In each case the polygon counts as misplaced.

-- | Do boundaries meet, but for segments with a corner in common, which meet there, and is every polygon where it may
-- be?
--
-- /Requires/ polygons that have nothing wrong at their own corners, but for corners in one place.
--
-- /Degenerate cases/ two corners in one place are 'Meet'. Vertical segments and segments on one line are ordinary.
--
-- /Cost/ O(n log n), however the segments lie.
--
-- /Laws/ 'Meet' exactly when 'meeting' is not 'Apart' for two segments without a common corner, or two corners are in
-- one place; else 'Misplaced' exactly when an obstacle is inside of another one or outside of the enclosure.
--
-- /Source/ Shamos and Hoey, Geometric intersection problems, 1976.
boundaries :: Outline -> Boundaries
boundaries o
  | placeTotal o < outlineTotal o = Meet
  | otherwise = runST (sweep o)

sweep :: Outline -> ST s Boundaries
sweep o = do
  -- By slot, see Note [What lies where].
  freeAbove <- M.new n
  begun <- M.replicate (V.length (outlineIds o)) False
  let
    told scan found (Place k _ low high change) onward = case change of
      Ended -> apart low high >>= onwardIf found
      TakenOver s -> (&&) <$> apart low s <*> apart s high >>= onwardIf found
      Begun lower count -> do
        isFree <- if low == noSlot then pure isFreeBeyond else M.read freeAbove low
        let p = ownerOf o (cornerScanned plane k)
            upper = lower + count - 1
        M.write freeAbove upper isFree
        when (upper > lower) $
          M.write freeAbove lower $ case outlineForms o V.! p of
            Ring -> not isFree
            Polyline -> isFree
        hasBegun <- M.read begun p
        M.write begun p True
        fine <- (&&) <$> apart low lower <*> apart upper high
        onwardIf (if not hasBegun && isFree == (outlineIds o V.! p == Enclosure) then Misplaced else found) fine
      where
        onwardIf now fine = if fine then onward now else pure Meet
        apart s t
          | s == noSlot || t == noSlot = pure True
          | otherwise = separate <$> sideIn scan s <*> sideIn scan t
    {-# INLINE told #-}
  scanning plane told Disjoint
  where
    n = outlineTotal o
    r = outlineRanked o
    isFreeBeyond = Enclosure `V.notElem` outlineIds o
    plane =
      Plane
        { planePoints = rankedPoints r
        , cornerTotal = n
        , cornerScanned = \k -> fromIntegral (outlineOrder o U.! k)
        , cornersHere = const 1
        , joinedCorners = joinedTo o
        , isScannedAfter = \k q -> q /= noCorner && numberOf o q > k
        , isLowerFace = const False
        }
    separate (Segment a b) (Segment c d) =
      a == c || a == d || b == c || b == d || meeting r (Segment a b) (Segment c d) == Apart
