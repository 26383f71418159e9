-- | The tables of the polygon-labelled complex of a convex scene, from those of the side-labelled one.
module Visibility.Complex.Quotient.Convex
  ( isConvexScene
  , convexTables
  ) where

import Control.Monad (forM_)
import Data.Int (Int32)
import Data.List (groupBy, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (isNothing, listToMaybe, mapMaybe)
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Complex.Quotient.Type
import Visibility.Complex.Quotient.Union
import Visibility.Complex.Type
import Visibility.Exact.Predicate
import Visibility.Law (broken)
import Visibility.Scene
import Visibility.Scene.Raw (Form (..))
import Visibility.View (Flank (..), View (..))

-- | Are there only convex polygons and thin walls of two corners under the sky, none of which touches another? A flat
-- corner is convex. /Cost/ O(n).
isConvexScene :: Scene -> Bool
isConvexScene scene =
  surroundings scene == OpenSky
    && sceneContacts scene == 0
    && all ((\polygon -> polygonForm polygon == Ring || length (polygonPoints polygon) == 2)) (scenePolygons scene)
    && all convex (corners scene)
  where
    convex c@(CornerId b) = isWallEnd scene c || turn (scenePoints scene) a b d /= RightTurn
      where
        CornerId a = previousCorner scene c
        CornerId d = nextCorner scene c

-- | One polygon on the line of a vertex: its left corner there, and the tangent stretches of its curves that end and
-- begin at the vertex, with the flank that they have there.
data Meeting = Meeting
  { meetingPolygon :: !PolygonId
  , meetingCorner :: !CornerId
  , arriving :: ![(Flank, EdgeId)]
  , departing :: ![(Flank, EdgeId)]
  }

-- | The vertices, edges and faces of the quotient.
--
-- /Requires/ 'isConvexScene', and the union of the faces of this complex. /Cost/ O(S log S) for S stretches.
convexTables :: Complex -> Union -> Convex
convexTables complex union =
  Convex
    { tangentLines = V.fromList (zipWith3 line ids lineStarts found)
    , arcs = arcTable
    , closedCurves = aloneCurves
    , regions = V.map fst made
    }
  where
    scene = complexScene complex
    meetings = [(v, tangentMeetings complex v) | v <- vertexIds complex]
    found = [(v, met) | (v, met) <- meetings, length met >= 2]
    ids = map LineId [0 ..]
    starts = [[(meeting, flank, e) | meeting <- met, (flank, e) <- departing meeting] | (_, met) <- found]
    lineStarts = scanl (+) 0 (map length starts)
    line _ from (v, met) =
      TangentLine
        { lineVertex = v
        , lineTangencies = [Tangency (meetingPolygon m) (meetingCorner m) (touch m) | m <- met]
        , lineArcs = map ArcId [from .. from + sum (map (length . departing) met) - 1]
        }
    touch meeting = case departing meeting of
      [(flank, _)] -> OneFlank flank
      _ -> BothFlanks

    -- By stretch: the next one of its curve; by vertex: its number in the quotient.
    following = follower (followers complex (concatMap snd meetings))
    numbers = Map.fromDistinctAscList [(v, i) | (i, (v, _)) <- zip ids found]
    numberAt v = Map.lookup v numbers

    -- Half turns are counted as the union does until the first vertices of regions are known.
    drafts = V.fromList [arc i m flank e | (i, begun) <- zip ids starts, (m, flank, e) <- begun]
    arcTable = V.map final drafts
    final a = a {arcAcross = seen (arcAcross a), arcBack = seen (arcBack a), arcFront = seen (arcFront a)}
    seen (Aspect r@(RegionId k) turns) = Aspect r (turns - snd (made V.! k))
    arc i meeting flank e =
      Arc
        { arcPolygon = meetingPolygon meeting
        , arcFlank = flank
        , arcFirst = i
        , arcLast = end
        , arcAcross = met (across flank)
        , arcBack = met (behind flank)
        , arcFront = met (beyond flank)
        , arcStretches = parts
        }
      where
        (parts, end) = walk e
        met = aspectAt e
    walk e = case numberAt (edgeLast complex e) of
      Just end -> ([e], end)
      Nothing -> let (rest, end) = walk (following e) in (e : rest, end)
    aspectAt e quarter = case faceAt complex e quarter of
      Just f -> Aspect (regionOf union f) (turnsAt union e quarter f)
      Nothing -> broken "a tangent stretch has a face on every quarter" (show e)
    regionAt e = aspectRegion . aspectAt e

    made = V.generate (regionCount union) (region complex union drafts incidences . RegionId)
    incidences = incidencesByRegion (regionCount union) drafts

    aloneCurves =
      [ ClosedCurve (polygonId polygon) (regionAt e (across Below)) (regionAt e (behind Below)) (around e)
      | polygon <- scenePolygons scene
      , polygonId polygon `Set.notMember` touched
      , Just e <- [listToMaybe (mapMaybe wrapping (cornersByPolygon (polygonId polygon)))]
      ]
    cornersByPolygon p = [c | c <- corners scene, polygonOfCorner scene c == p]
    touched = Set.fromList [meetingPolygon m | (_, met) <- found, m <- met]
    wrapping c = case edgeView complex e of
      Tangent Below _ _ -> Just e
      _ -> Nothing
      where
        e = lastEdgeOf complex c
    around e = e : takeWhile (/= e) (drop 1 (iterate following e))

across, behind, beyond :: Flank -> Quarter
across flank = if flank == Above then BelowBack else AboveBack
behind flank = if flank == Above then AboveBack else BelowBack
beyond flank = if flank == Above then AboveFront else BelowFront

-- | The polygons that the line of a vertex is tangent to, in order. Their corners follow each other on the line.
tangentMeetings :: Complex -> VertexId -> [Meeting]
tangentMeetings complex v =
  filter
    (not . null . departing)
    (mapMaybe meeting (groupBy samePolygon (vertexEdgesAfter complex v)))
  where
    scene = complexScene complex
    owner = polygonOfCorner scene . edgeCorner complex
    samePolygon d e = owner d == owner e
    meeting [] = Nothing
    meeting (e : rest) =
      Just
        Meeting
          { meetingPolygon = owner e
          , meetingCorner = edgeCorner complex e
          , arriving = [(flank, d) | d <- map (edgeBefore complex) (e : rest), Just flank <- [flankAtEnd d]]
          , departing = inOrder [(flank, d) | d <- e : rest, Just flank <- [flankOf d]]
          }
    -- Above before below.
    inOrder [(Below, d), (Above, e)] = [(Above, e), (Below, d)]
    inOrder found = found
    flankOf e = case edgeView complex e of
      Tangent flank _ _ -> Just flank
      _ -> Nothing
    flankAtEnd e = (if wrapsAround complex e then otherFlank else id) <$> flankOf e

otherFlank :: Flank -> Flank
otherFlank flank = if flank == Above then Below else Above

-- | By tangent stretch, the one that goes on on the same curve where it ends: of the same corner, or of the one that
-- the contact slides to along a side. −1 for other stretches.
followers :: Complex -> [Meeting] -> U.Vector Int32
followers complex meetings = U.create $ do
  table <- M.replicate (length (stretchIds complex)) (-1)
  forM_ meetings $ \meeting ->
    sequence_
      [ M.write table d (fromIntegral c)
      | (flank, EdgeId d) <- arriving meeting
      , (flank', EdgeId c) <- departing meeting
      , flank == flank'
      ]
  pure table

follower :: U.Vector Int32 -> EdgeId -> EdgeId
follower table (EdgeId e)
  | next < 0 = broken "the curve of a convex polygon goes on at every vertex" (show e)
  | otherwise = EdgeId (fromIntegral next)
  where
    next = table U.! e

-- | An edge on the boundary of a face: the half turns that the face has gone on where the edge begins, the edge, and
-- whether it bounds the face from above or from below, as the face reads itself after an even number of half turns.
data Incidence = Incidence !Int !ArcId !Bound

data Bound = Upper | Lower
  deriving (Eq)

otherBound :: Bound -> Bound
otherBound bound = if bound == Upper then Lower else Upper

-- | The edges around each region, in the order of direction.
--
-- Vertices come in an order in which they follow each other along every curve. So the edges of a chain follow each
-- other by id, within a half turn.
incidencesByRegion :: Int -> V.Vector Arc -> V.Vector [Incidence]
incidencesByRegion count table =
  V.map
    (sortOn (\(Incidence turns a _) -> (turns, a)))
    (V.accum (flip (:)) (V.replicate count []) (concat (zipWith around [0 ..] (V.toList table))))
  where
    around a arc =
      [ (r, Incidence turns (ArcId a) (if isBackwards turns then otherBound bound else bound))
      | (Aspect (RegionId r) turns, bound) <- zip [arcAcross arc, arcBack arc, arcFront arc] (bounds (arcFlank arc))
      ]
    bounds flank = if flank == Above then [Upper, Lower, Lower] else [Lower, Upper, Upper]

-- | A face with its chains, and the half turns to its first vertex from where the union counts.
region :: Complex -> Union -> V.Vector Arc -> V.Vector [Incidence] -> RegionId -> (Region, Int)
region complex union table incidences r@(RegionId i)
  | any (isNothing . faceFirst complex) faces =
      (Region OfSky OfSky Nothing Nothing (ArcChain []) (chain Lower 0) faces, 0)
  | otherwise = case incidences V.! i of
      [] -> (Region (label faceBack) (label faceFront) Nothing Nothing (ArcChain []) (ArcChain []) faces, 0)
      Incidence turns first _ : _ ->
        let (above, below) = if isBackwards turns then (Lower, Upper) else (Upper, Lower)
            (back, front) = labelAt complex (Aspect r turns) (arc first)
         in ( Region
                { regionBack = back
                , regionFront = front
                , regionFirst = Just (arcFirst (arc first))
                , regionLast = Just (foldl (\_ (a, _) -> arcLast (arc a)) (arcFirst (arc first)) (found above turns))
                , regionUpper = chain above turns
                , regionLower = chain below turns
                , regionFaces = faces
                }
            , turns
            )
  where
    faces = regionMembers union r
    arc (ArcId a) = table V.! a
    chain bound = ArcChain . found bound
    found bound from = [(a, turns - from) | Incidence turns a bound' <- incidences V.! i, bound' == bound]
    label end = maybe OfSky (polygonLabel (complexScene complex) . end complex) (listToMaybe faces)

-- | The label of a face as it is met by an edge, where the edge begins.
labelAt :: Complex -> Aspect -> Arc -> (PolygonLabel, PolygonLabel)
labelAt complex aspect arc = case map (edgeView complex) (take 1 (arcStretches arc)) of
  [Tangent _ back front]
    | arcAcross arc == aspect -> (label back, label front)
    | arcBack arc == aspect -> (label back, OfPolygon (arcPolygon arc))
    | otherwise -> (OfPolygon (arcPolygon arc), label front)
  _ -> broken "an edge of the quotient begins with a tangent stretch" (show arc)
  where
    label = polygonLabel (complexScene complex)
