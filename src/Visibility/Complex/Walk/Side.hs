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

import Control.Monad (forM_)
import Data.Int (Int32)
import qualified Data.Map.Strict as Map
import Data.Ratio ((%))
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Complex.Type
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Exact.RootSum (RootSum)
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.FormFactor (FormFactor, formFactor)
import Visibility.Scene
import Visibility.Sweep.Vertical (skyCode)

-- | A complex with the faces of each object: those of object k are listed from entry k on, below entry k + 1, in the
-- order of their ids.
data SideIndex = SideIndex !Complex !(U.Vector Int32) !(U.Vector Int32)

-- | /Cost/ O(number of faces) time, 8 bytes per face.
sideIndex :: Complex -> SideIndex
sideIndex complex = SideIndex complex starts listed
  where
    objects = skyCode (complexScene complex) + 1
    faceTotal = U.length (faceBacks complex)
    -- A face that has one object at both ends is listed once.
    ends f = if b == g then [b] else [b, g]
      where
        b = fromIntegral (faceBacks complex U.! f) :: Int
        g = fromIntegral (faceFronts complex U.! f)
    sizes = U.create $ do
      table <- M.replicate objects 0
      forM_ [0 .. faceTotal - 1] $ \f -> forM_ (ends f) $ \k -> M.modify table (+ 1) k
      pure table
    starts = U.scanl' (+) 0 sizes
    listed = U.create $ do
      table <- M.new (fromIntegral (U.last starts))
      next <- U.thaw starts
      forM_ [0 .. faceTotal - 1] $ \f -> forM_ (ends f) $ \k -> do
        place <- M.read next k
        M.write table (fromIntegral place) (fromIntegral f)
        M.write next k (place + 1)
      pure table

-- | The faces with an object at back or front, in the order of their ids. /Cost/ O(1) for each.
facesOf :: SideIndex -> Object -> [FaceId]
facesOf (SideIndex complex starts listed) object =
  [FaceId (fromIntegral (listed U.! fromIntegral i)) | i <- [starts U.! code .. starts U.! (code + 1) - 1]]
  where
    code = case object of
      Side (SideId s) -> s
      Sky -> skyCode (complexScene complex)

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
sees index@(SideIndex complex _ _) name = looked <$> piecesOf scene name
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
