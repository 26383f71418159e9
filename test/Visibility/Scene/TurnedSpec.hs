module Visibility.Scene.TurnedSpec (spec) where

import Data.List (sort)
import Data.Maybe (maybeToList)
import qualified Data.Vector.Unboxed as U
import Test.Hspec
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Point (LatticePoint (..), Point (..), Vector2 (..), Way (..))
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Scene.Turned
import Visibility.Sweep
import Visibility.Test.Generator

spec :: Spec
spec =
  describe "the scene turned by 90 degrees" $ do
    it "has each corner at its turned place, in lexicographic order, under its names" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            (turned, olds) = quarterTurned scene
            old (CornerId c) = CornerId (fromIntegral (olds U.! c))
         in conjoin
              [ sort (map old (corners turned)) === corners scene
              , map (cornerPoint turned) (corners turned)
                  === map (rightTurned . cornerPoint scene . old) (corners turned)
              , map (cornerPoint turned) (corners turned) === sort (map (cornerPoint turned) (corners turned))
              , map (cornerName turned) (corners turned) === map (cornerName scene . old) (corners turned)
              , map (namesHere turned) (corners turned) === map (namesHere scene . old) (corners turned)
              , map (fmap (map old) . cornersNamed turned . fst) (statedCorners turned)
                  === map (cornersNamed scene . fst) (statedCorners scene)
              , map snd (statedCorners turned) === map (rightTurned . snd) (statedCorners scene)
              ]
    it "has no corner that is negative on its lattice" $
      forAllShrink (oneof [(\(AnyScene s) -> s) <$> arbitrary, (\(HardScene s) -> s) <$> arbitrary]) shrinkSample $
        conjoin . map notNegative . turnedCorners . sampleScene
    it "has none where corners have denominators of their own" $
      let owned = map (turnedCorners . sampleScene) (maybeToList (sample unrelated))
       in (map (any hasOwn) owned, map (all notNegative) owned) `shouldBe` ([True], [True])
    it "has the same walks, sides and places" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            (turned, olds) = quarterTurned scene
            old (CornerId c) = CornerId (fromIntegral (olds U.! c))
            oldSide side = let CornerId c = old (sideStart side) in SideId c
            pairs = zip (corners turned) (drop 1 (corners turned))
         in conjoin
              [ map (old . nextCorner turned) (corners turned) === map (nextCorner scene . old) (corners turned)
              , map (old . previousCorner turned) (corners turned) === map (previousCorner scene . old) (corners turned)
              , map (uncurry (samePlace turned)) pairs === [samePlace scene (old c) (old d) | (c, d) <- pairs]
              , map (isSplitEnd turned) (corners turned) === map (isSplitEnd scene . old) (corners turned)
              , map (sideName turned) (sides turned) === map (sideName scene . oldSide) (sides turned)
              , map (fmap (sort . map oldSide) . piecesOf turned) (statedSides turned)
                  === map (piecesOf scene) (statedSides scene)
              , map (sideSpan turned) (statedSides turned)
                  === [Way (Vector2 y (negate x)) w | Way (Vector2 x y) w <- map (sideSpan scene) (statedSides scene)]
              , map (uncovered turned) (statedSides turned) === map (uncovered scene) (statedSides scene)
              ]
    it "sees the same" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            (turned, olds) = quarterTurned scene
            old (CornerId c) = CornerId (fromIntegral (olds U.! c))
         in sort (map (sort . map old . vertexCorners) (vertices turned)) === sort (map vertexCorners (vertices scene))

turnedCorners :: Scene -> [LatticePoint]
turnedCorners scene = let (turned, _) = quarterTurned scene in map (cornerAt turned) (corners turned)

notNegative, hasOwn :: LatticePoint -> Bool
notNegative (LatticePoint x y _) = x >= 0 && y >= 0
hasOwn (LatticePoint _ _ w) = w > 1

-- | Walls whose corners are on no lattice with a denominator of fewer than some hundred bits.
unrelated :: RawScene
unrelated = RawScene Nothing Nothing [rawWall [corner k 0, corner (k + 1) 1] | k <- [0, 2 .. 20]]
  where
    corner k y =
      Point (fromInteger k + 1 / (2 ^ (60 :: Int) + fromInteger k)) (y + 1 / (3 ^ (40 :: Int) + fromInteger k))

rightTurned :: Point -> Point
rightTurned (Point x y) = Point y (negate x)
