-- | What is seen from a point or a corner, read from the complex.
--
-- In the dual a point is a curve like that of a corner: the lines through it. A walk along it for half a turn visits
-- the faces of all free segments through the point, whose ends are what is seen forward and backward.
module Visibility.Complex.Walk
  ( -- * Looking around
    Look (..)
  , lookAround
  ) where

import Data.Function (on)
import Data.List (sortBy)
import Data.Maybe (fromMaybe, isNothing, mapMaybe)
import Visibility.Complex.Locate
import Visibility.Complex.Reading (Reading (..))
import Visibility.Complex.Table
import Visibility.Complex.Type
import Visibility.Exact.Predicate
import Visibility.Law (broken)
import Visibility.Scene
import Visibility.Scene.Cone
import Visibility.Sight
import Visibility.Sorting (firstWhere)
import Visibility.View (End (..), Flank (..), View (..))

-- | What is seen from somewhere.
data Look = Look
  { lookSights :: ![Sight]
  -- ^ In the form of 'joined'.
  , lookSteps :: !Int
  -- ^ How many faces were visited, or stretches of the corner.
  }
  deriving (Eq, Show)

-- | All that is seen from a corner or a point; for a point in the solid, the obstacle that it is in, or the enclosure
-- that it is outside of.
--
-- /Degenerate cases/ a point on a side sees half a turn, one on a thin wall sees both ways; a point at a corner sees
-- what the corner sees. Where a point is in line with corners, the rays along that line are the border of two sights.
--
-- /Cost/ of a point, that of 'locate' and O(log n) for each face visited; of a corner O(1) for each of its stretches;
-- both without what it takes to join the sights.
lookAround :: Complex -> Viewpoint -> Either PolygonId Look
lookAround complex viewpoint = case viewpoint of
  AtCorner name _ -> Right (fromCorners complex (fromMaybe [] (cornersNamed scene name)))
  AtPoint point -> case locate complex point of
    (_, OnCorners cs) -> Right (fromCorners complex cs)
    (_, InSolid polygon) -> Left polygon
    (eye, InFree start) -> Right (lookOf [turning (walk complex eye Nothing start)])
    (eye, OnSides pieces) -> Right (lookOf [pieceOf s (walk complex eye (Just s) start) | (s, start) <- pieces])
  where
    -- Of a side's two rays along a line one is free, that which does not end at the side.
    pieceOf s steps
      | sideEnd scene s < sideStart s = (fronts <> backs, length steps)
      | otherwise = (backs <> fronts, length steps)
      where
        fronts = ahead [step | step@(Step _ _ back _) <- steps, back == Just (Side s)]
        backs = behind [step | step@(Step _ _ _ front) <- steps, front == Just (Side s)]
    scene = complexScene complex

-- | What is seen from all cones of free space in one place.
fromCorners :: Complex -> [CornerId] -> Look
fromCorners complex = lookOf . map (turning . fromCorner complex)

-- | The sights of all parts of what is seen, each part counter-clockwise; with the number of steps.
lookOf :: [([Sight], Int)] -> Look
lookOf parts = Look (joined sights) (sum (map snd parts))
  where
    sights = case parts of
      [(own, _)] -> own
      _ -> sortBy (compareAround `on` sightFrom) (concatMap fst parts)

-- | A part of the half turn during which the line through a point stays in one face, or that through a corner on one
-- stretch: from one direction to another, with the objects at back and front.
data Step = Step !Direction !Direction !(Maybe Object) !(Maybe Object)

-- | What is seen along the lines of a half turn and against them, and the number of steps.
turning :: [Step] -> ([Sight], Int)
turning steps = (ahead steps <> behind steps, length steps)

ahead, behind :: [Step] -> [Sight]
ahead steps = [Sight from to object | Step from to _ (Just object) <- steps]
behind steps = [Sight (reversed from) (reversed to) object | Step from to (Just object) _ <- steps]

