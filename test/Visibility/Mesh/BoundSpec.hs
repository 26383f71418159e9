module Visibility.Mesh.BoundSpec (spec) where

import Data.List (minimumBy, sort)
import Data.Maybe (fromMaybe)
import Data.Ord (comparing)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Mesh
import Visibility.Scene
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
                === oneByOne (countedElements most) (pieceEnds mesh side) points
            | (side, points) <- meshSides mesh
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
                      && length (breaksOf droppedMore side) <= length points + 1
                | (side, points) <- meshSides dropped
                ]
  where
    key p = (breakParameter p, map casterKind (breakCasters p))

-- | Of discontinuity meshes, and of uniform ones, with a bound that is often too low.
onMeshes :: (Mesh -> ElementCount -> (Mesh, Mesh) -> Property) -> Property
onMeshes check =
  property $ \(AnyScene s) ->
    forAllBlind (elements (meshesOf (sampleScene s))) $ \mesh ->
      forAllShow (choose (1, 9) `suchThatMap` elementCount) show $ \most -> check mesh most (bounded most mesh)
  where
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

-- | What is kept and what is dropped, each ascending, by trying all break points each time.
oneByOne :: Int -> [(Rational, Rational)] -> [BreakPoint] -> ([Rational], [Rational])
oneByOne most pieces points = go (map stop points) []
  where
    stop p = (if breakKind p == Just ShadowLimit then 1 else 0 :: Int, breakParameter p)
    go kept dropped
      | length kept + length pieces <= most || null kept = (map snd kept, sort dropped)
      | otherwise =
          let gone = minimumBy (comparing (\p -> (fst p, joint kept (snd p), snd p))) kept
           in go (filter (/= gone) kept) (snd gone : dropped)
    -- How long the element is that is left without a break point.
    joint kept t = minimum (filter (> t) stops) - maximum (filter (< t) stops)
      where
        stops = map snd kept <> concat [[a, b] | (a, b) <- pieces]
