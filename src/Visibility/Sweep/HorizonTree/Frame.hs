-- | A scene as a heading sees it, and what the places of a tree's table mean in it.
module Visibility.Sweep.HorizonTree.Frame
  ( Frame
  , Tables
  , sceneTables
  , frame
  , frameSize
  , following
  , preceding
  , comesBefore
  , turnIn
    -- * Nodes of sides
  , markerOf
  ) where

import Data.Int (Int32)
import Data.Primitive.PrimArray
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Sweep.HorizonTree.Table
import Visibility.Sweep.Vertical (Heading (..), before)

-- | A scene as a heading sees it. A sum, not a product with a heading in it: so it is passed to the steps as one
-- pointer instead of field by field, and the numbers beside it fit into registers.
data Frame = RightwardFrame !Tables | LeftwardFrame !Tables

-- | What the steps need at hand. Corners are below n, so places in these tables are not checked.
data Tables = Tables
  { tableSize :: !Int
  , tableCorners :: !(PrimArray Int32)
  -- ^ Of corner i, from 4i on: x and y where machine integers decide, and the following and the preceding corner.
  , tableDecides :: !Decides
  }

-- | What decides turns.
data Decides
  = -- | The machine integers of 'tableCorners'.
    Machine
  | Other !Points

frame :: Tables -> Heading -> Frame
frame tables heading = case heading of
  Rightward -> RightwardFrame tables
  Leftward -> LeftwardFrame tables

-- | /Cost/ O(n).
sceneTables :: Scene -> Tables
sceneTables scene = case pointsKernel points of
  MachineKernel xs -> tabled Machine xs
  _ -> tabled (Other points) (U.replicate (2 * n) 0)
  where
    n = cornerCount scene
    points = scenePoints scene
    around = neighbourTable scene
    tabled decides xs = Tables n (generatePrimArray (4 * n) part) decides
      where
        part i
          | even (i `div` 2) = xs U.! (2 * (i `div` 4) + i `mod` 2)
          | otherwise = around U.! (2 * (i `div` 4) + i `mod` 2)

tablesOf :: Frame -> Tables
tablesOf (RightwardFrame tables) = tables
tablesOf (LeftwardFrame tables) = tables
{-# INLINE tablesOf #-}

-- | How many corners the scene has.
frameSize :: Frame -> Int
frameSize = tableSize . tablesOf
{-# INLINE frameSize #-}

following, preceding :: Frame -> Int -> Int
following f p = ofCorner f (4 * p + 2)
preceding f p = ofCorner f (4 * p + 3)
{-# INLINE following #-}
{-# INLINE preceding #-}

ofCorner :: Frame -> Int -> Int
ofCorner f i = fromIntegral (indexPrimArray (tableCorners (tablesOf f)) i)
{-# INLINE ofCorner #-}

comesBefore :: Frame -> Int -> Int -> Bool
comesBefore (RightwardFrame _) = before Rightward
comesBefore (LeftwardFrame _) = before Leftward
{-# INLINE comesBefore #-}

-- | 'turn' of the scene's corners.
turnIn :: Frame -> Int -> Int -> Int -> Turn
turnIn f a b c = case tableDecides (tablesOf f) of
  Machine -> machineTurn (x a) (y a) (x b) (y b) (x c) (y c)
  Other points -> turn points a b c
  where
    x i = fromIntegral (ofCorner f (4 * i))
    y i = fromIntegral (ofCorner f (4 * i + 1))
{-# INLINE turnIn #-}

-- | The marker of the side from s to t, s before t, or 'noNode' where they are not joined by a side.
markerOf :: Frame -> Int -> Int -> Node
markerOf f s t
  | following f s == t = markerNode s
  | preceding f s == t = markerNode t
  | otherwise = noNode
{-# INLINE markerOf #-}
