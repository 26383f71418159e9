-- | Which break points a mesh has.
module Options.Mesh
  ( MeshOptions (..)
  , Breaks (..)
  , meshOptions
  ) where

import Data.List (stripPrefix)
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
meshOptions = MeshOptions <$> breaks <*> optional most
  where
    breaks =
      option
        (eitherReader breaksNamed)
        ( long "breaks"
            <> metavar "all|shadow-limits|uniform:N"
            <> value AllBreaks
            <> showDefaultWith (const "all")
            <> help "Where sides are cut: where lines land, where shadows end, or into N equal parts."
        )
    most =
      option
        (eitherReader (count "max-elements"))
        ( long "max-elements"
            <> metavar "N"
            <> help
              "At most N elements on each side: drops break points, kinks first, then those whose elements are short, \
              \and lists what it dropped."
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
