module Visibility.Mesh.BoundSpec (spec) where

import Data.List (minimumBy, partition, sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Ord (comparing)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Mesh
import Visibility.Scene
import Visibility.Scene.Raw (Form (..))
import Visibility.Sweep
import Visibility.Test.Generator
import Visibility.Test.Landing (positionOn)

spec :: Spec
spec =
  describe "a bound on elements" $
    modifyMaxSuccess (* 3) $ do
      it "drops on each side, again and again, a kink before a shadow limit and the one of the shortest joint element" $
        onMeshes $ \mesh most (kept, dropped) ->
          conjoin
            [ (map breakParameter (breaksOf kept side), map breakParameter (breaksOf dropped side))
                === partition (not . (`elem` gone)) (map breakParameter points)
            | (side, points) <- meshSides mesh
            , let gone =
                    oneByOne (countedElements most) mesh side
                      <> [1 - t | Just other <- [behind mesh side], t <- oneByOne (countedElements most) mesh other]
            ]
      it "is kept when both faces of a wall are cut at the break points of both" $
        onMeshes $ \mesh most (kept, _) ->
          let count m = Map.fromListWith (+) [(elementSide e, 1 :: Int) | e <- refinedElements (refined m)]
              pieces side = length (concat (piecesOf (meshScene mesh) side))
              alone m = [length (breaksOf m side) + pieces side | side <- Map.keys (count m)]
           in cover 5 (or (zipWith (>) (Map.elems (count mesh)) (alone mesh))) "faces share" $
                conjoin
                  [ counterexample (sideText side) (k <= max (countedElements most) (pieces side))
                  | (side, k) <- Map.toList (count kept)
                  ]
      it "is kept on every side, but that a side has an element for each of its pieces" $
        onMeshes $ \mesh most (kept, _) ->
          conjoin
            [ counterexample (sideText side) (length points + pieces <= max (countedElements most) pieces)
            | (side, points) <- meshSides kept
            , let pieces = length (concat (piecesOf (meshScene mesh) side))
            ]
      it "loses nothing: what is kept and what is dropped is what was there" $
        onMeshes $ \mesh _ (kept, dropped) ->
          conjoin
            [ sort (map key (breaksOf kept side <> breaksOf dropped side)) === sort (map key points)
            | (side, points) <- meshSides mesh
            ]
      it "keeps break points in order along each piece" $
        onMeshes $ \mesh _ (kept, _) ->
          conjoin
            [ breaksOn kept side === [p | p <- breaksOn mesh side, key p `elem` map key (breaksOn kept side)]
            | side <- sides (meshScene mesh)
            ]
      it "that is lower by one drops the same and at most one more on each side" $
        onMeshes $ \mesh most (_, dropped) ->
          let less = fromMaybe most (elementCount (countedElements most - 1))
              (_, droppedMore) = bounded less mesh
           in conjoin
                [ counterexample (sideText side) $
                    all (`elem` map key (breaksOf droppedMore side)) (map key points)
                      && length (breaksOf droppedMore side) <= length points + maybe 1 (const 2) (behind mesh side)
                | (side, points) <- meshSides dropped
                ]
  where
    key p = (breakParameter p, map casterKind (breakCasters p))

-- | Of discontinuity meshes, and of uniform ones, with a bound that is often too low.
onMeshes :: (Mesh -> ElementCount -> (Mesh, Mesh) -> Property) -> Property
onMeshes check =
  forAll kinds $ \s ->
    forAllBlind (elements (meshesOf (sampleScene s))) $ \mesh ->
      forAllShow (choose (1, 9) `suchThatMap` elementCount) show $ \most -> check mesh most (bounded most mesh)
  where
    kinds = frequency [(3, (\(AnyScene s) -> s) <$> arbitrary), (1, (\(TouchingScene s) -> s) <$> arbitrary)]
    meshesOf scene = [discontinuityMesh scene (vertices scene), uniform scene]
    uniform scene = maybe (emptyMesh scene) (`uniformMesh` scene) (elementCount 7)

-- | The parameters of the ends of each piece of a side, the lesser first, in order.
pieceEnds :: Mesh -> SideName -> [(Rational, Rational)]
pieceEnds mesh side =
  sort
    [ (min a b, max a b)
    | piece <- concat (piecesOf scene side)
    , let a = position (sideStart piece)
    , let b = position (sideEnd scene piece)
    ]
  where
    scene = meshScene mesh
    position = positionOn scene side . cornerPoint scene

-- | The other face of a side of a thin wall: its sides go along one face and back along the other.
behind :: Mesh -> SideName -> Maybe SideName
behind mesh (SideName p k) =
  listToMaybe
    [ SideName p (2 * length (polygonPoints polygon) - 3 - k)
    | polygon <- scenePolygons (meshScene mesh)
    , polygonId polygon == p
    , polygonForm polygon == Polyline
    ]

-- | What a side drops, by trying all break points each time: its own, and on pieces of a wall that are uncovered on
-- both faces those of the other face.
oneByOne :: Int -> Mesh -> SideName -> [Rational]
oneByOne most mesh side = go (Map.toList points)
  where
    other = behind mesh side
    pieces = pieceEnds mesh side
    points =
      Map.fromListWith max $
        [(breakParameter p, rank p) | p <- breaksOf mesh side]
          <> [ (t, rank p)
             | Just face <- [other]
             , p <- breaksOf mesh face
             , let t = 1 - breakParameter p
             , or [a < t && t < b | (a, b) <- shared]
             ]
    rank p = if breakKind p == Just ShadowLimit then 1 else 0 :: Int
    shared = [(a, b) | Just face <- [other], (a, b) <- pieces, (1 - b, 1 - a) `elem` pieceEnds mesh face]
    among t = if any (< side) other && not (null shared) then 1 - t else t
    go kept
      | length kept + length pieces <= most || null kept = []
      | otherwise =
          let (gone, _) = minimumBy (comparing (\(t, r) -> (r, joint kept t, among t))) kept
           in gone : go (filter ((/= gone) . fst) kept)
    -- How long the element is that is left without a break point.
    joint kept t = minimum (filter (> t) stops) - maximum (filter (< t) stops)
      where
        stops = map fst kept <> concat [[a, b] | (a, b) <- pieces]
