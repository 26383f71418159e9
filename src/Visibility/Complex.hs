-- | The visibility complex of a scene as a value: vertices, edges and faces with their incidences.
--
-- A complex is made by 'build' from the vertices of any sweep, which number it; "Visibility.Complex.Canonical"
-- numbers it as a function of the scene alone. Where the half turn begins, nothing is cut: an edge and a face that go
-- on there are one.
--
-- In a scene in general position, a vertex has four edges, and six faces where the line is tangent at both corners,
-- five where it is tangent at one, four where it ends at both. A tangent edge has three faces, an ending edge two.
-- Vertices with any number of corners are ordinary values.
--
-- /Source/ Orti, Rivière, Durand, Puech, Using the visibility complex for radiosity computation, section 3; Pocchiola,
-- Vegter, The visibility complex. The handling of degenerate vertices is this project's.
module Visibility.Complex
  ( -- * The complex
    complexOf
  , build
    -- * Its parts
  , module Visibility.Complex.Type
  ) where

import Visibility.Complex.Build
import Visibility.Complex.Type (Complex, EdgeId, FaceId, VertexId)
import Visibility.Complex.Type hiding
  (Complex (..), EdgeId (..), FaceId (..), VertexId (..), lastEdgeOf, quartersOf, vertexLine, vertexRow)
import Visibility.Scene (Scene)
import Visibility.Sweep (vertices)

-- | The complex of a scene, numbered as the topological sweep goes. /Cost/ O(n log n + m).
complexOf :: Scene -> Complex
complexOf scene = build scene (vertices scene)
