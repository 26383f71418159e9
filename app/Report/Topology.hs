{-# LANGUAGE OverloadedStrings #-}

-- | The report's first section: arithmetic and scheduler on the ladder and on hard scenes.
module Report.Topology
  ( topologySection
  , graphErrors
  ) where

import Control.Monad (forM)
import qualified Data.ByteString.Char8 as Bytes
import Data.List (sort)
import qualified Data.Set as Set
import Report.Measure
import Report.Paper
import Report.Scenes
import Visibility.Count (Signs (..), countingSigns)
import Visibility.Draw.Drawing (Style (..))
import Visibility.Exact.Point (Arithmetic (..))
import Visibility.Exact.RootSum (Sign (Zero), sign)
import Visibility.FormFactor (closureDefect, measures)
import Visibility.Report.Plot
import Visibility.Scene
import Visibility.Scene.Family (Family (..))
import Visibility.Sweep

-- | One arithmetic and scheduler on one scene.
data Row = Row
  { rowCase :: !Case
  , rowPairs :: !Int
  , rowArithmetic :: !String
  , rowScheduler :: !String
  , rowSeconds :: !(Maybe Double)
  , rowOutcome :: !String
  , rowMissing, rowSpurious, rowOpen :: !(Maybe Int)
  , rowSigns :: !(Maybe Signs)
  }

topologySection :: (String -> IO ()) -> Plan -> FilePath -> IO Section
topologySection progress plan folder = do
  ladder <- mapM (saved . familyCase folder Random) (ladderSizes plan)
  others <-
    mapM (saved . uncurry (familyCase folder)) $
      [(kind, otherSize plan) | kind <- [Grid, Needles, Checkerboard, Terraces, ThinWalls, Comb]] <> [(Kettner, k) | k <- [8, 40]]
  large <- saved (rawCase folder "random-128-times-3^40" (enlarged (3 ^ (40 :: Int)) (familyCase folder Random 128)))
  rows <- concat <$> forM (ladder <> [large] <> others) (\found -> progress ("topology: " <> caseName found) >> rowsOf plan found)
  pure
    Section
      { sectionTitle = "Topology: arithmetic and scheduler"
      , sectionText =
          [ "Time is the least processor time of several sweeps in this process, of a scene that has been read and checked, \
            \per elementary visible pair. *filtered* is machine integers where they provably fit, else a floating-point \
            \filter with integers behind it; *exact* is integers of any size; *rational* is determinants of rationals; \
            \*double* has no bound and may be wrong. The topological sweep takes vertices in any legal order, the straight \
            \one by direction; brute force asks every pair of corners from the definition."
          , "Doubles were first tried in a process of their own, with a time limit: `viscomplex graph --arithmetic double`. \
            \Its lines were compared with the exact ones; only where it came to an end was it timed here. *Open sides* are \
            \those whose form factors do not add up to one, decided exactly, on the topology that Doubles found."
          ]
      , sectionTables =
          [ Table
              "Every arithmetic and scheduler on every scene. Signs: how many the filter was asked, and the share that it left to integers; empty where machine integers decide all."
              ["scene", "corners", "pairs", "arithmetic", "scheduler", "µs per pair", "outcome", "missing", "spurious", "open sides", "signs", "left"]
              (map cellsOf rows)
          ]
      , sectionFigures = [Figure "topology.svg" (ladderPlot ladder rows) caption]
      , sectionData =
          [ ( "topology.csv"
            , ["scene", "corners", "pairs", "arithmetic", "scheduler", "us_per_pair", "outcome", "missing", "spurious", "open_sides", "signs", "signs_left"]
                : map rawCells rows
            )
          ]
      }
  where
    caption =
      "Random quadrilaterals: processor time per elementary visible pair against the number of corners, for each arithmetic \
      \under the topological sweep, and for the straight sweep and brute force in filtered arithmetic. A level line is time \
      \in proportion to the output. Doubles gain nothing on machine integers, and rationals cost more than ten times as \
      \much where the line for rationals lies a decade higher."

rowsOf :: Plan -> Case -> IO [Row]
rowsOf plan found = do
  (seconds, exactFound) <- bestTime (runs plan) scene (length . vertices)
  let truth = sort (vertices scene)
      pairs = pairsSwept (finish scene)
      row arithmetic scheduler = Row found pairs arithmetic scheduler
      agreed list = let s = Set.fromList list in (Set.size (Set.fromList truth Set.\\ s), Set.size (s Set.\\ Set.fromList truth))
      safe name arithmetic scheduler = do
        let under = underArithmetic arithmetic scene
        (t, _) <- bestTime (runs plan) under (length . verticesBy scheduler)
        let (missing, extra) = agreed (verticesBy scheduler under)
        pure (row name (schedulerWord scheduler) (Just t) "finished" (Just missing) (Just extra) (Just 0) Nothing)
  (_, signs) <- countingSigns scene (\watched -> pure $! length (vertices watched))
  straight <- safe "filtered" Filtered Straight
  exact <- mapM (safe "exact" Exact) (if small (10 * slowLimit plan) then [Topological, Straight] else [])
  rational <- mapM (safe "rational" RationalBaseline) (if small (slowLimit plan) then [Topological, Straight] else [])
  brute <-
    if small (bruteForceLimit plan)
      then do
        (t, list) <- bestTime 1 scene bruteForce
        let (missing, extra) = agreed list
        pure [row "filtered" "brute force" (Just t) "finished" (Just missing) (Just extra) (Just 0) Nothing]
      else pure []
  unsafe <- mapM (unsafeRow plan found pairs) [Topological, Straight]
  pure $
    row "filtered" "topological" (Just seconds) "finished" (Just (length truth - exactFound)) (Just 0) (Just 0) signs
      : straight : exact <> rational <> unsafe <> brute
  where
    scene = caseScene found
    small limit = cornerCount scene <= limit

schedulerWord :: Scheduler -> String
schedulerWord Topological = "topological"
schedulerWord Straight = "straight"

-- | Doubles: first in a process of their own.
unsafeRow :: Plan -> Case -> Int -> Scheduler -> IO Row
unsafeRow plan found pairs scheduler = do
  outcome <- runChild (timeLimit plan) ["graph", "--arithmetic", "double", "--scheduler", schedulerWord scheduler, caseFile found]
  let row = Row found pairs "double" (schedulerWord scheduler)
  case outcome of
    Finished _ printed -> do
      exact <- runChild (timeLimit plan) ["graph", caseFile found]
      let (missing, extra) = graphErrors exact printed
      (seconds, _) <- bestTime (runs plan) under (length . verticesBy scheduler)
      open <- ended (length [() | (_, defect) <- closureDefect under (measures under (verticesBy scheduler under)), sign defect /= Zero])
      pure (row (Just seconds) (outcomeWord outcome) missing extra open Nothing)
    _ -> pure (row Nothing (outcomeWord outcome) Nothing Nothing Nothing Nothing)
  where
    under = underArithmetic UnsafeDouble (caseScene found)

-- | How many lines of the exact graph are missing, and how many others there are.
graphErrors :: Outcome -> Bytes.ByteString -> (Maybe Int, Maybe Int)
graphErrors (Finished _ exact) printed = (Just (Set.size (a Set.\\ b)), Just (Set.size (b Set.\\ a)))
  where
    a = Set.fromList (Bytes.lines exact)
    b = Set.fromList (Bytes.lines printed)
graphErrors _ _ = (Nothing, Nothing)

cellsOf, rawCells :: Row -> [String]
cellsOf row =
  opening row
    <> [maybe "" (micro . (/ fromIntegral (rowPairs row))) (rowSeconds row), rowOutcome row]
    <> map (maybe "" show) [rowMissing row, rowSpurious row, rowOpen row]
    <> case rowSigns row of
      Just (Signs decided left) -> [show decided, sig (100 * fromIntegral left / fromIntegral (max 1 decided)) <> " %"]
      Nothing -> ["", ""]
rawCells row =
  opening row
    <> [maybe "" (show . (* 1e6) . (/ fromIntegral (rowPairs row))) (rowSeconds row), rowOutcome row]
    <> map (maybe "" show) [rowMissing row, rowSpurious row, rowOpen row]
    <> maybe ["", ""] (\(Signs decided left) -> [show decided, show left]) (rowSigns row)

opening :: Row -> [String]
opening row = [caseName (rowCase row), show (cornerCount (caseScene (rowCase row))), show (rowPairs row), rowArithmetic row, rowScheduler row]

ladderPlot :: [Case] -> [Row] -> Plot
ladderPlot ladder rows =
  Plot
    { plotTitle = "Time per visible pair on random quadrilaterals"
    , plotDescription = "Microseconds per elementary visible pair against the number of corners, both logarithmic, by arithmetic and scheduler."
    , plotAcross = "corners"
    , plotUpwards = "µs per visible pair"
    , plotSeries =
        [ series "filtered, topological" Series1 Circle "filtered" "topological"
        , series "filtered, straight" Series2 Square "filtered" "straight"
        , series "double, topological" Series3 Cross "double" "topological"
        , series "exact, topological" Series4 Triangle "exact" "topological"
        , series "rational, topological" Series5 Diamond "rational" "topological"
        , series "brute force" Series6 Plus "filtered" "brute force"
        ]
    }
  where
    series name style marker arithmetic scheduler =
      Series name style marker $
        [ (fromIntegral (cornerCount (caseScene (rowCase r))), 1e6 * t / fromIntegral (rowPairs r))
        | r <- rows
        , caseName (rowCase r) `elem` map caseName ladder
        , rowArithmetic r == arithmetic
        , rowScheduler r == scheduler
        , Just t <- [rowSeconds r]
        ]
