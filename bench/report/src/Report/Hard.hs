{-# LANGUAGE OverloadedStrings #-}

-- | The report's fourth section: scenes that get harder step by step, and where each arithmetic first errs.
module Report.Hard
  ( hardSection
  ) where

import Control.Monad (forM)
import Data.Foldable (maximumBy)
import Data.List (sort)
import Data.List.NonEmpty (NonEmpty, nonEmpty)
import Data.Maybe (mapMaybe)
import Data.Ord (comparing)
import qualified Data.Text as Text
import Report.Arithmetic
import Report.Closure
import Report.Ladder
import Report.Measure
import Report.Paper
import Report.Scenes
import Report.Verdict
import Visibility.Draw.Drawing (Style (..))
import Visibility.Draw.Scale (counted)
import Report.Plot
import Visibility.Scene
import Visibility.Sweep
import Visibility.Test.BruteForce (bruteForce)

-- | The ways to decide signs, by their names; how each is judged.
data Way = Contained | Here (Scene -> Scene)

ways :: [(String, Way)]
ways = ("double", Contained) : [(name, Here arithmetic) | (name, arithmetic) <- exactArithmetics]

-- | A scene under an arithmetic.
data Row = Row
  { rowLadder :: !String
  , rowStep :: !Int
  , rowWay :: !String
  , rowVerdict :: !Verdict
  , rowClosure :: !(Maybe Closure)
  -- ^ Nothing where there is no graph, or closure was left out.
  , rowSigns :: !(Maybe Signs)
  -- ^ Those of the floating-point filter, where there is one.
  }

hardSection :: Plan -> IO Section
hardSection plan = do
  rows <- fmap concat . forM (ladders plan) $ \ladder -> fmap concat . forM (ladderRungs ladder) $ \k -> do
    progress plan ("hard cases: " <> ladderName ladder <> ", " <> show k)
    found <- saved (rawCase (folder plan) (map dash (ladderName ladder) <> "-" <> show k) (ladderScene ladder k))
    let truth = sort (bruteForce (caseScene found))
    forM ways $ \(name, way) -> judged plan found truth way (Row (ladderName ladder) k name)
  pure
    Section
      { sectionTitle = "Hard cases: where each arithmetic first errs"
      , sectionText =
          [ "Doubles, on "
              <> show (length (doublesOf rows))
              <> " scenes: "
              <> verdictsText (doublesOf rows)
          , "Each family gets harder with k; its scene for a k is the file of that name and k in [scenes](scenes). \
            \Doubles run in a process of their own, `viscomplex graph --arithmetic double`, with at most "
              <> limitsOf plan
              <> ", and their graph is compared with the exact one, pair by pair; filtered, exact and rational \
                 \arithmetic are compared with brute force in integers, vertex by vertex. All sweeps are topological. \
                 \The rational baseline computes on lattice integers, with denominator 1."
          , "Coordinates of 2^k. Signs are decided on the lattice, whose origin is where the scene begins. Where all \
            \is *moved*, the lattice moves along, so the signs of Doubles stay as they are; but they take distances in \
            \the file's coordinates, so form factors lose a binary digit each time that k grows by 1. Where a triangle \
            \stays (*moved apart*, *far away*), the lattice must reach from it to the others, and signs are lost too. \
            \*Scaled* by powers of two, Doubles keep all their digits, until the square of a distance overflows."
          , "Closure: the form factors of a side must add up to the part of it that nothing covers. For Doubles all is \
            \computed in Doubles, topology, distances and sums, wherever there is a graph; a side is *open* if its sum \
            \is off by more than "
              <> sig tolerance
              <> " or is no number. For the other arithmetics closure is decided exactly, on the topology that they \
                 \find, up to "
              <> show (closureLimit plan)
              <> " corners. "
              <> openText rows
          , signText rows
          ]
      , sectionTables =
          [ Table
              "The first k at which an arithmetic is wrong or without an answer, what happens there, and on how many \
              \scenes that is so."
              ( ["scenes", "what k does", "double first wrong at", "what happens", "scenes with a wrong or no answer"]
                  <> map (<> " first wrong at") exactWays
              )
              [ [ladderName ladder, ladderMeaning ladder, firstWrong doubles, firstWhat doubles, share doubles]
                  <> map (firstWrong . mine) exactWays
              | ladder <- ladders plan
              , let mine = byWay rows ladder
              , let doubles = mine "double"
              ]
          , Table
              ( "Closure, and the signs of the filter, over all scenes of a family. Open sides of Doubles: off by more \
                \than "
                  <> sig tolerance
                  <> ", of all sides in scenes with a graph; the first k with one; and how far the form factors of a \
                     \side are at most from their sum, which is 1 where nothing is covered. Open sides elsewhere: off \
                     \at all. Signs: how many the filter was asked, and the share that it left to integers, over the \
                     \family and in the scene where that is largest; empty where machine integers decide all."
              )
              ( ["scenes", "double first open at", "double open sides", "double farthest off"]
                  <> map (<> " open sides") exactWays
                  <> ["signs asked of the filter", "left to integers", "most left to integers", "at k ="]
              )
              [ [ladderName ladder]
                  <> closureOfDoubles (mine "double")
                  <> map (openShare . mine) exactWays
                  <> signsOf (mine "filtered")
              | ladder <- ladders plan
              , let mine = byWay rows ladder
              ]
          ]
      , sectionFigures = [Figure "hard.svg" (plot plan rows) (caption plan rows)]
      , sectionData =
          [ ( "hard.csv"
            , words "scenes k arithmetic verdict missing spurious sides open_sides farthest_off signs signs_left"
                : [ [rowLadder r, show (rowStep r), rowWay r]
                      <> verdictCells (rowVerdict r)
                      <> closureCells (rowClosure r)
                      <> signCells (rowSigns r)
                  | r <- rows
                  ]
            )
          ]
      }
  where
    exactWays = [name | (name, Here _) <- ways]
    byWay rows ladder way = [r | r <- rows, rowLadder r == ladderName ladder, rowWay r == way]
    doublesOf rows = [rowVerdict r | r <- rows, rowWay r == "double"]
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

-- | What a way makes of a scene.
judged :: Plan -> Case -> [Vertex] -> Way -> (Verdict -> Maybe Closure -> Maybe Signs -> Row) -> IO Row
judged plan found truth way row = case way of
  Contained -> do
    verdict <- unsafeVerdict plan "topological" (caseFile found)
    closure <- case verdict of
      NoAnswer _ -> pure Nothing
      _ -> ended (closureInDoubles scene)
    pure (row verdict closure Nothing)
  Here arithmetic -> do
    let under = arithmetic scene
    verdict <- vertexVerdict truth (vertices under)
    closure <-
      if cornerCount scene <= closureLimit plan
        then ended (closureExactly Topological under)
        else pure Nothing
    row verdict closure <$> countingSigns under (length . vertices)
  where
    scene = caseScene found

-- | Is a side open?
isOpen :: Row -> Bool
isOpen = maybe False ((> 0) . closureOpen) . rowClosure

-- | Open sides, of all.
openShare :: [Row] -> String
openShare rows = show (sum (map closureOpen found)) <> " of " <> show (sum (map closureSides found))
  where
    found = mapMaybe rowClosure rows

openText :: [Row] -> String
openText rows =
  "Doubles leave "
    <> openShare doubles
    <> " sides open, on "
    <> show (length (filter isOpen doubles))
    <> " scenes, on "
    <> show (length [() | r <- doubles, isOpen r, rowVerdict r == Correct])
    <> " of which all their pairs are right; and "
    <> show (length [() | r <- doubles, Wrong _ _ <- [rowVerdict r], Just 0 <- [closureOpen <$> rowClosure r]])
    <> " of their wrong graphs close. The others leave "
    <> openShare [r | r <- rows, rowWay r /= "double"]
    <> " open."
  where
    doubles = [r | r <- rows, rowWay r == "double"]

-- | Where closure first breaks, how many sides are open, and how far the farthest is off.
closureOfDoubles :: [Row] -> [String]
closureOfDoubles rows = case mapMaybe rowClosure rows of
  [] -> ["no graph", "no graph", "no graph"]
  found ->
    [ case filter isOpen rows of
        [] -> "never"
        r : _ -> show (rowStep r)
    , openShare rows
    , maybe "no number" (sig . maximum . (0 :)) (mapM closureWorst found)
    ]

-- | As data: all sides, the open ones, and the distance of the farthest sum, where all sums are numbers.
closureCells :: Maybe Closure -> [String]
closureCells found = case found of
  Nothing -> ["", "", ""]
  Just closure -> [show (closureSides closure), show (closureOpen closure), maybe "" show (closureWorst closure)]

-- | The signs of a filter with their rows, if there are any.
signsIn :: [Row] -> Maybe (NonEmpty (Row, Signs))
signsIn rows = nonEmpty [(r, signs) | r <- rows, Just signs <- [rowSigns r]]

together :: NonEmpty (Row, Signs) -> Signs
together found = Signs (sum (fmap (signsDecided . snd) found)) (sum (fmap (signsLeft . snd) found))

-- | All signs, the share left, the greatest share, and where that is.
signsOf :: [Row] -> [String]
signsOf rows = case signsIn rows of
  Nothing -> ["", "", "", ""]
  Just found -> [show (signsDecided (together found)), shareCell (together found), shareCell most, show (rowStep r)]
    where
      (r, most) = mostLeft found

mostLeft :: NonEmpty (Row, Signs) -> (Row, Signs)
mostLeft = maximumBy (comparing (shareLeft . snd))

signText :: [Row] -> String
signText rows = case signsIn rows of
  Nothing -> "Machine integers decide all signs of all scenes: no filter is asked."
  Just found ->
    "Signs: on "
      <> show (length found)
      <> " of "
      <> show (length [() | r <- rows, rowWay r == "filtered"])
      <> " scenes the coordinates are too long for machine integers, and the filter is asked. It decides "
      <> show (signsDecided (together found) - signsLeft (together found))
      <> " of "
      <> show (signsDecided (together found))
      <> " signs and leaves "
      <> shareCell (together found)
      <> " to integers; at most "
      <> shareCell most
      <> ", on *"
      <> rowLadder hardest
      <> "*, k = "
      <> show (rowStep hardest)
      <> "."
    where
      (hardest, most) = mostLeft found

-- | The marks of the plot: which rows have which.
kinds :: [(String, Style, Marker, Row -> Bool)]
kinds =
  [ (verdictWord Correct, series2, Circle, \r -> rowVerdict r == Correct && not (isOpen r))
  , ("right pairs, but form factors that do not add up", series4, Diamond, \r -> rowVerdict r == Correct && isOpen r)
  , (verdictWord (Wrong 0 0), series3, Cross, \r -> case rowVerdict r of Wrong _ _ -> True; _ -> False)
  , (failureWord Refused, series5, Triangle, (== NoAnswer Refused) . rowVerdict)
  , ( "crashed, or out of time or memory"
    , series7
    , Square
    , \r -> case rowVerdict r of NoAnswer failure -> failure /= Refused; _ -> False
    )
  ]

plot :: Plan -> [Row] -> Plot
plot plan rows =
  Plot
    { plotTitle = "Hard scenes: which arithmetic is right"
    , plotDescription = "The verdict on each scene by family and arithmetic, from left to right as scenes get harder."
    , plotAcross = Steps "k: the scene gets harder with it"
    , plotUpwards = Names [Text.pack (family' <> ", " <> way) | (family', way) <- places]
    , plotSeries =
        [ Series (Text.pack word) style marker Apart $
            [ (fromIntegral (rowStep r), height)
            | (height, place) <- zip [0 ..] places
            , r <- rows
            , (rowLadder r, rowWay r) == place
            , chosen r
            ]
        | (word, style, marker, chosen) <- kinds
        ]
    }
  where
    -- From below.
    places = reverse [(ladderName ladder, way) | ladder <- ladders plan, (way, _) <- ways]

caption :: Plan -> [Row] -> Text.Text
caption plan rows =
  "Scenes of "
    <> counted (length (ladders plan)) "family" "families"
    <> " under four arithmetics: a row for each family and arithmetic, a mark for each scene, harder from left to \
       \right. k is the exponent of a gap 2^-k, of a distance or a size 2^k or 2^(16 k), or a number of tiny \
       \triangles, as the table says. A circle: all visible pairs are right, and form factors add up. A diamond: all \
       \pairs are right, but the form factors of a side do not add up. A cross: pairs are wrong, and nothing noticed \
       \it. A triangle: a law of the sweep was broken and noticed. A square: no answer. Doubles are wrong, or without \
       \an answer, on "
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
