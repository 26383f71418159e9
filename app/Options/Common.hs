-- | The options that commands on a scene share, and those of the graph.
module Options.Common
  ( Common (..)
  , commonOptions
  , memoryOption
    -- * The graph
  , GraphOptions (..)
  , LineOrder (..)
  , graphOptions
  ) where

import Data.Char (isDigit)
import Data.Word (Word64)
import Options.Applicative
import Options.Reader
import Text.Read (readMaybe)
import Visibility.Exact.Point (Arithmetic (..))
import Visibility.Format.Graph (PairSelection (..))
import Visibility.Sweep (Scheduler (..))

-- | What every command on a scene takes.
data Common = Common
  { sceneFile :: !FilePath
  , arithmeticChoice :: !Arithmetic
  , schedulerChoice :: !Scheduler
  , memoryChoice :: !(Maybe Word64)
  }

-- | Which lines of the graph, and in which order.
data GraphOptions = GraphOptions
  { pairSelection :: !PairSelection
  , lineOrder :: !LineOrder
  }

data LineOrder = ByName | AsSwept

commonOptions :: Parser Common
commonOptions = Common <$> scene <*> arithmetic <*> scheduler <*> memoryOption
  where
    scene = argument str (metavar "SCENE" <> help sources)
    sources = "A scene file: JSON, or as its ending says, .geojson or .wkt; - for JSON from standard input."
    arithmetic =
      option
        (oneOf [("filtered", Filtered), ("exact", Exact), ("double", UnsafeDouble)])
        ( long "arithmetic"
            <> metavar "filtered|exact|double"
            <> value Filtered
            <> showDefaultWith (const "filtered")
            <> help "How signs are decided. double is unsafe: wrong results are its purpose."
        )
    scheduler =
      option
        (oneOf [("topological", Topological), ("straight", Straight), ("reference", Reference)])
        ( long "scheduler"
            <> metavar "topological|straight|reference"
            <> value Topological
            <> showDefaultWith (const "topological")
            <> help
              "The order in which vertices are swept: any legal one, or by direction. The result is the same. \
              \reference sweeps as topological does, by a slower program that is written to be read."
        )

-- | How many bytes of memory a command may take.
memoryOption :: Parser (Maybe Word64)
memoryOption =
  optional . option (eitherReader size) $
    long "memory"
      <> metavar "SIZE"
      <> help
        "The most memory to take, such as 500M or 2G (of 1024M), from 16M on. Where more is needed, the command ends \
        \with exit code 6. Default: half of the machine's memory, or what a container or ulimit -v allows, if less."
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

graphOptions :: Parser GraphOptions
graphOptions =
  GraphOptions
    <$> flag
      AllPairs
      FreeBitangents
      (long "bitangents" <> help "Only pairs whose line is tangent at both corners; sides of polygons left out.")
    <*> flag
      ByName
      AsSwept
      (long "unsorted" <> help "Print pairs as they are swept, in memory that does not grow with them.")
