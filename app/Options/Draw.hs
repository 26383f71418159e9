-- | Which figure is drawn.
module Options.Draw
  ( DrawOptions (..)
  , Figure (..)
  , LightOptions (..)
  , Frames (..)
  , figureKind
  , figureOption
  ) where

import Data.Maybe (fromMaybe, isJust)
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
  | SweepFigure !Frames

-- | Which states of the sweep.
data Frames
  = -- | That after so many vertices.
    After !Int
  | -- | So many states from the first to the last, a file each in a folder.
    Spread !Int

-- | How radiosity is shown.
data LightOptions = LightOptions
  { lightElements :: !Elements
  , lightScaling :: !Scaling
  , lightProfiles :: ![SideName]
  -- ^ The sides that have a profile below the scene.
  }

-- | The word for a figure.
data FigureName = OfScene | OfDual | OfMatrix | OfView | OfMesh | OfRadiosity | OfSweep
  deriving (Eq)

-- | What is said besides the word.
data Said = Said
  { saidBreaks :: !(Maybe Breaks)
  , saidMesh :: !(Maybe MeshName)
  , saidMost :: !(Maybe ElementCount)
  , saidLines :: !(Maybe CastingLines)
  , saidScaling :: !(Maybe Scaling)
  , saidProfiles :: ![SideName]
  , saidFrames :: !(Maybe Frames)
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
        , ("sweep", OfSweep)
        ]
    )
    ( metavar "FIGURE"
        <> help
          "scene: the polygons and their free bitangents. dual: the arrangement of the corners' curves. \
          \matrix: the form factors, a coloured cell for each that is not zero. \
          \view: what is seen --from a point, a --corner or a --side. mesh: the break points of all sides. \
          \radiosity: how bright each element of each side is. \
          \sweep: both horizon trees of the topological sweep, --at a moment or in several --frames."
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
    <*> optional frames
  where
    frames =
      After <$> option (number "--at" 0) (long "at" <> metavar "K" <> help "Of the sweep: the state after K vertices.")
        <|> Spread
          <$> option
            (number "--frames" 2)
            ( long "frames"
                <> metavar "N"
                <> help "Of the sweep: N states from the first to the last, each in a file of the folder --output."
            )
    number name least = fromInteger <$> eitherReader (wholeNumber name least 1000000000)
    casting =
      flag Nothing (Just WithLines) $
        long "lines" <> help "Of a mesh: draw the lines that cast the break points too."
    logarithmic = flag Nothing (Just Logarithmic) (long "log" <> help "Of radiosity: a logarithmic scale of colours.")
    profiles =
      many . option (nameReader SideName) $
        long "profile" <> metavar "P.S" <> help "Of radiosity: plot it along this side; may be given several times."

figured :: FigureName -> Said -> Maybe From -> Either String Figure
figured name said from = do
  looking <- case (name, from) of
    (OfView, Nothing) -> Left "draw view needs --from X,Y, --corner P.K or --side P.S"
    (OfView, _) -> Right from
    (_, Nothing) -> Right Nothing
    _ -> Left "--from, --corner and --side are for the figure view"
  sequence_ [Left (word <> " is for " <> figures) | (word, True, names, figures) <- words', name `notElem` names]
  case name of
    OfScene -> Right SceneFigure
    OfDual -> Right DualFigure
    OfView -> maybe (Left "draw view needs a place") (Right . ViewFigure) looking
    OfMesh ->
      let chosen = MeshOptions (fromMaybe AllBreaks (saidBreaks said)) (saidMost said)
       in Right (MeshFigure (fromMaybe WithoutLines (saidLines said)) chosen)
    OfMatrix -> MatrixFigure . fromMaybe WholeSides <$> elementsFrom (saidMesh said) (saidMost said)
    OfRadiosity -> do
      chosen <- elementsFrom (saidMesh said <|> Just (CutAt AllBreaks)) (saidMost said)
      Right $
        LightFigure
          LightOptions
            { lightElements = fromMaybe WholeSides chosen
            , lightScaling = fromMaybe Linear (saidScaling said)
            , lightProfiles = saidProfiles said
            }
    OfSweep -> maybe (Left "draw sweep needs --at K or --frames N") (Right . SweepFigure) (saidFrames said)
  where
    words' =
      [ ("--breaks", isJust (saidBreaks said), [OfMesh], "the figure mesh")
      , ("--mesh", isJust (saidMesh said), [OfMatrix, OfRadiosity], "the figures matrix and radiosity")
      , ("--max-elements", isJust (saidMost said), [OfMesh, OfMatrix, OfRadiosity], cutFigures)
      , ("--lines", isJust (saidLines said), [OfMesh], "the figure mesh")
      , ("--log", isJust (saidScaling said), [OfRadiosity], "the figure radiosity")
      , ("--profile", not (null (saidProfiles said)), [OfRadiosity], "the figure radiosity")
      , ("--at", isAt, [OfSweep], "the figure sweep")
      , ("--frames", isJust (saidFrames said) && not isAt, [OfSweep], "the figure sweep")
      ]
    cutFigures = "the figures mesh, matrix and radiosity"
    isAt = case saidFrames said of Just (After _) -> True; _ -> False

figureOption :: Parser (Maybe FilePath)
figureOption =
  optional . strOption $
    short 'o' <> long "output" <> metavar "FILE.svg" <> help "Where to write; standard output if not given."
