module Visibility.Sweep.TopologicalSpec (spec) where

import Data.List (unfoldr)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Point (Point (..))
import Visibility.Scene
import Visibility.Scene.Raw (RawScene (..), rawWall)
import Visibility.Sweep (vertices)
import Visibility.Sweep.HorizonTree.Table
import Visibility.Sweep.Reference (Target (..), Tree (..), start, step, treeOf)
import Visibility.Sweep.Topological (treesAfter)
import Visibility.Sweep.Vertical (Heading (..))
import Visibility.Test.Generator

spec :: Spec
spec = describe "the fast sweep" $ do
  modifyMaxSuccess (* 20) $
    it "has the vertices of the reference, in the same order" $
      property $ \(AnyScene s) -> sameVertices s
  it "has them in that order also where a line that waits is free before all its corners were looked at again" $
    once (maybe (property False) sameVertices waiting)
  modifyMaxSuccess (* 10) $ do
    it "has its trees at any moment" $ property $ \(AnyScene s) -> sameTrees s
    it "has its trees at any moment, where polygons touch" $ property $ \(TouchingScene s) -> sameTrees s
    it "has its trees at any moment, with many corners on lines" $ property $ \(LatticeScene s) -> sameTrees s
  it "has its trees at every moment" $
    property $ \(SmallScene s) -> let states = count s in conjoin [sameTreesAfter s k | k <- [0 .. states]]
  where
    sameVertices s = let scene = sampleScene s in vertices scene === unfoldr (step scene) (start scene)
    -- Walls of which three begin in one place, in a bent one.
    waiting =
      sample . RawScene Nothing Nothing . map (rawWall . map (uncurry Point)) $
        [ [(2, 3), (1, 5)], [(3, 3), (5, 6)], [(1, 3), (1, 5)], [(8, 1), (8, 9), (0, 9), (0, 1)]
        , [(3, 3), (4, 2)], [(3, 3), (0, 3)]
        ]
    count s = let scene = sampleScene s in length (vertices scene)
    sameTrees s = forAll (choose (0, count s)) (sameTreesAfter s)

-- | Are both trees the same after so many vertices?
sameTreesAfter :: Sample -> Int -> Property
sameTreesAfter s k =
  conjoin
    [ counterexample (show (heading tree, k)) (inTable scene table === inReference tree)
    | (way, table) <- [(Rightward, fst fast), (Leftward, snd fast)]
    , let tree = treeOf way slow
    ]
  where
    scene = sampleScene s
    fast = treesAfter scene k
    slow = iterate (\state -> maybe state snd (step scene state)) (start scene) !! k

-- | A tree: by corner its target; by target the corners that something arrives from, in order; linked corners; the two
-- ends of each chain.
type Picture = (Map.Map CornerId Target, Map.Map Target [CornerId], Set.Set CornerId, Map.Map CornerId CornerId)

inReference :: Tree -> Picture
inReference tree =
  (targets tree, Map.filter (not . null) (Map.map Map.elems (arrivals tree)), linked tree, otherEnd tree)

nodeAt :: Table -> Field -> Node
nodeAt table = Node . at table

listAt :: Table -> Field -> List
listAt table = List . at table

sourceAt :: Table -> Node -> Int
sourceAt table node = if isEdgeNode node then nodeOwner node else at table (source (nodeOwner node))

inTable :: Scene -> Table -> Picture
inTable scene table = (Map.fromList found, Map.fromList lists, Set.fromList (filter isLinked (corners scene)), ends)
  where
    n = cornerCount scene
    found = [(CornerId p, t) | p <- [0 .. n - 1], Just t <- [targetOf (listAt table (target p))]]
    targetOf l
      | l == noList = Nothing
      | isCornerList l = Just (ToCorner (CornerId (listOwner l)))
      | l == skyList n = Just ToSky
      | otherwise = Just (ToCeiling (SideId (listOwner l)))
    lists =
      [ (t, map (CornerId . sourceAt table) nodes)
      | (t, l) <-
          (ToSky, skyList n)
            : [(ToCorner (CornerId p), cornerList p) | p <- [0 .. n - 1]]
              <> [(ToCeiling (SideId p), ceilingList p) | p <- [0 .. n - 1]]
      , let nodes = takeWhile (/= noNode) (iterate (nodeAt table . later) (nodeAt table (first l)))
      , not (null nodes)
      ]
    isLinked (CornerId p) = at table (link p) == 1
    -- The top of a chain knows its leaf, and its leaf its top.
    ends =
      Map.fromList $
        concat
          [ [(CornerId p, source' deepest), (source' deepest, source' (nodeAt table (top deepest)))]
          | p <- [0 .. n - 1]
          , let own = nodeAt table (edge p)
          , own /= noNode
          , let l = listAt table (target p)
          , not (isCornerList l && isLinked (CornerId (listOwner l)) && nodeAt table (final l) == own)
          , let deepest = nodeAt table (leaf own)
          ]
    source' = CornerId . sourceAt table
