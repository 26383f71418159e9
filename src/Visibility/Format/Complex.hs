{-# LANGUAGE OverloadedStrings #-}

-- | The whole complex as JSON.
module Visibility.Format.Complex
  ( complexDocument
  ) where

import Data.Aeson.Encoding (Encoding, int, list, null_, pair, pairs, string)
import qualified Data.Aeson.Encoding as Aeson
import Data.ByteString.Builder (Builder, char7)
import Visibility.Complex.Canonical
import Visibility.Complex.Type
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.Predicate (Direction (..), primitive)
import Visibility.Exact.Rounding (rationalText)
import Visibility.Law (broken)
import Visibility.Scene
import Visibility.Sweep.Vertex
import Visibility.View (End (..), Flank (..), View (..))

-- | The document, in canonical order: it depends on the scene only, to the last byte.
--
-- /Shape/ @corners@, by name; @vertices@; @edges@; @faces@; @buried@, the stretches in which a corner is buried: they
-- are no edges, but each bounds a face, where the chain of its edges has a gap. Where a segment ends at a corner
-- instead of a side or the sky, @back@ or @front@ is that corner. Chains are listed in order of direction; what lies
-- after the end of the half turn comes last. The lines that miss everything are the last face; they have no first and
-- no last vertex, @null@, and their lower chain is closed.
--
-- /Cost/ O(m log m).
complexDocument :: Complex -> Builder
complexDocument complex = Aeson.fromEncoding document <> char7 '\n'
  where
    scene = complexScene complex
    numbering = canonicalNumbering complex
    document =
      pairs $
        pair "format" (string "viscomplex/1")
          <> pair "corners" (list corner (statedCorners scene))
          <> pair "vertices" (list (vertexEntry complex) (orderedVertices numbering))
          <> pair "edges" (list (edgeEntry complex numbering) (orderedEdges numbering))
          <> pair "faces" (list (faceEntry complex numbering) (orderedFaces numbering))
          <> pair "buried" (list (buriedEntry complex numbering) (orderedBuried numbering))
    corner (name, Point x y) =
      pairs (pair "id" (string (cornerText name)) <> pair "at" (list (string . rationalText) [x, y]))

nameOf :: Scene -> CornerId -> String
nameOf scene = cornerText . cornerName scene

vertexEntry :: Complex -> VertexId -> Encoding
vertexEntry complex v =
  pairs $
    pair "corners" (list (string . nameOf scene) line)
      <> pair "kinds" (list (string . kindText) (vertexKinds complex v))
      <> pair "direction" (list (string . show) [dx, dy])
      <> pair "back" (string (end (vertexBack complex v) (vertexFirst vertex)))
      <> pair "front" (string (end (vertexFront complex v) (vertexLast vertex)))
  where
    scene = complexScene complex
    vertex = vertexAt complex v
    line = vertexCorners vertex
    Direction dx dy = primitive (vertexDirection scene vertex)
    end object c = maybe (nameOf scene c) (objectText scene) object

-- | @tangent@, @ending@ or @side@.
kindText :: Kind -> String
kindText kind = case kind of
  TangentAt _ -> "tangent"
  EndingAt _ -> "ending"
  AlongSide -> "side"

edgeEntry :: Complex -> Numbering -> EdgeId -> Encoding
edgeEntry complex numbering e =
  pairs $
    ends complex numbering e
      <> pair "back" (string back)
      <> pair "front" (string front)
      <> pair "kind" (string kind)
      <> flanks complex numbering e
  where
    scene = complexScene complex
    here = nameOf scene (edgeCorner complex e)
    (back, front, kind) = case edgeView complex e of
      Tangent _ b f -> (objectText scene b, objectText scene f, "tangent")
      Ending Front b -> (objectText scene b, here, "ending")
      Ending Back f -> (here, objectText scene f, "ending")
      Buried _ -> broken "an edge is not buried" (show e)

buriedEntry :: Complex -> Numbering -> EdgeId -> Encoding
buriedEntry complex numbering e = pairs (ends complex numbering e <> flanks complex numbering e)

ends :: Complex -> Numbering -> EdgeId -> Aeson.Series
ends complex numbering e =
  pair "corner" (string (nameOf (complexScene complex) (edgeCorner complex e)))
    <> pair "from" (int (vertexNumber numbering (edgeFirst complex e)))
    <> pair "to" (int (vertexNumber numbering (edgeLast complex e)))

flanks :: Complex -> Numbering -> EdgeId -> Aeson.Series
flanks complex numbering e = pair "above" (faces Above) <> pair "below" (faces Below)
  where
    faces flank = list (int . faceNumber numbering) (edgeFacesOn complex e flank)

faceEntry :: Complex -> Numbering -> FaceId -> Encoding
faceEntry complex numbering f =
  pairs $
    pair "back" (string (objectText scene (faceBack complex f)))
      <> pair "front" (string (objectText scene (faceFront complex f)))
      <> pair "first" (vertex (faceFirst complex f))
      <> pair "last" (vertex (faceLast complex f))
      <> pair "upper" (chain (upperChain complex f))
      <> pair "lower" (chain (lowerChain complex f))
  where
    scene = complexScene complex
    vertex = maybe null_ (int . vertexNumber numbering)
    chain (Chain before after) = list (int . edgeNumber numbering) (filter (isEdge complex) (before <> after))
