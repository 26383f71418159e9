-- | The elements that a mesh cuts sides into, and the scene in which they are the sides.
--
-- The form factors of elements are those of a scene with flat corners at the break points, swept like any other.
module Visibility.Mesh.Element
  ( Element (..)
  , elementText
  , elementEnds
  , elementNames
    -- * Scenes of elements
  , Refined (..)
  , refinedScene
  , refinedElements
  , refined
  , unrefined
  ) where

import Data.Function (on)
import Data.List (groupBy)
import qualified Data.Map.Strict as Map
import Visibility.Exact.Point (Point)
import Visibility.Mesh.Span
import Visibility.Mesh.Type
import Visibility.Scene
import Visibility.Scene.Flat (withFlatCorners)

-- | A part of a side, of one radiosity.
data Element = Element
  { elementSide :: !SideName
  -- ^ The side of the file that it is a part of.
  , elementNumber :: !Int
  -- ^ Its number on the side, from 0.
  , elementFrom :: !Rational
  , elementTo :: !Rational
  -- ^ Where it begins and ends on the side, which goes from 0 to 1.
  , elementIn :: !SideName
  -- ^ What the scene calls it in which the elements are sides.
  }
  deriving (Eq, Show)

-- | @3.0#2@: the form of every output.
elementText :: Element -> String
elementText e = sideText (elementSide e) <> "#" <> show (elementNumber e)

-- | Where it begins and where it ends, in the file's coordinates.
elementEnds :: Refined -> Element -> (Point, Point)
elementEnds cut = sideEnds (refinedScene cut) . elementIn

-- | A scene whose sides are elements of another scene's sides, and all of these elements, in the order of those sides.
-- Shown as @\<refined: 12 elements\>@.
data Refined = Refined !Scene ![Element]

instance Show Refined where
  show cut = "<refined: " <> show (length (refinedElements cut)) <> " elements>"

refinedScene :: Refined -> Scene
refinedScene (Refined scene _) = scene

refinedElements :: Refined -> [Element]
refinedElements (Refined _ elements) = elements

-- | The elements between the break points of a mesh.
--
-- /Degenerate cases/ the two faces of a thin wall are cut at the break points of both. Where a side is covered in part,
-- the pieces that are not covered are cut each for itself, and what is covered belongs to no element. A side that is
-- all covered has none.
--
-- /Cost/ O(n log n) in the corners of the mesh's scene and its break points.
--
-- /Laws/ the elements of a side follow each other without gaps where it is not covered. Σ over the elements t_k of t of
-- F(s, t_k) is F(s, t), and Σ over those of s of |s_k| F(s_k, t) is |s| F(s, t); both exact.
refined :: Mesh -> Refined
refined mesh = Refined cut (concatMap numbered (groupBy ((==) `on` fst) (zip owners (statedSides cut))))
  where
    scene = meshScene mesh
    (cut, owners) = withFlatCorners (map breakAt . breaksOn mesh) scene
    numbered parts = [element side k part | (k, (side, part)) <- zip [0 ..] parts]
    element side k part = Element side k (along from) (along to) part
      where
        (from, to) = sideEnds cut part
        along = parameterOn (sideEnds scene side)

-- | By the name of a side in the scene of the elements, the name of the element.
elementNames :: Refined -> SideName -> String
elementNames cut = \name -> maybe (sideText name) elementText (Map.lookup name byName)
  where
    byName = Map.fromList [(elementIn e, e) | e <- refinedElements cut]

-- | Every side as one element.
unrefined :: Scene -> Refined
unrefined scene = Refined scene [Element s 0 0 1 s | s <- statedSides scene]
