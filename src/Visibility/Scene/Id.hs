-- | The names of things: what tables use inside, and what files and output say.
--
-- A 'CornerId' is a corner's rank in the lexicographic order of the scene (by x, then y): comparing two ids compares
-- two corners, so the sweep never looks at coordinates to order them. What people read is a 'CornerName' or 'SideName',
-- which counts polygons and corners as the file does. Where polygons touch, the two are not one to one: see
-- "Visibility.Scene.Boundary".
module Visibility.Scene.Id
  ( -- * Names in files and output
    PolygonId (..)
  , CornerName (..)
  , SideName (..)
  , polygonText
  , cornerText
  , sideText
  , readCornerName
    -- * Indices inside tables
  , CornerId (..)
  , SideId (..)
  , Object (..)
    -- * What is seen, in files and output
  , Seen (..)
  , seenText
  ) where

import Text.Read (readMaybe)

-- | A polygon of the file: obstacles are counted from 0, the enclosure has no number and comes last in every order.
data PolygonId = Obstacle !Int | Enclosure
  deriving (Eq, Ord, Show)

-- | Corner k of a polygon, as the file counts. Order: by polygon, then by corner.
data CornerName = CornerName !PolygonId !Int
  deriving (Eq, Ord, Show)

-- | Side k of a polygon joins the file's corners k and k+1 (cyclically); the sides of a thin wall of n corners go along
-- one face and back along the other, n - 1 each way. Order: by polygon, then by side.
data SideName = SideName !PolygonId !Int
  deriving (Eq, Ord, Show)

-- | @3@ for an obstacle, @E@ for the enclosure.
polygonText :: PolygonId -> String
polygonText (Obstacle k) = show k
polygonText Enclosure = "E"

-- | @3.0@, @E.2@: the form of every output.
cornerText :: CornerName -> String
cornerText (CornerName p k) = polygonText p <> "." <> show k

-- | @3.0@, @E.2@: the form of every output.
sideText :: SideName -> String
sideText (SideName p k) = polygonText p <> "." <> show k

-- | Reads what 'cornerText' writes.
--
-- >>> readCornerName "E.2"
-- Just (CornerName Enclosure 2)
--
-- >>> readCornerName "3"
-- Nothing
readCornerName :: String -> Maybe CornerName
readCornerName text = case break (== '.') text of
  (polygon, '.' : number) -> CornerName <$> readPolygon polygon <*> natural number
  _ -> Nothing
  where
    readPolygon "E" = Just Enclosure
    readPolygon digits = Obstacle <$> natural digits
    -- As it is written: without leading zeros.
    natural digits
      | not (null digits), all (`elem` ['0' .. '9']) digits, take 1 digits /= "0" || digits == "0" = readMaybe digits
      | otherwise = Nothing

-- | A corner of free space: its rank in the lexicographic order of the scene's corners, from 0. Corners in one place,
-- but in different cones of free space, follow each other.
newtype CornerId = CornerId Int
  deriving (Eq, Ord, Show)

-- | A side, named by the corner it starts at when the solid is kept on its left (obstacles counter-clockwise, the
-- enclosure clockwise). The two faces of a thin wall start at its two ends. Where other polygons cover a part of a
-- side, each uncovered piece of it is a side of its own here, all with the one name that the file gives.
newtype SideId = SideId Int
  deriving (Eq, Ord, Show)

-- | What ends a free segment: a side, or the sky beyond everything. Sides come first in the order.
data Object = Side !SideId | Sky
  deriving (Eq, Ord, Show)

-- | What is seen, as the file calls it: a side with all its pieces, or the sky. Sides come first in the order, by name.
data Seen = TheSide !SideName | TheSky
  deriving (Eq, Ord, Show)

-- | @3.0@, @E.2@ or @sky@.
seenText :: Seen -> String
seenText (TheSide s) = sideText s
seenText TheSky = "sky"
