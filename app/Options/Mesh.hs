-- | Which break points a mesh has.
module Options.Mesh
  ( MeshOptions (..)
  , Breaks (..)
  , meshOptions
    -- * Of a figure
  , MeshFigureOptions (..)
  , meshFigureOptions
  , plainMeshFigure
  ) where

import Data.List (stripPrefix)
import Data.Maybe (fromMaybe)
import Options.Applicative
import Options.Reader
import Visibility.Draw.Mesh (CastingLines (..))
import Visibility.Mesh (ElementCount, elementCount)

data MeshOptions = MeshOptions
  { meshBreaks :: !Breaks
  , mostElements :: !(Maybe ElementCount)
  -- ^ On each side.
  }

data Breaks
  = AllBreaks
  | OnlyShadowLimits
  | -- | Each side cut into so many equal parts.
    Uniform !ElementCount

meshOptions :: Parser MeshOptions
meshOptions = MeshOptions . fromMaybe AllBreaks <$> optional breaksGiven <*> optional mostGiven

-- | A mesh as a figure shows it.
data MeshFigureOptions = MeshFigureOptions
  { figureMesh :: !MeshOptions
  , castingLines :: !CastingLines
  }

-- | What is said of the mesh of a figure; 'Nothing' if nothing is.
meshFigureOptions :: Parser (Maybe MeshFigureOptions)
meshFigureOptions = combined <$> optional breaksGiven <*> optional mostGiven <*> lines'
  where
    lines' = flag WithoutLines WithLines (long "lines" <> help "Of a mesh: draw the lines that cast the break points too.")
    combined Nothing Nothing WithoutLines = Nothing
    combined breaks most wanted = Just (MeshFigureOptions (MeshOptions (fromMaybe AllBreaks breaks) most) wanted)

-- | The whole mesh, without lines.
plainMeshFigure :: MeshFigureOptions
plainMeshFigure = MeshFigureOptions (MeshOptions AllBreaks Nothing) WithoutLines

breaksGiven :: Parser Breaks
breaksGiven =
  option
    (eitherReader breaksNamed)
    ( long "breaks"
        <> metavar "all|shadow-limits|uniform:N"
        <> help "Where sides are cut: where lines land, where shadows end, or into N equal parts. (default: all)"
    )

mostGiven :: Parser ElementCount
mostGiven =
  option
    (eitherReader (count "max-elements"))
    ( long "max-elements"
        <> metavar "N"
        <> help
          "At most N elements on each side: drops break points, kinks first, then those whose elements are short. The \
          \JSON lists what was dropped."
    )

breaksNamed :: String -> Either String Breaks
breaksNamed word = case (word, stripPrefix "uniform:" word) of
  ("all", _) -> Right AllBreaks
  ("shadow-limits", _) -> Right OnlyShadowLimits
  (_, Just number) -> Uniform <$> count "uniform" number
  _ -> Left (word <> " is none of: all, shadow-limits, uniform:N")

count :: String -> String -> Either String ElementCount
count name word =
  wholeNumber name 1 1000000 word >>= maybe (Left "give 1 element or more") Right . elementCount . fromInteger
