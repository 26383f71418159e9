-- | A perceptually uniform scale of colours, from dark to bright.
--
-- The scale is a helix in the space OKLab: lightness rises and hue turns at constant rates, chroma stays the same. So
-- equal steps are equally far apart, and whoever does not see the hues still sees the order.
--
-- /Source/ B. Ottosson, A perceptual color space for image processing, 2020 (OKLab); IEC 61966-2-1 (sRGB).
module Visibility.Draw.Colour
  ( -- * Shades
    Shade (..)
  , shadeAt
  , position
  , opposite
  , shades
    -- * Their colours
  , Lab (..)
  , labOf
  , rgbOf
  , hexText
  ) where

import Data.Colour (Colour)
import Data.Colour.SRGB (sRGB24show)
import Data.Colour.SRGB.Linear (rgb)

-- | A step of the scale, from 0, the darkest, to 100, the brightest.
newtype Shade = Shade Int
  deriving (Eq, Ord, Show)

-- | The number of the last step.
final :: Int
final = 100

-- | The step next to a position on the scale, 0 dark and 1 bright.
--
-- /Degenerate cases/ what lies before the scale, or is no number, is dark; what lies beyond it is bright.
shadeAt :: Double -> Shade
shadeAt t
  | t >= 1 = Shade final
  | t > 0 = Shade (round (t * fromIntegral final))
  | otherwise = Shade 0

-- | The position of a step: undoes 'shadeAt'.
position :: Shade -> Double
position (Shade k) = fromIntegral k / fromIntegral final

-- | The step as far from the bright end as this one is from the dark end.
opposite :: Shade -> Shade
opposite (Shade k) = Shade (final - k)

-- | All steps, from dark to bright.
shades :: [Shade]
shades = map Shade [0 .. final]

-- | A colour in OKLab: lightness from 0 to 1; from green to red; from blue to yellow.
data Lab = Lab !Double !Double !Double
  deriving (Eq, Show)

-- | The colour of a step: from a dark violet over red and orange to a light yellow.
--
-- /Laws/ lightness is linear in the position; neighbours are equally far apart.
labOf :: Shade -> Lab
labOf shade = Lab (between 0.25 0.92) (chroma * cos hue) (chroma * sin hue)
  where
    chroma = 0.15
    hue = between 280 470 * pi / 180
    between from to = from + position shade * (to - from)

-- | The colour of a step as screens show it.
--
-- /Laws/ nothing is clipped: each component is within 0 and 1.
rgbOf :: Shade -> Colour Double
rgbOf shade = rgb red green blue
  where
    Lab light a b = labOf shade
    -- The answers of the eye's three receptors.
    long = cubed (light + 0.3963377774 * a + 0.2158037573 * b)
    middle = cubed (light - 0.1055613458 * a - 0.0638541728 * b)
    short = cubed (light - 0.0894841775 * a - 1.2914855480 * b)
    red = 4.0767416621 * long - 3.3077115913 * middle + 0.2309699292 * short
    green = 2.6097574011 * middle - 1.2684380046 * long - 0.3413193965 * short
    blue = 1.7076147010 * short - 0.0041960863 * long - 0.7034186147 * middle
    cubed v = v * v * v

-- | @#rrggbb@, each component next to the colour's.
hexText :: Shade -> String
hexText = sRGB24show . rgbOf
