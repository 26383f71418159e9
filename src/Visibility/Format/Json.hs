{-# LANGUAGE OverloadedStrings #-}

-- | Scenes as JSON, both ways.
module Visibility.Format.Json
  ( readScene
  , sceneDocument
  ) where

import Data.Aeson.Encoding (fromEncoding)
import qualified Data.Aeson.Encoding as Encoding
import Data.ByteString (ByteString)
import Data.ByteString.Builder (Builder)
import qualified Data.ByteString.Builder as Builder
import Data.Foldable (toList)
import Data.List (intersperse)
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as Text
import Text.Read (readMaybe)
import Visibility.Error
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.Rounding (rationalText)
import Visibility.Format.Checked
import Visibility.Format.Json.Shape
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
readScene = readDocument sceneAt

-- Reading ---------------------------------------------------------------------------------------------------------

sceneAt :: JsonPath -> Document -> Checked RawScene
sceneAt path document = case value document of
  Object members ->
    let member = memberOf path members
     in checkedKeys path ["format", "name", "enclosure", "polygons"] members
          *> traverse (uncurry formatAt) (member "format")
          *> ( RawScene
                <$> traverse (uncurry stringAt) (member "name")
                <*> traverse (uncurry enclosureAt) (member "enclosure")
                <*> maybe
                  (wrong path (MissingKey ("polygons" :| []) (Wanted "a list of polygons")))
                  (uncurry (listOf (Wanted "a list of polygons") polygonAt))
                  (member "polygons")
             )
  other -> wrongKind path other (Wanted "an object with the key \"polygons\"")

formatAt :: JsonPath -> Document -> Checked ()
formatAt path document = case value document of
  String "viscomplex/1" -> Good ()
  other -> wrongKind path other (Wanted "\"viscomplex/1\"")

-- | An enclosure has corners only; an obstacle may be stated as a wall instead.
enclosureAt, polygonAt :: JsonPath -> Document -> Checked RawPolygon
enclosureAt =
  shapeAt (Wanted "an object with the key \"corners\", or just the list of corners") (("corners", rawPolygon) :| [])
polygonAt =
  shapeAt
    (Wanted "an object with the key \"corners\" or \"wall\", or just the list of corners")
    (("corners", rawPolygon) :| [("wall", rawWall)])

-- | A polygon that gives its corners under one of these keys, which say how they are joined; or a list of corners.
shapeAt :: Wanted -> NonEmpty (Text, [Point] -> RawPolygon) -> JsonPath -> Document -> Checked RawPolygon
shapeAt wanted forms path document = case value document of
  List _ -> rawPolygon <$> listOf wanted cornerAt path document
  Object members ->
    let member = memberOf path members
        given = [(key, made <$> cornersAt at found) | (key, made) <- toList forms, Just (at, found) <- [member key]]
     in checkedKeys path (["name"] <> map fst (toList forms) <> ["emission", "reflectivity", "sides"]) members
          *> ( described
                <$> traverse (uncurry stringAt) (member "name")
                <*> case given of
                  [] -> wrong path (MissingKey (fmap fst forms) (Wanted "a list of corners [x, y]"))
                  [(_, polygon)] -> polygon
                  (key, polygon) : (other, polygon') : _ -> wrong path (ClashingKeys key other) *> polygon <* polygon'
                <*> (materialWith black <$> overrideBy member)
                <*> maybe (Good Map.empty) (uncurry sidesAt) (member "sides")
             )
  other -> wrongKind path other wanted
  where
    cornersAt = listOf (Wanted "a list of corners [x, y]") cornerAt

cornerAt :: JsonPath -> Document -> Checked Point
cornerAt path document = case value document of
  List [x, y] -> Point <$> numberAt (Item path 0) x <*> numberAt (Item path 1) y
  other -> wrongKind path other (Wanted "a list of two numbers [x, y]")

sidesAt :: JsonPath -> Document -> Checked (Map.Map Int MaterialOverride)
sidesAt path document = case value document of
  Object members -> Map.fromList <$> (checkedTwins path members *> traverse side members)
  other -> wrongKind path other (Wanted "an object with side numbers as keys")
  where
    side (key, override) =
      (,)
        <$> maybe (wrong path (BadSideKey key)) Good (sideNumber key)
        <*> overrideAt (Key path key) override
    -- Spelled in one way only, so that no two keys name the same side.
    sideNumber key = case readMaybe (Text.unpack key) of
      Just k | Text.pack (show k) == key -> Just k
      _ -> Nothing

overrideAt :: JsonPath -> Document -> Checked MaterialOverride
overrideAt path document = case value document of
  Object members -> checkedKeys path ["emission", "reflectivity"] members *> overrideBy (memberOf path members)
  other -> wrongKind path other (Wanted "an object with the keys \"emission\", \"reflectivity\" or both")

overrideBy :: (Text -> Maybe (JsonPath, Document)) -> Checked MaterialOverride
overrideBy member = MaterialOverride <$> number "emission" <*> number "reflectivity"
  where
    number = traverse (uncurry numberAt) . member

-- Writing ---------------------------------------------------------------------------------------------------------

-- | A scene as a file that says the same: a polygon to a line, keys and defaults as short as the format allows, always
-- the same bytes for the same scene. Integers and decimals of up to 20 digits after the point are written as JSON
-- numbers, other numbers as @"p/q"@.
--
-- /Degenerate cases/ no file can state a ring of two corners, which is read as a wall, nor a wall as the enclosure,
-- which is refused.
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
