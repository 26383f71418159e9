module Visibility.Draw.PathSpec (spec) where

import Data.ByteString.Builder (Builder, toLazyByteString)
import qualified Data.ByteString.Lazy.Char8 as Bytes
import Data.Char (isAlpha, isDigit)
import Test.Hspec
import Test.QuickCheck
import Visibility.Draw.Drawing (Place (..))
import Visibility.Draw.Path

spec :: Spec
spec = describe "a path" $ do
  it "leads by its places, to half a hundredth of a pixel and what its steps add up" $
    forAll somePlaces $ \places ->
      let found = [(x, y) | (letter, [x, y]) <- wayOf (text (linePath height places)), letter /= 'Z']
          slack = 0.5e-2 + 1e-4 * fromIntegral (length places)
          near (x, y) (Place a b) = x `isAbout` a && y `isAbout` (height - b)
          isAbout v a = abs (fromIntegral v / 1e4 - a) <= slack
       in counterexample (show found) (length found == length places && and (zipWith near found places))
  it "has places that are hundredths of a pixel" $
    forAll somePlaces $ \places ->
      [v | (_, vs) <- wayOf (text (linePath height places)), v <- vs, v `rem` 100 /= 0] === []
  it "is written without what can be done without" $ do
    text (linePath 500 [Place 84 32, Place 84 26]) `shouldBe` "M84 468v6"
    text (foldMap (linePath 1) [[Place 84 0.95, Place 84 1.95], [Place 90 1.25, Place 91 1.25, Place 90.25 1.25]])
      `shouldBe` "M84 .05v-1M90-.25h1-.75"
    text (linePath 1 [Place 1.0049 (-0.005), Place 1.0051 0.015, Place 3.5051 (-29.985)])
      `shouldBe` "M1 1.01l.01-.02 2.5 30"
  it "goes around regions, dots and the ground" $ do
    text (regionPath 9 [Place 1 1, Place 3 1, Place 3 2]) `shouldBe` "M1 8h2v-1Z"
    text (squarePath 9 1 (Place 4 5)) `shouldBe` "M5 5l0-2h-2l0 2Z"
    text (groundPath 8 9) `shouldBe` "M8 9l0-9h-8l0 9Z"
    text (circlePath 9 1 (Place 4 5)) `shouldBe` "M5 4c0-.55-.45-1-1-1-.55 0-1 .45-1 1 0 .55 .45 1 1 1 .55 0 1-.45 1-1Z"
  where
    height = 500
    text :: Builder -> String
    text = Bytes.unpack . toLazyByteString

-- | Places in a row, some of them beside or above the one before.
somePlaces :: Gen [Place]
somePlaces = resize 12 (listOf1 place)
  where
    place = Place <$> coordinate <*> coordinate
    coordinate = oneof [choose (-100, 1000), elements [0, 0.005, 12.5, 300]]

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
