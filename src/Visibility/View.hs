-- | What each corner sees just before and just after each of its vertices, in O(1) per elementary pair.
--
-- The stream of vertices becomes a stream of events, and that becomes edges. At a direction between two of its
-- vertices, the line through a corner has a 'View': tangent, ending or buried (mathematics: lines, curves, the dual).
--
-- /Source/ Rivière, Topologically sweeping the visibility complex of polygonal scenes; landing sides derived for this
-- project.
module Visibility.View
  ( -- * Views
    View (..)
  , Flank (..)
  , End (..)
  , Incidence (..)
  , incidences
  , isBuried
  , viewOf
    -- * Tangency at a vertex
  , isTangent
  , freeBitangents
    -- * Pairs as the file calls them
  , statedPairs
    -- * The stream of events
  , Event (..)
  , events
    -- * Edges
  , Edge (..)
  , edges
  , stretches
  ) where

import Control.Monad.ST (ST)
import qualified Control.Monad.ST.Lazy as Lazy
import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl', mapAccumL)
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Sweep.Vertex
import Visibility.Sweep.Vertical (objectOf)
import Visibility.Sweep.Sights

-- | A side of a directed line: above is to the left of it.
data Flank = Above | Below
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | An end of a maximal free segment: the front is where the right-going line leads.
data End = Back | Front
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | The line through a corner at a direction between two of the corner's vertices.
data View
  = -- | The polygon lies strictly on this flank of the line; what is seen backward and forward. Three faces meet.
    Tangent !Flank !Object !Object
  | -- | The maximal free segment has this end at the corner; what is seen at its other end. Two faces meet.
    Ending !End !Object
  | -- | Neither ray is free: a reflex corner of the solid, whose free cone lies on this flank. The segment through it
    -- is a single point, so it is no edge of the complex; yet it bounds one face, the segments that cut the corner off.
    Buried !Flank
  deriving (Eq, Ord, Show)

-- | Is the line through the corner no edge of the complex?
isBuried :: View -> Bool
isBuried (Buried _) = True
isBuried _ = False

