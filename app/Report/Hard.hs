-- | The report's fourth section: scenes that get harder step by step, and where each arithmetic first errs.
module Report.Hard
  ( hardSection
  ) where

import Control.Monad (forM)
import Data.List (intercalate, sort)
import qualified Data.Set as Set
import Report.Measure
import Report.Paper
import Report.Scenes
import Report.Topology (graphErrors)
import Visibility.Exact.Point (Arithmetic (..), Point (..))
import Visibility.Law (broken)
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
  , Ladder "touching" "four triangles of size 2^k that touch in (1/7, 1/11), and a fifth that nearly touches one of them along a side" touching steps
  , Ladder "kettner" "k tiny triangles near (1/2, 1/2), and two others" (\k -> named Kettner (max 1 k)) (filter (> 0) steps)
  ]
  where
    steps = hardSteps plan

data Row = Row !String !Int !Outcome !(Maybe Int) !(Maybe Int) !Bool !Bool

hardSection :: (String -> IO ()) -> Plan -> FilePath -> IO Section
hardSection progress plan folder = do
  rows <- fmap concat . forM (ladders plan) $ \ladder -> forM (ladderRungs ladder) $ \k -> do
    progress ("hard cases: " <> ladderName ladder <> ", " <> show k)
    found <- saved (rawCase folder (map dash (ladderName ladder) <> "-" <> show k) (ladderScene ladder k))
    outcome <- runChild (timeLimit plan) ["graph", "--arithmetic", "double", caseFile found]
    exact <- runChild (timeLimit plan) ["graph", caseFile found]
    let (missing, extra) = case outcome of
          Finished _ printed -> graphErrors exact printed
          _ -> (Nothing, Nothing)
        scene = caseScene found
        right arithmetic = sort (vertices (underArithmetic arithmetic scene)) == truth
        truth = sort (bruteForce scene)
    pure (Row (ladderName ladder) k outcome missing extra (right Filtered) (right Exact))
  pure
    Section
      { sectionTitle = "Hard cases: where each arithmetic first errs"
      , sectionText =
          [ "Doubles: " <> intercalate ", " [show n <> " " <> word | (word, n) <- outcomes rows, n > 0] <> "."
          , "Each scene gets harder with k. Doubles run in a process of their own, with a time limit, and their graph is \
            \compared with the exact one; filtered and exact arithmetic are compared with brute force in integers, pair by pair."
          ]
      , sectionTables =
          [ Table
              "The first k at which an arithmetic is wrong, and what happens there; of how many scenes it is wrong."
              ["scenes", "what k does", "double first wrong at", "what happens", "scenes with a wrong or no answer", "filtered first wrong at", "exact first wrong at"]
              [ [ ladderName ladder
                , ladderMeaning ladder
                , firstOf [k | Row _ k o m e _ _ <- mine, isWrong o m e]
                , concat (take 1 [what o m e | Row _ _ o m e _ _ <- mine, isWrong o m e])
                , show (Set.size (Set.fromList [k | Row _ k o m e _ _ <- mine, isWrong o m e])) <> " of " <> show (length mine)
                , firstOf [k | Row _ k _ _ _ False _ <- mine]
                , firstOf [k | Row _ k _ _ _ _ False <- mine]
                ]
              | ladder <- ladders plan
              , let mine = [r | r@(Row name _ _ _ _ _ _) <- rows, name == ladderName ladder]
              ]
          ]
      , sectionFigures = []
      , sectionData =
          [ ( "hard.csv"
            , ["scenes", "k", "double_outcome", "missing", "spurious", "filtered_right", "exact_right"]
                : [[name, show k, outcomeWord o, maybe "" show m, maybe "" show e, show a, show b] | Row name k o m e a b <- rows]
            )
          ]
      }
  where
    outcomes rows =
      [ ("right", length [() | Row _ _ o m e _ _ <- rows, not (isWrong o m e)])
      , ("finished with wrong pairs and noticed nothing", length [() | Row _ _ o@(Finished _ _) m e _ _ <- rows, isWrong o m e])
      , ("refused by a law", length [() | Row _ _ Refused _ _ _ _ <- rows])
      , ("crashed", length [() | Row _ _ (Crashed _) _ _ _ _ <- rows])
      , ("not finished in time", length [() | Row _ _ Unfinished _ _ _ _ <- rows])
      ]
    dash c = if c == ' ' then '-' else c
    firstOf ks = case ks of
      [] -> "never"
      k : _ -> show k
    isWrong (Finished _ _) m e = m /= Just 0 || e /= Just 0
    isWrong _ _ _ = True
    what o m e = case o of
      Finished _ _ -> maybe "?" show m <> " pairs missing, " <> maybe "?" show e <> " spurious, and nothing noticed"
      _ -> outcomeWord o

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
    [ [Point (j / 7) (j / 3 + y), Point (1 + j / 11) (j / 3 + y + 1 / 3 + tiny k / 3), Point (j / 7) (j / 3 + y + tiny k)]
    | j <- map fromInteger [0 .. 11]
    , let y = j * tiny k * 2
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
