-- | What the laws of the complex share: their type, reading the tables, and the names that texts give to things.
module Visibility.Complex.Law.Base
  ( -- * Laws
    Law (..)
  , law
  , lawOf
  , exactly
    -- * Reading the tables
  , cornersOf
  , compareLines
    -- * Texts
  , cornerLabel
  , vertexLabel
  , stretchLabel
  , faceLabel
  , objectLabel
  ) where

import Data.List (intercalate)
import Visibility.Complex.Type
import Visibility.Exact.Point (Arithmetic (..))
import Visibility.Exact.Predicate
import Visibility.Law
import Visibility.Scene
import Visibility.Sweep.Vertex

-- | A law of the complex of a scene: its name, what it says in full, and how it is decided.
data Law a = Law
  { lawName :: String
  , lawStatement :: String
  , lawViolations :: a -> [Violation]
  -- ^ Lazy, in no order of importance. /Requires/ well-formed tables, but for the law that says what these are.
  }

-- | A law whose check says what was found.
law :: String -> String -> (a -> [String]) -> Law a
law name statement check = Law name statement (map (Violation name) . check)

-- | A law that is decided by exact signs, whatever the arithmetic of the scene.
lawOf :: String -> String -> (Complex -> [String]) -> Law Complex
lawOf name statement check = law name statement (check . exactly)

-- | The complex with its scene under an arithmetic that is always right.
exactly :: Complex -> Complex
exactly complex = case sceneArithmetic (complexScene complex) of
  UnsafeDouble -> complex {sweptScene = underArithmetic Filtered (complexScene complex)}
  _ -> complex

-- | The corners of a vertex.
cornersOf :: Complex -> VertexId -> [CornerId]
cornersOf complex = vertexCorners . vertexAt complex

-- | The order of two vertices by direction.
compareLines :: Complex -> VertexId -> VertexId -> Ordering
compareLines complex v w = compareDirections (vertexLine complex v) (vertexLine complex w)

-- | @0.1@
cornerLabel :: Complex -> CornerId -> String
cornerLabel complex = cornerText . cornerName (complexScene complex)

-- | @vertex 7 (0.1 2.3)@
vertexLabel :: Complex -> VertexId -> String
vertexLabel complex v@(VertexId i) =
  "vertex " <> show i <> " (" <> unwords (map (cornerLabel complex) (cornersOf complex v)) <> ")"

-- | @stretch 12 of corner 0.1 from vertex 7 (0.1 2.3)@
stretchLabel :: Complex -> EdgeId -> String
stretchLabel complex e@(EdgeId i) =
  "stretch " <> show i <> " of corner " <> cornerLabel complex (edgeCorner complex e) <> " from "
    <> vertexLabel complex (edgeFirst complex e)

-- | @face 5 (0.1, sky)@
faceLabel :: Complex -> FaceId -> String
faceLabel complex f@(FaceId i) = "face " <> show i <> " (" <> intercalate ", " [name faceBack, name faceFront] <> ")"
  where
    name side = objectLabel complex (Just (side complex f))

-- | @0.1@, @sky@, or @solid@.
objectLabel :: Complex -> Maybe Object -> String
objectLabel complex = maybe "solid" (objectText (complexScene complex))
