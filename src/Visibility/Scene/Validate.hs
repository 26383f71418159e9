-- | The only door from what a file says to a 'Scene'.
module Visibility.Scene.Validate
  ( validate
  ) where

import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import qualified Data.Vector as V
import Visibility.Error (MaterialPlace (..), SceneError (..), sceneErrorPlace)
import Visibility.Law (broken)
import Visibility.Scene.Boundary
import Visibility.Scene.Fault
import Visibility.Scene.Id
import Visibility.Scene.Outline
import Visibility.Scene.Raw
import Visibility.Scene.Touching
import Visibility.Scene.Type (Scene, assemble)

-- | The scene, or everything that is wrong with it: sorted by polygon and then by corner or side, nothing twice.
--
-- Polygons may touch, in corners and along sides, but not overlap; so may thin walls, and a thin wall may touch itself,
-- but no two pieces of walls may lie along each other. Reported once: an overlap of two polygons, in however many
-- places. A thin wall has its two faces in one place, and crossings name that on the right of the way along it. What
-- follows from something else is left out: contacts at a spike between the sides that make it, contacts of a polygon of
-- no area with itself, overlaps of solids whose boundaries cross, and whether polygons whose boundaries meet are
-- nested. A polygon of too few corners is looked at no further; overlaps are not looked for while a polygon has
-- something wrong with itself. Of a boundary that crosses itself, the inside is where a ray crosses it an odd number of
-- times.
--
-- /Cost/ of a valid scene O(n log n), however the sides lie and wherever polygons touch. Of others that of 'placed', in
-- O(n) memory while they are consumed.
--
-- /Laws/ the set of errors is that of a comparison of all pairs of sides and all pairs of polygons. A valid scene has
-- the corners, sides and materials that the file gives, under the file's names.
validate :: RawScene -> Either (NonEmpty SceneError) Scene
validate raw
  | null shapes = Left (EmptyScene :| [])
  | otherwise = case allWrong shapes (either id (const []) layout) of
      e : es -> Left (e :| es)
      [] -> case layout of
        Right found -> Right (assemble (rawName raw) (contactPlaces found) shapes o (freeCorners o found))
        Left _ -> broken "what the scan finds wrong with a scene is found pair by pair" (show (V.toList (outlineIds o)))
  where
    shapes = zip (map Obstacle [0 ..]) (rawPolygons raw) <> [(Enclosure, room) | Just room <- [rawEnclosure raw]]
    whole = filter hasEnough shapes
    o = outline whole
    layout = placed whole o
    allWrong (shape : more) later
      | hasEnough shape
      , (own, others) : next <- later =
          merged (statementErrors shape <> own) others <> allWrong more next
      | otherwise = merged (statementErrors shape) [] <> allWrong more later
    allWrong [] _ = []
    -- Those that follow are in the order of places already.
    merged few others = inOrder (ordered few) (concatMap ordered others)
    inOrder (e : es) (f : fs)
      | withPlace e <= withPlace f = e : inOrder es (f : fs)
      | otherwise = f : inOrder (e : es) fs
    inOrder es fs = es <> fs
    withPlace e = (sceneErrorPlace e, e)
    hasEnough shape@(_, polygon) = cornerTotal polygon >= fewestCorners shape
    ordered = map snd . Set.toAscList . Set.fromList . map withPlace

sideTotalOf :: Shape -> Int
sideTotalOf shape@(_, polygon) = sideTotal polygon {rawForm = formOf shape}

-- Numbers of corners, side numbers, materials.
statementErrors :: Shape -> [SceneError]
statementErrors shape@(p, polygon) = few <> sideNumbers <> materials
  where
    few = [TooFewCorners p n | let n = cornerTotal polygon, n < fewestCorners shape]
    sideNumbers =
      [ NoSuchSide (SideName p k) n
      | let n = sideTotalOf shape
      , k <- Map.keys (rawSides polygon)
      , k < 0 || k >= n
      ]
    materials =
      material' (OfPolygon p) (Just (emission whole)) (Just (reflectivity whole))
        <> concat [material' (OfSide (SideName p k)) e r | (k, MaterialOverride e r) <- Map.toList (rawSides polygon)]
    whole = rawMaterial polygon
    material' place e r =
      [BadEmission place x | Just x <- [e], x < 0] <> [BadReflectivity place x | Just x <- [r], x < 0 || x >= 1]

