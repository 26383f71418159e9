module Visibility.Complex.BuildSpec (spec) where

import Data.List (sort, sortBy, unfoldr)
import Test.Hspec hiding (pending)
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Complex
import Visibility.Count
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Sweep
import Visibility.Sweep.Reference (pending, start, step)
import Visibility.Test.BruteForce (bruteForce)
import Visibility.Test.Description
import Visibility.Test.Generator
import Visibility.Test.Metamorphic
import Visibility.View (End (..), Flank (..), Incidence (..), View (..), events, incidences, stretches)
import qualified Visibility.View as Stream

spec :: Spec
spec = describe "build" $ do
  modifyMaxSuccess (* 10) $ do
    it "has as many edges, buried stretches and faces as are counted along the stream" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            complex = complexOf scene
            counts = count scene (events scene (vertices scene))
         in (length (edgeIds complex), length (stretchIds complex), length (faceIds complex))
              === (edgeCount counts, edgeCount counts + buriedCount counts, faceCount counts)
    it "has the stretches of the stream, those cut by the start of the half turn glued" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
         in sort (concatMap (cutAgain (complexOf scene)) (stretchIds (complexOf scene)))
              === sort (map told (stretches scene (events scene (vertices scene))))
    it "puts on the quarters of a stretch faces of the labels that its view demands" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            complex = complexOf scene
         in conjoin
              [ counterexample (show e) $
                  sort (concatMap (labelled complex e) [Above, Below])
                    === sort (map facing (incidences scene (edgeCorner complex e) (edgeView complex e)))
              | e <- stretchIds complex
              ]
  modifyMaxSuccess (* 4) $ do
    it "gives one complex, whichever sweep the vertices come from and in whichever order" $
      property $ \(LatticeScene s) ->
        let scene = sampleScene s
         in forAll (shuffle (corners scene)) $ \order ->
              let found = unfoldr (step scene) (start scene) {pending = order}
                  topological = description (complexOf scene)
               in conjoin
                    [ description (build scene found) === topological
                    , description (build scene (straightVertices scene)) === topological
                    ]
    it "gives the complex of brute force in small scenes" $
      property $ \(SmallScene s) ->
        let scene = sampleScene s
         in description (build scene (sortBy (compareVertices scene) (bruteForce scene)))
              === description (complexOf scene)
    it "changes names only, where polygons are put in another order" $
      property $ \(AnyScene s) ->
        forAll (oneof [permutedPolygons (sampleRaw s), rotatedCorners (sampleRaw s)]) $ \change ->
          case sample (changedScene change) of
            Nothing -> counterexample "not valid" False
            Just t ->
              description (complexOf (sampleScene t))
                === renamedDescription
                  (newCorner change)
                  (newSide change)
                  (description (complexOf (sampleScene s)))
  it "knows a single wall: one vertex, two edges that return to it, and three faces" $
    fmap (sizes . complexOf . sampleScene) (sampleOf [[(0, 0), (1, 0)]]) `shouldBe` Just (1, 2, 3)
  where
    sizes complex = (length (vertexIds complex), length (edgeIds complex), length (faceIds complex))
    told (Stream.Edge c from to view) = (c, primitive from, primitive to, view)
    labelled complex e flank =
      [(flank, back, front) | f <- edgeFacesOn complex e flank, (back, front) <- readAt complex e f]
    -- The label of a face as it is read where a stretch begins: backwards if the face began later in the half turn.
    readAt complex e f = case faceFirst complex f of
      Just v | compareDirections (edgeFrom complex e) (vertexDirectionOf complex v) == LT -> [(front, back)]
      _ -> [(back, front)]
      where
        (back, front) = (faceBack complex f, faceFront complex f)
    vertexDirectionOf complex v = vertexDirection (complexScene complex) (vertexAt complex v)
    facing (Incidence flank back front) = (flank, back, front)

-- | A stretch, or the two parts of one that goes on over the end of the half turn.
cutAgain :: Complex -> EdgeId -> [(CornerId, Direction, Direction, View Object)]
cutAgain complex e
  | not (wrapsAround complex e) = [(c, from, to, view)]
  | from == upwards = [(c, downwards, to, readBackwards view)]
  | otherwise = [(c, from, upwards, view), (c, downwards, to, readBackwards view)]
  where
    c = edgeCorner complex e
    view = edgeView complex e
    from = primitive (edgeFrom complex e)
    to = primitive (edgeTo complex e)
    downwards = Direction 0 (-1)

readBackwards :: View Object -> View Object
readBackwards view = case view of
  Tangent flank b f -> Tangent (other flank) f b
  Ending Front b -> Ending Back b
  Ending Back f -> Ending Front f
  Buried flank -> Buried (other flank)
  where
    other Above = Below
    other Below = Above
