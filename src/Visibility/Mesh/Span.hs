-- | Which part of its side, as the file states it, each uncovered piece is.
module Visibility.Mesh.Span
  ( Span (..)
  , pieceSpans
  , parameterOn
  , pointOn
  ) where

import qualified Data.Vector as V
import Visibility.Exact.Point (Point (..))
import Visibility.Scene

-- | A piece of a side of the file: where the side begins and ends in the order of the file, and the parameters of the
-- 'sideStart' and the 'sideEnd' of the piece.
--
-- /Degenerate cases/ the two parameters are 0 and 1 where nothing covers the side, and 1 and 0 where moreover the file
-- has the polygon the other way round.
data Span = Span
  { spanFrom :: !Point
  , spanTo :: !Point
  , spanStart :: !Rational
  , spanEnd :: !Rational
  }

-- | By 'SideId'. /Cost/ O(n).
pieceSpans :: Scene -> V.Vector Span
pieceSpans scene = V.fromList (map spanOf (sides scene))
  where
    spanOf s = Span from to (parameter (sideStart s)) (parameter (sideEnd scene s))
      where
        (from, to) = sideEnds scene (sideName scene s)
        parameter = parameterOn (from, to) . cornerPoint scene

-- | Where a point of a segment lies on it, from 0 at its first end to 1. /Requires/ a segment of some length.
parameterOn :: (Point, Point) -> Point -> Rational
parameterOn (Point ax ay, Point bx by) (Point x y)
  | ax /= bx = (x - ax) / (bx - ax)
  | otherwise = (y - ay) / (by - ay)

-- | The point of a side of the file at a parameter.
pointOn :: Span -> Rational -> Point
pointOn piece t = Point (ax + t * (bx - ax)) (ay + t * (by - ay))
  where
    Point ax ay = spanFrom piece
    Point bx by = spanTo piece
