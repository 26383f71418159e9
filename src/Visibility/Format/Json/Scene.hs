{-# LANGUAGE OverloadedStrings #-}

-- | Scenes as JSON, both ways.
module Visibility.Format.Json.Scene
  ( readScene
  , sceneDocument
  ) where

import Data.Aeson.Encoding (fromEncoding)
import qualified Data.Aeson.Encoding as Encoding
import Data.ByteString (ByteString)
import Data.ByteString.Builder (Builder)
import qualified Data.ByteString.Builder as Builder
import Data.Foldable (toList, traverse_)
import Data.List (intersperse)
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as Text
import Text.Read (readMaybe)
import Visibility.Error
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.Rounding (rationalText)
import Visibility.Format.Json.Syntax
import Visibility.Format.Number
import Visibility.Scene.Raw

-- | What the text of a file says of a scene; the path is only what the file is called in problems.
--
-- /Degenerate cases/ of a text that is not JSON, the first fault; of JSON that does not have the shape of a scene,
-- every fault. What no scene can have, such as a negative emission, is read: see "Visibility.Scene.Validate".
--
-- /Cost/ O(n) in bytes, but for the size of the numbers.
--
-- /Laws/ @readScene file (bytes (sceneDocument raw)) == Right raw@.
readScene :: FilePath -> ByteString -> Either (NonEmpty Problem) RawScene
readScene file bytes = case parseDocument bytes of
  Left (position, fault) -> Left (UnparseableFile file (SyntaxError position fault) :| [])
  Right document -> case sceneAt Root document of
    Wrong faults -> Left (fmap (UnparseableFile file) faults)
    Good raw -> Right raw

-- Reading ---------------------------------------------------------------------------------------------------------

-- | A value or all the faults that prevent it.
data Checked a = Wrong (NonEmpty ParseError) | Good a

instance Functor Checked where
  fmap _ (Wrong faults) = Wrong faults
  fmap f (Good a) = Good (f a)

-- | Collects the faults of both sides, in order.
instance Applicative Checked where
  pure = Good
  Good f <*> Good a = Good (f a)
  Wrong faults <*> Wrong faults' = Wrong (faults <> faults')
  Wrong faults <*> Good _ = Wrong faults
  Good _ <*> Wrong faults = Wrong faults

wrong :: JsonPath -> ShapeFault -> Checked a
wrong path fault = Wrong (ShapeError path fault :| [])

sceneAt :: JsonPath -> Document -> Checked RawScene
sceneAt path (Object members) =
  checkedKeys path ["format", "name", "enclosure", "polygons"] members
    *> traverse (uncurry formatAt) (member "format")
    *> ( RawScene
          <$> traverse (uncurry stringAt) (member "name")
          <*> traverse (uncurry enclosureAt) (member "enclosure")
          <*> maybe (wrong path (MissingKey ("polygons" :| []) WantedPolygons)) (uncurry polygonsAt) (member "polygons")
       )
  where
    member = memberOf path members
sceneAt path other = wrongKind path other WantedScene

formatAt :: JsonPath -> Document -> Checked ()
formatAt _ (String "viscomplex/1") = Good ()
formatAt path other = wrongKind path other WantedFormat

stringAt :: JsonPath -> Document -> Checked Text
stringAt _ (String text) = Good text
stringAt path other = wrongKind path other WantedString

polygonsAt :: JsonPath -> Document -> Checked [RawPolygon]
polygonsAt path (List items) = eachItem polygonAt path items
polygonsAt path other = wrongKind path other WantedPolygons

-- | An enclosure has corners only; an obstacle may be stated as a wall instead.
enclosureAt, polygonAt :: JsonPath -> Document -> Checked RawPolygon
enclosureAt = shapeAt WantedEnclosure (("corners", rawPolygon) :| [])
polygonAt = shapeAt WantedPolygon (("corners", rawPolygon) :| [("wall", rawWall)])

