module Visibility.Scene.FlatSpec (spec) where

import Data.List (nub, sort)
import qualified Data.Map.Strict as Map
import Data.Ratio ((%))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Complex (build)
import Visibility.Complex.Law (violations)
import Visibility.Exact.Point (Point (..))
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.FormFactor
import Visibility.Scene
import Visibility.Scene.Flat
import Visibility.Sweep
import Visibility.Test.BruteForce (bruteForce)
import Visibility.Test.Generator

spec :: Spec
spec =
  describe "a scene with flat corners" $ do
    it "is the scene itself where there are none" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            flat = fst (withFlatCorners (const []) scene)
         in conjoin
              [ vertices flat === vertices scene
              , map (cornerName flat) (corners flat) === map (cornerName scene) (corners scene)
              , statedCorners flat === statedCorners scene
              ]
    modifyMaxSuccess (* 2) $
      it "is swept as brute force finds its vertices" $
        forAllCut $ \_ flat _ -> sort (vertices flat) === bruteForce flat
    -- It takes the most time.
    modifyMaxSuccess (`div` 2) $
      it "obeys all laws of the complex" $
        forAllCut $ \_ flat _ -> violations (build flat (vertices flat)) === []
    it "has its corners in lexicographic order, each named after one in its place" $
      forAllCut $ \_ flat _ ->
        let places = map (cornerPoint flat) (corners flat)
         in conjoin
              [ places === sort places
              , map (statedPoint flat . cornerName flat) (corners flat) === map Just places
              , conjoin [fmap (elem c) (cornersNamed flat (cornerName flat c)) === Just True | c <- corners flat]
              ]
    it "has each element once, in the file's direction and order, with the material of its side" $
      forAllCut $ \scene flat owned ->
        let whole = [(name, from, end) | name <- statedSides scene, Just (from, end) <- [endsIn scene name]]
            parts = [(name, from, end) | name <- statedSides flat, Just (from, end) <- [endsIn flat name]]
            owners = ownersOf scene flat
         in conjoin
              [ map (fmap length . piecesOf flat) (statedSides flat) === map (const (Just 1)) (statedSides flat)
              , sort (map fst owners) === sort (statedSides flat)
              , conjoin
                  [ counterexample (show (part, owner)) $
                      along whole' (a, b) && sideMaterial flat s == sideMaterial scene t
                  | (part, a, b) <- parts
                  , (owner, whole') <- [(o, (u, v)) | (o, u, v) <- whole, lookup part owners == Just o]
                  , s <- concat (piecesOf flat part)
                  , t <- take 1 (concat (piecesOf scene owner))
                  ]
              , map snd owners === sort (map snd owners)
              , map snd owners === owned
              ]
    it "has the measures of the scene, added up" $
      forAllCut $ \scene flat _ ->
        let owner = Map.fromList (ownersOf scene flat)
            named seen = case seen of
              TheSide part -> maybe TheSky TheSide (Map.lookup part owner)
              TheSky -> TheSky
            both a b = if a <= b then (a, b) else (b, a)
            summed =
              RootSum.totalsBy
                [(both (named a) (named b), measure) | ((a, b), measure) <- statedMeasures flat (measuresOf flat)]
         in summed === Map.fromList (statedMeasures scene (measuresOf scene))
    it "can be cut again" $
      forAllCut $ \_ flat _ ->
        let twice = fst (withFlatCorners (cutsAt [1 % 3] flat) flat)
            -- Brute force takes the cube of the number of corners.
            expected = if cornerCount twice <= 80 then bruteForce twice else straightVertices twice
         in sort (vertices twice) === sort expected
  where
    measuresOf scene = measures scene (vertices scene)

-- | A scene of any kind and the same with a few flat corners.
forAllCut :: Testable p => (Scene -> Scene -> [SideName] -> p) -> Property
forAllCut check =
  forAll (oneof [kind (\(AnyScene s) -> s), kind (\(TouchingScene s) -> s), kind (\(LatticeScene s) -> s)]) $ \s ->
    forAll (nub . sort <$> resize 3 (listOf1 part)) $ \parts ->
      let scene = sampleScene s in uncurry (check scene) (withFlatCorners (cutsAt parts scene) scene)
  where
    kind :: Arbitrary a => (a -> Sample) -> Gen Sample
    kind of' = of' <$> arbitrary
    part = do
      q <- choose (2, 7)
      (% q) <$> choose (1, q - 1)

-- | The points at these parts of the way along each piece, ascending; more of them on every other piece.
cutsAt :: [Rational] -> Scene -> SideId -> [Point]
cutsAt parts scene s@(SideId k) =
  [Point (ax + t * (bx - ax)) (ay + t * (by - ay)) | t <- if even k then parts else take 1 parts]
  where
    Point ax ay = cornerPoint scene (sideStart s)
    Point bx by = cornerPoint scene (sideEnd scene s)

-- | Where a side of the file begins and ends.
endsIn :: Scene -> SideName -> Maybe (Point, Point)
endsIn scene name = case piecesOf scene name of
  Just (s : _) -> Just (cornerPoint scene (sideStart s), cornerPoint scene (sideEnd scene s))
  _ -> Nothing

-- | Does the second segment lie on the line of the first?
along :: (Point, Point) -> (Point, Point) -> Bool
along (a, b) (c, d) = cross a b c == 0 && cross a b d == 0
  where
    cross (Point ax ay) (Point bx by) (Point cx cy) = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)

-- | The elements in order, each with the side that it is a part of: the one whose faces hold it, by the way that free
-- space lies.
ownersOf :: Scene -> Scene -> [(SideName, SideName)]
ownersOf scene flat =
  [ (part, owner)
  | part <- statedSides flat
  , s <- concat (piecesOf flat part)
  , let from = cornerPoint flat (sideStart s)
  , let end = cornerPoint flat (sideEnd flat s)
  , owner <- take 1 [sideName scene t | t <- sides scene, holds t from end]
  ]
  where
    holds t from end = along (a, b) (from, end) && isInside from && isInside end && (from < end) == (a < b)
      where
        a = cornerPoint scene (sideStart t)
        b = cornerPoint scene (sideEnd scene t)
        isInside p = min a b <= p && p <= max a b
