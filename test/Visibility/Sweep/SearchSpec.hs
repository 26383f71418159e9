module Visibility.Sweep.SearchSpec (spec) where

import Control.Monad (forM_)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Law (Violation (..))
import Visibility.Scene
import Visibility.Scene.Family
import Visibility.Sweep.Reference
import Visibility.Sweep.Vertical (Heading (..))
import Visibility.Test.BruteForce (bruteForce)
import Visibility.Test.Generator
import Visibility.Test.SearchLaw

-- | One way to make a moment wrong, and the law that must notice it.
data Fault = Fault String (Scene -> [Pair] -> Moment -> [Moment])

spec :: Spec
spec = do
  describe "the state after every event" $
    modifyMaxSuccess (* 2) $ do
      it "keeps F1 to F4 and Lemma 2" $
        property $ \(SmallScene s) -> forAllMoment s stateViolations
      it "keeps them where polygons touch" $
        property $ \(TouchingScene s) -> forAllMoment s stateViolations
      it "keeps them in scenes of any kind" $
        property $ \(AnyScene s) -> forAllMoment s stateViolations
      it "is that of the sweep after the last event of a vertex" $
        property $ \(AnyScene s) -> forAllHeadings $ \way ->
          conjoin [found === tree | (found, tree) <- snd (moments (sampleScene s) way)]
  describe "the searches" $
    modifyMaxSuccess (* 2) $ do
      it "keep Lemmas 3 to 7 and the bounds" $
        property $ \(AnyScene s) -> searched (sampleScene s)
      it "keep them where polygons touch" $
        property $ \(TouchingScene s) -> searched (sampleScene s)
      it "keep them where chains are long" $
        once (conjoin (map searched long))
  describe "each law can fail:" $
    forM_ (map onMoment faults <> historyFaults) $ \(name, noticed) -> it name ((name `elem` noticed) `shouldBe` True)
  where
    forAllHeadings f = conjoin [counterexample (show way) (f way) | way <- [Rightward, Leftward]]
    forAllMoment s violations = forAllHeadings $ \way ->
      let scene = sampleScene s
          events = fst (moments scene way)
       in not (null events) ==> forAll (choose (0, length events - 1)) $ \k ->
            conjoin [violations scene (allPairs scene way) moment === [] | moment <- take 1 (drop k events)]
    searched scene = forAllHeadings $ \way ->
      let events = fst (moments scene way)
          pairs = allPairs scene way
       in conjoin
            [ concatMap (searchViolations scene (Set.fromList pairs)) events === []
            , historyViolations scene way pairs (map momentChange events) === []
            ]
    onMoment (Fault name spoilt) = (name, concatMap found long)
      where
        found scene =
          [ violatedLaw v
          | way <- [Rightward, Leftward]
          , let pairs = allPairs scene way
          , moment <- fst (moments scene way)
          , wrong <- spoilt scene pairs moment
          , v <- take 9 (searchViolations scene (Set.fromList pairs) wrong) <> stateViolations scene pairs wrong
          ]
    historyFaults =
      [ ("Lemma 6, two events share at most one corner", history (concatMap (replicate 2)))
      , ("Lemma 7, arcs do not cross", history interleaved)
      , ("the theorem, near sets are bounded by pairs", history (concatMap (replicate 40)))
      , ("the theorem, at most 8m edges are asked", history (concatMap (replicate 40)))
      ]
    history spoilt =
      [ violatedLaw v
      | scene <- long
      , let events = map momentChange (fst (moments scene Rightward))
      , v <- historyViolations scene Rightward (allPairs scene Rightward) (spoilt events)
      ]
    -- The corner of four events sees their four targets one after the other.
    interleaved events =
      [ withPassed (const near) change
      | change <- take 1 [c | c <- events, length (targetsOf c) > 3]
      , a : b : c : d : _ <- [targetsOf change]
      , near <- [[c, a], [d, b]]
      ]
      where
        targetsOf change = [sweptTo e | e <- events, changedCorner e == changedCorner change]

allPairs :: Scene -> Heading -> [Pair]
allPairs scene way = pairsAhead scene way (bruteForce scene)

-- | Scenes with near sets of several corners, on either side of the corner that passes them.
long :: [Scene]
long =
  [ sampleScene s
  | (kind, n) <- [(Tower, 4), (Ceiling, 4), (Random, 6)]
  , Just k <- [size n]
  , Just s <- [sample (family kind k (Seed 1))]
  ]

faults :: [Fault]
faults =
  [ Fault "F1, swept pairs have less slope than unswept ones" $ \_ pairs m ->
      [m {momentSwept = Set.insert pair (momentSwept m)} | pair <- take 1 (reverse (unswept pairs m))]
  , Fault "F2, a tree edge is the first unswept pair" $ \scene _ m ->
      [leading p c m | p <- take 1 (corners scene), c <- corners scene]
  , Fault "F3, lists hold tree edges and sides in order" $ \_ _ m ->
      [onTree (\tree -> tree {arrivals = Map.drop 1 (arrivals tree)}) m]
  , Fault "F4, what is linked is linkable" $ \scene _ m ->
      [onTree (\tree -> tree {linked = Set.fromList (corners scene)}) m]
  , Fault "F4, what is linkable is linked" $ \_ _ m -> [onTree (\tree -> tree {linked = Set.empty}) m]
  , Fault "Lemma 2, an unswept pair that crosses a tree edge has more slope" $ \_ pairs m ->
      [leading p q m | (p, q) <- reverse (unswept pairs m)]
  , Fault "Lemma 3, nothing hides the target that is found" $ \_ _ m ->
      [withTarget t m | (t, list) <- Map.toList (arrivals (momentTree m)), Map.size list > 1]
  , Fault "a corner passed is seen" $ \scene _ m -> [passing (const (corners scene)) m]
  , Fault "Lemma 4, the corner is below the edges passed" $ \_ _ m -> [passing reverse m]
  , Fault "Lemma 4, the fan is empty" $ \_ _ m -> [passing (\near -> take 1 near <> drop 2 near) m]
  , Fault "Lemma 4, pairs from behind are swept" $ \_ _ m -> [m {momentSwept = Set.empty}]
  , Fault "the edge found is the last one, after the chain" $ \_ _ m -> [passing (take 1) m]
  ]
  where
    unswept pairs m = filter (`Set.notMember` momentSwept m) pairs
    onTree f m = m {momentTree = f (momentTree m)}
    leading p q = onTree (\tree -> tree {targets = Map.insert p (ToCorner q) (targets tree)})

passing :: ([CornerId] -> [CornerId]) -> Moment -> Moment
passing f m = m {momentChange = withPassed f (momentChange m)}

withPassed :: ([CornerId] -> [CornerId]) -> Change -> Change
withPassed f change = change {search = fmap (\found -> found {passed = f (passed found)}) (search change)}

-- | The corner of the event leads to another target, and stands second in its list.
withTarget :: Target -> Moment -> Moment
withTarget t m = m {momentTree = tree {arrivals = Map.adjust second t (arrivals tree)}, momentChange = found}
  where
    tree = momentTree m
    change = momentChange m
    found = change {search = fmap (\s -> s {touching = t}) (search change)}
    second list = Map.fromList (zip (Map.keys list) (withSecond (Map.elems list)))
    withSecond here = take 1 here <> [changedCorner change] <> drop 2 here
