{-# LANGUAGE OverloadedStrings #-}

-- | The report's second section: form factors, time against error.
module Report.Factors
  ( factorsSection
  , Method (..)
  , methods
  , looks
  ) where

import Control.Monad (forM)
import Data.List (intercalate)
import Data.Maybe (catMaybes)
import qualified Data.Text as Text
import qualified Data.Map.Strict as Map
import Report.Measure
import Report.Paper
import Report.Scenes
import Visibility.Draw.Drawing (Style (..))
import Estimate.Lines
import Estimate.Matrix
import Estimate.Points
import Estimate.Strings
import Visibility.Exact.Point (Arithmetic (..))
import Visibility.Exact.Rounding (nearestDouble)
import Visibility.FormFactor
import Report.Plot
import Visibility.Scene
import Visibility.Scene.Family (Family (..))
import Visibility.Sweep

-- | A way to a matrix of form factors, with its parameter.
data Method = Method
  { methodName :: !String
  , methodParameter :: !(Maybe Int)
  , methodMatrix :: Scene -> Matrix
  }

-- | All methods, those with a parameter several times. One that is to be added is added here.
methods :: Plan -> [Method]
methods plan =
  [ Method "exact string rule" Nothing $ \s ->
      fromFactors s [(factorFrom f, factorTo f, nearestDouble (factorValue f)) | f <- formFactors s (measuresIn s)]
  , Method "nearest Doubles (proved)" Nothing $ \s ->
      fromFactors s [(from, to, x) | FactorRow from found _ <- nearestFactors s (measuresIn s), (to, x) <- found]
  , Method "string rule in Double on the exact topology" Nothing (\s -> plainStrings s (verticesInPieces s))
  , Method "compensated Double on the exact topology" Nothing (\s -> compensatedStrings s (verticesInPieces s))
  , Method "all Double" Nothing $ \s ->
      let under = underArithmetic UnsafeDouble s in plainStrings under (verticesInPieces under)
  ]
    <> [Method "double integral" (Just k) (pointQuadrature k . sidesIn) | k <- pointCounts plan]
    <> [Method "area in the dual" (Just k) (dualAreas k . sidesIn) | k <- directionCounts plan]
    <> [Method "random lines" (Just k) (randomLines 1 k . sidesIn) | k <- lineCounts plan]
  where
    measuresIn s = measuresInPieces s (verticesInPieces s)

fromFactors :: Scene -> [(SideName, Seen, Double)] -> Matrix
fromFactors scene factors =
  matrixFrom (Map.size ranks) $ \put -> mapM_ (\(from, to, x) -> put (rank from) (column to) x) factors
  where
    ranks = Map.fromList (zip (statedSides scene) [0 ..])
    rank side = Map.findWithDefault 0 side ranks
    column (TheSide side) = rank side
    column TheSky = Map.size ranks

data Row = Row !Case !Method !Double !Errors

factorsSection :: Plan -> IO Section
factorsSection plan = do
  cases <- mapM (saved . familyCase (folder plan) Random) (factorSizes plan)
  rows <- concat <$> forM cases measuredOn
  whole <- forM cases $ \found -> do
    progress plan ("form factors: commands on " <> caseName found)
    times <- forM factorCommands (\arguments -> leastClock plan (arguments <> [caseFile found]))
    pure (caseName found, zip (map unwords factorCommands) times)
  pure
    Section
      { sectionTitle = "Form factors: time against error"
      , sectionText =
          [ "The form factor of a side and a thing that it sees is the part of the light from the side, spread by \
            \Lambert's law, that reaches the thing: another side, or the sky. The *string rule* gives it as a signed \
            \sum of distances between corners that see each other, divided by twice the length of the side."
          , "Time is processor time in this process from a scene that has been read and checked to the whole matrix, \
            \sweep, sums and rounding included: "
              <> leastOf plan
              <> (if runs plan > 1 then "; with a parameter, taken once" else "")
              <> ". Errors are taken over all form factors that are not zero, against the exact sums of roots, rounded \
                 \to two Doubles; one that a method misses has the relative error 1. A form factor seen through a \
                 \narrow gap is tiny, so the largest relative error is a hard measure; the median says how most of \
                 \them fare. A correctly rounded Double has a relative error of up to 1.1e-16, which is where the \
                 \exact methods end: their sums are exact, and print to any number of digits."
          , "*Exact string rule* makes exact sums of roots, and rounds them; *nearest Doubles (proved)* makes sums in \
            \two Doubles with a proved bound, and in roots only where that leaves a doubt. *String rule in Double* \
            \and *compensated Double* add distances between the Doubles nearest to the corners, along the exact sweep, \
            \the former in one Double, the latter in two, without a bound; *all Double* is the former, but also sweeps \
            \in Doubles. *Double integral* takes what points in the middles of equal parts of each side see, their \
            \number being its parameter (up to 40000 points in all); *area in the dual* samples so many directions, \
            \and adds in each the widths between neighbouring corners: it does not use the faces of the complex, \
            \whose areas the string rule has in closed form; *random lines* takes so many lines, from seed 1."
          , "For orientation, two figures of approximate programs, from elsewhere and not measured here: on a scene \
            \of 30 quadrilaterals with 119 sides, 0.01 s for a largest error of 3e-4, and 0.46 s for one of 1e-9. It \
            \is another machine and another scene than random-30, and not said whether errors are relative. They have \
            \rows in the table and marks in the plot of the largest error of random-30."
          ]
            <> concat (take 1 (map aimText whole))
      , sectionTables =
          [ Table
              "All methods: processor time in seconds; the largest and the median relative error and the largest \
              \absolute error of a form factor that is not zero; and how many are spurious, not zero where they \
              \should be. Rows that say elsewhere are for orientation and not measured here: another machine, \
              \another scene; whether their largest error is relative is not known."
              ( ["scene", "method", "parameter", "seconds"]
                  <> ["largest relative error", "median relative error", "largest absolute error", "spurious"]
              )
              (concat [map (cellsOf sig) (casesRows rows c) <> orientation c | c <- cases])
          , Table
              ( "Whole commands, from the start of the process to its end, reading and printing included, by the \
                \clock, "
                  <> leastOf plan
                  <> ": `factors` prints 17 correct digits of each form factor, `factors --double` the nearest \
                     \Doubles."
              )
              ("scene" : map unwords factorCommands)
              [name : map (timeCell . snd) times | (name, times) <- whole]
          ]
      , sectionFigures =
          concat
            [ [ Figure
                  (caseName c <> "-largest.svg")
                  (plot c "largest relative error" largestRelative (elsewhereSeries c) rows)
                  (caption rows c "largest" <> fewHits <> orientationCaption c)
              , Figure
                  (caseName c <> "-median.svg")
                  (plot c "median relative error" medianRelative [] rows)
                  (caption rows c "median")
              ]
            | c <- cases
            ]
      , sectionData =
          [ ( "factors.csv"
            , words "scene method parameter seconds largest_relative median_relative largest_absolute spurious"
                : map (cellsOf show) rows
            )
          , ( "factors-commands.csv"
            , words "scene command seconds"
                : [[name, command, maybe "" show time] | (name, times) <- whole, (command, time) <- times]
            )
          ]
      }
  where
    measuredOn found = do
      let scene = caseScene found
          affordable m =
            methodName m /= "double integral" || maybe 0 (* cornerCount scene) (methodParameter m) <= 40000
          truth = truthOf scene (formFactors scene (measuresInPieces scene (verticesInPieces scene)))
      contained <- runContained plan ["graph", "--arithmetic", "double", caseFile found]
      let ends = case contained of Finished _ _ -> True; _ -> False
      catMaybes
        <$> forM
          [m | m <- methods plan, ends || methodName m /= "all Double", affordable m]
          ( \m -> do
              progress plan ("form factors: " <> caseName found <> ", " <> methodName m)
              (seconds, matrix) <- timed' m scene
              found' <- ended (errorsOf truth matrix)
              pure (fmap (Row found m seconds) found')
          )
    timed' m scene =
      bestTime (maybe (runs plan) (const 1) (methodParameter m)) scene $ \s ->
        let matrix = methodMatrix m s in entryAt matrix 0 0 `seq` matrix
    factorCommands = [["factors"], ["factors", "--double"]]
    aimText (name, times) =
      [ "The aim for 30 quadrilaterals is a whole command, process start, reading and printing included, of 0.05 s. On "
          <> name
          <> ", with 17 correct digits or as nearest Doubles: "
          <> intercalate "; " [taken command t | (command, Just t) <- times]
          <> "."
      ]
    taken command t = "`" <> command <> "` takes " <> sig t <> " s, " <> against t
    against t = if t <= 0.05 then "within it" else "above it"
    cellsOf shown (Row c m t e) =
      [caseName c, methodName m, maybe "" show (methodParameter m), shown t]
        <> map (shown . ($ e)) [largestRelative, medianRelative, largestAbsolute]
        <> [show (spurious e)]
    orientation c =
      [ ["30 quadrilaterals (elsewhere)", "approximate program (elsewhere)", "", sig t, sig e, "", "", ""]
      | (t, e) <- elsewhere c
      ]
    elsewhereSeries c =
      [ Series "approximate programs elsewhere, not measured here" series9 Star Apart found
      | let found = elsewhere c
      , not (null found)
      ]
    fewHits =
      " That of random lines is dominated by a few hits on tiny form factors: one line that happens to meet such a \
      \pair counts far too much, and none at all counts 1; so it need not fall with more lines."
    orientationCaption c
      | null (elsewhere c) = ""
      | otherwise =
          " The stars are for orientation only and not measured here: approximate programs, timed elsewhere on \
          \another machine, on a scene of 30 quadrilaterals with 119 sides; if their errors are absolute, the \
          \relative ones are larger than drawn."
    parametersOf found =
      [ (name, counts)
      | name <- map fst looks
      , let counts = [k | Row _ m _ _ <- found, methodName m == name, Just k <- [methodParameter m]]
      , not (null counts)
      ]
    caption rows c which =
      "Form factors of "
        <> Text.pack (caseName c)
        <> ": the "
        <> which
        <> " relative error over all form factors that are not zero, against processor time in seconds, both \
           \logarithmic. The points of one line are one method with growing parameter ("
        <> Text.intercalate
          "; "
          [ Text.pack (name <> " of " <> intercalate ", " (map show counts))
          | (name, counts) <- parametersOf (casesRows rows c)
          ]
        <> "); below and to the left is better. The exact and the proved results lie at the rounding of a Double, \
           \1.1e-16, which no sampling comes near; an error of 0 is not drawn."

casesRows :: [Row] -> Case -> [Row]
casesRows rows c = [row | row@(Row c' _ _ _) <- rows, caseName c' == caseName c]

-- | Seconds and largest errors of approximate programs on a scene like this one, that were not measured here.
elsewhere :: Case -> [(Double, Double)]
elsewhere c = if caseName c == "random-30" then [(0.01, 3e-4), (0.46, 1e-9)] else []

plot :: Case -> Text.Text -> (Errors -> Double) -> [Series] -> [Row] -> Plot
plot c title part others rows =
  Plot
    { plotTitle = "Speed against error: " <> title <> ", " <> Text.pack (caseName c)
    , plotDescription = "Relative error of form factors against processor time, by method, both axes logarithmic."
    , plotAcross = Decades "processor time in seconds"
    , plotUpwards = Decades title
    , plotSeries =
        [ Series (Text.pack name) style marker Joined found
        | (name, (style, marker)) <- looks
        , let found = [(t, part e) | Row _ m t e <- casesRows rows c, methodName m == name]
        ]
          <> others
    }

-- | How each method is drawn, in all plots alike.
looks :: [(String, (Style, Marker))]
looks =
  [ ("exact string rule", (series1, Circle))
  , ("nearest Doubles (proved)", (series2, Square))
  , ("string rule in Double on the exact topology", (series4, Triangle))
  , ("compensated Double on the exact topology", (series6, Wedge))
  , ("all Double", (series7, Plus))
  , ("double integral", (series5, Diamond))
  , ("area in the dual", (series8, Bar))
  , ("random lines", (series3, Cross))
  ]
