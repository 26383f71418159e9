-- | The boundary of free space, and what is wrong where polygons touch.
--
-- Where polygons touch, free space comes near to a place in several cones, or in none. Nothing is seen from one cone
-- into another: so the boundary is cut at the place, and each cone gets a corner of its own, with the sides of its own
-- two flanks. What sides cover of each other is no boundary. So the boundary becomes closed walks that share places but
-- never meet, and all that follows is the same for touching polygons as for others.
module Visibility.Scene.Boundary
  ( Boundary (..)
  , freeCorners
  ) where

import Control.Monad (forM_)
import Control.Monad.ST (runST)
import Data.Int (Int32)
import qualified Data.IntMap.Strict as IntMap
import Data.List (sortBy, sortOn)
import Data.Maybe (mapMaybe)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Scene.Outline
import Visibility.Scene.Raw (Form (..))
import Visibility.Scene.Touching
import Visibility.Sorting

-- | The corners of the boundary of free space, in the places of stated corners: where the face of a side, or what is
-- not covered of it, begins if free space is kept on the right. In the order of places; in one place by name, and then
-- by side.
data Boundary = Boundary
  { statedNumbers :: !(U.Vector Int32)
  -- ^ By stated corner: the number of its place among all places with corners, in lexicographic order.
  , freePlaces :: !(U.Vector Int32)
  -- ^ By corner of the boundary: a stated corner in its place.
  , freeNames :: !(U.Vector Int32)
  -- ^ The first of the stated corners in its place that belong to a polygon on one of its flanks.
  , freeSides :: !(U.Vector Int32)
  -- ^ The number of the side that begins there.
  , freeNexts :: !(U.Vector Int32)
  -- ^ The corner where that ends.
  }

-- | A face of a side, or an uncovered piece of it: from one place to another, free space on its right, with the number
-- of the side. Places are given by stated corners.
type Face = (Int32, Int32, Int32)

-- | All corners of the boundary.
--
-- /Degenerate cases/ a stated corner that is all covered has none, one in several cones of free space has several.
-- Where all of a room is filled, there are none.
--
-- /Requires/ a valid scene, and where its polygons touch. /Cost/ O(n) where they do not, else O(n log n), wherever they
-- do: directions around a place are sorted.
freeCorners :: Outline -> Contacts -> Boundary
freeCorners o found
  | contactPlaces found == 0 = wholeSides o
  | otherwise =
      Boundary
        { statedNumbers = places
        , freePlaces = U.map (U.unsafeIndex froms) ordered
        , freeNames = U.map (U.unsafeIndex names) ordered
        , freeSides = U.map (U.unsafeIndex sides) ordered
        , freeNexts = U.map (U.unsafeIndex newNumbers . U.unsafeIndex followers) ordered
        }
  where
    (froms, tos, sides) = U.unzip3 (U.fromList (exposed o (contactCuts found)))
    total = U.length froms
    places = outlineNumbers o
    placed = U.map (U.unsafeIndex places . fromIntegral)
    here = [0 .. placeTotal o - 1]
    -- By place: the faces that begin there, those that end there, and the stated corners.
    starting = bucketsBy (placeTotal o) (placed froms)
    ending = bucketsBy (placeTotal o) (placed tos)
    stated = bucketsBy (placeTotal o) places
    -- The faces by where they begin, place by place and by name in each.
    ordered = U.fromListN total (concatMap (inNameOrder . bucketOf starting) here)
    newNumbers = U.update_ (U.replicate total 0) ordered (U.enumFromN 0 total) :: U.Vector Int32
    inNameOrder fs = if null (drop 1 fs) then fs else sortOn (\f -> (names U.! f, sides U.! f)) fs
    followers = table (concatMap (\x -> followersAt o (faces froms tos x starting) (faces tos froms x ending)) here)
    leaders = U.update_ (U.replicate total 0) followers (U.enumFromN 0 total) :: U.Vector Int
    names = U.map fromIntegral (table (concatMap (\x -> namesAt (bucketOf stated x) (bucketOf starting x)) here))
    table entries = U.update (U.replicate total 0) (U.fromList entries) :: U.Vector Int
    faces near far x buckets = [(f, fromIntegral (near U.! f), fromIntegral (far U.! f)) | f <- bucketOf buckets x]
    -- Of each face, the corner that names where it begins.
    namesAt [only] fs = [(f, only) | f <- fs]
    namesAt corners fs =
      [ (f, if null own then minimum corners else minimum own)
      | f <- fs
      , let own = mapMaybe (\g -> IntMap.lookup (sideOwner g) first) [f, leaders U.! f]
      ]
      where
        first = IntMap.fromListWith min [(ownerOf o i, i) | i <- corners]
    sideOwner f = fromIntegral (sideOwners U.! fromIntegral (sides U.! f)) :: Int
    sideOwners = ownersFrom (sideFirsts o)

