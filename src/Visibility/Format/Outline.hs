-- | Rings and lines of positions, which GeoJSON and WKT have in common, as polygons of a scene.
module Visibility.Format.Outline
  ( ringPolygon
  , lineWall
  ) where

import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.List.NonEmpty as NonEmpty
import Visibility.Error (OutlineFault (..))
import Visibility.Exact.Point (Point)
import Visibility.Scene.Raw (RawPolygon, rawPolygon, rawWall)

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
