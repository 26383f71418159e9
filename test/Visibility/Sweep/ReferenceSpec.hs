module Visibility.Sweep.ReferenceSpec (spec) where

import Control.Monad (forM_)
import Data.List (inits, sort, sortBy, unfoldr)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Test.Hspec hiding (pending)
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Point (coordinates)
import Visibility.Exact.Predicate
import Visibility.Test.Ray
import Visibility.Scene
import Visibility.Sweep (Vertex, isDegenerate, vertexPairs)
import Visibility.Sweep.Reference
import Visibility.Sweep.Vertical (Heading (..))
import Visibility.Test.BruteForce (bruteForce)
import Visibility.Test.Generator
import Visibility.Test.SweepLaw

-- | A part of a tree, and how one entry of it may be made wrong.
data Part = Part {partName :: String, spoilt :: Scene -> Tree -> Gen (Maybe Tree)}

parts :: [Part]
parts =
  [ Part "target of a corner" $ \scene tree ->
      change targets (\new -> tree {targets = new}) (anyTarget scene) (corners scene) tree
  , Part "missing target of a corner" $ \_ tree ->
      picked (Map.keys (targets tree)) $ \p -> pure tree {targets = Map.delete p (targets tree)}
  , Part "arrival" $ \scene tree -> picked (Map.keys (arrivals tree)) $ \t -> do
      p <- elements (corners scene)
      let list = Map.findWithDefault Map.empty t (arrivals tree)
          other
            | p `elem` Map.elems list = Map.filter (/= p) list
            | otherwise = Map.insert (rankOf scene (heading tree) t p) p list
      pure tree {arrivals = Map.insert t other (arrivals tree)}
  , Part "order of arrivals" $ \_ tree -> picked (several tree) $ \(t, l) ->
      pure tree {arrivals = Map.insert t (Map.fromList (zip (Map.keys l) (reverse (Map.elems l)))) (arrivals tree)}
  , Part "link of a corner" $ \scene tree -> picked (corners scene) $ \p ->
      pure tree {linked = if Set.member p (linked tree) then Set.delete p (linked tree) else Set.insert p (linked tree)}
  , Part "end of a chain" $ \scene tree ->
      change otherEnd (\new -> tree {otherEnd = new}) (elements (corners scene)) (Map.keys (otherEnd tree)) tree
  , Part "missing end of a chain" $ \_ tree ->
      picked (Map.keys (otherEnd tree)) $ \p -> pure tree {otherEnd = Map.delete p (otherEnd tree)}
  ]
  where
    several tree = filter ((> 1) . Map.size . snd) (Map.toList (arrivals tree))
    picked xs f = if null xs then pure Nothing else elements xs >>= fmap Just . f
    change part with new keys tree = picked keys $ \p -> do
      value <- new `suchThat` (\v -> Map.lookup p (part tree) /= Just v)
      pure (with (Map.insert p value (part tree)))
    anyTarget scene =
      oneof ([ToCorner <$> elements (corners scene), ToCeiling <$> elements (sides scene)] <> [pure ToSky])

