-- | What each corner sees just before and just after each of its vertices, in O(1) per elementary pair.
--
-- The stream of vertices becomes a stream of events, and that becomes edges. At a direction between two of its
-- vertices, the line through a corner has a 'View': tangent, ending or buried (mathematics: lines, curves, the dual).
--
-- /Source/ Rivière, Topologically sweeping the visibility complex of polygonal scenes; landing sides derived for this
-- project.
module Visibility.View
  ( -- * Views (their rule: "Visibility.Incidence")
    View (..)
  , Flank (..)
  , End (..)
  , Incidence (..)
  , incidences
  , isBuried
    -- * Tangency at a vertex
  , isTangent
  , freeBitangents
    -- * Pairs as the file calls them
  , statedPairs
  , statedPairCount
    -- * The stream of events
  , Event (..)
  , events
    -- * Edges
  , Edge (..)
  , edges
  , stretches
  ) where

import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl', mapAccumL)
import Visibility.Exact.Predicate
import Visibility.Incidence
import Visibility.Scene
import Visibility.Scene.Cone
import Visibility.Sweep.Sights
import Visibility.Sweep.Vertex

-- | Does the line through two corners leave the polygon at the first of them on one side, so that both rays are free
-- there?
--
-- /Degenerate cases/ running along a side is free: a flat corner is tangent along its sides, a reflex corner never, an
-- end of a thin wall always.
isTangent :: Scene -> CornerId -> CornerId -> Bool
isTangent scene c towards
  | onNext == Collinear && onPrevious == Collinear = True
  | onNext /= Collinear && onPrevious == opposite onNext = False
  | otherwise = turned scene before c after /= RightTurn
  where
    after = nextCorner scene c
    before = previousCorner scene c
    onNext = turned scene c towards after
    onPrevious = turned scene c towards before

-- | The elementary pairs of a vertex whose line is tangent at both corners, without those that are sides.
freeBitangents :: Scene -> Vertex -> [(CornerId, CornerId)]
freeBitangents scene vertex =
  [ (p, q)
  | (p, q) <- vertexPairs scene vertex
  , q `notElem` besides scene p
  , isTangent scene p q
  , isTangent scene q p
  ]

-- | What the file calls an elementary pair: each stated corner in the place of the first with each in the place of the
-- second, smaller name first. Of the two pairs along the two faces of one piece of a thin wall, one has all the names,
-- the other none.
--
-- /Cost/ O(1) for each, besides that of 'statedPairCount'.
statedPairs :: Scene -> (CornerId, CornerId) -> [(CornerName, CornerName)]
statedPairs scene (p, q)
  | not (hasSharedPlaces scene) = [inOrder (cornerName scene p) (cornerName scene q)]
  | isSecondFace scene p q = []
  | otherwise = [inOrder a b | a <- namesHere scene p, b <- namesHere scene q]
  where
    inOrder a b = if a <= b then (a, b) else (b, a)

-- | How many they are.
--
-- /Cost/ O(1) where nothing touches. For a side it is O(k), for k corners in that place of its ends where there are
-- fewer of them: that is O(n) for all sides together, since sides that do not cross make a planar graph.
--
-- /Source/ Chiba and Nishizeki, Arboricity and subgraph listing algorithms, 1985, for that sum.
statedPairCount :: Scene -> (CornerId, CornerId) -> Int
statedPairCount scene (p, q)
  | not (hasSharedPlaces scene) = 1
  | isSecondFace scene p q = 0
  | otherwise = namesHereTotal scene p * namesHereTotal scene q

-- | Is this pair a side, and the second one of the two faces of a piece of a wall?
isSecondFace :: Scene -> CornerId -> CornerId -> Bool
isSecondFace scene p q = q `elem` besides scene p && or (zipWith (||) fromFirst fromSecond)
  where
    -- Either list tells of all sides between the two places, so the end of the shorter one is enough.
    fromFirst = [or [(p', q') < (p, q) | q' <- besides scene p', samePlace scene q q'] | p' <- around p]
    fromSecond = [or [(p', q') < (p, q) | p' <- besides scene q', samePlace scene p p'] | q' <- around q]
    around c = before c <> [c] <> after c
    before (CornerId c) = takeWhile (samePlace scene (CornerId c)) (map CornerId [c - 1, c - 2 .. 0])
    after (CornerId c) = takeWhile (samePlace scene (CornerId c)) (map CornerId [c + 1 .. cornerCount scene - 1])

-- | A vertex with the views of its corners, in their order along the line, at the directions just before and just after
-- it.
data Event = Event
  { eventVertex :: !Vertex
  , viewsBefore :: ![View Object]
  , viewsAfter :: ![View Object]
  }
  deriving (Eq, Show)

-- | The events of a stream of vertices, one each, in its order.
--
-- /Requires/ the vertices of the scene in an order in which each corner's vertices come by increasing direction.
-- /Cost/ O(1) per elementary pair, O(n) memory: tables are changed in place, as the stream is consumed.
events :: Scene -> [Vertex] -> [Event]
events scene = concat . alongStream scene (\sights _ found -> (,) () <$> mapM (event sights) found) () . pieces
  where
    pieces found = case splitAt 64 found of
      ([], _) -> []
      (now, later) -> now : pieces later
    event sights vertex = passing scene sights vertex $ \passed ->
      pure $! Event vertex [view before | Passage _ before _ <- passed] [view after | Passage _ _ after <- passed]
    view = viewOf scene

-- | An open interval of directions between consecutive vertices of a corner, during which it has one view; cut where
-- the half turn begins.
--
-- /Degenerate cases/ the next interval has another view, except where a thin wall lies in the line of the vertex
-- between them: seen edge-on it may hide nothing. Such a vertex ends the edge all the same.
data Edge = Edge
  { edgeCorner :: !CornerId
  , edgeFrom :: !Direction
  -- ^ Direction of its first vertex, or (0, −1) where the half turn begins, at −90°.
  , edgeTo :: !Direction
  -- ^ Direction of its last vertex, or (0, 1) where the half turn ends, at 90°.
  , edgeView :: !(View Object)
  -- ^ Not 'Buried', unless it comes from 'stretches'.
  }
  deriving (Eq, Show)

-- | The edges of a stream of events, each when its last vertex is reached, those that reach 90° last.
--
-- /Cost/ O(log n) per edge, O(n) memory.
edges :: Scene -> [Event] -> [Edge]
edges scene = filter (not . isBuried . edgeView) . stretches scene

-- | The edges, and likewise the intervals in which a corner is buried: all curves that bound a face.
--
-- /Law/ those of one corner follow each other and cover the half turn.
stretches :: Scene -> [Event] -> [Edge]
stretches scene stream = concat pieces <> foldr lastEdge [] (IntMap.toList open)
  where
    (open, pieces) = mapAccumL close IntMap.empty stream
    downwards = Direction 0 (-1)
    close begun (Event vertex before after) =
      ( foldl' (\m (CornerId c, view) -> IntMap.insert c (to, view) m) begun (zip line after)
      , [ Edge c (maybe downwards fst (IntMap.lookup k begun)) to view
        | (c@(CornerId k), view) <- zip line before
        ]
      )
      where
        line = vertexCorners vertex
        to = vertexDirection scene vertex
    lastEdge (c, (from, view)) rest
      | compareDirections from upwards == EQ = rest
      | otherwise = Edge (CornerId c) from upwards view : rest
