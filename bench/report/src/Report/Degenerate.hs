-- | The degenerate scenes of the project, under each arithmetic: a part of the report's first section.
module Report.Degenerate
  ( degenerateScenes
  , degenerateText
  , degenerateTable
  , degenerateData
  ) where

import Control.Monad (forM)
import Data.List (isSuffixOf, nub, sort)
import Report.Arithmetic (exactArithmetics)
import Report.Measure
import Report.Paper
import Report.Verdict
import System.Directory (listDirectory)
import System.FilePath (dropExtension, (</>))
import Visibility.Format.File (readSceneFile)
import Visibility.Sweep
import Visibility.Test.BruteForce (bruteForce)

data Row = Row
  { rowScene :: !String
  , rowWay :: !(String, String)
  -- ^ Arithmetic and scheduler.
  , rowVerdict :: !Verdict
  }

-- | Sweeps all valid scenes of the project's folder.
degenerateScenes :: Plan -> IO [Row]
degenerateScenes plan = do
  names <- sort . filter (".json" `isSuffixOf`) <$> listDirectory degenerate
  fmap concat . forM names $ \name -> do
    progress plan ("degenerate scenes: " <> name)
    readSceneFile (degenerate </> name) >>= either (const (pure [])) (rowsOf name)
  where
    rowsOf name scene = do
      let truth = sort (bruteForce scene)
          row arithmetic scheduler = Row (dropExtension name) (arithmetic, scheduler)
          safe (word, arithmetic) (scheduler, sweep) =
            row word scheduler <$> vertexVerdict truth (verticesBy sweep (arithmetic scene))
      right <- sequence [safe arithmetic scheduler | arithmetic <- exactArithmetics, scheduler <- schedulers]
      unsafe <- forM schedulers $ \(word, _) -> row "double" word <$> unsafeVerdict plan word (degenerate </> name)
      pure (right <> unsafe)
    schedulers = [("topological", Topological), ("straight", Straight)]

degenerateText :: [Row] -> String
degenerateText rows =
  "The "
    <> show (length (nub (map rowScene rows)))
    <> " scenes of `"
    <> degenerate
    <> "` are small, each with one kind of degeneracy or just beside it: corners in line, verticals, contacts, walls. \
       \Doubles run in a process of their own, with the same limits, and their graph is compared with the exact one; \
       \the other arithmetics are compared with brute force in integers, vertex by vertex."

degenerateTable :: [Row] -> Table
degenerateTable rows =
  Table
    "The degenerate scenes: on how many of them each arithmetic is right, wrong or without an answer, under each \
    \scheduler."
    ["arithmetic", "scheduler", "right", "wrong and nothing noticed", "refused by a law", "no answer otherwise"]
    [ [arithmetic, scheduler] <> map counted [(== Correct), unnoticed, (== NoAnswer Refused), otherwise']
    | way@(arithmetic, scheduler) <- nub (map rowWay rows)
    , let counted p = show (length [() | r <- rows, rowWay r == way, p (rowVerdict r)])
    ]
  where
    unnoticed verdict = case verdict of
      Wrong _ _ -> True
      _ -> False
    otherwise' verdict = case verdict of
      NoAnswer failure -> failure /= Refused
      _ -> False

degenerateData :: [Row] -> (FilePath, [[String]])
degenerateData rows =
  ( "degenerate.csv"
  , ["scene", "arithmetic", "scheduler", "verdict", "missing", "spurious"]
      : [ [rowScene r, arithmetic, scheduler] <> verdictCells (rowVerdict r)
        | r <- rows
        , let (arithmetic, scheduler) = rowWay r
        ]
  )

-- | Where the degenerate scenes of the project are, from its root.
degenerate :: FilePath
degenerate = "scenes/degenerate"
