{-# LANGUAGE BangPatterns #-}

-- | The start of the sweep: what each corner sees along the vertical, by a plane sweep; and from that its first targets.
--
-- Targets are written for a heading. Seen by 'Leftward' the scene is turned by 180°: right is left, above is below, while
-- turns stay what they are. So the left-going half of the sweep is the same code on the same tables.
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
  , floorsFor
  , firstTargets
    -- * Its states
  , Crossing (..)
  , freeAbove
  , freeBelow
  , beyondAll
  , slabs
  ) where

import Control.Applicative ((<|>))
import Control.Monad (forM_, when)
import Control.Monad.ST (ST, runST)
import Data.Int (Int32)
import Data.List (sortBy)
import Data.Set (Set)
import qualified Data.Set as Set
import qualified Data.Set.Internal as Set (Set (..), link, merge)
import qualified Data.Vector as V
import qualified Data.Vector.Mutable as Boxed
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Law (broken)
import Visibility.Exact.Predicate
import Visibility.Scene

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

-- | A side that crosses the vertical, from its left end to its right one. Both sides of a thin wall are one crossing.
data Crossing = Crossing !Int !Int

-- | The side of a crossing that is free above it, or 'solid'.
--
-- Sides keep their solid on the left: one that leads forward has free space below it, one that leads back has it
-- above. A thin wall has a side of each kind.
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

-- | The situation at the start of the half turn, for all corners.
--
-- /Cost/ O(n log n) time, O(n) memory.
--
-- /Source/ the start of the horizon trees, Rivière; the sky in place of a bounding box is this project's.
verticalSweep :: Scene -> Vertical
verticalSweep scene = runST $ do
  floors' <- column
  ceilings' <- column
  visitPlaces scene (const (pure ())) $ \p floor' ceiling' -> do
    M.unsafeWrite floors' p (fromIntegral floor')
    M.unsafeWrite ceilings' p (fromIntegral ceiling')
  Vertical <$> U.unsafeFreeze floors' <*> U.unsafeFreeze ceilings'
  where
    column :: ST s (M.MVector s Int32)
    column = M.new (cornerCount scene)

-- | By corner: the corner at the far end of its elementary pair of least slope that leaves forward, 'solid' where its
-- forward rays are solid, 'skyCode' where there is no such corner and it sees the sky.
--
-- For each floor the convex chain of corners seen above it is kept while corners are visited against the heading: nearest
-- first, down to the end of the floor. By floor the first node, by node the next; the nodes are p for the corner p, and
-- n + p for p as the end of a floor.
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
      let !under = fromIntegral (below U.! p)
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
    below = floorsFor heading vertical
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

-- | The sides that a vertical meets, from below upwards: entry k for the verticals between the corners k − 1 and k,
-- from before all corners, entry 0, to behind them, entry n. Each is found by asking of sides whether they lie below
-- a point.
--
-- /Cost/ O(n log n) time and memory: the sets share most of their nodes.
slabs :: Scene -> V.Vector (Set Crossing)
slabs scene = V.create $ do
  table <- Boxed.replicate (n + 1) Set.empty
  visitPlaces scene (\(from, to, crossing) -> forM_ [from .. to] $ \p -> Boxed.write table (p + 1) crossing) $
    \_ _ _ -> pure ()
  pure table
  where
    n = cornerCount scene

-- Note [The plane sweep]
-- ~~~~~~~~~~~~~~~~~~~~~~
-- What is carried from place to place: the sides that the vertical meets, from below upwards, in a balanced tree in
-- which a place is found by asking of sides whether they lie below a corner, and which is cut and joined there; its
-- elements are never compared with each other, for an order of theirs would hold at one vertical only.

-- | Visits the places of corners from left to right and keeps the sides that cross the vertical. Tells for each place
-- the first and the last corner there and the sides that cross the vertical after it; and for each corner what it meets
-- downwards and upwards.
--
-- /Degenerate cases/ corners on one vertical are visited in the order of their ids, like all others. Of the corners in
-- one place, at most one sees down and at most one sees up: those whose cones contain these directions.
--
-- /Cost/ O(n log n).
visitPlaces
  :: Scene
  -> ((Int, Int, Set Crossing) -> ST s ())
  -> (Int -> Int -> Int -> ST s ())
  -> ST s ()
