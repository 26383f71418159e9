-- | A scene as a heading sees it, and what the places of a tree's table mean in it.
module Visibility.Sweep.HorizonTree.Frame
  ( Frame
  , frame
  , frameSize
  , following
  , preceding
  , comesBefore
  , turnIn
  , sharePlace
    -- * Nodes and corners
  , nodeSource
  , markerOf
  , isTreeEdge
  ) where

import Data.Int (Int32)
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.Point (Points)
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Sweep.HorizonTree.Table
import Visibility.Sweep.Vertical

-- | A scene as a heading sees it. A sum, not a product with a heading in it: so it is passed to the steps as one
-- pointer instead of field by field, and the numbers beside it fit into registers.
data Frame = RightwardFrame !Tables | LeftwardFrame !Tables

-- | What the steps need at hand.
data Tables = Tables
  { tableSize :: !Int
  , tablePoints :: !Points
  , tableNeighbours :: !(U.Vector Int32)
  , tablePlaces :: !(U.Vector Int32)
  }

frame :: Scene -> Heading -> Frame
frame scene heading = case heading of
  Rightward -> RightwardFrame tables
  Leftward -> LeftwardFrame tables
  where
    tables = Tables (cornerCount scene) (scenePoints scene) (neighbourTable scene) (placeNumbers scene)

tablesOf :: Frame -> Tables
tablesOf (RightwardFrame tables) = tables
tablesOf (LeftwardFrame tables) = tables
{-# INLINE tablesOf #-}

-- | How many corners the scene has.
frameSize :: Frame -> Int
frameSize = tableSize . tablesOf
{-# INLINE frameSize #-}

following, preceding :: Frame -> Int -> Int
following f p = fromIntegral (tableNeighbours (tablesOf f) U.! (2 * p))
preceding f p = fromIntegral (tableNeighbours (tablesOf f) U.! (2 * p + 1))
{-# INLINE following #-}
{-# INLINE preceding #-}

comesBefore :: Frame -> Int -> Int -> Bool
comesBefore (RightwardFrame _) = before Rightward
comesBefore (LeftwardFrame _) = before Leftward
{-# INLINE comesBefore #-}

turnIn :: Frame -> Int -> Int -> Int -> Turn
turnIn = turn . tablePoints . tablesOf
{-# INLINE turnIn #-}

-- | Are two corners in one place?
sharePlace :: Frame -> Int -> Int -> Bool
sharePlace f a b = places U.! a == places U.! b
  where
    places = tablePlaces (tablesOf f)
{-# INLINE sharePlace #-}

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
