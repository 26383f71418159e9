-- | The polygon-labelled quotient of the visibility complex: the complex of Orti, Rivière, Durand and Puech, in which a
-- face knows the polygons at the ends of its segments, not their sides.
--
-- /Source/ Orti, Rivière, Durand, Puech, Using the visibility complex for radiosity computation, §3; thin walls, flat
-- corners and degenerate vertices derived for this project. What holds of it: 'quotientLaws', and docs/quotient.md.
module Visibility.Complex.Quotient
  ( -- * The quotient
    quotient
  , module Visibility.Complex.Quotient.Type
    -- * Its regions
  , Union
  , regionOf
  , regionMembers
    -- * Laws
  , QuotientLaw (..)
  , quotientLaws
  , isGeneral
  ) where

import Visibility.Complex.Quotient.Convex
import Visibility.Complex.Quotient.Law
import Visibility.Complex.Quotient.Type
import Visibility.Complex.Quotient.Union
import Visibility.Complex.Type

-- | The quotient of a complex: with vertices, edges and chains if the scene consists of convex polygons and thin walls
-- under the sky, else the union of faces only.
--
-- /Degenerate cases/ in a room it is a union, also where the room is convex. A convex room plays the part of the sky:
-- its regions correspond to those of the same polygons under the sky.
--
-- /Requires/ a complex that satisfies its laws; from broken tables it may come to no end.
--
-- /Cost/ O(S log V) for S stretches and V vertices.
quotient :: Complex -> Quotient
quotient complex
  | isConvexScene (complexScene complex) = ConvexQuotient complex union (convexTables complex union)
  | otherwise = UnionQuotient complex union
  where
    union = uniteFaces complex