-- | A polygon that gives its corners under one of these keys, which say how they are joined; or a list of corners.
shapeAt :: Wanted -> NonEmpty (Text, [Point] -> RawPolygon) -> JsonPath -> Document -> Checked RawPolygon
shapeAt wanted forms path document = case document of
  List _ -> rawPolygon <$> cornersAt path document
  Object members ->
    let member = memberOf path members
        given = [(key, made <$> cornersAt at corners) | (key, made) <- toList forms, Just (at, corners) <- [member key]]
     in checkedKeys path (["name"] <> map fst (toList forms) <> ["emission", "reflectivity", "sides"]) members
          *> ( described
                <$> traverse (uncurry stringAt) (member "name")
                <*> case given of
                  [] -> wrong path (MissingKey (fmap fst forms) WantedCorners)
                  [(_, polygon)] -> polygon
                  (key, polygon) : (other, polygon') : _ -> wrong path (ClashingKeys key other) *> polygon <* polygon'
                <*> ( Material
                        <$> maybe (Good (emission black)) (uncurry numberAt) (member "emission")
                        <*> maybe (Good (reflectivity black)) (uncurry numberAt) (member "reflectivity")
                    )
                <*> maybe (Good Map.empty) (uncurry sidesAt) (member "sides")
             )
  _ -> wrongKind path document wanted
  where
    described name polygon material overrides =
      polygon {rawPolygonName = name, rawMaterial = material, rawSides = overrides}

cornersAt :: JsonPath -> Document -> Checked [Point]
cornersAt path (List items) = eachItem cornerAt path items
cornersAt path other = wrongKind path other WantedCorners

cornerAt :: JsonPath -> Document -> Checked Point
cornerAt path (List [x, y]) = Point <$> numberAt (Item path 0) x <*> numberAt (Item path 1) y
cornerAt path other = wrongKind path other WantedCorner

sidesAt :: JsonPath -> Document -> Checked (Map.Map Int MaterialOverride)
sidesAt path (Object members) = Map.fromList <$> (checkedTwins path members *> traverse side members)
  where
    side (key, document) =
      (,)
        <$> maybe (wrong path (BadSideKey key)) Good (sideNumber key)
        <*> overrideAt (Key path key) document
    -- Spelled in one way only, so that no two keys name the same side.
    sideNumber key = case readMaybe (Text.unpack key) of
      Just k | Text.pack (show k) == key -> Just k
      _ -> Nothing
sidesAt path other = wrongKind path other WantedSides

overrideAt :: JsonPath -> Document -> Checked MaterialOverride
overrideAt path (Object members) =
  checkedKeys path ["emission", "reflectivity"] members
    *> ( MaterialOverride
          <$> traverse (uncurry numberAt) (member "emission")
          <*> traverse (uncurry numberAt) (member "reflectivity")
       )
  where
    member = memberOf path members
overrideAt path other = wrongKind path other WantedMaterial

numberAt :: JsonPath -> Document -> Checked Rational
numberAt path document = case document of
  Number spelled -> number spelled
  String text -> number text
  _ -> wrongKind path document WantedNumber
  where
    number = either (wrong path . BadNumber (found document)) Good . readNumber

eachItem :: (JsonPath -> Document -> Checked a) -> JsonPath -> [Document] -> Checked [a]
eachItem itemAt path items = traverse (\(k, item) -> itemAt (Item path k) item) (zip [0 ..] items)

memberOf :: JsonPath -> [(Text, Document)] -> Text -> Maybe (JsonPath, Document)
memberOf path members key = (,) (Key path key) <$> lookup key members

-- Every key is allowed and given once.
checkedKeys :: JsonPath -> [Text] -> [(Text, Document)] -> Checked ()
checkedKeys path allowed members =
  checkedTwins path members *> traverse_ (\key -> wrong path (UnknownKey key allowed)) unknown
  where
    unknown = distinct (filter (`notElem` allowed) (map fst members))

checkedTwins :: JsonPath -> [(Text, Document)] -> Checked ()
checkedTwins path members = traverse_ (wrong path . DuplicateKey) (distinct (repeated Set.empty (map fst members)))
  where
    repeated _ [] = []
    repeated seen (key : keys)
      | key `Set.member` seen = key : repeated seen keys
      | otherwise = repeated (Set.insert key seen) keys

-- In the order of their first appearance.
distinct :: [Text] -> [Text]
distinct = go Set.empty
  where
    go _ [] = []
    go seen (key : keys)
      | key `Set.member` seen = go seen keys
      | otherwise = key : go (Set.insert key seen) keys

wrongKind :: JsonPath -> Document -> Wanted -> Checked a
wrongKind path document wanted = wrong path (WrongKind (found document) wanted)

found :: Document -> Found
found document = case document of
  Null -> FoundNull
  Boolean b -> FoundBoolean b
  Number spelled -> FoundNumber spelled
  String text -> FoundString text
  List items -> FoundList (length items)
  Object _ -> FoundObject

-- Writing ---------------------------------------------------------------------------------------------------------

-- | A scene as a file that says the same: a polygon to a line, keys and defaults as short as the format allows, always
-- the same bytes for the same scene. Integers and decimals of up to 20 digits after the point are written as JSON
-- numbers, other numbers as @"p/q"@.
--
-- /Degenerate cases/ no file can state a ring of two corners, which is read as a wall, nor a wall as the enclosure, which
-- is refused. "Visibility.Scene.Raw" makes neither of a ring's corners.
--
-- /Laws/ of other scenes @readScene file (bytes (sceneDocument raw)) == Right raw@.
sceneDocument :: RawScene -> Builder
sceneDocument (RawScene name enclosure polygons) =
  "{ " <> commaSeparated ",\n  " (concat [format, title, room, [pair "polygons" obstacles]]) <> " }\n"
  where
    format = [pair "format" (textDocument "viscomplex/1")]
    title = [pair "name" (textDocument text) | Just text <- [name]]
    room = [pair "enclosure" (polygonDocument polygon) | Just polygon <- [enclosure]]
    obstacles = case polygons of
      [] -> "[]"
      _ -> "[\n    " <> commaSeparated ",\n    " (map polygonDocument polygons) <> "\n  ]"

polygonDocument :: RawPolygon -> Builder
polygonDocument (RawPolygon name form corners material sides)
  | null others && key == "corners" = cornerList
  | otherwise = braces (title <> [pair key cornerList] <> drop (length title) others)
  where
    -- Two corners make a wall under either key.
    key = case form of
      Polyline | length corners /= 2 -> "wall"
      _ -> "corners"
    title = [pair "name" (textDocument text) | Just text <- [name]]
    others =
      title
        <> [pair "emission" (numberDocument (emission material)) | emission material /= emission black]
        <> [pair "reflectivity" (numberDocument (reflectivity material)) | reflectivity material /= reflectivity black]
        <> [pair "sides" (braces (map side (Map.toAscList sides))) | not (Map.null sides)]
    cornerList = brackets [brackets [numberDocument x, numberDocument y] | Point x y <- corners]
    side (k, MaterialOverride e r) =
      pair
        (Text.pack (show k))
        (braces [pair part (numberDocument x) | (part, Just x) <- [("emission", e), ("reflectivity", r)]])

numberDocument :: Rational -> Builder
numberDocument q = case decimalText q of
  Just decimal -> Builder.string7 decimal
  Nothing -> "\"" <> Builder.string7 (rationalText q) <> "\""

textDocument :: Text -> Builder
textDocument = fromEncoding . Encoding.text

pair :: Text -> Builder -> Builder
pair key inner = textDocument key <> ": " <> inner

braces, brackets :: [Builder] -> Builder
braces inner = "{" <> commaSeparated ", " inner <> "}"
brackets inner = "[" <> commaSeparated "," inner <> "]"

commaSeparated :: Builder -> [Builder] -> Builder
commaSeparated comma = mconcat . intersperse comma
