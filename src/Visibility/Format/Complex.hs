{-# LANGUAGE OverloadedStrings #-}

-- | The whole complex as JSON, of sides or of polygons.
module Visibility.Format.Complex
  ( complexDocument
  , polygonDocument
  ) where

import qualified Data.Vector as V
import Visibility.Complex.Canonical
import Visibility.Complex.Polygons
import Visibility.Complex.Type
import Visibility.Exact.Predicate (Direction (..), primitive)
import Visibility.Format.Json.Document
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
complexDocument complex =
  complexOf complex $
    pair "vertices" (list vertexEntry (orderedVertices numbering))
      <> pair "edges" (list edgeEntry (orderedEdges numbering))
      <> pair "faces" (list faceEntry (orderedFaces numbering))
      <> pair "buried" (list (\e -> pairs (ends e <> flanks e)) (orderedBuried numbering))
  where
    numbering = canonicalNumbering complex
    scene = complexScene complex
    corner = string . nameOf scene
    object = string . objectText scene
    number = int . vertexNumber numbering
    vertexEntry v =
      pairs $
        pair "corners" (list corner (vertexCorners (vertexAt complex v)))
          <> pair "kinds" (list (string . kindText) (vertexKinds complex v))
          <> segment complex v object corner
    edgeEntry e = pairs (ends e <> pair "back" back <> pair "front" front <> pair "kind" (string kind) <> flanks e)
      where
        here = corner (edgeCorner complex e)
        (back, front, kind) = case edgeView complex e of
          Tangent _ b f -> (object b, object f, "tangent")
          Ending Front b -> (object b, here, "ending")
          Ending Back f -> (here, object f, "ending")
          Buried _ -> broken "an edge is not buried" (show e)
    ends e =
      pair "corner" (corner (edgeCorner complex e))
        <> pair "from" (number (edgeFirst complex e))
        <> pair "to" (number (edgeLast complex e))
    flanks e = pair "above" (faces e Above) <> pair "below" (faces e Below)
    faces e flank = list (int . faceNumber numbering) (edgeFacesOn complex e flank)
    faceEntry f =
      pairs $
        pair "back" (object (faceBack complex f))
          <> pair "front" (object (faceFront complex f))
          <> pair "first" (maybe null_ number (faceFirst complex f))
          <> pair "last" (maybe null_ number (faceLast complex f))
          <> pair "upper" (chain (upperChain complex f))
          <> pair "lower" (chain (lowerChain complex f))
    chain (Chain before after) = list (int . edgeNumber numbering) (filter (isEdge complex) (before <> after))

-- | A document on a complex, which begins with the corners of the scene.
complexOf :: Complex -> Series -> Builder
complexOf complex content = document (pair "corners" (list corner (statedCorners (complexScene complex))) <> content)
  where
    corner (name, at) = pairs (pair "id" (string (cornerText name)) <> pair "at" (exactPoint at))

-- | The complex of polygons, in its own order: it depends on the scene only, to the last byte.
--
-- /Shape/ @corners@; @vertices@; @edges@; @faces@. @vertex@ and @parts@ are numbers in 'complexDocument', of the
-- vertex, of edges, of faces. Where the complex has no outlines there are @faces@ only, without vertices and chains.
--
-- /Cost/ O(m log m).
polygonDocument :: PolygonComplex -> Builder
polygonDocument made = complexOf complex $ case outlines made of
  Nothing -> pair "faces" (list (\face -> pairs (labels face <> parts face)) (V.toList (regions made)))
  Just found ->
    pair "vertices" (list lineEntry (V.toList (tangentLines found)))
      <> pair "edges" (list arcEntry (V.toList (arcs found)))
      <> pair "faces" (list bounded (zip (V.toList (regions made)) (V.toList (boundaries found))))
  where
    complex = sideComplex made
    scene = complexScene complex
    numbering = canonicalNumbering complex
    text label = string (case label of OfPolygon p -> polygonText p; OfSky -> "sky")
    labels face = pair "back" (text (regionBack face)) <> pair "front" (text (regionFront face))
    parts face = pair "parts" (list (int . faceNumber numbering) (regionFaces face))
    bounded (face, Boundary first end upper lower) =
      pairs $
        labels face <> pair "first" (number first) <> pair "last" (number end)
          <> pair "upper" (list (\(ArcId a, _) -> int a) upper)
          <> pair "lower" (list (\(ArcId a, _) -> int a) lower)
          <> parts face
    number = maybe null_ (\(LineId i) -> int i)
    lineEntry (TangentLine v touched) =
      pairs $
        pair "polygons" (list (string . polygonText . tangencyPolygon) touched)
          <> pair "corners" (list (string . nameOf scene . tangencyCorner) touched)
          <> pair "flanks" (list (flankText . tangencyFlanks) touched)
          <> segment complex v (text . polygonLabel scene) (string . polygonText . polygonOfCorner scene)
          <> pair "vertex" (int (vertexNumber numbering v))
    flankText touched = string (case touched of [Above] -> "above"; [Below] -> "below"; _ -> "both")
    arcEntry arc =
      pairs $
        pair "polygon" (string (polygonText (arcPolygon arc)))
          <> pair "flank" (flankText [arcFlank arc])
          <> pair "from" (number (arcFirst arc))
          <> pair "to" (number (arcLast arc))
          <> pair "turns" (int (arcTurns complex arc))
          <> mconcat
            [ pair "back" (text (polygonLabel scene b)) <> pair "front" (text (polygonLabel scene f))
            | Tangent _ b f <- map (edgeView complex) (take 1 (arcStretches arc))
            ]
          <> pair "above" (met (if arcFlank arc == Above then onFlank else across))
          <> pair "below" (met (if arcFlank arc == Above then across else onFlank))
          <> pair "parts" (list (int . edgeNumber numbering) (arcStretches arc))
      where
        (across, onFlank) = splitAt 1 (arcFaces arc)
    met = list (\(Aspect (RegionId r) _) -> int r)

nameOf :: Scene -> CornerId -> String
nameOf scene = cornerText . cornerName scene

-- | The direction of a vertex and the ends of its segment: an object, or the corner where it ends.
segment :: Complex -> VertexId -> (Object -> Encoding) -> (CornerId -> Encoding) -> Series
segment complex v object corner =
  pair "direction" (list (string . show) [dx, dy])
    <> pair "back" (maybe (corner (vertexFirst vertex)) object (vertexBack complex v))
    <> pair "front" (maybe (corner (vertexLast vertex)) object (vertexFront complex v))
  where
    vertex = vertexAt complex v
    Direction dx dy = primitive (vertexDirection (complexScene complex) vertex)

-- | @tangent@, @ending@ or @side@.
kindText :: Kind -> String
kindText kind = case kind of
  TangentAt _ -> "tangent"
  EndingAt _ -> "ending"
  AlongSide -> "side"
