module Visibility.Test.AdversarySpec (spec) where

import Data.Either (isLeft)
import Data.Foldable (for_, toList)
import Data.List (nub, sort)
import Data.Ratio (denominator)
import Test.Hspec
import Visibility.Exact.Point (Point (..))
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Scene.Validate (validate)
import Visibility.Sweep
import Visibility.Test.Adversary
import Visibility.Test.BruteForce (bruteForce)

spec :: Spec
spec = do
  it "all have names of their own" $
    length (nub (map adversaryName kinds)) `shouldBe` length kinds
  it "touch in so many places, of nine parts" $
    [(kind, sceneContacts scene) | kind <- kinds, Right scene <- [validate (adversary kind 9)], sceneContacts scene > 0]
      `shouldBe` [(InOnePoint, 1), (InOnePointClosed, 9), (WallsInOnePoint, 1), (Saw, 9), (OneContact, 1)]
  for_ kinds $ \kind -> describe (adversaryName kind) $ do
    it "is valid, of every size" $
      [n | n <- [fewest kind .. 30] <> [1000], isLeft (validate (adversary kind n))] `shouldBe` []
    it "has the corners that were asked for" $
      [ (count, total)
      | count <- [30, 100, 1000, 10000]
      , let total = sum (map cornerTotal (polygons (adversary kind (adversaryParts kind count))))
      , total < count - 3 || total > count + 10
      ]
        `shouldBe` []
    it "has integer coordinates" $
      and [denominator x * denominator y == 1 | p <- polygons (adversary kind 50), Point x y <- rawCorners p]
        `shouldBe` True
    it "has the vertices that brute force finds" $
      [ n
      | n <- [fewest kind .. 6]
      , Right scene <- [validate (adversary kind n)]
      , sort (vertices scene) /= bruteForce scene
      ]
        `shouldBe` []
  where
    kinds = [minBound .. maxBound]
    fewest kind = case kind of
      Star -> 2
      ConvexRoom -> 3
      _ -> 1
    polygons raw = toList (rawEnclosure raw) <> rawPolygons raw
