{-# LANGUAGE BangPatterns #-}

-- | What each vertex of the complex adds to the measures of the lines between two objects: taken from the stream of
-- vertices.
module Visibility.FormFactor.Terms
  ( -- * Terms
    Terms
  , termsInPieces
    -- * Their distances
  , Slot
  , slotCount
  , slotEnds
    -- * By pairs of objects
  , Groups (..)
  , groupedBy
  , groupCount
  , groupPair
  , groupTerms
  , rowsOf
  ) where

import Control.Monad (foldM)
import Control.Monad.ST (ST)
import Data.Bits (shiftL, shiftR, (.&.), (.|.))
import Data.Int (Int32)
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Incidence
import Visibility.Scene
import Visibility.Sorting
import Visibility.Sweep.Piece
import Visibility.Sweep.Sights
import Visibility.Sweep.Vertical (skyCode)

-- Note [Measures along the stream]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
-- An edge of corner c between the directions a and b adds ±(t_c(b) − t_c(a)) to each face at its curve, + where the
-- face lies below the curve. Sorted by vertices instead of edges: at a vertex of direction d each corner c on the line
-- adds ±t_c(d) for its faces before the vertex and takes it away for its faces after it. A face that meets the vertex
-- has there, before and after together, as many upper as lower incidences, counted with these signs. So t may be
-- measured from any point of the line, and the first corner is taken. The half turn begins and ends with the same
-- lines, read the other way: t changes its sign, above and below change places, and both contributions cancel. So the
-- cut at ±90° adds nothing.

-- Under an open sky the lines that miss everything have no finite measure; that pair is left out.

-- | Terms ±k·t: an unordered pair of objects by their numbers, the sky's being n, and a weight: the slot of t, and k.
data Terms = Terms
  { termItems :: !(U.Vector (Pair, Int))
  , slots :: !(U.Vector (Int32, Int32))
  }

-- | A distance along the line of a vertex, from its first corner to another one.
type Slot = Int

-- | How many distances there are: for each vertex one less than its corners.
slotCount :: Terms -> Int
slotCount = U.length . slots

-- | The first corner of the line and the corner at the distance, which lies elsewhere.
slotEnds :: Terms -> Slot -> (Int, Int)
slotEnds terms slot = let (a, b) = slots terms U.! slot in (fromIntegral a, fromIntegral b)
{-# INLINE slotEnds #-}

-- | The terms of a stream of vertices, which must be that of the whole half turn.
--
-- /Cost/ O(1) per elementary pair; live memory O(n) besides the result, which has up to six terms for each of them.
termsInPieces :: Scene -> [Piece] -> Terms
termsInPieces scene pieces = Terms (U.concat (map fst found)) (U.concat (map snd found))
  where
    found = alongStream scene (piecewise scene) 0 pieces

-- | The terms and slots of one piece, the first slot having the given number; before them the number of the next slot.
piecewise
  :: Scene
  -> Changing s
  -> Slot
  -> Piece
  -> ST s (Slot, (U.Vector (Pair, Int), U.Vector (Int32, Int32)))
piecewise scene sights !base piece = do
  items <- M.new (6 * size)
  ends <- M.new size
  let
    go !used !slot found = case found of
      [] -> pure (used, slot)
      vertex : rest -> passing scene sights vertex $ \passed -> case passed of
        -- What happens most often.
        [Passage p _ _, Passage q before after] -> distance p q before after used slot >>= \u -> go u (slot + 1) rest
        _ -> general used slot passed >>= \(u, k) -> go u k rest

    general used slot passed = case passed of
      [] -> pure (used, slot)
      Passage first _ _ : others -> foldM (to first) (used, slot) others
    to first (!used, !slot) (Passage c before after)
      | samePlace scene (CornerId first) (CornerId c) = pure (used, slot)
      | otherwise = (\u -> (u, slot + 1)) <$> distance first c before after used slot

    -- The slot for the distance to a corner, and the terms of the corner with it.
    distance !first !c before after !used !slot = do
      M.unsafeWrite ends (slot - base) (int first, int c)
      if before == after
        then pure used
        else do
          end <- faces (-1) before used >>= faces 1 after
          settled slot used end used
      where
        -- Adds terms of the faces at the curve of the corner; the sign is that of faces above it.
        faces !sign = foldFaces scene (face sign) pure c
        face !sign flank _ a b rest u
          | a == sky && b == sky = rest u
          | otherwise = enter used (pairOf (min a b) (max a b)) (if flank == Above then sign else -sign) u >>= rest
    -- Adds to the term of a pair, if there is one since the given place.
    enter !i !pair !k !u
      | i >= u = M.unsafeWrite items u (pair, k) >> pure (u + 1)
      | otherwise = do
          (pair', k') <- M.unsafeRead items i
          if pair' == pair then M.unsafeWrite items i (pair, k' + k) >> pure u else enter (i + 1) pair k u
    -- Keeps those that are not zero, with their slot.
    settled !slot !i !end !u
      | i >= end = pure u
      | otherwise = do
          (pair, k) <- M.unsafeRead items i
          if k == 0
            then settled slot (i + 1) end u
            else M.unsafeWrite items u (pair, weightOf slot k) >> settled slot (i + 1) end (u + 1)
  (used, slot) <- go 0 base (pieceVertices piece)
  items' <- U.freeze (M.take used items)
  ends' <- U.freeze (M.take (slot - base) ends)
  pure (slot, (items', ends'))
  where
    size = pieceCorners piece
    sky = skyCode scene
    int = fromIntegral :: Int -> Int32

-- | A slot and a multiple of it, from −8 to 7.
weightOf :: Slot -> Int -> Int
weightOf slot k = slot `shiftL` 4 .|. (k + 8)
{-# INLINE weightOf #-}

-- | All terms, by pairs of numbers that stand for objects, smaller one first.
data Groups = Groups
  { groupItems :: !(U.Vector (Pair, Int))
  , groupStarts :: !(U.Vector Int)
  -- ^ Where each pair begins; then the number of terms.
  }

-- | Groups terms by the numbers, below a bound, that a table has for objects.
--
-- /Cost/ O(terms + bound).
groupedBy :: Int -> U.Vector Int -> Terms -> Groups
groupedBy bound numbers terms = Groups items (runs fst items)
  where
    items = sortedPairs bound fst (U.map renumbered (termItems terms))
    renumbered (pair, weight) =
      let (a, b) = parts pair
          x = numbers U.! a
          y = numbers U.! b
       in (pairOf (min x y) (max x y), weight)

groupCount :: Groups -> Int
groupCount groups = max 0 (U.length (groupStarts groups) - 1)

-- | The numbers that a group belongs to. /Requires/ a number below 'groupCount'.
groupPair :: Groups -> Int -> (Int, Int)
groupPair groups g = parts (fst (groupItems groups U.! (groupStarts groups U.! g)))

-- | Folds the terms of a group: slots with their multiples. A slot may come more than once.
groupTerms :: (a -> Slot -> Int -> a) -> a -> Groups -> Int -> a
groupTerms combine begin groups g = U.foldl' step begin (U.slice from (to - from) (groupItems groups))
  where
    from = groupStarts groups U.! g
    to = groupStarts groups U.! (g + 1)
    step acc (_, weight) = combine acc (weight `shiftR` 4) ((weight .&. 15) - 8)
{-# INLINE groupTerms #-}

-- | For a number below the bound, all groups with it: the other number of each, ascending, and the group.
--
-- /Cost/ O(groups + bound) when first used, then O(1) for each group.
rowsOf :: Int -> Groups -> Int -> [(Int, Int)]
rowsOf bound groups = \r -> row fst (bucketOf bySecond r) <> row snd (bucketOf byFirst r)
  where
    -- The number is found at once, so that nothing holds all terms for it.
    row part found = [(other, g) | g <- found, let !other = part (groupPair groups g)]
    byFirst = bucketsBy bound (U.generate (groupCount groups) (fromIntegral . fst . groupPair groups))
    bySecond = bucketsBy bound (U.generate (groupCount groups) (fromIntegral . snd . groupPair groups))
