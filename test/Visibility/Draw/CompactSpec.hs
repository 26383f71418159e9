{-# LANGUAGE OverloadedStrings #-}

module Visibility.Draw.CompactSpec (spec) where

import Data.Char (isAlpha, isDigit)
import qualified Data.Text.Lazy as Text
import Numeric (showFFloat)
import Test.Hspec
import Test.QuickCheck
import Visibility.Draw.Compact

spec :: Spec
spec = do
  describe "a path" $ do
    it "leads by the same places, to half a hundredth of a pixel" $
      forAll stepsSomewhere $ \steps ->
        let (long, short) = (wayOf (libraryText steps), wayOf (compacted steps))
         in counterexample (show (long, short)) $
              map fst long == map fst short
                && and [abs (a - b) <= 50 | ((_, as), (_, bs)) <- zip long short, (a, b) <- zip as bs]
    it "has places that are hundredths of a pixel" $
      forAll stepsSomewhere $ \steps ->
        [v | (_, vs) <- wayOf (compacted steps), v <- vs, v `rem` 100 /= 0] === []
    it "is written without what can be done without" $ do
      compactPath "M 84.0000,468.0000 v 6.0000 " `shouldBe` "M84 468v6"
      compactPath "M 84.0000,468.0000 v 6.0000 M 90.0000,0.0500 v -6.0000 v 0.0000 " `shouldBe` "M84 468v6M90 .05v-6 0"
      compactPath "M 1.0049,1.0050 l 0.0002,-0.0200 l 2.5000,30.0000 Z" `shouldBe` "M1 1.01l.01-.02 2.5 30Z"
      compactPath "M 0.0000,-0.7500 c 0.1000,0.0000 -0.1000,0.5000 2.0000 0.7500h 1.0000 "
        `shouldBe` "M0-.75c.1 0-.1 .5 2 .75h1"
  describe "a document" $
    it "keeps all that is no path" $
      compactPaths "<title>M 1.0000 &lt;path d=\"M 1.0000</title><g w=\"1.0000\"><path d=\"M 1.0000,2.0000 h 3.0000 \"/>1.0000"
        `shouldBe` "<title>M 1.0000 &lt;path d=\"M 1.0000</title><g w=\"1.0000\"><path d=\"M1 2h3\"/>1.0000"
  where
    compacted = Text.unpack . compactPath . Text.pack . libraryText

-- | A command, with numbers in units of 10⁻⁴.
type Step = (Char, [Int])

-- | Some subpaths with steps of all kinds and sizes.
stepsSomewhere :: Gen [Step]
stepsSomewhere = concat <$> resize 6 (listOf1 subpath)
  where
    subpath = do
      start <- (,) 'M' <$> vectorOf 2 (choose (-10 ^ (7 :: Int), 10 ^ (7 :: Int)))
      steps <- resize 12 (listOf (elements [('l', 2), ('h', 1), ('v', 1), ('c', 6)] >>= step))
      end <- elements [[], [('Z', [])]]
      pure (start : steps <> end)
    step (letter, count) = (,) letter <$> vectorOf count some
    some = oneof [choose (-200, 200), choose (-200000, 200000), pure 0]

-- | As the library writes it.
libraryText :: [Step] -> String
libraryText = concatMap text
  where
    text (letter, numbers) = case numbers of
      [] -> [letter]
      [x, y] -> letter : ' ' : number x <> "," <> number y <> " "
      [x] -> letter : ' ' : number x <> " "
      _ -> letter : ' ' : pairs numbers
    pairs list = case list of
      [x, y] -> number x <> " " <> number y
      x : y : others -> number x <> "," <> number y <> " " <> pairs others
      _ -> ""
    number v = showFFloat (Just 4) (fromIntegral v / 10000 :: Double) ""

-- | The places of a path, command by command, as the grammar of SVG has it: a command counts for all groups of numbers
-- that follow it.
wayOf :: String -> [(Char, [Int])]
wayOf = go (0, 0) (0, 0)
  where
    go here start text = case dropWhile (== ' ') text of
      'Z' : rest -> ('Z', []) : go start start rest
      letter : rest | isAlpha letter -> groups letter here start rest
      _ -> []
    groups letter here@(x, y) start text = case numbersIn (sizeOf letter) text of
      Nothing -> go here start text
      Just (numbers, rest) ->
        let to = case (letter, numbers) of
              ('h', [dx]) -> [x + dx, y]
              ('v', [dy]) -> [x, y + dy]
              ('M', _) -> numbers
              _ -> zipWith (+) (cycle [x, y]) numbers
            end = case drop (length to - 2) to of [a, b] -> (a, b); _ -> here
            start' = if letter == 'M' then end else start
         in (letter, to) : groups (if letter == 'M' then 'L' else letter) end start' rest
    sizeOf letter = case letter of
      'h' -> 1
      'v' -> 1
      'c' -> 6
      _ -> 2 :: Int
    numbersIn count text
      | count == 0 = Just ([], text)
      | otherwise = do
          (v, rest) <- numberIn (dropWhile (`elem` (" ," :: String)) text)
          (vs, end) <- numbersIn (count - 1) rest
          Just (v : vs, end)
    numberIn text = case text of
      '-' : rest -> (\(v, end) -> (negate v, end)) <$> unsigned rest
      _ -> unsigned text
    unsigned text =
      let (whole, rest) = span isDigit text
          (part, end) = case rest of
            '.' : more -> span isDigit more
            _ -> ("", rest)
       in if null (whole <> part) then Nothing else Just (read ('0' : whole <> take 4 (part <> "0000")), end)
