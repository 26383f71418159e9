{-# LANGUAGE BangPatterns #-}

-- | The topological sweep: every vertex of the visibility complex, once, in an order in which each corner's vertices
-- come by increasing direction.
--
-- A pure step from state to state. A state is an immutable value of O(n) numbers. 'vertices' makes the same steps in
-- place, on one state that nobody else sees, so that each costs O(1) and live memory is O(n) while the list is
-- consumed.
--
-- /Source/ Rivière, Topologically sweeping the visibility complex of polygonal scenes; Rafalin, Souvaine, Streinu for
-- taking all collinear corners in one step.
module Visibility.Sweep.Topological
  ( -- * The whole sweep
    vertices
  , verticesInPieces
    -- * Step by step
  , Sweep (..)
  , start
  , step
  , trace
  , finish
  , stepsTaken
  ) where

import Control.Monad (forM_, when)
import Control.Monad.ST (ST, runST)
import qualified Control.Monad.ST.Lazy as Lazy
import Data.Int (Int32)
import qualified Data.IntSet as IntSet
import Data.List (unfoldr)
import Data.Primitive.PrimArray
import qualified Data.Vector.Unboxed as U
import Visibility.Law (broken)
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Sweep.HorizonTree
import Visibility.Sweep.HorizonTree.Frame
import Visibility.Sweep.HorizonTree.Plant
import Visibility.Sweep.HorizonTree.Table
import Visibility.Sweep.Piece
import Visibility.Sweep.Vertex
import Visibility.Sweep.Vertical

-- | The state of the sweep: what has been swept is implied by the two trees.
data Sweep = Sweep
  { rightTree :: !Table
  -- ^ For each corner its next pair to the right.
  , leftTree :: !Table
  -- ^ For each corner its next pair to the left.
  , pending :: !(U.Vector Int32)
  -- ^ The corners at which a vertex may be ready, each once. Empty when the half turn is done.
  , isPending :: !(U.Vector Int32)
  -- ^ By corner: 1 where pending.
  , pairsSwept :: !Int
  -- ^ Elementary pairs so far.
  }
  deriving (Eq, Show)

-- | The state just above −90°. /Cost/ O(n log n).
start :: Scene -> Sweep
start scene = runST (begun (prepared scene) >>= \state -> stopped state (cornerCount scene) 0)

-- | All vertices of the complex, lazily. Which of the many topological orders it is depends on nothing but the scene.
--
-- /Degenerate cases/ all corners on a maximal free segment make one vertex, however many there are.
--
-- /Cost/ O(n log n) to start, then O(1) per elementary pair and chain step; O(n) live memory. Measured, there are about
-- three chain steps per pair; that there are O(m) is proved by Rivière for another scan of the chains, not for this
-- one.
--
-- /Laws/ the set equals that of brute force; @vertices s == unfoldr (step s) (start s)@. That no pair is left at the
-- end is asked each time.
vertices :: Scene -> [Vertex]
vertices = concatMap pieceVertices . verticesInPieces

-- | The vertices of a sweep in pieces of many vertices each, none of them empty. /Cost/ that of 'vertices'.
--
-- /Laws/ @concatMap pieceVertices (verticesInPieces s) == vertices s@.
verticesInPieces :: Scene -> [Piece]
verticesInPieces scene = Lazy.runST $ do
  state <- Lazy.strictToLazyST (begun (prepared scene))
  let onwards depth swept = Lazy.strictToLazyST (run state pieceSize depth swept) >>= go
      go (Progress size depth swept piece)
        | size == 0 = pure []
        | otherwise = (piece :) <$> onwards depth swept
  onwards (cornerCount scene) 0

-- | The state at the end of the half turn. /Cost/ that of 'vertices'.
finish :: Scene -> Sweep
finish scene = runST $ do
  state <- begun (prepared scene)
  let go (Progress size depth swept _)
        | size == 0 = stopped state depth swept
        | otherwise = run state pieceSize depth swept >>= go
  run state pieceSize (cornerCount scene) 0 >>= go

-- | How many vertices are swept at a time.
pieceSize :: Int
pieceSize = 1024

-- | The next vertex and the state after it, 'Nothing' at the end of the half turn. /Cost/ O(n), for copying the state.
step :: Scene -> Sweep -> Maybe (Vertex, Sweep)
step scene state = runST $ do
  running <- resumed (prepared scene) state
  Progress _ depth swept piece <- run running 1 (U.length (pending state)) (pairsSwept state)
  after <- stopped running depth swept
  pure $ case pieceVertices piece of
    [] -> Nothing
    vertex : _ -> Just (vertex, after)

-- | Every vertex with the state after it. /Cost/ O(n) per vertex.
trace :: Scene -> [(Vertex, Sweep)]
trace scene = unfoldr (fmap (\(vertex, state) -> ((vertex, state), state)) . step scene) (start scene)

-- | Chain steps of both trees: the work of the sweep besides O(1) per pair.
stepsTaken :: Scene -> Sweep -> Int
stepsTaken scene state = chainSteps scene (rightTree state) + chainSteps scene (leftTree state)

-- | A scene as the steps need it.
data Prepared = Prepared !Scene !Frame !Frame

prepared :: Scene -> Prepared
prepared scene = Prepared scene (frame tables Rightward) (frame tables Leftward)
  where
    tables = sceneTables scene

-- | The state while it changes: both trees; which corners are pending; a stack with the pending corners; and room for
-- the numbers of a piece.
data Running s
  = Running
      !Prepared
      !(Growing s)
      !(Growing s)
      !(MutablePrimArray s Int32)
      !(MutablePrimArray s Int32)
      !(MutablePrimArray s Int32)

-- | The state just above −90°, in which all corners are pending.
begun :: Prepared -> ST s (Running s)
begun known@(Prepared scene rightward leftward) = do
  right <- plant rightward (firstTargets scene Rightward vertical)
  left <- plant leftward (firstTargets scene Leftward vertical)
  waiting <- newPrimArray n
  setPrimArray waiting 0 n 1
  stack <- newPrimArray n
  forM_ [0 .. n - 1] $ \p -> writePrimArray stack p (fromIntegral p)
  Running known right left waiting stack <$> newPrimArray (roomFor scene pieceSize)
  where
    n = cornerCount scene
    vertical = verticalSweep scene

-- | How many numbers so many vertices may take: two corners each, or on some lines more, each corner of the scene once.
roomFor :: Scene -> Int -> Int
roomFor scene most = 2 * most + cornerCount scene

-- | A changeable copy of a state, for single steps.
resumed :: Prepared -> Sweep -> ST s (Running s)
resumed known@(Prepared scene _ _) state = do
  right <- thawed (rightTree state)
  left <- thawed (leftTree state)
  waiting <- copied (isPending state)
  stack <- copied (pending state)
  Running known right left waiting stack <$> newPrimArray (roomFor scene 1)
  where
    copied numbers = do
      copy <- newPrimArray (cornerCount scene)
      forM_ [0 .. U.length numbers - 1] $ \i -> writePrimArray copy i (numbers U.! i)
      pure copy

-- | The state as it is now, with the depth of its stack and the number of pairs swept. /Requires/ no change after it.
stopped :: Running s -> Int -> Int -> ST s Sweep
stopped (Running _ right left waiting stack _) depth swept = do
  right' <- frozen right
  left' <- frozen left
  waiting' <- unsafeFreezePrimArray waiting
  stack' <- unsafeFreezePrimArray stack
  let numbers count array = U.generate count (indexPrimArray array)
  pure (Sweep right' left' (numbers depth stack') (numbers (sizeofPrimArray waiting') waiting') swept)

-- | What has been done: the numbers written, the depth of the stack, the pairs swept since the start; and the vertices.
data Progress = Progress !Int !Int !Int !Piece

-- | Which of the two next pairs of a pending corner is looked at.
data Look = RightFirst | ThenLeft

-- | Takes corners off the stack until so many vertices have been swept; none only at the end.
run :: Running s -> Int -> Int -> Int -> ST s Progress
run (Running (Prepared scene rightward leftward) right left waiting stack written) !most !deep !before' = do
  let
    go !size !count !depth !swept
      | count <= 0 || depth <= 0 || size > room - n = pure (Progress size depth swept (pieceOf []))
      | swept > n * (n - 1) `div` 2 = broken "each elementary pair is swept once" (show swept)
      | otherwise = do
          top' <- readPrimArray stack (depth - 1)
          let !p = fromIntegral top'
          writePrimArray waiting p 0
          l <- getList right (target p)
          if isCornerList l
            then look RightFirst size count (depth - 1) swept p p (listOwner l)
            else lookLeft size count (depth - 1) swept p

    lookLeft !size !count !depth !swept !p = do
      l <- getList left (target p)
      if isCornerList l
        then look ThenLeft size count depth swept p (listOwner l) p
        else go size count depth swept

    -- Is there a vertex with the pair of a and b, one of which is p, that may be swept now? Each edge of its line is
    -- the next pair of both of its corners, and no other unswept pair at its ends has a lesser slope.
    look which !size !count !depth !swept !p !a !b
      | hasSplitEnds scene = readyTracks scene right left a b >>= maybe failed tracks
      | otherwise = do
          there <- getList right (target a)
          back <- getList left (target b)
          if there /= cornerList b || back /= cornerList a
            then failed
            else do
              ahead <- getList right (target b)
              case continuing rightward a b ahead of
                RightTurn -> failed
                onRight -> do
                  behind <- getList left (target a)
                  case continuing leftward b a behind of
                    RightTurn -> failed
                    LeftTurn | LeftTurn <- onRight -> pair
                    _ -> beyond leftward left right b a >>= onLine
      where
        failed = case which of
          RightFirst -> lookLeft size count depth swept p
          ThenLeft -> go size count depth swept
        pair = do
          writePrimArray written size (fromIntegral a)
          writePrimArray written (size + 1) (closing b)
          advance rightward right a
          advance leftward left b
          depth' <- push depth a >>= \d -> push d b
          go (size + 2) (count - 1) depth' (swept + 1)
        -- More than two corners, the first of them at the given one.
        onLine Wait = failed
        onLine (Further leftmost _) = do
          found <- beyond rightward right left leftmost leftmost
          case found of
            Wait -> failed
            Further _ more -> do
              let k = more + 1
              follow size leftmost k
              sweepLine rightward right written (k - 1) size 1
              sweepLine leftward left written (k - 1) (size + k - 1) (-1)
              finished k (k - 1)
        tracks line = do
          let k = length line
              pairs = maybe [] (vertexPairs scene) (fromCorners (map CornerId line))
              m = length pairs
          forM_ (zip [size ..] line) $ \(i, c) -> writePrimArray written i (fromIntegral c)
          sources <- newPrimArray m
          targets <- newPrimArray m
          forM_ (zip [0 ..] pairs) $ \(i, (CornerId c, CornerId d)) -> do
            writePrimArray sources i (fromIntegral c)
            writePrimArray targets i (fromIntegral d)
          sweepLine rightward right sources m 0 1
          sweepLine leftward left targets m (m - 1) (-1)
          finished k m
        -- A vertex of k corners and m pairs has been swept and written.
        finished k m = do
          depth' <- pushAll depth size (size + k)
          lastCorner <- readPrimArray written (size + k - 1)
          writePrimArray written (size + k - 1) (closing (fromIntegral lastCorner))
          go (size + k) (count - 1) depth' (swept + m)

    follow !i !c !k
      | k <= 0 = pure ()
      | otherwise = do
          writePrimArray written i (fromIntegral c)
          l <- getList right (target c)
          follow (i + 1) (listOwner l) (k - 1 :: Int)

    pushAll !depth !i !end
      | i >= end = pure depth
      | otherwise = do
          p <- readPrimArray written i
          depth' <- push depth (fromIntegral p)
          pushAll depth' (i + 1) end

    push !depth !p = do
      already <- readPrimArray waiting p
      if already == 1
        then pure depth
        else do
          writePrimArray waiting p 1
          writePrimArray stack depth (fromIntegral p)
          pure (depth + 1)

  Progress size depth swept _ <- go 0 most deep before'
  when (size == 0) finished'
  found <- newPrimArray size
  copyMutablePrimArray found 0 written 0 size
  Progress size depth swept . Piece <$> unsafeFreezePrimArray found
  where
    n = cornerCount scene
    room = roomFor scene most
    -- Unsafe arithmetic may stop before the end, with pairs that are never swept.
    finished' = forM_ [0 .. n - 1] $ \p -> do
      ahead <- getList right (target p)
      behind <- getList left (target p)
      when (isCornerList ahead) $ isLater p (listOwner ahead)
      when (isCornerList behind) $ isLater (listOwner behind) p
    isLater a b = broken "the sweep goes on to the end of its range" (show (a, b))

-- | The turn at b from the line from a to the next pair of b in the same heading: left if there is none.
continuing :: Frame -> Int -> Int -> List -> Turn
continuing f !a !b !l
  | isCornerList l = turnIn f a b (listOwner l)
  | otherwise = LeftTurn
{-# INLINE continuing #-}

-- | All corners of the line of p and q, in order, if it is a vertex that may be swept now; where it runs along both
-- faces of a wall, the pairs at a free end of the wall come one after the other, but are swept together.
--
-- /Cost/ O(log k) for each of k corners.
readyTracks :: Scene -> Growing s -> Growing s -> Int -> Int -> ST s (Maybe [Int])
readyTracks scene right left !p !q = fmap IntSet.toAscList <$> go [p] (IntSet.singleton p)
  where
    points = scenePoints scene
    go [] line = pure (Just line)
    go (c : rest) line = do
      ahead <- neighboursOn right left LeftTurn c
      behind <- neighboursOn left right RightTurn c
      case (<>) <$> ahead <*> behind of
        Nothing -> pure Nothing
        Just found ->
          let more = filter (`IntSet.notMember` line) found
           in go (more <> rest) (foldr IntSet.insert line more)
    -- The corners next to c on the line in the direction of a tree, the other one being the opposite one; nothing if
    -- something else must be swept first. The first turn is that to corners that are to be swept later.
    neighboursOn tree other later c = do
      l <- getList tree (target c)
      let d = listOwner l
      if not (isCornerList l)
        then pure (Just [])
        else case turn points p q d of
          Collinear -> do
            let found = if isSplitEnd scene (CornerId c) && d `elem` besides c then besides c else [d]
            mutual <- and <$> mapM (leadsBack other c) found
            pure (if mutual then Just found else Nothing)
          t | t == later -> pure (Just [])
          _ -> pure Nothing
    leadsBack tree c d = do
      l <- getList tree (target d)
      pure (l == cornerList c || (isSplitEnd scene (CornerId d) && c `elem` besides d && l `elem` firstOf d))
    firstOf d = map cornerList (take 1 (besides d))
    -- The corners at the other ends of a wall's two faces, that of the face which is swept first before the other.
    besides c = [d | CornerId d <- [nextCorner scene (CornerId c), previousCorner scene (CornerId c)]]

-- | What follows on a line.
data Beyond
  = -- | Something else must be swept first.
    Wait
  | -- | The last corner, and how many there are beyond the one asked about.
    Further !Int !Int

-- | The corners beyond b on the line from a to b, in the direction of the first tree; the second is the opposite one.
beyond :: Frame -> Growing s -> Growing s -> Int -> Int -> ST s Beyond
beyond f ahead behind !a = go 0
  where
    go !count !b = do
      l <- getList ahead (target b)
      case continuing f a b l of
        LeftTurn -> pure (Further b count)
        RightTurn -> pure Wait
        Collinear -> do
          let !c = listOwner l
          mutual <- getList behind (target c)
          if mutual == cornerList b then go (count + 1) c else pure Wait
