{-# LANGUAGE BangPatterns #-}

-- | Whether polygons lie to each other as they may, and where they touch, decided by one scan of the plane. For valid
-- scenes it is the whole check of that, and its cost does not depend on how the sides lie, nor on how many of them meet
-- in one place. It does not say what is wrong with others: that is for "Visibility.Scene.Fault".
module Visibility.Scene.Touching
  ( Contacts (..)
  , touching
  , tangled
  ) where

import Control.Monad (filterM, (>=>))
import Control.Monad.ST (ST, runST)
import Data.List (groupBy)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.Predicate
import Visibility.Scene.Boxes (Box (..))
import Visibility.Scene.Contact (rankedPoints, segmentBox)
import Visibility.Scene.Id
import Visibility.Scene.Outline
import Visibility.Scene.Raw (Form (..))
import Visibility.Scene.Scan

-- | Where valid polygons touch.
data Contacts = Contacts
  { contactPlaces :: !Int
  -- ^ In so many places there is more than one corner, or a side that passes.
  , contactCuts :: [(Int, Int)]
  -- ^ A corner in each place that a side passes, with the corner that starts the side.
  }
  deriving (Eq, Show)

-- Note [The sweep]
-- ~~~~~~~~~~~~~~~~
-- It is the scan of "Visibility.Scene.Scan". The status holds the segments that are met, ordered upwards, those along
-- each other in any order. Segments that become neighbours are asked whether they cross further on, and what leads away
-- from a place is asked whether it may be there together.
--
-- Let p be the least point in which segments cross, inside of both, or in which what leads away may not be together.
-- Until p the status is in order. If p is the place of a corner, all segments through it are next to each other when
-- the scan comes there, and so nothing is missed: two that pass on different lines cross, and others are looked at as
-- Note [Around a place] says. Else all segments through p follow each other in the status just before it, and on more
-- than one line: so two neighbours among them are on different lines, and were asked when the last event made them
-- neighbours. So the scan stops at p or before, and what it relies on is right until then.
--
-- Note [Around a place]
-- ~~~~~~~~~~~~~~~~~~~~~
-- What leads away from a place is a cycle of directions, counter-clockwise: what begins there
-- from the lowest to the uppermost, then what ends there from the uppermost to the lowest; what passes is in both. The
-- solid of a ring is the arc from a direction that has it on its left to one that has it on its right. No two solids
-- overlap, and no wall is in one, if and only if each arc ends in the direction that follows the one in which it
-- begins: it has none between, and no two arcs begin or end in one. So it is enough to compare neighbours in the cycle.
-- A ring that has two arcs here touches itself. Walls may share a place in any way but a direction.
--
-- Polygons whose boundaries meet and do not cross overlap if and only if they do at some place where they meet.
--
-- Note [What lies where]
-- ~~~~~~~~~~~~~~~~~~~~~~
-- With each slot goes whether it is free above it: beyond all rings it is free if there is no
-- enclosure, and each ring is a change. Where nothing arrives at a place, the direction down is free if what begins
-- there does not say that it is solid. Of polygons that hang together by contacts and do not overlap, all are in the
-- same part of the plane that the others leave, so it is enough to compare the two at their least place, where nothing
-- arrives. In a valid scene the two agree everywhere. Conversely, of all such parts that are where they may not be, in
-- a solid or outside of the enclosure, take one with the fewest rings around it. What is around it is where it may be,
-- for it has fewer. So if there is no enclosure, there is one ring, and it is solid. Else there is no ring around an
-- obstacle, and it is solid, or there are the enclosure and one obstacle; or there is one around the enclosure, and it
-- is free. In each case the two differ.

-- Note [Taking out]
-- ~~~~~~~~~~~~~~~~~
-- What is wrong does not end the scan. All polygons that take part in it are taken out, with what begins of them later,
-- and the scan goes on with the others, among which all that is wrong is found. Sides that become neighbours are asked
-- whether they cross. Around a place one look is enough: what is left there has only such arcs as it may have.
--
-- For each polygon that is taken out there is a fault of its own, of two neighbours at most. So there are at least half
-- as many faults as such polygons, and each fault has one of these.
--
-- Where a polygon goes around others that are met, what was said of free space is no longer right when it is taken out.
-- So from then on this is not asked. It stays right where a polygon is taken out at its first place.

-- | Where polygons touch; or some of the polygons that take part in what is wrong: if segments cross, if solids or
-- walls overlap, if a ring touches itself, or if a polygon is inside of another one or outside of the enclosure. Among
-- the others no segments cross, and no solids or walls overlap where they meet.
--
-- /Requires/ polygons that have nothing wrong at their own corners.
--
-- /Degenerate cases/ any number of corners in one place, sides that pass corners, sides along each other, vertical
-- ones.
--
-- /Cost/ O(n log n), however the segments lie and wherever they meet: in a valid scene at most three sides pass a
-- place, two solids and a wall between them.
--
-- /Laws/ something is wrong exactly when the comparison of all pairs finds it; else the places are those that hold
-- two corners or a corner and a side, and the cuts are all pairs of such a place and such a side.
--
-- /Source/ Shamos and Hoey, Geometric intersection problems, 1976, for segments that do not meet; that they may touch
-- is this project's.
touching :: Outline -> Either [Int] Contacts
touching o = if null (foundOut found) then Right (foundContacts found) else Left (foundOut found)
  where
    found = runST $ do
      freeAbove <- M.new (outlineTotal o)
      isOut <- M.replicate (V.length (outlineIds o)) False
      scanned o (Parts partOf' (cornersOf o) (\s t -> [partOf' s, partOf' t])) freeAbove isOut
    partOf' (Segment a _) = ownerOf o a

-- | What a scan has found so far.
data Found = Found
  { foundContacts :: !Contacts
  , foundOut :: ![Int]
  -- ^ The parts that are taken out.
  , foundAreas :: !Areas
  }

-- | Is it known where free space is? See Note [Taking out].
data Areas = AreasKnown | AreasLost
  deriving (Eq, Ord)

-- | What is taken out together, by number: that of a side; corners at which the sides of one end; and which go of those
-- of two sides that cross, one at least.
data Parts = Parts {partOf :: Segment -> Int, partCorners :: Int -> [Int], partsCrossing :: Segment -> Segment -> [Int]}

-- The tables are by slot, see Note [What lies where], and by polygon, whether it is taken out.
scanned :: Outline -> Parts -> M.MVector s Bool -> M.MVector s Bool -> ST s Found
scanned o parts freeAbove isOut = scanning plane told (Found (Contacts 0 []) [] AreasKnown)
  where
    told scan found place@(Place _ _ low high change) onward = case change of
      TakenOver s -> do
        crossed <- (<>) <$> crossedBetween o parts scan low s <*> crossedBetween o parts scan s high
        onwardWithout AreasLost crossed found
      Replaced met begun -> do
        now <- if null (foundOut found) then pure begun else stillIn begun
        isFree <- if low == noSlot then pure isFreeBeyond else M.read freeAbove low
        marked isFree now
        let (c, others) = cornersIn plane place
            passing = passingSides plane c met
            isContact = not (null others && null passing)
            next = if isContact then found {foundContacts = added c passing (foundContacts found)} else found
            sides = map keptSide now
            beginning = concat (take 1 (sameWays o c (reverse sides)))
        if null met && not (null now) && foundAreas found == AreasKnown
          && isFree == any ((== OnLeft) . solidOf o) beginning
          then onwardWithout AreasKnown (map (partOf parts) sides) next
          else do
            crossed <- crossedAround o parts scan low now high
            let clashing = if isContact then clashes o c others (map keptSide met) sides passing else []
            onwardWithout AreasLost (clashing <> crossed) next
        where
          stillIn (side : more) = do
            out <- M.read isOut (partOf parts (keptSide side))
            if out then dropSide scan (keptSlot side) >> stillIn more else (side :) <$> stillIn more
          stillIn [] = pure []
      where
        onwardWithout areas wrong next
          | null wrong = onward next
          | otherwise = do
              out <- takenOut o parts isOut scan place (foundOut next) wrong
              onward next {foundOut = out, foundAreas = max areas (foundAreas next)}
    {-# INLINE told #-}
    added c passing (Contacts places cuts) =
      let !more = places + 1 in Contacts more ([(c, startOf o side) | side <- passing] <> cuts)
    marked _ [] = pure ()
    marked isFree (Kept s side : more) = do
      let isNextFree = isFree == (solidOf o side == Nowhere)
      M.write freeAbove s isNextFree
      marked isNextFree more
    isFreeBeyond = Enclosure `V.notElem` outlineIds o
    plane = planeOf o

-- | Some sides, given by the corners that start them, and the places that others pass: a corner in each with the corner
-- that starts the side. Of the others no two cross, and at most three that lie along each other pass a place.
--
-- /Degenerate cases/ all; sides of no length are none.
--
-- /Cost/ O(n log n).
--
-- /Laws/ of two sides that cross, one is found at least. There are not more sides found than pairs that cross or lie
-- along each other.
tangled :: Outline -> ([Int], [(Int, Int)])
tangled o = (foundOut found, contactCuts (foundContacts found))
  where
    found = runST (M.replicate (outlineTotal o) False >>= \isOut -> scanning plane (told isOut) nothing)
    nothing = Found (Contacts 0 []) [] AreasLost
    parts = Parts (startOf o) (\s -> [s, around o 1 s]) (\s t -> [startOf o (if reach s < reach t then s else t)])
    -- The shorter one, which is near to fewer others.
    reach side = let Box l r b t = segmentBox (outlineRanked o) side in (r - l) + (t - b)
    plane = planeOf o
    told isOut scan next place@(Place _ _ low high change) onward = case change of
      TakenOver s ->
        (<>) <$> crossedBetween o parts scan low s <*> crossedBetween o parts scan s high >>= onwardWithout next
      Replaced met now -> do
        crossed <- crossedAround o parts scan low now high
        let (c, _) = cornersIn plane place
            passing = passingSides plane c met
            ways = sameWays o c passing
            Contacts places cuts = foundContacts next
        onwardWithout
          next {foundContacts = Contacts places ([(c, startOf o side) | side <- passing] <> cuts)}
          (crossed <> map (partOf parts) (concatMap (drop 3) (take 1 ways) <> concat (drop 1 ways)))
      where
        onwardWithout now [] = onward now
        onwardWithout now wrong = do
          out <- takenOut o parts isOut scan place (foundOut now) wrong
          onward now {foundOut = out}
    {-# INLINE told #-}

-- | Takes parts out of a scan, at a place, and all those whose sides become neighbours and cross. They are added to
-- those that are out, of which there is a table.
takenOut :: Outline -> Parts -> M.MVector s Bool -> Scan s -> Place -> [Int] -> [Int] -> ST s [Int]
takenOut o parts isOut scan (Place k _ _ _ _) = go
  where
    go out [] = pure out
    go out (p : more) = do
      isKnown <- M.read isOut p
      if isKnown
        then go out more
        else do
          M.write isOut p True
          slots <- concat <$> mapM (arriving scan) (filter (isInLaterPlace plane here) (partCorners parts p))
          crossing <- mapM dropped =<< filterM (fmap ((== p) . partOf parts) . sideIn scan) slots
          go (p : out) (concat crossing <> more)
    dropped s = do
      (low, high) <- dropSide scan s
      known <- or <$> mapM (fmap (partOf parts) . sideIn scan >=> M.read isOut) (filter (/= noSlot) [low, high])
      if known then pure [] else crossedBetween o parts scan low high
    plane = planeOf o
    here = cornerScanned plane k

-- | The corners in a place.
cornersIn :: Plane -> Place -> (Int, [Int])
cornersIn plane (Place k count _ _ _) = (cornerScanned plane k, map (cornerScanned plane) [k + 1 .. k + count - 1])

-- | The sides that pass the place of a corner, of those that were met.
passingSides :: Plane -> Int -> [Kept] -> [Segment]
passingSides plane c met = [side | Kept _ side@(Segment _ b) <- met, isInLaterPlace plane c b]

-- | Parts that must go if the sides that are met in two slots, the first one below, cross further on.
crossedBetween :: Outline -> Parts -> Scan s -> Slot -> Slot -> ST s [Int]
crossedBetween o parts scan low high
  | low == noSlot || high == noSlot = pure []
  | otherwise = crossing <$> sideIn scan low <*> sideIn scan high
  where
    crossing lower@(Segment a b) upper@(Segment c d)
      | turn points a b d == RightTurn && turn points c d b == LeftTurn = partsCrossing parts lower upper
      | otherwise = []
    points = rankedPoints (outlineRanked o)
{-# INLINE crossedBetween #-}

-- | The same between two slots in which sides are now met that lead away from one place.
crossedAround :: Outline -> Parts -> Scan s -> Slot -> [Kept] -> Slot -> ST s [Int]
crossedAround o parts scan low now high = case (now, reverse now) of
  (lowest : _, uppermost : _) ->
    (<>) <$> crossedBetween o parts scan low (keptSlot lowest)
      <*> crossedBetween o parts scan (keptSlot uppermost) high
  _ -> crossedBetween o parts scan low high

-- | What is scanned.
planeOf :: Outline -> Plane
planeOf o =
  Plane
    { planePoints = points
    , cornerTotal = n
    , cornerScanned = \k -> fromIntegral (outlineOrder o U.! k)
    , cornersHere = \k -> 1 + length (takeWhile (isWith k) [k + 1 .. n - 1])
    , joinedCorners = joinedTo o
    , isInLaterPlace = \c q -> q /= noCorner && numberOf o q > numberOf o c
    , reaches = \(Segment a b) c -> turn points a b c == Collinear
    , isLowerFace = const False
    }
  where
    isWith k i = numberAt k == numberAt i
    numberAt k = numberOf o (fromIntegral (outlineOrder o U.! k))
    points = rankedPoints (outlineRanked o)
    n = outlineTotal o
{-# INLINE planeOf #-}

-- | Polygons without which the others may be together in a place, none if all may. See Note [Around a place]. Given are
-- the corners in it, one and others, the sides that reach it and those that go on, both from the lowest to the
-- uppermost, and the sides in both.
--
-- /Cost/ O(k) for k sides.
clashes :: Outline -> Int -> [Int] -> [Segment] -> [Segment] -> [Segment] -> [Int]
clashes o c others met now passing = concat (zipWith clash ways (drop 1 ways <> ways)) <> crossed <> touched
  where
    ways = sameWays o c now <> sameWays o c [Segment b a | Segment a b <- reverse met]
    clash way next
      | many (with Nowhere way) || many (with OnLeft way) = owners way
      | with OnLeft way /= with OnRight next = owners way <> owners next
      | otherwise = []
    with part way = owners [side | side <- way, solidOf o side == part]
    owners way = [ownerOf o a | Segment a _ <- way]
    crossed = if many (sameWays o c passing) then owners passing else []
    touched = [p | p <- owners passing, outlineForms o V.! p == Ring, p `elem` map (ownerOf o) (c : others)]
    many = not . null . drop 1

-- | Sides that follow each other around the place of a corner, those that lead the same way to their second ends
-- together.
sameWays :: Outline -> Int -> [Segment] -> [[Segment]]
sameWays o c = groupBy (\(Segment _ a) (Segment _ b) -> turn (rankedPoints (outlineRanked o)) c a b == Collinear)
