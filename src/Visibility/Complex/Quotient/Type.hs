-- | The polygon-labelled complex: tangent lines, arcs of curves and regions, by id.
module Visibility.Complex.Quotient.Type
  ( -- * Quotients
    Quotient (..)
  , quotientUnion
  , regionIds
  , regionPolygons
    -- * The complex of a convex scene
  , Convex (..)
  , lineIds
  , arcIds
  , lineOf
  , arcOf
  , regionIn
    -- * Vertices
  , LineId (..)
  , TangentLine (..)
  , Tangency (..)
  , Touch (..)
  , touchFlanks
    -- * Edges
  , ArcId (..)
  , Arc (..)
  , arcTurns
  , ClosedCurve (..)
    -- * Faces
  , RegionId (..)
  , Region (..)
  , Aspect (..)
  , aspectPolygons
  , ArcChain (..)
  , arcsOfChain
  , isBackwards
    -- * Labels
  , PolygonLabel (..)
  , polygonLabel
  ) where

import qualified Data.Vector as V
import Visibility.Complex.Quotient.Union
import Visibility.Complex.Type
import Visibility.Scene
import Visibility.View (Flank (..))

-- | The quotient of a complex in which all sides of a polygon count as one object.
data Quotient
  = -- | Of convex polygons (flat corners allowed) and thin walls under the sky: a complex again.
    ConvexQuotient !Complex !Union !Convex
  | -- | Of any other scene: regions only, for there the curves have free ends, a region may touch itself along an edge,
    -- and may have several first or last vertices, or none.
    UnionQuotient !Complex !Union

-- | The faces of each region, in every quotient.
quotientUnion :: Quotient -> Union
quotientUnion (ConvexQuotient _ union _) = union
quotientUnion (UnionQuotient _ union) = union

-- | All regions, in the order of their least faces.
regionIds :: Quotient -> [RegionId]
regionIds quotient = map RegionId [0 .. regionCount (quotientUnion quotient) - 1]

-- | The polygons at back and front of a region: in a 'ConvexQuotient' as it is at its first vertex, else as its least
-- face is at its own.
regionPolygons :: Quotient -> RegionId -> (PolygonLabel, PolygonLabel)
regionPolygons (ConvexQuotient _ _ convex) r = (regionBack region, regionFront region)
  where
    region = regionIn convex r
regionPolygons (UnionQuotient complex union) r = case regionMembers union r of
  f : _ -> (label (faceBack complex f), label (faceFront complex f))
  [] -> (OfSky, OfSky)
  where
    label = polygonLabel (complexScene complex)

-- | The tables of the polygon-labelled complex.
data Convex = Convex
  { tangentLines :: !(V.Vector TangentLine)
  , arcs :: !(V.Vector Arc)
  , closedCurves :: ![ClosedCurve]
  -- ^ Of polygons that no tangent line touches together with another one: of a polygon that is alone.
  , regions :: !(V.Vector Region)
  }

-- | All vertices, in the order of the vertices of the complex.
lineIds :: Convex -> [LineId]
lineIds convex = map LineId [0 .. V.length (tangentLines convex) - 1]

-- | All edges. Those that begin at one vertex follow each other, in the order of the tangencies along the line; of a
-- thin wall on the line 'Above' comes first.
arcIds :: Convex -> [ArcId]
arcIds convex = map ArcId [0 .. V.length (arcs convex) - 1]

lineOf :: Convex -> LineId -> TangentLine
lineOf convex (LineId i) = tangentLines convex V.! i

arcOf :: Convex -> ArcId -> Arc
arcOf convex (ArcId i) = arcs convex V.! i

regionIn :: Convex -> RegionId -> Region
regionIn convex (RegionId i) = regions convex V.! i

-- | A vertex of the quotient, from 0.
newtype LineId = LineId Int
  deriving (Eq, Ord, Show)

-- | A vertex: a maximal free segment that is tangent to two polygons or more.
data TangentLine = TangentLine
  { lineVertex :: !VertexId
  -- ^ The same segment in the side-labelled complex.
  , lineTangencies :: ![Tangency]
  -- ^ All of them, in their order along the line. Where the segment ends at a corner, it is not tangent.
  , lineArcs :: ![ArcId]
  -- ^ The edges that begin here, one for each flank of each tangency.
  }
  deriving (Eq, Show)

-- | A polygon that a line is tangent to.
data Tangency = Tangency
  { tangencyPolygon :: !PolygonId
  , tangencyCorner :: !CornerId
  -- ^ Where it touches; of a whole side on the line the left end.
  , tangencyTouch :: !Touch
  }
  deriving (Eq, Ord, Show)

