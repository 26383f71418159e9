-- | The horizon trees of the reference at the start of the half turn.
module Visibility.Sweep.Reference.Plant
  ( planted
  ) where

import Data.List (foldl')
import qualified Data.Map.Strict as Map
import Data.Maybe (listToMaybe)
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Sweep.Reference.Tree
import Visibility.Sweep.Vertical

-- | The tree just above −90°, from what is below each corner. /Cost/ O(n log n).
--
-- Corners are visited from right to left. For each object that the vertical meets, the lower hull of the corners
-- visited above it is kept, the nearest corner first: that is what a ray turning up from the object meets.
planted :: Scene -> Vertical -> Heading -> Tree
planted scene vertical way = foldl' (relink scene) edged (corners scene)
  where
    edged = foldl' (\tree (p, t) -> grownBy scene tree p t) (bareTree scene way) (Map.toList firsts)
    firsts = snd (foldl' visit (Map.empty, Map.empty) (reverse (along way (cornerCount scene))))
    objectsBelow = (case way of Rightward -> floors; Leftward -> ceilings) vertical
    visit (hulls, found) c = (started (maybe hulls (\o -> Map.insert o (p : hull o) hulls) below), targeted found)
      where
        p = CornerId c
        below = objectOf scene (fromIntegral (objectsBelow U.! c))
        hull o = fromTangent (Map.findWithDefault [] o hulls)
        fromTangent (a : b : rest) | turned scene p a b == RightTurn = fromTangent (b : rest)
        fromTangent rest = rest
        targeted = maybe id (Map.insert p) $ case below of
          Just o -> Just (maybe ToSky ToCorner (listToMaybe (hull o)))
          Nothing -> ToCorner <$> lowest (filter (comesBefore way p) (besides scene p))
        lowest [a, b] | turned scene p a b == RightTurn = Just b
        lowest sides' = listToMaybe sides'
        -- Solid is on the left of a side: the one from p to a corner on the left is free above, and met from here on.
        started = if comesBefore way (nextCorner scene p) p then Map.insert (Side (SideId c)) [p] else id
