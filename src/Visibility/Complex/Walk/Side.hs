-- | What a side sees: all faces with the side at back or front, and their measures from their own boundaries.
module Visibility.Complex.Walk.Side
  ( -- * Faces by side
    SideIndex
  , sideIndex
  , facesOf
    -- * What a side sees
  , SideLook (..)
  , sees
    -- * Measures
  , faceMeasure
  ) where

import Data.List (nub)
import qualified Data.Map.Strict as Map
import Data.Ratio ((%))
import qualified Data.Vector as V
import Visibility.Complex.Type
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Exact.RootSum (RootSum)
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.FormFactor (FormFactor, formFactor)
import Visibility.Scene

-- | A complex with the faces of each object: by 'SideId', then those of the sky, in the order of their ids.
data SideIndex = SideIndex !Complex !(V.Vector [FaceId])

-- | /Cost/ O(number of faces).
sideIndex :: Complex -> SideIndex
sideIndex complex = SideIndex complex (V.accum (flip (:)) (V.replicate (cornerCount scene + 1) []) found)
  where
    scene = complexScene complex
    -- A face that has one object at both ends is listed once.
    found =
      [ (listOf scene object, f)
      | f <- reverse (faceIds complex)
      , object <- nub [faceBack complex f, faceFront complex f]
      ]

-- Where the faces of an object are listed.
listOf :: Scene -> Object -> Int
listOf scene object = case object of
  Side (SideId s) -> s
  Sky -> cornerCount scene

-- | The faces with an object at back or front, in the order of their ids. /Cost/ O(1) for each.
facesOf :: SideIndex -> Object -> [FaceId]
facesOf (SideIndex complex lists) object = lists V.! listOf (complexScene complex) object

-- | What is seen from a side.
data SideLook = SideLook
  { sideFactors :: ![FormFactor]
  -- ^ Of all that it sees: faces have positive measures, so none is zero. By the names of what is seen, the sky last.
  , sideFaces :: !Int
  -- ^ How many faces were visited.
  }

-- | All that a side of the file sees, with exact measures and form factors: all its pieces together. 'Nothing' if the
-- file has no such side.
--
-- /Cost/ proportional to the faces of the side and their boundaries, besides the arithmetic of sums of roots.
--
-- /Laws/ equal to those that are added up along the sweep ('Visibility.FormFactor.formFactors'); they sum up to the
-- part of the side that is not covered.
sees :: SideIndex -> SideName -> Maybe SideLook
sees index@(SideIndex complex _) name = looked <$> piecesOf scene name
  where
    scene = complexScene complex
    looked pieces = SideLook (map factor (Map.toAscList totals)) (length faces)
      where
        faces = [(s, f) | s <- pieces, f <- facesOf index (Side s)]
        measured = [(other s f, faceMeasure complex f) | (s, f) <- faces]
        totals = Map.map RootSum.merged (RootSum.totalsBy measured)
    other s f = seenAs scene (if faceBack complex f == Side s then faceFront complex f else faceBack complex f)
    factor (object, total) = formFactor scene name object total

-- | The measure of the lines of a face, its area in the dual, in the file's units: the integral of its upper boundary
-- less that of its lower one. A corner's curve adds what its position along the line gains from one end of the
-- stretch to the other.
--
-- /Degenerate cases/ where the half turn's end cuts the face or a stretch, directions go on turning.
--
-- /Requires/ a face with a first vertex. /Cost/ one gcd and one square for each end of a stretch.
--
-- /Source/ Orti, Rivière, Durand, Puech, Using the visibility complex for radiosity computation, propositions 1 and 2.
faceMeasure :: Complex -> FaceId -> RootSum
faceMeasure complex f = along (upperChain complex f) `RootSum.minus` along (lowerChain complex f)
  where
    scene = complexScene complex
    unit = latticeScale (sceneLattice scene)
    along (Chain early late) = mconcat (concatMap (gained id) early <> concatMap (gained reversed) late)
    gained turned e =
      [ position (edgeCorner complex e) (turned (passed (edgeTo complex e)))
      , RootSum.negated (position (edgeCorner complex e) (turned (edgeFrom complex e)))
      ]
      where
        passed = if wrapsAround complex e then reversed else id
    position c d = RootSum.hypotenuse ((x * dx + y * dy) % (unit * w * (dx * dx + dy * dy))) dx dy
      where
        LatticePoint x y w = cornerAt scene c
        Direction dx dy = primitive d
