-- | Break points of sides, and meshes of them.
module Visibility.Mesh.Type
  ( -- * Break points
    BreakPoint (..)
  , Cause (..)
  , Kind (..)
  , Caster (..)
  , breakKind
  , breakCasters
  , casterNames
    -- * Meshes
  , Mesh (..)
  , meshScene
  , emptyMesh
  , breaksOn
  , breaksOf
  , meshSides
  , breakCount
    -- * How many elements
  , ElementCount
  , elementCount
  , countedElements
  ) where

import Data.Foldable (toList)
import Data.List (sortOn)
import Data.List.NonEmpty (NonEmpty (..))
import Data.Maybe (fromMaybe)
import qualified Data.Vector as V
import Visibility.Exact.Point (Point)
import Visibility.Scene

-- | What changes along a side where the line of a vertex lands.
data Kind
  = -- | The line is a free bitangent: beyond it something comes into view, or is hidden, all at once.
    ShadowLimit
  | -- | The line passes the end of a patch, or runs along one: what is seen changes, but from or to nothing.
    Kink
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | Two corners whose line lands on a side: an elementary visible pair of a vertex, the corner that is nearer to where
-- it lands first.
data Caster = Caster
  { casterKind :: !Kind
  , casterNear :: !CornerId
  , casterFar :: !CornerId
  }
  deriving (Eq, Ord, Show)

-- | Why a side is cut at a point.
data Cause
  = -- | Lines of vertices land there, one caster for each of them; shadow limits come first, then the smaller names.
    Cast !(NonEmpty Caster)
  | -- | It is cut into equal parts.
    EqualParts
  deriving (Eq, Show)

-- | A point of a side, strictly inside it.
data BreakPoint = BreakPoint
  { breakParameter :: !Rational
  -- ^ Where it is on the side of the file, whatever covers that: 0 where the side begins in the order of the file, 1
  -- where it ends. The second face of a thin wall begins where its first one ends.
  , breakAt :: Point
  -- ^ In the file's coordinates.
  , breakCause :: !Cause
  }
  deriving (Eq, Show)

-- | The kind of the first caster: a shadow limit if any is one.
breakKind :: BreakPoint -> Maybe Kind
breakKind point = case breakCause point of
  Cast (first :| _) -> Just (casterKind first)
  EqualParts -> Nothing

breakCasters :: BreakPoint -> [Caster]
breakCasters point = case breakCause point of
  Cast casters -> toList casters
  EqualParts -> []

-- | What the file calls the corners of a caster, the nearer one first.
casterNames :: Scene -> Caster -> (CornerName, CornerName)
casterNames scene caster = (cornerName scene (casterNear caster), cornerName scene (casterFar caster))

-- | The break points of all sides of a scene. Shown as @\<mesh: 12 break points\>@.
data Mesh = Mesh
  { cutScene :: !Scene
  , breakTable :: !(V.Vector [BreakPoint])
  -- ^ By 'SideId': see 'breaksOn'. Each entry is made when it is needed.
  }

instance Show Mesh where
  show mesh = "<mesh: " <> show (breakCount mesh) <> " break points>"

-- | The scene whose sides are cut.
meshScene :: Mesh -> Scene
meshScene = cutScene

-- | No break points: the elements are the sides.
emptyMesh :: Scene -> Mesh
emptyMesh scene = Mesh scene (V.replicate (length (sides scene)) [])

-- | The break points of a side, or of a piece of one, from its 'sideStart' to its 'sideEnd', which are not among them.
--
-- /Laws/ parameters are strictly monotone, and strictly between those of the ends.
breaksOn :: Mesh -> SideId -> [BreakPoint]
breaksOn mesh (SideId s) = fromMaybe [] (breakTable mesh V.!? s)

-- | The break points of a side of the file, on all its pieces, by ascending parameter; none if there is no such side.
--
-- /Laws/ parameters are strictly increasing, and strictly between 0 and 1.
breaksOf :: Mesh -> SideName -> [BreakPoint]
breaksOf mesh = sortOn breakParameter . concatMap (breaksOn mesh) . fromMaybe [] . piecesOf (meshScene mesh)

-- | All sides of the file with their break points, by name, those too that are covered or not cut.
meshSides :: Mesh -> [(SideName, [BreakPoint])]
meshSides mesh = [(side, breaksOf mesh side) | side <- statedSides (meshScene mesh)]

-- | How many break points there are.
breakCount :: Mesh -> Int
breakCount = sum . V.map length . breakTable

-- | How many elements a side has: 1 or more.
newtype ElementCount = ElementCount Int
  deriving (Eq, Ord, Show)

-- | 'Nothing' below 1.
elementCount :: Int -> Maybe ElementCount
elementCount n = if n >= 1 then Just (ElementCount n) else Nothing

countedElements :: ElementCount -> Int
countedElements (ElementCount n) = n
