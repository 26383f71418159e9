{-# LANGUAGE BangPatterns #-}

-- | One scan of the plane from left to right: a vertical goes over corners, and the sides that it meets are kept in
-- their order, with the neighbours of each at hand.
--
-- Verticals lean a little to the right, by as little as you like: corners on one vertical are met in lexicographic
-- order, and a vertical side starts at its lower end. A side is given as a segment from its left end to its right one.
-- The two sides of a thin wall of one piece are one; the two faces of a piece of a longer one are two, in one place.
module Visibility.Scene.Scan
  ( -- * What is scanned
    Plane (..)
  , Segment (..)
    -- * The scan
  , Scan
  , scanning
  , Place (..)
  , Change (..)
    -- * The sides that are met
  , Slot
  , noSlot
  , sideIn
  , isUnder
  ) where

import Control.Monad.ST (ST)
import Data.Int (Int32)
import Data.List (delete, sortBy)
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.Point (Points)
import Visibility.Exact.Predicate
import Visibility.Law (broken)
import Visibility.Scene.Contact (Segment (..))
import Visibility.Scene.Status

-- | Corners by number, joined by sides that meet in corners only. They are scanned in the order of their places, those
-- of one place together.
data Plane = Plane
  { planePoints :: !Points
  , cornerTotal :: !Int
  , cornerScanned :: Int -> Int
  -- ^ The corner that is scanned after so many others.
  , cornersHere :: Int -> Int
  -- ^ How many corners are in the place of the one that is scanned after so many others and is the first there.
  , joinedCorners :: Int -> (Int, Int)
  -- ^ The corners to which sides lead from one. They may be the same.
  , isScannedAfter :: Int -> Int -> Bool
  -- ^ Is a corner one that is scanned after so many others and one more? False of what is no corner.
  , isLowerFace :: Segment -> Bool
  -- ^ Of two faces of one piece of a wall, is this the lower one, which has free space on its right?
  }

-- | The sides that the vertical meets, each in a slot, and each slot with the ends of its side.
data Scan s = Scan
  { scanStatus :: !(Status s)
  , scanEnds :: !(M.MVector s Int32)
  -- ^ Of slot s, the ends of its side at 2s and 2s + 1.
  , scanArrivals :: !(M.MVector s Int32)
  -- ^ The slots of the sides that end at corner c, at 2c and 2c + 1.
  }

-- | A place that the vertical goes over: how many corners were scanned before, how many are here; the slots just below
-- the place and just above it, and what becomes of those between.
data Place = Place !Int !Int !Slot !Slot !Change

-- | What becomes of the sides that end in a place. Slots that are new have numbers above those of all others.
data Change
  = -- | Nothing begins there.
    Ended
  | -- | The one side that begins takes the slot of the one that ends.
    TakenOver !Slot
  | -- | So many sides begin, from the lowest to the uppermost in slots from this one on.
    Begun !Slot !Int

-- | Goes over all places. At each it is told what has changed there, and how to go on, or not.
--
-- /Requires/ sides that are in order as far as the scan goes. /Cost/ O(n log n) for n corners, O(n) memory.
--
-- /Source/ Shamos and Hoey, Geometric intersection problems, 1976.
scanning :: Plane -> (Scan s -> a -> Place -> (a -> ST s a) -> ST s a) -> a -> ST s a
scanning plane told begin = do
  scan <- Scan <$> newStatus n <*> M.new (2 * n) <*> M.replicate (2 * n) (fromIntegral noSlot)
  let
    status = scanStatus scan
    arrivals = scanArrivals scan

    visit !k !unused found
      | k >= n = pure found
      | otherwise = do
          let c = cornerScanned plane k
              (d, e) = joinedCorners plane c
              size = cornersHere plane k
              onlyLater = if isScannedAfter plane k d then d else e
          s <- get arrivals (2 * c)
          t <- get arrivals (2 * c + 1)
          -- What happens most often has a way of its own, without lists.
          if s /= noSlot && t == noSlot && size == 1 && isScannedAfter plane k onlyLater
            then do
              occupy s (Segment c onlyLater)
              low <- below status s
              high <- above status s
              told scan found (Place k 1 low high (TakenOver s)) (visit (k + 1) unused)
            else do
              let others = if size == 1 then [] else map (cornerScanned plane) [k + 1 .. k + size - 1]
                  starting = startingSides plane k (c : others)
                  count = length starting
              (low, high) <- concat <$> mapM arriving others >>= gap c s t
              filled low high unused starting
              told scan found (Place k size low high (if count == 0 then Ended else Begun unused count)) $
                visit (k + size) (unused + count)

    -- The slots around a place, when those that end there have been taken out: those of its first corner and others.
    gap c s t others
      | s /= noSlot = remove status s >>= widened c (if t == noSlot then others else t : others)
      | otherwise = case others of
          [] -> lookupGap status (fmap not . isUnder plane scan c)
          o : more -> remove status o >>= widened c more
    widened _ [] around = pure around
    -- Unsafe arithmetic may get the sides out of order.
    widened c slots (low, high) = case filter (\s -> s == low || s == high) slots of
      s : _ -> remove status s >>= widened c (delete s slots)
      [] -> broken "the sides that a vertical meets are in order" ("at corner " <> show c)

    filled _ _ _ [] = pure ()
    filled low high s (side : others) = do
      occupy s side
      insertBetween status low high s
      filled s high (s + 1) others

    occupy s (Segment a b) = do
      put (scanEnds scan) (2 * s) a
      put (scanEnds scan) (2 * s + 1) b
      first <- get arrivals (2 * b)
      put arrivals (if first == noSlot then 2 * b else 2 * b + 1) s

    arriving c = do
      s <- get arrivals (2 * c)
      t <- get arrivals (2 * c + 1)
      pure (filter (/= noSlot) [s, t])
  visit 0 0 begin
  where
    n = cornerTotal plane
{-# INLINE scanning #-}

-- | The sides that start at corners of one place, which are scanned after so many others, from the lowest to the
-- uppermost.
startingSides :: Plane -> Int -> [Int] -> [Segment]
startingSides plane k here = case [Segment c d | c <- here, d <- neighbours c, isScannedAfter plane k d] of
  [side, other] -> if order side other == GT then [other, side] else [side, other]
  found -> sortBy order found
  where
    neighbours c = let (d, e) = joinedCorners plane c in if d == e then [d] else [d, e]
    order side@(Segment a b) (Segment _ d) = case turn (planePoints plane) a b d of
      LeftTurn -> LT
      RightTurn -> GT
      Collinear -> if isLowerFace plane side then LT else GT
{-# INLINE startingSides #-}

-- | The side in a slot.
sideIn :: Scan s -> Slot -> ST s Segment
sideIn scan s = Segment <$> get (scanEnds scan) (2 * s) <*> get (scanEnds scan) (2 * s + 1)
{-# INLINE sideIn #-}

-- | Does a corner lie under the side in a slot, or on its line?
isUnder :: Plane -> Scan s -> Int -> Slot -> ST s Bool
isUnder plane scan c s = (\(Segment a b) -> turn (planePoints plane) a b c /= LeftTurn) <$> sideIn scan s
{-# INLINE isUnder #-}

get :: M.MVector s Int32 -> Int -> ST s Int
get table k = fromIntegral <$> M.read table k
{-# INLINE get #-}

put :: M.MVector s Int32 -> Int -> Int -> ST s ()
put table k value = M.write table k (fromIntegral value)
{-# INLINE put #-}
