module Visibility.ViewSpec (spec) where

import Data.List (partition, sort, sortBy)
import qualified Data.Map.Strict as Map
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Sweep
import Visibility.Test.Generator
import Visibility.Test.Ray
import Visibility.View

spec :: Spec
spec = do
  describe "the edges" $ do
    modifyMaxSuccess (* 10) $
      it "are those that rays find between the vertices of each corner" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
           in sort (map keyOf (edgesOf scene)) === sort (map keyOf (edgesByRays scene))
    modifyMaxSuccess (* 4) $
      it "are maximal: where one follows another at a corner, the view changes, or a thin wall lies in the line" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
              wallsSeenEdgeOn =
                [ (c, primitive (vertexDirection scene v))
                | v <- vertices scene
                , any (isWall scene) (vertexPairs scene v)
                , c <- vertexCorners v
                ]
           in conjoin
                [ counterexample (show (e, f)) $
                    edgeView e /= edgeView f || (edgeCorner e, primitive (edgeTo e)) `elem` wallsSeenEdgeOn
                | es <- byCorner (edgesOf scene)
                , (e, f) <- zip es (drop 1 es)
                , primitive (edgeTo e) == primitive (edgeFrom f)
                ]
  describe "the events" $
    modifyMaxSuccess (* 4) $ do
      it "agree: what a corner sees after a vertex it sees before its next one" $
        property $ \(AnyScene s) ->
          conjoin [map snd (take (length h - 1) h) === map fst (drop 1 h) | h <- histories (sampleScene s)]
      it "begin and end with the same lines, read the other way" $
        property $ \(AnyScene s) ->
          conjoin
            [ map (readBackwards . snd) (drop (length h - 1) h) === map fst (take 1 h)
            | h <- histories (sampleScene s)
            ]
      it "have one view of each corner before and one after" $
        property $ \(AnyScene s) ->
          conjoin
            [ [length (viewsBefore e), length (viewsAfter e)] === [k, k]
            | e <- eventsOf (sampleScene s)
            , let k = length (vertexCorners (eventVertex e))
            ]
      it "meet each face above a curve and below a curve by turns" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
           in conjoin
                [ counterexample (show (eventVertex e, incident)) (all alternating (byLabel incident))
                | e <- eventsOf scene
                , views <- [viewsBefore e, viewsAfter e]
                , let incident = incidencesOf scene e views
                ]
      it "meet each face as often from above as from below, before and after together" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
           in conjoin
                [ counterexample (show (eventVertex e, flanks)) (length above === length below)
                | e <- eventsOf scene
                , flanks <-
                    byLabel (incidencesOf scene e (viewsBefore e) <> map crossed (incidencesOf scene e (viewsAfter e)))
                , let (above, below) = partition (== Above) flanks
                ]
  describe "a tangent pair" $
    modifyMaxSuccess (* 3) $
      it "is one whose line enters the solid at neither corner" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
              free v (p, q) =
                nextCorner scene p /= q && previousCorner scene p /= q
                  && not (any (\c -> any (enters scene c) (bothWays (vertexDirection scene v))) [p, q])
           in conjoin [freeBitangents scene v === filter (free v) (vertexPairs scene v) | v <- vertices scene]
  where
    -- Two faces of one piece of a wall, which lead from one place to another and back.
    isWall scene (p, q) =
      or [samePlace scene p a && samePlace scene q b && joins (a, b) | (a, b) <- ends] && joins (q, p)
      where
        ends = [(a, nextCorner scene a) | a <- corners scene]
        joins (a, b) = or [samePlace scene a c && samePlace scene b d | (c, d) <- ends]
    crossed (Incidence flank back front) = Incidence (otherFlank flank) back front
    bothWays (Direction x y) = [(x, y), (-x, -y)]

edgesOf :: Scene -> [Edge]
edgesOf scene = edges scene (eventsOf scene)

eventsOf :: Scene -> [Event]
eventsOf scene = events scene (vertices scene)

-- | An edge with its directions in lowest terms.
keyOf :: Edge -> (CornerId, Direction, Direction, View Object)
keyOf e = (edgeCorner e, primitive (edgeFrom e), primitive (edgeTo e), edgeView e)

byCorner :: [Edge] -> [[Edge]]
byCorner es = map (sortBy fromDown) (Map.elems (Map.fromListWith (<>) [(edgeCorner e, [e]) | e <- es]))
  where
    fromDown e f = case (edgeFrom e, edgeFrom f) of
      (Direction 0 (-1), Direction 0 (-1)) -> EQ
      (Direction 0 (-1), _) -> LT
      (_, Direction 0 (-1)) -> GT
      (d, d') -> compareDirections d d'

-- | What each corner sees before and after each of its vertices, in their order.
histories :: Scene -> [[(View Object, View Object)]]
histories scene =
  Map.elems . Map.fromListWith (flip (<>)) $
    [ (c, [views])
    | e <- eventsOf scene
    , (c, views) <- zip (vertexCorners (eventVertex e)) (zip (viewsBefore e) (viewsAfter e))
    ]

-- | The view along the same line in the other direction.
readBackwards :: View Object -> View Object
readBackwards (Tangent flank back front) = Tangent (otherFlank flank) front back
readBackwards (Ending Back object) = Ending Front object
readBackwards (Ending Front object) = Ending Back object
readBackwards (Buried flank) = Buried (otherFlank flank)

otherFlank :: Flank -> Flank
otherFlank Above = Below
otherFlank Below = Above

-- | The faces at all corners of a vertex, in their order along the line.
incidencesOf :: Scene -> Event -> [View Object] -> [Incidence]
incidencesOf scene e views = concat (zipWith (incidences scene) (vertexCorners (eventVertex e)) views)

-- | The flanks of the incidences of each label, in their order.
byLabel :: [Incidence] -> [[Flank]]
byLabel incident = Map.elems (Map.fromListWith (flip (<>)) [((back, front), [f]) | Incidence f back front <- incident])

alternating :: [Flank] -> Bool
alternating flanks = and (zipWith (/=) flanks (drop 1 flanks))

-- | Does a direction lead from a corner into the solid? Where the corner is convex the solid is the meeting of two half
-- planes, where it is reflex their union, where it is flat one of them; an end of a thin wall has none.
enters :: Scene -> CornerId -> (Integer, Integer) -> Bool
enters scene c (x, y)
  | isWallEnd scene c = False
  | bend == LeftTurn = leftOf arriving && leftOf leaving
  | bend == RightTurn = leftOf arriving || leftOf leaving
  | otherwise = leftOf leaving
  where
    index (CornerId k) = k
    heading a b = direction (scenePoints scene) (index a) (index b)
    arriving = heading (previousCorner scene c) c
    leaving = heading c (nextCorner scene c)
    bend = directionTurn arriving leaving
    leftOf d = directionTurn d (Direction x y) == LeftTurn
