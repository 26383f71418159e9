-- | What the specs of figures share: the scenes of the demonstration, scenes for golden drawings, and the comparison
-- with them.
module Visibility.Draw.Gallery
  ( withGallery
  , goldenScenes
  , extremeScenes
  , withValid
  , legible
  , isLegible
  , displaced
  , cornerSights
  , forAllViewpoints
  , shouldBeListedIn
  ) where

import qualified Data.ByteString as Bytes
import Data.Foldable (for_)
import Data.List (sort)
import Data.List.NonEmpty (NonEmpty)
import qualified Data.Map.Strict as Map
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import System.Directory (doesFileExist, listDirectory)
import System.FilePath (dropExtension, takeExtension, (</>))
import Test.Hspec
import Test.QuickCheck
import Visibility.Draw.Checks
import Visibility.Draw.Drawing
import Visibility.Exact.Point
import Visibility.Format.File (readSceneFile)
import Visibility.Exact.Predicate (reversed)
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Error.Scene (SceneError)
import Visibility.Scene.Validate (validate)
import Visibility.Sight
import Visibility.Sweep (vertices)
import Visibility.Test.Scan
import Visibility.View

-- | Examples for each scene in scenes/, by name.
withGallery :: (String -> Scene -> Spec) -> Spec
withGallery examples = do
  files <- runIO (sort . filter ((== ".json") . takeExtension) <$> listDirectory "scenes")
  it "there are at least twelve" $ length files `shouldSatisfy` (>= 12)
  for_ files $ \file -> do
    outcome <- runIO (readSceneFile ("scenes" </> file))
    case outcome of
      Left problems -> it file (expectationFailure (show problems))
      Right scene -> examples (dropExtension file) scene

-- | Small scenes that have everything between them: a light, a thin wall, a room, degenerate and vertical vertices.
goldenScenes :: [(String, RawScene)]
goldenScenes =
  [ ("two-squares", RawScene (Just (Text.pack "two squares")) Nothing [square 0 0 bright, square 2 0 black])
  ,
    ( "room-with-wall"
    , RawScene
        (Just (Text.pack "a <room> & a wall"))
        (Just (rawPolygon (points [(0, 0), (6, 0), (6, 4), (0, 4)])))
        [ rawPolygon (points [(2, 1), (3, 3 / 2), (5 / 3, 3)])
        , (rawPolygon (points [(4, 1), (5, 3)])) {rawSides = Map.fromList [(0, MaterialOverride (Just 1) Nothing)]}
        ]
    )
  ]
  where
    square x y material =
      (rawPolygon (points [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)])) {rawMaterial = material}
    bright = Material 1 0
    points = map (uncurry Point)

-- | Scenes with parts that differ by more than Doubles hold: things of size 1 and gaps of 1 where others are larger by
-- powers of ten; with the length of the first side, which is that of an axis. A chamfer, a solid and a free spike, a
-- pocket with a light in it, a wall and a light that are points.
extremeScenes :: [(String, String, RawScene)]
extremeScenes =
  concat
    [ [ ("obstacles of 1 and of 10^" <> show k, "1e" <> show k, RawScene Nothing Nothing (obstacles (10 ^ k)))
      , ("a room of 10^" <> show k, "1", RawScene Nothing (Just (room (10 ^ k))) (furniture (10 ^ k)))
      , ("a room of 10^-" <> show k, "1e−" <> show (2 * k), smaller (10 ^ (2 * k)) (room (10 ^ k)) (furniture (10 ^ k)))
      ]
    | k <- [72, 149, 350 :: Int]
    ]
  where
    obstacles s =
      [ solid [(0, 0), (s, 0), (s, s - 1), (s - 1, s), (0, s)]
      , bright (solid [(s + 1, 0), (2 * s, 0), (2 * s, s), (s + 1, s)])
      , bright (solid [(s / 2, 2 * s), (s / 2 + 1, 2 * s), (s / 2 + 1, 2 * s + 1), (s / 2, 2 * s + 1)])
      , solid [(0, 3 * s), (2 * s, 3 * s), (0, 3 * s + 1)]
      ]
    room s =
      lit 2 . solid $
        [(0, 0), (s / 2, 0), (s / 2, -1), (s / 2 + 1, -1), (s / 2 + 1, 0), (s, 0)]
          <> [(s, s / 2), (3 * s, s / 2), (s, s / 2 + 1), (s, s), (0, s)]
    furniture s = [rawWall [Point (s / 4) (s / 4), Point (s / 4 + 1) (s / 4)], lit 0 (solid (triangle s))]
    triangle s = [(s / 3, s / 2), (2 * s / 3, s / 2), (s / 2, 2 * s / 3)]
    smaller d enclosure others =
      RawScene Nothing (Just (shrunk d enclosure)) (map (shrunk d) others)
    shrunk d polygon = polygon {rawCorners = [Point (x / d) (y / d) | Point x y <- rawCorners polygon]}
    solid = rawPolygon . map (uncurry Point)
    bright polygon = polygon {rawMaterial = Material 1 (1 / 2)}
    lit k polygon = polygon {rawSides = Map.fromList [(k, MaterialOverride (Just 1) Nothing)]}

