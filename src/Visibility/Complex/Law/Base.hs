-- | What the laws of the complex share: their type, reading the tables, and the names that texts give to things.
module Visibility.Complex.Law.Base
  ( -- * Laws
    Law (..)
  , law
  , lawOf
    -- * Reading the tables
  , entry
  , exactly
  , stretchesOf
  , cornersOf
  , pairsOf
  , startOf
  , endOf
    -- * Directions
  , lineOf
  , compareLines
    -- * Texts
  , cornerLabel
  , vertexLabel
  , stretchLabel
  , faceLabel
  , objectLabel
  ) where

import Data.List (intercalate)
import qualified Data.Vector.Unboxed as U
import Visibility.Complex.Table
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

-- | The number that stands in a table. /Requires/ an index within it.
entry :: Table index item -> Int -> Int
entry (Table numbers) i = fromIntegral (numbers U.! i)
{-# INLINE entry #-}

-- | The stretches that begin at a vertex.
stretchesOf :: Complex -> Int -> [Int]
stretchesOf complex v = [entry (vertexStarts complex) v .. entry (vertexStarts complex) (v + 1) - 1]

-- | The corners of a vertex.
cornersOf :: Complex -> Int -> [Int]
cornersOf complex = map (entry (stretchCorners complex)) . stretchesOf complex

-- | The elementary pairs of the line through some corners.
pairsOf :: Complex -> [Int] -> [(CornerId, CornerId)]
pairsOf complex line = maybe [] (vertexPairs (complexScene complex)) (fromCorners (map CornerId line))

-- | The vertex where a stretch begins, and the one where it ends.
startOf, endOf :: Complex -> EdgeId -> Int
startOf complex e = let VertexId v = edgeFirst complex e in v
endOf complex e = let VertexId v = edgeLast complex e in v

-- | The direction of a vertex, from its first corner to its last.
lineOf :: Complex -> Int -> Direction
lineOf complex v = uncurry (direction (scenePoints (complexScene complex))) (endsOf complex v)

-- | The first and the last corner of a vertex.
endsOf :: Complex -> Int -> (Int, Int)
endsOf complex v = (corner (vertexStarts complex `entry` v), corner (vertexStarts complex `entry` (v + 1) - 1))
  where
    corner = entry (stretchCorners complex)

-- | The order of two vertices by direction.
compareLines :: Complex -> Int -> Int -> Ordering
compareLines complex v w = turnOrder (headingTurn (scenePoints (complexScene complex)) a b c d)
  where
    (a, b) = endsOf complex v
    (c, d) = endsOf complex w

-- | @0.1@
cornerLabel :: Complex -> Int -> String
cornerLabel complex = cornerText . cornerName (complexScene complex) . CornerId

-- | @vertex 7 (0.1 2.3)@
vertexLabel :: Complex -> Int -> String
vertexLabel complex v =
  "vertex " <> show v <> " (" <> unwords (map (cornerLabel complex) (cornersOf complex v)) <> ")"

-- | @stretch 12 of corner 0.1 from vertex 7 (0.1 2.3)@
stretchLabel :: Complex -> Int -> String
stretchLabel complex e =
  "stretch " <> show e <> " of corner " <> cornerLabel complex (entry (stretchCorners complex) e) <> " from "
    <> vertexLabel complex (entry (stretchVertices complex) e)

-- | @face 5 (0.1, sky)@
faceLabel :: Complex -> Int -> String
faceLabel complex f = "face " <> show f <> " (" <> intercalate ", " [name faceBack, name faceFront] <> ")"
  where
    name side = objectLabel complex (Just (side complex (FaceId f)))

-- | @0.1@, @sky@, or @solid@.
objectLabel :: Complex -> Maybe Object -> String
objectLabel complex = maybe "solid" (objectText (complexScene complex))
