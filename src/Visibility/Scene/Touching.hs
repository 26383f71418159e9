{-# LANGUAGE BangPatterns #-}

-- | Whether polygons lie to each other as they may, and where they touch, decided by one scan of the plane. For valid
-- scenes it is the whole check of that, and its cost does not depend on how the sides lie, nor on how many of them meet
-- in one place. It does not say what is wrong with others: that is for "Visibility.Scene.Fault".
module Visibility.Scene.Touching
  ( Contacts (..)
  , touching
  ) where

import Control.Monad.ST (ST, runST)
import Data.List (groupBy)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.Predicate
import Visibility.Scene.Contact (rankedPoints)
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

-- | Where polygons touch; or some of the polygons that take part in what is wrong first: if segments cross, if solids
-- or walls overlap, if a ring touches itself, or if a polygon is inside of another one or outside of the enclosure.
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
touching o = runST (M.new (outlineTotal o) >>= scanned o)

-- The table is by slot, see Note [What lies where].
scanned :: Outline -> M.MVector s Bool -> ST s (Either [Int] Contacts)
scanned o freeAbove = scanning plane told (Right (Contacts 0 []))
  where
    told scan found (Place k count low high change) onward = case change of
      TakenOver s -> do
        side <- sideIn scan s
        crossed <- (<>) <$> crossedBelow scan low side <*> crossedAbove scan side high
        onwardIf crossed found
      Replaced met now -> do
        isFree <- if low == noSlot then pure isFreeBeyond else M.read freeAbove low
        marked isFree now
        let c = cornerScanned plane k
            passing = [side | Kept _ side@(Segment _ b) <- met, isInLaterPlace plane c b]
            others = map (cornerScanned plane) [k + 1 .. k + count - 1]
            isContact = count > 1 || not (null passing)
            clashing = if isContact then clashes o c others (map keptSide met) (map keptSide now) passing else []
        wrong <- case (map keptSide now, map keptSide (reverse now)) of
          (lowest : _, downwards@(uppermost : _))
            | null met, isFree == or [solidOf o side == OnLeft | side <- concat (take 1 (sameWays o c downwards))] ->
                pure [ownerOf o c]
            | otherwise -> (<>) <$> crossedBelow scan low lowest <*> crossedAbove scan uppermost high
          _ -> if low == noSlot then pure [] else sideIn scan low >>= \side -> crossedAbove scan side high
        onwardIf (wrong <> clashing) (if isContact then added c passing <$> found else found)
      where
        onwardIf wrong now = if null wrong then onward now else pure (Left wrong)
    {-# INLINE told #-}
    added c passing (Contacts places cuts) =
      let !more = places + 1 in Contacts more ([(c, startOf o side) | side <- passing] <> cuts)
    marked _ [] = pure ()
    marked isFree (Kept s side : more) = do
      let isNextFree = isFree == (solidOf o side == Nowhere)
      M.write freeAbove s isNextFree
      marked isNextFree more
    crossedBelow scan s side = if s == noSlot then pure [] else (`crossing` side) <$> sideIn scan s
    crossedAbove scan side s = if s == noSlot then pure [] else crossing side <$> sideIn scan s
    -- The polygons of two sides that are met, the first one below, if they cross further on.
    crossing (Segment a b) (Segment c d)
      | turn points a b d == RightTurn && turn points c d b == LeftTurn = [ownerOf o a, ownerOf o c]
      | otherwise = []
    isFreeBeyond = Enclosure `V.notElem` outlineIds o
    points = rankedPoints (outlineRanked o)
    n = outlineTotal o
    plane =
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
    isWith k i = numberOf o (cornerScanned plane i) == numberOf o (cornerScanned plane k)

-- | Some of the polygons that may not be together in a place, none if all may. See Note [Around a place]. Given are the
-- corners in it, one and others, the sides that reach it and those that go on, both from the lowest to the uppermost,
-- and the sides in both.
--
-- /Cost/ O(k) for k sides.
clashes :: Outline -> Int -> [Int] -> [Segment] -> [Segment] -> [Segment] -> [Int]
clashes o c others met now passing = take 4 (concat (zipWith clash ways (drop 1 ways <> ways)) <> crossed <> touched)
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
