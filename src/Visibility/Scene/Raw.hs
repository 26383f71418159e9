{-# LANGUAGE PatternSynonyms #-}
{-# LANGUAGE ViewPatterns #-}

-- | A scene as a file states it, before anything has been checked.
module Visibility.Scene.Raw
  ( RawScene (..)
  , RawPolygon (RawPolygon, rawPolygonName, rawForm, rawCorners, rawMaterial, rawSides)
  , Form (..)
  , rawPolygon
  , rawWall
  , described
  , cornerTotal
  , machineCorners
  , sideTotal
  , Material (..)
  , black
  , MaterialOverride (..)
  ) where

import qualified Data.Map.Strict as Map
import Data.Primitive.PrimArray (PrimArray)
import Data.Text (Text)
import Visibility.Exact.Point (Point)
import Visibility.Scene.Packed

-- | What a file says. Nothing in it need be valid: see "Visibility.Scene.Validate".
data RawScene = RawScene
  { rawName :: !(Maybe Text)
  , rawEnclosure :: !(Maybe RawPolygon)
  , rawPolygons :: ![RawPolygon]
  }
  deriving (Eq, Show)

-- | A polygon with its corners in the file's order, in either orientation; or a thin wall. In memory the corners are
-- packed; who looks at them, by 'RawPolygon' and 'rawCorners', unpacks them each time anew.
data RawPolygon = PackedPolygon
  { packedName :: !(Maybe Text)
  , packedForm :: !Form
  , packedCorners :: !Packed
  , packedMaterial :: !Material
  , packedSides :: !(Map.Map Int MaterialOverride)
  }
  deriving (Eq)

-- | The name, the form, the corners, the material, and what the file says of single sides, by the file's side number.
pattern RawPolygon :: Maybe Text -> Form -> [Point] -> Material -> Map.Map Int MaterialOverride -> RawPolygon
pattern RawPolygon {rawPolygonName, rawForm, rawCorners, rawMaterial, rawSides} <-
  PackedPolygon rawPolygonName rawForm (unpacked -> rawCorners) rawMaterial rawSides
  where
    RawPolygon name form corners = PackedPolygon name form (packed corners)

{-# COMPLETE RawPolygon #-}

-- | As it is made.
instance Show RawPolygon where
  showsPrec p (RawPolygon name form corners material sides) =
    showParen (p > 10) $
      showString "RawPolygon "
        . (showsPrec 11 name . showString " ")
        . (showsPrec 11 form . showString " ")
        . (showsPrec 11 corners . showString " ")
        . (showsPrec 11 material . showString " ")
        . showsPrec 11 sides

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
rawWall points = (rawPolygon points) {packedForm = Polyline}

-- | The same outline with this name, this material and these sides. (Other than a change of fields, this does not look
-- at the corners.)
described :: Maybe Text -> RawPolygon -> Material -> Map.Map Int MaterialOverride -> RawPolygon
described name polygon material sides =
  polygon {packedName = name, packedMaterial = material, packedSides = sides}

-- | How many corners a polygon has. /Cost/ O(1).
cornerTotal :: RawPolygon -> Int
cornerTotal = packedLength . packedCorners

-- | The corners of a polygon in machine integers, where these do: see 'machineTable'. /Cost/ O(1).
machineCorners :: RawPolygon -> Maybe (Int, PrimArray Int)
machineCorners = machineTable . packedCorners

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
