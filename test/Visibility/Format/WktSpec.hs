{-# LANGUAGE OverloadedStrings #-}

module Visibility.Format.WktSpec (spec) where

import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Chars
import Data.Foldable (for_, toList)
import Data.List.NonEmpty (NonEmpty (..))
import Data.Ratio ((%))
import qualified Data.Text as Text
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Visibility.Error
import Visibility.Exact.Point (Point (..))
import Visibility.Format.Number
import Visibility.Format.Sample
import Visibility.Format.Wkt
import Visibility.Scene.Raw

-- What is wrong is in test/golden/errors.
spec :: Spec
spec = describe "readWkt" $ do
  let aGeometry = Expected "POLYGON, MULTIPOLYGON, LINESTRING or MULTILINESTRING belongs here"
  describe "reads each geometry" $
    for_
      [ ("POLYGON ((0 0, 1 0, 0 1, 0 0))", [triangle])
      , ("MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), ((0 0, 1 0, 0 1, 0 0)))", [triangle, triangle])
      , ("LINESTRING (0 0, 1 0)", [wall [(0, 0), (1, 0)]])
      , ("LINESTRING (0 0, 1 0, 0 1, 0 0)", [wall [(0, 0), (1, 0), (0, 1), (0, 0)]])
      , ("MULTILINESTRING ((0 0, 1 0), (0 0, 1 0, 0 1))", [wall [(0, 0), (1, 0)], wall [(0, 0), (1, 0), (0, 1)]])
      , ("polygon((0 0,1 0,0 1,0 0))", [triangle])
      , ("Polygon Z((0 0 1,1 0 2,0 1 3,0 0 4))", [triangle])
      , ("POLYGON zm ((0 0 1 1, 1 0 2 2, 0 1 3 3, 0 0 4 4))", [triangle])
      , ("POLYGON EMPTY", [])
      , ("MULTIPOLYGON (EMPTY, ((0 0, 1 0, 0 1, 0 0)))", [triangle])
      , ("MULTILINESTRING (EMPTY)", [])
      , ("  POLYGON\t( ( 0  0 , 1 0 , 0 1 , 0.0 0e7 ) ) \r", [triangle])
      , ("# LINESTRING (0 0, 1 0)\n\n \n #(\nLINESTRING (2 0, 3 0)\r\n", [wall [(2, 0), (3, 0)]])
      , ("", [])
      ]
      $ \(text, polygons) -> it (show text) $ readWkt "a" text `shouldBe` Right (RawScene Nothing Nothing polygons)
  describe "reads numbers exactly" $
    for_
      [ ("0.1", 1 % 10)
      , ("-1/3", -1 % 3)
      , ("+1/3", 1 % 3)
      , ("1e-3", 1 % 1000)
      , ("-2.5E+1", -25)
      , (".5", 1 % 2)
      , ("-.5", -1 % 2)
      , ("+7.", 7)
      , ("7.e1", 70)
      , ("007", 7)
      ]
      $ \(word, value) ->
        it (show word) $
          readWkt "a" ("LINESTRING (" <> word <> " 0, 1 0)")
            `shouldBe` Right (RawScene Nothing Nothing [rawWall [Point value 0, Point 1 0]])
  describe "refuses other numbers" $
    for_ [".", "-.", "+", "+-1", "-+1", "--1", "1..2", ".5/2", "1/.5", "1/-2", ".e1", "x", "NaN", "\"1\""] $ \word ->
      it (show word) $
        fmap rawName (readWkt "a" ("LINESTRING (" <> word <> " 0, 1 0)"))
          `shouldBe` Left
            (UnparseableFile "a" (SyntaxError (TextPosition 1 13) (BadWord (decoded word) NotANumber)) :| [])
  prop "reads what is written in any of the ways, to the same scene" $
    forAll outlinedScenes $ \raw ->
      forAll (wktOf raw) $ \bytes ->
        counterexample (Chars.unpack bytes) $
          readWkt "a" bytes === Right (RawScene Nothing Nothing (map bare (rawPolygons raw)))
  it "reports faults of every line; what goes on with a geometry that ended early is not its own fault" $
    faultsOf "POINT (1 2)\nPOLYGON ((0 0, 1 0,\n 0 1,\n\n 0 0))\nLINESTRING (0 0)\n((7\n"
      `shouldBe` [ (1, 1, UnexpectedWord (Just "POINT") aGeometry)
                 , (2, 20, UnexpectedWord Nothing (Expected "a number belongs here, two for each position"))
                 , (6, 12, BadGeometry (ShortLine 1))
                 , (7, 1, UnexpectedWord (Just "(") aGeometry)
                 ]
  it "counts characters, not bytes" $
    faultsOf "\195\169 (\nLINESTRING (0 0, \195\169\195\169 1, 1/0 1e401)"
      `shouldBe` [ (1, 1, UnexpectedWord (Just "\233") aGeometry)
                 , (2, 18, BadWord "\233\233" NotANumber)
                 , (2, 24, BadWord "1/0" ZeroDenominator)
                 , (2, 28, BadWord "1e401" ExponentTooLarge)
                 ]
  it "wants UTF-8" $
    readWkt "a" "# caf\233\n"
      `shouldBe` Left (UnparseableFile "a" (SyntaxError (TextPosition 1 6) InvalidUtf8) :| [])
  it "takes many lines and many positions" $ do
    let row = "LINESTRING (" <> Bytes.intercalate ", " (replicate 1000 "0 1") <> ")\n"
    fmap (map (length . rawCorners) . rawPolygons) (readWkt "a" (Bytes.concat (replicate 100 row)))
      `shouldBe` Right (replicate 100 1000)
  where
    triangle = rawPolygon [Point 0 0, Point 1 0, Point 0 1]
    wall = rawWall . map (uncurry Point)
    bare polygon = polygon {rawPolygonName = Nothing, rawMaterial = black}
    decoded = Text.pack . Chars.unpack
    faultsOf text = case readWkt "a" text of
      Right _ -> []
      Left problems ->
        [(line, column, why) | UnparseableFile _ (SyntaxError (TextPosition line column) why) <- toList problems]
