-- | Which side-labelled faces are one when sides of a polygon count as one object: connected components, by union-find.
module Visibility.Complex.Quotient.Union
  ( -- * Labels
    PolygonLabel (..)
  , polygonLabel
  , polygonOfCorner
    -- * Unions
  , Union
  , RegionId (..)
  , uniteFaces
  , regionOf
  , turnsAt
  , regionMembers
  , regionCount
  ) where

import Control.Monad (forM_, when)
import Control.Monad.ST (ST, runST)
import Data.Int (Int32, Int8)
import Data.Maybe (isNothing)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Complex.Type
import Visibility.Scene
import Visibility.View (End (..), Flank (..), View (..))

-- | What ends a free segment, by polygon.
data PolygonLabel = OfPolygon !PolygonId | OfSky
  deriving (Eq, Ord, Show)

-- | The polygon that an object belongs to.
polygonLabel :: Scene -> Object -> PolygonLabel
polygonLabel scene (Side s) = let SideName p _ = sideName scene s in OfPolygon p
polygonLabel _ Sky = OfSky

-- | The polygon that a corner belongs to; where polygons touch, one of them.
polygonOfCorner :: Scene -> CornerId -> PolygonId
polygonOfCorner scene c = case cornerName scene c of CornerName p _ -> p

-- | A disjoint union of the faces into regions.
--
-- A region is wound around the half turn: going along it over the end of the half turn, one reads it backwards from
-- there on, and may come again to directions where one has been. So it counts half turns, from its least face on.
data Union = Union
  { faceRegions :: !(U.Vector Int32)
  , faceTurns :: !(U.Vector Int32)
  -- ^ The half turns from the first vertex of the region's least face to that of this one.
  , quarterTurns :: !(U.Vector Int8)
  -- ^ By quarter of a stretch, 1 where the face has gone on over the end of the half turn since its own first vertex.
  , members :: !(V.Vector [FaceId])
  }

-- | A face of the quotient, from 0.
newtype RegionId = RegionId Int
  deriving (Eq, Ord, Show)

-- | The region of a face.
regionOf :: Union -> FaceId -> RegionId
regionOf union (FaceId f) = RegionId (fromIntegral (faceRegions union U.! f))

-- | The faces of a region, ascending.
regionMembers :: Union -> RegionId -> [FaceId]
regionMembers union (RegionId r) = members union V.! r

-- | The number of regions.
regionCount :: Union -> Int
regionCount = V.length . members

-- | The half turns that the region on a quarter of a stretch has gone on where the stretch begins. Odd where it is read
-- backwards: back and front, above and below exchanged.
turnsAt :: Union -> EdgeId -> Quarter -> FaceId -> Int
turnsAt union e quarter (FaceId f) = fromIntegral (faceTurns union U.! f) + turnsOf (quarterTurns union) e quarter

-- | The finest union in which faces on opposite flanks of a stretch are one if their segments end at the same polygons.
--
-- /Degenerate cases/ a thin wall is taken as a polygon of infinitesimal thickness: while the line turns through the
-- wall, the face that ends at it stays the same if nothing else on the line lies beyond that end of the wall. The two
-- faces have nothing but one point in common there.
--
-- /Cost/ O(F + S log F) for F faces and S stretches.
--
-- /Law/ in a scene of convex polygons and thin walls, the components of the segments by polygons (Orti, Rivière,
-- Durand, Puech); 'Visibility.Complex.Quotient.quotientLaws'.
uniteFaces :: Complex -> Union
uniteFaces complex =
  Union
    { faceRegions = U.map (\f -> numbers U.! fromIntegral f) least
    , faceTurns = turns
    , quarterTurns = table
    , members =
        V.map reverse (V.accum (flip (:)) (V.replicate (U.length leaders) []) (zip regions (faceIds complex)))
    }
  where
    faces = length (faceIds complex)
    table = countedTurns complex
    (least, turns) = runST $ do
      forest <- Forest <$> U.unsafeThaw (U.enumFromN 0 faces) <*> M.replicate faces 0
      forM_ (joins complex table) (unite forest)
      forM_ [0 .. faces - 1] (root forest)
      (,) <$> U.unsafeFreeze (parents forest) <*> U.unsafeFreeze (offsets forest)
    leaders = U.filter (\f -> fromIntegral (least U.! f) == f) (U.enumFromN 0 faces)
    numbers = U.replicate faces (-1) U.// zip (U.toList leaders) [0 :: Int32 ..]
    regions = map (\f -> fromIntegral (numbers U.! fromIntegral (least U.! f))) [0 .. faces - 1]

-- | By face: one of its class, itself for the root, and the half turns from that one to this.
data Forest s = Forest {parents :: !(M.MVector s Int32), offsets :: !(M.MVector s Int32)}

-- | A face, and half turns since its own first vertex.
data Place = Place !Int !Int

-- | Makes the lesser of two roots the root of the other, so that two places are one.
unite :: Forest s -> (Place, Place) -> ST s ()
unite forest (Place f m, Place g n) = do
  (a, fromA) <- root forest f
  (b, fromB) <- root forest g
  let ahead = fromA + fromIntegral m - fromB - fromIntegral n
  case compare a b of
    LT -> hang b a ahead
    GT -> hang a b (negate ahead)
    EQ -> pure ()
  where
    hang child parent offset = do
      M.write (parents forest) child (fromIntegral parent)
      M.write (offsets forest) child offset

