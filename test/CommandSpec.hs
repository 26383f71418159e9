{-# LANGUAGE OverloadedStrings #-}

-- | The command line as its users see it: the executable named by VISCOMPLEX_EXE, or bin/viscomplex.
module CommandSpec (spec) where

import Command.Run
import qualified Data.Aeson as Aeson
import qualified Data.Aeson.Types as Aeson
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Char (isDigit)
import Data.Foldable (for_)
import Data.List (isInfixOf, isPrefixOf, isSuffixOf, nub, sort, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, listToMaybe)
import qualified Data.Set as Set
import Data.Traversable (for)
import System.Directory (listDirectory)
import System.Exit (ExitCode (..))
import System.FilePath (takeExtension, (</>))
import System.IO.Temp (withSystemTempDirectory)
import System.Process (readProcessWithExitCode)
import System.Timeout (timeout)
import Test.Hspec
import Visibility.Scene.Id (CornerName, readCornerName)

-- | A pair of a line of the graph.
pairOf :: String -> (CornerName, CornerName)
pairOf line = case map readCornerName (words line) of
  [Just a, Just b] -> (a, b)
  _ -> error ("not a pair: " <> line)

factorsOf :: String -> [((String, String), String)]
factorsOf text = [((from, to), value) | line <- drop 1 (lines text), [from, to, value] <- [cells line]]

-- | A side of a mesh: its id, and the parameters and kinds of its break points, and of those that were dropped.
data MeshSide = MeshSide
  { meshSide :: String
  , keptPoints :: [(String, String)]
  , droppedPoints :: [(String, String)]
  }

meshOf :: [String] -> IO [MeshSide]
meshOf arguments = do
  text <- output ("mesh" : arguments) ""
  pure (fromMaybe [] (Aeson.decode (Lazy.pack text) >>= Aeson.parseMaybe document))
  where
    document = Aeson.withObject "document" (\o -> o Aeson..: "sides" >>= mapM side)
    side = Aeson.withObject "side" $ \o ->
      MeshSide
        <$> o Aeson..: "id"
        <*> (o Aeson..: "points" >>= mapM point)
        <*> (o Aeson..:? "dropped" Aeson..!= [] >>= mapM point)
    point = Aeson.withObject "point" (\o -> (,) <$> o Aeson..: "parameter" <*> o Aeson..: "kind")

spec :: Spec
spec = do
  describe "every scene in scenes/" $ do
    names <- runIO sceneFiles
    it "is among at least twelve" $ length names `shouldSatisfy` (>= 12)
    it "has its line in scenes/README.md" $ do
      text <- readFile ("scenes" </> "README.md")
      filter (\name -> not (("(" <> name <> ")") `isInfixOf` text)) names `shouldBe` []
    for_ names $ \name ->
      it (name <> " is counted alike by info and graph, whose lines are sorted") $ do
        let file = "scenes" </> name
        info <- output ["info", file] ""
        pairs <- lines <$> output ["graph", file] ""
        lookup "elementary visible pairs" (infoLines info) `shouldBe` Just (show (length pairs))
        bitangents <- lines <$> output ["graph", file, "--bitangents"] ""
        lookup "bitangents" (infoLines info) `shouldBe` Just (show (length bitangents))
        Set.fromList bitangents `Set.isSubsetOf` Set.fromList pairs `shouldBe` True
        map pairOf pairs `shouldBe` sort (map pairOf pairs)
        all (uncurry (<) . pairOf) pairs `shouldBe` True

  it "says the version of package.yaml" $ do
    stated <- filter ("version: " `isPrefixOf`) . lines <$> readFile "package.yaml"
    said <- output ["--version"] ""
    ["version: " <> drop (length ("viscomplex " :: String)) line | line <- lines said] `shouldBe` stated

  describe "graph" $ do
    it "streams the same lines with --unsorted" $ do
      sorted <- lines <$> output ["graph", "scenes/flat.json"] ""
      streamed <- lines <$> output ["graph", "scenes/flat.json", "--unsorted"] ""
      sortOn pairOf streamed `shouldBe` sorted
      length (nub sorted) `shouldBe` length sorted
    it "decides alike under every exact arithmetic" $
      for_ ["grid", "forty-digits", "thirds-and-sevenths", "flat"] $ \name -> do
        let call arithmetic = output ["graph", "scenes" </> name <> ".json", "--arithmetic", arithmetic] ""
        filtered <- call "filtered"
        exact <- call "exact"
        exact `shouldBe` filtered
    it "streams 3 200 corners in memory that does not grow with the number of pairs" $ do
      few <- output ["generate", "comb", "--size", "400"] ""
      many <- output ["generate", "grid", "--size", "800"] ""
      let within memory options = output (["graph", "-", "--memory", memory] <> options)
      fewPairs <- length . lines <$> within "16M" ["--unsorted"] few
      manyPairs <- length . lines <$> within "16M" ["--unsorted"] many
      manyPairs `shouldSatisfy` (> 4 * fewPairs)
      refuses 6 ["16M"] ["graph", "-", "--memory", "16M"] many

  describe "factors" $ do
    it "writes the same factors in every format" $ do
      csv <- factorsOf <$> output ["factors", "scenes/room.json"] ""
      json <- output ["factors", "scenes/room.json", "--format", "json", "--exact"] ""
      text <- output ["factors", "scenes/room.json", "--format", "text"] ""
      let entries = do
            document <- Aeson.decode (Lazy.pack json)
            Aeson.parseMaybe (Aeson.withObject "document" parts) document
          parts o = (,) <$> o Aeson..: "format" <*> o Aeson..: "factors"
          entry = Aeson.withObject "factor" $ \o -> do
            from <- o Aeson..: "from"
            to <- o Aeson..: "to"
            value <- o Aeson..: "value"
            measure <- o Aeson..: "measure" :: Aeson.Parser [(String, String)]
            if null measure then fail "no measure" else pure ((from, to), value)
      fmap fst entries `shouldBe` Just ("viscomplex/1" :: String)
      (entries >>= mapM (Aeson.parseMaybe entry) . snd) `shouldBe` Just csv
      filter (\(_, value) -> not (value `isInfixOf` text)) csv `shouldBe` []
    it "gives as many digits as asked, correctly rounded: √2 − 1 between unit squares a unit apart" $
      for_
        [ (1, "0.4")
        , (2, "0.41")
        , (3, "0.414")
        , (20, "0.41421356237309504880")
        , (40, "0.4142135623730950488016887242096980785697")
        ]
        $ \(n, value) -> do
          rows <- factorsOf <$> output ["factors", "scenes/two-squares.json", "--digits", show (n :: Int)] ""
          Map.elems (Map.filter (\v -> "0.4" `isPrefixOf` v) (Map.fromList rows)) `shouldSatisfy` elem value
    it "reads standard input" $ do
      text <- readFile "scenes/room.json"
      named <- output ["factors", "scenes/room.json"] ""
      piped <- output ["factors", "-"] text
      piped `shouldBe` named

    it "writes with --double the Doubles nearest to the decimals, shortest first, in every format" $
      for_ ["room", "two-squares", "flat"] $ \name -> do
        let call options = output (["factors", "scenes" </> name <> ".json"] <> options) ""
        exact <- factorsOf <$> call ["--digits", "25"]
        doubles <- factorsOf <$> call ["--double"]
        map fst doubles `shouldBe` map fst exact
        let read' text = fst <$> listToMaybe (reads text) :: Maybe Double
        map (read' . snd) doubles `shouldBe` map (read' . snd) exact
        json <- call ["--double", "--format", "json"]
        text <- call ["--double", "--format", "text"]
        for_ (take 20 doubles) $ \(_, value) -> do
          json `shouldContain` ("\"value\":\"" <> value <> "\"")
          text `shouldContain` value

  describe "complex" $ do
    it "is the same to the last byte for both schedulers and every exact arithmetic, in every scene" $ do
      names <- sceneFiles
      for_ names $ \name -> do
        let call options = output (["complex", "scenes" </> name] <> options) ""
        topological <- call []
        straight <- call ["--scheduler", "straight"]
        exact <- call ["--arithmetic", "exact"]
        (name, straight == topological, exact == topological) `shouldBe` (name, True, True)
    it "has the sizes that info counts" $
      for_ ["grid", "room", "thin-walls", "flat"] $ \name -> do
        info <- infoLines <$> output ["info", "scenes" </> name <> ".json"] ""
        text <- output ["complex", "scenes" </> name <> ".json"] ""
        let sizeOf key = do
              document <- Aeson.decode (Lazy.pack text)
              found <- Aeson.parseMaybe (Aeson.withObject "document" (Aeson..: key)) document
              pure (show (length (found :: [Aeson.Value])))
        map sizeOf ["corners", "vertices", "edges", "faces"]
          `shouldBe` map (`lookup` info) ["corners", "vertices", "edges", "faces"]
    it "does not come between the scheduler and the other commands" $
      for_ [["graph"], ["factors"], ["draw", "scene"], ["draw", "dual"], ["draw", "matrix"]] $ \command -> do
        topological <- output (command <> ["scenes/grid.json"]) ""
        straight <- output (command <> ["scenes/grid.json", "--scheduler", "straight"]) ""
        (command, straight == topological) `shouldBe` (command, True)

  describe "mesh" $ do
    it "lists the break points of every side, and drops kinds of them or some where it is told to" $ do
      everything <- meshOf ["scenes/room.json"]
      limits <- meshOf ["scenes/room.json", "--breaks", "shadow-limits"]
      few <- meshOf ["scenes/room.json", "--max-elements", "3"]
      map meshSide limits `shouldBe` map meshSide everything
      sum (map (length . keptPoints) limits) `shouldSatisfy` (> 0)
      for_ (zip everything limits) $ \(whole, part) ->
        keptPoints part `shouldBe` [point | point@(_, "shadow-limit") <- keptPoints whole]
      for_ (zip everything few) $ \(whole, part) -> do
        length (keptPoints part) `shouldSatisfy` (<= 2)
        sort (keptPoints part <> droppedPoints part) `shouldBe` sort (keptPoints whole)
      sum (map (length . droppedPoints) few) `shouldSatisfy` (> 0)
    it "cuts all sides into equal parts" $ do
      found <- meshOf ["scenes/room.json", "--breaks", "uniform:4"]
      length found `shouldSatisfy` (> 0)
      map keptPoints found `shouldBe` map (const [(t, "equal-parts") | t <- ["1/4", "1/2", "3/4"]]) found
    it "does not depend on the scheduler" $ do
      topological <- output ["mesh", "scenes/flat.json"] ""
      output ["mesh", "scenes/flat.json", "--scheduler", "straight"] "" `shouldReturn` topological
    it "refuses a mesh that it does not know" $ do
      refuses 1 ["some is none of: all, shadow-limits, uniform:N"] ["mesh", "scenes/room.json", "--breaks", "some"] ""
      refuses 1 ["uniform"] ["mesh", "scenes/room.json", "--breaks", "uniform:0"] ""
      refuses 1 ["max-elements"] ["mesh", "scenes/room.json", "--max-elements", "0"] ""

  describe "verify" $ do
    it "finds every law to hold" $
      for_ ["grid", "room", "thin-walls", "hooks", "forty-digits"] $ \name -> do
        text <- lines <$> output ["verify", "scenes" </> name <> ".json"] ""
        filter (not . ("holds " `isPrefixOf`)) (take (length text - 1) text) `shouldBe` []
        length text `shouldSatisfy` (> 15)
        last ("" : text) `shouldSatisfy` isInfixOf "0 broken"
    it "ends with exit code 5 and says which laws are broken, where Doubles went wrong" $ do
      scene <- readFile "test/golden/complex/nearly-collinear.scene.json"
      (code, out, err) <- run ["verify", "-", "--arithmetic", "double"] scene
      (code, err) `shouldBe` (5, "")
      out `shouldSatisfy` isInfixOf "BROKEN"

  describe "view" $ do
    it "tells the visibility polygon of a point, closed by the room" $ do
      text <- output ["view", "test/golden/complex/l-room.scene.json", "--from", "1,1"] ""
      filter (/= '"') text
        `shouldBe` "{format:viscomplex/1,from:[1,1],polygon:[[0,0],[4,0],[4,2],[2,2],[2,4],[0,4]],unbounded:[]}\n"
    it "tells what a side sees as factors does" $ do
      rows <- factorsOf <$> output ["factors", "scenes/room.json"] ""
      text <- output ["view", "scenes/room.json", "--side", "E.0"] ""
      seenIn text `shouldBe` Just [(to, value) | ((from, to), value) <- rows, from == "E.0"]
    it "tells the form factors of an element, which depend on the direction of its normal only" $ do
      let call normal = output ["view", "scenes/room.json", "--from", "1/2,3", "--normal=" <> normal, "--exact"] ""
      one <- call "1,-2"
      three <- call "3/2,-3"
      three `shouldBe` one
      seenIn one `shouldSatisfy` maybe False (not . null)
    it "refuses places that are not in the scene or in the solid, as wrong usage" $ do
      refuses 1 ["polygon 0 has no corner 9", "0.0 to 0.3"] ["view", "scenes/room.json", "--corner", "0.9"] ""
      refuses 1 ["no polygon 7"] ["view", "scenes/room.json", "--side", "7.0"] ""
      refuses 1 ["outside the enclosure"] ["view", "scenes/room.json", "--from=-100,0"] ""
      refuses 1 ["inside polygon 0"] ["view", "scenes/two-squares.json", "--from", "1/2,1/2"] ""
      for_ ["1", "1,", "1,2,3", "x,y"] $ \place ->
        refuses 1 ["--from", "is not a"] ["view", "scenes/room.json", "--from", place] ""
      refuses 1 ["denominator 0"] ["view", "scenes/room.json", "--from", "1/0,2"] ""
      refuses 1 ["-400 to 400"] ["view", "scenes/room.json", "--from", "1e401,2"] ""
      refuses 1 ["not a name"] ["view", "scenes/room.json", "--corner", "0.01"] ""
      refuses 1 ["view: give --from", "view SCENE"] ["view", "scenes/room.json"] ""
      refuses 1 ["not with --side"] ["view", "scenes/room.json", "--side", "0.0", "--normal", "0,1"] ""
      refuses 1 ["not more"] ["view", "scenes/room.json", "--from", "1,1", "--corner", "0.0"] ""
      refuses 1 ["normal"] ["view", "scenes/room.json", "--from", "1/2,3", "--normal", "0,0"] ""
      refuses 1 ["draw view: give --from"] ["draw", "view", "scenes/room.json"] ""
      refuses 1 ["--from; it is an option of view, draw view"] (words "draw dual scenes/room.json --from 1,1") ""

  describe "draw" $ do
    it "draws views" $
      for_ ["--from 1/2,3", "--corner 0.1", "--side E.0", "--from 1/2,3 --normal 0,1"] $ \from -> do
        svg <- output (["draw", "view", "scenes/room.json"] <> words from) ""
        svg `shouldSatisfy` isInfixOf "<svg"
    it "writes a figure to the file named, and nothing else" $
      withSystemTempDirectory "viscomplex" $ \folder ->
        for_ ["scene", "dual", "matrix", "mesh"] $ \figure -> do
          let file = folder </> figure <> ".svg"
          out <- output ["draw", figure, "scenes/room.json", "-o", file] ""
          out `shouldBe` ""
          svg <- readFile file
          svg `shouldSatisfy` isInfixOf "<svg"
          piped <- output ["draw", figure, "scenes/room.json"] ""
          piped `shouldBe` svg
    it "draws meshes, with their lines if asked to, and their options with nothing else" $ do
      let call options = output (["draw", "mesh", "scenes/room.json"] <> options) ""
      plain <- call []
      call ["--breaks", "all"] `shouldReturn` plain
      plain `shouldSatisfy` isInfixOf "class=\"breaks\""
      plain `shouldSatisfy` not . isInfixOf "class=\"lines\""
      withLines <- call ["--lines"]
      withLines `shouldSatisfy` isInfixOf "class=\"lines\""
      few <- call ["--max-elements", "2"]
      length few `shouldSatisfy` (< length plain)
      for_ [["--lines"], ["--breaks", "all"]] $ \options ->
        refuses 1 ["it is an option of", "draw mesh"] (["draw", "scene", "scenes/room.json"] <> options) ""
      refuses 1 ["it is an option of view, draw view"] ["draw", "mesh", "scenes/room.json", "--from", "1,1"] ""
    it "draws the figures of the README, of docs/commands.md and of docs/mesh.md" $
      for_ documentedFigures $ \(figure, name) -> do
        svg <- output (["draw"] <> take 1 (words figure) <> ["scenes/room.json"] <> drop 1 (words figure)) ""
        shown <- readFile ("docs" </> "figures" </> name <> ".svg")
        svg `shouldBe` shown
    it "draws the figures of docs/sweep.md as they are there" $ do
      page <- readFile "docs/sweep.md"
      for_ sweepFigures $ \(name, k) -> do
        page `shouldSatisfy` isInfixOf ("figures/sweep/" <> name <> ".svg")
        svg <- output ["draw", "sweep", "scenes/sweep.json", "--at", show k] ""
        shown <- readFile ("docs/figures/sweep" </> name <> ".svg")
        svg `shouldBe` shown
    it "draws so many states of the sweep into a folder, the first and the last among them" $
      withSystemTempDirectory "viscomplex" $ \folder -> do
        _ <- output ["draw", "sweep", "scenes/sweep.json", "--frames", "4", "-o", folder </> "frames"] ""
        names <- sort <$> listDirectory (folder </> "frames")
        names `shouldBe` ["00.svg", "16.svg", "32.svg", "49.svg"]
        for_ names $ \name -> do
          alone <- output ["draw", "sweep", "scenes/sweep.json", "--at", take 2 name] ""
          frame <- readFile (folder </> "frames" </> name)
          frame `shouldBe` alone
    it "refuses moments that a sweep does not have, and frames without a folder" $ do
      refuses 1 ["49 vertices"] ["draw", "sweep", "scenes/sweep.json", "--at", "50"] ""
      refuses 1 ["--at K or --frames N"] ["draw", "sweep", "scenes/sweep.json"] ""
      refuses 1 ["--output FOLDER"] ["draw", "sweep", "scenes/sweep.json", "--frames", "3"] ""
      refuses 1 ["--at; it is an option of draw sweep"] ["draw", "scene", "scenes/sweep.json", "--at", "3"] ""
    it "says so where it cannot write" $
      refuses 2 [nowhere, "cannot be written"] ["draw", "scene", "scenes/room.json", "-o", nowhere] ""

  describe "generate" $
    it "prints scenes that can be read, the same for the same seed" $
      for_ (words "random sparse grid room comb thin-walls needles kettner ceiling tower") $ \name -> do
        let call seed = output ["generate", name, "--size", "5", "--seed", seed] ""
        scene <- call "3"
        again <- call "3"
        again `shouldBe` scene
        info <- output ["info", "-"] scene
        lookup "vertices" (infoLines info) `shouldSatisfy` maybe False (all isDigit)

  describe "version" $
    it "is that of the package" $ do
      version <- output ["--version"] ""
      package <- readFile "package.yaml"
      [drop 9 line | line <- lines package, "version: " `isPrefixOf` line] `shouldBe` [drop 11 (concat (lines version))]
  describe "help" $
    it "teaches by example, for every command" $
      for_ ([] : map pure (words "info graph factors complex mesh view verify draw generate")) $ \command -> do
        text <- output (command <> ["--help"]) ""
        text `shouldSatisfy` isInfixOf "viscomplex"
        text `shouldSatisfy` isInfixOf "Examples:"

  describe "formats of scenes" $ do
    it "give the same results, told by the ending of the file" $
      withSystemTempDirectory "viscomplex" $ \folder -> do
        let statements =
              [ ("a.json", "{\"polygons\": [[[0,0],[1,0],[0,1]], [[3,0],[4,\"1/3\"]]]}")
              , ( "a.geojson"
                , "{\"type\": \"GeometryCollection\", \"geometries\": [\
                  \ {\"type\": \"Polygon\", \"coordinates\": [[[0,0],[1,0],[0,1],[0,0]]]},\
                  \ {\"type\": \"LineString\", \"coordinates\": [[3,0],[4,\"1/3\"]]}]}"
                )
              , ("a.WKT", "POLYGON ((0 0, 1 0, 0 1, 0 0))\n# a wall\nLINESTRING (3 0, 4 1/3)\n")
              ]
        for_ statements $ \(name, text) -> writeFile (folder </> name) text
        for_ [["graph"], ["factors", "--exact"], ["complex"]] $ \command -> do
          results <- mapM (\(name, _) -> output (command <> [folder </> name]) "") statements
          length (nub results) `shouldBe` 1
    it "do not change what - reads, which is JSON" $ do
      refuses 3 ["standard input", "line 1, column 1"] ["info", "-"] "LINESTRING (0 0, 1 0)"
      refuses 3 ["standard input", "\"polygons\""] ["info", "-"] "{\"type\": \"FeatureCollection\", \"features\": []}"
    it "have the same exit codes" $
      withSystemTempDirectory "viscomplex" $ \folder -> do
        let given name text = writeFile (folder </> name) text >> pure ["info", folder </> name]
        for_ ["none.geojson", "none.wkt"] $ \name -> refuses 2 [name, "no such file"] ["info", folder </> name] ""
        hole <- given "hole.geojson" "{\"type\": \"Polygon\", \"coordinates\": [[[0,0],[9,0],[0,9],[0,0]], []]}"
        refuses 3 ["hole.geojson: $.coordinates[1]", "is a hole"] hole ""
        lines' <- given "lines.wkt" "LINESTRING (0 0, 1 x)\nCIRCLE (0 0)\n"
        refuses 3 ["lines.wkt: line 1, column 20", "line 2, column 1"] lines' ""
        crossing <- given "crossing.wkt" "LINESTRING (0 0, 2 2)\nLINESTRING (0 2, 2 0)\n"
        refuses 4 ["crossing.wkt: polygon 0", "crosses"] crossing ""
        nothing <- given "empty.geojson" "{\"type\": \"FeatureCollection\", \"features\": []}"
        refuses 4 ["empty.geojson", "empty"] nothing ""

  describe "mistakes" $ do
    it "in usage end with exit code 1" $ do
      for_
        [ []
        , ["grpah"]
        , ["graph"]
        , ["graph", "a", "b"]
        , ["draw", "picture", "scenes/room.json"]
        , ["generate", "circles", "--size", "3"]
        ]
        $ \arguments -> refuses 1 ["Usage"] arguments ""
      for_ ["0", "-3", "1.5", "0x2", "(3)", "", "18446744073709551617"] $ \number -> do
        refuses 1 ["digits"] ["factors", "scenes/room.json", "--digits=" <> number] ""
        refuses 1 ["size"] ["generate", "random", "--size=" <> number] ""
      for_ ["-5", "18446744073709551616", "x"] $ \number ->
        refuses 1 ["seed"] ["generate", "random", "--size", "3", "--seed=" <> number] ""
      refuses 1 ["--double", "--digits"] ["factors", "scenes/room.json", "--double", "--digits", "3"] ""
      refuses 1 ["--double", "--exact"] ["factors", "scenes/room.json", "--double", "--exact"] ""
      refuses 1 ["filtered, exact, double"] ["graph", "scenes/room.json", "--arithmetic", "float"] ""
    it "in file names end with exit code 2" $ do
      refuses 2 ["scenes/no-such.json"] ["graph", "scenes/no-such.json"] ""
      refuses 2 ["scenes"] ["graph", "scenes"] ""
    it "of standard output are told: a full device ends with exit code 2, a closed pipe silently" $ do
      exe <- executable
      let shell command = readProcessWithExitCode "sh" ["-c", exe <> " " <> command] ""
          printing = ["graph scenes/city.json", "graph --unsorted scenes/city.json", "generate grid --size 9"]
      for_ ("info scenes/room.json" : printing) $
        \arguments -> do
          (code, out, err) <- shell (arguments <> " > /dev/full")
          (code, out) `shouldBe` (ExitFailure 2, "")
          err `shouldSatisfy` isInfixOf "standard output: cannot be written"
          (_, _, silent) <- shell (arguments <> " | head -n 1 > /dev/null")
          silent `shouldBe` ""
    it "of the unsafe arithmetic end with exit code 70, the law and the scene" $ do
      (code, out, err) <- run ["graph", "scenes/forty-digits.json", "--arithmetic", "double"] ""
      (code, out) `shouldBe` (70, "")
      for_ ["law is broken", "unsafe", "The scene was:", "forty digits"] $ \phrase ->
        err `shouldSatisfy` isInfixOf phrase
      statement <- readFile "scenes/forty-digits.json"
      (code', out', err') <- run ["graph", "-", "--arithmetic", "double"] statement
      (code', out', err') `shouldBe` (code, out, err)
      err' `shouldSatisfy` isSuffixOf ("The scene was:\n" <> statement <> "\n")
    it "of the unsafe arithmetic give a wrong graph or none, where corners are nearly in line" $ do
      -- Whatever goes wrong stays in a process of its own, with little time and memory.
      let call name arithmetic =
            timeout 20000000 $
              run ["graph", "scenes" </> name <> ".json", "--arithmetic", arithmetic, "--memory", "400M"] ""
      answers <- for ["kettner-a", "kettner-b"] $ \name -> (,,) name <$> call name "filtered" <*> call name "double"
      [name | (name, right, _) <- answers, fmap (\(code, _, _) -> code) right /= Just 0] `shouldBe` []
      [name | (name, right, unsafe) <- answers, unsafe == right] `shouldBe` []
    for_ [("forty-digits", "are in order"), ("kettner-a", "to the end of its range")] $ \(name, law) ->
      it ("of the unsafe arithmetic are noticed by the laws of the sweep: " <> law) $ do
        (code, _, err) <- run ["graph", "scenes" </> name <> ".json", "--arithmetic", "double"] ""
        code `shouldBe` 70
        err `shouldSatisfy` isInfixOf law
    for_ ["info", "graph", "factors", "complex", "verify"] $ \command -> do
      it ("in syntax and shape end with exit code 3 in " <> command) $ do
        refuses 3 ["standard input"] [command, "-"] "{\"polygons\": [[[0,0],[1,0],[0,1]]"
        refuses 3 ["colour"] [command, "-"] "{\"polygons\": [], \"colour\": 1}"
        refuses 3 ["1/0"] [command, "-"] "{\"polygons\": [[[0,0],[\"1/0\",0],[0,1]]]}"
        refuses 3 ["exponent"] [command, "-"] "{\"polygons\": [[[0,0],[1e999999999,0],[0,1]]]}"
        refuses 3 ["standard input"] [command, "-"] ""
      it ("in geometry end with exit code 4, all of them reported, in " <> command) $ do
        refuses 4 ["standard input"] [command, "-"] "{\"polygons\": []}"
        refuses
          4
          ["polygon 0", "polygon 1", "polygon 2"]
          [command, "-"]
          "{\"polygons\": [[[0,0],[1,1],[1,0],[0,1]], [[5,0],[6,0],[7,0]], [[10,0],[11,0],[10,0],[9,5]]]}"
        refuses
          4
          ["polygon 0", "polygon 1"]
          [command, "-"]
          "{\"polygons\": [[[0,0],[1,0],[0,1]], [[1,0],[\"1/4\",\"1/2\"],[\"1/4\",\"1/4\"]]]}"
  where
    nowhere = "/nowhere/at/all.svg"
    -- Figures of scenes/room.json, and their names in docs/figures.
    documentedFigures =
      [ ("scene", "room")
      , ("dual", "room-dual")
      , ("view --corner 0.1", "room-view")
      , ("radiosity --mesh discontinuity", "room-radiosity")
      , ("mesh", "room-mesh")
      , ("mesh --breaks shadow-limits --lines", "room-shadows")
      ]
    -- By name, how many vertices have been swept.
    sweepFigures = [("start", 0 :: Int), ("ready", 8), ("chain", 26), ("line", 12)]
    sceneFiles = sort . filter ((`elem` [".json", ".geojson", ".wkt"]) . takeExtension) <$> listDirectory "scenes"

-- | The objects seen and their form factors, of a view.
seenIn :: String -> Maybe [(String, String)]
seenIn text = Aeson.decode (Lazy.pack text) >>= Aeson.parseMaybe seen >>= mapM entry
  where
    seen = Aeson.withObject "view" (Aeson..: "sees")
    entry = Aeson.parseMaybe . Aeson.withObject "object seen" $ \o -> (,) <$> o Aeson..: "id" <*> o Aeson..: "value"

-- | The values of info by their names.
infoLines :: String -> [(String, String)]
infoLines text = [(trimmed name, trimmed value) | line <- lines text, let (name, value) = splitAt 26 line]
  where
    trimmed = unwords . words
