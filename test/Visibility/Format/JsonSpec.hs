{-# LANGUAGE OverloadedStrings #-}

module Visibility.Format.JsonSpec (spec) where

import qualified Data.Aeson as Aeson
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Chars
import qualified Data.ByteString.Lazy as Lazy
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.Map.Strict as Map
import Data.Ratio ((%))
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Visibility.Error
import Visibility.Exact.Point (Point (..))
import Visibility.Format.Json
import Visibility.Format.Sample
import Visibility.Scene.Raw

spec :: Spec
spec = do
  describe "readScene" $ do
    it "reads the scene of the contract" $
      readScene "a" contract
        `shouldBe` Right
          RawScene
            { rawName = Just "two rooms"
            , rawEnclosure =
                Just (rawPolygon (points [(0, 0), (10, 0), (10, 8), (0, 8)])) {rawMaterial = Material 0 (7 % 10)}
            , rawPolygons =
                [ RawPolygon
                    (Just "lamp")
                    Ring
                    (points [(1 % 3, 2), (1, 2), (1, 5 % 2)])
                    (Material 1 (1 % 2))
                    (Map.fromList [(2, MaterialOverride (Just 0) Nothing)])
                , rawPolygon (points [(4, 4), (6, 4), (5, 6)])
                ]
            }
    it "reads numbers as the decimals they spell" $
      readScene "a" "{\"polygons\": [[[0.1, 1e-3], [-1.50E+2, \"7/2\"]]]}"
        `shouldBe` Right (RawScene Nothing Nothing [rawPolygon (points [(1 % 10, 1 % 1000), (-150, 7 % 2)])])
    it "reads walls; two corners make one under either key" $
      readScene
        "a"
        "{\"polygons\": [{\"wall\": [[0,0],[1,0],[1,1]], \"sides\": {\"3\": {\"emission\": 1}}},\
        \ {\"wall\": [[2,0],[2,1]]}, {\"corners\": [[3,0],[3,1]]}, [[4,0],[4,1]], {\"wall\": [[5,0]]}]}"
        `shouldBe` Right
          ( RawScene
              Nothing
              Nothing
              [ (wallOf [(0, 0), (1, 0), (1, 1)]) {rawSides = Map.fromList [(3, MaterialOverride (Just 1) Nothing)]}
              , wallOf [(2, 0), (2, 1)]
              , wallOf [(3, 0), (3, 1)]
              , wallOf [(4, 0), (4, 1)]
              , wallOf [(5, 0)]
              ]
          )
    it "reports every fault of shape, in order" $
      readScene "a" "{\"polygons\": [[[0, null], [1]], 7], \"x\": 0}"
        `shouldBe` Left
          ( fmap
              (UnparseableFile "a" . uncurry ShapeError)
              ( (Root, UnknownKey "x" ["format", "name", "enclosure", "polygons"])
                  :| [ (Item (Item (Item polygons 0) 0) 1, WrongKind "null" aNumber)
                     , ( Item (Item polygons 0) 1
                       , WrongKind "a list of 1 element" (Wanted "a list of two numbers [x, y]")
                       )
                     , ( Item polygons 1
                       , WrongKind "7" $
                           Wanted "an object with the key \"corners\" or \"wall\", or just the list of corners"
                       )
                     ]
              )
          )
    it "leaves to validation what has the shape of a scene" $
      readScene "a" "{\"polygons\": [{\"corners\": [], \"emission\": -1, \"sides\": {\"-7\": {}}}]}"
        `shouldBe` Right
          ( RawScene
              Nothing
              Nothing
              [RawPolygon Nothing Ring [] (Material (-1) 0) (Map.fromList [(-7, MaterialOverride Nothing Nothing)])]
          )
  describe "sceneDocument" $ do
    prop "readScene file (bytes (sceneDocument raw)) == Right raw" $
      forAll rawScenes $ \raw ->
        let bytes = written raw in counterexample (Chars.unpack bytes) (readScene "a" bytes === Right raw)
    prop "is JSON to aeson" $
      forAll rawScenes $ \raw ->
        either (`counterexample` False) (const (property True)) (asValue (written raw))
    it "writes a polygon to a line, and no defaults" $
      fmap written (readScene "a" contract)
        `shouldBe` Right
          "{ \"format\": \"viscomplex/1\",\n\
          \  \"name\": \"two rooms\",\n\
          \  \"enclosure\": {\"corners\": [[0,0],[10,0],[10,8],[0,8]], \"reflectivity\": 0.7},\n\
          \  \"polygons\": [\n\
          \    {\"name\": \"lamp\", \"corners\": [[\"1/3\",2],[1,2],[1,2.5]], \"emission\": 1, \"reflectivity\": 0.5, \
          \\"sides\": {\"2\": {\"emission\": 0}}},\n\
          \    [[4,4],[6,4],[5,6]]\n\
          \  ] }\n"
    it "writes walls under their own key, but for those of two corners" $
      written (RawScene Nothing Nothing (map wallOf [[], [(0, 0)], [(0, 0), (1, 0)], [(0, 0), (1, 0), (1, 1)]]))
        `shouldBe` "{ \"format\": \"viscomplex/1\",\n\
                   \  \"polygons\": [\n\
                   \    {\"wall\": []},\n\
                   \    {\"wall\": [[0,0]]},\n\
                   \    [[0,0],[1,0]],\n\
                   \    {\"wall\": [[0,0],[1,0],[1,1]]}\n\
                   \  ] }\n"
  where
    asValue = Aeson.eitherDecodeStrict :: Bytes.ByteString -> Either String Aeson.Value
    polygons = Key Root "polygons"
    wallOf corners = RawPolygon Nothing Polyline (points corners) black Map.empty

written :: RawScene -> Bytes.ByteString
written = Lazy.toStrict . Builder.toLazyByteString . sceneDocument

points :: [(Rational, Rational)] -> [Point]
points = map (uncurry Point)

contract :: Bytes.ByteString
contract =
  "{ \"format\": \"viscomplex/1\", \"name\": \"two rooms\",\n\
  \  \"enclosure\": {\"corners\": [[0,0],[10,0],[10,8],[0,8]], \"reflectivity\": \"0.7\"},\n\
  \  \"polygons\": [\n\
  \    {\"name\": \"lamp\", \"corners\": [[\"1/3\",\"2\"],[1,2],[1,\"2.5\"]], \"emission\": 1,\n\
  \     \"reflectivity\": \"1/2\",\n\
  \     \"sides\": {\"2\": {\"emission\": 0}}},\n\
  \    [[4,4],[6,4],[5,6]]\n\
  \  ] }\n"
