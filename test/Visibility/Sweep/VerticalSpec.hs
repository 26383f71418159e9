module Visibility.Sweep.VerticalSpec (spec) where

import Data.List (sortBy)
import qualified Data.Vector.Unboxed as U
import Test.Hspec hiding (before)
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck
import Visibility.Exact.Predicate
import Visibility.Ray
import Visibility.Test.Ray
import Visibility.Scene
import Visibility.Sweep
import Visibility.Sweep.Vertical
import Visibility.Test.BruteForce (bruteForce)
import Visibility.Test.Generator

spec :: Spec
spec = do
  describe "the plane sweep" $
    modifyMaxSuccess (* 5) $ do
      it "finds what each corner sees downward and upward, just after -90 degrees" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
              ahead c = sight (shoot scene c (justAfterDown scene c))
              behind c = let Direction x y = justAfterDown scene c in sight (shoot scene c (Direction (-x) (-y)))
              table part = map (objectOf scene . fromIntegral) (U.toList (part (verticalSweep scene)))
           in conjoin [table floors === map ahead (corners scene), table ceilings === map behind (corners scene)]
      it "finds the pair of least slope that leaves each corner forward, the nearest of collinear ones" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
              pairs = concatMap (vertexPairs scene) (bruteForce scene)
              targets heading = map fromIntegral (U.toList (firstTargets scene heading (verticalSweep scene)))
              first heading c = case sortBy (leastSlope scene c) (forward pairs heading c) of
                CornerId q : _ -> q
                [] -> case sight (shoot scene c (turned heading (justAfterDown scene c))) of
                  Just Sky -> skyCode scene
                  _ -> solid
           in conjoin [targets heading === map (first heading) (corners scene) | heading <- [minBound ..]]
  describe "headings" $
    it "order all indices, one against the other" $
      property $ \(NonNegative n) ->
        conjoin
          [ along Leftward n === reverse (along Rightward n)
          , conjoin [property (and (zipWith (before h) (along h n) (drop 1 (along h n)))) | h <- [minBound ..]]
          ]
  where
    sight (Meets object) = Just object
    sight Solid = Nothing
    turned Rightward d = d
    turned Leftward (Direction x y) = Direction (-x) (-y)
    forward pairs Rightward c = [q | (p, q) <- pairs, p == c]
    forward pairs Leftward c = [p | (p, q) <- pairs, q == c]
    leastSlope scene c p q = case turn (scenePoints scene) (index c) (index p) (index q) of
      LeftTurn -> LT
      -- Of a wall's two faces on one line, that which has free space on the right of the way comes first.
      Collinear -> if nextCorner scene c == p then LT else GT
      RightTurn -> GT
    index (CornerId k) = k

-- | A direction after -90 degrees and before the first vertex of a corner.
justAfterDown :: Scene -> CornerId -> Direction
justAfterDown scene c =
  case sortBy compareDirections [lineTo q | q <- corners scene, not (samePlace scene q c)] of
    d : _ -> between (Direction 0 (-1)) d
    [] -> Direction 1 0
  where
    CornerId i = c
    lineTo (CornerId q) = direction (scenePoints scene) (min i q) (max i q)
