{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DeriveTraversable #-}
{-# LANGUAGE RankNTypes #-}

-- | What every corner sees along the line through it while the direction turns: tables that a vertex changes in O(1)
-- per elementary pair. All that is told of a corner that passes a vertex is told from here.
--
-- /Source/ Rivière, Topologically sweeping the visibility complex of polygonal scenes; landing sides derived for this
-- project.
module Visibility.Sweep.Sights
  ( Sights (..)
  , Changing
  , startSights
  , outlookFrom
    -- * Passing vertices
  , Passage (..)
  , passing
  , alongStream
  ) where

import Control.Monad (forM_, when)
import Control.Monad.ST (ST)
import qualified Control.Monad.ST.Lazy as Lazy
import Data.Int (Int32)
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.Predicate
import Visibility.Incidence
import Visibility.Scene
import Visibility.Sweep.Vertex
import Visibility.Sweep.Vertical (Vertical (..), following, preceding, solid, verticalSweep)

-- | By corner: the objects in front and at the back of it, and 1 where the following corner of its polygon lies above
-- its line.
data Sights v = Sights {frontOf :: !v, backOf :: !v, nextAbove :: !v}
  deriving (Functor, Foldable, Traversable)

-- | Tables that are being changed.
type Changing s = Sights (M.MVector s Int32)

-- | What is seen along the vertical, at the start of the half turn. /Cost/ O(n log n).
startSights :: Scene -> Sights (U.Vector Int32)
startSights scene =
  Sights
    (floors vertical)
    (ceilings vertical)
    (U.generate (cornerCount scene) (\p -> if following scene p > p then 1 else 0))
  where
    vertical = verticalSweep scene

-- | What a corner sees now.
outlookFrom :: Changing s -> Int -> ST s Outlook
outlookFrom sights !c = do
  back <- M.unsafeRead (backOf sights) c
  front <- M.unsafeRead (frontOf sights) c
  above <- M.unsafeRead (nextAbove sights) c
  pure (Outlook (fromIntegral back) (fromIntegral front) (fromIntegral above))
{-# INLINE outlookFrom #-}

-- | A corner that passes a vertex, with what it sees just before and just after.
data Passage = Passage !Int !Outlook !Outlook

-- | Turns the lines of a vertex's corners through it, and tells of their passage, in their order along the line.
--
-- /Cost/ O(1) per elementary pair.
passing :: Scene -> Changing s -> Vertex -> ([Passage] -> ST s a) -> ST s a
passing scene sights vertex told = case vertex of
  -- What happens most often has a way of its own: where it is known what is told, it needs no list.
  Vertex (CornerId p) (CornerId q) [] | not (hasSplitEnds scene) -> do
    beforeP <- look p
    beforeQ <- look q
    landing scene p q (frontOf sights)
    turnBack scene sights p q
    afterP <- look p
    afterQ <- look q
    told [Passage p beforeP afterP, Passage q beforeQ afterQ]
  _ -> do
    before <- mapM look line
    let pairs = vertexPairs scene vertex
    forM_ (reverse pairs) $ \(CornerId p, CornerId q) -> landing scene p q (frontOf sights)
    forM_ pairs $ \(CornerId p, CornerId q) -> turnBack scene sights p q
    after <- mapM look line
    told (zipWith3 Passage line before after)
  where
    look = outlookFrom sights
    line = [c | CornerId c <- vertexCorners vertex]
{-# INLINE passing #-}

-- | Goes through a stream of vertices in pieces, lazily: something is told of each piece, and something is handed on
-- from piece to piece.
--
-- /Requires/ that the vertices are passed in their order, piece by piece. /Cost/ O(n log n) to begin with.
alongStream :: Scene -> (forall s. Changing s -> a -> piece -> ST s (a, b)) -> a -> [piece] -> [b]
alongStream scene told begin pieces = Lazy.runST $ do
  sights <- Lazy.strictToLazyST (traverse U.thaw (startSights scene))
  let go _ [] = pure []
      go handed (piece : rest) = do
        (handed', found) <- Lazy.strictToLazyST (told sights handed piece)
        (found :) <$> go handed' rest
  go begin pieces
{-# INLINE alongStream #-}

-- | Turns the backward ray of the second corner of a pair, and the sides between the two.
turnBack :: Scene -> Changing s -> Int -> Int -> ST s ()
turnBack scene sights !p !q = do
  landing scene q p (backOf sights)
  when (following scene p == q) (M.unsafeModify (nextAbove sights) (1 -) p)
  when (following scene q == p) (M.unsafeModify (nextAbove sights) (1 -) q)
{-# INLINE turnBack #-}

-- | Writes what p's ray towards q meets once it has turned left past q: the solid if the side from p to q is one of an
-- obstacle, a side of q that stands in the way, or what q sees itself.
landing :: Scene -> Int -> Int -> M.MVector s Int32 -> ST s ()
landing scene !p !q objects
  | following scene p == q, preceding scene p /= q = M.unsafeWrite objects p (fromIntegral solid)
  | x /= p, turn (scenePoints scene) p q x == LeftTurn = M.unsafeWrite objects p (fromIntegral x)
  | otherwise = M.unsafeRead objects q >>= M.unsafeWrite objects p
  where
    x = preceding scene q
