-- | Which break points a mesh has.
module Options.Mesh
  ( MeshOptions (..)
  , Breaks (..)
  , meshOptions
    -- * Elements
  , Elements (..)
  , MeshName (..)
  , elementsGiven
  , elementsFrom
    -- * What is said
  , meshGiven
  , breaksGiven
  , mostGiven
  , ElementCount
  ) where

import Data.List (stripPrefix)
import Data.Maybe (fromMaybe)
import Options.Applicative
import Options.Reader
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

-- | What has form factors and a radiosity of its own.
data Elements
  = -- | Every side.
    WholeSides
  | -- | What the break points of a mesh cut sides into.
    ElementsOf !MeshOptions

-- | What @--mesh@ names.
data MeshName = NoMesh | CutAt !Breaks

-- | The elements that are asked for, if that is said, or what does not go together.
elementsGiven :: Parser (Either String (Maybe Elements))
elementsGiven = elementsFrom <$> optional meshGiven <*> optional mostGiven

elementsFrom :: Maybe MeshName -> Maybe ElementCount -> Either String (Maybe Elements)
elementsFrom mesh most = case (mesh, most) of
  (Nothing, Nothing) -> Right Nothing
  (Just NoMesh, Nothing) -> Right (Just WholeSides)
  (Just (CutAt breaks), _) -> Right (Just (ElementsOf (MeshOptions breaks most)))
  (_, Just _) -> Left "--max-elements goes with a --mesh other than sides"

meshGiven :: Parser MeshName
meshGiven =
  option
    (eitherReader named)
    ( long "mesh"
        <> metavar "sides|discontinuity|shadow-limits|uniform:N"
        <> help
          "What the elements are: whole sides, or what break points cut them into: those of the discontinuity mesh, \
          \those of them where shadows end, or N equal parts."
    )
  where
    named word = case word of
      "sides" -> Right NoMesh
      "discontinuity" -> Right (CutAt AllBreaks)
      "all" -> Left (notOne word)
      _ -> either (const (Left (notOne word))) (Right . CutAt) (breaksNamed word)
    notOne word = word <> " is none of: sides, discontinuity, shadow-limits, uniform:N"

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
          "At most N elements on each side, but one for each part that nothing covers: drops break points, kinks \
          \first, then those whose elements are short; those of both faces of a thin wall count on each. The JSON \
          \lists what was dropped."
    )

breaksNamed :: String -> Either String Breaks
breaksNamed word = case (word, stripPrefix "uniform:" word) of
  ("all", _) -> Right AllBreaks
  ("shadow-limits", _) -> Right OnlyShadowLimits
  (_, Just number) -> Uniform <$> count "uniform" number
  _ -> Left (word <> " is none of: all, shadow-limits, uniform:N")

count :: String -> String -> Either String ElementCount
count name = countOf name 1000000 elementCount
