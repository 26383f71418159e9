-- | A complex told in names, without a single number of a table: what can be compared between sweeps and under
-- renaming.
module Visibility.Test.Description
  ( Description
  , description
  , renamedDescription
  ) where

import Data.Bifunctor (bimap)
import Data.List (sort)
import Data.Set (Set)
import qualified Data.Set as Set
import Visibility.Complex
import Visibility.Scene
import Visibility.Sweep
import Visibility.View (End, Flank (..), View (..))

-- | An object by its name, the sky having none.
type Named = Maybe SideName

-- | A corner by all names in its place.
type Corner = [CornerName]

-- | A vertex by its corners.
type Line = [Corner]

-- | A stretch by its corner and the vertex where it begins.
type Stretch = (Corner, Line)

-- | A face by its labels and where it begins; and by its chains, which tell apart faces that share these.
type Face = (Named, Named, Maybe Line, Maybe Line, [Stretch], [Stretch])

-- | Vertices with kinds, objects at both ends, and the faces around; stretches with their end, objects, and faces above
-- and below; faces.
data Description = Description
  { vertexFacts :: Set (Line, [Kind], Maybe Named, Maybe Named, Set Face)
  , stretchFacts :: Set (Stretch, Line, ([Named], Maybe Flank, Maybe End), [Face], [Face])
  , faceFacts :: Set Face
  }
  deriving (Eq, Show)

-- | /Cost/ O(m) times the length of the chains.
description :: Complex -> Description
description complex =
  Description
    { vertexFacts =
        Set.fromList
          [ (line v, vertexKinds complex v, named <$> vertexBack complex v, named <$> vertexFront complex v
            , Set.fromList (map face (vertexFaces complex v)))
          | v <- vertexIds complex
          ]
    , stretchFacts =
        Set.fromList
          [ (stretch e, line (edgeLast complex e), viewFacts (edgeView complex e), faces Above, faces Below)
          | e <- stretchIds complex
          , let faces side = map face (edgeFacesOn complex e side)
          ]
    , faceFacts = Set.fromList (map face (faceIds complex))
    }
  where
    scene = complexScene complex
    line v = map (namesHere scene) (vertexCorners (vertexAt complex v))
    stretch e = (namesHere scene (edgeCorner complex e), line (edgeFirst complex e))
    named (Side s) = Just (sideName scene s)
    named Sky = Nothing
    viewFacts view = case view of
      Tangent flank b f -> ([named b, named f], Just flank, Nothing)
      Ending end o -> ([named o], Nothing, Just end)
      Buried flank -> ([], Just flank, Nothing)
    face f =
      ( named (faceBack complex f)
      , named (faceFront complex f)
      , line <$> faceFirst complex f
      , line <$> faceLast complex f
      , turned f (upperChain complex f)
      , turned f (lowerChain complex f)
      )
    -- The closed chain of the lines that miss everything has no first stretch.
    turned f (Chain before after) = case faceFirst complex f of
      Just _ -> map stretch (before <> after)
      Nothing -> Set.toList (Set.fromList (map stretch (before <> after)))

-- | The same complex under new names.
renamedDescription :: (CornerName -> CornerName) -> (SideName -> SideName) -> Description -> Description
renamedDescription rename side told =
  Description
    { vertexFacts =
        Set.map (\(l, k, b, f, fs) -> (line l, k, fmap object b, fmap object f, Set.map face fs)) (vertexFacts told)
    , stretchFacts =
        Set.map
          (\(s, l, (seen, flank, end), above, below) ->
             (stretch s, line l, (map object seen, flank, end), map face above, map face below))
          (stretchFacts told)
    , faceFacts = Set.map face (faceFacts told)
    }
  where
    corner = sort . map rename
    line = map corner
    object = fmap side
    stretch = bimap corner line
    face (b, f, first, end, upper, lower) =
      (object b, object f, fmap line first, fmap line end, chain first upper, chain first lower)
    chain Nothing = Set.toList . Set.fromList . map stretch
    chain (Just _) = map stretch
