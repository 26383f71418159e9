-- | The cone of free space at a corner, decided by its two sides; and how corners lie to each other.
module Visibility.Scene.Cone
  ( -- * Cones
    Moment (..)
  , entersSolid
    -- * From corner to corner
  , besides
  , heading
  , turned
  , sameWay
  ) where

import Visibility.Exact.Predicate
import Visibility.Scene

-- | When to look, while a direction turns to the left: at it, or next to nothing before or after it.
data Moment = JustBefore | JustThen | JustAfter
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | Does a ray from a corner leave its cone of free space right there? The cone lies between the side to the preceding
-- corner and, counter-clockwise from it, the side to the following one; all else is solid for this corner, even where
-- another cone begins in the same place.
--
-- /Degenerate cases/ 'JustThen', a ray along a side does not; a free end of a thin wall has no solid.
--
-- /Cost/ O(1).
entersSolid :: Scene -> Moment -> CornerId -> Direction -> Bool
entersSolid scene moment c ray
  | isWallEnd scene c = False
  | otherwise =
      insideArc directionTurn (to, from) ray
        || (moment == JustAfter && along to)
        || (moment == JustBefore && along from)
  where
    to = heading scene c (nextCorner scene c)
    from = heading scene c (previousCorner scene c)
    along side = directionTurn side ray == Collinear && sameWay side ray

-- | The corners at the other ends of the two sides of a corner.
besides :: Scene -> CornerId -> [CornerId]
besides scene c = [nextCorner scene c, previousCorner scene c]

-- | The direction from one corner to another.
heading :: Scene -> CornerId -> CornerId -> Direction
heading scene (CornerId a) (CornerId b) = direction (scenePoints scene) a b

-- | 'turn' of the scene's corners.
turned :: Scene -> CornerId -> CornerId -> CornerId -> Turn
turned scene (CornerId a) (CornerId b) (CornerId c) = turn (scenePoints scene) a b c

-- | Do two parallel directions lead the same way?
sameWay :: Direction -> Direction -> Bool
sameWay (Direction ax ay) (Direction bx by) = ax * bx + ay * by > 0