withValid :: RawScene -> (Scene -> Expectation) -> Expectation
withValid raw check = either (expectationFailure . show) check (validate raw)

-- | What holds of every figure, as examples about something: all of it can be read.
legible :: String -> Drawing -> Spec
legible about drawing = do
  it (about <> ": no label covers anything") $ labelCollisions drawing `shouldBe` []
  it (about <> ": nothing leaves the canvas") $ strayMarks drawing `shouldBe` []

-- | The same of any figure: no label covers anything, and nothing leaves the canvas.
isLegible :: Drawing -> Property
isLegible drawing = (labelCollisions drawing, strayMarks drawing) === ([], [])

-- | The scene moved by the same amount to the right and upwards.
displaced :: Rational -> RawScene -> Either (NonEmpty SceneError) Scene
displaced d raw =
  validate raw {rawEnclosure = moved <$> rawEnclosure raw, rawPolygons = map moved (rawPolygons raw)}
  where
    moved polygon = polygon {rawCorners = [Point (x + d) (y + d) | Point x y <- rawCorners polygon]}

-- | All corners, each with its sights all around: its views follow each other from −90° to 90° forward, then
-- backward.
cornerSights :: Scene -> [(CornerId, [Sight])]
cornerSights scene = Map.toList (Map.map allAround byCorner)
  where
    byCorner = Map.fromListWith (flip (<>)) [(edgeCorner e, [e]) | e <- stretches scene (events scene (vertices scene))]
    allAround found =
      [Sight (edgeFrom e) (edgeTo e) object | e <- found, Just object <- [frontOf (edgeView e)]]
        <> [ Sight (reversed (edgeFrom e)) (reversed (edgeTo e)) object
           | e <- found
           , Just object <- [backOf (edgeView e)]
           ]
    frontOf view = case view of
      Tangent _ _ front -> Just front
      Ending Back front -> Just front
      _ -> Nothing
    backOf view = case view of
      Tangent _ back _ -> Just back
      Ending Front back -> Just back
      _ -> Nothing

-- | A check of any corner or other point that is not in the solid, with its sights.
forAllViewpoints :: Testable check => Scene -> (Point -> [Sight] -> check) -> Property
forAllViewpoints scene check =
  forAll (oneof [elements (map snd (statedCorners scene)), somePoint scene]) $ \q ->
    case scan scene q of
      Right sights@(_ : _) -> property (check q sights)
      _ -> discard

-- | Compares a drawing with a file in test/golden/draw, which has to exist.
shouldBeListedIn :: Drawing -> FilePath -> Expectation
shouldBeListedIn drawing file = do
  exists <- doesFileExist path
  if exists
    then do
      expected <- Text.unpack . Text.decodeUtf8 <$> Bytes.readFile path
      lines (listing drawing) `shouldBe` lines expected
    else expectationFailure (path <> " is missing")
  where
    path = "test" </> "golden" </> "draw" </> file
