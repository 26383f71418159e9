-- | A scene as a heading sees it, and what the places of a tree's table mean in it.
module Visibility.Sweep.HorizonTree.Frame
  ( Frame
  , frame
  , frameSize
  , following
  , preceding
  , comesBefore
  , turnIn
    -- * Nodes and corners
  , nodeSource
  , markerOf
  , isTreeEdge
  ) where

import qualified Data.Vector.Unboxed as U
import Visibility.Exact.Point (Points)
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Sweep.HorizonTree.Table
import Visibility.Sweep.Vertical

-- | A scene as a heading sees it, with what the steps need at hand.
data Frame = Frame
  { frameHeading :: !Heading
  , frameSize :: !Int
  , framePoints :: !Points
  , followings :: !(U.Vector Int)
  , precedings :: !(U.Vector Int)
  }

frame :: Scene -> Heading -> Frame
frame scene heading =
  Frame
    { frameHeading = heading
    , frameSize = cornerCount scene
    , framePoints = scenePoints scene
    , followings = nextCorners scene
    , precedings = previousCorners scene
    }

following, preceding :: Frame -> Int -> Int
following f p = followings f U.! p
preceding f p = precedings f U.! p
{-# INLINE following #-}
{-# INLINE preceding #-}

comesBefore :: Frame -> Int -> Int -> Bool
comesBefore = before . frameHeading
{-# INLINE comesBefore #-}

turnIn :: Frame -> Int -> Int -> Int -> Turn
turnIn = turn . framePoints
{-# INLINE turnIn #-}

-- | The corner that a node comes from.
nodeSource :: Frame -> Node -> Int
nodeSource f node
  | isEdgeNode node || comesBefore f i j = i
  | otherwise = j
  where
    i = nodeOwner node
    j = following f i
{-# INLINE nodeSource #-}

-- | The marker of the side from s to t, s before t, or 'noNode' where they are not joined by a side.
markerOf :: Frame -> Int -> Int -> Node
markerOf f s t
  | following f s == t = markerNode s
  | preceding f s == t = markerNode t
  | otherwise = noNode
{-# INLINE markerOf #-}

-- | Is this node of a list the tree edge of its source? Markers of sides may also be mere places in the list.
isTreeEdge :: Frame -> Table -> Node -> Bool
isTreeEdge f table node = nodeAt table (edge (nodeSource f node)) == node
