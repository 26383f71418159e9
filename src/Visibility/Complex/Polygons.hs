-- | The complex of polygons: the complex of Orti, Rivière, Durand and Puech, in which a face knows the polygons at the
-- ends of its segments, not their sides.
--
-- It is made of the side-labelled complex and numbered as a function of the scene alone. In every scene its faces are
-- unions of side-labelled ones. In a scene of convex polygons and thin walls under the sky it has vertices, edges and
-- chains as well; docs/complex.md says why others have none.
--
-- /Source/ Orti, Rivière, Durand, Puech, Using the visibility complex for radiosity computation, §3; thin walls, flat
-- corners and degenerate vertices derived for this project. What holds of it: "Visibility.Complex.Law.Polygons".
module Visibility.Complex.Polygons
  ( -- * The complex
    PolygonComplex (..)
  , polygonComplex
  , Outlines (..)
    -- * Vertices
  , LineId (..)
  , TangentLine (..)
  , Tangency (..)
    -- * Edges
  , ArcId (..)
  , Arc (..)
  , arcTurns
  , arcFaces
  , Aspect (..)
    -- * Faces
  , RegionId (..)
  , Region (..)
  , Boundary (..)
    -- * Labels
  , PolygonLabel (..)
  , polygonLabel
  , polygonOfCorner
    -- * Half turns
  , flankAfter
  ) where

import Control.Monad.ST (runST)
import Data.Function (on)
import Data.List (groupBy, nub, sort, sortOn)
import Data.Maybe (isNothing, listToMaybe, mapMaybe)
import Data.Ord (comparing)
import Data.Tuple (swap)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Complex.Canonical
import Visibility.Complex.Reading
import Visibility.Complex.Table
import Visibility.Complex.Type
import Visibility.Exact.Predicate
import Visibility.Law (broken)
import Visibility.Scene
import Visibility.Scene.Raw (Form (..))
import Visibility.Sorting
import Visibility.Sweep.Vertical (objectAt)
import Visibility.View (End (..), Flank (..), View (..))

-- | The complex in which all sides of a polygon count as one object.
data PolygonComplex = PolygonComplex
  { sideComplex :: !Complex
  , regions :: !(V.Vector Region)
  -- ^ The faces by 'RegionId', in the canonical order of the first of their side-labelled faces.
  , outlines :: !(Maybe Outlines)
  -- ^ Of convex polygons, flat corners allowed, and thin walls of two corners, none of which touches another, under the
  -- sky. Elsewhere curves have free ends, and a region may touch itself along an edge, and have several first or last
  -- vertices, or none.
  }

-- | Vertices and edges, and what bounds the faces.
data Outlines = Outlines
  { tangentLines :: !(V.Vector TangentLine)
  -- ^ The vertices by 'LineId', in canonical order.
  , arcs :: !(V.Vector Arc)
  -- ^ The edges by 'ArcId', by their first vertices, then in the order of the tangencies along the line; of a thin wall
  -- on the line 'Above' comes first. The curve of a polygon that is alone is one edge.
  , boundaries :: !(V.Vector Boundary)
  -- ^ By 'RegionId'.
  }

newtype LineId = LineId Int deriving (Eq, Ord, Show)

newtype ArcId = ArcId Int deriving (Eq, Ord, Show)

newtype RegionId = RegionId Int deriving (Eq, Ord, Show)

-- | A vertex: a maximal free segment that is tangent to two polygons or more, all of them in order. Where the segment
-- ends at a corner, it is not tangent. The line of a side or wall alone is no vertex: the contact slides along.
data TangentLine = TangentLine
  { lineVertex :: !VertexId
  , lineTangencies :: ![Tangency]
  }
  deriving (Eq, Show)

-- | A polygon that a line is tangent to.
data Tangency = Tangency
  { tangencyPolygon :: !PolygonId
  , tangencyCorner :: !CornerId
  -- ^ Where it touches; of a whole side on the line the left end.
  , tangencyFlanks :: ![Flank]
  -- ^ The flank on which the polygon lies just after the vertex; both, 'Above' first, of a thin wall on the line.
  }
  deriving (Eq, Ord, Show)

