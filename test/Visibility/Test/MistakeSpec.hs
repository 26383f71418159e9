module Visibility.Test.MistakeSpec (spec) where

import Data.Foldable (for_, toList)
import Data.List (nub)
import Test.Hspec
import Visibility.Scene.Validate (validate)
import Visibility.Test.Mistake

spec :: Spec
spec = do
  it "all have names of their own" $
    length (nub (map mistakeName kinds)) `shouldBe` length kinds
  for_ kinds $ \kind -> describe (mistakeName kind) $
    it "has as many errors as it says, all of one kind" $
      [ (n, found)
      | n <- [3 .. 12]
      , let found = either (map (head' . words . show) . toList) (const []) (validate (mistaken kind n))
      , found /= replicate (mistakes kind n) (constructor kind)
      ]
        `shouldBe` []
  where
    kinds = [minBound .. maxBound]
    head' = concat . take 1
    constructor kind = case kind of
      Points -> "TooFewCorners"
      Repeats -> "RepeatedCorner"
      FlatTriangles -> "ZeroArea"
      Spikes -> "Spike"
      SawOnItself -> "CornerOnSide"
      Twins -> "OverlappingPolygons"
      TwinWalls -> "OverlappingWalls"
      Lattice -> "CrossingSides"
      OneCrossing -> "CrossingSides"
      Dolls -> "NestedPolygon"
      Swallowed -> "NestedPolygon"
      LockedOut -> "OutsideEnclosure"
      FourthSides -> "NoSuchSide"
      Dark -> "BadEmission"
      Mirrors -> "BadReflectivity"
