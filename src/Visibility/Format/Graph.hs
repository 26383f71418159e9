-- | The visibility graph as lines of text.
module Visibility.Format.Graph
  ( -- * Which pairs
    PairSelection (..)
  , selectedPairs
    -- * As text
  , graphLines
  , sortedGraphLines
  ) where

import Data.ByteString.Builder (Builder, byteString, char7)
import qualified Data.ByteString as ByteString
import qualified Data.ByteString.Char8 as Char8
import qualified Data.Vector as V
import qualified Data.Vector.Algorithms.Intro as Intro
import qualified Data.Vector.Unboxed as U
import Visibility.Scene
import Visibility.Sweep
import Visibility.View

-- | Which elementary visible pairs are asked for.
data PairSelection
  = AllPairs
  | -- | Only those whose line is tangent at both corners, sides of polygons left out.
    FreeBitangents
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | The selected pairs of a stream of vertices, in its order, as the file calls them: smaller name first.
--
-- /Degenerate cases/ where corners of the file are in one place, each of them is seen; they do not see each other.
selectedPairs :: Scene -> PairSelection -> [Vertex] -> [(CornerName, CornerName)]
selectedPairs scene selection = concatMap (concatMap (statedPairs scene) . chosen)
  where
    chosen = case selection of
      AllPairs -> vertexPairs scene
      FreeBitangents -> freeBitangents scene

-- | A line per pair, in the order of the stream.
--
-- /Cost/ O(1) per pair, in constant memory besides a table of names.
graphLines :: Scene -> [(CornerName, CornerName)] -> Builder
graphLines scene = foldMap (\(a, b) -> nameLine (text a) (text b))
  where
    names = namesOf scene
    text name = nameTexts names V.! rankOf names name

-- | The same lines, sorted by the names of both corners: polygon number, then corner number, the enclosure last.
--
-- /Cost/ O(m log m) time, O(m) memory.
sortedGraphLines :: Scene -> [(CornerName, CornerName)] -> Builder
sortedGraphLines scene pairs = foldMap line (U.toList sorted)
  where
    names = namesOf scene
    n = V.length (nameTexts names)
    sorted = U.modify Intro.sort (U.fromList [rankOf names a * n + rankOf names b | (a, b) <- pairs])
    line k = let (a, b) = k `quotRem` n in nameLine (nameTexts names V.! a) (nameTexts names V.! b)

nameLine :: ByteString.ByteString -> ByteString.ByteString -> Builder
nameLine a b = byteString a <> char7 ' ' <> byteString b <> char7 '\n'

-- | The texts of all corners of the file, in order, and by polygon, the enclosure last, the rank of its corner 0.
data Names = Names {nameTexts :: !(V.Vector ByteString.ByteString), firstRanks :: !(U.Vector Int)}

namesOf :: Scene -> Names
namesOf scene = Names (V.fromList (map (Char8.pack . cornerText . fst) (statedCorners scene))) (U.fromList (scanl (+) 0 sizes))
  where
    sizes = map (length . polygonPoints) (scenePolygons scene)

-- | The rank of a corner among all. /Requires/ a corner of the scene. /Cost/ O(1).
rankOf :: Names -> CornerName -> Int
rankOf names (CornerName polygon k) = k + firstRanks names U.! place
  where
    place = case polygon of
      Obstacle p -> p
      Enclosure -> U.length (firstRanks names) - 2
