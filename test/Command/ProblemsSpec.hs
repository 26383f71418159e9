-- | How many problems of a scene are told: twenty of a kind and the number of the rest, or all.
module Command.ProblemsSpec (spec) where

import Command.Run
import Data.Foldable (for_)
import Data.List (intercalate, isInfixOf, isSubsequenceOf)
import Test.Hspec

spec :: Spec
spec = do
  it "up to twenty of a kind are told as they are" $ do
    (code, out, err) <- run ["info", "-"] (twins 6 <> "\n")
    (code, out, length (lines err)) `shouldBe` (4, "", 15)
    (_, _, all') <- run ["info", "--all-errors", "-"] (twins 6)
    err `shouldBe` all'
  it "of more, twenty are told and the others are counted, kind by kind" $ do
    (code, out, err) <- run ["graph", "-"] (twins 30)
    (code, out, length (lines err)) `shouldBe` (4, "", 21)
    drop 20 (lines err)
      `shouldBe` [ "viscomplex: standard input: and 415 more like this: polygon 0: overlaps polygon 1; \
                   \--all-errors tells all"
                 ]
    (_, _, mixed) <- run ["info", "-"] (scene (replicate 25 (object "\"emission\": -1, \"reflectivity\": 1")))
    length (lines mixed) `shouldBe` 63
    for_ ["280 more like this: polygon 0: overlaps", "5 more like this: polygon 0: emission is -1"] $ \phrase ->
      mixed `shouldSatisfy` isInfixOf phrase
  it "those that are told are the first of each kind, in their order" $ do
    let bad = scene (replicate 25 (object "\"emission\": -1"))
    (_, _, brief) <- run ["info", "-"] bad
    (code, _, all') <- run ["info", "--all-errors", "-"] bad
    (code, length (lines all')) `shouldBe` (4, 325)
    filter (not . isInfixOf "more like this") (lines brief) `shouldSatisfy` (`isSubsequenceOf` lines all')
  it "problems of the text are counted as well" $ do
    (code, _, err) <- run ["info", "-"] (scene (replicate 40 "[[\"x\", 0], [1], [0, 1]]"))
    (code, length (lines err)) `shouldBe` (3, 42)
    err `shouldSatisfy` isInfixOf "and 20 more like this: $.polygons[0][0][0]: \"x\" is not a number;"
  it "every command on a scene tells all of them if it is asked" $
    for_ commands $ \command -> do
      (code, _, err) <- run (words command <> ["-", "--all-errors"]) (twins 8)
      (command, code, length (lines err)) `shouldBe` (command, 4, 28)
  it "of 3 000 triangles in one place, which overlap four million times, a hundred thousand problems are looked at" $ do
    (code, out, err) <- run ["info", "-", "--memory", "64M"] (twins 3000)
    (code, out, length (lines err)) `shouldBe` (4, "", 21)
    err `shouldSatisfy` isInfixOf "and at least 99980 more like this: polygon 0: overlaps polygon 1; so many"
  it "all are told in memory that does not grow with their number" $
    for_ [twins 150, scene (crossing 100), scene [star 301]] $ \many -> do
      (code, _, err) <- run ["info", "-", "--memory", "20M", "--all-errors"] many
      (code, length (lines err) >= 10000) `shouldBe` (4, True)
  where
    scene polygons = "{\"polygons\": [" <> intercalate ", " polygons <> "]}"
    triangle = "[[0, 0], [4, 0], [0, 4]]"
    twins n = scene (replicate n triangle)
    object more = "{\"corners\": " <> triangle <> ", " <> more <> "}"
    crossing n =
      [corners [(0, k), (n + 1, k)] | k <- [1 .. n]] <> [corners [(k, 0), (k, n + 1)] | k <- [1 .. n :: Int]]
    -- Each side crosses nearly all others: corners on a parabola, from one half to the other and back.
    star :: Int -> String
    star n = corners [(x, x * x) | k <- [0 .. n - 1], let x = k * (n `div` 2) `mod` n]
    corners points = "[" <> intercalate ", " ["[" <> show x <> ", " <> show y <> "]" | (x, y) <- points] <> "]"
    commands =
      words "info graph complex factors mesh radiosity verify"
        <> ["view --corner 0.0", "draw scene", "draw sweep --at 1"]
