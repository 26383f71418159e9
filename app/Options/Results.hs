-- | How form factors, radiosities, views and figures are asked for.
module Options.Results
  ( factorOptions
  , radiosityOptions
  , viewOptions
    -- * Figures
  , matrixFigure
  , viewFigure
  , meshFigure
  , lightFigure
  , sweepFigure
  ) where

import Command.Draw
import Command.Elements (runRadiosity)
import Command.Query (FactorValues (..), runFactors)
import Command.View (From (..), runView)
import Data.Maybe (fromMaybe)
import Options.Applicative
import Options.Common (Common)
import Options.Mesh
import Options.Reader
import Visibility.Draw.Mesh (CastingLines (..))
import Visibility.Draw.Values (Scaling (..))
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.Rounding (Digits, defaultDigits, digitCount, digits)
import Visibility.Format.Factors (Detail (..), FactorFormat (..))
import Visibility.Radiosity (Closeness (..), Tolerance, defaultTolerance, tolerance)

-- | Form factors, or what does not go together; so of the others.
factorOptions :: Parser (Either String (Common -> IO ()))
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
    combined wanted (Just chosen) Nothing DecimalsOnly = Right (asked wanted chosen)
    combined _ (Just _) (Just _) _ = Left "--double prints Doubles: it goes without --digits"
    combined _ (Just _) Nothing WithExactMeasures = Left "--double prints Doubles: it goes without --exact"
    combined wanted Nothing count detail =
      Right (asked wanted (Decimals (fromMaybe defaultDigits count) detail))
    asked wanted chosen elements common = runFactors common wanted chosen elements

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

radiosityOptions :: Parser (Either String (Common -> IO ()))
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
    made elements close common = runRadiosity common (fromMaybe WholeSides elements) close

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

-- | Where one looks from, or what is wrong with what is said of it.
place :: Parser (Either String From)
place = combined <$> point <*> corner <*> side <*> normal
  where
    point = optional (given (pair "X,Y") "from" "A point in free space or on a boundary, in the scene's unit." needed)
    corner = optional (given (address "K") "corner" "A corner." needed)
    side = optional (given (address "S") "side" "A side." needed)
    normal =
      optional $
        given
          (direction "DX,DY")
          "normal"
          "Form factors of a small element that faces this way; no --side."
          (Default "none: the visibility polygon")
    needed = Default "none; one of --from, --corner and --side is required"
    combined (Just (x, y)) Nothing Nothing facing = Right (FromPoint (Point x y) facing)
    combined Nothing (Just name) Nothing facing = Right (FromCorner name facing)
    combined Nothing Nothing (Just name) Nothing = Right (FromSide name)
    combined Nothing Nothing (Just _) (Just _) = Left "--normal goes with --from or --corner, not with --side"
    combined Nothing Nothing Nothing (Just _) = Left "--normal needs --from X,Y or --corner P.K"
    combined Nothing Nothing Nothing Nothing = Left "give --from X,Y, --corner P.K or --side P.S"
    combined _ _ _ _ = Left "give one of --from, --corner and --side, not more"

viewOptions :: Parser (Either String (Common -> IO ()))
viewOptions = complete <$> place <*> digitsOption <*> detailOption
  where
    complete from wanted detail = (\known common -> runView common known wanted detail) <$> from

matrixFigure :: Parser (Either String Figure)
matrixFigure = fmap (drawMatrix . fromMaybe WholeSides) <$> elementsGiven "sides"

viewFigure :: Parser (Either String Figure)
viewFigure = fmap drawView <$> place

meshFigure :: Parser (Either String Figure)
meshFigure = (\wanted cast -> Right (drawMesh cast wanted)) <$> meshOptions <*> casting
  where
    casting = flag WithoutLines WithLines (long "lines" <> help "Draw the lines that cast the break points too.")

lightFigure :: Parser (Either String Figure)
lightFigure =
  lit
    <$> optional (meshGiven "discontinuity")
    <*> optional mostGiven
    <*> scaling
    <*> optional toleranceGiven
    <*> many profile
  where
    lit mesh most scaled close sides =
      (\cut -> drawLight (fromMaybe WholeSides cut) scaled (fromMaybe defaultTolerance close) sides)
        <$> elementsFrom (mesh <|> Just (CutAt AllBreaks)) most
    scaling = flag Linear Logarithmic (long "log" <> help "A logarithmic scale of colours.")
    profile = given (address "S") "profile" "Plot it along this side; may be given several times." (Default "none")

sweepFigure :: Parser (Either String Figure)
sweepFigure = maybe (Left "give --at K or --frames N") Right <$> optional (at <|> frames)
  where
    at = drawMoment <$> given (reading "K" 0 "20") "at" "The state after K vertices, at most all of the sweep." one
    frames =
      drawFrames
        <$> given
          (reading "N" 2 "10")
          "frames"
          "N states from the first to the last, each in a file of the folder --output."
          one
    one = Default "none; --at or --frames is required"
    reading letter least = wholeNumber letter least (10 ^ (9 :: Int))
