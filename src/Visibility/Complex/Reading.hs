-- | How the faces of a complex read the stretches of their chains.
--
-- Where the half turn ends, every line comes again with back and front, above and below exchanged. So a face that goes
-- on over the end reads the stretches that come after it backwards.
module Visibility.Complex.Reading
  ( Reading (..)
  , Incident (..)
  , chainIncidences
  , Readings
  , readings
  , readingAt
  ) where

import qualified Data.Vector.Unboxed as U
import Data.Word (Word8)
import Visibility.Complex.Table
import Visibility.Complex.Type
import Visibility.View (Flank (..))

-- | How a face is read: in the half turn that it begins in, or in the following one. The face of the lines that miss
-- everything lies above all curves in the one reading, below all of them in the other.
data Reading = Forwards | Backwards
  deriving (Eq, Ord, Show, Enum)

-- | A stretch in a chain of a face: the face, the stretch, the flank of the stretch on which the face lies where the
-- stretch begins, and how the face reads the stretch.
data Incident = Incident !FaceId !EdgeId !Flank !Reading

-- | All entries of all chains.
chainIncidences :: Complex -> [Incident]
chainIncidences complex =
  [ Incident f e flank reading
  | f <- faceIds complex
  , (Chain now later, below, above) <- [(upperChain complex f, Below, Above), (lowerChain complex f, Above, Below)]
  , (es, flank, reading) <- [(now, below, Forwards), (later, above, Backwards)]
  , e <- es
  ]

-- | By stretch and quarter: how the face there reads the stretch, by its chains. 'Nothing' where there is no face, or,
-- in broken tables, if the stretch is not in the chains of the face.
newtype Readings = Readings (U.Vector Word8)

-- | /Cost/ O(incidences).
readings :: Complex -> Readings
readings complex =
  Readings $
    U.replicate (tableLength (stretchFaces complex)) 0
      U.// [ (code (e, quarter), 1 + fromIntegral (fromEnum reading))
           | Incident f e flank reading <- chainIncidences complex
           , quarter <- quartersOf flank
           , faceAt complex e quarter == Just f
           ]

readingAt :: Readings -> EdgeId -> Quarter -> Maybe Reading
readingAt (Readings table) e quarter = case table U.! code (e, quarter) of
  0 -> Nothing
  k -> Just (toEnum (fromIntegral k - 1))
