-- | Which figure is drawn.
module Options.Draw
  ( DrawOptions (..)
  , Figure (..)
  , LightOptions (..)
  , Frames (..)
    -- * What each figure takes
  , drawOptions
  , matrixFigure
  , viewFigure
  , meshFigure
  , lightFigure
  , sweepFigure
  ) where

import Data.Maybe (fromMaybe)
import Options.Applicative
import Options.Mesh
import Options.Radiosity (toleranceGiven)
import Options.Reader
import Options.View
import Visibility.Draw.Mesh (CastingLines (..))
import Visibility.Draw.Values (Scaling (..))
import Visibility.Radiosity (Tolerance, defaultTolerance)

data DrawOptions = DrawOptions
  { figure :: !Figure
  , figureFile :: !(Maybe FilePath)
  }

data Figure
  = SceneFigure
  | DualFigure
  | MatrixFigure !Elements
  | ViewFigure !From
  | MeshFigure !CastingLines !MeshOptions
  | LightFigure !LightOptions
  | SweepFigure !Frames

-- | Which states of the sweep.
data Frames
  = -- | That after so many vertices.
    After !Integer
  | -- | So many states from the first to the last, a file each in a folder.
    Spread !Integer

-- | How radiosity is shown.
data LightOptions = LightOptions
  { lightElements :: !Elements
  , lightScaling :: !Scaling
  , lightTolerance :: !Tolerance
  , lightProfiles :: ![Address]
  -- ^ The sides that have a profile below the scene.
  }

-- | A figure, or what is wrong with it, and where it goes; given is what may stand for the file.
drawOptions :: String -> Parser (Either String Figure) -> Parser (Either String DrawOptions)
drawOptions shape chosen = (\wanted file -> (`DrawOptions` file) <$> wanted) <$> chosen <*> optional output
  where
    output =
      option (eitherReader (readingOf reading)) $
        short 'o' <> long "output" <> metavar shape <> completer (readingCompleter reading)
          <> help "Where to write. (default: standard output)"
    reading = outputFile shape

matrixFigure :: Parser (Either String Figure)
matrixFigure = fmap (MatrixFigure . fromMaybe WholeSides) <$> elementsGiven "sides"

viewFigure :: Parser (Either String Figure)
viewFigure = fmap ViewFigure <$> place

meshFigure :: Parser (Either String Figure)
meshFigure = (\wanted cast -> Right (MeshFigure cast wanted)) <$> meshOptions <*> casting
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
      (\cut -> LightFigure (LightOptions (fromMaybe WholeSides cut) scaled (fromMaybe defaultTolerance close) sides))
        <$> elementsFrom (mesh <|> Just (CutAt AllBreaks)) most
    scaling = flag Linear Logarithmic (long "log" <> help "A logarithmic scale of colours.")
    profile = given (address "S") "profile" "Plot it along this side; may be given several times." (Default "none")

sweepFigure :: Parser (Either String Figure)
sweepFigure = maybe (Left "give --at K or --frames N") (Right . SweepFigure) <$> optional (at <|> frames)
  where
    at = After <$> given (reading "K" 0 "20") "at" "The state after K vertices, at most all of the sweep." one
    frames =
      Spread
        <$> given
          (reading "N" 2 "10")
          "frames"
          "N states from the first to the last, each in a file of the folder --output."
          one
    one = Default "none; --at or --frames is required"
    reading letter least = wholeNumber letter least (10 ^ (9 :: Int))
