{-# LANGUAGE OverloadedStrings #-}

-- | The report's fourth section: scenes that get harder step by step, and where each arithmetic first errs.
module Report.Hard
  ( hardSection
  ) where

import Control.Monad (forM)
import Data.List (intercalate, sort)
import qualified Data.Text as Text
import Report.Measure
import Report.Paper
import Report.Scenes
import Report.Verdict
import Visibility.Draw.Drawing (Style (..))
import Visibility.Exact.Point (Arithmetic (..), Point (..))
import Visibility.Law (broken)
import Visibility.Report.Plot
import Visibility.Scene
import Visibility.Scene.Family
import Visibility.Scene.Raw
import Visibility.Sweep

-- | A family by a growing number.
data Ladder = Ladder
  { ladderName :: !String
  , ladderMeaning :: !String
  , ladderScene :: Int -> RawScene
  , ladderRungs :: ![Int]
  }

ladders :: Plan -> [Ladder]
ladders plan =
  [ Ladder "nearly collinear" "three triangles with tips on a line, but for 2^-k" nearlyCollinear steps
  , Ladder "slit" "two walls end to end with a slit of 2^-k between them, and a triangle on either side" slit steps
  , Ladder "needles" "twelve slanted triangles, about a unit long and 2^-k wide" needles steps
  , Ladder "far away" "ten quadrilaterals with corners at thirds, and a triangle at a distance of 4000 · 2^k" far steps
  , Ladder
      "touching"
      "four triangles of size 2^k that touch in (1/7, 1/11), and a fifth that nearly touches one of them along a side"
      touching
      steps
  , Ladder "kettner" "k tiny triangles near (1/2, 1/2), and two others" (named Kettner . max 1) (filter (> 0) steps)
  ]
  where
    steps = hardSteps plan

-- | The ways to decide signs, by their names; how each is judged.
data Way = Contained | Here !Arithmetic

ways :: [(String, Way)]
ways =
  [ ("double", Contained)
  , ("rational", Here RationalBaseline)
  , ("filtered", Here Filtered)
  , ("exact", Here Exact)
  ]

-- | A scene under an arithmetic.
data Row = Row
  { rowLadder :: !String
  , rowStep :: !Int
  , rowWay :: !String
  , rowVerdict :: !Verdict
  }

hardSection :: (String -> IO ()) -> Plan -> FilePath -> IO Section
hardSection progress plan folder = do
  rows <- fmap concat . forM (ladders plan) $ \ladder -> fmap concat . forM (ladderRungs ladder) $ \k -> do
    progress ("hard cases: " <> ladderName ladder <> ", " <> show k)
    found <- saved (rawCase folder (map dash (ladderName ladder) <> "-" <> show k) (ladderScene ladder k))
    let truth = sort (bruteForce (caseScene found))
    forM ways $ \(name, way) -> Row (ladderName ladder) k name <$> case way of
      Contained -> unsafeVerdict plan "topological" (caseFile found)
      Here arithmetic -> vertexVerdict truth (vertices (underArithmetic arithmetic (caseScene found)))
  pure
    Section
      { sectionTitle = "Hard cases: where each arithmetic first errs"
      , sectionText =
          [ "Doubles, on "
              <> show (length (doublesOf rows))
              <> " scenes: "
              <> intercalate "; " [show n <> " " <> word | (word, n) <- outcomes (doublesOf rows)]
              <> ". In the wrong graphs "
              <> show (sum [missing | Wrong missing _ <- doublesOf rows])
              <> " pairs are missing and "
              <> show (sum [extra | Wrong _ extra <- doublesOf rows])
              <> " are spurious."
          , "Each scene gets harder with k. Doubles run in a process of their own, with limits of time and memory, \
            \and their graph is compared with the exact one; filtered, exact and rational arithmetic are compared \
            \with brute force in integers, pair by pair. The rational baseline computes on lattice integers, with \
            \denominator 1."
          ]
      , sectionTables =
          [ Table
              "The first k at which an arithmetic is wrong, and what happens there; of how many scenes it is wrong."
              ( ["scenes", "what k does", "double first wrong at", "what happens", "scenes with a wrong or no answer"]
                  <> map (<> " first wrong at") exactWays
              )
              [ [ladderName ladder, ladderMeaning ladder, firstWrong doubles, firstWhat doubles, share doubles]
                  <> map (firstWrong . mine) exactWays
              | ladder <- ladders plan
              , let mine way = [r | r <- rows, rowLadder r == ladderName ladder, rowWay r == way]
              , let doubles = mine "double"
              ]
          ]
      , sectionFigures = [Figure "hard.svg" (plot plan rows) (caption rows)]
      , sectionData =
          [ ( "hard.csv"
            , words "scenes k arithmetic verdict missing spurious"
                : [[rowLadder r, show (rowStep r), rowWay r] <> verdictCells (rowVerdict r) | r <- rows]
            )
          ]
      }
  where
    exactWays = [name | (name, Here _) <- ways]
    doublesOf rows = [rowVerdict r | r <- rows, rowWay r == "double"]
    -- All of them, those too that do not occur.
    outcomes found =
      [ (kindWord RightKind, amount (== Correct))
      , (kindWord WrongKind, amount ((== WrongKind) . kindOf))
      , (failureWord Refused, amount (== NoAnswer Refused))
      , ("crashed", amount (\verdict -> case verdict of NoAnswer (Crashed _) -> True; _ -> False))
      , (failureWord OutOfTime, amount (== NoAnswer OutOfTime))
      , (failureWord OutOfMemory, amount (== NoAnswer OutOfMemory))
      ]
      where
        amount p = length (filter p found)
    dash c = if c == ' ' then '-' else c
    wrong rows = [r | r <- rows, rowVerdict r /= Correct]
    firstWrong rows = case wrong rows of
      [] -> "never"
      r : _ -> show (rowStep r)
    firstWhat rows = concat (take 1 (map (what . rowVerdict) (wrong rows)))
    share rows = show (length (wrong rows)) <> " of " <> show (length rows)
    what verdict = case verdict of
      Wrong missing extra ->
        "pairs missing: " <> show missing <> ", spurious: " <> show extra <> ", and nothing noticed"
      _ -> verdictWord verdict

-- | Verdicts as they are told apart in the plot.
data Kind = RightKind | WrongKind | RefusedKind | NoneKind
  deriving (Eq)

kindOf :: Verdict -> Kind
kindOf verdict = case verdict of
  Correct -> RightKind
  Wrong _ _ -> WrongKind
  NoAnswer Refused -> RefusedKind
  NoAnswer _ -> NoneKind

kindWord :: Kind -> String
kindWord kind = case kind of
  RightKind -> "right"
  WrongKind -> "finished with wrong pairs and noticed nothing"
  RefusedKind -> "refused by a law"
  NoneKind -> "crashed, or out of time or memory"

plot :: Plan -> [Row] -> Plot
plot plan rows =
  Plot
    { plotTitle = "Hard scenes: which arithmetic is right"
    , plotDescription = "The verdict on each scene by family and arithmetic, from left to right as scenes get harder."
    , plotAcross = Steps "k: the scene gets harder with it"
    , plotUpwards = Names [Text.pack (family' <> ", " <> way) | (family', way) <- places]
    , plotSeries =
        [ Series (Text.pack (kindWord kind)) style marker Apart $
            [ (fromIntegral (rowStep r), height)
            | (height, place) <- zip [0 ..] places
            , r <- rows
            , (rowLadder r, rowWay r) == place
            , kindOf (rowVerdict r) == kind
            ]
        | (kind, style, marker) <-
            [ (RightKind, Series2, Circle)
            , (WrongKind, Series3, Cross)
            , (RefusedKind, Series5, Triangle)
            , (NoneKind, Series7, Square)
            ]
        ]
    }
  where
    -- From below.
    places = reverse [(ladderName ladder, way) | ladder <- ladders plan, (way, _) <- ways]

caption :: [Row] -> Text.Text
caption rows =
  "Scenes of six families under four arithmetics: a row for each family and arithmetic, a mark for each scene, harder \
  \from left to right. k is the exponent of a gap 2^-k, of a distance or a size 2^k, or a number of tiny triangles, \
  \as the table says. A circle: all visible pairs are right. A cross: pairs are wrong, and nothing noticed it. A \
  \triangle: a law of the sweep was broken and noticed. A square: no answer. Doubles are wrong, or without an answer, \
  \on "
    <> Text.pack (show (length (wrongBy (== "double"))))
    <> " of "
    <> Text.pack (show (length [() | r <- rows, rowWay r == "double"]))
    <> " scenes; rational, filtered and exact arithmetic on "
    <> Text.pack (show (length (wrongBy (/= "double"))))
    <> " of "
    <> Text.pack (show (length [() | r <- rows, rowWay r /= "double"]))
    <> ". The rational baseline computes on lattice integers, with denominator 1."
  where
    wrongBy way = [() | r <- rows, way (rowWay r), rowVerdict r /= Correct]

scene' :: [[Point]] -> RawScene
scene' = RawScene Nothing Nothing . map rawPolygon

nearlyCollinear, slit, needles, far, touching :: Int -> RawScene
nearlyCollinear k = scene' [at 0 0, at (1 / 3) (1 / 3 + tiny k), at (5 / 7) (5 / 7)]
  where
    at x y = [Point x y, Point (x + 1 / 11) (y - 1 / 5), Point (x + 1 / 7) (y - 1 / 7)]
slit k =
  scene'
    [ [Point 0 (-1), Point 0 0]
    , [Point 0 (tiny k), Point 0 (2 + tiny k)]
    , [Point (-3) (-1 / 3), Point (-2) (-1 / 7), Point (-2) (1 / 3)]
    , [Point 2 (-1 / 3), Point 3 0, Point 2 (1 / 7)]
    ]
needles k =
  scene'
    [ [Point (j / 7) base, Point (1 + j / 11) (base + 1 / 3 + tiny k / 3), Point (j / 7) (base + tiny k)]
    | j <- map fromInteger [0 .. 11]
    , let base = j / 3 + j * tiny k * 2
    ]
far k =
  RawScene Nothing Nothing $
    [p {rawCorners = [Point (x / 3) (y / 3) | Point x y <- rawCorners p]} | p <- rawPolygons (named Random 10)]
      <> [rawPolygon [Point (-d) (-d), Point (-d) (1 - d), Point (-d - 1) (-d)]]
  where
    d = 4000 * 2 ^ k
touching k =
  scene'
    [ map moved corners'
    | corners' <-
        [ [(0, 0), (s, s / 7), (s, s / 2)]
        , [(0, 0), (-s / 7, s), (-s / 2, s)]
        , [(0, 0), (-s, -s / 7), (-s, -s / 2)]
        , [(0, 0), (s / 7, -s), (s / 2, -s)]
        , [(s / 3, s / 6 + 1 / 97), (s / 2, s / 4 + 1 / 97), (s / 3, s / 3)]
        ]
    ]
  where
    s = 4 + 2 ^ k / 3
    moved (x, y) = Point (x + 1 / 7) (y + 1 / 11)

tiny :: Int -> Rational
tiny k = 1 / 2 ^ k

named :: Family -> Int -> RawScene
named kind n = case size n of
  Just k -> family kind k (Seed 1)
  Nothing -> broken "a scene of the report has a size" (show (kind, n))
