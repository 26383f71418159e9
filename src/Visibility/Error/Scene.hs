-- | All that can be wrong with a scene that a file states in the right form: its geometry and its materials.
module Visibility.Error.Scene
  ( SceneError (..)
  , MaterialPlace (..)
  , sceneErrorPlace
  , sceneErrorText
  ) where

import Visibility.Exact.Point (Point (..))
import Visibility.Format.Number (numberText)
import Visibility.Scene.Id

-- | Why a 'Visibility.Scene.Raw.RawScene' is not a valid scene. Of two polygons, the earlier one comes first.
data SceneError
  = -- | Neither polygons nor an enclosure.
    EmptyScene
  | -- | With the number of corners.
    TooFewCorners !PolygonId !Int
  | -- | A corner in the place of an earlier one of the same polygon, the first there.
    RepeatedCorner !CornerName !Int !Point
  | -- | Three or more corners, all on a line. Spikes and contacts of the polygon with itself are not named besides.
    ZeroArea !PolygonId
  | -- | An angle of 0° or 360°.
    Spike !CornerName !Point
  | -- | A corner on a side of the same polygon, not at its ends.
    CornerOnSide !CornerName !SideName !Point
  | -- | Two polygons whose boundaries meet and of which one reaches into the solid of the other one.
    OverlappingPolygons !PolygonId !PolygonId
  | -- | Two thin walls, or two pieces of one, that lie along each other.
    OverlappingWalls !PolygonId !PolygonId
  | -- | Two sides of one polygon or of two that cross in a point that is no corner.
    CrossingSides !SideName !SideName
  | -- | The first lies inside the second; their boundaries do not meet.
    NestedPolygon !PolygonId !PolygonId
  | -- | A polygon outside of the enclosure; their boundaries do not meet.
    OutsideEnclosure !PolygonId
  | -- | A side named under @sides@, and the number of sides that there are.
    NoSuchSide !SideName !Int
  | BadEmission !MaterialPlace !Rational
  | BadReflectivity !MaterialPlace !Rational
  deriving (Eq, Ord, Show)

-- | What a material is stated for.
data MaterialPlace = OfPolygon !PolygonId | OfSide !SideName
  deriving (Eq, Ord, Show)

-- | The polygon, and in it the corner or side, that an error is listed under; nothing for the scene as a whole.
sceneErrorPlace :: SceneError -> Maybe (PolygonId, Maybe Int)
sceneErrorPlace problem = case problem of
  EmptyScene -> Nothing
  TooFewCorners p _ -> Just (p, Nothing)
  RepeatedCorner c _ _ -> corner c
  ZeroArea p -> Just (p, Nothing)
  Spike c _ -> corner c
  CornerOnSide c _ _ -> corner c
  OverlappingPolygons p _ -> Just (p, Nothing)
  OverlappingWalls p _ -> Just (p, Nothing)
  CrossingSides s _ -> side s
  NestedPolygon p _ -> Just (p, Nothing)
  OutsideEnclosure p -> Just (p, Nothing)
  NoSuchSide (SideName p _) _ -> Just (p, Nothing)
  BadEmission m _ -> material m
  BadReflectivity m _ -> material m
  where
    corner (CornerName p k) = Just (p, Just k)
    side (SideName p k) = Just (p, Just k)
    material (OfPolygon p) = Just (p, Nothing)
    material (OfSide s) = side s

-- | The text of an error without the file, one line.
sceneErrorText :: SceneError -> String
sceneErrorText problem = case problem of
  EmptyScene -> "the scene is empty; give at least one polygon or an enclosure"
  TooFewCorners p n ->
    polygon p <> ": has " <> counted n "corner" <> "; give three or more"
      <> (if p == Enclosure then "" else ", or two for a thin wall")
  RepeatedCorner c j at ->
    corner c <> ": repeats corner " <> show j <> " at " <> point at
      <> "; give each corner its own place, or leave one of them out"
  ZeroArea p ->
    polygon p <> ": all corners lie on one line, so its area is zero; move a corner off the line"
      <> (if p == Enclosure then "" else ", or give only the two ends for a thin wall")
  Spike c at ->
    corner c <> ": is the tip of a spike at " <> point at <> ", where the polygon turns back along its own side"
      <> "; move the corner or leave it out"
  CornerOnSide c (SideName _ k) at ->
    corner c <> ": lies on side " <> show k <> " of the same polygon, at " <> point at
      <> "; a polygon may not touch itself, move one of them"
  OverlappingPolygons p q
    | q == Enclosure -> polygon p <> ": reaches out of the enclosure; it may touch the enclosure, keep all of it inside"
    | otherwise -> polygon p <> ": overlaps " <> polygon q <> "; polygons may touch, move them apart until they only do"
  OverlappingWalls p q
    | p == q ->
        polygon p <> ": runs along itself; end the thin wall where it meets itself, or leave out the repeated part"
    | otherwise ->
        polygon p <> ": runs along " <> polygon q <> ", and two thin walls in one place leave open which is in front"
          <> "; let one of them end where it meets the other"
  CrossingSides s@(SideName p _) t@(SideName q k)
    | p == q ->
        side s <> ": crosses side " <> show k <> " of the same polygon"
          <> "; list the corners in order around the polygon"
    | q == Enclosure -> side s <> ": crosses " <> otherSide t <> "; keep all of the polygon inside the enclosure"
    | otherwise -> side s <> ": crosses " <> otherSide t <> "; move the polygons apart"
  NestedPolygon p q ->
    polygon p <> ": lies inside " <> polygon q <> ", which is solid; move it out, or leave it out"
  OutsideEnclosure p ->
    polygon p <> ": lies outside the enclosure; move it inside, or leave it or the enclosure out"
  NoSuchSide (SideName p k) n ->
    polygon p <> ": \"sides\" names side " <> show k <> "; "
      <> (if n == 0 then "it has no sides" else "its sides are 0 to " <> show (n - 1))
  BadEmission place x -> material place <> ": emission is " <> numberText x <> "; give 0 or more"
  BadReflectivity place x ->
    material place <> ": reflectivity is " <> numberText x <> "; give 0 or more, and less than 1"
  where
    polygon (Obstacle k) = "polygon " <> show k
    polygon Enclosure = "enclosure"
    corner (CornerName p k) = polygon p <> ", corner " <> show k
    side (SideName p k) = polygon p <> ", side " <> show k
    otherSide (SideName p k) = "side " <> show k <> " of " <> the p
    the Enclosure = "the enclosure"
    the p = polygon p
    material (OfPolygon p) = polygon p
    material (OfSide s) = side s
    point (Point x y) = "(" <> numberText x <> ", " <> numberText y <> ")"
    counted 1 noun = "1 " <> noun
    counted n noun = show (n :: Int) <> " " <> noun <> "s"
