-- | The options that commands on a scene share, and those of the graph.
module Options.Common
  ( Common (..)
  , commonOptions
    -- * The graph
  , GraphOptions (..)
  , LineOrder (..)
  , graphOptions
  ) where

import Options.Applicative
import Options.Reader
import Visibility.Exact.Point (Arithmetic (..))
import Visibility.Format.Graph (PairSelection (..))
import Visibility.Sweep (Scheduler (..))

-- | What every command on a scene takes.
data Common = Common
  { sceneFile :: !FilePath
  , arithmeticChoice :: !Arithmetic
  , schedulerChoice :: !Scheduler
  }

-- | Which lines of the graph, and in which order.
data GraphOptions = GraphOptions
  { pairSelection :: !PairSelection
  , lineOrder :: !LineOrder
  }

data LineOrder = ByName | AsSwept

commonOptions :: Parser Common
commonOptions = Common <$> scene <*> arithmetic <*> scheduler
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
