-- | What the laws of the complex share: their type, reading the tables, and the names that texts give to things.
module Visibility.Complex.Law.Base
  ( -- * Laws
    Law (..)
  , lawOf
    -- * Reading the tables
  , entry
  , vertexTotal
  , stretchTotal
  , faceTotal
  , exactly
  , stretchesOf
  , cornersOf
  , pairsOf
    -- * Directions
  , lineOf
  , compareLines
    -- * Chains
  , Reading (..)
  , Incident (..)
  , chainIncidences
  , readings
  , readingAt
  , quartersOf
    -- * Texts
  , cornerLabel
  , vertexLabel
  , stretchLabel
  , faceLabel
  , objectLabel
  ) where

import Data.Int (Int32, Int8)
import Data.List (intercalate)
import qualified Data.Vector.Unboxed as U
import Visibility.Complex.Type
import Visibility.Exact.Point (Arithmetic (..))
import Visibility.Exact.Predicate
import Visibility.Law
import Visibility.Scene
import Visibility.Sweep.Vertex
import Visibility.View (Flank (..))

-- | A law of the complex of a scene: its name, what it says in full, and how it is decided.
data Law = Law
  { lawName :: String
  , lawStatement :: String
  , lawViolations :: Complex -> [Violation]
  -- ^ Lazy, in no order of importance. /Requires/ well-formed tables, but for the law that says what these are.
  }

-- | A law whose check says what was found.
lawOf :: String -> String -> (Complex -> [String]) -> Law
lawOf name statement check = Law name statement (map (Violation name) . check . exactly)

-- | The complex with its scene under an arithmetic that is always right.
exactly :: Complex -> Complex
exactly complex = case sceneArithmetic (complexScene complex) of
  UnsafeDouble -> complex {complexScene = underArithmetic Filtered (complexScene complex)}
  _ -> complex

-- | The entry of a table. /Requires/ an index within it.
entry :: U.Vector Int32 -> Int -> Int
entry table i = fromIntegral (table U.! i)
{-# INLINE entry #-}

vertexTotal, stretchTotal, faceTotal :: Complex -> Int
vertexTotal complex = U.length (vertexStarts complex) - 1
stretchTotal = U.length . stretchCorners
faceTotal = U.length . faceFirsts

-- | The stretches that begin at a vertex.
stretchesOf :: Complex -> Int -> [Int]
stretchesOf complex v = [entry (vertexStarts complex) v .. entry (vertexStarts complex) (v + 1) - 1]

-- | The corners of a vertex.
cornersOf :: Complex -> Int -> [Int]
cornersOf complex = map (entry (stretchCorners complex)) . stretchesOf complex

-- | The elementary pairs of the line through some corners.
pairsOf :: Complex -> [Int] -> [(CornerId, CornerId)]
pairsOf complex line = maybe [] (vertexPairs (complexScene complex)) (fromCorners (map CornerId line))

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
compareLines complex v w = case headingTurn points a b c d of
  LeftTurn -> LT
  Collinear -> EQ
  RightTurn -> GT
  where
    points = scenePoints (complexScene complex)
    (a, b) = endsOf complex v
    (c, d) = endsOf complex w

-- | How a face reads a stretch of its chains: as it is where the stretch begins, or backwards, after the end of the
-- half turn.
data Reading = AsItIs | Backwards
  deriving (Eq, Ord, Show)

-- | A stretch in a chain of a face: the face, the flank of the stretch on which it lies where the stretch begins, how
-- it reads the stretch.
data Incident = Incident !Int !Int !Flank !Reading

-- | All entries of all chains.
chainIncidences :: Complex -> [Incident]
chainIncidences complex = concatMap chainsOf (faceIds complex)
  where
    chainsOf f =
      let Chain upper upperRest = upperChain complex f
          Chain lower lowerRest = lowerChain complex f
       in incident f Below AsItIs upper
            <> incident f Above Backwards upperRest
            <> incident f Above AsItIs lower
            <> incident f Below Backwards lowerRest
    incident (FaceId f) flank reading es = [Incident f e flank reading | EdgeId e <- es]

-- | By stretch and quarter: how the face there reads the stretch, by its chains. 1 as it is, 2 backwards, 0 if the
-- stretch is not in its chains.
readings :: Complex -> U.Vector Int8
readings complex =
  U.replicate (4 * stretchTotal complex) 0
    U.// [ (q, if reading == AsItIs then 1 else 2)
         | Incident f e flank reading <- chainIncidences complex
         , q <- quartersOf e flank
         , entry (stretchFaces complex) q == f
         ]

-- | Takes 'readings'.
readingAt :: U.Vector Int8 -> Int -> Maybe Reading
readingAt table q = case table U.! q of
  1 -> Just AsItIs
  2 -> Just Backwards
  _ -> Nothing

-- | The entries in 'stretchFaces' of a flank of a stretch.
quartersOf :: Int -> Flank -> [Int]
quartersOf e Above = [4 * e, 4 * e + 1]
quartersOf e Below = [4 * e + 2, 4 * e + 3]

-- | @0.1@
cornerLabel :: Complex -> Int -> String
cornerLabel complex = cornerText . cornerName (complexScene complex) . CornerId

-- | @vertex 7 (0.1 2.3)@
vertexLabel :: Complex -> Int -> String
vertexLabel complex v
  | v < 0 = "no vertex"
  | otherwise = "vertex " <> show v <> " (" <> unwords (map (cornerLabel complex) (cornersOf complex v)) <> ")"

-- | @stretch 12 of corner 0.1 from vertex 7 (0.1 2.3)@
stretchLabel :: Complex -> Int -> String
stretchLabel complex e =
  "stretch " <> show e <> " of corner " <> cornerLabel complex (entry (stretchCorners complex) e) <> " from "
    <> vertexLabel complex (entry (stretchVertices complex) e)

-- | @face 5 (0.1, sky)@
faceLabel :: Complex -> Int -> String
faceLabel complex f
  | f < 0 = "no face"
  | otherwise = "face " <> show f <> " (" <> intercalate ", " [name faceBack, name faceFront] <> ")"
  where
    name side = objectLabel complex (Just (side complex (FaceId f)))

-- | @0.1@, @sky@, or @solid@.
objectLabel :: Complex -> Maybe Object -> String
objectLabel complex = maybe "solid" (objectText (complexScene complex))
