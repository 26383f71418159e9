{-# LANGUAGE BangPatterns #-}

-- | Where the lines of vertices land on sides: taken from the stream of vertices, and sorted by side, before any
-- coordinate is computed.
module Visibility.Mesh.Landing
  ( Landings
  , landings
  , landingsOn
  ) where

import Control.Monad.ST (ST)
import Data.Int (Int32)
import Data.List (minimumBy)
import Data.Ord (comparing)
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Incidence (Outlook (..))
import Visibility.Mesh.Type
import Visibility.Scene
import Visibility.Sorting
import Visibility.Sweep.Piece
import Visibility.Sweep.Sights
import Visibility.Sweep.Vertex
import Visibility.Sweep.Vertical (skyCode, solid)
import Visibility.View (freeBitangents)

-- | All landings by their sides, in the order of the stream: the near corner, the far one, and whether they are a free
-- bitangent.
data Landings = Landings !Buckets !(U.Vector (Int32, Int32, Bool))

-- | A landing as it is found, with its side first.
type Found = (Int32, (Int32, Int32, Bool))

-- Note [Landings]
-- ~~~~~~~~~~~~~~~
-- The maximal free segment of a vertex ends where the first corner sees backward and where the last one sees forward.
-- A vertex has all corners on its segment, so where there is an object to be seen, the segment ends strictly inside a
-- piece of a side, or in the sky. Where there is none, it ends at the corner and casts nothing.
--
-- A segment goes on past each of its corners but perhaps the first and the last. So of its elementary pairs those are
-- no free bitangents that are sides, and at the ends those with a corner at which it ends. Of a vertex of two corners
-- this is known from what they see; others are asked.
--
-- Only one ray leads from a landing to the nearest place with corners, in one cone of free space; so on each line only
-- one vertex lands at a point.

-- | The landings of a stream of vertices, which must be that of the whole half turn.
--
-- /Degenerate cases/ of the elementary pairs of a degenerate vertex, the free bitangent nearest to the landing is the
-- caster; if none is free, the nearest pair. Where several pairs join the same places, as along both faces of a wall,
-- it is the one with the smaller names.
--
-- /Cost/ O(1) per elementary pair, O(m + n) in all; 17 bytes per landing.
landings :: Scene -> [Vertex] -> Landings
landings scene swept = Landings (bucketsBy (cornerCount scene) landedOn) items
  where
    (landedOn, items) = U.unzip (U.concat found)
    found = alongStream scene (\sights _ piece -> (,) () <$> piecewise scene sights piece) () (inPieces swept)

-- | The casters that land on a side, in the order of the stream.
landingsOn :: Landings -> SideId -> [Caster]
landingsOn (Landings bySide items) (SideId s) =
  [ Caster (if free then ShadowLimit else Kink) (CornerId (fromIntegral p)) (CornerId (fromIntegral q))
  | (p, q, free) <- map (items U.!) (bucketOf bySide s)
  ]

-- | The landings of one piece of the stream. See Note [Landings].
piecewise :: Scene -> Changing s -> Piece -> ST s (U.Vector Found)
piecewise scene sights piece = do
  items <- M.new (2 * pieceLength piece)
  let
    go !used found = case found of
      [] -> pure used
      vertex : rest -> passing scene sights vertex $ \passed -> case passed of
        [Passage p (Outlook back _ _) _, Passage q (Outlook _ front _) _] | not (hasSplitEnds scene) -> do
          let free = back /= solid && front /= solid && not (isSide p q)
          put used back p q free >>= \u -> put u front q p free >>= \u' -> go u' rest
        _ -> do
          let (backward, forward) = casting scene vertex
          cast used (firstSeen (\(Outlook back _ _) -> back) passed) backward
            >>= \u -> cast u (firstSeen (\(Outlook _ front _) -> front) (reverse passed)) forward
            >>= \u' -> go u' rest
    cast used object (Caster kind (CornerId near) (CornerId far)) = put used object near far (kind == ShadowLimit)
    put !used !object !near !far !free
      | object == solid || object == sky = pure used
      | otherwise = do
          M.write items used (fromIntegral object, (fromIntegral near, fromIntegral far, free))
          pure (used + 1 :: Int)
  used <- go 0 (pieceVertices piece)
  U.freeze (M.take used items)
  where
    sky = skyCode scene
    isSide p q = nextCorner scene (CornerId p) == CornerId q || previousCorner scene (CornerId p) == CornerId q
    -- Where a line runs along both faces of a wall, it goes on along one of them at most.
    firstSeen part passed = case filter (/= solid) (map part (here passed)) of
      object : _ -> object
      [] -> solid
    here passed = case passed of
      [] -> []
      Passage first _ _ : _ ->
        let isHere (Passage c _ _) = samePlace scene (CornerId first) (CornerId c)
         in [before | Passage _ before _ <- takeWhile isHere passed]

-- | What a vertex casts backward and forward, if it lands there.
casting :: Scene -> Vertex -> (Caster, Caster)
casting scene vertex = (nearest pairs, nearest (reverse [(q, p) | (p, q) <- pairs]))
  where
    (kind, pairs) = case freeBitangents scene vertex of
      [] -> (Kink, vertexPairs scene vertex)
      free -> (ShadowLimit, free)
    nearest found = case found of
      [] -> Caster Kink (vertexFirst vertex) (vertexLast vertex)
      (p, _) : _ ->
        minimumBy (comparing (casterNames scene)) [Caster kind p' q | (p', q) <- found, samePlace scene p p']
