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
        , "time                      0.125 s"
        ]
  it "says what the arithmetic comes to" $ do
    fmap (arithmetic . told Filtered) huge
      `shouldBe` Just ["filtered: floating-point filter, integers behind it (1-bit common denominator)"]
    fmap (arithmetic . told Exact) square `shouldBe` Just ["exact: integers of any size"]
    fmap (arithmetic . told UnsafeDouble) square `shouldBe` Just ["double: unsafe, results may be wrong"]
  where
    square = sampleScene <$> sampleOf [[(0, 0), (1, 0), (1, 1), (0, 1)]]
    huge = sampleScene <$> sampleOf [[(0, 0), (10 ^ (12 :: Int), 0), (1, 1)]]
    told chosen scene = infoText (underArithmetic chosen scene) Topological (Counts 1 2 3 4 5 6 7) 0.125
    arithmetic text = [drop 26 found | found <- lines text, "arithmetic" `isPrefixOf` found]
