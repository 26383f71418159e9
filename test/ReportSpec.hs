{-# LANGUAGE OverloadedStrings #-}

-- | What @make report@ writes.
module ReportSpec (spec) where

import Command.Run (cells, executable)
import Data.Char (isDigit)
import Data.Foldable (for_)
import Data.List (isInfixOf, nub, sort)
import Report
import System.Directory (listDirectory)
import System.FilePath (takeExtension, (</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec
import Text.Read (readMaybe)

spec :: Spec
spec = describe "report" $
  it "measures, and writes a page, its data and its plots" $
    withSystemTempDirectory "viscomplex" $ \folder -> do
      exe <- executable
      writeReport (planOf Quick exe (folder </> "new") (const (pure ())))
      text <- readFile (folder </> "new" </> "report.md")
      for_ ["## Topology", "## Form factors", "## Cancellation", "## Hard cases", "## Radiosity"] $ \title ->
        text `shouldContain` title
      written <- sort <$> listDirectory (folder </> "new")
      [name | name <- written, takeExtension name == ".csv"] `shouldBe` sort (map fst reportTables)
      for_ reportTables $ \(name, (columns, least)) -> do
        table <- map cells . lines <$> readFile (folder </> "new" </> name)
        take 1 table `shouldBe` [map fst columns]
        (name, length (drop 1 table) >= least) `shouldBe` (name, True)
        [(name, row) | row <- drop 1 table, map (const ()) row /= map (const ()) columns] `shouldBe` []
        [ (name, column, cell)
          | row <- drop 1 table
          , ((column, kind), cell) <- zip columns row
          , not (isOfKind kind cell)
          ]
          `shouldBe` []
        text `shouldContain` ("(" <> name <> ")")
      -- What has a name in the data has the same in the tables.
      for_ [("factors.csv", "method"), ("radiosity.csv", "mesh"), ("hard.csv", "scenes"), ("topology.csv", "scene")] $
        \(name, column) -> do
          (header, rows) <- splitAt 1 . map cells . lines <$> readFile (folder </> "new" </> name)
          let names = nub [cell | row <- rows, Just cell <- [lookup column (zip (concat header) row)]]
          names `shouldSatisfy` (not . null)
          [(name, cell) | cell <- names, not (("| " <> cell <> " |") `isInfixOf` text)] `shouldBe` []
      let plots =
            words "topology random-30-largest random-30-median cancellation-free cancellation-occluded hard"
              <> ["radiosity-" <> name <> by | name <- words "room round flat", by <- ["-elements", "-seconds"]]
      [name | name <- written, takeExtension name == ".svg"] `shouldBe` sort (map (<> ".svg") plots)
      for_ plots $ \name -> do
        svg <- readFile (folder </> "new" </> name <> ".svg")
        svg `shouldContain` "</svg>"
        text `shouldContain` (name <> ".svg")
      -- What is exact is right on every scene, whatever the clock says; unsafe arithmetic is not on all.
      for_ ["hard.csv", "degenerate.csv", "topology.csv"] $ \name -> do
        (header, rows) <- splitAt 1 . map cells . lines <$> readFile (folder </> "new" </> name)
        let named = map (zip (concat header)) rows
            verdicts p =
              nub
                [ verdict
                | row <- named
                , Just way <- [lookup "arithmetic" row]
                , p way
                , Just verdict <- [lookup "verdict" row]
                ]
        (name, verdicts (/= "double")) `shouldBe` (name, ["right"])
        verdicts (== "double") `shouldSatisfy` \found -> "right" `elem` found && length found > 1
      -- Closure, signs, and what becomes of Doubles when a scene moves or grows.
      hard <- map cells . lines <$> readFile (folder </> "new" </> "hard.csv")
      let rows = [zip (concat (take 1 hard)) row | row <- drop 1 hard]
          column name chosen = [cell | row <- rows, chosen row, Just cell <- [lookup name row]]
          has name value row = lookup name row == Just value
          double row = has "arithmetic" "double" row
          answered row = lookup "sides" row /= Just ""
      for_ [("open_sides", "0"), ("farthest_off", "0.0")] $ \(name, none) ->
        nub (column name (\row -> not (double row) && answered row)) `shouldBe` [none]
      column "open_sides" (\row -> double row && has "scenes" "moved" row && has "k" "0" row) `shouldBe` ["0"]
      column "open_sides" (\row -> double row && answered row) `shouldSatisfy` any (/= "0")
      -- The sides of a row are those of the scene, whatever is made of it; the open ones are among them.
      [ (scenes, k)
        | row <- rows
        , answered row
        , Just scenes <- [lookup "scenes" row]
        , Just k <- [lookup "k" row]
        , length (nub (column "sides" (\r -> answered r && has "scenes" scenes r && has "k" k r))) > 1
          || columnAbove "open_sides" "sides" row
        ]
        `shouldBe` []
      nub (column "arithmetic" (not . has "signs" "")) `shouldBe` ["filtered"]
      filter (columnAbove "signs_left" "signs") rows `shouldBe` []
      for_ ["moved", "scaled"] $ \name -> nub (column "verdict" (has "scenes" name)) `shouldBe` ["right"]
      -- Doubles do not notice a power of two until it overflows.
      nub (filter (not . null) (column "farthest_off" (\row -> double row && has "scenes" "scaled" row)))
        `shouldSatisfy` ((== 1) . length)
      column "farthest_off" (\row -> double row && has "scenes" "scaled" row) `shouldSatisfy` elem ""
      column "verdict" (\row -> double row && has "scenes" "moved apart" row) `shouldSatisfy` any (/= "right")

-- | What a cell of a data file holds.
data CellKind = AWord | Whole | Number | Perhaps CellKind

isOfKind :: CellKind -> String -> Bool
isOfKind kind cell = case kind of
  AWord -> not (null cell)
  Whole -> not (null cell) && all isDigit cell
  Number -> case reads cell :: [(Double, String)] of
    [(x, "")] -> not (isNaN x || isInfinite x)
    _ -> False
  Perhaps other -> null cell || isOfKind other cell

-- | The data files of a report: their columns, and at least how many rows each has.
reportTables :: [(FilePath, ([(String, CellKind)], Int))]
reportTables =
  [ ( "topology.csv"
    , ( sizes
          <> ways
          <> [("us_per_pair", Perhaps Number)]
          <> verdict
          <> [(name, Perhaps Whole) | name <- words "open_sides signs signs_left"]
      , 50
      )
    )
  , ("topology-commands.csv", (sizes <> [("command", AWord), ("seconds", Number)], 8))
  , ("degenerate.csv", (("scene", AWord) : ways <> verdict, 300))
  , ( "factors.csv"
    , ( [("scene", AWord), ("method", AWord), ("parameter", Perhaps Whole), ("seconds", Number)]
          <> [(name, Number) | name <- words "largest_relative median_relative largest_absolute"]
          <> [("spurious", Whole)]
      , 10
      )
    )
  , ("factors-commands.csv", ([("scene", AWord), ("command", AWord), ("seconds", Number)], 2))
  , ( "cancellation.csv"
    , ( [("case", AWord), ("log10_distance", Whole), ("method", AWord)]
          <> [("form_factor", Number), ("relative_error", Number)]
      , 100
      )
    )
  , ( "hard.csv"
    , ( [("scenes", AWord), ("k", Whole), ("arithmetic", AWord)]
          <> verdict
          <> [("sides", Perhaps Whole), ("open_sides", Perhaps Whole), ("farthest_off", Perhaps Number)]
          <> [("signs", Perhaps Whole), ("signs_left", Perhaps Whole)]
      , 300
      )
    )
  , ( "radiosity.csv"
    , ( [("scene", AWord), ("mesh", AWord), ("parameter", Perhaps Whole), ("elements", Whole)]
          <> [(name, Number) | name <- words "seconds mean_error largest_error"]
      , 36
      )
    )
  , ( "radiosity-references.csv"
    , ( [("scene", AWord), ("sides", Whole), ("elements", Whole)]
          <> [(name, Number) | name <- words "bounds half_mean_error half_largest_error"]
      , 3
      )
    )
  ]
  where
    sizes = [("scene", AWord), ("corners", Whole), ("pairs", Whole)]
    ways = [("arithmetic", AWord), ("scheduler", AWord)]
    verdict = [("verdict", AWord), ("missing", Perhaps Whole), ("spurious", Perhaps Whole)]

-- | Whether a row has a number under the first name that is greater than the one under the second.
columnAbove :: String -> String -> [(String, String)] -> Bool
columnAbove name limit row = or [x > y | Just x <- [at name], Just y <- [at limit]]
  where
    at column = lookup column row >>= readMaybe :: Maybe Int
