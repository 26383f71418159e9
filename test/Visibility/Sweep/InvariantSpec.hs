module Visibility.Sweep.InvariantSpec (spec) where

import Control.Monad (forM_)
import qualified Data.Vector.Unboxed as U
import Test.Hspec hiding (pending)
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Scene
import Visibility.Sweep
import Visibility.Sweep.HorizonTree
import Visibility.Sweep.Invariant
import Visibility.Sweep.Topological (Sweep (..))
import Visibility.Sweep.Vertical
import Visibility.Test.Generator

type Table = U.Vector Int

-- | A table of a tree, the entries that mean something in a state, and the values that an entry may have.
data Part = Part
  { partName :: String
  , partTable :: Tree Table -> Table
  , withTable :: Tree Table -> Table -> Tree Table
  , meaningful :: Int -> Tree Table -> [Int]
  , values :: Int -> [Int]
  }

parts :: [Part]
parts =
  [ Part "target of a corner" targets (\t v -> t {targets = v}) (\n _ -> [0 .. n - 1]) (\n -> [none .. 2 * n])
  , Part "node of a corner" nodes (\t v -> t {nodes = v}) (\n _ -> [0 .. n - 1]) nodeNumbers
  , Part "link of a corner" links (\t v -> t {links = v}) (\n _ -> [0 .. n - 1]) (const [0, 1])
  , Part "first node of a list" firstIn (\t v -> t {firstIn = v}) (\n _ -> [0 .. 2 * n]) nodeNumbers
  , Part "last node of a list" lastIn (\t v -> t {lastIn = v}) (\n _ -> [0 .. 2 * n]) nodeNumbers
  , Part "pointer up a list" upperNode (\t v -> t {upperNode = v}) listed nodeNumbers
  , Part "pointer down a list" lowerNode (\t v -> t {lowerNode = v}) listed nodeNumbers
  , Part "top of a chain" tops (\t v -> t {tops = v}) (\n t -> map (leaves t U.!) (topNodes n t)) nodeNumbers
  , Part "leaf of a chain" leaves (\t v -> t {leaves = v}) topNodes nodeNumbers
  ]
  where
    nodeNumbers n = [none .. 2 * n - 1]
    listed n t = concat [takeWhile (/= none) (iterate (upperNode t U.!) (firstIn t U.! k)) | k <- [0 .. 2 * n], firstIn t U.! k /= none, endsProperly k t]
    endsProperly k t = upperNode t U.! (lastIn t U.! k) == none
    topNodes n t =
      [ node
      | p <- [0 .. n - 1]
      , let node = nodes t U.! p
      , let q = targets t U.! p
      , node /= none
      , not (q < n && links t U.! q == 1 && lastIn t U.! q == node)
      ]

spec :: Spec
spec = do
  describe "every state" $
    modifyMaxSuccess (* 3) $ do
      it "keeps all laws, before and after each step" $
        property $ \(SmallScene s) ->
          let scene = sampleScene s
           in conjoin [violations scene state === [] | state <- start scene : map snd (trace scene)]
      it "keeps them in scenes of any kind" $
        property $ \(AnyScene s) -> forAllState s $ \state -> violations (sampleScene s) state === []
  describe "the laws notice" $ do
    forM_ parts $ \part -> it ("a wrong " <> partName part) $
      property $ \(LatticeScene s) -> forAllState s $ \state -> forAll arbitraryBoundedEnum $ \heading ->
        let n = cornerCount (sampleScene s)
            tree = treeOf heading state
            table = partTable part tree
         in forAll (sublist (meaningful part n tree)) $ \places ->
              conjoin
                [ forAll (elements (filter (/= table U.! k) (values part n))) $ \value ->
                    counterexample (show (heading, k)) (noticed s (withTree heading (withTable part tree (table U.// [(k, value)])) state))
                | k <- places
                ]
    it "a flag without a pending corner, and a pending corner without a flag" $
      property $ \(LatticeScene s) -> forAllState s $ \state ->
        forAll (choose (0, cornerCount (sampleScene s) - 1)) $ \p ->
          noticed s state {isPending = isPending state U.// [(p, 1 - isPending state U.! p)]}
    it "a sweep that stops before a vertex of two corners" $
      property $ \(LatticeScene s) ->
        let scene = sampleScene s
            states = start scene : map snd (trace scene)
            early = [state | (state, vertex) <- zip states (map fst (trace scene)), not (isDegenerate vertex)]
         in not (null early) ==> forAll (elements [0 .. length early - 1]) $ \k ->
              conjoin [noticed s state {pending = [], isPending = U.map (const 0) (isPending state)} | state <- take 1 (drop k early)]
  where
    noticed s state = counterexample "not noticed" (not (null (violations (sampleScene s) state)))
    sublist xs = case xs of [] -> pure []; _ -> vectorOf 4 (elements xs)

treeOf :: Heading -> Sweep -> Tree Table
treeOf Rightward = rightTree
treeOf Leftward = leftTree

withTree :: Heading -> Tree Table -> Sweep -> Sweep
withTree Rightward tree state = state {rightTree = tree}
withTree Leftward tree state = state {leftTree = tree}

-- | Any state of the sweep of a scene.
forAllState :: Testable p => Sample -> (Sweep -> p) -> Property
forAllState s f = forAll (choose (0, length states - 1)) $ \k -> conjoin (map f (take 1 (drop k states)))
  where
    states = start (sampleScene s) : map snd (trace (sampleScene s))