-- | On which flank of a line a polygon lies that it touches.
data Touch
  = OneFlank !Flank
  | -- | A thin wall on the line: two tangencies at one position.
    BothFlanks
  deriving (Eq, Ord, Show)

-- | 'Above' before 'Below'.
touchFlanks :: Touch -> [Flank]
touchFlanks (OneFlank flank) = [flank]
touchFlanks BothFlanks = [Above, Below]

-- | An edge of the quotient, from 0.
newtype ArcId = ArcId Int
  deriving (Eq, Ord, Show)

-- | An edge: a part of the curve of the lines that touch a polygon from one flank, between two vertices. On the way the
-- point of contact may slide along sides. Over the end of the half turn (P, Above) goes over into (P, Below).
data Arc = Arc
  { arcPolygon :: !PolygonId
  , arcFlank :: !Flank
  -- ^ Where the polygon lies where the arc begins.
  , arcFirst :: !LineId
  , arcLast :: !LineId
  , arcAcross :: !Aspect
  -- ^ The face on the other flank; the three faces are as they are where the arc begins.
  , arcBack :: !Aspect
  -- ^ The face on the polygon's flank behind the contact.
  , arcFront :: !Aspect
  -- ^ The face on the polygon's flank beyond the contact. It may be the same as behind, half turns later.
  , arcStretches :: ![EdgeId]
  -- ^ In the order of direction.
  }
  deriving (Eq, Show)

-- | How often the edge goes on over the end of the half turn: an edge may span more than half a turn, so twice at most.
arcTurns :: Complex -> Arc -> Int
arcTurns complex = length . filter (wrapsAround complex) . arcStretches

-- | The whole curve of a polygon without a vertex: all lines tangent to it, half a turn with the polygon on one flank,
-- half a turn on the other.
data ClosedCurve = ClosedCurve
  { curvePolygon :: !PolygonId
  , curveAcross :: !RegionId
  , curveParts :: !RegionId
  -- ^ Behind the contact and beyond it is one face: half a turn later it is read backwards.
  , curveStretches :: ![EdgeId]
  -- ^ In the order of direction, from any one of those that lie 'Below' over the end of the half turn.
  }
  deriving (Eq, Show)

-- | A face: a connected set of maximal free segments with the same polygons at their ends.
data Region = Region
  { regionBack :: !PolygonLabel
  -- ^ As the face is at its first vertex.
  , regionFront :: !PolygonLabel
  , regionFirst :: !(Maybe LineId)
  -- ^ 'Nothing' for the lines that miss everything, and for all faces of a polygon that is alone.
  , regionLast :: !(Maybe LineId)
  , regionUpper :: !ArcChain
  -- ^ Empty for the lines that miss everything.
  , regionLower :: !ArcChain
  , regionFaces :: ![FaceId]
  -- ^ The side-labelled faces that it consists of.
  }
  deriving (Eq, Show)

-- | A face as it is met at some direction.
--
-- A face of the quotient may span more than half a turn, even more than a full one: lines from a polygon to the sky
-- pass another polygon on either flank, and between the two they have turned all around the first. So a line may meet
-- a face more than once, and an edge may bound it more than once.
data Aspect = Aspect
  { aspectRegion :: !RegionId
  , aspectTurns :: !Int
  -- ^ How often the face has gone on over the end of the half turn since its first vertex.
  }
  deriving (Eq, Ord, Show)

-- | After an odd number of half turns, back and front, above and below are exchanged.
isBackwards :: Int -> Bool
isBackwards = odd

-- | The polygons at back and front of a face as it is met.
aspectPolygons :: Convex -> Aspect -> (PolygonLabel, PolygonLabel)
aspectPolygons convex (Aspect r turns)
  | isBackwards turns = (regionFront region, regionBack region)
  | otherwise = (regionBack region, regionFront region)
  where
    region = regionIn convex r

-- | A chain of a face, in the order of direction: the edges, each with the number of half turns at which it begins,
-- counted as in 'Aspect'. Where that is odd the face is read backwards, and the edge bounds it from the other flank.
-- The closed chain of the lines that miss everything begins with any edge.
newtype ArcChain = ArcChain [(ArcId, Int)]
  deriving (Eq, Show)

-- | All edges of a chain.
arcsOfChain :: ArcChain -> [ArcId]
arcsOfChain (ArcChain found) = map fst found
