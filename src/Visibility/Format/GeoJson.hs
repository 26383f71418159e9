{-# LANGUAGE OverloadedStrings #-}

-- | Scenes as GeoJSON (RFC 7946).
--
-- Coordinates are those of the plane, whatever reference system the file has in mind.
module Visibility.Format.GeoJson
  ( readGeoJson
  ) where

import Data.ByteString (ByteString)
import Data.Foldable (traverse_)
import Data.List.NonEmpty (NonEmpty (..))
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import Visibility.Error
import Visibility.Exact.Point (Point (..))
import Visibility.Format.Checked
import Visibility.Format.Json.Shape
import Visibility.Format.Json.Syntax
import Visibility.Scene.Raw

-- | What the text of a file says of a scene; the path is only what the file is called in problems. Polygons are those
-- of Polygon and MultiPolygon, thin walls those of LineString and MultiLineString, in the order of the file. The
-- properties @name@, @emission@ and @reflectivity@ of a Feature hold for all of its geometry, and the @role@
-- @"enclosure"@ makes it the enclosure. A FeatureCollection may have a @name@, which is the scene's.
--
-- Numbers are those of our own JSON: exact, and strings such as @"1/3"@ too.
--
-- /Degenerate cases/ the third and further numbers of a position, all other properties and members, and what is null
-- or has no coordinates, are passed over. A property that is null is not given. Points, holes, rings that do not close
-- and a second enclosure are faults. Of JSON that is no GeoJSON of a scene, every fault is reported.
--
-- /Cost/ O(n) in bytes, but for the size of the numbers.
readGeoJson :: FilePath -> ByteString -> Either (NonEmpty Problem) RawScene
readGeoJson = readDocument sceneAt

sceneAt :: JsonPath -> Document -> Checked RawScene
sceneAt path document = case value document of
  Object members -> assembled name (ofType path members anyType (topLevel members))
    where
      name = case (stated "type", stated "name") of
        (Just (String "FeatureCollection"), Just (String text)) -> Just text
        _ -> Nothing
      stated key = value <$> lookup key members
  other -> wrongKind path other (Wanted "an object with a \"type\": a FeatureCollection, a Feature or a geometry")
  where
    anyType = Wanted ("\"FeatureCollection\", \"Feature\", " <> geometryTypes)
    topLevel members kind = case kind of
      "FeatureCollection" -> Just (needed path members "features" (Wanted "a list of features") features)
      "Feature" -> Just (feature path members)
      _ -> geometryOfType plain path members kind

-- | A piece of the scene, or faults that belong to none. A polygon has its place, by which a second enclosure is told.
data Part
  = Faulty !(NonEmpty ParseError)
  | Shape !JsonPath !Role !(Checked RawPolygon)

-- | What a feature is in the scene.
data Role = Standing | Enclosing
  deriving (Eq)

-- | What a feature says of all its polygons.
data Properties = Properties {role :: !Role, given :: !(RawPolygon -> RawPolygon)}

plain :: Properties
plain = Properties Standing id

assembled :: Maybe Text -> [Part] -> Checked RawScene
assembled name parts = scene . concat <$> eachOf (const checked) parts
  where
    scene shapes = RawScene name (listToMaybe (those Enclosing shapes)) (those Standing shapes)
    those wanted shapes = [polygon | (as, polygon) <- shapes, as == wanted]
    checked (Faulty faults) = Wrong faults
    checked (Shape place as polygon) = onlyOne place as *> ((\made -> [(as, made)]) <$> polygon)
    firstRoom = listToMaybe [place | Shape place Enclosing _ <- parts]
    onlyOne place Enclosing | Just first <- firstRoom, first /= place = wrong place (SecondEnclosure first)
    onlyOne _ _ = Good ()

-- Objects ---------------------------------------------------------------------------------------------------------

-- The parts that an object with members has by its type; nothing for types that do not belong there.
ofType :: JsonPath -> [(Text, Document)] -> Wanted -> (Text -> Maybe [Part]) -> [Part]
ofType path members wanted parts = case fmap value <$> memberOf path members "type" of
  Nothing -> faulty (wrong path (MissingKey ("type" :| []) wanted))
  Just (_, String kind) | Just known <- parts kind -> once path members ["type"] <> known
  Just (at, other) -> faulty (wrongKind at other wanted)

-- The parts of a member that must be there.
needed :: JsonPath -> [(Text, Document)] -> Text -> Wanted -> (JsonPath -> Document -> [Part]) -> [Part]
needed path members key wanted parts =
  once path members [key] <> case memberOf path members key of
    Nothing -> faulty (wrong path (MissingKey (key :| []) wanted))
    Just (at, document) -> parts at document

-- None of the keys that have a meaning is given more than once.
once :: JsonPath -> [(Text, Document)] -> [Text] -> [Part]
once path members keys = faulty (checkedTwins path (filter ((`elem` keys) . fst) members))

faulty :: Checked a -> [Part]
faulty (Wrong faults) = [Faulty faults]
faulty (Good _) = []

eachPart :: Wanted -> (JsonPath -> Document -> [Part]) -> JsonPath -> Document -> [Part]
eachPart wanted parts path document = case value document of
  List items -> concat (zipWith (parts . Item path) [0 ..] items)
  other -> faulty (wrongKind path other wanted)

-- Features --------------------------------------------------------------------------------------------------------

features :: JsonPath -> Document -> [Part]
features = eachPart (Wanted "a list of features") featureAt
  where
    featureAt path document = case value document of
      Object members -> ofType path members (Wanted "\"Feature\"") (ofFeature path members)
      other -> faulty (wrongKind path other (Wanted "an object of the type \"Feature\""))
    ofFeature path members kind = if kind == "Feature" then Just (feature path members) else Nothing

feature :: JsonPath -> [(Text, Document)] -> [Part]
feature path members = once path members ["properties"] <> faults <> needed path members "geometry" aGeometry shape
  where
    (faults, properties) = maybe ([], plain) (uncurry propertiesAt) (memberOf path members "properties")
    shape at document = case value document of
      Null -> []
      _ -> geometry properties at document

-- What is wrong with the properties of a feature, and what is right.
propertiesAt :: JsonPath -> Document -> ([Part], Properties)
propertiesAt path document = case value document of
  Null -> ([], plain)
  Object members -> (once path members ["name", "emission", "reflectivity", "role"] <> faults, properties)
    where
      property key readAt = case memberOf path members key of
        Nothing -> Good Nothing
        Just (at, document') -> case value document' of
          Null -> Good Nothing
          _ -> Just <$> readAt at document'
      as = fromMaybe Standing <$> property "role" roleAt
      description =
        stated <$> property "name" stringAt <*> property "emission" numberAt <*> property "reflectivity" numberAt
      stated name e r polygon = described name polygon (materialWith black (MaterialOverride e r)) (rawSides polygon)
      faults = faulty description <> faulty as
      properties = Properties {role = orElse Standing as, given = orElse id description}
      orElse usual found = case found of
        Good right -> right
        Wrong _ -> usual
  other -> (faulty (wrongKind path other (Wanted "an object or null")), plain)

roleAt :: JsonPath -> Document -> Checked Role
roleAt path document = case value document of
  String "enclosure" -> Good Enclosing
  other -> wrongKind path other (Wanted "\"enclosure\", or leave it out")

-- Geometry --------------------------------------------------------------------------------------------------------

geometry :: Properties -> JsonPath -> Document -> [Part]
geometry properties path document = case value document of
  Object members -> ofType path members (Wanted geometryTypes) (geometryOfType properties path members)
  other -> faulty (wrongKind path other aGeometry)

geometryOfType :: Properties -> JsonPath -> [(Text, Document)] -> Text -> Maybe [Part]
geometryOfType properties path members kind = case kind of
  "Polygon" -> Just (coordinates (Wanted "a list of rings, each a list of positions [x, y]") polygon)
  "MultiPolygon" -> Just (lists (Wanted "a list of polygons, each a list of rings of positions [x, y]") polygon)
  "LineString" -> Just (coordinates (Wanted "a list of positions [x, y]") line)
  "MultiLineString" -> Just (lists (Wanted "a list of lines, each a list of positions [x, y]") line)
  "GeometryCollection" -> Just (needed path members "geometries" (Wanted "a list of geometries") geometries)
  _ -> Nothing
  where
    geometries = eachPart (Wanted "a list of geometries") (geometry properties)
    lists wanted parts = coordinates wanted (eachPart wanted parts)
    coordinates wanted parts = needed path members "coordinates" wanted (unlessEmpty parts)
    polygon = unlessEmpty (shape polygonAt)
    line = unlessEmpty (shape lineAt)
    shape outline at document =
      [Shape at (role properties) (given properties <$> outline (role properties) at document)]

geometryTypes :: String
geometryTypes = "\"Polygon\", \"MultiPolygon\", \"LineString\", \"MultiLineString\" or \"GeometryCollection\""

aGeometry :: Wanted
aGeometry = Wanted ("an object of the type " <> geometryTypes)

-- Empty coordinates stand for no geometry (RFC 7946, 3.1).
unlessEmpty :: (JsonPath -> Document -> [Part]) -> JsonPath -> Document -> [Part]
unlessEmpty parts path document = case value document of
  List [] -> []
  _ -> parts path document

polygonAt :: Role -> JsonPath -> Document -> Checked RawPolygon
polygonAt as path document = case value document of
  List (outer : holes) ->
    outlineAt ringPolygon (Item path 0) outer
      <* traverse_ (\k -> wrong (Item path k) hole) (zipWith const [1 ..] holes)
  other -> wrongKind path other (Wanted "a list of rings, each a list of positions [x, y]")
  where
    hole = case as of
      Standing -> BadOutline Hole
      Enclosing -> EnclosureHole

lineAt :: Role -> JsonPath -> Document -> Checked RawPolygon
lineAt Standing path document = outlineAt lineWall path document
lineAt Enclosing path document = outlineAt lineWall path document <* wrong path EnclosureWall

outlineAt :: ([Point] -> Either OutlineFault RawPolygon) -> JsonPath -> Document -> Checked RawPolygon
outlineAt outline path document =
  listOf (Wanted "a list of positions [x, y]") positionAt path document
    `andThen` (either (wrong path . BadOutline) Good . outline)

-- What stands behind x and y, an altitude as a rule, has no meaning in the plane.
positionAt :: JsonPath -> Document -> Checked Point
positionAt path document = case value document of
  List (x : y : _) -> Point <$> numberAt (Item path 0) x <*> numberAt (Item path 1) y
  other -> wrongKind path other (Wanted "a list of two numbers [x, y], or more of which these two count")
