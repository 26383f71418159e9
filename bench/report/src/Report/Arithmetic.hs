-- | Arithmetics that exist to be measured: rationals, and the filter with its signs counted.
module Report.Arithmetic
  ( -- * What is exact
    exactArithmetics
  , inRationals
    -- * Signs
  , Signs (..)
  , shareLeft
  , countingSigns
  ) where

import Control.Exception (evaluate)
import Data.Maybe (fromMaybe)
import Data.Ratio ((%))
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed.Mutable as M
import System.IO.Unsafe (unsafeDupablePerformIO)
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Scene

-- | The arithmetics that are always right, by their names.
exactArithmetics :: [(String, Scene -> Scene)]
exactArithmetics =
  [("filtered", underArithmetic Filtered), ("exact", underArithmetic Exact), ("rational", inRationals)]

-- | The scene, decided about in rationals without a lattice's advantages: what a first attempt would do.
inRationals :: Scene -> Scene
inRationals scene = scene {scenePoints = decidedBy rationalTurn points}
  where
    points = scenePoints scene
    table = V.fromList (map coordinates (placeList (pointPlaces points)))
    rationalTurn a b c d = signTurn (compare (x1 * y2) (y1 * x2))
      where
        (x1, y1) = between a b
        (x2, y2) = between c d
    between a b = let ((x, y), (x', y')) = (table V.! a, table V.! b) in (x' - x, y' - y)
    signTurn order = case order of
      GT -> LeftTurn
      EQ -> Collinear
      LT -> RightTurn

-- | Signs asked of a filter.
data Signs = Signs
  { signsDecided :: !Int
  -- ^ All of them.
  , signsLeft :: !Int
  -- ^ Those of them that the filter was not sure of, so that integers decided.
  }
  deriving (Eq, Show)

-- | The part of the signs that was left to integers, from 0 to 1; 0 if there were none.
shareLeft :: Signs -> Rational
shareLeft (Signs decided left) = if decided == 0 then 0 else toInteger left % toInteger decided

-- | How many signs a filter decides until a number made of the scene is known. 'Nothing' where no filter decides.
countingSigns :: Scene -> (Scene -> Int) -> IO (Maybe Signs)
countingSigns scene work = case pointsKernel points of
  FilterKernel _ -> do
    cells <- M.replicate 2 0
    _ <- evaluate (work scene {scenePoints = decidedBy (counted cells) points})
    Just <$> (Signs <$> M.read cells 0 <*> M.read cells 1)
  _ -> pure Nothing
  where
    points = scenePoints scene
    -- It writes to its counters when its result is evaluated, which no type shows. The result is that of the arguments
    -- alone, and the counters are read only here, after the work.
    counted cells a b c d = unsafeDupablePerformIO $ do
      let sure = filterTurn points a b c d
      M.modify cells (+ 1) 0
      maybe (M.modify cells (+ 1) 1) (const (pure ())) sure
      pure (fromMaybe (headingTurn points a b c d) sure)
    {-# NOINLINE counted #-}
