module Visibility.SweepSpec (spec) where

import Data.List (nub, sort, unfoldr)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Set as Set
import Data.Tuple (swap)
import Test.Hspec hiding (pending)
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Point (Arithmetic (..), Point (..))
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Scene.Family
import Visibility.Scene.Raw (RawScene)
import Visibility.Sweep
import Visibility.Sweep.Reference (State (..), start, step)
import Visibility.Test.BruteForce (bruteForce)
import Visibility.Test.Generator
import Visibility.Test.Metamorphic
import Visibility.Test.SweepLaw (searchWork)

spec :: Spec
spec = do
  describe "the vertices" $ do
    modifyMaxSuccess (* 50) $
      it "are those of brute force, each once" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
           in sort (vertices scene) === bruteForce scene
    modifyMaxSuccess (* 4) $ do
      it "come by strictly increasing directions at each corner" $
        property $ \(AnyScene s) -> let scene = sampleScene s in outOfOrder scene (vertices scene) === []
      it "are the same whatever decides the signs, if it is exact" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
           in vertices (underArithmetic Exact scene) === vertices (underArithmetic Filtered scene)
      it "are the same set whatever order the corners are tried in, each order topological" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
           in forAll (shuffle (corners scene)) $ \order ->
                let found = unfoldr (step scene) (start scene) {pending = order}
                 in (sort found, outOfOrder scene found) === (sort (vertices scene), [])
    it "are those of the reference in scenes swept in several pieces" $
      once . onFamilies 48 $ \scene -> vertices scene === referenceVertices scene
    it "are those of brute force in small scenes of every family" $
      once . onFamilies 48 $ \scene -> sort (vertices scene) === bruteForce scene
  describe "the graph" $
    modifyMaxSuccess (* 3) $ do
      it "keeps under maps that keep lines" $
        property $ \(AnyScene s) -> changesNothing s (affinity (sampleRaw s))
      it "changes names only, where only names change" $
        property $ \(AnyScene s) -> changesNothing s (relabelling (sampleRaw s))
      it "changes only along a side, or a piece of one, that is cut by a flat corner" $
        property $ \(AnyScene s) ->
          forAll (splitSide (sampleRaw s)) $ maybe (property True) $ \split ->
            onScene (splitScene split) $ \scene ->
              let new = graphOf scene
                  old = renamedGraph (splitNames split) (graphOf (sampleScene s))
                  named point = [splitNames split name | (name, at) <- statedCorners (sampleScene s), at == point]
                  atNew = Set.filter (\(a, b) -> a == splitCorner split || b == splitCorner split) new
                  toNew a = ordered (a, splitCorner split)
               in conjoin $ case (cutPieces (sampleScene s) (splitPlace scene split), named (splitPlace scene split)) of
                    -- The side is free there, or what lies along it is.
                    ([(a, b)], []) ->
                      [ counterexample "the pair along the side" (ends `Set.isSubsetOf` old)
                      , Set.difference new atNew === Set.difference old ends
                      , counterexample "both parts" (all ((`Set.member` new) . toNew) (named a <> named b))
                      ]
                      where
                        ends = Set.fromList [ordered (c, d) | c <- named a, d <- named b]
                    -- It is covered there, or there is a corner already: the new one sees what that sees.
                    ([], there) ->
                      [ Set.difference new atNew === old
                      , atNew
                          === Set.fromList
                            [toNew b | pair <- Set.toList old, (a, b) <- [pair, swap pair], a `elem` there]
                      ]
                    found -> [counterexample (show found) False]
  describe "the work" $ do
    it "is less than two edges of chains per pair and tree, on long chains and aligned corners too" $
      [(name, edges, pairs) | (name, scene) <- hardScenes, let (pairs, edges) = searchWork scene, edges >= 4 * pairs]
        `shouldBe` []
    it "is measured on scenes that are valid" $
      map fst hardScenes `shouldSatisfy` ((== 7) . length)
    it "per pair grows slowly with the scene in every family" $
      [ (familyName kind, perPair small, perPair large)
      | kind <- [minBound ..]
      , Just small <- [familyOf kind (sizeOfCorners kind 128)]
      , Just large <- [familyOf kind (sizeOfCorners kind 512)]
      , perPair large > 1.25 * perPair small
      ]
        `shouldBe` []
  where
    ordered (a, b) = (min a b, max a b)
    splitPlace scene split = fromMaybe (Point 0 0) (statedPoint scene (splitCorner split))
    perPair scene = let (pairs, edges) = searchWork scene in fromIntegral edges / fromIntegral pairs :: Double

