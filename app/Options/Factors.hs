-- | How form factors are written.
module Options.Factors
  ( FactorOptions (..)
  , FactorValues (..)
  , factorOptions
    -- * For others that write some
  , digitsOption
  , detailOption
  ) where

import Data.Maybe (fromMaybe)
import Options.Applicative
import Options.Mesh
import Options.Reader
import Visibility.Exact.Rounding (Digits, defaultDigits, digitCount, digits)
import Visibility.Format.Factors (Detail (..), FactorFormat (..))

data FactorOptions = FactorOptions
  { factorFormat :: !FactorFormat
  , factorValues :: !FactorValues
  , factorElements :: !Elements
  }

-- | What stands for a form factor.
data FactorValues
  = -- | A decimal of so many digits, correctly rounded, and perhaps the exact measure.
    Decimals !Digits !Detail
  | -- | The nearest Double.
    NearestDoubles

-- | The options, or what does not go together.
factorOptions :: Parser (Either String FactorOptions)
factorOptions =
  (\chosen made -> ($) <$> made <*> chosen)
    <$> (elementsChosen <$> elementsFlag <*> optional (meshGiven usually) <*> optional mostGiven)
    <*> (combined <$> format <*> double <*> optional digitsGiven <*> detailOption)
  where
    usually = "sides; with --elements, discontinuity"
    -- The mesh where none is named.
    elementsFlag =
      flag
        Nothing
        (Just (CutAt AllBreaks))
        ( long "elements"
            <> help "Form factors of elements instead of sides, such as 0.0#3: those of the --mesh, by default the \
                    \discontinuity mesh."
        )
    elementsChosen usual mesh most = fromMaybe WholeSides <$> elementsFrom (mesh <|> usual) most
    format =
      given
        (words' [("csv", FactorsCsv), ("json", FactorsJson), ("text", FactorsText)])
        "format"
        "Output format."
        (Default "csv")
        <|> pure FactorsCsv
    double =
      flag
        Nothing
        (Just NearestDoubles)
        ( long "double"
            <> help
              "Print the Double nearest to each form factor, as the shortest decimal that is read back as it. As \
              \exact as the rest, and much faster. A form factor of 2^-1075 or less is listed as 0; a side's length \
              \beyond the range of Doubles is printed with 17 digits."
        )
    combined wanted (Just chosen) Nothing DecimalsOnly = Right (FactorOptions wanted chosen)
    combined _ (Just _) (Just _) _ = Left "--double prints Doubles: it goes without --digits"
    combined _ (Just _) Nothing WithExactMeasures = Left "--double prints Doubles: it goes without --exact"
    combined wanted Nothing count detail =
      Right (FactorOptions wanted (Decimals (fromMaybe defaultDigits count) detail))

digitsOption :: Parser Digits
digitsOption = fromMaybe defaultDigits <$> optional digitsGiven

digitsGiven :: Parser Digits
digitsGiven =
  given
    (counted "N" 1000000 "30" digits)
    "digits"
    "Significant digits of form factors, correctly rounded."
    (Default (show (digitCount defaultDigits)))

detailOption :: Parser Detail
detailOption =
  flag
    DecimalsOnly
    WithExactMeasures
    (long "exact" <> help "Also print form factors, where there are any, as exact sums of square roots.")
