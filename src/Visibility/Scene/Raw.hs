-- | A scene as a file states it, before anything has been checked.
module Visibility.Scene.Raw
  ( RawScene (..)
  , RawPolygon (..)
  , Form (..)
  , rawPolygon
  , rawWall
  , described
  , cornerTotal
  , sideTotal
  , Material (..)
  , black
  , MaterialOverride (..)
  , materialWith
  ) where

import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import Visibility.Exact.Point (Point)

-- | What a file says. Nothing in it need be valid: see "Visibility.Scene.Validate".
data RawScene = RawScene
  { rawName :: !(Maybe Text)
  , rawEnclosure :: !(Maybe RawPolygon)
  , rawPolygons :: ![RawPolygon]
  }
  deriving (Eq, Show)

-- | A polygon with its corners in the file's order, in either orientation; or a thin wall.
data RawPolygon = RawPolygon
  { rawPolygonName :: !(Maybe Text)
  , rawForm :: !Form
  , rawCorners :: ![Point]
  , rawMaterial :: !Material
  , rawSides :: !(Map.Map Int MaterialOverride)
  -- ^ What the file says of single sides, by its side number.
  }
  deriving (Eq, Show)

-- | How a polygon's corners are joined.
data Form
  = -- | Around an area, the last corner with the first. Side k joins the corners k and k + 1.
    Ring
  | -- | In a line, a thin wall. Of n corners, side k joins the corners k and k + 1, and side 2n − 3 − k is the other
    -- face of the same piece: the sides go along one face of the wall and back along the other.
    Polyline
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | A nameless black polygon that emits nothing. Two corners make a thin wall.
rawPolygon :: [Point] -> RawPolygon
rawPolygon points = RawPolygon Nothing form points black Map.empty
  where
    form = case points of
      [_, _] -> Polyline
      _ -> Ring

-- | A nameless black thin wall that emits nothing.
rawWall :: [Point] -> RawPolygon
rawWall points = (rawPolygon points) {rawForm = Polyline}

-- | The same outline with this name, this material and these sides.
described :: Maybe Text -> RawPolygon -> Material -> Map.Map Int MaterialOverride -> RawPolygon
described name polygon material sides =
  polygon {rawPolygonName = name, rawMaterial = material, rawSides = sides}

-- | How many corners a polygon has. /Cost/ O(n).
cornerTotal :: RawPolygon -> Int
cornerTotal = length . rawCorners

-- | How many sides a polygon has.
sideTotal :: RawPolygon -> Int
sideTotal polygon = case rawForm polygon of
  Ring -> n
  Polyline -> max 0 (2 * (n - 1))
  where
    n = cornerTotal polygon

-- | What a side does with light: emitted power per unit length, and the part of the incident power that it reflects.
data Material = Material {emission :: !Rational, reflectivity :: !Rational}
  deriving (Eq, Ord, Show)

-- | The default: no emission, no reflection.
black :: Material
black = Material 0 0

-- | The parts of a material that a single side states anew.
data MaterialOverride = MaterialOverride
  { overrideEmission :: !(Maybe Rational)
  , overrideReflectivity :: !(Maybe Rational)
  }
  deriving (Eq, Ord, Show)

-- | A material with what is stated anew.
materialWith :: Material -> MaterialOverride -> Material
materialWith (Material e r) (MaterialOverride e' r') = Material (fromMaybe e e') (fromMaybe r r')