-- | The root of a face's class, and the half turns from it. Makes it the parent of all on the way.
root :: Forest s -> Int -> ST s (Int, Int32)
root forest i = do
  parent <- fromIntegral <$> M.read (parents forest) i
  offset <- M.read (offsets forest) i
  if parent == i
    then pure (i, 0)
    else do
      (top, above) <- root forest parent
      M.write (parents forest) i (fromIntegral top)
      M.write (offsets forest) i (offset + above)
      pure (top, offset + above)

-- | 'quarterTurns', by the chains that name the stretch.
countedTurns :: Complex -> U.Vector Int8
countedTurns complex = U.create $ do
  table <- M.replicate (4 * length (stretchIds complex)) 0
  forM_ (faceIds complex) $ \f -> do
    let Chain upper upperAfter = upperChain complex f
        Chain lower lowerAfter = lowerChain complex f
        enter quarters value e@(EdgeId s) =
          forM_ quarters $ \quarter ->
            when (faceAt complex e quarter == Just f) (M.write table (4 * s + fromEnum quarter) value)
    forM_ upper (enter belowIt 0)
    forM_ upperAfter (enter aboveIt 1)
    forM_ lower (enter aboveIt 0)
    forM_ lowerAfter (enter belowIt 1)
  pure table
  where
    aboveIt = [AboveBack, AboveFront]
    belowIt = [BelowBack, BelowFront]

turnsOf :: U.Vector Int8 -> EdgeId -> Quarter -> Int
turnsOf table (EdgeId e) quarter = fromIntegral (table U.! (4 * e + fromEnum quarter))

-- | The places that are to be one.
joins :: Complex -> U.Vector Int8 -> [(Place, Place)]
joins complex table =
  [ pair
  | e <- stretchIds complex
  , above <- [AboveBack, AboveFront]
  , below <- [BelowBack, BelowFront]
  , Just found <- [labelAt e above]
  , Just found == labelAt e below
  , pair <- zip (placeOn e above) (placeOn e below)
  ]
    <> concatMap (wallJoins complex placeOn) (vertexIds complex)
  where
    labelAt e = quarterLabel scene (edgeCorner complex e) (edgeView complex e)
    scene = complexScene complex
    placeOn e quarter = [Place f (turnsOf table e quarter) | Just (FaceId f) <- [faceAt complex e quarter]]

-- | The faces that end at a thin wall on the line, before and after it.
wallJoins :: Complex -> (EdgeId -> Quarter -> [Place]) -> VertexId -> [(Place, Place)]
wallJoins complex placeOn v = concat (zipWith3 wall [0 ..] after (drop 1 after))
  where
    scene = complexScene complex
    after = vertexEdgesAfter complex v
    count = length after
    wall :: Int -> EdgeId -> EdgeId -> [(Place, Place)]
    wall i p q
      | nextCorner scene (edgeCorner complex p) /= edgeCorner complex q = []
      | previousCorner scene (edgeCorner complex p) /= edgeCorner complex q = []
      | otherwise =
          (if i == 0 || (i == 1 && isNothing (vertexBack complex v)) then same Back p else [])
            <> (if i == count - 2 || (i == count - 3 && isNothing (vertexFront complex v)) then same Front q else [])
    same end e =
      [ (now, earlier)
      | let before = edgeBefore complex e
      , Just flank <- [tangentFlank (edgeView complex e)]
      , let (flankThere, endThere, turned)
              | wrapsAround complex before = (flank, otherEnd end, 1)
              | otherwise = (otherFlank flank, end, 0)
      , seenAt endThere (edgeView complex before) == seenAt end (edgeView complex e)
      , now <- placeOn e (quarterOn flank end)
      , Place f m <- placeOn before (quarterOn flankThere endThere)
      , let earlier = Place f (m + turned)
      ]
    seenAt end view = case (view, end) of
      (Tangent _ back _, Back) -> Just (polygonLabel scene back)
      (Tangent _ _ front, Front) -> Just (polygonLabel scene front)
      _ -> Nothing
    tangentFlank (Tangent flank _ _) = Just flank
    tangentFlank _ = Nothing
    otherFlank flank = if flank == Above then Below else Above
    otherEnd end = if end == Back then Front else Back

quarterOn :: Flank -> End -> Quarter
quarterOn Above Back = AboveBack
quarterOn Above Front = AboveFront
quarterOn Below Back = BelowBack
quarterOn Below Front = BelowFront

-- | The polygons at the ends of the segments on a quarter of a corner's curve; 'Nothing' in the solid, and at a buried
-- corner, where only one flank has a face.
quarterLabel :: Scene -> CornerId -> View -> Quarter -> Maybe (PolygonLabel, PolygonLabel)
quarterLabel scene c view quarter = case (view, quarter) of
  (Tangent Above b _, AboveBack) -> Just (polygonLabel scene b, arriving)
  (Tangent Above _ f, AboveFront) -> Just (leaving, polygonLabel scene f)
  (Tangent Below b _, BelowBack) -> Just (polygonLabel scene b, leaving)
  (Tangent Below _ f, BelowFront) -> Just (arriving, polygonLabel scene f)
  (Tangent _ b f, _) -> Just (polygonLabel scene b, polygonLabel scene f)
  (Ending Front b, AboveBack) -> Just (polygonLabel scene b, arriving)
  (Ending Front b, BelowBack) -> Just (polygonLabel scene b, leaving)
  (Ending Back f, AboveFront) -> Just (leaving, polygonLabel scene f)
  (Ending Back f, BelowFront) -> Just (arriving, polygonLabel scene f)
  (Ending _ _, _) -> Nothing
  (Buried _, _) -> Nothing
  where
    CornerId start = c
    CornerId before = previousCorner scene c
    leaving = polygonLabel scene (Side (SideId start))
    arriving = polygonLabel scene (Side (SideId before))
