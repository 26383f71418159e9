-- | The visibility graph as lines of text.
module Visibility.Format.Graph
  ( -- * Which pairs
    PairSelection (..)
  , selectedPairs
    -- * As text
  , graphLines
  , sortedGraphLines
  ) where

import Data.ByteString.Builder (Builder, byteString, char7, string7)
import qualified Data.ByteString.Char8 as Char8
import qualified Data.Map.Strict as Map
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
-- /Cost/ O(1) per pair, in constant memory.
graphLines :: [(CornerName, CornerName)] -> Builder
graphLines = foldMap (\(a, b) -> string7 (cornerText a) <> char7 ' ' <> string7 (cornerText b) <> char7 '\n')

-- | The same lines, sorted by the names of both corners: polygon number, then corner number, the enclosure last.
--
-- /Cost/ O(m log m) time, O(m) memory.
sortedGraphLines :: Scene -> [(CornerName, CornerName)] -> Builder
sortedGraphLines scene pairs = foldMap line (U.toList sorted)
  where
    names = V.fromList (map fst (statedCorners scene))
    n = V.length names
    texts = V.map (Char8.pack . cornerText) names
    ranks = Map.fromDistinctAscList (zip (V.toList names) [0 ..])
    rank name = Map.findWithDefault 0 name ranks
    sorted = U.modify Intro.sort (U.fromList [rank a * n + rank b | (a, b) <- pairs])
    line k = let (a, b) = k `quotRem` n in byteString (texts V.! a) <> char7 ' ' <> byteString (texts V.! b) <> char7 '\n'
