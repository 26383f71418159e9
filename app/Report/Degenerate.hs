-- | The degenerate scenes of the project, under each arithmetic: a part of the report's first section.
module Report.Degenerate
  ( Degenerate
  , degenerateScenes
  , degenerateText
  , degenerateTable
  , degenerateData
  ) where

import Control.Monad (forM)
import Data.List (isSuffixOf, nub, sort)
import Report.Measure
import Report.Paper
import Report.Verdict
import System.Directory (doesDirectoryExist, listDirectory)
import System.FilePath (dropExtension, (</>))
import Visibility.Exact.Point (Arithmetic (..))
import Visibility.Format.File (readSceneFile)
import Visibility.Scene
import Visibility.Sweep

-- | The folder, and what each way made of each of its scenes; 'Nothing' where there is no such folder.
data Degenerate = Degenerate !FilePath !(Maybe [Row])

data Row = Row
  { rowScene :: !String
  , rowWay :: !(String, String)
  -- ^ Arithmetic and scheduler.
  , rowVerdict :: !Verdict
  }

-- | Sweeps all valid scenes of a folder.
degenerateScenes :: (String -> IO ()) -> Plan -> FilePath -> IO Degenerate
degenerateScenes progress plan folder = do
  there <- doesDirectoryExist folder
  if there
    then do
      names <- sort . filter (".json" `isSuffixOf`) <$> listDirectory folder
      Degenerate folder . Just . concat <$> forM names (\name -> do
        progress ("degenerate scenes: " <> name)
        readSceneFile (folder </> name) >>= either (const (pure [])) (rowsOf name))
    else pure (Degenerate folder Nothing)
  where
    rowsOf name scene = do
      let truth = sort (bruteForce scene)
          row arithmetic scheduler = Row (dropExtension name) (arithmetic, scheduler)
          safe (word, arithmetic) (scheduler, sweep) =
            row word scheduler <$> vertexVerdict truth (verticesBy sweep (underArithmetic arithmetic scene))
      right <- sequence [safe arithmetic scheduler | arithmetic <- arithmetics, scheduler <- schedulers]
      unsafe <- forM schedulers $ \(word, _) -> row "double" word <$> unsafeVerdict plan word (folder </> name)
      pure (right <> unsafe)
    arithmetics = [("filtered", Filtered), ("exact", Exact), ("rational", RationalBaseline)]
    schedulers = [("topological", Topological), ("straight", Straight)]

degenerateText :: Degenerate -> String
degenerateText (Degenerate folder found) = case found of
  Nothing -> "The degenerate scenes of the project were left out: there was no folder `" <> folder <> "`."
  Just rows ->
    "The "
      <> show (length (nub (map rowScene rows)))
      <> " scenes of `"
      <> folder
      <> "` are small, each with one kind of degeneracy or just beside it: corners in line, verticals, contacts, \
         \walls. Doubles run in a process of their own, with the same limits, and their graph is compared with the \
         \exact one; the other arithmetics are compared with brute force in integers, vertex by vertex."

degenerateTable :: Degenerate -> [Table]
degenerateTable (Degenerate _ found) =
  [ Table
      "The degenerate scenes: on how many of them each arithmetic is right, wrong or without an answer, under each \
      \scheduler."
      ["arithmetic", "scheduler", "right", "wrong and nothing noticed", "refused by a law", "no answer otherwise"]
      [ [arithmetic, scheduler] <> map counted [(== Correct), unnoticed, (== NoAnswer Refused), otherwise']
      | way@(arithmetic, scheduler) <- nub (map rowWay rows)
      , let counted p = show (length [() | r <- rows, rowWay r == way, p (rowVerdict r)])
      ]
  | Just rows <- [found]
  ]
  where
    unnoticed verdict = case verdict of
      Wrong _ _ -> True
      _ -> False
    otherwise' verdict = case verdict of
      NoAnswer failure -> failure /= Refused
      _ -> False

degenerateData :: Degenerate -> [(FilePath, [[String]])]
degenerateData (Degenerate _ found) =
  [ ( "degenerate.csv"
    , ["scene", "arithmetic", "scheduler", "verdict", "missing", "spurious"]
        : [ [rowScene r, arithmetic, scheduler] <> verdictCells (rowVerdict r)
          | r <- rows
          , let (arithmetic, scheduler) = rowWay r
          ]
    )
  | Just rows <- [found]
  ]
