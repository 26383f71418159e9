-- | The options that commands share.
module Options.Common
  ( Common (..)
  , Telling (..)
  , commonOptions
  , talkOption
  , memoryOption
  ) where

import Data.Char (isDigit)
import Data.Word (Word64)
import Options.Applicative
import Options.Reader
import Progress (Talk (..))
import Text.Read (readMaybe)
import Visibility.Exact.Point (Arithmetic (..))
import Visibility.Sweep (Scheduler (..))

-- | What every command on a scene takes.
data Common = Common
  { sceneFile :: !FilePath
  , arithmeticChoice :: !Arithmetic
  , schedulerChoice :: !Scheduler
  , talk :: !Talk
  , memoryChoice :: !(Maybe Word64)
  , telling :: !Telling
  }

-- | How much is told of what is wrong with a scene.
data Telling = TellBriefly | TellAll

commonOptions :: Parser Common
commonOptions = Common <$> scene <*> arithmetic <*> scheduler <*> talkOption <*> memoryOption <*> allErrors
  where
    scene =
      argument str $
        metavar (readingShape inputFile) <> completer (readingCompleter inputFile) <> help
          "A scene file: JSON, or as its ending says, .geojson or .wkt; - for JSON from standard input."
    arithmetic =
      given
        (words' [("filtered", Filtered), ("exact", Exact), ("double", UnsafeDouble)])
        "arithmetic"
        "How signs are decided. double is unsafe: wrong results are its purpose."
        (Default "filtered")
        <|> pure Filtered
    scheduler =
      given
        (words' [("topological", Topological), ("straight", Straight), ("reference", Reference)])
        "scheduler"
        "The order in which vertices are swept: any legal one, or by direction. The result is the same. \
        \reference sweeps as topological does, by a slower program that is written to be read."
        (Default "topological")
        <|> pure Topological
    allErrors =
      flag TellBriefly TellAll $
        long "all-errors"
          <> help "Tell all that is wrong with the scene, not only twenty faults of a kind and how many more."

talkOption :: Parser Talk
talkOption =
  flag Talkative Quiet (long "quiet" <> help "Say nothing on standard error but errors: no progress, no warnings.")

-- | How many bytes of memory a command may take.
memoryOption :: Parser (Maybe Word64)
memoryOption =
  optional $
    given
      (Reading "SIZE" "SIZE is from 16M to 1024T, such as 500M or 2G (of 1024M)." mempty size)
      "memory"
      "The most memory to take. Where more is needed, the command ends with exit code 6."
      (Default "half of the machine's memory, or what a container or ulimit -v allows, if less")
  where
    size word = case span isDigit word of
      (number, unit)
        | Just bytes <- lookup unit units
        , length number < 20
        , Just wanted <- (* bytes) <$> readMaybe number
        , 16 * 1024 * 1024 <= wanted
        , wanted <= 1024 ^ (5 :: Int) ->
            Right (fromInteger wanted)
      _ -> Left (show word <> " is not a size from 16M to 1024T, such as 500M or 2G")
    units = zip ["", "K", "M", "G", "T"] (iterate (* 1024) 1)
