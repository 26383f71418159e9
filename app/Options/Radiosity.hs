-- | How radiosities are asked for.
module Options.Radiosity
  ( RadiosityOptions (..)
  , radiosityOptions
  ) where

import Data.Maybe (fromMaybe)
import qualified Data.Text as Text
import Options.Applicative
import Options.Mesh
import Options.Reader
import Visibility.Error (numberFaultText)
import Visibility.Exact.Rounding (digits)
import Visibility.Format.Number (readNumber)
import Visibility.Radiosity (Closeness (..), defaultTolerance, tolerance)

data RadiosityOptions = RadiosityOptions
  { radiosityElements :: !Elements
  , radiosityCloseness :: !Closeness
  }

-- | The options, or what does not go together.
radiosityOptions :: Parser (Either String RadiosityOptions)
radiosityOptions =
  (\chosen within' exact' -> chosen >>= combined within' exact')
    <$> elementsGiven
    <*> optional within
    <*> optional exact
  where
    within =
      option
        toleranceReader
        ( long "tolerance"
            <> metavar "X"
            <> help
              "How far the bounds of an element may be apart, as a part of the largest radiosity: an exact number \
              \such as 1e-12. Form factors are the nearest Doubles, which limits it. (default: 1e-9)"
        )
    exact =
      option
        (eitherReader (countOf "digits" 10000 digits))
        ( long "digits"
            <> metavar "N"
            <> help "Significant digits, from exact form factors; for small scenes. Bounds are rounded outwards."
        )
    combined (Just _) (Just _) _ = Left "--tolerance is met with Doubles: it goes without --digits"
    combined chosen Nothing elements = Right (made elements (WithinTolerance (fromMaybe defaultTolerance chosen)))
    combined Nothing (Just n) elements = Right (made elements (ToDigits n))
    made = RadiosityOptions . fromMaybe WholeSides
    toleranceReader = eitherReader $ \word ->
      case readNumber (Text.pack word) of
        Left why -> Left (show word <> numberFaultText why)
        Right x -> maybe (Left (word <> none)) Right (tolerance x)
    none = " is no tolerance: give a number between 0 and 1, such as 1e-12"
