{-# LANGUAGE OverloadedStrings #-}

module Visibility.Format.GeoJsonSpec (spec) where

import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Chars
import Data.Foldable (for_)
import Data.List.NonEmpty (NonEmpty (..))
import Data.Ratio ((%))
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Visibility.Error
import Visibility.Exact.Point (Point (..))
import Visibility.Format.GeoJson
import Visibility.Format.Sample
import Visibility.Scene.Raw

-- What is wrong is in test/golden/errors.
spec :: Spec
spec = describe "readGeoJson" $ do
  it "reads a file as other programs write it" $
    readGeoJson "a" exported
      `shouldBe` Right
        RawScene
          { rawName = Just "ground floor"
          , rawEnclosure =
              Just (rawPolygon (points [(0, 0), (10, 0), (10, 8), (0, 8)])) {rawMaterial = Material 0 (7 % 10)}
          , rawPolygons =
              [ lamp (points [(1, 1), (2, 1), (2, 2)])
              , lamp (points [(3, 1), (4, 1), (4, 5 % 2)])
              , rawWall (points [(5, 5), (6, 5), (6, 6)])
              , rawWall (points [(7, 5), (8, 1 % 3)])
              ]
          }
  prop "reads what is written in any of the ways, to the same scene" $
    forAll outlinedScenes $ \raw ->
      forAll (geoJsonOf raw) $ \bytes -> counterexample (Chars.unpack bytes) (readGeoJson "a" bytes === Right raw)
  describe "reads geometry by itself" $
    for_
      [ ("Polygon", "[[[0,0],[1,0],[0,1],[0,0]]]", [triangle])
      , ("MultiPolygon", "[[[[0,0],[1,0],[0,1],[0,0]]], [[[0,0],[1,0],[0,1],[0,0]]]]", [triangle, triangle])
      , ("LineString", "[[0,0],[1,0]]", [rawWall (points [(0, 0), (1, 0)])])
      , ("MultiLineString", "[[[0,0],[1,0]], [[0,0],[1,0],[0,1]]]", map (rawWall . points) [[(0, 0), (1, 0)], corners])
      ]
      $ \(kind, coordinates, polygons) -> do
        let bare = "{\"type\": \"" <> kind <> "\", \"coordinates\": " <> coordinates <> "}"
            expected = Right (RawScene Nothing Nothing polygons)
        it (Chars.unpack kind) $ readGeoJson "a" bare `shouldBe` expected
        it (Chars.unpack kind <> " in a collection of a collection") $
          readGeoJson "a" (collection (collection bare)) `shouldBe` expected
        it (Chars.unpack kind <> " in a Feature") $
          readGeoJson "a" ("{\"type\": \"Feature\", \"geometry\": " <> bare <> "}") `shouldBe` expected
  it "passes over what has no coordinates" $
    for_ ["Polygon", "MultiPolygon", "LineString", "MultiLineString"] $ \kind ->
      readGeoJson "a" ("{\"type\": \"" <> kind <> "\", \"coordinates\": []}")
        `shouldBe` Right (RawScene Nothing Nothing [])
  it "keeps a line that closes as a wall, with its last corner" $
    readGeoJson "a" "{\"type\": \"LineString\", \"coordinates\": [[0,0],[1,0],[0,1],[0,0]]}"
      `shouldBe` Right (RawScene Nothing Nothing [rawWall (points (corners <> [(0, 0)]))])
  it "compares the ends of a ring as numbers, and without the altitude" $
    readGeoJson "a" "{\"type\": \"Polygon\", \"coordinates\": [[[0.5,0,1],[1,0],[0,1],[\"1/2\",0e3,2]]]}"
      `shouldBe` Right (RawScene Nothing Nothing [rawPolygon (points [(1 % 2, 0), (1, 0), (0, 1)])])
  it "takes a name of the collection only if it is a string" $
    for_ [("7", Nothing), ("null", Nothing), ("\"hall\"", Just "hall")] $ \(name, expected) ->
      fmap rawName (readGeoJson "a" ("{\"type\": \"FeatureCollection\", \"name\": " <> name <> ", \"features\": []}"))
        `shouldBe` Right expected
  it "reports every fault, in order" $
    readGeoJson "a" "{\"type\": \"MultiLineString\", \"coordinates\": [[[0]], 7, [[0,0]]]}"
      `shouldBe` Left
        ( fmap
            (UnparseableFile "a" . uncurry ShapeError)
            ( ( Item (Item (Key Root "coordinates") 0) 0
              , WrongKind
                  "a list of 1 element"
                  (Wanted "a list of two numbers [x, y], or more of which these two count")
              )
                :| [ (Item (Key Root "coordinates") 1, WrongKind "7" (Wanted "a list of positions [x, y]"))
                   , (Item (Key Root "coordinates") 2, BadOutline (ShortLine 1))
                   ]
            )
        )
  where
    collection inner = "{\"type\": \"GeometryCollection\", \"geometries\": [" <> inner <> "]}"
    triangle = rawPolygon (points corners)
    corners = [(0, 0), (1, 0), (0, 1)]
    lamp outline = (rawPolygon outline) {rawPolygonName = Just "lamp", rawMaterial = Material 1 (1 % 2)}
    points = map (uncurry Point)

exported :: Bytes.ByteString
exported =
  "{\n\
  \\"type\": \"FeatureCollection\",\n\
  \\"name\": \"ground floor\",\n\
  \\"crs\": { \"type\": \"name\", \"properties\": { \"name\": \"urn:ogc:def:crs:EPSG::25832\" } },\n\
  \\"features\": [\n\
  \{ \"type\": \"Feature\", \"properties\": { \"fid\": 1, \"name\": \"lamp\", \"emission\": 1.0, \
  \\"reflectivity\": \"1/2\", \"role\": null }, \"geometry\": { \"type\": \"MultiPolygon\", \
  \\"coordinates\": [ [ [ [ 1.0, 1.0 ], [ 2.0, 1.0 ], [ 2.0, 2.0 ], [ 1.0, 1.0 ] ] ], [ [ [ 3, 1 ], [ 4, 1 ], [ 4, 2.5 ], [ 3, 1 ] ] ] ] } },\n\
  \{ \"type\": \"Feature\", \"properties\": { \"fid\": 2, \"name\": null, \"emission\": null, \"reflectivity\": 0.7, \
  \\"role\": \"enclosure\" }, \"geometry\": { \"type\": \"Polygon\", \"coordinates\": [ [ [ 0.0, 0.0, 3.1 ], \
  \[ 10.0, 0.0, 3.1 ], [ 10.0, 8.0, 3.1 ], [ 0.0, 8.0, 3.1 ], [ 0.0, 0.0, 3.1 ] ] ] } },\n\
  \{ \"type\": \"Feature\", \"properties\": { \"fid\": 3, \"name\": null, \"emission\": null, \
  \\"reflectivity\": null, \"role\": null }, \"geometry\": { \"type\": \"MultiLineString\", \
  \\"coordinates\": [ [ [ 5, 5 ], [ 6, 5 ], [ 6, 6 ] ], [ [ 7.0, 5.0 ], [ 8.0, \"1/3\" ] ] ] } },\n\
  \{ \"type\": \"Feature\", \"properties\": { \"fid\": 4 }, \"geometry\": null }\n\
  \]\n\
  \}\n"
