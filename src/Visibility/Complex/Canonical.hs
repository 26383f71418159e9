-- | The canonical numbering of a complex: it depends on the scene and its names only, not on the sweep that the complex
-- was made along.
module Visibility.Complex.Canonical
  ( Numbering (..)
  , canonicalNumbering
  ) where

import Data.Function (on)
import Data.List (sortOn)
import Data.Ord (comparing)
import qualified Data.Vector.Algorithms.Intro as Intro
import qualified Data.Vector.Unboxed as U
import Visibility.Complex.Type
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Sorting
import Visibility.Sweep.Vertex

-- | What comes in which order, and the number of each, from 0.
data Numbering = Numbering
  { orderedVertices :: ![VertexId]
  -- ^ By direction, then by offset, then along the line.
  , orderedEdges :: ![EdgeId]
  -- ^ Tangent and ending edges by the number of their first vertex, then by corner.
  , orderedBuried :: ![EdgeId]
  -- ^ Buried stretches likewise.
  , orderedFaces :: ![FaceId]
  -- ^ By the number of their first vertex, then by back, then by front, then from above downwards. The lines that miss
  -- everything come last.
  , vertexNumber :: VertexId -> Int
  , edgeNumber :: EdgeId -> Int
  -- ^ Of an edge among the edges, of a buried stretch among the buried ones: each kind is numbered from 0.
  , faceNumber :: FaceId -> Int
  }

-- | /Degenerate cases/ two faces may have the same first vertex, back and front: thin walls on one line, seen from both
-- ends. The upper one comes first.
--
-- /Cost/ O(m log m).
--
-- /Laws/ the names of everything in this order are the same for all streams of vertices of a scene; renaming the
-- polygons changes it only where names break ties.
canonicalNumbering :: Complex -> Numbering
canonicalNumbering complex =
  Numbering
    { orderedVertices = vertexOrder
    , orderedEdges = edgeOrder
    , orderedBuried = buriedOrder
    , orderedFaces = faceOrder
    , vertexNumber = \(VertexId v) -> vertexRanks U.! v
    , edgeNumber = \(EdgeId e) -> edgeRanks U.! e
    , faceNumber = \(FaceId f) -> faceRanks U.! f
    }
  where
    scene = complexScene complex
    vertexOrder =
      map (VertexId . snd) . U.toList . U.modify (Intro.sortBy (comparing fst <> exactly)) . U.fromList $
        [(slope v, k) | v@(VertexId k) <- vertexIds complex]
    exactly = compareVertices scene `on` (vertexAt complex . VertexId . snd)
    -- Quotients of numbers that Doubles hold keep their order when they are rounded; equal ones are told apart exactly.
    slope v = case pointPlaces (scenePoints scene) of
      SmallPlaces _ -> let Direction x y = edgeFrom complex (fst (vertexRow complex v)) in fromInteger y / fromInteger x
      LargePlaces _ -> 0 :: Double
    vertexRanks = ranks [v | VertexId v <- vertexOrder]
    rank (VertexId v) = vertexRanks U.! v
    fromVertices wanted =
      [ e
      | v <- vertexOrder
      , e <- sortOn (cornerName scene . edgeCorner complex) (filter wanted (vertexEdgesAfter complex v))
      ]
    edgeOrder = fromVertices (isEdge complex)
    buriedOrder = fromVertices (not . isEdge complex)
    edgeRanks = U.replicate (stretchTotal complex) 0 U.// (numbered edgeOrder <> numbered buriedOrder)
    numbered es = zip [e | EdgeId e <- es] [0 ..]
    -- At one vertex, faces are numbered from above downwards.
    faceOrder = concatMap (sortOn labels . map FaceId . bucketOf begun) [0 .. vertexTotal complex]
    begun = bucketsBy (vertexTotal complex + 1) (U.fromList (map (fromIntegral . place) (faceIds complex)))
    place f = maybe (vertexTotal complex) rank (faceFirst complex f)
    labels f = (seenAs scene (faceBack complex f), seenAs scene (faceFront complex f))
    faceRanks = ranks [f | FaceId f <- faceOrder]
    ranks order = U.replicate (length order) 0 U.// zip order [0 ..]
