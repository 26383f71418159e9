{-# LANGUAGE BangPatterns #-}

-- | The start of the sweep: what each corner sees along the vertical, by a plane sweep; and from that its first
-- targets.
--
-- Targets are written for a heading. Seen by 'Leftward' the scene is turned by 180°: right is left, above is below,
-- while turns stay what they are. So the left-going half of the sweep is the same code on the same tables.
--
-- Verticals need no care: order is lexicographic, which is the same as turning the scene by an infinitely small angle
-- to the right.
module Visibility.Sweep.Vertical
  ( -- * Headings
    Heading (..)
  , before
  , along
  , following
  , preceding
    -- * Codes in tables
  , solid
  , skyCode
  , objectOf
  , objectAt
    -- * The plane sweep
  , Vertical (..)
  , verticalSweep
  , firstTargets
  ) where

import Control.Monad (forM_, unless, when)
import Control.Monad.ST (ST, runST)
import Data.Int (Int32)
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.Predicate
import Visibility.Law (broken)
import Visibility.Scene
import Visibility.Scene.Scan

-- | Which way a sweep's rays go along the line.
data Heading = Rightward | Leftward
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | Does the first corner come before the second, seen by the heading?
before :: Heading -> Int -> Int -> Bool
before Rightward a b = a < b
before Leftward a b = a > b
{-# INLINE before #-}

-- | All indices below n in the order of the heading.
along :: Heading -> Int -> [Int]
along Rightward n = [0 .. n - 1]
along Leftward n = [n - 1, n - 2 .. 0]

-- | In a table of objects: no free ray.
solid :: Int
solid = -1

-- | In a table of objects of a scene with n corners: the sky. Sides have their own numbers.
skyCode :: Scene -> Int
skyCode = cornerCount

-- | What a number in a table of objects stands for, 'Nothing' for 'solid'.
objectOf :: Scene -> Int -> Maybe Object
objectOf scene code
  | code == solid = Nothing
  | otherwise = Just (objectAt scene code)
{-# INLINE objectOf #-}

-- | The same of a number that does not stand for 'solid'.
objectAt :: Scene -> Int -> Object
objectAt scene code = if code == skyCode scene then Sky else Side (SideId code)
{-# INLINE objectAt #-}

-- | The situation at the start of the half turn.
data Vertical = Vertical
  { floors :: !(U.Vector Int32)
  -- ^ By corner: the object met by its downward ray, or 'solid'.
  , ceilings :: !(U.Vector Int32)
  -- ^ By corner: the object met by its upward ray, or 'solid'.
  }
  deriving (Eq, Show)

-- | What is below each corner as a heading sees it.
floorsFor :: Heading -> Vertical -> U.Vector Int32
floorsFor heading = case heading of
  Rightward -> floors
  Leftward -> ceilings

-- | The side of a segment that is free above it, or 'solid'.
--
-- Sides keep their solid on the left: one that leads forward has free space below it, one that leads back has it
-- above. A thin wall of one piece has a side of each kind.
freeAbove :: Scene -> Segment -> Int
freeAbove scene (Segment a b) = if following scene b == a then b else solid

-- | The side of a segment that is free below it, or 'solid'.
freeBelow :: Scene -> Segment -> Int
freeBelow scene (Segment a b) = if following scene a == b then a else solid

-- | The corners at the other ends of the two sides of a corner.
following, preceding :: Scene -> Int -> Int
following scene p = let CornerId q = nextCorner scene (CornerId p) in q
preceding scene p = let CornerId q = previousCorner scene (CornerId p) in q
{-# INLINE following #-}
{-# INLINE preceding #-}

-- | What lies above and below all sides: the sky, or 'solid' in a room.
beyondAll :: Scene -> Int
beyondAll scene = case surroundings scene of
  OpenSky -> skyCode scene
  Room -> solid

-- | The situation at the start of the half turn, for all corners, by a plane sweep from left to right.
--
-- /Degenerate cases/ corners on one vertical are visited in the order of their ids, like all others. Of the corners in
-- one place, at most one sees down and at most one sees up: those whose cones contain these directions.
--
-- /Cost/ O(n log n) time, O(n) memory.
--
-- /Source/ the start of the horizon trees, Rivière; the sky in place of a bounding box is this project's.
verticalSweep :: Scene -> Vertical
verticalSweep scene = runST $ do
  floors' <- M.new n
  ceilings' <- M.new n
  let
    told scan () (Place x size low high _) onward = do
      ordered scan low high x
      forM_ [x .. x + size - 1] $ \p -> do
        let (seesDown, seesUp) = verticals scene p
        if seesDown then sideOf scan freeAbove low >>= put floors' p else put floors' p solid
        if seesUp then sideOf scan freeBelow high >>= put ceilings' p else put ceilings' p solid
      onward ()
    {-# INLINE told #-}
    -- Unsafe arithmetic may get the sides out of order.
    ordered scan low high x = do
      isAbove <- if low == noSlot then pure True else not <$> isUnder plane scan x low
      isBelow <- if high == noSlot then pure True else isUnder plane scan x high
      unless (isAbove && isBelow) $
        broken "the sides that a vertical meets are in order" ("at corner " <> show x)
    sideOf scan part s = if s == noSlot then pure (beyondAll scene) else part scene <$> sideIn scan s
  scanning plane told ()
  Vertical <$> U.unsafeFreeze floors' <*> U.unsafeFreeze ceilings'
  where
    n = cornerCount scene
    put :: M.MVector s Int32 -> Int -> Int -> ST s ()
    put table k value = M.write table k (fromIntegral value)
    plane =
      Plane
        { planePoints = scenePoints scene
        , cornerTotal = n
        , cornerScanned = id
        , cornersHere = \x -> 1 + length (takeWhile (samePlace scene (CornerId x) . CornerId) [x + 1 .. n - 1])
        , joinedCorners = \p -> (following scene p, preceding scene p)
        , isInLaterPlace = \p q -> q > p && not (samePlace scene (CornerId p) (CornerId q))
        , reaches = \(Segment _ b) p -> samePlace scene (CornerId b) (CornerId p)
        , isLowerFace = \(Segment a b) -> following scene a == b
        }

-- | Does the cone of a corner hold the direction down, and that up?
verticals :: Scene -> Int -> (Bool, Bool)
verticals scene p = case (before' < p, after < p) of
  (True, False) -> (True, False)
  (False, True) -> (False, True)
  _ -> let around = turn (scenePoints scene) p before' after /= LeftTurn in (around, around)
  where
    before' = preceding scene p
    after = following scene p

-- | By corner: the corner at the far end of its elementary pair of least slope that leaves forward, 'solid' where its
-- forward rays are solid, 'skyCode' where there is no such corner and it sees the sky.
--
-- For each floor the convex chain of corners seen above it is kept while corners are visited against the heading:
-- nearest first, down to the end of the floor. By floor the first node, by node the next; the nodes are p for the
-- corner p, and n + p for p as the end of a floor.
--
-- /Degenerate cases/ corners collinear with p on a chain stay, so that the first target is the nearest. Of two faces of
-- one piece of a wall the lower one, which has free space on its right, comes first.
--
-- /Requires/ the floors of the scene. /Cost/ O(n).
firstTargets :: Scene -> Heading -> Vertical -> U.Vector Int32
firstTargets scene heading vertical = U.create $ do
  targets <- M.new n
  heads <- M.replicate (n + 1) nowhere
  nexts <- M.replicate (2 * n) nowhere
  let
    -- The chain without the corners that the tangent from p leaves out.
    tangentChain !p !a
      | a == nowhere = pure a
      | otherwise = do
          b <- M.unsafeRead nexts (fromIntegral a)
          if b /= nowhere && turnOf p (cornerOf a) (cornerOf b) == RightTurn then tangentChain p b else pure a
    visit !p = do
      let !under = fromIntegral (underneath U.! p)
          !q = following scene p
      if under == solid
        then M.unsafeWrite targets p (fromIntegral (lowestSide p))
        else do
          chain <- M.unsafeRead heads under >>= tangentChain p
          M.unsafeWrite targets p (if chain == nowhere then fromIntegral n else fromIntegral (cornerOf chain))
          M.unsafeWrite nexts p chain
          M.unsafeWrite heads under (fromIntegral p)
      -- The side from p back to q is met from here on, free above it.
      when (before heading q p) $ M.unsafeWrite heads p (fromIntegral (n + p))
  case heading of
    Rightward -> forM_ [1 .. n] $ \k -> visit (n - k)
    Leftward -> forM_ [0 .. n - 1] visit
  pure targets
  where
    n = cornerCount scene
    underneath = floorsFor heading vertical
    nowhere = -1 :: Int32
    cornerOf node = let k = fromIntegral node in if k < n then k else k - n
    turnOf = turn (scenePoints scene)
    lowestSide p = case (before heading p next, before heading p previous) of
      (True, True) -> if turnOf p next previous == RightTurn then previous else next
      (True, False) -> next
      (False, True) -> previous
      (False, False) -> solid
      where
        next = following scene p
        previous = preceding scene p
