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

import Data.List (intercalate, stripPrefix)
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

-- | The elements that are asked for, if that is said, or what does not go together. Given is what they are else.
elementsGiven :: String -> Parser (Either String (Maybe Elements))
elementsGiven usual = elementsFrom <$> optional (meshGiven usual) <*> optional mostGiven

elementsFrom :: Maybe MeshName -> Maybe ElementCount -> Either String (Maybe Elements)
elementsFrom mesh most = case (mesh, most) of
  (Nothing, Nothing) -> Right Nothing
  (Just NoMesh, Nothing) -> Right (Just WholeSides)
  (Just (CutAt breaks), _) -> Right (Just (ElementsOf (MeshOptions breaks most)))
  (_, Just _) -> Left "--max-elements goes with a --mesh other than sides"

-- | Given is what the elements are where it is not.
meshGiven :: String -> Parser MeshName
meshGiven usual =
  given
    (breaksOr CutAt [("sides", NoMesh), ("discontinuity", CutAt AllBreaks), ("shadow-limits", CutAt OnlyShadowLimits)])
    "mesh"
    "What the elements are: whole sides, or what break points cut them into: those of the discontinuity mesh, those of \
    \them where shadows end, or N equal parts."
    (Default usual)

breaksGiven :: Parser Breaks
breaksGiven =
  given
    (breaksOr id [("all", AllBreaks), ("shadow-limits", OnlyShadowLimits)])
    "breaks"
    "Where sides are cut: where lines land, where shadows end, or into N equal parts."
    (Default "all")

mostGiven :: Parser ElementCount
mostGiven =
  given
    (counted "N" greatest "8" elementCount)
    "max-elements"
    "At most N elements on each side, but one for each part that nothing covers: drops break points, kinks first, then \
    \those whose elements are short; those of both faces of a thin wall count on each. The JSON lists what was dropped."
    (Default "no limit")

-- Some words, or equal parts.
breaksOr :: (Breaks -> a) -> [(String, a)] -> Reading a
breaksOr made choices =
  Reading (intercalate "|" shapes) (readingBounds parts) (listCompleter (names <> ["uniform:"])) $ \word ->
    case (lookup word choices, stripPrefix "uniform:" word) of
      (Just choice, _) -> Right choice
      (_, Just number) -> made . Uniform <$> either (Left . ("uniform: " <>)) Right (readingOf parts number)
      _ -> Left (word <> " is none of: " <> intercalate ", " shapes <> near word)
  where
    near word = meant (takeWhile (/= ':') word) (names <> ["uniform"])
    names = map fst choices
    shapes = names <> ["uniform:N"]
    parts = counted "N" greatest "10" elementCount

-- The most elements that a side may be cut into.
greatest :: Integer
greatest = 1000000
