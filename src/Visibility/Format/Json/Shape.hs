{-# LANGUAGE OverloadedStrings #-}

-- | Values of a JSON document that have the shape of their place, or all the faults that prevent it.
module Visibility.Format.Json.Shape
  ( -- * Values and faults
    readDocument
  , wrong
  , wrongKind
    -- * Values
  , stringAt
  , numberAt
  , listOf
    -- * Members
  , memberOf
  , checkedKeys
  , checkedTwins
  ) where

import Data.ByteString (ByteString)
import Data.Containers.ListUtils (nubOrd)
import Data.Foldable (traverse_)
import Data.List.NonEmpty (NonEmpty)
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as Text
import Visibility.Error
import Visibility.Format.Checked
import Visibility.Format.Json.Syntax
import Visibility.Format.Number
import Visibility.Format.Utf8

-- | What the text of a file says, by the shape of its document; the path is only what the file is called in problems.
--
-- /Degenerate cases/ of a text that is not JSON, the first fault; else every fault of shape.
readDocument :: (JsonPath -> Document -> Checked a) -> FilePath -> ByteString -> Either (NonEmpty Problem) a
readDocument shapeAt file bytes = outcome file $ case parseDocument bytes of
  Left (position, why) -> fault (SyntaxError position why)
  Right document -> shapeAt Root document

-- | One fault.
wrong :: JsonPath -> ShapeFault -> Checked a
wrong path why = fault (ShapeError path why)

-- | The value found is not of the kind wanted.
wrongKind :: JsonPath -> Value -> Wanted -> Checked a
wrongKind path other wanted = wrong path (WrongKind (found other) wanted)

-- | What messages call a value.
found :: Value -> String
found other = case other of
  Null -> "null"
  Boolean b -> if b then "true" else "false"
  Number spelled -> Text.unpack (shortened (decoded spelled))
  String text -> quoted text
  List [] -> "an empty list"
  List [_] -> "a list of 1 element"
  List items -> "a list of " <> show (length items) <> " elements"
  Object _ -> "an object"

-- | A string.
stringAt :: JsonPath -> Document -> Checked Text
stringAt path document = case value document of
  String text -> Good text
  other -> wrongKind path other (Wanted "a string")

-- | A number as it is spelled, or a string that spells one.
numberAt :: JsonPath -> Document -> Checked Rational
numberAt path document = case value document of
  Number spelled -> number (readSpelled spelled)
  String text -> number (readNumber text)
  other -> wrongKind path other aNumber
  where
    number = either (wrong path . BadNumber (found (value document))) Good

-- | All items of a list.
listOf :: Wanted -> (JsonPath -> Document -> Checked a) -> JsonPath -> Document -> Checked [a]
listOf wanted itemAt path document = case value document of
  List items -> eachOf (itemAt . Item path) items
  other -> wrongKind path other wanted
{-# INLINE listOf #-}

-- | A member of the object at the path, with its own path. Of several, the first.
memberOf :: JsonPath -> [(Text, Document)] -> Text -> Maybe (JsonPath, Document)
memberOf path members key = (,) (Key path key) <$> lookup key members

-- | Every key is allowed and given once.
checkedKeys :: JsonPath -> [Text] -> [(Text, Document)] -> Checked ()
checkedKeys path allowed members =
  checkedTwins path members *> traverse_ (\key -> wrong path (UnknownKey key allowed)) unknown
  where
    unknown = nubOrd (filter (`notElem` allowed) (map fst members))

-- | Every key is given once.
checkedTwins :: JsonPath -> [(Text, Document)] -> Checked ()
checkedTwins path members = traverse_ (wrong path . DuplicateKey) (nubOrd (repeated Set.empty (map fst members)))
  where
    repeated _ [] = []
    repeated seen (key : keys)
      | key `Set.member` seen = key : repeated seen keys
      | otherwise = repeated (Set.insert key seen) keys
