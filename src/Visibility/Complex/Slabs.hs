{-# LANGUAGE BangPatterns #-}

-- | The sides that verticals meet, for each place of a vertical.
module Visibility.Complex.Slabs
  ( slabs
  ) where

import Control.Monad (forM_)
import Data.Set (Set)
import qualified Data.Set as Set
import qualified Data.Set.Internal as Set (link, merge)
import qualified Data.Vector as V
import qualified Data.Vector.Mutable as Boxed
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Sweep.Vertical

-- | The sides that a vertical meets, from below upwards: entry k for the verticals between the corners k − 1 and k,
-- from before all corners, entry 0, to behind them, entry n. Each is found by asking of sides whether they lie below
-- a point: elements are never compared with each other, for an order of theirs would hold at one vertical only.
--
-- /Degenerate cases/ between corners in one place it is what is behind all of them.
--
-- /Cost/ O(n log n) time and memory: the sets share most of their nodes.
slabs :: Scene -> V.Vector (Set Crossing)
slabs scene = V.create $ do
  table <- Boxed.replicate (n + 1) Set.empty
  let visit !crossing !x
        | x >= n = pure ()
        | otherwise = do
            let here = cornersFrom scene x
                next = x + length here
                crossing' = passed x (startingSides scene here) crossing
            forM_ [x + 1 .. next] $ \k -> Boxed.write table k crossing'
            visit crossing' next
  visit Set.empty 0
  pure table
  where
    n = cornerCount scene
    passed x starting crossing = case starting of
      [] -> Set.merge lower upper
      side : others -> Set.link side lower (foldr (`Set.link` Set.empty) upper others)
      where
        (lower, from) = Set.spanAntitone isBelow crossing
        upper = Set.dropWhileAntitone endsHere from
        isBelow (Crossing a b) = turn (scenePoints scene) a b x == LeftTurn
        endsHere (Crossing _ b) = samePlace scene (CornerId b) (CornerId x)