-- | The uncovered pieces of sides that hold a point between their ends, by their ends.
cutPieces :: Scene -> Point -> [(Point, Point)]
cutPieces scene point@(Point x y) =
  [ (a, b)
  | side <- sides scene
  , let a@(Point ax ay) = cornerPoint scene (sideStart side)
  , let b@(Point bx by) = cornerPoint scene (sideEnd scene side)
  , (bx - ax) * (y - ay) == (by - ay) * (x - ax)
  , min a b < point && point < max a b
  ]

-- | The corners at which a list of vertices goes back or stands still.
outOfOrder :: Scene -> [Vertex] -> [CornerId]
outOfOrder scene found = [c | (c, ds) <- Map.toList directions, or (zipWith notBefore ds (drop 1 ds))]
  where
    notBefore d e = compareDirections d e /= LT
    directions = Map.fromListWith (flip (<>)) [(c, [vertexDirection scene v]) | v <- found, c <- vertexCorners v]

changesNothing :: Sample -> Gen Change -> Property
changesNothing s change = forAll change $ \c ->
  onScene (changedScene c) $ \scene -> graphOf scene === renamedGraph (newCorner c) (graphOf (sampleScene s))

onScene :: Testable p => RawScene -> (Scene -> p) -> Property
onScene raw f = maybe (counterexample ("not valid: " <> sampleText raw) False) (property . f . sampleScene) (sample raw)

familyOf :: Family -> Int -> Maybe Scene
familyOf kind n = size n >>= \count -> sampleScene <$> sample (family kind count (Seed 1))

onFamilies :: Testable p => Int -> (Scene -> p) -> Property
onFamilies most f =
  conjoin
    [ counterexample (show (kind, n)) (f scene)
    | kind <- [minBound ..]
    , n <- nub [1, 2, 3, sizeOfCorners kind most]
    , Just scene <- [familyOf kind n]
    ]

-- | Scenes that are costly for a careless scan of convex chains. Thin walls high on the left look past a corner down
-- there at the end of a long chain of corners, of which they see the nearest one only. Where those corners are on one
-- line, they are one chain only if collinear corners are linked.
hardScenes :: [(String, Scene)]
hardScenes =
  [ (name, sampleScene s)
  | (name, loops) <-
      [ ("a curved ceiling", ceiling' curved : onLooker : slots)
      , ("a flat ceiling", ceiling' flat : onLooker : slots)
      , ("teeth on a curve", map (tooth curved) steps <> (onLooker : slots))
      , ("teeth on a line", map (tooth flat) steps <> (onLooker : slots))
      , ("walls in a row", map dash steps <> (onLooker : slots))
      , ("squares in a lattice", [square (3 * i) (3 * j) | i <- [0 .. 9], j <- [0 .. 9]])
      , ("walls in a lattice", [[(3 * i, 3 * j), (3 * i + 1, 3 * j)] | i <- [0 .. 7], j <- [0 .. 19]])
      ]
  , Just s <- [sampleOf loops]
  ]
  where
    count = 80 :: Integer
    pitch = 1000000
    steps = [0 .. count - 1]
    flat _ = 0
    curved i = (2 * i - count) * (2 * i - count)
    square x y = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]
    ceiling' height =
      [(pitch * i, height i) | i <- [0 .. count]] <> [(pitch * count, pitch * count), (0, pitch * count)]
    tooth height i = [(pitch * i, height i), (pitch * i + 200000, pitch * count), (pitch * i - 200000, pitch * count)]
    dash i = [(pitch * i, 0), (pitch * i + 500000, 0)]
    onLooker = [(-3 * pitch, -2 * pitch), (-2 * pitch, -2 * pitch), (-2 * pitch, -pitch)]
    slots = [[(-3 * pitch * count, y), (-pitch * count - i * i, y)] | i <- steps, let y = pitch * count + 1000 * i]
