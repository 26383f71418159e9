{-# LANGUAGE OverloadedStrings #-}

-- | The report's first section: arithmetic and scheduler on the ladder and on hard scenes.
module Report.Topology
  ( topologySection
  ) where

import Control.Monad (forM)
import Data.List (sort)
import qualified Data.Text as Text
import Report.Arithmetic
import Report.Closure
import Report.Degenerate
import Report.Measure
import Report.Paper
import Report.Scenes
import Report.Verdict
import Visibility.Exact.Point (Arithmetic (..))
import Report.Plot
import Visibility.Scene
import Visibility.Scene.Family (Family (..), familyPurpose)
import Visibility.Sweep
import Visibility.Test.BruteForce (bruteForce)

-- | One arithmetic and scheduler on one scene.
data Row = Row
  { rowCase :: !Case
  , rowPairs :: !Int
  , rowArithmetic :: !String
  , rowScheduler :: !String
  , rowSeconds :: !(Maybe Double)
  , rowVerdict :: !Verdict
  , rowOpen :: !(Maybe Int)
  , rowSigns :: !(Maybe Signs)
  }

topologySection :: Plan -> IO Section
topologySection plan = do
  ladder <- mapM (sizedCase . (,) Random) (ladderSizes plan)
  others <-
    mapM sizedCase $
      [(kind, otherSize plan) | kind <- [Grid, Needles, Checkerboard, Terraces, ThinWalls, Comb]]
        <> [(Kettner, k) | k <- [8, 40]]
  let small = familyCase (folder plan) Random (largeSize plan)
  large <- saved (rawCase (folder plan) (caseName small <> "-times-3^40") (enlarged (3 ^ (40 :: Int)) small))
  let beyond = (large, caseName small <> ", 3^40 times as large: beyond machine integers")
      sized = ladder <> [beyond] <> others
  rows <- concat <$> forM sized (\(found, _) -> do
    progress plan ("topology: " <> caseName found)
    rowsOf plan found)
  commands <- forM (map fst (ladder <> [beyond])) $ \found -> do
    progress plan ("topology: commands on " <> caseName found)
    times <- forM graphCommands (\arguments -> leastClock plan (arguments <> [caseFile found]))
    pure (found, zip (map unwords graphCommands) times)
  degenerate <- degenerateScenes plan
  pure
    Section
      { sectionTitle = "Topology: arithmetic and scheduler"
      , sectionText =
          [ "An *elementary visible pair* is two corners whose open segment is in free space, with no corner on it; a \
            \sweep gives them all. Time is processor time of a sweep in this process, of a scene that has been read \
            \and checked, "
              <> leastOf plan
              <> ". *filtered* is machine integers where they provably fit, else a floating-point filter with \
                 \integers behind it; *exact* is integers of any size; *rational* is determinants of rationals, but of \
                 \those of the lattice, whose denominators are one, not of the file's; *double* has no bound and may \
                 \be wrong. The topological sweep takes vertices in any legal order, the straight one by direction; \
                 \the *reference* is the topological sweep as a text, in pure steps over persistent maps, here in \
                 \filtered arithmetic; brute force asks every pair of corners from the definition, and is left out \
                 \above "
              <> show (bruteForceLimit plan)
              <> " corners, the rationals above "
              <> show (slowLimit plan)
              <> "."
          , "The verdict is on all vertices, the lines through two corners or more, against the straight sweep in \
            \integers: right, or how many are *missing* and how many *spurious*. Doubles are first tried in a process \
            \of their own, `viscomplex graph --arithmetic double`, with at most "
              <> limitsOf plan
              <> "; only where that comes to an end are they judged and timed here. *Open sides* are those whose form \
                 \factors do not add up to what is not covered of them, decided exactly, on the topology found; they \
                 \are left out above "
              <> show (closureLimit plan)
              <> " corners and for brute force."
          , "Doubles, on "
              <> show (length sized)
              <> " scenes under two schedulers each: "
              <> verdictsText [rowVerdict r | r <- rows, rowArithmetic r == "double"]
          , degenerateText degenerate
          ]
      , sectionTables =
          [ Table
              "The scenes, all but the enlarged one as `viscomplex generate FAMILY --size N --seed 1` writes them."
              ["scene", "corners", "elementary visible pairs", "what it is"]
              [sizesOf found <> [what] | (found, what) <- sized]
          , Table
              "Every arithmetic and scheduler on every scene: processor time in µs per elementary visible pair, the \
              \verdict on the vertices, and the number of open sides. Signs: how many the filter was asked, and the \
              \share that it left to integers; it decided the others. Empty where machine integers decide all, and \
              \counted under the topological sweep only."
              ( words "scene corners pairs arithmetic scheduler"
                  <> ["µs per pair", "verdict", "missing", "spurious", "open sides"]
                  <> ["signs asked of the filter", "left to integers"]
              )
              (map cellsOf rows)
          , Table
              ( "Whole commands, from the start of the process to its end, reading and printing included, by the \
                \clock, "
                  <> leastOf plan
                  <> ": `graph` prints the visible pairs in the order of their names, `graph --unsorted` as they are \
                     \swept."
              )
              (["scene", "corners", "pairs"] <> map unwords graphCommands)
              [sizesOf found <> map (timeCell . snd) times | (found, times) <- commands]
          ]
            <> [degenerateTable degenerate]
      , sectionFigures = [Figure "topology.svg" (ladderPlot (map fst ladder) rows) caption]
      , sectionData =
          [ ( "topology.csv"
            , words "scene corners pairs arithmetic scheduler us_per_pair verdict missing spurious open_sides"
                <> ["signs", "signs_left"]
                : map rawCells rows
            )
          , ( "topology-commands.csv"
            , words "scene corners pairs command seconds"
                : [sizesOf found <> [name, maybe "" show time] | (found, times) <- commands, (name, time) <- times]
            )
          , degenerateData degenerate
          ]
      }
  where
    sizedCase (kind, n) = do
      found <- saved (familyCase (folder plan) kind n)
      pure (found, Text.unpack (familyPurpose kind) <> "; N = " <> show n)
    graphCommands = [["graph"], ["graph", "--unsorted"]]
    sizesOf found =
      [caseName found, show (cornerCount (caseScene found)), show (pairsOf (caseScene found))]
    caption =
      "Random quadrilaterals: processor time in µs per elementary visible pair against the number of corners, both \
      \logarithmic, for each arithmetic under the topological sweep, and for the straight sweep and the reference in \
      \filtered arithmetic and brute force in integers. Lower is better; a level line is time in proportion to the output. The rational \
      \baseline computes on lattice integers, with denominator 1."

pairsOf :: Scene -> Int
pairsOf scene = sum (map (length . vertexPairs scene) (vertices scene))

rowsOf :: Plan -> Case -> IO [Row]
rowsOf plan found = do
  let truth = sort (straightVertices (underArithmetic Exact scene))
      pairs = pairsOf scene
      row arithmetic scheduler = Row found pairs arithmetic scheduler
      safe (name, arithmetic) scheduler = do
        let under = arithmetic scene
        (t, _) <- bestTime (runs plan) under (length . verticesBy scheduler)
        verdict <- vertexVerdict truth (verticesBy scheduler under)
        let open = if small (closureLimit plan) then Just (closureOpen (closureExactly scheduler under)) else Nothing
        pure (row name (schedulerWord scheduler) (Just t) verdict open Nothing)
  signs <- countingSigns scene (length . vertices)
  right <-
    sequence
      [ safe way scheduler
      | way@(name, _) <- exactArithmetics
      , name /= "rational" || small (slowLimit plan)
      , scheduler <- [Topological, Straight] <> [Reference | name == "filtered"]
      ]
  brute <-
    if small (bruteForceLimit plan)
      then do
        (t, list) <- bestTime 1 scene bruteForce
        verdict <- vertexVerdict truth list
        pure [row "integers" "brute force" (Just t) verdict Nothing Nothing]
      else pure []
  unsafe <- mapM (unsafeRow plan found pairs truth) [Topological, Straight]
  pure ([if counted r then r {rowSigns = signs} else r | r <- right] <> unsafe <> brute)
  where
    scene = caseScene found
    small limit = cornerCount scene <= limit
    counted r = rowArithmetic r == "filtered" && rowScheduler r == "topological"

schedulerWord :: Scheduler -> String
schedulerWord Topological = "topological"
schedulerWord Straight = "straight"
schedulerWord Reference = "reference"

-- | Doubles: first in a process of their own.
unsafeRow :: Plan -> Case -> Int -> [Vertex] -> Scheduler -> IO Row
unsafeRow plan found pairs truth scheduler = do
  outcome <- runContained plan ["graph", "--arithmetic", "double", "--scheduler", word, caseFile found]
  verdict <- case outcome of
    Failed failure -> pure (NoAnswer failure)
    Finished _ _ -> vertexVerdict truth (verticesBy scheduler under)
  case verdict of
    NoAnswer _ -> pure (row Nothing verdict Nothing Nothing)
    _ -> do
      (seconds, _) <- bestTime (runs plan) under (length . verticesBy scheduler)
      open <- if closes then ended (closureOpen (closureExactly scheduler under)) else pure Nothing
      pure (row (Just seconds) verdict open Nothing)
  where
    under = underArithmetic UnsafeDouble (caseScene found)
    closes = cornerCount under <= closureLimit plan
    word = schedulerWord scheduler
    row = Row found pairs "double" word

cellsOf, rawCells :: Row -> [String]
cellsOf row =
  opening row
    <> [maybe "" (micro . (/ fromIntegral (rowPairs row))) (rowSeconds row)]
    <> verdictCells (rowVerdict row)
    <> [maybe "" show (rowOpen row)]
    <> case rowSigns row of
      Just signs -> [show (signsDecided signs), shareCell signs]
      Nothing -> ["", ""]
rawCells row =
  opening row
    <> [maybe "" (show . (* 1e6) . (/ fromIntegral (rowPairs row))) (rowSeconds row)]
    <> verdictCells (rowVerdict row)
    <> [maybe "" show (rowOpen row)]
    <> signCells (rowSigns row)

opening :: Row -> [String]
opening row =
  [ caseName (rowCase row)
  , show (cornerCount (caseScene (rowCase row)))
  , show (rowPairs row)
  , rowArithmetic row
  , rowScheduler row
  ]

ladderPlot :: [Case] -> [Row] -> Plot
ladderPlot ladder rows =
  Plot
    { plotTitle = "Time per visible pair on random quadrilaterals"
    , plotDescription =
        "Microseconds per elementary visible pair against the number of corners, both logarithmic, by arithmetic and \
        \scheduler."
    , plotAcross = Decades "corners"
    , plotUpwards = Decades "µs per visible pair"
    , plotSeries =
        [ series "filtered, topological" series1 Circle "filtered" "topological"
        , series "filtered, straight" series2 Square "filtered" "straight"
        , series "double, topological" series3 Cross "double" "topological"
        , series "exact, topological" series4 Triangle "exact" "topological"
        , series "rational on the lattice, topological" series5 Diamond "rational" "topological"
        , series "filtered, reference" series8 Wedge "filtered" "reference"
        , series "brute force" series6 Plus "integers" "brute force"
        ]
    }
  where
    series name style marker arithmetic scheduler =
      Series name style marker Joined $
        [ (fromIntegral (cornerCount (caseScene (rowCase r))), 1e6 * t / fromIntegral (rowPairs r))
        | r <- rows
        , caseName (rowCase r) `elem` map caseName ladder
        , rowArithmetic r == arithmetic
        , rowScheduler r == scheduler
        , Just t <- [rowSeconds r]
        ]
