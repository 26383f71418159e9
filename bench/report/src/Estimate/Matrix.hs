{-# LANGUAGE RankNTypes #-}

-- | Form factor matrices in Doubles, with errors against the exact one, and the scene in Doubles.
--
-- What is estimated here is there to be measured: nothing else in this project depends on it.
module Estimate.Matrix
  ( -- * Matrices
    Matrix
  , matrixSize
  , matrixFrom
  , entryAt
    -- * The truth
  , Truth
  , truthOf
  , truthEntries
  , only
  , Errors (..)
  , errorsOf
    -- * The scene in Doubles
  , Sides (..)
  , sidesIn
  ) where

import Control.Monad.ST (ST)
import Data.List (sort)
import qualified Data.Map.Strict as Map
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.Point (Point (..))
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Exact.Rounding (nearestDouble)
import Visibility.FormFactor
import Visibility.Scene

-- | A Double for each side and each thing that light from it may reach, by the order of their names, the sky last.
data Matrix = Matrix !Int !(U.Vector Double)

-- | The number of sides.
matrixSize :: Matrix -> Int
matrixSize (Matrix n _) = n

-- | A matrix that starts with zeros and is written by row and column.
matrixFrom :: Int -> (forall s. (Int -> Int -> Double -> ST s ()) -> ST s ()) -> Matrix
matrixFrom n fill = Matrix n $ U.create $ do
  entries <- M.replicate (n * (n + 1)) 0
  fill (\row column x -> M.modify entries (+ x) (row * (n + 1) + column))
  pure entries
{-# INLINE matrixFrom #-}

-- | The entry of a row and a column.
entryAt :: Matrix -> Int -> Int -> Double
entryAt (Matrix n entries) row column = entries U.! (row * (n + 1) + column)

-- | The exact form factors: row and column, the nearest Double, and the Double nearest to what it lacks. Together they
-- are good to 2^−104.
newtype Truth = Truth [((Int, Int), (Double, Double))]

truthOf :: Scene -> [FormFactor] -> Truth
truthOf scene factors =
  Truth
    [ ((rank (factorFrom f), column (factorTo f)), (high, nearestDouble lacking))
    | f <- factors
    , let high = nearestDouble (factorValue f)
    , let lacking = factorValue f - RootSum.rational (toRational high)
    ]
  where
    ranks = Map.fromList (zip (statedSides scene) [0 ..])
    rank side = Map.findWithDefault 0 side ranks
    column (TheSide side) = rank side
    column TheSky = Map.size ranks

-- | The entries that are not zero.
truthEntries :: Truth -> [((Int, Int), Double)]
truthEntries (Truth entries) = [(place, high) | (place, (high, _)) <- entries]

-- | What the truth says of one entry.
only :: (Int, Int) -> Truth -> Truth
only place (Truth entries) = Truth (filter ((== place) . fst) entries)

-- | Relative errors over all form factors that are not zero, a missing one counting 1; the largest absolute error; and
-- how many form factors are not zero that should be.
data Errors = Errors
  { largestRelative :: !Double
  , medianRelative :: !Double
  , largestAbsolute :: !Double
  , spurious :: !Int
  }
  deriving (Eq, Show)

errorsOf :: Truth -> Matrix -> Errors
errorsOf (Truth exact) (Matrix n entries) =
  Errors
    { largestRelative = maximum (0 : map fst errors)
    , medianRelative = case drop (length errors `div` 2) (sort (map fst errors)) of
        middle : _ -> middle
        [] -> 0
    , largestAbsolute = maximum (0 : map snd errors)
    , spurious = U.length (U.filter (/= 0) entries) - length (filter (/= 0) (map (at . fst) exact))
    }
  where
    at (row, column) = entries U.! (row * (n + 1) + column)
    errors =
      [ (distance / high, distance)
      | (place, (high, low)) <- exact
      , let distance = abs ((at place - high) - low)
      , high > 0
      ]

-- | The sides of free space in Doubles, in the file's coordinates: their ends, the solid on the left of the way from
-- the first to the second; the number of the side of the file that each is a piece of, and the lengths by that number.
data Sides = Sides
  { startX, startY, endX, endY :: !(U.Vector Double)
  , sideNumber :: !(U.Vector Int)
  , lengths :: !(U.Vector Double)
  , isRoom :: !Bool
  }

sidesIn :: Scene -> Sides
sidesIn scene =
  Sides
    { startX = table (x . sideStart)
    , startY = table (y . sideStart)
    , endX = table (x . sideEnd scene)
    , endY = table (y . sideEnd scene)
    , sideNumber = U.fromList [Map.findWithDefault 0 (sideName scene s) numbers | s <- sides scene]
    , lengths = U.fromList (map (nearestDouble . sideLength scene) (statedSides scene))
    , isRoom = surroundings scene == Room
    }
  where
    table part = U.fromList (map part (sides scene))
    numbers = Map.fromDistinctAscList (zip (statedSides scene) [0 ..])
    points = V.fromList [(fromRational a, fromRational b) | Point a b <- map (cornerPoint scene) (corners scene)]
    x (CornerId c) = fst (points V.! c)
    y (CornerId c) = snd (points V.! c)