-- | The stretches of a corner in cyclic order.
fromCorner :: Complex -> CornerId -> [Step]
fromCorner complex c =
  map step (takeWhile (/= lastOne) (iterate (edgeAfter complex) (edgeAfter complex lastOne)) <> [lastOne])
  where
    lastOne = lastEdgeOf complex c
    step e = case edgeView complex e of
      Tangent _ b f -> through (Just b) (Just f)
      Ending Front b -> through (Just b) Nothing
      Ending Back f -> through Nothing (Just f)
      Buried _ -> through Nothing Nothing
      where
        through = Step (edgeFrom complex e) ((if e == lastOne then reversed else id) (edgeTo complex e))

-- Note [Leaving a face]
-- ~~~~~~~~~~~~~~~~~~~~~
-- While the curve of a point runs in a face, the face's upper chain lies above it and the lower one below it. Along
-- the upper chain, those vertices that come later than the present direction and do not lie strictly above the
-- point's curve are the last ones: two points have one line, so their curves cross once, and the upper chain is below
-- the curve of the corner where it was crossed from there on. So a binary search finds the stretch that is crossed;
-- likewise in the lower chain; the crossing that comes first is where the curve leaves. A crossing in the upper chain
-- is at a corner to the right of the point, one in the lower chain at a corner to the left of it.
--
-- Where the crossing is at a vertex p1 … pk of the chain, the curves have the order p1 … pk from above just after it,
-- and the point's curve has its place among them as the point has among the corners along the line. It goes on just
-- below the curve of the last corner before it on the line, or just above that of p1. With k = 1 this also says where
-- it goes on when it crosses the curve of a corner between two vertices.

-- | The half turn of the lines through a point, in which they have one free segment each; for a point on a side, the
-- one that ends there on the free side.
--
-- /Cost/ O(log n) for each step. See Note [Leaving a face].
walk :: Complex -> Eye -> Maybe SideId -> Start -> [Step]
walk complex eye piece (Start begin side0) = go downwards begin (readingAt downwards begin side0)
  where
    go from face reading = case sortBy (compareDirections `on` towards) (mapMaybe crossing [Above, Below]) of
      [] -> [stepTo upwards]
      Exit to next side : _
        | not (isBefore from to) -> broken "a curve leaves a face after it has entered it" (show (from, to, face))
        | compareDirections to upwards == EQ -> [stepTo upwards]
        | otherwise -> stepTo to : go to next (readingAt to next side)
      where
        towards (Exit to _ _) = to
        stepTo to = case reading of
          Forwards -> Step from to (Just (faceBack complex face)) (Just (faceFront complex face))
          Backwards -> Step from to (Just (faceFront complex face)) (Just (faceBack complex face))
        crossing = leaving complex eye piece face reading from

    -- How a face is read just after a direction; the last argument says it of the lines that miss everything.
    readingAt from face side = case faceFirst complex face of
      Nothing -> side
      Just v -> if isBefore from (edgeFrom complex (at (vertexStarts complex) v)) then Backwards else Forwards

-- | Where the curve of a point leaves a face: the direction, the face in which it goes on, and how that is read if it
-- is the face of the lines that miss everything.
data Exit = Exit !Direction !FaceId !Reading

-- | −90°, where the half turn begins.
downwards :: Direction
downwards = Direction 0 (-1)

-- | Does a direction come before another one in the half turn? The first may be its beginning.
isBefore :: Direction -> Direction -> Bool
isBefore from to = from == downwards || compareDirections from to == LT

