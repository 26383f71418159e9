{-# LANGUAGE BangPatterns #-}

-- | The topological sweep, fast: that of "Visibility.Sweep.Reference", which says why it is right, in tables that are
-- changed in place.
--
-- The order of cases is that of the reference, and so are the names but where tables are the matter: the ends of a
-- chain are 'top' and 'leaf' of its nodes, arrivals are lists that are linked both ways. What differs: a state is four
-- tables that nobody else sees; what most vertices are, two corners with nothing else on their line, has a way of its
-- own, without lists; vertices are written as numbers, many in one array. Live memory is O(n) while they are consumed.
--
-- /Source/ Rivière, Topologically sweeping the visibility complex of polygonal scenes; Rafalin, Souvaine, Streinu for
-- taking all collinear corners in one step.
module Visibility.Sweep.Topological
  ( vertices
  , verticesInPieces
    -- * For checks
  , treesAfter
  ) where

import Control.Monad (foldM, forM_, when)
import Control.Monad.ST (ST, runST)
import qualified Control.Monad.ST.Lazy as Lazy
import Data.Int (Int32)
import qualified Data.IntSet as IntSet
import Data.List (sort)
import Data.Maybe (fromMaybe)
import Data.Primitive.PrimArray
import Visibility.Exact.Predicate
import Visibility.Law (broken)
import Visibility.Scene
import Visibility.Sweep.HorizonTree
import Visibility.Sweep.HorizonTree.Frame
import Visibility.Sweep.HorizonTree.Plant
import Visibility.Sweep.HorizonTree.Table
import Visibility.Sweep.Piece
import Visibility.Sweep.Vertex
import Visibility.Sweep.Vertical hiding (following, preceding)

-- | All vertices of the complex, lazily. Which of the many topological orders it is depends on nothing but the scene.
--
-- /Degenerate cases/ all corners on a maximal free segment make one vertex, however many there are.
--
-- /Cost/ O(n log n) to start, then O(m) for all searches, as docs/scan-bound.md proves, and O(k log k) to see that a
-- line of k corners is ready; O(n) live memory.
--
-- /Laws/ the set equals that of brute force; the list equals that of the reference. That no pair is left at the end is
-- asked each time.
vertices :: Scene -> [Vertex]
vertices = concatMap pieceVertices . verticesInPieces

-- | The vertices of a sweep in pieces of many vertices each, none of them empty. /Cost/ that of 'vertices'.
--
-- /Laws/ @concatMap pieceVertices (verticesInPieces s) == vertices s@.
verticesInPieces :: Scene -> [Piece]
verticesInPieces scene = Lazy.runST $ do
  state <- Lazy.strictToLazyST (begun scene)
  let onwards now = Lazy.strictToLazyST (run state pieceSize now) >>= go
      go now
        | size now == 0 = pure []
        | otherwise = (:) <$> Lazy.strictToLazyST (pieceWritten state now) <*> onwards now {size = 0}
  onwards (beginning scene)

-- | Both trees, the right one first, after so many vertices or at the end. /Cost/ that of sweeping them.
treesAfter :: Scene -> Int -> (Table, Table)
treesAfter scene count = runST $ do
  state <- begun scene
  _ <- foldM (\now _ -> run state 1 now {size = 0}) (beginning scene) [1 .. count]
  (,) <$> frozen (rightTree state) <*> frozen (leftTree state)

-- | The state while it changes.
data Running s = Running
  { sweptScene :: !Scene
  , rightward, leftward :: !Frame
  , rightTree, leftTree :: !(Growing s)
  , stack :: !(MutablePrimArray s Int32)
  -- ^ The corners at which a vertex may be ready, each once.
  , isPending :: !(MutablePrimArray s Int32)
  -- ^ By corner: 0 where it is not on the stack, 1 where it is, more where it is but waits: the tree and the corner
  -- that block its line. See Note [Waiting].
  , blocking :: !(MutablePrimArray s Int32)
  -- ^ By corner that waits: the corner that the pair of the blocking one leads to.
  , written :: !(MutablePrimArray s Int32)
  -- ^ The vertices of the piece at hand, in the numbers of a 'Piece'.
  }

-- Note [Waiting]
-- ~~~~~~~~~~~~~~
-- A line may be looked at in vain, because at one of its corners, the blocking one, a pair of less slope is next in one
-- of the trees; that may be the neighbour of the corner that was looked at, if their pair is not mutual. It cannot
-- be swept until that tree edge has been. All other corners of which both ways along the line were met have the line as
-- what is next with the least slope: so none of them is on a vertex that is ready before the line is. As long as the
-- tree edge is there, they need not be looked at when they are taken off the stack: else each of k corners would look
-- at k others. If it has gone, they are looked at as any other corner is, so vertices come in the order of the
-- reference. From a corner one looks along both arms by turns, to the next blocking corner on one of them: like merging
-- the lesser of two parts into the greater one, this takes O(k log k) steps in all.

-- | How far the sweep is: corners on the stack, pairs swept since the start, numbers written of the piece at hand.
data Progress = Progress {depth :: !Int, pairsSwept :: !Int, size :: !Int}

-- | How many numbers a piece has before it is given away; with the last vertex it may have more.
pieceSize :: Int
pieceSize = 2048

-- | The state just above −90°, in which all corners are pending.
begun :: Scene -> ST s (Running s)
begun scene = do
  right <- plant toRight (firstTargets scene Rightward vertical)
  left <- plant toLeft (firstTargets scene Leftward vertical)
  corners' <- newPrimArray n
  forM_ [0 .. n - 1] $ \p -> writePrimArray corners' p (fromIntegral p)
  flags <- newPrimArray n
  setPrimArray flags 0 n 1
  -- The last vertex of a piece may have each corner of the scene once.
  Running scene toRight toLeft right left corners' flags <$> newPrimArray n <*> newPrimArray (pieceSize + n)
  where
    n = cornerCount scene
    vertical = verticalSweep scene
    tables = sceneTables scene
    toRight = frame tables Rightward
    toLeft = frame tables Leftward

beginning :: Scene -> Progress
beginning scene = Progress (cornerCount scene) 0 0

-- | Sweeps vertices until so many numbers have been written; fewer only at the end.
run :: Running s -> Int -> Progress -> ST s Progress
run state !most = go
  where
    n = cornerCount (sweptScene state)
    go !now
      | size now >= most = pure now
      | depth now == 0 = now <$ exhausted state
      | pairsSwept now > n * (n - 1) `div` 2 = broken "each elementary pair is swept once" (show (pairsSwept now))
      | otherwise = do
          p <- fromIntegral <$> readPrimArray (stack state) (depth now - 1)
          flag <- readPrimArray (isPending state) p
          writePrimArray (isPending state) p 0
          let popped = now {depth = depth now - 1}
          waits <- if flag < 2 then pure False else isBlocked state p (fromIntegral flag)
          if waits
            then go popped
            else do
              ahead <- getList (rightTree state) (target p)
              if isCornerList ahead then try OfRightTree popped p p (listOwner ahead) else tryLeft popped p
    tryLeft !now !p = do
      back <- getList (leftTree state) (target p)
      if isCornerList back then try OfLeftTree now p (listOwner back) p else go now
    -- Sweeps the vertex with the next pair of p in one of the trees, of a and b, if it may be swept, and goes on.
    try which !now !p !a !b = do
      ready <- readiness state a b
      case ready of
        NotReady -> failed which now p
        ReadyPair -> sweepPair state now a b >>= go
        PerhapsLine -> tryLine which now p a b
    -- Apart, so that nothing is allocated for it where it is not needed.
    tryLine which !now !p !a !b =
      readyLine state a b >>= either (\blocked -> wait state blocked >> failed which now p) swept
      where
        swept line = sweepVertex state now line >>= go
    failed which !now !p = case which of
      OfRightTree -> tryLeft now p
      OfLeftTree -> go now

-- | In which tree a pair is the next one of its corner.
data Next = OfRightTree | OfLeftTree

-- | Whether a pair may be swept.
data Readiness
  = NotReady
  | -- | Nothing else is on its line.
    ReadyPair
  | -- | Other pairs may be on the line: these are to be asked as well.
    PerhapsLine

-- | May the pair of a and b, a to the left, be swept? It is to be the next one of both its corners, and whatever else
-- is next at them must have a greater slope: two turns. See Note [Ready] of the reference.
readiness :: Running s -> Int -> Int -> ST s Readiness
readiness state !a !b
  | hasSplitEnds (sweptScene state) && (isSplit a || isSplit b) = pure PerhapsLine
  | otherwise = do
      nextOfA <- getList (rightTree state) (target a)
      nextOfB <- getList (leftTree state) (target b)
      if nextOfA /= cornerList b || nextOfB /= cornerList a
        then pure NotReady
        else do
          atB <- continuing (rightward state) a b <$> getList (rightTree state) (target b)
          case atB of
            RightTurn -> pure NotReady
            _ -> do
              atA <- continuing (leftward state) b a <$> getList (leftTree state) (target a)
              pure $ case atA of
                RightTurn -> NotReady
                LeftTurn | LeftTurn <- atB -> ReadyPair
                _ -> PerhapsLine
  where
    isSplit = isSplitEnd (sweptScene state) . CornerId
{-# INLINE readiness #-}

-- | The turn at b from the line from a to the next pair of b in the same heading: left if there is none.
continuing :: Frame -> Int -> Int -> List -> Turn
continuing f !a !b !l
  | isCornerList l = turnIn f a b (listOwner l)
  | otherwise = LeftTurn
{-# INLINE continuing #-}

-- | One way along a line: the tree that leads that way, and its opposite; the turn to pairs of greater slope; the
-- corners found, the last first; the corner to go on from, or nothing where the line ends.
data Arm s = Arm !(Growing s) !(Growing s) !Turn ![Int] !(Maybe Int)

-- | Corners that wait as long as the next pair of a corner in a tree is what it is. See Note [Waiting].
data Blocked = Blocked ![Int] !Block

-- | The tree in which the corner's pair is next, by its turn to greater slopes; the corner; the list of the corner that
-- it leads to.
data Block = Block !Turn !Int !List

-- | The vertex that this pair is on if it may be swept, else what waits for what. See Note [Line] of the reference.
--
-- /Cost/ O(1) for each corner; O(log k) for each of k corners where there are split ends.
readyLine :: Running s -> Int -> Int -> ST s (Either Blocked Vertex)
readyLine state@Running {sweptScene = scene} !p !q
  | hasSplitEnds scene = fmap (vertexOn . IntSet.toAscList) <$> collected [p] (IntSet.singleton p)
  | otherwise = byTurns (arm left right RightTurn) (arm right left LeftTurn)
  where
    (left, right) = (leftTree state, rightTree state)
    vertexOn line = fromMaybe (broken "a line has two corners" (show line)) (fromCorners (map CornerId line))
    arm tree back greater = Arm tree back greater [] (Just p)
    -- One corner further on either arm by turns, as long as no pair of less slope is next, nor one that is not mutual.
    byTurns (Arm _ _ _ found Nothing) (Arm _ _ _ found' Nothing) = pure (Right (vertexOn (sort (p : found <> found'))))
    byTurns ended@(Arm _ _ _ _ Nothing) other = byTurns other ended
    byTurns (Arm tree back greater found (Just c)) other = do
      l <- getList tree (target c)
      let !d = listOwner l
          ends = byTurns other (Arm tree back greater found Nothing)
      if not (isCornerList l)
        then ends
        else case turn (scenePoints scene) p q d of
          Collinear -> do
            r <- getList back (target d)
            if r == cornerList c
              then byTurns other (Arm tree back greater (d : found) (Just d))
              else blocked (Block (opposite greater) d r)
          side -> if side == greater then ends else blocked (Block greater c l)
      where
        -- Both ways are known but at the corners to go on from.
        blocked by =
          let Arm _ _ _ found' next = other
           in pure (Left (Blocked (filter (\e -> e /= c && Just e /= next) (p : found <> found')) by))
    -- The same where a free end of a wall may lead along both faces.
    collected [] line = pure (Right line)
    collected (c : rest) line = do
      ahead <- nextOnLine right left LeftTurn c
      behind <- nextOnLine left right RightTurn c
      case (<>) <$> ahead <*> behind of
        Left by -> pure (Left (Blocked (filter (`notElem` (c : rest)) (IntSet.toList line)) by))
        Right onwards ->
          let new = filter (`IntSet.notMember` line) onwards in collected (rest <> new) (foldr IntSet.insert line new)
    nextOnLine tree back greater c = do
      l <- getList tree (target c)
      let d = listOwner l
          onwards = if isSplit c && d `elem` besides c then besides c else [d]
      if not (isCornerList l)
        then pure (Right [])
        else case turn (scenePoints scene) p q d of
          Collinear -> (onwards <$) . sequence_ <$> mapM (c `isNextOf`) onwards
          side -> pure (if side == greater then Right [] else Left (Block greater c l))
      where
        c' `isNextOf` e = do
          r <- getList back (target e)
          let isMutual =
                r == cornerList c' || isSplit e && c' `elem` besides e && r `elem` map cornerList (take 1 (besides e))
          pure (if isMutual then Right () else Left (Block (opposite greater) e r))
    isSplit = isSplitEnd scene . CornerId
    besides c = [d | CornerId d <- [nextCorner scene (CornerId c), previousCorner scene (CornerId c)]]
{-# NOINLINE readyLine #-}

-- | Sweeps a vertex of two corners. They need not be separated: what arrives at a has more slope than the pair, so a is
-- not linked.
sweepPair :: Running s -> Progress -> Int -> Int -> ST s Progress
sweepPair state !now !a !b = do
  writePrimArray (written state) (size now) (fromIntegral a)
  writePrimArray (written state) (size now + 1) (closing b)
  advance (rightward state) (rightTree state) a
  advance (leftward state) (leftTree state) b
  deeper <- push state (depth now) a >>= \d -> push state d b
  pure (Progress deeper (pairsSwept now + 1) (size now + 2))
{-# INLINE sweepPair #-}

-- | Sweeps a vertex pair by pair: in the right tree the rightmost pair first, in the left tree the leftmost one.
sweepVertex :: Running s -> Progress -> Vertex -> ST s Progress
sweepVertex state !now vertex = do
  forM_ (zip [size now ..] line) $ \(i, c) -> writePrimArray (written state) i (fromIntegral c)
  writePrimArray (written state) (size now + length line - 1) (closing end)
  sweepLine (rightward state) (rightTree state) (reverse (map (number . fst) pairs))
  sweepLine (leftward state) (leftTree state) (map (number . snd) pairs)
  deeper <- foldM (push state) (depth now) line
  pure (Progress deeper (pairsSwept now + length pairs) (size now + length line))
  where
    line = map number (vertexCorners vertex)
    end = number (vertexLast vertex)
    pairs = vertexPairs (sweptScene state) vertex
    number (CornerId c) = c

{-# NOINLINE sweepVertex #-}

-- | Puts a corner on the stack of so many, if it is not there; how many there are then.
push :: Running s -> Int -> Int -> ST s Int
push state !deep !p = do
  already <- readPrimArray (isPending state) p
  writePrimArray (isPending state) p 1
  if already /= 0
    then pure deep
    else do
      writePrimArray (stack state) deep (fromIntegral p)
      pure (deep + 1)
{-# INLINE push #-}

-- | Notes that corners need not be looked at as long as the block is there.
wait :: Running s -> Blocked -> ST s ()
wait state (Blocked met (Block greater c l)) = forM_ met $ \p -> do
  flag <- readPrimArray (isPending state) p
  when (flag /= 0) $ do
    writePrimArray (isPending state) p (fromIntegral (2 * c + (if greater == LeftTurn then 2 else 3)))
    writePrimArray (blocking state) p (fromIntegral (listOwner l))

-- | Is that still there for which a corner with this mark waits?
isBlocked :: Running s -> Int -> Int -> ST s Bool
isBlocked state p flag = do
  next <- readPrimArray (blocking state) p
  now <- getList (if even flag then rightTree state else leftTree state) (target ((flag - 2) `div` 2))
  pure (isCornerList now && listOwner now == fromIntegral next)

-- | Asks that no pair is left. Unsafe arithmetic may stop before the end, with pairs that are never swept.
exhausted :: Running s -> ST s ()
exhausted state = forM_ [rightTree state, leftTree state] $ \tree ->
  forM_ [0 .. cornerCount (sweptScene state) - 1] $ \p -> do
    l <- getList tree (target p)
    when (isCornerList l) $ broken "the sweep goes on to the end of its range" (show (p, listOwner l))

-- | The numbers written, as a piece.
pieceWritten :: Running s -> Progress -> ST s Piece
pieceWritten state now = do
  found <- newPrimArray (size now)
  copyMutablePrimArray found 0 (written state) 0 (size now)
  Piece <$> unsafeFreezePrimArray found
