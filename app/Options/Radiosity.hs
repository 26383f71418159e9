-- | How radiosities are asked for.
module Options.Radiosity
  ( RadiosityOptions (..)
  , radiosityOptions
  , toleranceGiven
  ) where

import Data.Maybe (fromMaybe)
import Options.Applicative
import Options.Mesh
import Options.Reader
import Visibility.Exact.Rounding (digits)
import Visibility.Radiosity (Closeness (..), Tolerance, defaultTolerance, tolerance)

data RadiosityOptions = RadiosityOptions
  { radiosityElements :: !Elements
  , radiosityCloseness :: !Closeness
  }

-- | The options, or what does not go together.
radiosityOptions :: Parser (Either String RadiosityOptions)
radiosityOptions =
  (\chosen within' exact' -> chosen >>= combined within' exact')
    <$> elementsGiven "sides"
    <*> optional toleranceGiven
    <*> optional exact
  where
    exact =
      given
        (counted "N" 10000 "50" digits)
        "digits"
        "Significant digits, from exact form factors; for small scenes. Bounds are rounded outwards."
        (Default "none; --tolerance holds")
    combined (Just _) (Just _) _ = Left "--tolerance is met with Doubles: it goes without --digits"
    combined chosen Nothing elements = Right (made elements (WithinTolerance (fromMaybe defaultTolerance chosen)))
    combined Nothing (Just n) elements = Right (made elements (ToDigits n))
    made = RadiosityOptions . fromMaybe WholeSides

toleranceGiven :: Parser Tolerance
toleranceGiven =
  given
    (Reading "X" "X is an exact number as in files, above 0 and below 1, such as 1e-12." mempty toleranceOf)
    "tolerance"
    "How far the bounds of an element may be apart, as a part of the largest radiosity. Form factors are the nearest \
    \Doubles, which limits it."
    (Default "1e-9")
  where
    toleranceOf word = exactNumber word >>= maybe (Left (word <> none)) Right . tolerance
    none = " is no tolerance: give a number above 0 and below 1, such as 1e-12"
