-- | Which figure is drawn.
module Options.Draw
  ( DrawOptions (..)
  , Figure (..)
  , LightOptions (..)
  , figureKind
  , figureOption
  ) where

import Data.Maybe (fromMaybe)
import Options.Applicative
import Options.Mesh
import Options.Reader
import Options.View
import Visibility.Draw.Mesh (CastingLines (..))
import Visibility.Draw.Values (Scaling (..))
import Visibility.Scene (SideName (..))

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

-- | How radiosity is shown.
data LightOptions = LightOptions
  { lightElements :: !Elements
  , lightScaling :: !Scaling
  , lightProfiles :: ![SideName]
  -- ^ The sides that have a profile below the scene.
  }

-- | The word for a figure.
data FigureName = OfScene | OfDual | OfMatrix | OfView | OfMesh | OfRadiosity
  deriving (Eq)

-- | What is said besides the word.
data Said = Said
  { saidBreaks :: !(Maybe Breaks)
  , saidMesh :: !(Maybe MeshName)
  , saidMost :: !(Maybe ElementCount)
  , saidLines :: !(Maybe CastingLines)
  , saidScaling :: !(Maybe Scaling)
  , saidProfiles :: ![SideName]
  }

-- | The figure, or why there is none of this kind.
figureKind :: Parser (Either String Figure)
figureKind = (\name from said -> from >>= figured name said) <$> figureName <*> place <*> saidBesides

figureName :: Parser FigureName
figureName =
  argument
    ( oneOf
        [ ("scene", OfScene)
        , ("dual", OfDual)
        , ("matrix", OfMatrix)
        , ("view", OfView)
        , ("mesh", OfMesh)
        , ("radiosity", OfRadiosity)
        ]
    )
    ( metavar "FIGURE"
        <> help
          "scene: the polygons and their free bitangents. dual: the arrangement of the corners' curves. \
          \matrix: the form factors, a coloured cell for each that is not zero. \
          \view: what is seen --from a point, a --corner or a --side. mesh: the break points of all sides. \
          \radiosity: how bright each element of each side is."
    )

saidBesides :: Parser Said
saidBesides =
  Said
    <$> optional breaksGiven
    <*> optional meshGiven
    <*> optional mostGiven
    <*> casting
    <*> logarithmic
    <*> profiles
  where
    casting =
      flag Nothing (Just WithLines) $
        long "lines" <> help "Of a mesh: draw the lines that cast the break points too."
    logarithmic = flag Nothing (Just Logarithmic) (long "log" <> help "Of radiosity: a logarithmic scale of colours.")
    profiles =
      many . option (nameReader SideName) $
        long "profile" <> metavar "P.S" <> help "Of radiosity: plot it along this side; may be given several times."

figured :: FigureName -> Said -> Maybe From -> Either String Figure
figured name said from = case (name, from) of
  (OfView, Just looking) -> ViewFigure looking <$ unsaid [breaks, mesh, most, cast, scaling, profiles]
  (OfView, Nothing) -> Left "draw view needs --from X,Y, --corner P.K or --side P.S"
  (_, Just _) -> Left "--from, --corner and --side are for the figure view"
  (OfScene, Nothing) -> SceneFigure <$ unsaid [breaks, mesh, most, cast, scaling, profiles]
  (OfDual, Nothing) -> DualFigure <$ unsaid [breaks, mesh, most, cast, scaling, profiles]
  (OfMesh, Nothing) -> do
    unsaid [mesh, scaling, profiles]
    Right $
      MeshFigure
        (fromMaybe WithoutLines (saidLines said))
        (MeshOptions (fromMaybe AllBreaks (saidBreaks said)) (saidMost said))
  (OfMatrix, Nothing) -> do
    unsaid [breaks, cast, scaling, profiles]
    MatrixFigure . fromMaybe WholeSides <$> elementsFrom (saidMesh said) (saidMost said)
  (OfRadiosity, Nothing) -> do
    unsaid [breaks, cast]
    chosen <- elementsFrom (saidMesh said <|> Just (CutAt AllBreaks)) (saidMost said)
    Right $
      LightFigure
        LightOptions
          { lightElements = fromMaybe WholeSides chosen
          , lightScaling = fromMaybe Linear (saidScaling said)
          , lightProfiles = saidProfiles said
          }
  where
    unsaid = sequence_
    given word figures isSaid = if isSaid then Left (word <> " is for " <> figures) else Right ()
    breaks = given "--breaks" "the figure mesh" (isSet (saidBreaks said))
    mesh = given "--mesh" "the figures matrix and radiosity" (isSet (saidMesh said))
    most = given "--max-elements" "the figures mesh, matrix and radiosity" (isSet (saidMost said))
    cast = given "--lines" "the figure mesh" (isSet (saidLines said))
    scaling = given "--log" "the figure radiosity" (isSet (saidScaling said))
    profiles = given "--profile" "the figure radiosity" (not (null (saidProfiles said)))
    isSet :: Maybe a -> Bool
    isSet = maybe False (const True)

figureOption :: Parser (Maybe FilePath)
figureOption =
  optional . strOption $
    short 'o' <> long "output" <> metavar "FILE.svg" <> help "Where to write; standard output if not given."
