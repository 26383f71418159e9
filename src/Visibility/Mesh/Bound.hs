-- | Fewer break points, by exact criteria.
module Visibility.Mesh.Bound
  ( bounded
  ) where

import Data.List (foldl', sortOn)
import qualified Data.IntMap.Strict as IntMap
import qualified Data.IntSet as IntSet
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Set as Set
import qualified Data.Vector as V
import Visibility.Mesh.Span
import Visibility.Mesh.Type
import Visibility.Scene

-- | What a sequence along a side consists of: ends of pieces, and break points, by their parameters.
data Stop = PieceEnd !Rational | Break !Rational !Rank

-- | What is dropped first: what is no shadow limit.
data Rank = Minor | Major
  deriving (Eq, Ord)

-- | At most so many elements on each side of the file: the mesh that is kept, and that of the break points that are
-- dropped. One after the other is dropped, first all those that are no shadow limits; of these, and then of the others,
-- each time the one whose removal leaves the shortest element, and of several such that with the least parameter.
-- Lengths are compared exactly.
--
-- /Degenerate cases/ a side of which several pieces are uncovered has an element for each of them at least. It keeps
-- none of its break points if there are more pieces than the bound.
--
-- /Cost/ O(k log k) for a side with k break points.
--
-- /Laws/ no side has more elements than the bound allows, or than it has pieces; kept and dropped are together what
-- was there; a side within the bound is left as it is; a bound that is lower by one drops the same points, and at most
-- one more on each side.
bounded :: ElementCount -> Mesh -> (Mesh, Mesh)
bounded most mesh = (part (\gone p -> not (gone p)) , part id)
  where
    scene = meshScene mesh
    spans = pieceSpans scene
    dropped = Map.fromList [(side, Set.fromList (dropping most (stopsOf pieces))) | (side, pieces) <- named]
    named = [(side, fromMaybe [] (piecesOf scene side)) | side <- statedSides scene]
    part choose = mesh {breakTable = V.imap (\s -> filter (choose (isDropped s))) (breakTable mesh)}
    isDropped s point =
      maybe False (Set.member (breakParameter point)) (Map.lookup (sideName scene (SideId s)) dropped)
    stopsOf pieces = concatMap stops (sortOn low pieces)
    low s = let (a, b) = endsOf s in min a b
    endsOf (SideId s) = let piece = spans V.! s in (spanStart piece, spanEnd piece)
    stops s =
      PieceEnd (min a b)
        : [Break (breakParameter p) (rankOf p) | p <- (if a < b then id else reverse) (breaksOn mesh s)]
          <> [PieceEnd (max a b)]
      where
        (a, b) = endsOf s
    rankOf point = if breakKind point == Just ShadowLimit then Major else Minor

-- | The parameters of what is dropped of a sequence along one side.
dropping :: ElementCount -> [Stop] -> [Rational]
dropping most stops = go excess initial (IntSet.fromDistinctAscList [0 .. length stops - 1])
  where
    excess = length [() | Break _ _ <- stops] + length [() | PieceEnd _ <- stops] `div` 2 - countedElements most
    places = IntMap.fromDistinctAscList (zip [0 ..] stops)
    initial = foldl' (\queue i -> insert i everything queue) Set.empty (IntMap.keys places)
    everything = IntMap.keysSet places
    go left queue present
      | left <= 0 = []
      | otherwise = case Set.minView queue of
          Nothing -> []
          Just ((_, _, t, i), rest) ->
            let beside = [j | Just j <- [IntSet.lookupLT i present, IntSet.lookupGT i present]]
                present' = IntSet.delete i present
                queue' = foldl' (\q j -> insert j present' (remove j present q)) rest beside
             in t : go (left - 1) queue' present'
    insert i present = maybe id Set.insert (entry i present)
    remove i present = maybe id Set.delete (entry i present)
    -- Its rank, the length of the element that its removal leaves, its parameter.
    entry i present = case IntMap.lookup i places of
      Just (Break t rank) -> Just (rank, next - previous, t, i)
        where
          previous = maybe 0 at (IntSet.lookupLT i present)
          next = maybe 1 at (IntSet.lookupGT i present)
      _ -> Nothing
    at i = case IntMap.lookup i places of
      Just (Break t _) -> t
      Just (PieceEnd t) -> t
      Nothing -> 0