-- | With each face that ends in a place, the one that follows it, from those that begin there and those that end; each
-- with a corner in the place and the one at its other end.
--
-- It is the next one counter-clockwise: between the two is a cone of free space. One that leads back the same way comes
-- last, after a full turn.
followersAt :: Outline -> [(Int, Int, Int)] -> [(Int, Int, Int)] -> [(Int, Int)]
followersAt _ [(g, _, _)] [(f, _, _)] = [(f, g)]
followersAt o starting ending = go (take 1 [g | (Starts, (g, _, _)) <- turning]) (reverse turning)
  where
    turning = sortBy order (map ((,) Starts) starting <> map ((,) Ends) ending)
    order (event, (_, x, a)) (event', (_, _, b)) = angleOrder o x a b <> compare event event'
    go _ ((Starts, (g, _, _)) : before) = go [g] before
    go next ((Ends, (f, _, _)) : before) = map ((,) f) next <> go next before
    go _ [] = []

-- | What a face does in a place.
data Event = Starts | Ends
  deriving (Eq, Ord)

-- | 'freeCorners' where nothing meets: each corner of a ring begins its one side there, and on the way back along a
-- wall what follows a face that arrives is the other one that begins there. Done the other way, @graph@ of 20 000
-- quadrilaterals takes 1.3 times the time and 1.8 times the memory.
wholeSides :: Outline -> Boundary
wholeSides o = runST $ do
  corners <- M.new total
  sides <- M.new total
  nexts <- M.new total
  let begins new i side next = do
        M.write corners new (fromIntegral i)
        M.write sides new (fromIntegral side)
        M.write nexts new next
  forM_ (polygonIndices o) $ \p -> case outlineForms o V.! p of
    Ring -> case solidFlank o p of
      OnLeft -> forM_ (cornersOf o p) $ \i -> begins (front i) i (sideNumberOf o firsts i) (news U.! after i)
      _ -> forM_ (cornersOf o p) $ \i -> begins (front (after i)) (after i) (sideNumberOf o firsts i) (news U.! i)
    Polyline -> forM_ (segmentStarts o p) $ \i -> do
      begins (front i) i (sideNumberOf o firsts i) (news U.! after i)
      begins (back (after i)) (after i) (backSideNumberOf o firsts i) (fromIntegral (back i))
  named <- U.unsafeFreeze corners
  Boundary (outlineNumbers o) named named <$> U.unsafeFreeze sides <*> U.unsafeFreeze nexts
  where
    firsts = sideFirsts o
    total = U.sum faces
    -- In the order of places, how many faces begin at each corner: two between the ends of a wall.
    faces = U.map facesAt (outlineOrder o)
    facesAt i = if hasTwo (fromIntegral i) then 2 else 1
    hasTwo i = outlineForms o V.! ownerOf o i == Polyline && not (isEnd i)
    isEnd i = i == outlineFirst o U.! p || i == outlineFirst o U.! (p + 1) - 1
      where
        p = ownerOf o i
    -- By stated corner, the first of its own. It begins the side with the lesser number.
    news = U.update_ (U.replicate (outlineTotal o) 0) (U.map fromIntegral (outlineOrder o)) starts :: U.Vector Int32
    starts = U.map fromIntegral (U.prescanl' (+) 0 faces)
    front i = fromIntegral (news U.! i) :: Int
    back i = if hasTwo i then front i + 1 else front i
    after = around o 1

-- | What lies along a piece between two places, the first the lesser one. Sides by number.
data Occupant
  = -- | A side of a ring with its solid to the left of the way from the lesser place.
    SolidLeft !Int
  | SolidRight !Int
  | -- | A thin wall with its left and its right face.
    Wall !Int !Int

-- | The faces of sides that are not covered, cut where something touches them: at corners, each given with the one
-- that starts the side.
exposed :: Outline -> [(Int, Int)] -> [Face]
exposed o found = concatMap facesOf (IntMap.elems together)
  where
    cuts = IntMap.fromListWith (<>) [(s, [i]) | (i, s) <- found]
    -- What lies along one piece; each is alone where nothing meets.
    together =
      IntMap.fromListWith
        (<>)
        [ (pairOf (numberOf o low) (numberOf o high), [piece])
        | piece@(low, high, _) <- concatMap piecesOf (polygonIndices o)
        ]
    piecesOf p =
      [ (low, high, occupant)
      | s <- segmentStarts o p
      , let t = around o 1 s
      , let onwards = numberOf o s < numberOf o t
      , let occupant = occupantOf s onwards
      , let between = case IntMap.lookup s cuts of
              Nothing -> if onwards then [s, t] else [t, s]
              Just corners -> sortOn (numberOf o) (s : t : corners)
      , (low, high) <- zip between (drop 1 between)
      , numberOf o low /= numberOf o high
      ]
    occupantOf s onwards = case solidFlank o (ownerOf o s) of
      Nowhere
        | onwards -> Wall (back s) (front s)
        | otherwise -> Wall (front s) (back s)
      flank
        | (flank == OnLeft) == onwards -> SolidLeft (front s)
        | otherwise -> SolidRight (front s)
    firsts = sideFirsts o
    front = sideNumberOf o firsts
    back = backSideNumberOf o firsts
    facesOf [] = []
    facesOf occupants@((low, high, _) : _) =
      [face high low side | null leftSolids, side <- take 1 (map fst walls <> rightSolids)]
        <> [face low high side | null rightSolids, side <- take 1 (map snd walls <> leftSolids)]
      where
        leftSolids = [side | (_, _, SolidLeft side) <- occupants]
        rightSolids = [side | (_, _, SolidRight side) <- occupants]
        walls = [(left, right) | (_, _, Wall left right) <- occupants]
    face a b side = (fromIntegral a, fromIntegral b, fromIntegral side)
