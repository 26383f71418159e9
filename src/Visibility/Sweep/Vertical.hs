{-# LANGUAGE BangPatterns #-}

-- | The start of the sweep: what each corner sees along the vertical, and its first target, by a plane sweep.
--
-- Everything is written for a heading. Seen by 'Leftward' the scene is turned by 180°: right is left, above is below,
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
import Data.List (sortBy)
import Data.Maybe (fromMaybe, listToMaybe)
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

-- | The situation at the start of the half turn, seen by a heading.
data Vertical = Vertical
  { floors :: !(U.Vector Int)
  -- ^ By corner: the object met by its downward ray, or 'solid'.
  , ceilings :: !(U.Vector Int)
  -- ^ By corner: the object met by its upward ray, or 'solid'.
  , firstTargets :: !(U.Vector Int)
  -- ^ By corner: the corner at the far end of its elementary pair of least slope that leaves forward, −1 where its
  -- forward rays are solid, n where there is no such corner and it sees the sky.
  }
  deriving (Eq, Show)

-- | A side that crosses the vertical, from its end that comes first by the heading to the other. Both sides of a thin
-- wall are one crossing.
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

following :: Scene -> Int -> Int
following scene p = let CornerId q = nextCorner scene (CornerId p) in q
{-# INLINE following #-}

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
verticalSweep :: Scene -> Heading -> Vertical
verticalSweep scene heading = runST $ do
  floors' <- column
  ceilings' <- column
  targets <- column
  visitPlaces scene heading (const (pure ())) $ \p floor' ceiling' target' -> do
    M.unsafeWrite floors' p floor'
    M.unsafeWrite ceilings' p ceiling'
    M.unsafeWrite targets p target'
  Vertical <$> U.unsafeFreeze floors' <*> U.unsafeFreeze ceilings' <*> U.unsafeFreeze targets
  where
    column :: ST s (M.MVector s Int)
    column = M.replicate (cornerCount scene) solid

-- | The sides that a vertical meets, from below upwards: entry k for the verticals between the corners k − 1 and k,
-- from before all corners, entry 0, to behind them, entry n. Each is found by asking of sides whether they lie below
-- a point.
--
-- /Cost/ O(n log n) time and memory: the sets share most of their nodes.
slabs :: Scene -> V.Vector (Set Crossing)
slabs scene = V.create $ do
  table <- Boxed.replicate (n + 1) Set.empty
  visitPlaces scene Rightward (\(from, to, crossing) -> forM_ [from .. to] $ \p -> Boxed.write table p crossing) $
    \_ _ _ _ -> pure ()
  pure table
  where
    n = cornerCount scene

-- Note [The plane sweep]
-- ~~~~~~~~~~~~~~~~~~~~~~
-- What is carried from place to place: the sides that the vertical meets, from below upwards, in a balanced tree in
-- which a place is found by asking of sides whether they lie below a corner, and which is cut and joined there; its
-- elements are never compared with each other, for an order of theirs would hold at one vertical only. And for each
-- floor the convex chain of corners seen above it so far, nearest first, down to the end of the floor: by floor the
-- first node, by node the next. The nodes are p for the corner p, and n + p for p as the end of a floor.

-- | Visits the places of corners against the heading and keeps the sides that cross the vertical. Tells for each place
-- the first and the last corner there and the sides that cross the vertical after it; and for each corner what it meets
-- downwards and upwards, and its first target.
--
-- /Degenerate cases/ corners on one vertical are visited in the order of their ids, like all others. Corners collinear
-- with p on a chain stay, so that the first target is the nearest. Of the corners in one place, at most one sees down
-- and at most one sees up: those whose cones contain these directions.
--
-- /Cost/ O(n log n) for the tree, O(n) for the chains.
visitPlaces
  :: Scene
  -> Heading
  -> ((Int, Int, Set Crossing) -> ST s ())
  -> (Int -> Int -> Int -> Int -> ST s ())
  -> ST s ()
visitPlaces scene heading visited found = do
  heads <- M.replicate (n + 1) nowhere
  nexts <- M.replicate (2 * n) nowhere
  let
    visit !crossing !x
      | x < 0 || x >= n = pure ()
      | otherwise = do
          let y = lastHere x
              here = if y == x then [x] else [min x y .. max x y]
              arriving = upwards' RightTurn [(q, p) | p <- here, q <- neighbours p, before heading q p]
              leaving = upwards' LeftTurn [(p, q) | p <- here, q <- neighbours p, before heading p q]
              Meeting below above crossing' = crossed leaving (map (uncurry Crossing) arriving) x crossing
              floorSide = maybe beyond (freeAbove scene) below
              ceilingSide = maybe beyond (freeBelow scene) above
          chain <- if floorSide == solid then pure nowhere else M.unsafeRead heads floorSide >>= tangentChain x
          forM_ here $ \p -> do
            let (seesDown, seesUp) = verticals p
                target
                  | seesDown = if chain == nowhere then sky else cornerOf chain
                  | otherwise = fromMaybe solid (listToMaybe [q | (p', q) <- leaving, p' == p])
            found p (if seesDown then floorSide else solid) (if seesUp then ceilingSide else solid) target
            when (seesDown && floorSide /= solid) $ M.unsafeWrite nexts p chain >> M.unsafeWrite heads floorSide p
          forM_ leaving $ \(p, q) -> chainOf (Crossing p q) nowhere
          forM_ arriving $ \(q, p) -> chainOf (Crossing q p) (n + p)
          visited (min x y, max x y, crossing')
          visit crossing' (onwards y)

    chainOf side node = let s = freeAbove scene side in when (s /= solid) $ M.unsafeWrite heads s node

    -- The chain without the corners that the tangent from p leaves out; collinear ones stay.
    tangentChain p a
      | a == nowhere = pure a
      | otherwise = do
          b <- M.unsafeRead nexts a
          if b /= nowhere && turnOf p (cornerOf a) (cornerOf b) == RightTurn then tangentChain p b else pure a
  visit Set.empty (case heading of Rightward -> n - 1; Leftward -> 0)
  where
    n = cornerCount scene
    nowhere = -1
    sky = skyCode scene
    beyond = beyondAll scene
    cornerOf node = if node < n then node else node - n
    onwards = case heading of
      Rightward -> subtract 1
      Leftward -> (+ 1)
    -- The last corner to be visited in the place of this one.
    lastHere x
      | y >= 0 && y < n && samePlace scene (CornerId x) (CornerId y) = lastHere y
      | otherwise = x
      where
        y = onwards x

    next = following scene
    previous p = let CornerId q = previousCorner scene (CornerId p) in q
    turnOf = turn (scenePoints scene)
    endsAt x (Crossing a _) = a == x || samePlace scene (CornerId a) (CornerId x)
    isBelow x (Crossing a b) = turnOf a b x == LeftTurn

    crossed leaving arriving x crossing = case (leaving, arriving) of
      ([_], [side]) | Just replaced <- passing (endsAt x) (isBelow x) side crossing -> replaced
      _
        | length leaving /= Set.size ending -> broken "status of the plane sweep" ("at corner " <> show x)
        | otherwise -> Meeting (Set.lookupMax below) (Set.lookupMin above) $ case arriving of
            [] -> Set.merge below above
            side : others -> Set.link side below (foldr (`Set.link` Set.empty) above others)
      where
        (below, from) = Set.spanAntitone (isBelow x) crossing
        (ending, above) = Set.spanAntitone (endsAt x) from

    neighbours p = if next p == previous p then [next p] else [next p, previous p]
    -- Sides at one place, from the lowest to the uppermost, seen from their ends there: the first ends of those that
    -- arrive, for which lower means that the turn to the next one is to the right, or the second ends of those that
    -- leave. Of the two faces of one piece of a wall the lower one, which has free space on its right, comes first.
    upwards' _ [] = []
    upwards' _ [side] = [side]
    upwards' wanted sides' = sortBy order sides'
      where
        order (a, b) (c, d) = case wanted of
          RightTurn -> rank (turnOf b a c) <> faces (a, b) (c, d)
          _ -> rank (turnOf a b d) <> faces (a, b) (c, d)
        rank found'
          | found' == wanted = LT
          | found' == Collinear = EQ
          | otherwise = GT
        faces (a, b) _ = if next a == b then LT else GT
    -- Does the cone of a corner hold the direction down, and that up?
    verticals p = case (before heading (previous p) p, before heading (next p) p) of
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
