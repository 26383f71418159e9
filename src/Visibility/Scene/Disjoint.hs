{-# LANGUAGE BangPatterns #-}

-- | Whether the boundaries of polygons meet at all, and whether one lies where it may not, decided by a sweep. For
-- valid scenes without contacts it is the whole check of how polygons lie to each other, and unlike a comparison of
-- boxes its cost does not depend on how the sides lie; it does not say what meets.
module Visibility.Scene.Disjoint
  ( Boundaries (..)
  , boundaries
  ) where

import Control.Monad (unless)
import Control.Monad.ST (ST, runST)
import Data.Int (Int32)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.Predicate
import Visibility.Scene.Contact
import Visibility.Scene.Id
import Visibility.Scene.Outline
import Visibility.Scene.Raw (Form (..))
import Visibility.Scene.Status

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
-- Corners are visited in lexicographic order; the status holds the segments with one end visited, ordered upwards
-- (along a line turned from the vertical by as little as you like, so a vertical segment starts at its lower end).
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
  status <- newStatus n
  -- Of slot s, the corner where its segment starts at 2s, and that where it ends at 2s + 1.
  ends <- M.new (2 * n)
  -- The slots of segments that end at corner c, at 2c and 2c + 1.
  arrivals <- M.replicate (2 * n) (fromIntegral noSlot)
  -- By slot, see Note [What lies where].
  freeAbove <- M.new n
  begun <- M.replicate (V.length (outlineIds o)) False
  let
    -- The slots from a number on are not in use yet.
    visit !k !unused !found
      | k >= n = pure found
      | otherwise = do
          let c = fromIntegral (outlineOrder o U.! k)
              (d, e) = joinedTo o c
              isLater q = q /= noCorner && numberOf o q > k
          s <- get arrivals (2 * c)
          t <- get arrivals (2 * c + 1)
          case (isLater d, isLater e) of
            (True, True) -> starting k unused found c d e
            (True, False) -> if s == noSlot then starting k unused found c d noCorner else passing k unused found s c d
            (False, True) -> if s == noSlot then starting k unused found c e noCorner else passing k unused found s c e
            (False, False) -> do
              first <- remove status s
              (low, high) <- if t == noSlot then pure first else remove status t
              fine <- apart low high
              visitIf fine k unused found

    visitIf fine k unused found = if fine then visit (k + 1) unused found else pure Meet

    passing k unused found s c d = do
      occupy s c d
      low <- below status s
      high <- above status s
      fine <- (&&) <$> apart low s <*> apart s high
      visitIf fine k unused found

    starting k unused found c d e = do
      (low, high) <- lookupGap status (isUnder c)
      isFree <- if low == noSlot then pure isFreeBeyond else M.read freeAbove low
      let p = ownerOf o c
          alone = e == noCorner
          isUpsideDown = not alone && turn points c d e == RightTurn
          lower = unused
          upper = if alone then unused else unused + 1
      insertBetween status low high lower
      occupy lower c (if isUpsideDown then e else d)
      M.write freeAbove lower $ case outlineForms o V.! p of
        Ring -> not isFree
        Polyline -> isFree
      unless alone $ do
        insertBetween status lower high upper
        occupy upper c (if isUpsideDown then d else e)
        M.write freeAbove upper isFree
      hasBegun <- M.read begun p
      M.write begun p True
      fine <- (&&) <$> apart low lower <*> apart upper high
      visitIf fine k (upper + 1) $
        if not hasBegun && isFree == (outlineIds o V.! p == Enclosure) then Misplaced else found

    -- Lets a slot hold a segment.
    occupy s c d = do
      put ends (2 * s) c
      put ends (2 * s + 1) d
      first <- get arrivals (2 * d)
      put arrivals (if first == noSlot then 2 * d else 2 * d + 1) s

    isUnder c s = do
      a <- get ends (2 * s)
      b <- get ends (2 * s + 1)
      pure (turn points a b c == LeftTurn)

    apart s t
      | s == noSlot || t == noSlot = pure True
      | otherwise = do
          a <- get ends (2 * s)
          b <- get ends (2 * s + 1)
          c <- get ends (2 * t)
          d <- get ends (2 * t + 1)
          pure (a == c || a == d || b == c || b == d || meeting r (Segment a b) (Segment c d) == Apart)
  visit 0 0 Disjoint
  where
    n = outlineTotal o
    r = outlineRanked o
    points = rankedPoints r
    isFreeBeyond = Enclosure `V.notElem` outlineIds o

get :: M.MVector s Int32 -> Int -> ST s Int
get table k = fromIntegral <$> M.read table k
{-# INLINE get #-}

put :: M.MVector s Int32 -> Int -> Int -> ST s ()
put table k value = M.write table k (fromIntegral value)
{-# INLINE put #-}
