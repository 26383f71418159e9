{-# LANGUAGE OverloadedStrings #-}

-- | The report's fifth section: radiosity, accuracy by elements and by time.
module Report.Radiosity
  ( radiositySection
  ) where

import Control.Monad (forM)
import Data.List (intercalate, sort)
import qualified Data.Text as Text
import Report.Lit
import Report.Measure
import Report.Paper
import Report.Scenes
import Visibility.Radiosity (Radiosity)
import Report.Plot
import Visibility.Scene

-- | A mesh on a scene.
data Row = Row
  { rowCase :: !String
  , rowWay :: !Way
  , rowElements :: !Int
  , rowSeconds :: !Double
  , rowDistance :: !Distance
  }

-- | What a scene's meshes are measured against.
data Reference = Reference
  { referenceCase :: !Case
  , referenceElements :: !Int
  , referenceBounds :: !Double
  , referenceHalf :: !Distance
  -- ^ Of the reference with half as many parts.
  }

radiositySection :: Plan -> IO Section
radiositySection plan = do
  cases <- mapM saved (litScenes (folder plan))
  measured <- forM cases $ \found -> do
    progress plan ("radiosity: reference of " <> caseName found)
    let scene = caseScene found
        -- The reference itself is not kept, only what it says.
        finest = litBy (BreaksAndParts (referenceParts plan)) scene
        fine = shineOf finest
        far = distanceFrom scene fine . shineOf
    bounds <- pure $! widestBounds finest
    half <- pure $! far (litBy (BreaksAndParts (referenceParts plan `div` 2)) scene)
    rows <- forM (ways plan) $ \way -> do
      progress plan ("radiosity: " <> caseName found <> ", " <> wayName way)
      (seconds, lit) <- bestTime (runs plan) scene (\s -> let r = litBy way s in widestBounds r `seq` r)
      pure $! row found way seconds lit (far lit)
    pure (Reference found (shineSize fine) bounds half, rows)
  let references = map fst measured
      rows = concatMap snd measured
  pure
    Section
      { sectionTitle = "Radiosity: accuracy by elements and by time"
      , sectionText =
          [ "Each element of a mesh has one radiosity. How far is that from the radiosity at its points? Three scenes \
            \are lit: *room*, with a pier, two obstacles and a small lamp; *round*, two round objects of twelve \
            \corners before a round lamp in a room; *flat*, three rooms with doors between them, one with a lamp and \
            \one with a window. *No mesh* has whole sides as elements; *uniform* cuts each side, long or short, into \
            \so many equal parts; the *discontinuity mesh* cuts where the lines of all vertices land; *bounded*, it \
            \has at most so many elements on a side, kinks dropped first; *shadow limits* cuts only where shadows end; \
            \*discontinuity and uniform* at the points of both."
          , "The reference is a mesh of all break points and "
              <> show (referenceParts plan)
              <> " equal parts of each side, which contains all the other meshes. The error is |B − B_ref| along all \
                 \that is not covered of sides: its mean over the length, and its maximum, both as parts of the mean \
                 \of B_ref. Overlaps of elements are found exactly, and values are the middles of the proved bounds. \
                 \How far the reference with half as many parts is from it tells what the reference is worth: errors \
                 \not much larger than that say little."
          , "Time is processor time in this process from a scene that has been read and checked to proved bounds of \
            \all radiosities, within 1e-9 of the largest: the sweep for break points, where the mesh needs it, the \
            \sweep of the elements, form factors as nearest Doubles, and the solution; "
              <> leastOf plan
              <> "."
          , "The mean error of a uniform mesh, as a multiple of that of the discontinuity mesh with all its points: "
              <> intercalate
                "; "
                [ "on "
                    <> rowCase r
                    <> " "
                    <> factor byElements rows r
                    <> " with as many elements and "
                    <> factor rowSeconds rows r
                    <> " in as much time"
                | r <- rows
                , rowWay r == AllBreaks
                ]
              <> "."
          ]
      , sectionTables =
          [ Table
              "The references: sides of the scene, elements, the widest proved bounds of a radiosity as a part of the \
              \largest radiosity, and the error, mean and largest, of the same mesh with half as many parts."
              ["scene", "sides", "elements", "bounds within", "mean error of half", "largest error of half"]
              (map (referenceCells sig) references)
          , Table
              "All meshes: the parameter is the number of parts, or the most elements, of a side; processor time in \
              \seconds; errors as parts of the mean radiosity. The last two columns: the mean error of a uniform mesh \
              \of as many elements, or in as much time, as a multiple of that of the mesh, between uniform meshes by \
              \logarithms; below 1 the uniform mesh is better. Empty where no two uniform meshes are around it."
              ( ["scene", "mesh", "parameter", "elements", "seconds", "mean error", "largest error"]
                  <> ["uniform with as many elements", "uniform in as much time"]
              )
              [ cellsOf sig r <> [maybe "" sig (against by rows r) | by <- [byElements, rowSeconds]]
              | r <- rows
              ]
          ]
      , sectionFigures =
          concat
            [ [ Figure
                  ("radiosity-" <> caseName c <> "-elements.svg")
                  (plot c "elements" byElements rows)
                  (caption r "the number of elements")
              , Figure
                  ("radiosity-" <> caseName c <> "-seconds.svg")
                  (plot c "processor time in seconds" rowSeconds rows)
                  (caption r "processor time in seconds, from the scene to proved bounds")
              ]
            | r <- references
            , let c = referenceCase r
            ]
      , sectionData =
          [ ( "radiosity.csv"
            , words "scene mesh parameter elements seconds mean_error largest_error"
                : map (cellsOf show) rows
            )
          , ( "radiosity-references.csv"
            , words "scene sides elements bounds half_mean_error half_largest_error"
                : map (referenceCells show) references
            )
          ]
      }
  where
    row :: Case -> Way -> Double -> Radiosity -> Distance -> Row
    row found way seconds lit = Row (caseName found) way (shineSize (shineOf lit)) seconds
    cellsOf shown r =
      [rowCase r, wayName (rowWay r), maybe "" show (wayParameter (rowWay r)), show (rowElements r)]
        <> map shown [rowSeconds r, meanDistance (rowDistance r), largestDistance (rowDistance r)]
    referenceCells shown r =
      [caseName (referenceCase r), sideCount (referenceCase r), show (referenceElements r)]
        <> map shown [referenceBounds r, meanDistance (referenceHalf r), largestDistance (referenceHalf r)]
    sideCount = show . length . statedSides . caseScene
    byElements = fromIntegral . rowElements
    factor by rows = maybe "not measured (no uniform mesh of this run is as large)" sig . against by rows
    caption r which =
      "Radiosity of the scene "
        <> Text.pack (caseName (referenceCase r))
        <> ", one value for each element: the mean of |B − B_ref| over the length of all sides, as a part of the mean \
           \of B_ref, against "
        <> which
        <> ", both logarithmic. The points of one line are one kind of mesh, finer and finer; below and to the left is \
           \better. B is the radiosity on the mesh, B_ref that on a mesh of "
        <> Text.pack (show (referenceElements r))
        <> " elements that contains all these meshes; the same with half as many equal parts on each side is "
        <> Text.pack (sig (meanDistance (referenceHalf r)))
        <> " away from it, so lower errors say little."

-- | The meshes.
ways :: Plan -> [Way]
ways plan =
  [WholeSides]
    <> map EqualPartsOf (partCounts plan)
    <> [WhereShadowsEnd]
    <> map AtMost (partCounts plan)
    <> [AllBreaks]
    <> map BreaksAndParts (partCounts plan)

-- | By what factor the mean error of a uniform mesh of as much cost is larger, if two of them, or no mesh and one, are
-- around that cost.
against :: (Row -> Double) -> [Row] -> Row -> Maybe Double
against cost rows r
  | isUniform r = Nothing
  | otherwise = case [(p, q) | (p, q) <- zip known (drop 1 known), fst p <= here, here <= fst q, fst p < fst q] of
      ((x, e), (y, f)) : _ ->
        let part = logBase (y / x) (here / x) in Just (e * (f / e) ** part / meanDistance (rowDistance r))
      [] -> Nothing
  where
    here = cost r
    known = sort [(cost u, meanDistance (rowDistance u)) | u <- rows, rowCase u == rowCase r, isUniform u]
    isUniform u = case rowWay u of
      WholeSides -> True
      EqualPartsOf _ -> True
      _ -> False

plot :: Case -> Text.Text -> (Row -> Double) -> [Row] -> Plot
plot c across cost rows =
  Plot
    { plotTitle = "Radiosity: mean error by " <> across <> ", " <> Text.pack (caseName c)
    , plotDescription = "Mean error of radiosity against " <> across <> ", by mesh, both axes logarithmic."
    , plotAcross = Decades across
    , plotUpwards = Decades "mean error, as a part of the mean radiosity"
    , plotSeries =
        [ series "no mesh: whole sides" series7 Star ["no mesh"]
        , series "uniform" series2 Square ["uniform"]
        , series "shadow limits" series5 Plus ["shadow limits"]
        , series "bounded discontinuity mesh, up to all of it" series1 Circle
            ["bounded discontinuity mesh", "discontinuity mesh"]
        , series "discontinuity and uniform" series3 Cross ["discontinuity and uniform"]
        ]
    }
  where
    series name style mark names =
      Series name style mark Joined
        [(cost r, meanDistance (rowDistance r)) | r <- rows, rowCase r == caseName c, wayName (rowWay r) `elem` names]
