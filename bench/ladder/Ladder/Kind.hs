-- | The kinds of scenes that the ladder climbs.
module Ladder.Kind
  ( Kind (..)
  , kinds
  , kindsNamed
  ) where

import Bench.Scenes
import qualified Data.Text as Text
import Visibility.Scene.Family
import Visibility.Scene.Raw
import Visibility.Test.Adversary
import Visibility.Test.Generator (sizeOfCorners)

-- | Scenes by about how many corners they have.
data Kind = Kind
  { kindName :: !String
  , kindScene :: Int -> RawScene
  }

-- | The families of the program, and those that only the tests have.
kinds :: [Kind]
kinds =
  [Kind (Text.unpack (familyName kind)) (alight . rawOf kind . sizeOfCorners kind) | kind <- [minBound ..]]
    <> [Kind (adversaryName kind) (alight . adversary kind . adversaryParts kind) | kind <- [minBound ..]]

-- | The kinds of these names, all if there are none; or the names that no kind has.
kindsNamed :: [String] -> Either [String] [Kind]
kindsNamed names = case (names, filter (`notElem` map kindName kinds) names) of
  ([], _) -> Right kinds
  (_, []) -> Right (filter ((`elem` names) . kindName) kinds)
  (_, unknown) -> Left unknown
