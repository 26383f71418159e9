module Visibility.Sweep.InvariantSpec (spec) where

import Control.Monad (forM_)
import qualified Data.Vector.Unboxed as U
import Test.Hspec hiding (pending)
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Scene
import Visibility.Sweep
import Visibility.Sweep.HorizonTree.Table
import Visibility.Sweep.Invariant
import Visibility.Sweep.Topological (Sweep (..))
import Visibility.Sweep.Vertical
import Visibility.Test.Generator

-- | A kind of field, the fields of it that mean something in a state, and the values that one may have.
data Part = Part
  { partName :: String
  , meaningful :: Int -> Table -> [Field]
  , values :: Int -> [Int]
  }

parts :: [Part]
parts =
  [ Part "target of a corner" (eachCorner target) (\n -> [l | List l <- noList : listsOf n])
  , Part "node of a corner" (eachCorner edge) nodeNumbers
  , Part "link of a corner" (eachCorner link) (const [0, 1])
  , Part "first node of a list" (\n _ -> map first (listsOf n)) nodeNumbers
  , Part "last node of a list" (\n _ -> map final (listsOf n)) nodeNumbers
  , Part "pointer up a list" (\n table -> map upper (listed n table)) nodeNumbers
  , Part "pointer down a list" (\n table -> map lower (listed n table)) nodeNumbers
  , Part "top of a chain" (\n table -> map (top . nodeAt table . leaf) (topNodes n table)) nodeNumbers
  , Part "leaf of a chain" (\n table -> map leaf (topNodes n table)) nodeNumbers
  ]
  where
    eachCorner field n _ = map field [0 .. n - 1]
    listsOf n = map cornerList [0 .. n - 1] <> map ceilingList [0 .. n - 1] <> [skyList n]
    nodeNumbers n = [e | Node e <- noNode : map edgeNode [0 .. n - 1] <> map markerNode [0 .. n - 1]]
    listed n table = concatMap (following table . nodeAt table . first) (listsOf n)
    following table = takeWhile (/= noNode) . iterate (nodeAt table . upper)
    topNodes n table =
      [ node
      | p <- [0 .. n - 1]
      , let node = nodeAt table (edge p)
      , node /= noNode
      , let l = listAt table (target p)
      , not (isCornerList l && at table (link (listOwner l)) == 1 && nodeAt table (final l) == node)
      ]

spec :: Spec
spec = do
  describe "every state" $
    modifyMaxSuccess (* 3) $ do
      it "keeps all laws, before and after each step" $
        property $ \(SmallScene s) ->
          let scene = sampleScene s
           in conjoin [violations scene state === [] | state <- start scene : map snd (trace scene)]
      it "keeps them where polygons touch" $
        property $ \(TouchingScene s) -> forAllState s $ \state -> violations (sampleScene s) state === []
      it "keeps them in scenes of any kind" $
        property $ \(AnyScene s) -> forAllState s $ \state -> violations (sampleScene s) state === []
  describe "the laws notice" $ do
    forM_ parts $ \part -> it ("a wrong " <> partName part) $
      property $ \(LatticeScene s) -> forAllState s $ \state -> forAll arbitraryBoundedEnum $ \heading ->
        let n = cornerCount (sampleScene s)
            table = treeOf heading state
         in forAll (some (meaningful part n table)) $ \places ->
              conjoin
                [ forAll (elements (filter (/= at table field) (values part n))) $ \value ->
                    counterexample (show (heading, field)) $
                      noticed s (withTree heading (changed field value table) state)
                | field <- places
                ]
    it "a flag without a pending corner, and a pending corner without a flag" $
      property $ \(LatticeScene s) -> forAllState s $ \state ->
        forAll (choose (0, cornerCount (sampleScene s) - 1)) $ \p ->
          noticed s state {isPending = isPending state U.// [(p, 1 - isPending state U.! p)]}
    it "a sweep that stops before a vertex of two corners" $
      property $ \(LatticeScene s) ->
        let scene = sampleScene s
            states = start scene : map snd (trace scene)
            early = [state | (state, vertex) <- zip states (map fst (trace scene)), not (isDegenerate scene vertex)]
         in not (null early) ==> forAll (elements [0 .. length early - 1]) $ \k ->
              conjoin (map (noticed s . withoutPending) (take 1 (drop k early)))
  where
    noticed s state = counterexample "not noticed" (not (null (violations (sampleScene s) state)))
    withoutPending state = state {pending = U.empty, isPending = U.map (const 0) (isPending state)}
    some xs = case xs of [] -> pure []; _ -> vectorOf 4 (elements xs)

treeOf :: Heading -> Sweep -> Table
treeOf Rightward = rightTree
treeOf Leftward = leftTree

withTree :: Heading -> Table -> Sweep -> Sweep
withTree Rightward tree state = state {rightTree = tree}
withTree Leftward tree state = state {leftTree = tree}

-- | Any state of the sweep of a scene.
forAllState :: Testable p => Sample -> (Sweep -> p) -> Property
forAllState s f = forAll (choose (0, length states - 1)) $ \k -> conjoin (map f (take 1 (drop k states)))
  where
    states = start (sampleScene s) : map snd (trace (sampleScene s))
