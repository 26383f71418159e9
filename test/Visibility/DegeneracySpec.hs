-- | The scenes of docs/degeneracies.md. Every answer here is derived by hand from the definitions of that document, as
-- the comments say; the laws then hold besides, for every scene and either sweep.
module Visibility.DegeneracySpec (spec) where

import Control.Monad (forM_)
import qualified Data.ByteString as Bytes
import Data.Foldable (toList)
import Data.List (isInfixOf, sort, sortBy, (\\))
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Text as Text
import Data.Text.Encoding (decodeUtf8)
import System.Directory (doesFileExist, listDirectory)
import System.FilePath (dropExtension, takeExtension, (<.>), (</>))
import Test.Hspec
import Visibility.Complex (complexOf)
import Visibility.Complex.Law (Law (..), checked)
import Visibility.Complex.Polygons
import Visibility.Complex.Type
import Visibility.Count
import Visibility.Draw.Checks
import Visibility.Draw.Drawing
import Visibility.Draw.Dual (dualDrawing)
import Visibility.Draw.Scene (sceneDrawing)
import Visibility.Error (Problem (..), SceneError (..))
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.Predicate (Direction (..), primitive)
import Visibility.Exact.RootSum (RootSum, Sign (..), fromTerms, rational, sign, zero)
import Visibility.FormFactor
import Visibility.Format.Graph (PairSelection (..), selectedPairs)
import Visibility.Format.File (readRawSceneFile, readSceneFile)
import Visibility.Scene
import Visibility.Scene.Raw (RawScene (..), rawCorners)
import Visibility.Sweep
import Visibility.Test.BruteForce (bruteForce)
import Visibility.View (End (..), Flank (..), events)

spec :: Spec
spec = do
  forM_ cases $ \(Case name rule wanted) -> do
    it (name <> ": " <> rule) $
      withScene name $ \scene -> concatMap ($ scene) wanted `shouldBe` []
    it (name <> ": both sweeps are brute force, and all laws hold") $
      withScene name $ \scene -> do
        let found = bruteForce scene
        sort (vertices scene) `shouldBe` found
        sort (straightVertices scene) `shouldBe` found
        [(lawName law, broken) | (law, broken@(_ : _)) <- checked (complexOf scene)] `shouldBe` []
        [side | (side, defect) <- closureDefect scene (measuresOf scene), sign defect /= Zero] `shouldBe` []
        [name | sceneContacts scene > 0, Just _ <- [outlines (polygonComplex (complexOf scene))]] `shouldBe` []
    it (name <> ": the figures have a label for every corner, and dots at flat corners only") $
      withScene name $ \scene -> do
        let found = vertices scene
            names = sort (map (Text.pack . cornerText . fst) (statedCorners scene))
            ends = [Text.pack (cornerText (cornerName scene c)) | c <- corners scene, isWallEnd scene c]
        sort (concatMap Text.words (labelsOf (sceneDrawing scene found))) `shouldBe` names
        sort (concatMap Text.words (labelsOf (dualDrawing scene (events scene found))))
          `shouldBe` sort
            [Text.pack (cornerText c) | g <- placeGroups scene, c <- concatMap (namesHere scene) (take 1 g)]
        filter (`elem` ends) (map markName (marksIn (Text.pack "flat-corners") (sceneDrawing scene found)))
          `shouldBe` []
  forM_ refusals $ \(Refusal name rule wanted) ->
    it (name <> ": " <> rule) $ do
      result <- readSceneFile (folder </> "refused" </> name <.> "json")
      either (map problem . toList) (const []) result `shouldBe` map Just wanted
  describe "docs/degeneracies.md" $ do
    files <- runIO (namesIn folder)
    refused <- runIO (namesIn (folder </> "refused"))
    text <- runIO (Text.unpack . decodeUtf8 <$> Bytes.readFile document)
    it "has a test for every scene, and a scene for every test" $ do
      sort [name | Case name _ _ <- cases] `shouldBe` files
      sort [name | Refusal name _ _ <- refusals] `shouldBe` refused
    it "names the test of every scene" $
      [ name
      | (name, rule) <- [(n, r) | Case n r _ <- cases] <> [(n, r) | Refusal n r _ <- refusals]
      , not (("`" <> name <> ": " <> rule <> "`") `isInfixOf` unwords (words text))
      ]
        `shouldBe` []
    it "has a section and a figure for every scene" $
      [ name
      | name <- files
      , not (("\n### " <> name <> "\n") `isInfixOf` text) || not ((figureOf name <> ")") `isInfixOf` text)
      ]
        `shouldBe` []
    forM_ files $ \name ->
      it (name <> " has a name, at most ten corners and a figure") $ do
        result <- readRawSceneFile (folder </> name <.> "json")
        case result of
          Left problems -> expectationFailure (show problems)
          Right raw -> do
            rawName raw `shouldSatisfy` (/= Nothing)
            sum (map (length . rawCorners) (rawPolygons raw <> toList (rawEnclosure raw))) `shouldSatisfy` (<= 10)
        doesFileExist ("docs" </> figureOf name) `shouldReturn` True
    it "shows no figure that is not there" $
      mapM doesFileExist (figuresIn text) `shouldReturn` map (const True) (figuresIn text)
  where
    withScene name check =
      readSceneFile (folder </> name <.> "json") >>= either (expectationFailure . show) check
    problem (InvalidScene _ fault) = Just fault
    problem _ = Nothing
    namesIn path = sort . map dropExtension . filter ((== ".json") . takeExtension) <$> listDirectory path
    figureOf name = "figures" </> "degenerate" </> name <.> "svg"

    labelsOf drawing = [text | Mark _ _ (Label _ _ text) <- marksIn (Text.pack "labels") drawing]

folder, document :: FilePath
folder = "scenes" </> "degenerate"
document = "docs" </> "degeneracies.md"

-- | The figures that a document shows.
figuresIn :: String -> [FilePath]
figuresIn text = case text of
  ']' : '(' : rest
    | (path, ')' : more) <- break (== ')') rest -> ["docs" </> path | takeExtension path == ".svg"] <> figuresIn more
  _ : rest -> figuresIn rest
  [] -> []

