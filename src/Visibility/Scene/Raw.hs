-- | A scene as a file states it, before anything has been checked.
module Visibility.Scene.Raw
  ( RawScene (..)
  , RawPolygon (..)
  , rawPolygon
  , Material (..)
  , black
  , MaterialOverride (..)
  ) where

import qualified Data.Map.Strict as Map
import Data.Text (Text)
import Visibility.Exact.Point (Point)

-- | What a file says. Nothing in it need be valid: see "Visibility.Scene.Validate".
data RawScene = RawScene
  { rawName :: !(Maybe Text)
  , rawEnclosure :: !(Maybe RawPolygon)
  , rawPolygons :: ![RawPolygon]
  }
  deriving (Eq, Show)

-- | A polygon with its corners in the file's order, in either orientation. Two corners make a thin wall.
data RawPolygon = RawPolygon
  { rawPolygonName :: !(Maybe Text)
  , rawCorners :: ![Point]
  , rawMaterial :: !Material
  , rawSides :: !(Map.Map Int MaterialOverride)
  -- ^ What the file says of single sides, by the file's side number.
  }
  deriving (Eq, Show)

-- | A nameless black polygon that emits nothing.
rawPolygon :: [Point] -> RawPolygon
rawPolygon points = RawPolygon Nothing points black Map.empty

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
