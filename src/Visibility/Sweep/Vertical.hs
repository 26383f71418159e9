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
    -- * Codes in tables
  , solid
  , skyCode
  , objectOf
    -- * The plane sweep
  , Vertical (..)
  , verticalSweep
  , firstTargets
    -- * Its states
  , Crossing (..)
  , freeAbove
  , freeBelow
  , beyondAll
  , cornersFrom
  , startingSides
  ) where

import Control.Monad (foldM, forM_, unless, when)
import Control.Monad.ST (ST, runST)
import Data.Int (Int32)
import qualified Data.IntSet as IntSet
import Data.List (sortBy)
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.Predicate
import Visibility.Law (broken)
import Visibility.Scene
import Visibility.Scene.Status

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
  | code == skyCode scene = Just Sky
  | otherwise = Just (Side (SideId code))
{-# INLINE objectOf #-}

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

-- | A side that crosses the vertical, from its left end to its right one. The two sides of a thin wall of one piece are
-- one crossing; the two faces of a piece of a longer one are two, in one place.
data Crossing = Crossing !Int !Int

-- | The side of a crossing that is free above it, or 'solid'.
--
-- Sides keep their solid on the left: one that leads forward has free space below it, one that leads back has it
-- above. A thin wall of one piece has a side of each kind.
freeAbove :: Scene -> Crossing -> Int
freeAbove scene (Crossing a b) = if following scene b == a then b else solid

-- | The side of a crossing that is free below it, or 'solid'.
freeBelow :: Scene -> Crossing -> Int
freeBelow scene (Crossing a b) = if following scene a == b then a else solid

following, preceding :: Scene -> Int -> Int
following scene p = let CornerId q = nextCorner scene (CornerId p) in q
preceding scene p = let CornerId q = previousCorner scene (CornerId p) in q
{-# INLINE following #-}
{-# INLINE preceding #-}

-- | What lies above and below all crossings: the sky, or 'solid' in a room.
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
  -- The sides that the vertical meets, from below upwards, each in a slot.
  status <- newStatus n
  -- Of slot s, the ends of its side at 2s and 2s + 1.
  ends <- M.new (2 * n)
  -- The slots of the sides that end at corner c, at 2c and 2c + 1.
  arrivals <- M.replicate (2 * n) (fromIntegral noSlot)
  let
    -- The slots from a number on are not in use yet.
    visit !x !unused
      | x >= n = pure ()
      | otherwise = do
          s <- get arrivals (2 * x)
          t <- get arrivals (2 * x + 1)
          let later = max (following scene x) (preceding scene x)
          -- What happens most often has a way of its own, without lists: a side takes the slot of another.
          if s /= noSlot && t == noSlot && later > x && isLast x
            then do
              occupy s (Crossing x later)
              low <- below status s
              high <- above status s
              ordered low high x
              seen low high x
              visit (x + 1) unused
            else do
              let here = cornersFrom scene x
                  starting = startingSides scene here
              (low, high) <- concat <$> mapM arriving here >>= gap x
              ordered low high x
              filled low high unused starting
              mapM_ (seen low high) here
              visit (x + length here) (unused + length starting)

    -- Unsafe arithmetic may get the sides out of order.
    ordered low high x = do
      isAbove <- if low == noSlot then pure True else isUnder x low
      isBelow <- if high == noSlot then pure True else not <$> isUnder x high
      unless (isAbove && isBelow) $ disordered x
    disordered x = broken "the sides that a vertical meets are in order" ("at corner " <> show x)
    isUnder x s = (\(Crossing a b) -> turn (scenePoints scene) a b x == LeftTurn) <$> sideIn s

    isLast x = x + 1 >= n || not (samePlace scene (CornerId x) (CornerId (x + 1)))

    -- What a corner sees between two slots.
    seen low high p = do
      let (seesDown, seesUp) = verticals scene p
      if seesDown then sideOf freeAbove low >>= put floors' p else put floors' p solid
      if seesUp then sideOf freeBelow high >>= put ceilings' p else put ceilings' p solid

    -- The slots around a place, when those that end there have been taken out.
    gap x [] = lookupGap status (isUnder x)
    gap x slots = do
      let ending = IntSet.fromList slots
      lows <- filter (`IntSet.notMember` ending) <$> mapM (below status) slots
      case lows of
        [_] -> foldM (\_ s -> remove status s) (noSlot, noSlot) slots
        _ -> disordered x

    filled _ _ _ [] = pure ()
    filled low high s (side : others) = do
      occupy s side
      insertBetween status low high s
      filled s high (s + 1) others

    occupy s (Crossing a b) = do
      put ends (2 * s) a
      put ends (2 * s + 1) b
      first <- get arrivals (2 * b)
      put arrivals (if first == noSlot then 2 * b else 2 * b + 1) s

    arriving c = do
      s <- get arrivals (2 * c)
      t <- get arrivals (2 * c + 1)
      pure (filter (/= noSlot) [s, t])

    sideIn s = Crossing <$> get ends (2 * s) <*> get ends (2 * s + 1)
    sideOf part s = if s == noSlot then pure (beyondAll scene) else part scene <$> sideIn s
  visit 0 0
  Vertical <$> U.unsafeFreeze floors' <*> U.unsafeFreeze ceilings'
  where
    n = cornerCount scene
    get :: M.MVector s Int32 -> Int -> ST s Int
    get table k = fromIntegral <$> M.read table k
    put :: M.MVector s Int32 -> Int -> Int -> ST s ()
    put table k value = M.write table k (fromIntegral value)

-- | The corners in the place of one, which is the first of them.
cornersFrom :: Scene -> Int -> [Int]
cornersFrom scene x = x : [c | c <- takeWhile isHere [x + 1 .. cornerCount scene - 1]]
  where
    isHere c = samePlace scene (CornerId x) (CornerId c)

-- | The sides that start at corners of one place, seen from the left, from the lowest to the uppermost. Of the two
-- faces of one piece of a wall the lower one, which has free space on its right, comes first.
startingSides :: Scene -> [Int] -> [Crossing]
startingSides scene here = case [Crossing p q | p <- here, q <- neighbours p, p < q] of
  found@(_ : _ : _) -> sortBy order found
  found -> found
  where
    neighbours p
      | following scene p == preceding scene p = [following scene p]
      | otherwise = [following scene p, preceding scene p]
    order (Crossing a b) (Crossing _ d) = case turn (scenePoints scene) a b d of
      LeftTurn -> LT
      RightTurn -> GT
      Collinear -> if following scene a == b then LT else GT

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