-- | A scene of the folder, its rule, and what must hold of it.
data Case = Case String String [Claim]

-- | A scene that is refused, why, and with which errors.
data Refusal = Refusal String String [SceneError]

-- | What differs from what is expected; nothing if it is as expected.
type Claim = Scene -> [String]

claim :: (Eq a, Show a) => String -> a -> (Scene -> a) -> Claim
claim what wanted found scene
  | found scene == wanted = []
  | otherwise = [what <> ": expected " <> show wanted <> ", found " <> show (found scene)]

-- | The whole visibility graph: each word is two places joined by a hyphen, a place the names of one or several corners
-- in it, with commas.
pairs :: String -> Claim
pairs wanted = claim "pairs" (sort (concatMap namedPairs (words wanted))) (graphOf AllPairs)

-- | All pairs of corners are elementary but these.
allPairsBut :: String -> Claim
allPairsBut missing =
  claim "pairs that are missing" (sort (concatMap namedPairs (words missing))) $ \scene ->
    let names = map (cornerText . fst) (statedCorners scene)
     in [(a, b) | (i, a) <- zip [0 :: Int ..] names, b <- drop (i + 1) names] \\ graphOf AllPairs scene

-- | These pairs are elementary.
sees :: String -> Claim
sees wanted = claim "pairs that are missing" [] ((concatMap namedPairs (words wanted) \\) . graphOf AllPairs)

-- | These pairs are not elementary.
hides :: String -> Claim
hides unwanted =
  claim "pairs that should not be" [] $ \scene ->
    filter (`elem` graphOf AllPairs scene) (concatMap namedPairs (words unwanted))

-- | All free bitangents.
bitangents :: String -> Claim
bitangents wanted = claim "free bitangents" (sort (concatMap namedPairs (words wanted))) (graphOf FreeBitangents)

namedPairs :: String -> [(String, String)]
namedPairs word = [(a, b) | a <- names from, b <- names (drop 1 to)]
  where
    (from, to) = break (== '-') word
    names text = case break (== ',') text of
      (name, ',' : rest) -> name : names rest
      (name, _) -> [name]

graphOf :: PairSelection -> Scene -> [(String, String)]
graphOf selection scene =
  sort [(cornerText a, cornerText b) | (a, b) <- selectedPairs scene selection (vertices scene)]

-- | All degenerate vertices, each with all its corners, in canonical order.
lines' :: [String] -> Claim
lines' wanted =
  claim "degenerate vertices" wanted $ \scene -> map (lineText scene) (filter (isDegenerate scene) (inOrder scene))

-- | All vertices of a direction, in canonical order.
inDirection :: (Integer, Integer) -> [String] -> Claim
inDirection (dx, dy) wanted =
  claim ("vertices of direction " <> show (dx, dy)) wanted $ \scene ->
    [lineText scene v | v <- inOrder scene, primitive (vertexDirection scene v) == Direction dx dy]

-- | The first and the last vertex in canonical order.
firstAndLast :: String -> String -> Claim
firstAndLast one other =
  claim "first and last vertex" [one, other] $ \scene ->
    let found = map (lineText scene) (inOrder scene) in take 1 found <> drop (length found - 1) found

inOrder :: Scene -> [Vertex]
inOrder scene = sortBy (compareVertices scene) (vertices scene)

lineText :: Scene -> Vertex -> String
lineText scene = unwords . map (cornerText . cornerName scene) . vertexCorners

-- | What the line of a vertex does at its corners, and what its segment ends at: back, then front; a corner by its
-- name.
atLine :: String -> [Kind] -> (String, String) -> Claim
atLine line kinds ends =
  claim ("the line " <> line) [(kinds, ends)] $ \scene ->
    let complex = complexOf scene
     in [ (vertexKinds complex i, (end (vertexFirst v) vertexBack, end (vertexLast v) vertexFront))
        | i <- vertexIds complex
        , let v = vertexAt complex i
        , lineText scene v == line
        , let end corner object = maybe (cornerText (cornerName scene corner)) (objectText scene) (object complex i)
        ]

-- | V, E, B and F: vertices, edges, buried stretches, faces.
sizes :: Int -> Int -> Int -> Int -> Claim
sizes v e b f =
  claim "vertices, edges, buried stretches, faces" [v, e, b, f] $ \scene ->
    let c = count scene (events scene (vertices scene)) in map ($ c) [vertexCount, edgeCount, buriedCount, faceCount]

-- | The names of the corners of free space in the place of a corner, one for each cone.
cones :: String -> [String] -> Claim
cones corner wanted =
  claim ("cones of free space at " <> corner) (Just wanted) $ \scene ->
    map (cornerText . cornerName scene) <$> (readCornerName corner >>= cornersNamed scene)

-- | The sides that are not whole: what part is free, and in how many pieces; and the whole ones in more than one piece.
free :: [(String, Rational, Int)] -> Claim
free wanted =
  claim "sides that are covered in part or cut" (sort wanted) $ \scene ->
    sort
      [ (sideText s, uncovered scene s, length pieces)
      | s <- statedSides scene
      , let pieces = fromMaybe [] (piecesOf scene s)
      , (uncovered scene s, length pieces) /= (1, 1)
      ]

-- | A form factor, as terms of coefficient and radicand; none for no factor.
factor :: String -> String -> [(Rational, Integer)] -> Claim
factor from to wanted = claim (from <> " to " <> to) (fromMaybe zero (fromTerms wanted)) $ \scene ->
  Map.findWithDefault zero (from, to) (factorsOf scene)

-- | These sides see nothing but the sky, with the form factor 1.
seeOnlySky :: [String] -> Claim
seeOnlySky names = claim "what these sides see" (map (\s -> (s, [("sky", rational 1)])) names) $ \scene ->
  [(s, [(to, value) | ((from, to), value) <- Map.toList (factorsOf scene), from == s]) | s <- names]

measuresOf :: Scene -> Measures
measuresOf scene = measures scene (vertices scene)