spec :: Spec
spec = do
  describe "every state" $
    modifyMaxSuccess (* 3) $ do
      it "keeps all laws, before and after each step" $
        property $ \(SmallScene s) ->
          let scene = sampleScene s in conjoin [violations scene state === [] | state <- statesOf scene]
      it "keeps them where polygons touch" $
        property $ \(TouchingScene s) -> forAllState s $ \state -> violations (sampleScene s) state === []
      it "keeps them in scenes of any kind" $
        property $ \(AnyScene s) -> forAllState s $ \state -> violations (sampleScene s) state === []
  describe "the laws notice" $ do
    forM_ parts $ \part -> it ("a wrong " <> partName part) $
      property $ \(LatticeScene s) -> forAllState s $ \state -> forAll (elements [Rightward, Leftward]) $ \way ->
        let scene = sampleScene s
            tree = treeOf way state
         in forAllBlind (spoilt part scene tree) $ \found -> case found of
              Nothing -> discard
              Just wrong -> counterexample (show (way, wrong)) (noticed s (withTree way wrong state))
    it "a flag without a pending corner, and a pending corner without a flag" $
      property $ \(LatticeScene s) -> forAllState s $ \state -> forAll (elements (corners (sampleScene s))) $ \p ->
        let flags = isPending state
         in noticed s state {isPending = if Set.member p flags then Set.delete p flags else Set.insert p flags}
    it "a sweep that stops before a vertex of two corners" $
      property $ \(LatticeScene s) ->
        let scene = sampleScene s
            isOrdinary (_, vertex) = not (isDegenerate scene vertex)
            early = map fst (filter isOrdinary (zip (statesOf scene) (verticesOf scene)))
         in not (null early) ==> forAll (choose (0, length early - 1)) $ \k ->
              conjoin [noticed s state {pending = [], isPending = Set.empty} | state <- take 1 (drop k early)]
  describe "a horizon tree" $
    modifyMaxSuccess (* 3) $ do
      it "leads, in every state, along the unswept pair of least slope" $
        property $ \(SmallScene s) -> leadsAlongLeast (sampleScene s)
      it "leads, in every state, along the unswept pair of least slope, where polygons touch" $
        forAllShrink (resize 10 touchingScene) shrinkSample $ \s ->
          cornerCount (sampleScene s) <= 24 ==> leadsAlongLeast (sampleScene s)
      it "ends with what each corner sees upward" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
              end = last (statesOf scene)
           in conjoin
                [ counterexample (show (way, c)) (Map.lookup c (targets (treeOf way end)) === upward scene way c)
                | way <- [Rightward, Leftward]
                , c <- corners scene
                ]
  describe "the vertices" $
    it "are those of brute force" $
      property $ \(AnyScene s) -> let scene = sampleScene s in sort (verticesOf scene) === bruteForce scene
  where
    noticed s state = counterexample "not noticed" (not (null (violations (sampleScene s) state)))
    withTree Rightward tree state = state {rightTree = tree}
    withTree Leftward tree state = state {leftTree = tree}
    leadsAlongLeast scene =
      conjoin
        [ counterexample (show (length done, way, c)) $
            cornerAhead (treeOf way state) c === nextPair scene all' swept way c
        | let all' = concatMap (vertexPairs scene) (bruteForce scene)
        , (state, done) <- zip (statesOf scene) (inits (verticesOf scene))
        , let swept = concatMap (vertexPairs scene) done
        , way <- [Rightward, Leftward]
        , c <- corners scene
        ]
    -- After the half turn the right-going ray is the one that was the left-going one before it.
    upward scene way c = case shoot scene c (case way of Rightward -> opposed (steep scene); Leftward -> steep scene) of
      Meets (Side side) -> Just (ToCeiling side)
      Meets Sky -> Just ToSky
      Solid -> Nothing
    opposed (Direction x y) = Direction (-x) (-y)
    nextPair scene pairs swept way c =
      case sortBy (bySlope scene c) (concatMap (from way c) (filter (`notElem` swept) pairs)) of
        q : _ -> Just q
        [] -> Nothing
    from Rightward c (a, b) = [b | a == c]
    from Leftward c (a, b) = [a | b == c]
    -- Of a wall's two faces on one line, that which has free space on the right of the way comes first.
    bySlope scene c p q = case turned scene c p q of
      LeftTurn -> LT
      Collinear -> if nextCorner scene c == p then LT else GT
      RightTurn -> GT

-- | All states of a sweep, the first and the last one too.
statesOf :: Scene -> [State]
statesOf scene = start scene : unfoldr (fmap (\(_, state) -> (state, state)) . step scene) (start scene)

verticesOf :: Scene -> [Vertex]
verticesOf scene = unfoldr (step scene) (start scene)

-- | Any state of the sweep of a scene.
forAllState :: Testable p => Sample -> (State -> p) -> Property
forAllState s f = forAll (choose (0, length states - 1)) $ \k -> conjoin (map f (take 1 (drop k states)))
  where
    states = statesOf (sampleScene s)

-- | A direction after -90 degrees, steeper than any line of two corners that is not vertical.
steep :: Scene -> Direction
steep scene = Direction 1 (-1 - height)
  where
    height = maximum (0 : [ceiling (snd (coordinates (cornerAt scene c))) | c <- corners scene])
