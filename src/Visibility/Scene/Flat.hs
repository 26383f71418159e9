-- | A scene with flat corners on its sides, which cut them into elements.
module Visibility.Scene.Flat
  ( withFlatCorners
  ) where

import Data.Int (Int32)
import qualified Data.IntMap.Strict as IntMap
import Data.List (sortBy)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Data.Tuple (swap)
import qualified Data.Vector as V
import qualified Data.Vector.Algorithms.Intro as Intro
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.Point
import Visibility.Scene.Boundary (Boundary (..))
import Visibility.Scene.Id
import Visibility.Scene.Outline (ownersFrom)
import Visibility.Scene.Raw (Form (..))
import Visibility.Scene.Stated
import Visibility.Scene.Type
import Visibility.Sorting

-- | The same scene with corners between the ends of its sides: those that are given for a side or a piece of one, in
-- order from its start to its end. All that is uncovered of a polygon's sides is cut into elements. In the new scene
-- the elements of a polygon count as its sides, numbered from 0: side by side, and along each side as the file has it.
-- A polygon's corners keep their names, and the new ones are numbered on after them, in the order of the elements.
--
-- Nothing else changes: where solid is and where free space, what touches, the lattice. A new corner has a denominator
-- of its own.
--
-- With it come the sides of the given scene that its sides are elements of, in their order.
--
-- /Degenerate cases/ a corner of a thin wall is a corner of both its faces, and cuts both. What is covered of a side is
-- no element.
--
-- /Requires/ points strictly between the ends of each piece. /Cost/ O(n log n) in the corners of the new scene.
--
-- /Laws/ it obeys all laws of a scene; the measures of a side's elements add up to those of the side.
withFlatCorners :: (SideId -> [Point]) -> Scene -> (Scene, [SideName])
withFlatCorners cuts scene = (cut, [sideName scene (SideId (piece walks U.! c)) | c <- U.toList elements])
  where
    walks = walksThrough (cutsOfBothFaces cuts scene) scene
    total = V.length (spots walks)
    -- Corners in one place stay in their order, those of one face of a wall before those of the other.
    sorted = U.modify (Intro.sortBy (\a b -> compareSpots walks a b <> compare a b)) (U.enumFromN 0 total)
    ranks = U.update_ (U.replicate total 0) sorted (U.enumFromN 0 total) :: U.Vector Int32
    onWays = elementStarts scene walks
    elements = U.fromList (map fst onWays)
    (stated, names) = statedAnew scene walks onWays
    byStart = U.update_ (U.replicate total 0) elements (U.enumFromN 0 (U.length elements))
    boundary =
      Boundary
        { statedNumbers = denseRanks (comparePlacesAt (statedPlaces stated)) (placeCount (statedPlaces stated))
        , freePlaces = U.map (names U.!) sorted
        , freeNames = U.map (names U.!) sorted
        , freeSides = U.map (byStart U.!) sorted
        , freeNexts = U.map (\c -> ranks U.! (follower walks U.! c)) sorted
        }
    newOn side = [spots walks V.! c | c <- map (elements U.!) (bucketOf bySide side), c >= oldTotal walks]
    bySide =
      bucketsBy
        (statedSideTotal (sceneStated scene))
        (U.map (\c -> facedSides scene U.! (piece walks U.! c)) elements)
    polygons = zipWith (restated scene newOn) [0 ..] (scenePolygons scene)
    cut =
      underArithmetic (sceneArithmetic scene) $
        sceneOn (sceneTitle scene) (sceneLattice scene) (sceneContacts scene) polygons stated boundary

-- | A polygon, by number, stated with its new corners, which are given by the sides of the file, in the order of each.
restated :: Scene -> (Int -> [LatticePoint]) -> Int -> Polygon -> Polygon
restated scene newOn p polygon =
  polygon {polygonPoints = concat (zipWith (:) (polygonPoints polygon) (map onPiece (take segments [0 ..]) <> [[]]))}
  where
    stated = sceneStated scene
    first = statedSideFirsts stated U.! p
    total = statedSideFirsts stated U.! (p + 1) - first
    segments = case polygonForm polygon of
      Ring -> total
      Polyline -> total `quot` 2
    -- The corners that are new on a side of the file, or on the other face of a piece of a wall.
    onPiece k = case (polygonForm polygon, onSide (first + k)) of
      (Polyline, []) -> reverse (onSide (first + total - 1 - k))
      (_, found) -> found
    onSide = map (fromLattice (sceneLattice scene)) . newOn

-- | The points on each piece, together with those on the other face of it if it is one of a thin wall: there the same
-- two places are joined the other way round.
cutsOfBothFaces :: (SideId -> [Point]) -> Scene -> SideId -> [Point]
cutsOfBothFaces cuts scene = \s -> case Map.lookup (swap (ends s)) faces of
  Just other | more@(_ : _) <- cuts other -> inOrder s (Set.fromList (cuts s <> more))
  _ -> cuts s
  where
    faces = Map.fromList [(ends s, s) | s <- sides scene]
    ends s = (place (sideStart s), place (sideEnd scene s))
    place (CornerId c) = placeNumbers scene U.! c
    inOrder s = if uncurry (<) (ends s) then Set.toAscList else Set.toDescList