factorsOf :: Scene -> Map.Map (String, String) RootSum
factorsOf scene =
  Map.fromList
    [((sideText (factorFrom f), seenText (factorTo f)), factorValue f) | f <- formFactors scene (measuresOf scene)]

-- | One less half the root of two: the form factor between two sides of one length at a right angle. In a triangle of
-- sides a, b, c the measure of the lines between a and b is a + b − c, which is all of this and most that follows.
rightAngle :: [(Rational, Integer)]
rightAngle = [(1, 1), (-1 / 2, 2)]

-- The parts of form factors that follow from it for sides of other lengths.
times :: Rational -> [(Rational, Integer)] -> [(Rational, Integer)]
times k = map (\(c, n) -> (k * c, n))

-- Numbers below come from three rules. Under the sky the faces are one more than the pairs of each vertex, a wall that
-- nothing touches counted twice; in a room there is no such one more. A corner has as many stretches as vertices, so E
-- + B is the number of corners of all vertices together. A corner is buried where both rays of its line enter the
-- solid.

cases :: [Case]
cases =
  -- One pair, along the wall. Each corner is on this one vertex, so its curve is one edge. Two faces begin with the
  -- pair of a wall, and there is the sky's.
  [ Case "wall-alone" "its line is a vertex with one pair, and its faces see the sky only" $
      [pairs "0.0-0.1", lines' [], bitangents "", sizes 1 2 0 3, seeOnlySky ["0.0", "0.1"]]
  , -- Six sides, and the line across the notch. At 0.3 = (1, 1) the solid is all but the quadrant of the notch, so the
    -- lines that fall to the right through it are buried: one stretch. The two sides of the notch are at a right angle.
    Case "reflex" "a reflex corner is never tangent, and buried where both rays enter the solid" $
      [ pairs "0.0-0.1 0.1-0.2 0.2-0.3 0.3-0.4 0.4-0.5 0.0-0.5 0.2-0.4"
      , bitangents "0.2-0.4"
      , sizes 7 13 1 8
      , factor "0.2" "0.3" rightAngle
      ]
  , -- The top is cut at 0.3 = (2, 2). The line y = 2 runs along both parts and on to the wall. From 1.1 the line to 0.3
    -- ends there, as 0.3 has the solid on both flanks of every other line. For the strings from [0.3, 0.2] and [0.4,
    -- 0.3] to the wall, crossed less uncrossed: (4 + √13) − (2 + √29) and (6 + √29) − (4 + √53).
    Case "flat-corner" "a flat corner is tangent along its sides only, and its two sides are two objects" $
      [ pairs "0.0-0.1 0.1-0.2 0.2-0.3 0.3-0.4 0.0-0.4 1.0-1.1 0.2-1.0 0.1-1.0 0.1-1.1 0.2-1.1 0.3-1.1 0.4-1.1"
      , lines' ["0.4 0.3 0.2 1.0"]
      , bitangents "0.2-1.0 0.1-1.0 0.1-1.1 0.4-1.1"
      , atLine "0.3 1.1" [EndingAt Back, TangentAt Below] ("0.3", "sky")
      , factor "0.2" "1.1" [(1 / 2, 1), (1 / 4, 13), (-1 / 4, 29)]
      , factor "0.3" "1.1" [(1 / 2, 1), (1 / 4, 29), (-1 / 4, 53)]
      ]
  , -- Triangles that differ by (6, 2). From the left one, 0.1 and 0.2 see the right one whole, 0.0 is behind them. For
    -- each of the three directions of sides there are two sides; the two outer bitangents have the direction (3, 1).
    Case "parallel" "parallel lines are vertices of their own, in the order of their offsets" $
      [ pairs "0.0-0.1 0.0-0.2 0.1-0.2 1.0-1.1 1.0-1.2 1.1-1.2 0.1-1.0,1.1,1.2 0.2-1.0,1.1,1.2"
      , lines' []
      , inDirection (3, 1) ["0.1 1.1", "0.2 1.2"]
      , inDirection (2, -1) ["0.0 0.1", "1.0 1.1"]
      , inDirection (1, 2) ["1.0 1.2", "0.0 0.2"]
      , inDirection (1, -3) ["0.2 0.1", "1.2 1.1"]
      , sizes 12 24 0 13
      ]
  , -- Hidden by the wall [0.0, 0.1]: 2.0 from 3.0, at the height 4/5. The five others have a corner between them. The
    -- steepest lines that fall have the slope −4, from 2.1 and from 1.1; that of 2.1 has the lesser offset.
    Case "verticals" "the half turn begins just after the vertical: a vertical is the last vertex, and runs upwards" $
      [ allPairsBut "0.0-1.0 0.0-1.1 0.1-1.1 1.1-2.0 0.0-3.1 2.0-3.0"
      , lines' ["0.0 3.0 3.1", "2.0 2.1 1.1", "0.0 0.1 1.0 1.1"]
      , inDirection (1, -4) ["2.1 0.0", "1.1 3.0"]
      , firstAndLast "2.1 0.0" "0.0 0.1 1.0 1.1"
      ]
  , -- Each wall ends on the line y = 0 and hangs from it. What else is missing is blocked by the wall in the middle.
    Case "collinear-one-side" "corners on one line, solid on one side, are one vertex in order, neighbours are pairs" $
      [ allPairsBut "0.0-2.0 0.0-2.1 0.1-2.0 0.1-2.1"
      , lines' ["0.0 1.0 2.0"]
      , atLine "0.0 1.0 2.0" (replicate 3 (TangentAt Below)) ("sky", "sky")
      , sizes 10 21 0 15
      ]
  , -- The wall in the middle stands on the line, so nothing else is blocked.
    Case "collinear-both-sides" "a line squeezed between solids with zero width is free" $
      [ allPairsBut "0.0-2.0"
      , lines' ["0.0 1.0 2.0"]
      , atLine "0.0 1.0 2.0" [TangentAt Below, TangentAt Above, TangentAt Below] ("sky", "sky")
      , sizes 13 27 0 18
      ]
  , -- The lines of the bottoms and of the tops; between the squares the two diagonals. The sides that face each other:
    -- crossed strings √2 each, uncrossed ones 1 each.
    Case "aligned-sides" "collinear sides are on one vertex, and see nothing of each other" $
      [ pairs "0.0-0.1 0.1-0.2 0.2-0.3 0.0-0.3 1.0-1.1 1.1-1.2 1.2-1.3 1.0-1.3 0.1-1.0 0.2-1.3 0.1-1.3 0.2-1.0"
      , lines' ["0.0 0.1 1.0 1.1", "0.3 0.2 1.3 1.2"]
      , bitangents "0.1-1.0 0.2-1.3 0.1-1.3 0.2-1.0"
      , factor "0.1" "1.3" [(1, 2), (-1, 1)]
      , factor "0.0" "1.0" []
      , seeOnlySky ["0.0", "0.2", "0.3", "1.0", "1.1", "1.2"]
      ]
  , -- The squares touch the line x = 1 from the left and from the right, at different heights.
    Case "vertical-squeezed" "a vertical is squeezed between solids like any other line" $
      [ pairs "0.0-0.1 0.1-0.2 0.2-0.3 0.0-0.3 1.0-1.1 1.1-1.2 1.2-1.3 1.0-1.3 0.2-1.0 0.1,0.2,0.3-1.1 0.3-1.0,1.3"
      , lines' ["0.1 0.2 1.0 1.3"]
      , inDirection (0, 1) ["1.1 1.2", "0.1 0.2 1.0 1.3", "0.0 0.3"]
      , atLine "0.1 0.2 1.0 1.3" (replicate 4 AlongSide) ("sky", "sky")
      ]
  , -- Five pairs, three of them walls: eight faces and the sky's.
    Case "aligned-walls" "thin walls on one line are on one vertex, and edge-on they hide nothing" $
      [ pairs "0.0-0.1 0.1-1.0 1.0-1.1 1.1-2.0 2.0-2.1"
      , lines' ["0.0 0.1 1.0 1.1 2.0 2.1"]
      , bitangents "0.1-1.0 1.1-2.0"
      , sizes 1 6 0 9
      , seeOnlySky ["0.0", "0.1", "1.0", "1.1", "2.0", "2.1"]
      ]
  , -- A tip from below, both faces of the wall, a tip from above.
    Case "wall-in-line" "a line runs along both faces of a thin wall at once, and on to the corners beyond" $
      [ sees "0.0-1.0 1.0-1.1 1.1-2.0"
      , hides "0.0-1.1 0.0-2.0 1.0-2.0"
      , lines' ["0.0 1.0 1.1 2.0"]
      , atLine "0.0 1.0 1.1 2.0" [TangentAt Below, AlongSide, AlongSide, TangentAt Above] ("sky", "sky")
      ]
  , -- At 1.0 = (2, 0) the solid is on both flanks of the line y = 0.
    Case "behind-ends" "a line ends at a corner that it is not tangent at, whatever lies behind" $
      [ sees "0.0-1.0"
      , hides "0.0-2.0 1.0-2.0"
      , lines' []
      , atLine "0.0 1.0" [TangentAt Above, EndingAt Front] ("sky", "1.0")
      ]
  , -- At 1.0 = (2, 0) the solid is below the line y = 0.
    Case "behind-goes-on" "a line goes on at a corner that it is tangent at, to the corner exactly behind" $
      [ sees "0.0-1.0 1.0-2.0"
      , hides "0.0-2.0"
      , lines' ["0.0 1.0 2.0"]
      , atLine "0.0 1.0 2.0" [TangentAt Above, TangentAt Below, TangentAt Above] ("sky", "sky")
      ]
  , -- The line y = 0 runs along [1.5, 1.4] and meets the side [1.4, 1.3] head on.
    Case "side-then-solid" "a line along a side ends where the side ends at a reflex corner" $
      [ sees "0.0-1.5 1.4-1.5"
      , hides "0.0-1.4 1.4-2.0 1.5-2.0 0.0-2.0"
      , lines' ["0.0 1.5 1.4"]
      , atLine "0.0 1.5 1.4" [TangentAt Above, AlongSide, AlongSide] ("sky", "1.4")
      ]
  , -- The wall in the middle crosses the line y = 0, on which the others lie.
    Case "separated" "one line with solid between is several vertices" $
      [ allPairsBut "0.0-2.0 0.0-2.1 0.1-2.0 0.1-2.1"
      , lines' []
      , inDirection (1, 0) ["0.0 0.1", "2.0 2.1"]
      , sizes 11 22 0 15
      ]
  , -- The wall in the middle stops 10⁻³⁰ below the line of 0.0 and 2.0, so that they see each other. Below, all three
    -- walls end on the line y = −1.
    Case "nearly-collinear" "what is not exactly on the line is not on it" $
      [ allPairsBut "0.0-2.1 0.1-2.0 0.1-2.1"
      , lines' ["0.1 1.1 2.1"]
      , inDirection (1, 0) ["0.1 1.1 2.1", "0.0 2.0"]
      ]
  , -- The places of the contact: two corners of the file, and two cones of free space with a corner each. The places
    -- (1, 0) and (1, 1), and (1, 1) and (1, 2), are pairs in different cones.
    Case "corner-on-corner" "no light passes between two polygons that touch in a corner" $
      [ pairs "0.0-0.1 0.0-0.3 1.1-1.2 1.2-1.3 0.1-0.2,1.0 0.3-1.0 0.2-0.3 0.2,1.0-1.1 0.2,1.0-1.3 0.1-1.1 0.3-1.3"
      , cones "0.2" ["0.2", "0.2"]
      , cones "1.0" ["0.2", "0.2"]
      , lines' []
      , inDirection (0, 1) ["1.1 1.2", "0.1 0.2", "0.2 1.3", "0.0 0.3"]
      , bitangents "0.1-1.1 0.3-1.3"
      , sizes 10 18 2 11
      , factor "0.1" "1.0" rightAngle
      , factor "0.1" "1.3" []
      , free []
      ]
  , -- A tip from below and one from above, two units apart.
    Case "tips-apart" "two corners that touch a line from both sides at two places let it pass" $
      [ sees "0.0-1.0 0.0-2.0 1.0-3.0"
      , hides "2.0-3.0 0.0-3.0 1.0-2.0"
      , lines' ["2.0 0.0 1.0 3.0"]
      , atLine "2.0 0.0 1.0 3.0" [TangentAt Above, TangentAt Below, TangentAt Above, TangentAt Above] ("sky", "sky")
      ]
  , -- The same two tips in one place. Each wall's end sees the place, in a cone of its own.
    Case "tips-touch" "two corners that touch a line from both sides at one place block it" $
      [ sees "0.0,1.0-2.0 0.0,1.0-3.0"
      , hides "0.0-1.0 2.0-3.0 2.0-3.1 2.1-3.0"
      , lines' []
      , inDirection (1, 0) ["2.0 0.0", "0.0 3.0", "2.1 1.2"]
      , cones "1.0" ["0.0", "0.0"]
      ]
  , -- Above the contact there is more than half a plane of free space, so the line y = 0 passes through this cone. The
    -- cone below is narrow.
    Case "grazing-a-contact" "a line that has all solid of a contact on one side grazes it" $
      [ sees "0.0,1.0-2.0 0.0,1.0-3.0"
      , hides "2.0-3.0 0.0-1.0"
      , lines' ["2.0 0.0 3.0"]
      , atLine "2.0 0.0 3.0" [TangentAt Above, TangentAt Below, TangentAt Above] ("sky", "sky")
      , cones "1.0" ["0.0", "0.0"]
      ]
  , -- The tip cuts the top, two units to either side of it. With each half, 2 + √5 − √5 for the side of the triangle.
    Case "corner-on-side" "a corner on a side cuts it: two pieces, one name, the whole length" $
      [ pairs "0.0-0.1 0.1-0.2 0.0-1.0 0.2-1.0 1.0-1.1 1.1-1.2 1.0-1.2 0.2-1.1 0.0-1.2"
      , lines' []
      , free [("0.2", 1, 2)]
      , cones "1.0" ["1.0", "1.0"]
      , factor "0.2" "1.0" [(1 / 4, 1)]
      , factor "0.2" "1.2" [(1 / 4, 1)]
      , factor "0.2" "sky" [(1 / 2, 1)]
      , factor "1.0" "0.2" [(1 / 5, 5)]
      ]
  , -- What is left is a rectangle with a flat corner in its bottom and in its top.
    Case "side-on-side" "sides that cover each other are no boundary, and see nothing" $
      [ pairs "0.0-0.1,1.0 0.1,1.0-1.1 1.1-1.2 1.2-1.3 0.2-1.2 0.2-0.3 0.3-1.3 0.0-0.3"
      , lines' ["0.0 0.1 1.1", "0.3 0.2 1.2"]
      , free [("0.1", 0, 0), ("1.3", 0, 0)]
      , cones "1.3" ["0.2"]
      , sizes 4 10 0 7
      , factor "0.1" "1.3" []
      , seeOnlySky ["0.0", "0.2", "0.3", "1.0", "1.1", "1.2"]
      ]
  , -- The lower half of 1.3 is covered, all of 0.1 is. The free half and the top 0.2 are at a right angle, a unit each:
    -- the measure is 2 − √2, of 2·1 for the one and 2·2 for the other.
    Case "side-flush" "a side that is covered in part keeps its name and its length: it closes to the free part" $
      [ pairs "0.0-0.1,1.0 0.1,1.0-1.1 1.1-1.2 1.2-1.3 0.2-1.3 0.2-0.3 0.0-0.3 0.3-1.3"
      , lines' ["0.0 0.1 1.1"]
      , free [("0.1", 0, 0), ("1.3", 1 / 2, 1)]
      , factor "0.2" "1.3" rightAngle
      , factor "1.3" "0.2" (times (1 / 2) rightAngle)
      , factor "1.3" "sky" [(1 / 4, 2)]
      ]
  , -- A third of 0.2 is covered; a third is left on either side.
    Case "side-on-side-middle" "a side may be covered in the middle: its two ends do not see each other along it" $
      [ pairs "0.0-0.1 0.1-0.2 0.0-0.3 0.2-1.1 0.3-1.0 1.0-1.3 1.1-1.2 1.2-1.3 0.2-1.2 0.3-1.3"
      , free [("0.2", 2 / 3, 2), ("1.0", 0, 0)]
      , factor "0.2" "1.1" (times (1 / 3) rightAngle)
      , factor "0.2" "1.3" (times (1 / 3) rightAngle)
      , factor "1.3" "0.2" rightAngle
      ]
  , -- Half of the one top is covered by half of the other bottom.
    Case "side-overhang" "each of two sides may stand out: both are covered in part" $
      [ pairs "0.0-0.1 0.1-0.2 0.0-0.3 0.3-1.0 1.0-1.3 1.2-1.3 1.1-1.2 0.2-1.1 0.3-1.3 0.1-1.1"
      , lines' []
      , free [("0.2", 1 / 2, 1), ("1.0", 1 / 2, 1)]
      , factor "0.2" "1.3" (times (1 / 2) rightAngle)
      , factor "0.2" "sky" [(1 / 4, 2)]
      , factor "1.0" "0.1" (times (1 / 2) rightAngle)
      ]
  , -- The square fills the corner of the notch: nothing is left of two of its sides, and half of each side of the
    -- notch. The line x + y = 4 grazes it.
    Case "in-the-notch" "a reflex corner may be filled: there is no free space at it" $
      [ pairs "0.0-0.1 0.1-0.2 0.2-1.1 1.1-1.2 1.2-1.3 0.4-1.3 0.4-0.5 0.0-0.5 0.2-1.2 0.4-1.2"
      , lines' ["0.4 1.2 0.2"]
      , cones "0.3" []
      , cones "1.0" []
      , free [("0.2", 1 / 2, 1), ("0.3", 1 / 2, 1), ("1.0", 0, 0), ("1.3", 0, 0)]
      ]
  , -- The pocket is a triangle with sides √2, √2, 2: measures 2, 2 and 2√2 − 2. 1.0 is all in it, of 0.2 and 0.3 half.
    Case "several-contacts" "two contacts of the same polygons close off a pocket, which is free space of its own" $
      [ pairs "0.0-0.1 0.1-0.2 0.0-0.4 0.2-1.1 0.4-1.0 0.3-1.0 0.3-1.1 1.0-1.1 1.1-1.2 1.0-1.2 0.2-1.2 0.4-1.2"
      , lines' []
      , free [("0.2", 1, 2), ("0.3", 1, 2)]
      , sizes 12 19 5 13
      , factor "1.0" "0.2" [(1 / 2, 1)]
      , factor "1.0" "0.3" [(1 / 2, 1)]
      , factor "1.0" "sky" []
      , factor "0.2" "1.0" [(1 / 4, 2)]
      , factor "0.2" "0.3" [(1 / 2, 1), (-1 / 4, 2)]
      ]
  , -- The pocket is a triangle with sides 2, √5, √5. Outside, only the two tops are on one line; the other two contacts
    -- have less than half a plane of free space.
    Case "ring-of-three" "a ring of polygons that touch closes off a pocket" $
      [ pairs
          "0.0-0.2,1.0 0.2,1.0-2.2 0.2,1.0-1.2,2.0 0.0-1.2,2.0 1.2,2.0-2.2 \
          \0.0-0.1 0.1-2.2 0.1-0.2,1.0 0.2,1.0-1.1 1.1-1.2,2.0 1.2-2.1 2.0-2.1 0.0-2.1 2.1-2.2"
      , lines' ["2.1 1.2 1.1"]
      , cones "2.0" ["1.2", "1.2"]
      , factor "0.2" "1.2" [(1 / 2, 1)]
      , factor "0.2" "2.2" [(1 / 2, 1)]
      , factor "1.2" "2.2" [(1, 1), (-1 / 5, 5)]
      , factor "1.2" "sky" []
      ]
  , -- Three gaps, three cones. The line through 1.2 and 0.1 meets the place, but leads from one cone into another.
    Case "fan" "many corners at one place: a cone for each gap, each corner of the file seen from all of them" $
      [ pairs
          "0.0-0.1,0.2,1.1,1.2,2.1,2.2 0.1,0.2-1.0,2.0 1.0-1.1,1.2,2.1,2.2 1.1,1.2-2.0 2.0-2.1,2.2 \
          \0.1-0.2 1.1-1.2 2.1-2.2 0.2-1.1 1.2-2.1 0.1-2.2"
      , cones "0.0" ["0.0", "0.0", "1.0"]
      , lines' []
      , hides "0.0-1.0 0.0-2.0 1.0-2.0 0.1-1.2"
      ]
  , -- The three triangles make one, whose corners are two corners of the file each.
    Case "filled-fan" "many corners at one place without gaps: none of them sees, and none is seen" $
      [ pairs "0.1-0.2,1.1 0.2,1.1-2.2 0.2-1.2,2.1 1.1-1.2,2.1 0.1-1.2,2.1 1.2,2.1-2.2"
      , lines' []
      , cones "0.0" []
      , free [(s, 0, 0) | s <- ["0.0", "0.2", "1.0", "1.2", "2.0", "2.2"]]
      , sizes 3 6 0 4
      ]
  , -- The diagonals of the room pass the upper corners of the square. Its bottom covers a third of the room's. The part
    -- to its right and its right side are a unit each.
    Case "at-the-wall" "a polygon covers what it touches of the room's wall" $
      [ pairs
          "0.0-E.0 0.1-E.1 E.0-E.3 E.1-E.2 E.2-E.3 0.0-0.3 0.1-0.2 0.2-0.3 \
          \0.0-E.3 0.1-E.2 0.3-E.0,E.2,E.3 0.2-E.1,E.2,E.3"
      , lines' ["E.3 0.2 E.1", "E.0 0.3 E.2"]
      , free [("0.0", 0, 0), ("E.0", 2 / 3, 2)]
      , sizes 14 24 6 16
      , factor "0.1" "E.0" rightAngle
      , factor "E.0" "0.1" (times (1 / 3) rightAngle)
      ]
  , -- Half of two of the room's walls is covered, and its corner with the square's.
    Case "in-the-corner" "a polygon may fill a corner of the room" $
      [ pairs "0.1-E.1 E.1-E.2 E.2-E.3 0.3-E.3 0.1-0.2 0.2-0.3 0.1-E.2 0.3-E.2 0.2-E.1,E.2,E.3"
      , lines' ["E.3 0.2 E.1"]
      , cones "E.0" []
      , cones "0.0" []
      , free [("0.0", 0, 0), ("0.3", 0, 0), ("E.0", 1 / 2, 1), ("E.3", 1 / 2, 1)]
      ]
  , -- Nothing is free, so there is nothing.
    Case "filled-room" "a room that is all filled has an empty complex" $
      [ pairs ""
      , sizes 0 0 0 0
      , free [(s, 0, 0) | s <- ["0.0", "0.1", "0.2", "1.0", "1.1", "1.2", "E.0", "E.1", "E.2", "E.3"]]
      ]
  , -- Two rooms of 1 by 2, in which all four corners see each other. From the wall to the far side of its room: crossed
    -- strings √5 each, uncrossed ones 1 each. The bottom is a unit in each room: 1 + 2 − √5 with the far side.
    Case "divided-room" "a wall from side to side makes two rooms of one" $
      [ pairs "0.0,0.1-E.0,E.1,E.2,E.3 0.0-0.1 E.0-E.3 E.1-E.2"
      , free [("E.0", 1, 2), ("E.2", 1, 2)]
      , cones "0.0" ["0.0", "0.0"]
      , inDirection (0, 1) ["E.1 E.2", "0.0 0.1", "0.0 0.1", "E.0 E.3"]
      , factor "0.0" "E.1" [(1 / 2, 5), (-1 / 2, 1)]
      , factor "E.0" "E.1" [(3 / 4, 1), (-1 / 4, 5)]
      , factor "0.0" "E.3" []
      ]
  , -- The cone between the walls and the one around them. The line y = 0 runs along both faces of the wall 0: along the
    -- upper one it ends at the wall 1, along the lower one it goes on to 2.0. Between the walls: 3 + 4 − 5.
    Case "walls-L" "walls that share an end have a cone of free space on either side" $
      [ pairs "0.0-0.1 0.1-1.0 0.0-1.1 1.0-1.1 0.1-1.1 2.0-2.1 0.0-2.0,2.1 1.0-2.0,2.1 1.1-2.0,2.1"
      , cones "1.0" ["0.0", "0.0"]
      , lines' ["2.0 0.0 0.0 0.1"]
      , factor "0.1" "1.0" [(1 / 3, 1)]
      , factor "1.0" "0.1" [(1 / 4, 1)]
      , factor "0.0" "1.0" []
      , free []
      ]
  , -- The line runs along the upper faces and along the lower ones, with a corner in the middle of each. Four pairs,
    -- one for each face, four faces and the sky's; the file's corners in the middle are two.
    Case "walls-end-to-end" "along two walls on one line that share an end, one vertex has a track for each face" $
      [ pairs "0.0-0.1,1.0 0.1,1.0-1.1"
      , lines' ["0.0 0.1 0.1 1.1"]
      , cones "1.0" ["0.1", "0.1"]
      , bitangents ""
      , sizes 1 4 0 5
      , seeOnlySky ["0.0", "0.1", "1.0", "1.1"]
      ]
  , -- Three cones, each less than half a plane, so that no line passes. Between the walls 0 and 1: 2 + √5 − √13.
    Case "walls-Y" "three walls that share an end have three cones of free space" $
      [ pairs "0.0-0.1,1.1,2.1 0.1-1.0,1.1,2.0,2.1 1.0-1.1,2.1 1.1-2.0,2.1 2.0-2.1"
      , lines' []
      , cones "0.0" ["0.0", "0.0", "1.0"]
      , factor "0.1" "1.0" [(1 / 2, 1), (1 / 4, 5), (-1 / 4, 13)]
      , factor "0.0" "1.0" []
      ]
  , -- The corner of the wall 1 is on both faces of the wall 0, and cuts both. One line runs along both. Above, on
    -- either side: 2 + 2 − 2√2 of 2·4.
    Case "walls-T" "a wall that ends on another cuts both of its faces" $
      [ pairs "0.0-1.0 0.1-1.0 1.0-1.1 0.0-1.1 0.1-1.1"
      , lines' ["0.0 1.0 1.0 1.0 0.1"]
      , cones "1.0" ["1.0", "1.0", "1.0"]
      , free [("0.0", 1, 2), ("0.1", 1, 2)]
      , factor "0.1" "1.0" [(1 / 2, 1), (-1 / 4, 2)]
      , factor "0.0" "sky" [(1, 1)]
      ]
  , -- Four quadrants. A line along a face of the wall 0 ends in the middle, from the left and from the right.
    Case "walls-cross" "walls may meet in a cross where they end" $
      [ pairs "0.0-1.0,2.0 0.1-1.0,2.0 1.0-1.1 1.1-2.0 1.0-2.1 2.0-2.1 0.0-1.1,2.1 0.1-1.1,2.1"
      , lines' []
      , cones "1.0" ["1.0", "1.0", "2.0", "2.0"]
      , inDirection (1, 0) ["0.0 1.0 2.0", "1.0 2.0 0.1"]
      , factor "0.1" "1.0" [(1 / 2, 1), (-1 / 4, 2)]
      , factor "1.0" "2.1" []
      ]
  , -- As with two walls end to end, but the corner in the middle is one corner of the file.
    Case "wall-straight" "a corner between the ends of a straight wall is on both faces, its pairs are listed once" $
      [ pairs "0.0-0.1 0.1-0.2"
      , lines' ["0.0 0.1 0.1 0.2"]
      , cones "0.1" ["0.1", "0.1"]
      , sizes 1 4 0 5
      , seeOnlySky ["0.0", "0.1", "0.2", "0.3"]
      ]
  , -- Sides 0 and 1 go along the inner face, 2 and 3 back along the outer one. Inside: 3 + 4 − 5.
    Case "wall-bent" "a corner between the ends of a bent wall is in two cones, and its sides go out and back" $
      [ pairs "0.0-0.1 0.1-0.2 0.0-0.2"
      , lines' []
      , cones "0.1" ["0.1", "0.1"]
      , sizes 3 7 1 6
      , factor "0.0" "0.1" [(1 / 3, 1)]
      , factor "0.1" "0.0" [(1 / 4, 1)]
      , seeOnlySky ["0.2", "0.3"]
      ]
  , -- Sides 0, 1 and 2 are outside, 5, 4 and 3 are their other faces inside. The triangle has sides 4, 5, 3: measures 4
    -- + 3 − 5 = 2, 4 + 5 − 3 = 6 and 3 + 5 − 4 = 4.
    Case "wall-loop" "a closed wall has free space inside and outside" $
      [ pairs "0.0-0.1 0.1-0.3 0.1-0.2 0.0-0.2 0.2-0.3"
      , lines' []
      , cones "0.3" ["0.0", "0.0"]
      , sizes 6 9 3 7
      , seeOnlySky ["0.0", "0.1", "0.2"]
      , factor "0.5" "0.3" [(1 / 4, 1)]
      , factor "0.5" "0.4" [(3 / 4, 1)]
      , factor "0.3" "0.5" [(1 / 3, 1)]
      , factor "0.3" "0.4" [(2 / 3, 1)]
      , factor "0.4" "0.5" [(3 / 5, 1)]
      , factor "0.4" "0.3" [(2 / 5, 1)]
      ]
  , -- The wall ends between 0.0 and 0.1. The line y = 0 runs along both faces from the free end 0.0; the face in the
    -- pocket hangs together with neither, and is a vertex of its own. The pocket has sides 4 (of 6), 5, 3: measures 2,
    -- 6 and 4. The rest of face 5 and face 2: 2 + 3 − √13.
    Case "wall-on-itself" "a wall may end on itself and close off a pocket" $
      [ pairs "0.0-0.3 0.1-0.3 0.1-0.2 0.2-0.3 0.0-0.2"
      , lines' ["0.0 0.3 0.3 0.1"]
      , inDirection (1, 0) ["0.0 0.3 0.3 0.1", "0.3 0.1"]
      , cones "0.3" ["0.3", "0.3", "0.3"]
      , factor "0.5" "0.3" [(1 / 6, 1)]
      , factor "0.5" "0.4" [(1 / 2, 1)]
      , factor "0.4" "0.5" [(3 / 5, 1)]
      , factor "0.3" "0.4" [(2 / 3, 1)]
      , factor "0.5" "0.2" [(5 / 12, 1), (-1 / 12, 13)]
      ]
  , -- To the right of the wall 3 + 3 − 3√2, to its left 1 + 3 − √10.
    Case "wall-on-polygon" "a wall that ends on a side cuts it" $
      [ pairs "0.0-1.0 0.1-1.0 1.0-1.1 0.0-1.1 0.1-1.1 0.1-0.2 0.2-0.3 0.0-0.3"
      , free [("0.0", 1, 2)]
      , factor "0.0" "1.0" [(3 / 4, 1), (-3 / 8, 2)]
      , factor "0.0" "1.1" [(1 / 2, 1), (-1 / 8, 10)]
      ]
  , -- The line along the wall, on both of its faces, ends at the polygon.
    Case "wall-on-corner" "a line along a wall ends where the wall ends on a corner" $
      [ pairs "0.0-0.1 0.0-0.2 0.1-0.2 0.1-1.0,1.1 0.2-1.0,1.1 0.0-1.0 1.0-1.1"
      , lines' []
      , inDirection (1, 0) ["1.0 0.0 0.0"]
      , cones "1.1" ["0.0", "0.0"]
      ]
  , -- Half of the top is covered by the wall 1, whose lower face the top covers; half of the bottom by the wall 2,
    -- whose upper face the bottom covers. Four lines, those of the top and of the bottom with four corners each.
    Case "wall-along-side" "a wall along a side covers it, on either flank: what is seen there is the wall" $
      [ pairs "0.0-1.0 1.0-1.1 0.1-1.1 0.1-0.2 0.0-0.3 0.3-2.0 2.0-2.1 0.2-2.1"
      , lines' ["0.3 2.0 2.1 0.2", "0.0 1.0 1.1 0.1"]
      , free [("0.0", 1 / 2, 2), ("0.2", 1 / 2, 2), ("1.0", 0, 0), ("2.1", 0, 0)]
      , sizes 4 12 0 9
      , seeOnlySky ["0.1", "0.3", "1.1", "2.0"]
      , factor "0.0" "sky" [(1 / 2, 1)]
      , factor "0.2" "sky" [(1 / 2, 1)]
      ]
  , -- The lower half of the wall is between the squares. Above, the wall and either top are at a right angle.
    Case "wall-between" "a wall between two polygons sees nothing where they cover it" $
      [ pairs
          "0.0-0.1,1.0,2.0 0.1-1.1 1.0-1.1 1.1-2.0 1.1-1.2 0.0-0.3 \
          \0.2-0.3 0.3-1.3 0.2-1.2 1.2-1.3 0.2-2.1 1.3-2.1 0.3-2.1 1.2-2.1"
      , lines' ["0.0 0.1 1.1"]
      , cones "0.1" ["0.1"]
      , cones "1.3" ["0.2", "1.3"]
      , free [("0.1", 0, 0), ("1.3", 0, 0), ("2.0", 1 / 2, 1), ("2.1", 1 / 2, 1)]
      , factor "0.2" "2.1" rightAngle
      , factor "2.1" "0.2" (times (1 / 2) rightAngle)
      , factor "2.1" "sky" [(1 / 4, 2)]
      , factor "1.2" "2.0" rightAngle
      ]
  ]

refusals :: [Refusal]
refusals =
  [ Refusal "crossing-walls" "thin walls may not cross" [CrossingSides (side 0 0) (side 1 0)]
  , Refusal "walls-along" "thin walls may not lie along each other" [OverlappingWalls (Obstacle 0) (Obstacle 1)]
  , Refusal "wall-doubled" "a thin wall may not run back along itself" [Spike (corner 0 1) (Point 4 0)]
  , Refusal "ring-on-itself" "a polygon may not touch its own side" [CornerOnSide (corner 0 3) (side 0 0) (Point 2 0)]
  , Refusal "ring-through-a-place-twice" "a polygon may not pass a place twice" $
      [RepeatedCorner (corner 0 5) 2 (Point 1 1)]
  , Refusal "spike" "a polygon may not turn back along its own side" [Spike (corner 0 1) (Point 3 0)]
  , Refusal "no-area" "a polygon may not lie on one line" [ZeroArea (Obstacle 0)]
  , Refusal "crossing-sides" "sides may not cross" $
      [CrossingSides (side 0 1) (side 1 0), CrossingSides (side 0 2) (side 1 3)]
  , Refusal "overlap" "polygons may not overlap where they touch" [OverlappingPolygons (Obstacle 0) (Obstacle 1)]
  , Refusal "twins" "a polygon may not be stated twice" [OverlappingPolygons (Obstacle 0) (Obstacle 1)]
  , Refusal "nested" "a polygon may not lie inside another" [NestedPolygon (Obstacle 1) (Obstacle 0)]
  , Refusal "wall-into-solid" "a thin wall may not lead into a polygon" [OverlappingPolygons (Obstacle 0) (Obstacle 1)]
  , Refusal "out-of-the-room" "a polygon may not touch the room from outside" $
      [OverlappingPolygons (Obstacle 0) Enclosure]
  ]
  where
    side p = SideName (Obstacle p)
    corner p = CornerName (Obstacle p)
