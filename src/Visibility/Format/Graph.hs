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
import Data.List (sortOn)
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

-- | The selected pairs of a stream of vertices, in its order.
selectedPairs :: Scene -> PairSelection -> [Vertex] -> [(CornerId, CornerId)]
selectedPairs scene selection = concatMap $ case selection of
  AllPairs -> vertexPairs
  FreeBitangents -> freeBitangents scene

-- | A line per pair, the corner of smaller name first, in the order of the stream.
--
-- /Cost/ O(1) per pair, in constant memory besides a table of names.
graphLines :: Scene -> [(CornerId, CornerId)] -> Builder
graphLines scene = foldMap (line . ranked)
  where
    names = namesByRank scene
    ranks = nameRanks scene
    ranked (CornerId p, CornerId q) = let a = ranks U.! p; b = ranks U.! q in (min a b, max a b)
    line (a, b) = nameLine (names V.! a) (names V.! b)

-- | The same lines, sorted by the names of both corners: polygon number, then corner number, the enclosure last.
--
-- /Cost/ O(m log m) time, O(m) memory.
sortedGraphLines :: Scene -> [(CornerId, CornerId)] -> Builder
sortedGraphLines scene pairs = foldMap line (U.toList sorted)
  where
    n = cornerCount scene
    names = namesByRank scene
    ranks = nameRanks scene
    sorted = U.modify Intro.sort (U.fromList (map key pairs))
    key (CornerId p, CornerId q) = let a = ranks U.! p; b = ranks U.! q in min a b * n + max a b
    line k = let (a, b) = k `quotRem` n in nameLine (names V.! a) (names V.! b)

nameLine :: ByteString.ByteString -> ByteString.ByteString -> Builder
nameLine a b = byteString a <> char7 ' ' <> byteString b <> char7 '\n'

-- | The corners' names in the order of names.
namesByRank :: Scene -> V.Vector ByteString.ByteString
namesByRank scene = V.fromList (map (Char8.pack . cornerText . cornerName scene) (byName scene))

-- | The place of each corner in the order of names.
nameRanks :: Scene -> U.Vector Int
nameRanks scene = U.replicate (cornerCount scene) 0 U.// [(c, rank) | (rank, CornerId c) <- zip [0 ..] (byName scene)]

byName :: Scene -> [CornerId]
byName scene = sortOn (cornerName scene) (corners scene)
