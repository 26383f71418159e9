{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE GeneralizedNewtypeDeriving #-}

-- | The visibility complex in tables: vertices, stretches and faces with their incidences, by id.
--
-- A stretch is the part of a corner's curve between two vertices in a row. It is an edge, except where the corner is
-- buried.
--
-- The constructor is open for those who make complexes ("Visibility.Complex.Build"), check them
-- ("Visibility.Complex.Law") or break them on purpose, in tests. Others see "Visibility.Complex".
module Visibility.Complex.Type
  ( -- * Tables
    Complex (..)
  , complexScene
  , vertexTotal
  , stretchTotal
  , faceTotal
    -- * Identifiers
  , VertexId (..)
  , EdgeId (..)
  , FaceId (..)
    -- * Vertices
  , vertexIds
  , vertexAt
  , vertexEdgesAfter
  , vertexRow
  , vertexLine
  , Kind (..)
  , vertexKinds
  , vertexBack
  , vertexFront
  , vertexEdges
  , vertexFaces
    -- * Stretches and edges
  , edgeIds
  , stretchIds
  , isEdge
  , edgeCorner
  , edgeFirst
  , edgeLast
  , edgeBefore
  , edgeAfter
  , edgeView
  , edgeFrom
  , edgeTo
  , wrapsAround
  , Quarter (..)
  , quartersOf
  , faceAt
  , edgeFacesOn
  , lastEdgeOf
    -- * Faces
  , faceIds
  , faceBack
  , faceFront
  , faceFirst
  , faceLast
  , outerFace
  , Chain (..)
  , upperChain
  , lowerChain
  ) where

import Data.List (nub)
import Data.Maybe (listToMaybe, mapMaybe)
import Visibility.Complex.Table
import Visibility.Exact.Predicate
import Visibility.Incidence
import Visibility.Law (broken)
import Visibility.Scene
import Visibility.Scene.Cone
import Visibility.Sweep.Vertex
import Visibility.Sweep.Vertical (objectAt, objectOf, solid)
import Visibility.View (isTangent)

-- | A vertex, from 0.
newtype VertexId = VertexId Int
  deriving stock (Eq, Ord, Show)
  deriving newtype (Code)

-- | A stretch of a corner's curve between two consecutive vertices of the corner, from 0: an edge, or an interval in
-- which the corner is buried. There is one for each corner of each vertex, the one that begins there; those of one
-- vertex follow each other in the order of the corners along its line.
newtype EdgeId = EdgeId Int
  deriving stock (Eq, Ord, Show)
  deriving newtype (Code)

-- | A face, from 0.
newtype FaceId = FaceId Int
  deriving stock (Eq, Ord, Show)
  deriving newtype (Code)

-- | The tables of the complex of a scene. Objects are numbered as in the tables of the sweep ('objectOf').
--
-- /Cost/ 44 bytes per corner of a vertex, 32 per face, 4 per vertex and per corner; the chains take 4 bytes per
-- incidence of a stretch with a face. Under the sky, face 0 is that of the lines that miss everything. Shown as
-- @\<complex: 6 vertices, 12 edges, 8 faces\>@.
data Complex = Complex
  { sweptScene :: !Scene
  , vertexStarts :: !(Table VertexId EdgeId)
  -- ^ The stretches that begin at vertex v are those from entry v on, below entry v + 1.
  , stretchCorners :: !(Table EdgeId CornerId)
  , stretchVertices :: !(Table EdgeId VertexId)
  -- ^ The vertex at which a stretch begins.
  , stretchesBefore :: !(Table EdgeId EdgeId)
  -- ^ The stretch of the same corner that ends where this one begins.
  , stretchesAfter :: !(Table EdgeId EdgeId)
  -- ^ The stretch of the same corner that begins where this one ends. Where the half turn cuts a stretch, it is
  -- glued: after the last stretch of a corner comes its first one, read backwards.
  , stretchBacks :: !(Table EdgeId (Maybe Object))
  -- ^ The object seen backward, where the stretch begins.
  , stretchFronts :: !(Table EdgeId (Maybe Object))
  , stretchFlanks :: !(Table EdgeId Flank)
  -- ^ Where the following corner of the polygon lies, where the stretch begins: 1 stands for above.
  , stretchFaces :: !(Table (EdgeId, Quarter) (Maybe FaceId))
  -- ^ Where the stretch begins. A face on both quarters of a flank is entered twice.
  , lastStretches :: !(Table CornerId EdgeId)
  -- ^ The stretch that goes on over the end of the half turn.
  , faceFirsts :: !(Table FaceId (Maybe VertexId))
  , faceLasts :: !(Table FaceId (Maybe VertexId))
  , faceBacks :: !(Table FaceId Object)
  , faceFronts :: !(Table FaceId Object)
  , chainStarts :: !(Table Int Int)
  -- ^ Where parts of chains begin in 'chains', from entry 4f on those of face f: of its upper chain, then of the lower
  -- one, each before and after the end of the half turn. The last entry is the length of 'chains'.
  , chains :: !(Table Int EdgeId)
  }

instance Show Complex where
  show complex =
    "<complex: " <> unwords [count vertexIds "vertices,", count edgeIds "edges,", count faceIds "faces>"]
    where
      count :: (Complex -> [a]) -> String -> String
      count ids what = show (length (ids complex)) <> " " <> what

-- | The scene that a complex is that of.
complexScene :: Complex -> Scene
complexScene = sweptScene

-- How many there are.
vertexTotal, stretchTotal, faceTotal :: Complex -> Int
vertexTotal complex = tableLength (vertexStarts complex) - 1
stretchTotal = tableLength . stretchCorners
faceTotal = tableLength . faceFirsts

-- | All vertices, in the order of the stream that the complex was built from.
vertexIds :: Complex -> [VertexId]
vertexIds complex = map VertexId [0 .. vertexTotal complex - 1]

-- | The corners of a vertex. /Cost/ O(k) for k corners.
vertexAt :: Complex -> VertexId -> Vertex
vertexAt complex v = case map (edgeCorner complex) (vertexEdgesAfter complex v) of
  a : b : rest -> Vertex a b rest
  found -> broken "a vertex has two corners or more" (show found)

-- | The stretches that begin at a vertex, in the order of its corners.
vertexEdgesAfter :: Complex -> VertexId -> [EdgeId]
vertexEdgesAfter complex v = map EdgeId [first .. end - 1]
  where
    (EdgeId first, EdgeId end) = vertexRow complex v

-- | The first stretch that begins at a vertex, and the one after the last.
vertexRow :: Complex -> VertexId -> (EdgeId, EdgeId)
vertexRow complex v@(VertexId i) = (at (vertexStarts complex) v, at (vertexStarts complex) (VertexId (i + 1)))
{-# INLINE vertexRow #-}

-- | What the line of a vertex does at one of its corners.
data Kind
  = -- | The polygon lies strictly on this flank.
    TangentAt !Flank
  | -- | The maximal free segment has this end at the corner.
    EndingAt !End
  | -- | A side of the corner lies in the line.
    AlongSide
  deriving (Eq, Ord, Show)

-- | By corner, in their order along the line.
--
-- /Degenerate cases/ at a side the segment passes on where the corner is convex, flat, or an end of a thin wall, and
-- ends where it is reflex; 'vertexBack' and 'vertexFront' tell.
vertexKinds :: Complex -> VertexId -> [Kind]
vertexKinds complex v = zipWith kind line (Back : map (const Front) (drop 1 line))
  where
    scene = complexScene complex
    vertex = vertexAt complex v
    first = vertexFirst vertex
    line = vertexCorners vertex
    -- The line goes on past a corner unless it enters the solid there, which it can do at its ends only.
    kind c end
      | onNext == Collinear || onPrevious == Collinear = AlongSide
      | isTangent scene c other = TangentAt (if onNext == LeftTurn then Above else Below)
      | otherwise = EndingAt end
      where
        other = case end of
          Back -> vertexLast vertex
          Front -> first
        onNext = sideOf (nextCorner scene c)
        onPrevious = sideOf (previousCorner scene c)
    sideOf = turned scene first (vertexLast vertex)

-- | What the maximal free segment of a vertex ends at backward, 'Nothing' where it ends at the first corner.
vertexBack :: Complex -> VertexId -> Maybe Object
vertexBack complex v = beyondEnd complex stretchBacks (vertexEdgesAfter complex v)

-- | What it ends at forward, 'Nothing' where it ends at the last corner.
vertexFront :: Complex -> VertexId -> Maybe Object
vertexFront complex v = beyondEnd complex stretchFronts (reverse (vertexEdgesAfter complex v))

-- | What is seen from the first of some stretches, or from the other one in its place, where the line runs along both
-- faces of a wall: it goes on along one of them at most.
beyondEnd :: Complex -> (Complex -> Table EdgeId (Maybe Object)) -> [EdgeId] -> Maybe Object
beyondEnd complex table found = listToMaybe (mapMaybe object here)
  where
    here = [e | first <- take 1 found, e <- takeWhile (samePlace scene (cornerOf first) . cornerOf) found]
    cornerOf = edgeCorner complex
    object = objectOf scene . numberAt (table complex)
    scene = complexScene complex

-- | The incident edges in cyclic order, counter-clockwise in the dual (angle to the right, offset upwards), beginning
-- with the lowest of those that begin here. Buried stretches are no edges.
vertexEdges :: Complex -> VertexId -> [EdgeId]
vertexEdges complex v = filter (isEdge complex) (after <> map (edgeBefore complex) after)
  where
    after = reverse (vertexEdgesAfter complex v)

-- | The incident faces, each once, in no particular order.
vertexFaces :: Complex -> VertexId -> [FaceId]
vertexFaces complex v =
  nub (concatMap around (reverse after) <> concatMap (around . edgeBefore complex) after)
  where
    after = vertexEdgesAfter complex v
    around e = mapMaybe (faceAt complex e) [BelowFront, BelowBack, AboveBack, AboveFront]

-- | All edges: tangent and ending stretches.
edgeIds :: Complex -> [EdgeId]
edgeIds complex = filter (isEdge complex) (stretchIds complex)

-- | All stretches, the buried ones too.
stretchIds :: Complex -> [EdgeId]
stretchIds complex = map EdgeId [0 .. stretchTotal complex - 1]

-- | Is the stretch an edge, that is, not buried?
isEdge :: Complex -> EdgeId -> Bool
isEdge complex e = numberAt (stretchBacks complex) e /= solid || numberAt (stretchFronts complex) e /= solid

edgeCorner :: Complex -> EdgeId -> CornerId
edgeCorner = at . stretchCorners
{-# INLINE edgeCorner #-}

-- | The vertex where a stretch begins.
edgeFirst :: Complex -> EdgeId -> VertexId
edgeFirst = at . stretchVertices
{-# INLINE edgeFirst #-}

-- | The vertex where it ends; the same one for an end of a thin wall that sees no other corner.
edgeLast :: Complex -> EdgeId -> VertexId
edgeLast complex = edgeFirst complex . edgeAfter complex
{-# INLINE edgeLast #-}

-- | The stretch of the same corner that ends where this one begins.
edgeBefore :: Complex -> EdgeId -> EdgeId
edgeBefore = at . stretchesBefore
{-# INLINE edgeBefore #-}

-- | The stretch of the same corner that begins where this one ends.
edgeAfter :: Complex -> EdgeId -> EdgeId
edgeAfter = at . stretchesAfter
{-# INLINE edgeAfter #-}

-- | The view during a stretch, read as it is where the stretch begins.
edgeView :: Complex -> EdgeId -> View Object
edgeView complex e =
  viewOf (complexScene complex) (Outlook (number stretchBacks) (number stretchFronts) (number stretchFlanks))
  where
    number table = numberAt (table complex) e

-- | The direction in which a stretch begins. Not reduced.
edgeFrom :: Complex -> EdgeId -> Direction
edgeFrom complex e = vertexLine complex (edgeFirst complex e)

-- | The direction in which it ends, right-going, also where it goes on over the end of the half turn. Not reduced.
edgeTo :: Complex -> EdgeId -> Direction
edgeTo complex e = vertexLine complex (edgeLast complex e)

-- | The direction of a vertex. Not reduced.
vertexLine :: Complex -> VertexId -> Direction
vertexLine complex v = direction (scenePoints (complexScene complex)) a b
  where
    (first, EdgeId end) = vertexRow complex v
    (CornerId a, CornerId b) = (edgeCorner complex first, edgeCorner complex (EdgeId (end - 1)))

-- | Does the stretch go on over the end of the half turn? Its last part is then read backwards.
wrapsAround :: Complex -> EdgeId -> Bool
wrapsAround complex e = lastEdgeOf complex (edgeCorner complex e) == e

-- | The stretch of a corner that goes on over the end of the half turn.
lastEdgeOf :: Complex -> CornerId -> EdgeId
lastEdgeOf = at . lastStretches

-- | Where the segments of a face lie at a corner whose curve bounds it: above or below the line, and on which part of
-- it. Where nothing cuts the line on a flank, the face there is on both parts.
data Quarter = AboveBack | AboveFront | BelowBack | BelowFront
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | Four for each stretch.
instance Code (EdgeId, Quarter) where
  code (EdgeId e, quarter) = 4 * e + fromEnum quarter
  decoded i = (EdgeId (i `quot` 4), toEnum (i `rem` 4))
  {-# INLINE code #-}

-- | The face on a quarter of a stretch, as it is where the stretch begins. 'Nothing' in the solid.
faceAt :: Complex -> EdgeId -> Quarter -> Maybe FaceId
faceAt complex e quarter = at (stretchFaces complex) (e, quarter)
{-# INLINE faceAt #-}

-- | The faces on a flank of a stretch, from back to front: 2 and 1 where it is tangent, 1 and 1 where it is ending.
edgeFacesOn :: Complex -> EdgeId -> Flank -> [FaceId]
edgeFacesOn complex e = nub . mapMaybe (faceAt complex e) . quartersOf

-- | The two quarters on a flank, from back to front.
quartersOf :: Flank -> [Quarter]
quartersOf Above = [AboveBack, AboveFront]
quartersOf Below = [BelowBack, BelowFront]

-- | All faces.
faceIds :: Complex -> [FaceId]
faceIds complex = map FaceId [0 .. faceTotal complex - 1]

-- | The object at the back of a face's segments, as it is where the face begins.
faceBack :: Complex -> FaceId -> Object
faceBack complex = objectAt (complexScene complex) . numberAt (faceBacks complex)

-- | The object at their front.
faceFront :: Complex -> FaceId -> Object
faceFront complex = objectAt (complexScene complex) . numberAt (faceFronts complex)

-- | The vertex where a face begins; 'Nothing' for the lines under the sky that miss everything.
faceFirst :: Complex -> FaceId -> Maybe VertexId
faceFirst = at . faceFirsts

-- | The vertex where a face ends; it may be the same, half a turn later.
faceLast :: Complex -> FaceId -> Maybe VertexId
faceLast = at . faceLasts

-- | Under the sky, the face of the lines that miss everything.
outerFace :: Complex -> Maybe FaceId
outerFace complex = case surroundings (complexScene complex) of
  OpenSky -> Just (FaceId 0)
  Room -> Nothing

-- | A chain of a face in the order of direction. The second part lies after the end of the half turn: there, stretches
-- are read backwards, above being below. A stretch that goes on over the end is the last of the first part.
data Chain = Chain ![EdgeId] ![EdgeId]
  deriving (Eq, Show)

-- | The stretches that bound a face from above, from its first vertex to its last one.
upperChain :: Complex -> FaceId -> Chain
upperChain complex (FaceId f) = chainFrom complex (4 * f)

-- | The stretches that bound a face from below, from its first vertex to its last one. The chain of the lines that miss
-- everything is closed: it goes around all corners in a full turn.
lowerChain :: Complex -> FaceId -> Chain
lowerChain complex (FaceId f) = chainFrom complex (4 * f + 2)

-- By the number of its first part in 'chainStarts'.
chainFrom :: Complex -> Int -> Chain
chainFrom complex i = Chain (part i) (part (i + 1))
  where
    part k = map (at (chains complex)) [at (chainStarts complex) k .. at (chainStarts complex) (k + 1) - 1]
