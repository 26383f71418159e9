-- | Which figure is drawn.
module Options.Draw
  ( outputOption
    -- * What each figure takes
  , matrixFigure
  , viewFigure
  , meshFigure
  , lightFigure
  , sweepFigure
  ) where

import Command.Draw
import Data.Maybe (fromMaybe)
import Options.Applicative
import Options.Factors (place, toleranceGiven)
import Options.Mesh
import Options.Reader
import Visibility.Draw.Mesh (CastingLines (..))
import Visibility.Draw.Values (Scaling (..))
import Visibility.Radiosity (defaultTolerance)

-- | Where a figure goes; given is what may stand for the file.
outputOption :: String -> Parser (Maybe FilePath)
outputOption shape =
  optional . option (eitherReader (readingOf reading)) $
    short 'o' <> long "output" <> metavar shape <> completer (readingCompleter reading)
      <> help "Where to write. (default: standard output)"
  where
    reading = outputFile shape

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