visitPlaces scene visited found = visit Set.empty 0
  where
    visit !crossing !x
      | x >= n = pure ()
      | otherwise = do
          let y = lastHere x
              here = [x .. y]
              ending = length [() | p <- here, q <- neighbours p, q < p]
              starting = upwards' [Crossing p q | p <- here, q <- neighbours p, p < q]
              Meeting below above crossing' = crossed ending starting x crossing
              floorSide = maybe beyond (freeAbove scene) below
              ceilingSide = maybe beyond (freeBelow scene) above
          forM_ here $ \p -> do
            let (seesDown, seesUp) = verticals p
            found p (if seesDown then floorSide else solid) (if seesUp then ceilingSide else solid)
          visited (x, y, crossing')
          visit crossing' (y + 1)
    n = cornerCount scene
    beyond = beyondAll scene
    -- The last corner in the place of this one.
    lastHere x
      | x + 1 < n && samePlace scene (CornerId x) (CornerId (x + 1)) = lastHere (x + 1)
      | otherwise = x

    next = following scene
    previous = preceding scene
    turnOf = turn (scenePoints scene)
    endsAt x (Crossing _ b) = b == x || samePlace scene (CornerId b) (CornerId x)
    isBelow x (Crossing a b) = turnOf a b x == LeftTurn

    crossed count starting x crossing = case starting of
      [side] | count == 1, Just replaced <- passing (endsAt x) (isBelow x) side crossing -> replaced
      _
        | count /= Set.size ending -> broken "status of the plane sweep" ("at corner " <> show x)
        | otherwise -> Meeting (Set.lookupMax below) (Set.lookupMin above) $ case starting of
            [] -> Set.merge below above
            side : others -> Set.link side below (foldr (`Set.link` Set.empty) above others)
      where
        (below, from) = Set.spanAntitone (isBelow x) crossing
        (ending, above) = Set.spanAntitone (endsAt x) from

    neighbours p = if next p == previous p then [next p] else [next p, previous p]
    -- Sides that start at one place, from the lowest to the uppermost. Of the two faces of one piece of a wall the lower
    -- one, which has free space on its right, comes first.
    upwards' [] = []
    upwards' [side] = [side]
    upwards' starting = sortBy order starting
      where
        order (Crossing a b) (Crossing _ d) = case turnOf a b d of
          LeftTurn -> LT
          RightTurn -> GT
          Collinear -> if next a == b then LT else GT
    -- Does the cone of a corner hold the direction down, and that up?
    verticals p = case (previous p < p, next p < p) of
      (True, False) -> (True, False)
      (False, True) -> (False, True)
      _ -> let around = turnOf p (previous p) (next p) /= LeftTurn in (around, around)
{-# INLINE visitPlaces #-}

-- | What a vertical meets at a place: the sides just below and just above it, and all sides after it.
data Meeting = Meeting !(Maybe Crossing) !(Maybe Crossing) !(Set Crossing)

-- | Puts a side in the place of the one that ends at the place, if one only does; so the tree keeps its shape.
--
-- /Cost/ O(log n).
passing :: (Crossing -> Bool) -> (Crossing -> Bool) -> Crossing -> Set Crossing -> Maybe Meeting
passing ends below side = go Nothing Nothing
  where
    go _ _ Set.Tip = Nothing
    go !low !high (Set.Bin size c l r)
      | ends c = Just (Meeting (Set.lookupMax l <|> low) (Set.lookupMin r <|> high) (Set.Bin size side l r))
      | below c = fmap (\(Meeting b a r') -> Meeting b a (Set.Bin size c l r')) (go (Just c) high r)
      | otherwise = fmap (\(Meeting b a l') -> Meeting b a (Set.Bin size c l' r)) (go low (Just c) l)
