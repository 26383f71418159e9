module Visibility.ViewSpec (spec) where

import Data.List (group, partition, sort, sortBy)
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
              walls = [ (c, vertexDirection scene v)
                      | v <- vertices scene
                      , any (isWall scene) (vertexPairs v)
                      , c <- vertexCorners v
                      ]
           in conjoin
                [ counterexample (show (e, f)) (edgeView e /= edgeView f || or [ c == edgeCorner e && d `along` edgeTo e
                                                                               | (c, d) <- walls
                                                                               ])
                | es <- byCorner (edgesOf scene)
                , (e, f) <- zip es (drop 1 es)
                , primitive (edgeTo e) == primitive (edgeFrom f)
                ]
  describe "the events" $
    modifyMaxSuccess (* 4) $ do
      it "agree: what a corner sees after a vertex it sees before its next one" $
        property $ \(AnyScene s) ->
          let histories = Map.fromListWith (flip (<>)) [ (c, [(b, a)])
                                                       | e <- eventsOf (sampleScene s)
                                                       , (c, b, a) <- zip3 (vertexCorners (eventVertex e)) (viewsBefore e) (viewsAfter e)
                                                       ]
           in conjoin [map snd (take (length h - 1) h) === map fst (drop 1 h) | h <- Map.elems histories]
      it "begin and end with the same lines, read the other way" $
        property $ \(AnyScene s) ->
          let ends = Map.fromListWith joined [ (c, (b, a))
                                             | e <- eventsOf (sampleScene s)
                                             , (c, b, a) <- zip3 (vertexCorners (eventVertex e)) (viewsBefore e) (viewsAfter e)
                                             ]
              joined (_, final) (first, _) = (first, final)
           in conjoin [readBackwards final === first | (first, final) <- Map.elems ends]
      it "have one view of each corner before and one after" $
        property $ \(AnyScene s) ->
          conjoin [ [ length (viewsBefore e)
                    , length (viewsAfter e)
                    ] === replicate 2 (length (vertexCorners (eventVertex e)))
                  | e <- eventsOf (sampleScene s)
                  ]
      it "meet each face above a curve and below a curve by turns" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
           in conjoin
                [ counterexample (show (eventVertex e, incident)) (all alternating (Map.elems (byLabel incident)))
                | e <- eventsOf scene
                , views <- [viewsBefore e, viewsAfter e]
                , let incident = zipWith (incidences scene) (vertexCorners (eventVertex e)) views
                ]
      it "meet each face as often from above as from below, before and after together" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
           in conjoin
                [ counterexample (show (eventVertex e, name)) (length above === length below)
                | e <- eventsOf scene
                , let faces views = concat (zipWith (incidences scene) (vertexCorners (eventVertex e)) views)
                , let signed = [(l, f) | Incidence f b a <- faces (viewsBefore e), let l = (b, a)] <> [ (l, f)
                                                                                                      | Incidence f b a <- map crossed (faces (viewsAfter e))
                                                                                                      , let l = (b, a)
                                                                                                      ]
                , name <- map (take 1) (group (sort (map fst signed)))
                , let (above, below) = partition (== Above) [f | (l, f) <- signed, [l] == name]
                ]
  describe "a tangent pair" $
    modifyMaxSuccess (* 3) $
      it "is one whose line enters the solid at neither corner" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
              free v (p, q) =
                nextCorner scene p /= q && previousCorner scene p /= q
                  && not (or [enters scene c d | let Direction x y = vertexDirection scene v, c <- [p, q], d <- [(x, y), (-x, -y)]])
           in conjoin [freeBitangents scene v === filter (free v) (vertexPairs v) | v <- vertices scene]
  where
    isWall scene (p, q) = isWallCorner scene p && nextCorner scene p == q
    along d e = directionTurn d e == Collinear
    crossed (Incidence Above b a) = Incidence Below b a
    crossed (Incidence Below b a) = Incidence Above b a

edgesOf :: Scene -> [Edge]
edgesOf scene = edges scene (eventsOf scene)

eventsOf :: Scene -> [Event]
eventsOf scene = events scene (vertices scene)

-- | An edge with its directions in lowest terms.
keyOf :: Edge -> (CornerId, Direction, Direction, View)
keyOf e = (edgeCorner e, primitive (edgeFrom e), primitive (edgeTo e), edgeView e)

byCorner :: [Edge] -> [[Edge]]
byCorner es = map (sortBy (\e f -> fromDown (edgeFrom e) (edgeFrom f))) (Map.elems (Map.fromListWith (<>) [ (edgeCorner e, [e])
                                                                                                          | e <- es
                                                                                                          ]))
  where
    fromDown a b
      | a == b = EQ
      | a == Direction 0 (-1) = LT
      | b == Direction 0 (-1) = GT
      | otherwise = compareDirections a b

-- | The view along the same line in the other direction.
readBackwards :: View -> View
readBackwards (Tangent flank back front) = Tangent (otherFlank flank) front back
readBackwards (Ending Back object) = Ending Front object
readBackwards (Ending Front object) = Ending Back object
readBackwards (Buried flank) = Buried (otherFlank flank)

otherFlank :: Flank -> Flank
otherFlank Above = Below
otherFlank Below = Above

-- | The flanks on which a face of each label lies, in order along the line.
byLabel :: [[Incidence]] -> Map.Map (Object, Object) [[Flank]]
byLabel incident = Map.fromListWith (flip (<>)) [((b, a), [[f]]) | Incidence f b a <- concat incident]

-- | Does the label change flanks from corner to corner?
alternating :: [[Flank]] -> Bool
alternating flanks = and (zipWith (/=) fs (drop 1 fs))
  where
    fs = concat flanks

-- | Does a direction lead from a corner into the solid? Where the corner is convex the solid is the meeting of two half
-- planes, where it is reflex their union, where it is flat one of them; an end of a thin wall has none.
enters :: Scene -> CornerId -> (Integer, Integer) -> Bool
enters scene c (x, y)
  | isWallCorner scene c = False
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
