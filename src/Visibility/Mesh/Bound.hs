-- | Fewer break points: at most so many elements on each side, where lengths are compared exactly.
module Visibility.Mesh.Bound
  ( bounded
  ) where

import Data.List (foldl', sortOn)
import qualified Data.IntSet as IntSet
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isJust, maybeToList)
import qualified Data.Set as Set
import Data.Tuple (swap)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Mesh.Span
import Visibility.Mesh.Type
import Visibility.Scene

-- | What a sequence along a side consists of: ends of pieces, and break points, by their parameters. Break points have
-- a rank, and those that are alike otherwise go by their last number.
data Stop = Stop {stopAt :: !Rational, stopBreak :: !(Maybe (Rank, Rational))}

-- | What is dropped first: what is no shadow limit.
data Rank = Minor | Major
  deriving (Eq, Ord)

-- | At most so many elements on each side of the file: the mesh that is kept, and that of the break points that are
-- dropped. One after the other is dropped, first all those that are no shadow limits; of these, and then of the others,
-- each time the one whose removal leaves the shortest element, and of several such that with the least parameter.
-- Lengths are compared exactly.
--
-- /Degenerate cases/ a side of which several pieces are uncovered has an element for each of them at least. It keeps
-- none of its break points if there are more pieces than the bound. The two faces of a thin wall are cut at the break
-- points of both (see 'Visibility.Mesh.Element.refined'), so on each face those of both count; what is a shadow limit
-- on one of them is one on both, the parameter is that on the face that is named first, and what one face drops is
-- dropped on both.
--
-- /Cost/ O(k log k) for a side with k break points, and O(n log n) in all.
--
-- /Laws/ no side has more elements than the bound allows, or than it has pieces, those that it shares with the other
-- face of a wall among them; kept and dropped are together what was there; a side within the bound, the other face
-- being so too, is left as it is; a bound that is lower by one drops the same points, and at most one more on each
-- side, or two on a face of a wall that is covered in part.
bounded :: ElementCount -> Mesh -> (Mesh, Mesh)
bounded most mesh = (part (\gone p -> not (gone p)) , part id)
  where
    scene = meshScene mesh
    spans = pieceSpans scene
    dropped = Map.fromList [(side, Set.fromList (dropping most (stopsOf pieces))) | (side, pieces) <- named]
    named = [(side, fromMaybe [] (piecesOf scene side)) | side <- statedSides scene]
    part choose = mesh {breakTable = V.imap (\s -> filter (choose (isDropped (SideId s)))) (breakTable mesh)}
    isDropped s point = or [drops face (parameterAt face point) | face <- s : maybeToList (behind s)]
    drops face t = maybe False (Set.member t) (Map.lookup (sideName scene face) dropped)
    behind = otherFace scene
    parameterAt (SideId s) point = let piece = spans V.! s in parameterOn (spanFrom piece, spanTo piece) (breakAt point)
    stopsOf pieces = concatMap (stops (if any isSecond pieces then negate else id)) (sortOn low pieces)
    low s = let (a, b) = endsOf s in min a b
    endsOf (SideId s) = let piece = spans V.! s in (spanStart piece, spanEnd piece)
    stops among s =
      Stop (min a b) Nothing
        : [Stop t (Just (rank, among t)) | (t, rank) <- Map.toAscList (ranks s)]
          <> [Stop (max a b) Nothing]
      where
        (a, b) = endsOf s
    isSecond s = or [sideName scene other < sideName scene s | Just other <- [behind s]]
    ranks s =
      Map.fromListWith max $
        [(breakParameter p, rankOf p) | p <- breaksOn mesh s]
          <> [(parameterAt s p, rankOf p) | Just other <- [behind s], p <- breaksOn mesh other]
    rankOf point = if breakKind point == Just ShadowLimit then Major else Minor

-- | The side in the same place that is seen from behind, if there is one: the other face of a thin wall.
otherFace :: Scene -> SideId -> Maybe SideId
otherFace scene = \s -> Map.lookup (swap (ends s)) faces
  where
    faces = Map.fromList [(ends s, s) | s <- sides scene]
    ends s = (place (sideStart s), place (sideEnd scene s))
    place (CornerId c) = placeNumbers scene U.! c

-- | The parameters of what is dropped of a sequence along one side.
dropping :: ElementCount -> [Stop] -> [Rational]
dropping most stops = go (breaks + (length stops - breaks) `div` 2 - countedElements most) initial everything
  where
    breaks = length (filter (isJust . stopBreak) stops)
    places = V.fromList stops
    initial = foldl' (\queue i -> insert i everything queue) Set.empty (IntSet.toAscList everything)
    everything = IntSet.fromDistinctAscList [0 .. length stops - 1]
    go left queue present
      | left <= 0 = []
      | otherwise = case Set.minView queue of
          Nothing -> []
          Just ((_, _, _, i), rest) ->
            let beside = [j | Just j <- [IntSet.lookupLT i present, IntSet.lookupGT i present]]
                present' = IntSet.delete i present
                queue' = foldl' (\q j -> insert j present' (remove j present q)) rest beside
             in at i : go (left - 1) queue' present'
    insert i present = maybe id Set.insert (entry i present)
    remove i present = maybe id Set.delete (entry i present)
    -- Its rank, the length of the element that its removal leaves, what decides among such.
    entry i present = do
      (rank, among) <- stopBreak (places V.! i)
      Just (rank, maybe 1 at (IntSet.lookupGT i present) - maybe 0 at (IntSet.lookupLT i present), among, i)
    at i = stopAt (places V.! i)
