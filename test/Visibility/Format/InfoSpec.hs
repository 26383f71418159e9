module Visibility.Format.InfoSpec (spec) where

import Data.List (isPrefixOf)
import Test.Hspec
import Visibility.Count
import Visibility.Exact.Point (Arithmetic (..))
import Visibility.Format.Info
import Visibility.Scene
import Visibility.Sweep (Scheduler (..))
import Visibility.Test.Generator

spec :: Spec
spec = describe "infoText" $ do
  it "has a line for each size, and says how long it took" $
    fmap (lines . told Filtered) square
      `shouldBe` Just
        [ "polygons                  1"
        , "corners                   4"
        , "contacts                  0"
        , "vertices                  1"
        , "degenerate vertices       2"
        , "bitangents                4"
        , "elementary visible pairs  3"
        , "edges                     5"
        , "faces                     7"
        , "scheduler                 topological"
        , "arithmetic                filtered: the lattice fits machine integers (1-bit common denominator)"
        , "signs                     all in machine integers"
        , "time                      0.125 s"
        ]
  it "says what the arithmetic comes to" $ do
    fmap (arithmetic . told Filtered) huge
      `shouldBe` Just ["filtered: floating-point filter, integers behind it (1-bit common denominator)"]
    fmap (arithmetic . told Exact) square `shouldBe` Just ["exact: integers of any size"]
    fmap (arithmetic . told UnsafeDouble) square `shouldBe` Just ["double: unsafe, results may be wrong"]
  it "says how many signs there were, and how many the filter left to integers" $ do
    fmap (line "signs" . shown Filtered (Just (Signs 123456 383))) huge
      `shouldBe` Just ["123456, of them 383 (0.31 %) left to integers"]
    fmap (line "signs" . shown Filtered (Just (Signs 0 0))) huge
      `shouldBe` Just ["0, of them 0 (0.00 %) left to integers"]
    fmap (line "signs" . shown Filtered (Just (Signs 100000 1))) huge
      `shouldBe` Just ["100000, of them 1 (less than 0.01 %) left to integers"]
    fmap (line "signs" . told Exact) square `shouldBe` Just ["all in integers of any size"]
    fmap (line "signs" . told UnsafeDouble) square `shouldBe` Just ["all in Doubles"]
  where
    square = sampleScene <$> sampleOf [[(0, 0), (1, 0), (1, 1), (0, 1)]]
    huge = sampleScene <$> sampleOf [[(0, 0), (10 ^ (12 :: Int), 0), (1, 1)]]
    told chosen = shown chosen Nothing
    shown chosen signs scene = infoText (underArithmetic chosen scene) Topological (Counts 1 2 3 4 5 6 7) signs 0.125
    arithmetic = line "arithmetic"
    line name text = [drop 26 found | found <- lines text, name `isPrefixOf` found]
