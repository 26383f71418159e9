{-# LANGUAGE OverloadedStrings #-}

-- | Random statements of scenes, most of them not valid, and writers of the formats that are only read.
module Visibility.Format.Sample
  ( rawScenes
  , outlinedScenes
  , geoJsonOf
  , wktOf
  ) where

import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (toLower)
import Data.List (intercalate)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, maybeToList)
import Data.Ratio ((%))
import qualified Data.Text as Text
import Test.QuickCheck
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.Rounding (rationalText)
import Visibility.Format.Number (decimalText, numberText)
import Visibility.Scene.Raw

-- | Scenes as our own JSON may state them. No file states a ring of two corners, or a wall as enclosure.
rawScenes :: Gen RawScene
rawScenes = RawScene <$> names <*> perhaps (polygon rawPolygon) <*> upTo 4 (oneof (map polygon [rawPolygon, rawWall]))
  where
    polygon made = do
      outline <- made <$> upTo 5 corners
      name <- names
      material <- Material <$> numbers <*> numbers
      overrides <- Map.fromList <$> upTo 3 ((,) <$> arbitrary <*> override)
      pure outline {rawPolygonName = name, rawMaterial = material, rawSides = overrides}
    override = MaterialOverride <$> perhaps numbers <*> perhaps numbers
    names = perhaps (Text.pack <$> listOf character)
    character = frequency [(5, arbitrary), (5, choose ('a', 'z')), (1, elements "\"\\/\0\n\119070")]

-- | Scenes as GeoJSON may state them too: no sides by themselves, three corners or more around an area, two or more
-- along a wall.
outlinedScenes :: Gen RawScene
outlinedScenes = RawScene <$> names <*> perhaps (polygon ring) <*> upTo 4 (oneof (map polygon [ring, wall]))
  where
    polygon outlines = do
      outline <- outlines
      name <- names
      material <- oneof [pure black, Material <$> numbers <*> numbers]
      pure outline {rawPolygonName = name, rawMaterial = material}
    ring = rawPolygon <$> (choose (3, 6) >>= \n -> vectorOf n corners)
    wall = rawWall <$> (choose (2, 6) >>= \n -> vectorOf n corners)
    names = perhaps (elements ["lamp", "", "two rooms", "caf\233"])

-- | One of the ways in which GeoJSON says it.
geoJsonOf :: RawScene -> Gen Bytes.ByteString
geoJsonOf (RawScene name room polygons) = do
  place <- choose (0, length polygons)
  features <- mapM standing (take place polygons)
  enclosure <- mapM (feature [("role", "\"enclosure\"")]) room
  others <- mapM standing (drop place polygons)
  nothing <- elements [[], ["{\"type\": \"Feature\", \"properties\": null, \"geometry\": null}"]]
  fmap bytes . object $
    [("type", "\"FeatureCollection\""), ("features", list (features <> maybeToList enclosure <> others <> nothing))]
      <> [("name", quoted text) | Just text <- [name]]
      <> [("crs", "{\"type\": \"name\"}"), ("bbox", "[0, 0, 1, 1]")]
  where
    bytes = Lazy.toStrict . Builder.toLazyByteString . Builder.stringUtf8
    standing = feature []
    feature others polygon = do
      geometry <- geometryOf polygon
      properties <- object (others <> propertiesOf polygon)
      object [("type", "\"Feature\""), ("properties", properties), ("geometry", geometry), ("id", "7")]
    propertiesOf polygon =
      [("name", maybe "null" quoted (rawPolygonName polygon))]
        <> [("emission", numberJson e) | let e = emission (rawMaterial polygon), e /= emission black]
        <> [("reflectivity", numberJson r) | let r = reflectivity (rawMaterial polygon), r /= reflectivity black]
        <> [("height", "[1, {\"unit\": \"m\"}]")]
    geometryOf polygon = do
      positions <- mapM position (rawCorners polygon)
      let (kind, coordinates) = case rawForm polygon of
            Ring -> ("Polygon", list [list (positions <> take 1 positions)])
            Polyline -> ("LineString", list positions)
      single <- object [("type", quoted kind), ("coordinates", coordinates)]
      several <- object [("type", quoted ("Multi" <> kind)), ("coordinates", list [coordinates])]
      collected <- elements [single, several] >>= \one ->
        object [("type", "\"GeometryCollection\""), ("geometries", list [one])]
      elements [single, several, collected]
    position (Point x y) = do
      altitude <- elements [[], ["0"], ["12.5", "3"]]
      pure (list (map numberJson [x, y] <> altitude))
    object members = do
      shuffled <- shuffle members
      pure ("{" <> intercalate ", " [quoted key <> ": " <> value | (key, value) <- shuffled] <> "}")
    list items = "[" <> intercalate "," items <> "]"
    -- The names above need no escapes.
    quoted text = "\"" <> Text.unpack text <> "\""
    numberJson q = fromMaybe ("\"" <> rationalText q <> "\"") (decimalText q)

-- | One of the ways in which WKT says it, but for the enclosure, names and materials.
wktOf :: RawScene -> Gen Bytes.ByteString
wktOf (RawScene _ _ polygons) = do
  lines' <- mapM (\polygon -> (<>) <$> nothing <*> geometry polygon) polygons
  Lazy.toStrict . Builder.toLazyByteString . Builder.stringUtf8 <$> ((concat lines' <>) <$> nothing)
  where
    nothing =
      concat
        <$> upTo 2 (elements ["\n", " \t\r\n", "# (caf\233\n", "  #\n", "POLYGON EMPTY\n", "multilinestring z empty\n"])
    geometry polygon = do
      (dimension, others) <- elements [("", []), ("Z", ["0"]), ("M", ["1e3"]), ("zM", ["-1", "7"]), ("", ["2", "5"])]
      positions <- mapM (position others) (rawCorners polygon)
      let (kind, body) = case rawForm polygon of
            Ring -> ("POLYGON", list [list (positions <> take 1 positions)])
            Polyline -> ("LINESTRING", list positions)
      several <- elements ["EMPTY", "empty", ""]
      (word, text) <-
        elements [(kind, body), ("MULTI" <> kind, list ([several | not (null several)] <> [body]))]
      cased <- elements [id, map toLower]
      gap <- blank
      end <- elements ["\n", "\r\n", " \n"]
      before <- elements ["", "  "]
      pure (before <> cased word <> (if null dimension then "" else " " <> dimension) <> gap <> text <> end)
    position others (Point x y) = unwords . (<> others) <$> mapM number [x, y]
    number q = do
      plus <- elements ["", "+"]
      pure ((if q >= 0 then plus else "") <> numberText q)
    list items = "(" <> intercalate ", " items <> ")"
    blank = elements ["", " ", "\t "]

corners :: Gen Point
corners = Point <$> numbers <*> numbers

perhaps :: Gen a -> Gen (Maybe a)
perhaps g = oneof [pure Nothing, Just <$> g]

upTo :: Int -> Gen a -> Gen [a]
upTo n g = choose (0, n) >>= \k -> vectorOf k g

numbers :: Gen Rational
numbers =
  oneof
    [ pure 0
    , fromInteger <$> arbitrary
    , arbitrary
    , (\p k -> p % (10 ^ k)) <$> choose (-10 ^ (25 :: Int), 10 ^ (25 :: Int)) <*> choose (0, 25 :: Int)
    , (%) <$> choose (-10 ^ (60 :: Int), 10 ^ (60 :: Int)) <*> choose (1, 10 ^ (60 :: Int))
    ]