-- | An edge: a part of the curve of the lines that touch a polygon from one flank, between two vertices. On the way the
-- point of contact may slide along sides. Over the end of the half turn (P, Above) goes over into (P, Below).
data Arc = Arc
  { arcPolygon :: !PolygonId
  , arcFlank :: !Flank
  -- ^ Where the polygon lies where the arc begins.
  , arcFirst :: !(Maybe LineId)
  -- ^ 'Nothing' for the closed curve of a polygon that is alone.
  , arcLast :: !(Maybe LineId)
  , arcAcross :: {-# UNPACK #-} !Aspect
  -- ^ The face on the other flank; the three faces are as they are where the arc begins.
  , arcBack :: {-# UNPACK #-} !Aspect
  -- ^ The face on the polygon's flank behind the contact.
  , arcFront :: {-# UNPACK #-} !Aspect
  -- ^ The face on the polygon's flank beyond the contact. It may be the same as behind, half turns later.
  , arcStretches :: ![EdgeId]
  -- ^ In the order of direction. A closed curve begins with the one that lies 'Below' over the end of the half turn.
  }
  deriving (Eq, Show)

-- | How often the edge goes on over the end of the half turn: an edge may span more than half a turn, so twice at most.
arcTurns :: Complex -> Arc -> Int
arcTurns complex = length . filter (wrapsAround complex) . arcStretches

-- | Its three faces: across, behind, beyond.
arcFaces :: Arc -> [Aspect]
arcFaces arc = [arcAcross arc, arcBack arc, arcFront arc]

-- | A face as it is met at some direction, and how often it has gone on over the end of the half turn since its first
-- vertex.
--
-- A face may span more than half a turn, even more than a full one: lines from a polygon to the sky pass another
-- polygon on either flank, and between the two they have turned all around the first. So a line may meet a face more
-- than once, and an edge may bound it more than once.
data Aspect = Aspect {aspectRegion :: !RegionId, aspectTurns :: !Int}
  deriving (Eq, Ord, Show)

-- | A flank as it is read after so many half turns: after an odd number of them, back and front, above and below are
-- exchanged.
flankAfter :: Int -> Flank -> Flank
flankAfter turns flank
  | odd turns = if flank == Above then Below else Above
  | otherwise = flank

-- | A face: a connected set of maximal free segments with the same polygons at their ends.
data Region = Region
  { regionBack :: !PolygonLabel
  -- ^ As the first of its side-labelled faces is.
  , regionFront :: !PolygonLabel
  , regionFaces :: ![FaceId]
  -- ^ The side-labelled faces that it consists of, in the order in which they begin; those after the end of the half
  -- turn, and so on, come later.
  }
  deriving (Eq, Show)

-- | The first and the last vertex of a face, and the chains from one to the other in the order of direction: edges,
-- each with the number of half turns at which it begins, counted as in 'Aspect'. Where that is odd the face is read
-- backwards, and the edge bounds it from the other flank.
--
-- /Degenerate cases/ the lines that miss everything have a closed lower chain, which begins with any edge, and nothing
-- else; those that meet a polygon that is alone have its closed curve in both chains.
data Boundary = Boundary
  { firstLine :: !(Maybe LineId)
  , lastLine :: !(Maybe LineId)
  , upperArcs :: ![(ArcId, Int)]
  , lowerArcs :: ![(ArcId, Int)]
  }
  deriving (Eq, Show)

-- | What ends a free segment, by polygon.
data PolygonLabel = OfPolygon !PolygonId | OfSky
  deriving (Eq, Ord, Show)

-- | The polygon that an object belongs to.
polygonLabel :: Scene -> Object -> PolygonLabel
polygonLabel scene object = case seenAs scene object of
  TheSide (SideName p _) -> OfPolygon p
  TheSky -> OfSky

-- | The polygon that a corner belongs to; where polygons touch, one of them.
polygonOfCorner :: Scene -> CornerId -> PolygonId
polygonOfCorner scene c = case cornerName scene c of CornerName p _ -> p

-- | The complex of polygons, made of the complex of sides.
--
-- /Degenerate cases/ a thin wall is taken as a polygon of infinitesimal thickness: while the line turns through the
-- wall, the face that ends at it stays the same if nothing else on the line lies beyond that end of the wall. A room
-- has no outlines, also where it is convex; its regions are then those of the same polygons under the sky.
--
-- /Requires/ a complex that satisfies its laws; from broken tables it may come to no end.
--
-- /Cost/ O(S log S) for S stretches.
polygonComplex :: Complex -> PolygonComplex
polygonComplex complex = PolygonComplex complex (V.fromList (map region unions)) found
  where
    scene = complexScene complex
    numbering = canonicalNumbering complex
    read' = readings complex
    found
      | isConvexScene scene = Just (outlinesOf complex (orderedVertices numbering) aspect (length unions))
      | otherwise = Nothing
    faces = V.fromList (orderedFaces numbering)
    -- By object, a number for its label.
    owners = denseRanks (comparing (polygonLabel scene . objectAt scene)) (cornerCount scene + 1)
    endsOf (k, turns)
      | odd turns = (owner faceFronts, owner faceBacks)
      | otherwise = (owner faceBacks, owner faceFronts)
      where
        owner table = owners U.! numberAt (table complex) (faces V.! k)
    placesAt e quarter =
      [(faceNumber numbering f, maybe 0 fromEnum (readingAt read' e quarter)) | Just f <- [faceAt complex e quarter]]
    unions = components (V.length faces) [(a, b) | (a, b) <- joins complex placesAt, endsOf a == endsOf b]
    region own = Region back front [faces V.! k | (k, _) <- own]
      where
        (back, front) = case own of
          (k, turns) : _ -> (if odd turns then swap else id) (label faceBack k, label faceFront k)
          [] -> (OfSky, OfSky)
        label side k = polygonLabel scene (side complex (faces V.! k))
    -- By face: its region, and the half turns from the first vertex of the region to its own.
    regionsOf =
      U.replicate (V.length faces) (0, 0) U.// [(k, (r, turns)) | (r, own) <- zip [0 ..] unions, (k, turns) <- own]
    aspect e quarter = case placesAt e quarter of
      (k, more) : _ -> let (r, own) = regionsOf U.! k in Aspect (RegionId r) (own + more)
      [] -> broken "a tangent stretch has a face on every quarter" (show (e, quarter))

-- | A face by its canonical number, and half turns since its own first vertex, or since that of its region.
type Place = (Int, Int)

-- | The components of so many faces, given places that are one. Each has its faces in the order in which they begin,
-- with the half turns from the beginning of the first to theirs; they come in the order of their first faces.
components :: Int -> [(Place, Place)] -> [[Place]]
components count same = sort $ runST $ do
  met <- M.replicate count False
  let reach own [] = pure own
      reach own ((k, turns) : rest) = do
        known <- M.read met k
        M.write met k True
        let next = [(j, turns + more) | not known, (j, more) <- besides k]
        reach (if known then own else (k, turns) : own) (next <> rest)
  map inOrder . filter (not . null) <$> mapM (\k -> reach [] [(k, 0)]) [0 .. count - 1]
  where
    links = U.fromList [(k, (j, m - n)) | (a, b) <- same, ((k, m), (j, n)) <- [(a, b), (b, a)]]
    beside = bucketsBy count (U.map (fromIntegral . fst) links)
    besides k = sort [snd (links U.! i) | i <- bucketOf beside k]
    inOrder own = let start = minimum (map snd own) in sortOn swap [(k, turns - start) | (k, turns) <- own]

-- | The places that are one if their segments end at the same polygons: on opposite flanks of a stretch; and, where a
-- thin wall is on the line and nothing lies beyond one of its ends, at that end before and after the line.
joins :: Complex -> (EdgeId -> Quarter -> [Place]) -> [(Place, Place)]
joins complex placesAt =
  [(above, below) | e <- stretchIds complex, above <- placesOn e Above, below <- placesOn e Below]
    <> [ (now, (k, turns + turned))
       | v <- vertexIds complex
       , let after = vertexEdgesAfter complex v
       , (i, p, q) <- zip3 [0 ..] after (drop 1 after)
       , isWall (edgeCorner complex p) (edgeCorner complex q)
       , (end, e) <-
           [(Back, p) | isLastThing i (vertexBack complex v)]
             <> [(Front, q) | isLastThing (length after - 2 - i) (vertexFront complex v)]
       , Tangent flank _ _ <- [edgeView complex e]
       , let before = edgeBefore complex e
       , let (quarter, turned)
               | wrapsAround complex before = (quarterOn flank (if end == Back then Front else Back), 1)
               | otherwise = (quarterOn (flankAfter 1 flank) end, 0)
       , now <- placesAt e (quarterOn flank end)
       , (k, turns) <- placesAt before quarter
       ]
  where
    scene = complexScene complex
    placesOn e flank = nub (concatMap (placesAt e) (quartersOf flank))
    isWall p q = nextCorner scene p == q && previousCorner scene p == q
    -- Where the segment ends at a corner, that corner is what is seen beyond the end of the wall.
    isLastThing :: Int -> Maybe Object -> Bool
    isLastThing others seen = others == 0 || (others == 1 && isNothing seen)

quarterOn :: Flank -> End -> Quarter
quarterOn flank end = toEnum (2 * fromEnum flank + fromEnum end)

-- | Are there only convex polygons and thin walls of two corners under the sky, none of which touches another? A flat
-- corner is convex. /Cost/ O(n).
isConvexScene :: Scene -> Bool
isConvexScene scene =
  surroundings scene == OpenSky
    && sceneContacts scene == 0
    && all (\polygon -> polygonForm polygon == Ring || length (polygonPoints polygon) == 2) (scenePolygons scene)
    && all convex (corners scene)
  where
    convex c@(CornerId b) = isWallEnd scene c || turn (scenePoints scene) a b d /= RightTurn
      where
        CornerId a = previousCorner scene c
        CornerId d = nextCorner scene c

-- | The outlines, given the vertices of the complex in canonical order, the face on each quarter of a tangent stretch,
-- and the number of regions.
--
-- /Requires/ 'isConvexScene'.
outlinesOf :: Complex -> [VertexId] -> (EdgeId -> Quarter -> Aspect) -> Int -> Outlines
outlinesOf complex order aspect count = Outlines (V.fromList lines') table (V.generate count boundary)
  where
    owner = polygonOfCorner (complexScene complex) . edgeCorner complex
    flanksOf e = [flank | Tangent flank _ _ <- [edgeView complex e]]

    -- The polygons that the line of a vertex is tangent to, each with the tangent stretches that begin there. The
    -- corners of one polygon follow each other on the line.
    tangencies v = mapMaybe tangency (groupBy ((==) `on` owner) (vertexEdgesAfter complex v))
    tangency es = case (es, sort [(flank, e) | e <- es, flank <- flanksOf e]) of
      (e : _, begun@(_ : _)) -> Just (Tangency (owner e) (edgeCorner complex e) (map fst begun), begun)
      _ -> Nothing
    found = [(v, met) | v <- order, let met = tangencies v, length (nub (map (tangencyPolygon . fst) met)) >= 2]
    lines' = [TangentLine v (map fst met) | (v, met) <- found]
    numbers = U.replicate (vertexTotal complex) (-1) U.// zip [v | (VertexId v, _) <- found] [0 ..]
    numberOf (VertexId v) = let i = numbers U.! v in if i < 0 then Nothing else Just (LineId i)

    -- The stretch that goes on on the same curve: of the same corner, or of the one that the contact slides to.
    following e = case [d | d <- near, flank <- flanksOf e, turned flank `elem` flanksOf d] of
      next : _ -> next
      [] -> broken "the curve of a convex polygon goes on at every vertex" (show e)
      where
        turned = flankAfter (fromEnum (wrapsAround complex e))
        (EdgeId first, EdgeId end) = vertexRow complex (edgeLast complex e)
        EdgeId onward = edgeAfter complex e
        near = concatMap (takeWhile ((== owner e) . owner) . map EdgeId) ways'
        ways' = [[onward .. end - 1], [onward - 1, onward - 2 .. first]]

    table = V.fromList (map arc (if null found then closed else concatMap (concatMap snd . snd) found))
    closed = [(Below, e) | c <- corners (complexScene complex), let e = lastEdgeOf complex c, flanksOf e == [Below]]
    arc (flank, e) =
      Arc
        { arcPolygon = owner e
        , arcFlank = flank
        , arcFirst = numberOf (edgeFirst complex e)
        , arcLast = lastOf passed >>= numberOf . edgeLast complex
        , arcAcross = aspect e (quarterOn (flankAfter 1 flank) Back)
        , arcBack = aspect e (quarterOn flank Back)
        , arcFront = aspect e (quarterOn flank Front)
        , arcStretches = passed
        }
      where
        passed = e : takeWhile goesOn (drop 1 (iterate following e))
        goesOn d = d /= e && isNothing (numberOf (edgeFirst complex d))

    -- By edge and side of it, three for each: the region there, and at how many half turns.
    sides' = U.fromList [(r, turns) | one <- V.toList table, Aspect (RegionId r) turns <- arcFaces one]
    incidences = bucketsBy count (U.map (fromIntegral . fst) sides')
    -- In a chain, edges come by half turns. Vertices come by direction, so within a half turn edges come by number. A
    -- flank is where the region is not, as it reads itself after an even number of half turns.
    boundary r = Boundary (listToMaybe upper >>= arcFirst . one) (lastOf upper >>= arcLast . one) upper lower
      where
        one (ArcId a, _) = table V.! a
        (upper, lower) = (on' Above, on' Below)
        on' flank = map swap (sort [(turns, ArcId a) | (turns, a, flank') <- met, flank' == flank])
        met =
          [ (turns, a, flankAfter turns (if i == 0 then across else flankAfter 1 across))
          | k <- bucketOf incidences r
          , let (a, i) = k `quotRem` 3
          , let turns = snd (sides' U.! k)
          , let across = arcFlank (table V.! a)
          ]
    lastOf xs = listToMaybe (reverse xs)