-- | The view of a corner from the numbers that tables hold: of the objects at its back and front, and 1 where the
-- following corner lies above its line.
viewOf :: Scene -> Int -> Int -> Int -> View
viewOf scene back front above = case (objectOf scene back, objectOf scene front) of
  (Just b, Just f) -> Tangent flank b f
  (Just b, Nothing) -> Ending Front b
  (Nothing, Just f) -> Ending Back f
  (Nothing, Nothing) -> Buried flank
  where
    flank = if above == 1 then Above else Below
{-# INLINE viewOf #-}

-- | A face at the curve of a corner: the flank on which the face lies, and its label, the sides at the back and at the
-- front.
data Incidence = Incidence !Flank !Object !Object
  deriving (Eq, Ord, Show)

-- | The faces that meet at the curve of a corner under a view: 3 where it is tangent, 2 where it is ending, 1 where it
-- is buried.
--
-- /Degenerate cases/ none: at a direction between two vertices no side of the corner lies on the line, and a flat
-- corner is never tangent.
--
-- /Law/ at a vertex, above and below incidences of one label alternate along the corners, before and after it.
incidences :: Scene -> CornerId -> View -> [Incidence]
incidences scene c view = case view of
  Tangent Above back front -> [Incidence Below back front, Incidence Above back arriving, Incidence Above leaving front]
  Tangent Below back front -> [Incidence Above back front, Incidence Below back leaving, Incidence Below arriving front]
  Ending Front back -> [Incidence Above back arriving, Incidence Below back leaving]
  Ending Back front -> [Incidence Above leaving front, Incidence Below arriving front]
  Buried Above -> [Incidence Above leaving arriving]
  Buried Below -> [Incidence Below arriving leaving]
  where
    CornerId start = c
    CornerId before = previousCorner scene c
    leaving = Side (SideId start)
    arriving = Side (SideId before)

-- | Does the line through two corners leave the polygon at the first of them on one side, so that both rays are free
-- there?
--
-- /Degenerate cases/ running along a side is free: a flat corner is tangent along its sides, a reflex corner never, an
-- end of a thin wall always.
isTangent :: Scene -> CornerId -> CornerId -> Bool
isTangent scene c towards
  | onNext == Collinear && onPrevious == Collinear = True
  | onNext /= Collinear && onPrevious == opposite onNext = False
  | otherwise = turn points before i after /= RightTurn
  where
    points = scenePoints scene
    CornerId i = c
    CornerId j = towards
    CornerId after = nextCorner scene c
    CornerId before = previousCorner scene c
    onNext = turn points i j after
    onPrevious = turn points i j before

-- | The elementary pairs of a vertex whose line is tangent at both corners, without those that are sides.
freeBitangents :: Scene -> Vertex -> [(CornerId, CornerId)]
freeBitangents scene vertex =
  [ (p, q)
  | (p, q) <- vertexPairs scene vertex
  , nextCorner scene p /= q
  , previousCorner scene p /= q
  , isTangent scene p q
  , isTangent scene q p
  ]

-- | What the file calls an elementary pair: each stated corner in the place of the first with each in the place of the
-- second, smaller name first. Of the two pairs along the two faces of one piece of a thin wall, one has all the names,
-- the other none.
--
-- /Cost/ O(1) where nothing touches; of a side, O(k) for k corners in the places of its ends.
statedPairs :: Scene -> (CornerId, CornerId) -> [(CornerName, CornerName)]
statedPairs scene (p, q)
  | not (hasSharedPlaces scene) = [inOrder (cornerName scene p) (cornerName scene q)]
  | isSecondFace = []
  | otherwise = [inOrder a b | a <- namesHere scene p, b <- namesHere scene q]
  where
    isSecondFace = joins p q && or [(p', q') < (p, q) | p' <- around p, q' <- besides p', samePlace scene q q']
    inOrder a b = if a <= b then (a, b) else (b, a)
    joins a b = b `elem` besides a
    besides c = [nextCorner scene c, previousCorner scene c]
    around c = before c <> [c] <> after c
    before (CornerId c) = takeWhile (samePlace scene (CornerId c)) (map CornerId [c - 1, c - 2 .. 0])
    after (CornerId c) = takeWhile (samePlace scene (CornerId c)) (map CornerId [c + 1 .. cornerCount scene - 1])

-- | A vertex with the views of its corners, in their order along the line, at the directions just before and just after
-- it.
data Event = Event
  { eventVertex :: !Vertex
  , viewsBefore :: ![View]
  , viewsAfter :: ![View]
  }
  deriving (Eq, Show)

-- | The events of a stream of vertices, one each, in its order.
--
-- /Requires/ the vertices of the scene in an order in which each corner's vertices come by increasing direction.
-- /Cost/ O(1) per elementary pair, O(n) memory: tables are changed in place, as the stream is consumed.
events :: Scene -> [Vertex] -> [Event]
events scene stream = Lazy.runST $ do
  sights <- Lazy.strictToLazyST (traverse U.thaw (startSights scene))
  let go [] = pure []
      go vertices = do
        let (piece, rest) = splitAt 64 vertices
        done <- Lazy.strictToLazyST (mapM (pass scene sights) piece)
        (done <>) <$> go rest
  go stream

-- | Turns the line of one vertex through it.
pass :: Scene -> Changing s -> Vertex -> ST s Event
pass scene sights vertex = do
  before <- mapM look line
  turnThrough scene sights vertex
  after <- mapM look line
  pure (Event vertex before after)
  where
    line = vertexCorners vertex
    look (CornerId p) = do
      front <- M.read (frontOf sights) p
      back <- M.read (backOf sights) p
      above <- M.read (nextAbove sights) p
      pure $! viewOf scene (fromIntegral back) (fromIntegral front) (fromIntegral above)

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
  , edgeView :: !View
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
