{-# LANGUAGE OverloadedStrings #-}

module Visibility.Format.FileSpec (spec) where

import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_)
import Data.List.NonEmpty (NonEmpty (..))
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Visibility.Error
import Visibility.Exact.Point (Point (..))
import Visibility.Format.File
import Visibility.Format.Json (sceneDocument)
import Visibility.Format.Sample
import Visibility.Scene (cornerCount)
import Visibility.Scene.Raw

spec :: Spec
spec = do
  describe "readSceneFile" $ do
    it "reads a valid scene" $ withFile' "a.json" triangle $ \path -> do
      outcome <- readSceneFile path
      fmap cornerCount outcome `shouldBe` Right 3
    it "reports an invalid scene under the file's name" $ withFile' "a.json" "{\"polygons\": []}" $ \path -> do
      outcome <- readSceneFile path
      fmap cornerCount outcome `shouldBe` Left (InvalidScene path EmptyScene :| [])
    it "reports a missing file" $ withSystemTempDirectory "scenes" $ \dir -> do
      outcome <- readSceneFile (dir </> "none.json")
      fmap cornerCount outcome `shouldBe` Left (UnreadableFile (dir </> "none.json") NoSuchFile :| [])
    it "reports a folder" $ withSystemTempDirectory "scenes" $ \dir -> do
      outcome <- readSceneFile dir
      case fmap cornerCount outcome of
        Left (UnreadableFile path (ReadFailed _) :| []) -> path `shouldBe` dir
        other -> expectationFailure (show other)
    it "reads a file in the format of its ending" $
      for_
        [ ("a.geojson", triangleGeoJson)
        , ("a.GeoJSON", triangleGeoJson)
        , ("a.wkt", triangleWkt)
        , ("a.WKT", triangleWkt)
        , ("geojson", triangle)
        , ("wkt.txt", triangle)
        ]
        $ \(name, bytes) -> withFile' name bytes $ \path -> do
          outcome <- readRawSceneFile path
          outcome `shouldBe` Right (RawScene Nothing Nothing [rawPolygon [Point 0 0, Point 1 0, Point 0 1]])
  describe "readSceneBytes" $
    prop "reads the same scene from all three formats" $
      forAll (bare <$> outlinedScenes) $ \raw ->
        forAll ((,) <$> geoJsonOf raw <*> wktOf raw) $ \(geoJson, wkt) ->
          conjoin
            [ readSceneBytes name bytes === Right raw
            | (name, bytes) <- [("a.json", json raw), ("a.geojson", geoJson), ("a.wkt", wkt)]
            ]
  where
    json = Lazy.toStrict . Builder.toLazyByteString . sceneDocument
    -- WKT has no more.
    bare (RawScene _ _ polygons) =
      RawScene Nothing Nothing [p {rawPolygonName = Nothing, rawMaterial = black} | p <- polygons]
    withFile' name bytes act = withSystemTempDirectory "scenes" $ \dir -> do
      Bytes.writeFile (dir </> name) bytes
      act (dir </> name)

triangle, triangleGeoJson, triangleWkt :: Bytes.ByteString
triangle = "{\"polygons\": [[[0,0],[1,0],[0,1]]]}"
triangleGeoJson = "{\"type\": \"Polygon\", \"coordinates\": [[[0,0],[1,0],[0,1],[0,0]]]}"
triangleWkt = "POLYGON ((0 0, 1 0, 0 1, 0 0))\n"