-- | The boundary of free space with its new corners. The old corners keep their numbers here, and the new ones come
-- after them, piece by piece.
data Walks = Walks
  { spots :: !(V.Vector LatticePoint)
  , piece :: !(U.Vector Int)
  -- ^ The old corner that starts the piece which a corner starts an element of.
  , chains :: !(V.Vector [Int])
  -- ^ By old corner: the corners at which elements of its piece start, from itself on.
  , follower :: !(U.Vector Int)
  , oldTotal :: !Int
  }

walksThrough :: (SideId -> [Point]) -> Scene -> Walks
walksThrough cuts scene =
  Walks
    { spots = V.fromList (map (cornerAt scene) (corners scene) <> concat (V.toList flats))
    , piece = byCorner (concat [s <$ chain s | s <- olds])
    , chains = V.fromList (map chain olds)
    , follower = byCorner (concat [drop 1 (chain s) <> [end s] | s <- olds])
    , oldTotal = n
    }
  where
    n = cornerCount scene
    olds = [0 .. n - 1]
    flats = V.fromList (map (map (ontoLattice (sceneLattice scene)) . cuts) (sides scene))
    firsts = U.scanl' (+) n (U.generate n (\s -> length (flats V.! s)))
    chain s = s : [firsts U.! s .. firsts U.! (s + 1) - 1]
    end s = let CornerId c = sideEnd scene (SideId s) in c
    byCorner = U.update_ (U.replicate (U.last firsts) 0) (U.fromList (concatMap chain olds)) . U.fromList

compareSpots :: Walks -> Int -> Int -> Ordering
compareSpots walks a b = comparePlaces (spots walks V.! a) (spots walks V.! b)

-- | The corners at which elements start, in the order of the file, each with whether its element leads along its side
-- in that order.
elementStarts :: Scene -> Walks -> [(Int, Bool)]
elementStarts scene walks = concatMap alongSide [0 .. statedSideTotal stated - 1]
  where
    stated = sceneStated scene
    -- Ways are compared by how their first end compares with the second.
    alongSide side = concatMap along (sortBy order (bucketOf (piecesBySide scene) side))
      where
        forward = comparePlacesAt (statedPlaces stated) (end 0) (end 1)
        end k = fromIntegral (statedSideEnds stated U.! (2 * side + k))
        order = case forward of
          LT -> compareSpots walks
          _ -> flip (compareSpots walks)
        along s
          | compareSpots walks s pieceEnd == forward = map (\c -> (c, True)) (chains walks V.! s)
          | otherwise = map (\c -> (c, False)) (reverse (chains walks V.! s))
          where
            CornerId pieceEnd = sideEnd scene (SideId s)

-- | What is stated of the new scene, with the elements as sides; and by corner, the stated corner that names it.
statedAnew :: Scene -> Walks -> [(Int, Bool)] -> (Stated, U.Vector Int32)
statedAnew scene walks onWays = (stated, names)
  where
    elements = U.fromList (map fst onWays)
    old = sceneStated scene
    n = oldTotal walks
    oldSide c = fromIntegral (facedSides scene U.! (piece walks U.! c)) :: Int
    owner c = statedSideOwners old U.! oldSide c
    polygons = [0 .. V.length (statedIds old) - 1]
    newcomers = U.filter (>= n) elements
    added = bucketsBy (length polygons) (U.map owner newcomers)
    -- Of each polygon, the old corners and then the new ones.
    oldMembers p = [statedFirsts old U.! p .. statedFirsts old U.! (p + 1) - 1]
    newMembers p = map (newcomers U.!) (bucketOf added p)
    firsts = U.fromList (scanl (+) 0 [length (oldMembers p) + length (newMembers p) | p <- polygons])
    numbering members skipped size =
      U.update_
        (U.replicate size 0)
        (U.fromList (concatMap members polygons))
        (U.fromList (concat [zipWith const [fromIntegral (firsts U.! p + skipped p) ..] (members p) | p <- polygons]))
        :: U.Vector Int32
    oldNumbers = numbering oldMembers (const 0) (statedTotal old)
    newNumbers = numbering newMembers (length . oldMembers) (V.length (spots walks))
    names = U.generate (V.length (spots walks)) $ \c ->
      if c < n then oldNumbers U.! fromIntegral (namingCorners scene U.! c) else newNumbers U.! c
    placesOf p = map (placeAt (statedPlaces old)) (oldMembers p) <> map (spots walks V.!) (newMembers p)
    sideFirsts =
      U.scanl' (+) 0 $
        U.accumulate (+) (U.replicate (length polygons) 0) (U.map (\c -> (fromIntegral (owner c), 1)) elements)
    stated =
      old
        { statedPlaces = placesFrom (concatMap placesOf polygons)
        , statedFirsts = firsts
        , statedOwners = ownersFrom firsts
        , statedSideFirsts = sideFirsts
        , statedSideOwners = ownersFrom sideFirsts
        , statedSideEnds = U.fromList (concatMap ends onWays)
        , statedOverrides =
            IntMap.fromList
              [ (k, own)
              | (k, c) <- zip [0 ..] (U.toList elements)
              , Just own <- [IntMap.lookup (oldSide c) (statedOverrides old)]
              ]
        }
    ends (c, isForward) = (if isForward then id else reverse) [names U.! c, names U.! (follower walks U.! c)]