-- | The exit through the chain above the curve or below it, if there is one in the half turn after a direction. See
-- Note [Leaving a face].
leaving :: Complex -> Eye -> Maybe SideId -> FaceId -> Reading -> Direction -> Flank -> Maybe Exit
leaving complex eye piece face reading from flank
  | place >= high = Nothing
  | (index c < rank) == (flank == Above) = Nothing
  | atVertex = Just (pastVertex complex eye piece to (edgeLast complex e))
  | otherwise = Just $ case (flank, place < low) of
      (Above, False) -> newFace complex to e AboveBack Forwards
      (Above, True) -> newFace complex to e BelowFront Forwards
      (Below, False) -> newFace complex to e BelowFront Backwards
      (Below, True) -> newFace complex to e AboveBack Backwards
  where
    scene = complexScene complex
    rank = eyeRank eye
    (earlier, low, high) = boundary complex face reading flank
    place = firstWhere isPassed (maybe low (const (low - 1)) earlier) high
    e = edgeIn place
    c = edgeCorner complex e
    index (CornerId k) = k
    to = directionFrom scene eye c
    atVertex = not (goesOn place e) && aside e == Collinear
    aside s = directionTurn (edgeTo complex s) (eyeFrom scene eye (edgeCorner complex s))
    -- The entry before the first one is the stretch that goes on into this half turn.
    edgeIn i = at (chains complex) (if i < low then fromMaybe i earlier else i)
    goesOn i s = i >= low && wrapsAround complex s
    isPassed i = goesOn i s || (isBefore from (edgeTo complex s) && aside s /= inside)
      where
        s = edgeIn i
    inside = case flank of
      Above -> RightTurn
      Below -> LeftTurn

-- | The part of a face's boundary above or below its lines in one reading: where it is in 'chains', and where the
-- stretch is that goes on into this half turn from before its beginning, if there is one.
boundary :: Complex -> FaceId -> Reading -> Flank -> (Maybe Int, Int, Int)
boundary complex face@(FaceId f) reading flank = (earlier, start own, start (own + 1))
  where
    own = case (reading, flank) of
      (Forwards, Above) -> 4 * f
      (Forwards, Below) -> 4 * f + 2
      (Backwards, Above) -> 4 * f + 3
      (Backwards, Below) -> 4 * f + 1
    -- The other part of the chain, that of the half turn before.
    other = if reading == Forwards then own + 1 else own - 1
    isRead = reading == Backwards || isNothing (faceFirst complex face)
    earlier = if isRead && start (other + 1) > start other then Just (start (other + 1) - 1) else Nothing
    start = at (chainStarts complex)

-- | Where the curve of a point goes on after a vertex that the point is in line with.
--
-- /Degenerate cases/ a point on a side, at the line of the side, goes on at the side's end before it if it looks upward
-- from the side, else at the end after it. Of several corners in the place next to it on the line, those count from
-- whose cone of free space the line leads to it.
pastVertex :: Complex -> Eye -> Maybe SideId -> Direction -> VertexId -> Exit
pastVertex complex eye piece to v = case (before, after) of
  ([], _) -> atLeft (towards (reversed to) after)
  (_, []) -> atRight (towards to before)
  _ -> case piece of
    Just s
      | any ((== sideStart s) . cornerOf) before, i : _ <- filter ((== sideEnd scene s) . cornerOf) after -> atLeft i
      | any ((== sideStart s) . cornerOf) after, i : _ <- filter ((== sideEnd scene s) . cornerOf) before -> atRight i
    _ -> atRight (towards to before)
  where
    scene = complexScene complex
    (EdgeId first, EdgeId end) = vertexRow complex v
    cornerOf i = edgeCorner complex (EdgeId i)
    place = firstWhere (\i -> cornerOf i >= CornerId (eyeRank eye)) first end
    before = inPlaceOf (place - 1) [place - 1, place - 2 .. first]
    after = inPlaceOf place [place .. end - 1]
    inPlaceOf i = takeWhile (samePlace scene (cornerOf i) . cornerOf)
    towards d is = case is of
      [i] -> i
      _ -> case filter (\i -> not (entersSolid scene JustThen (cornerOf i) d)) is of
        i : _ -> i
        [] -> broken "a line leads to a point on it from a corner" (show (v, d))
    atLeft i = newFace complex to (EdgeId i) AboveBack Forwards
    atRight i = newFace complex to (EdgeId i) BelowFront Backwards

-- | Where it goes on in the face on a quarter of a stretch.
newFace :: Complex -> Direction -> EdgeId -> Quarter -> Reading -> Exit
newFace complex to e quarter reading = case faceAt complex e quarter of
  Just face -> Exit to face reading
  Nothing -> broken "a free ray is in a face" (show (e, quarter))
