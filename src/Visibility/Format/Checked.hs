-- | What readers of scenes have in common: they go on behind a fault, so that every fault is reported; and what GeoJSON
-- and WKT give as rings and lines of positions becomes polygons.
module Visibility.Format.Checked
  ( Checked (..)
  , fault
  , andThen
  , eachOf
  , outcome
    -- * Rings and lines
  , ringPolygon
  , lineWall
  ) where

import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.List.NonEmpty as NonEmpty
import Visibility.Error
import Visibility.Exact.Point (Point)
import Visibility.Scene.Raw (RawPolygon, rawPolygon, rawWall)

-- | A value or all the faults that prevent it. Nothing waits to be computed, so that what has been read keeps no text.
data Checked a = Wrong !(NonEmpty ParseError) | Good !a

instance Functor Checked where
  fmap _ (Wrong faults) = Wrong faults
  fmap f (Good a) = Good (f a)

-- | Collects the faults of both sides, in order.
instance Applicative Checked where
  pure = Good
  Good f <*> Good a = Good (f a)
  Wrong faults <*> Wrong faults' = Wrong (faults <> faults')
  Wrong faults <*> Good _ = Wrong faults
  Good _ <*> Wrong faults = Wrong faults

-- | One fault.
fault :: ParseError -> Checked a
fault why = Wrong (why :| [])

-- | What a value leads to, which may be faults of its own. Faults before it hide those.
andThen :: Checked a -> (a -> Checked b) -> Checked b
andThen (Wrong faults) _ = Wrong faults
andThen (Good a) next = next a

-- | 'traverse' with the places in the list, from 0.
eachOf :: (Int -> a -> Checked b) -> [a] -> Checked [b]
eachOf check = sequenceA . zipWith check [0 ..]
{-# INLINE eachOf #-}

-- | What has been read from a file, or its problems.
outcome :: FilePath -> Checked a -> Either (NonEmpty Problem) a
outcome file (Wrong faults) = Left (fmap (UnparseableFile file) faults)
outcome _ (Good a) = Right a

-- | The polygon inside a ring. Both formats repeat the first position as the last; it is one corner.
--
-- /Degenerate cases/ positions are not compared otherwise: a corner may be repeated, which no valid scene has. A ring
-- of two corners, there and back, is an error and no thin wall: that is what lines are for.
--
-- /Cost/ O(n).
--
-- >>> ringPolygon [Point 0 0, Point 1 0, Point 0 1, Point 0 0]
-- Right (rawPolygon [Point 0 0, Point 1 0, Point 0 1])
ringPolygon :: [Point] -> Either OutlineFault RawPolygon
ringPolygon positions = case positions of
  a : b : c : d : rest
    | end == a -> Right (rawPolygon (NonEmpty.init whole))
    | otherwise -> Left (OpenRing a end)
    where
      whole = a :| b : c : d : rest
      end = NonEmpty.last whole
  [a, _, c] | a /= c -> Left (OpenRing a c)
  _ -> Left (ShortRing (length positions))

-- | The thin wall along a line of two or more positions.
--
-- /Degenerate cases/ a line whose last position is its first is a wall that closes, with a face inside and one outside.
lineWall :: [Point] -> Either OutlineFault RawPolygon
lineWall positions = case positions of
  _ : _ : _ -> Right (rawWall positions)
  _ -> Left (ShortLine (length positions))
