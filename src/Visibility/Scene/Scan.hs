{-# LANGUAGE BangPatterns #-}

-- | One scan of the plane from left to right: a vertical goes over corners, and the sides that it meets are kept in
-- their order, with the neighbours of each at hand.
--
-- Verticals lean a little to the right, by as little as you like: corners on one vertical are met in lexicographic
-- order, and a vertical side starts at its lower end. A side is given as a segment from its left end to its right one.
-- The two sides of a thin wall of one piece are one; the two faces of a piece of a longer one are two, in one place.
--
-- Sides may share a place, pass one, and lie along each other. What reaches a place is then next to each other among
-- the sides that are met: it is taken out there, and what goes on is put back with what begins, in the order of the
-- directions in which it leads away.
module Visibility.Scene.Scan
  ( -- * What is scanned
    Plane (..)
  , Segment (..)
    -- * The scan
  , Scan
  , scanning
  , Place (..)
  , Change (..)
  , Kept (..)
    -- * The sides that are met
  , Slot
  , noSlot
  , sideIn
  , isUnder
    -- * Taking out
  , arriving
  , dropSide
  ) where

import Control.Monad (unless)
import Control.Monad.ST (ST)
import Data.Int (Int32)
import Data.List (sortBy)
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.Point (Points)
import Visibility.Exact.Predicate
import Visibility.Law (broken)
import Visibility.Scene.Contact (Segment (..))
import Visibility.Scene.Status

-- | Corners by number, joined by sides that do not cross. They are scanned in the order of their places, those of one
-- place together.
data Plane = Plane
  { planePoints :: !Points
  , cornerTotal :: !Int
  , cornerScanned :: Int -> Int
  -- ^ The corner that is scanned after so many others.
  , cornersHere :: Int -> Int
  -- ^ How many corners are in the place of the one that is scanned after so many others and is the first there.
  , joinedCorners :: Int -> (Int, Int)
  -- ^ The corners to which sides lead from one. They may be the same.
  , isInLaterPlace :: Int -> Int -> Bool
  -- ^ Is the place of the second corner scanned after that of the first? False of what is no corner.
  , reaches :: Segment -> Int -> Bool
  -- ^ Does a side that is met end in the place of a corner, or pass it, if all between the two does?
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

-- | What becomes of the sides that reach a place.
data Change
  = -- | One side ends, and the one that begins takes its slot.
    TakenOver !Slot
  | -- | These sides were met, and these are now, from the lowest to the uppermost. Those that pass are in both.
    Replaced [Kept] [Kept]

-- | A side and its slot.
data Kept = Kept {keptSlot :: !Slot, keptSide :: !Segment}

-- | Goes over all places. At each it is told what has changed there, and how to go on, or not.
--
-- /Requires/ sides that are in order as far as the scan goes. /Cost/ O(log n) for each corner and for each side that
-- passes a place, for n corners; O(n) memory.
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
              onlyLater = if isInLaterPlace plane c d then d else e
          s <- get arrivals (2 * c)
          t <- get arrivals (2 * c + 1)
          -- What happens most often has a way of its own, without lists.
          if s /= noSlot && t == noSlot && size == 1 && isInLaterPlace plane c onlyLater
            then do
              low <- below status s
              high <- above status s
              alone <- (\lower upper -> not (lower || upper)) <$> isReached c low <*> isReached c high
              if alone
                then do
                  occupy s (Segment c onlyLater)
                  told scan found (Place k 1 low high (TakenOver s)) (visit (k + 1) unused)
                else replaced k c size s unused found
            else replaced k c size s unused found

    -- At a place of so many corners, the first of them c, where a side ends in slot s if that is one.
    replaced k c size s unused found = do
      (underneath, overhead) <-
        if s == noSlot then lookupGap status (fmap not . isUnder plane scan c) else (,) s <$> above status s
      (lower, low) <- lowerFrom c [] underneath
      (upper, high) <- upperFrom c overhead
      let met = lower <> upper
          passing = filter (\(Kept _ (Segment _ b)) -> isInLaterPlace plane c b) met
          others = if size == 1 then [] else map (cornerScanned plane) [k + 1 .. k + size - 1]
          beginning = zipWith Kept [unused ..] (startingSides plane c others)
          now = upwardsFrom plane c (beginning <> passing)
      ending <- length . filter (/= noSlot) <$> mapM (get arrivals) (concat [[2 * i, 2 * i + 1] | i <- c : others])
      -- Unsafe arithmetic may get the sides out of order.
      unless (length met == length passing + ending) $
        broken "the sides that a vertical meets are in order" ("at corner " <> show c)
      filled low high now
      mapM_ (\(Kept slot side) -> occupy slot side) beginning
      told scan found (Place k size low high (Replaced met now)) (visit (k + size) (unused + length beginning))

    -- Takes out what reaches a place, from a slot on downwards or upwards: that, and the slot next to it.
    lowerFrom c found low = do
      reached <- isReached c low
      if reached
        then do
          side <- sideIn scan low
          (next, _) <- remove status low
          lowerFrom c (Kept low side : found) next
        else pure (found, low)
    upperFrom c high = do
      reached <- isReached c high
      if reached
        then do
          side <- sideIn scan high
          (_, next) <- remove status high
          (rest, final) <- upperFrom c next
          pure (Kept high side : rest, final)
        else pure ([], high)

    filled _ _ [] = pure ()
    filled low high (Kept s _ : more) = insertBetween status low high s >> filled s high more

    occupy s (Segment a b) = do
      put (scanEnds scan) (2 * s) a
      put (scanEnds scan) (2 * s + 1) b
      first <- get arrivals (2 * b)
      put arrivals (if first == noSlot then 2 * b else 2 * b + 1) s

    isReached c s = if s == noSlot then pure False else (\side -> reaches plane side c) <$> sideIn scan s
  visit 0 0 begin
  where
    n = cornerTotal plane
{-# INLINE scanning #-}

-- | The sides that start at corners of one place, of which one is the first.
startingSides :: Plane -> Int -> [Int] -> [Segment]
startingSides plane first others =
  [Segment c d | c <- first : others, d <- neighbours c, isInLaterPlace plane first d]
  where
    neighbours c = let (d, e) = joinedCorners plane c in if d == e then [d] else [d, e]
{-# INLINE startingSides #-}

-- | Sides that go on from the place of a corner, from the lowest to the uppermost.
upwardsFrom :: Plane -> Int -> [Kept] -> [Kept]
upwardsFrom plane c found = case found of
  [side, other] -> if order side other == GT then [other, side] else found
  _ -> sortBy order found
  where
    order (Kept _ side@(Segment _ b)) (Kept _ other@(Segment _ d)) = case turn (planePoints plane) c b d of
      LeftTurn -> LT
      RightTurn -> GT
      Collinear -> compare (isLowerFace plane other) (isLowerFace plane side)
{-# INLINE upwardsFrom #-}

-- | The side in a slot.
sideIn :: Scan s -> Slot -> ST s Segment
sideIn scan s = Segment <$> get (scanEnds scan) (2 * s) <*> get (scanEnds scan) (2 * s + 1)
{-# INLINE sideIn #-}

-- | The slots of the sides that will end at a corner which is not yet scanned, of those that are met.
arriving :: Scan s -> Int -> ST s [Slot]
arriving scan c = filter (/= noSlot) <$> mapM (get (scanArrivals scan)) [2 * c, 2 * c + 1]

-- | Takes out a side that is met, as if it were not there, and gives the slots just below it and just above it.
dropSide :: Scan s -> Slot -> ST s (Slot, Slot)
dropSide scan s = do
  Segment _ b <- sideIn scan s
  first <- get arrivals (2 * b)
  put arrivals (if first == s then 2 * b else 2 * b + 1) noSlot
  remove (scanStatus scan) s
  where
    arrivals = scanArrivals scan

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
