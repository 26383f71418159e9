module Visibility.Draw.ColourSpec (spec) where

import Data.Char (digitToInt)
import Data.Colour.SRGB (RGB (..), toSRGB)
import Test.Hspec
import Test.QuickCheck
import Visibility.Draw.Colour

spec :: Spec
spec = do
  describe "shadeAt" $ do
    it "is undone by position" $
      map (shadeAt . position) shades `shouldBe` shades
    it "is monotone" $
      property $ \s t -> (s :: Double) <= t ==> shadeAt s <= shadeAt t
    it "keeps to the scale" $
      map shadeAt [-1 / 0, -3, 0 / 0, 1, 7, 1 / 0] `shouldBe` map (shades !!) [0, 0, 0, 100, 100, 100]
    it "is off by at most half a step" $
      forAll (choose (0, 1)) $ \t -> abs (position (shadeAt t) - t) <= 0.5 / 100 + 1e-12
  describe "opposite" $
    it "turns the scale round" $
      map opposite shades `shouldBe` reverse shades
  describe "the colours" $ do
    it "rise in lightness by the same amount at each step" $
      [rise | rise <- zipWith (-) (drop 1 lightnesses) lightnesses, not (near 1e-12 (0.67 / 100) rise)] `shouldBe` []
    it "are equally far from their neighbours" $
      [d | d <- steps, abs (d / (sum steps / 100) - 1) > 0.03] `shouldBe` []
    it "are in the gamut, without clipping" $
      [rgb | rgb@(RGB r g b) <- map (toSRGB . rgbOf) shades, any (\v -> not (v >= 0 && v <= 1)) [r, g, b]] `shouldBe` []
    it "are those of OKLab, by its definition from sRGB" $
      [shade | shade <- shades, distance (labOf shade) (labFrom (toSRGB (rgbOf shade))) > 1e-6] `shouldBe` []
    it "as they are written are in the order of lightness, and of luminance, which is all that grey keeps" $ do
      let written = map (readHex . hexText) shades
      written `shouldSatisfy` increasing . map (\rgb -> let Lab l _ _ = labFrom rgb in l)
      written `shouldSatisfy` increasing . map luminance
    it "do not come near to white or black" $
      [shade | shade <- shades, ground <- [Lab 1 0 0, Lab 0 0 0], distance (labOf shade) ground < 0.15] `shouldBe` []
  where
    lightnesses = [l | Lab l _ _ <- map labOf shades]
    -- From what screens show.
    steps = let labs = map (labFrom . toSRGB . rgbOf) shades in zipWith distance labs (drop 1 labs)
    near most x y = abs (x - y) <= most
    increasing values = and (zipWith (<) values (drop 1 values))

distance :: Lab -> Lab -> Double
distance (Lab l a b) (Lab l' a' b') = sqrt ((l - l') ^ (2 :: Int) + (a - a') ^ (2 :: Int) + (b - b') ^ (2 :: Int))

-- | The other way: linear light, the receptors' answers, their cube roots.
labFrom :: RGB Double -> Lab
labFrom rgb =
  Lab
    (0.2104542553 * long + 0.7936177850 * middle - 0.0040720468 * short)
    (1.9779984951 * long - 2.4285922050 * middle + 0.4505937099 * short)
    (0.0259040371 * long + 0.7827717662 * middle - 0.8086757660 * short)
  where
    (r, g, b) = linear rgb
    long = root (0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b)
    middle = root (0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b)
    short = root (0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b)
    root v = v ** (1 / 3)

linear :: RGB Double -> (Double, Double, Double)
linear (RGB r g b) = (expanded r, expanded g, expanded b)
  where
    expanded v
      | v <= 0.04045 = v / 12.92
      | otherwise = ((v + 0.055) / 1.055) ** 2.4

luminance :: RGB Double -> Double
luminance rgb = let (r, g, b) = linear rgb in 0.2126 * r + 0.7152 * g + 0.0722 * b

readHex :: String -> RGB Double
readHex text = case map (fromIntegral . digitToInt) (drop 1 text) of
  [a, b, c, d, e, f] -> RGB ((16 * a + b) / 255) ((16 * c + d) / 255) ((16 * e + f) / 255)
  _ -> RGB (0 / 0) (0 / 0) (0 / 0)
