module Visibility.Scene.Family.KettnerSpec (spec) where

import Control.Monad (forM_)
import Data.List (sort)
import qualified Data.Set as Set
import Test.Hspec
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Exact.RootSum (Sign (Zero), sign)
import Visibility.Format.File (readSceneFile)
import Visibility.FormFactor
import Visibility.Scene
import Visibility.Scene.Family
import Visibility.Scene.Raw
import Visibility.Scene.Validate (validate)
import Visibility.Sweep
import Visibility.Test.BruteForce (bruteForce)
import Visibility.Test.Metamorphic (graphOf)

spec :: Spec
spec = do
  describe "the family kettner" $ do
    it "has Doubles as coordinates, as in the source" $
      property $ \seed -> forAll (choose (1, 200)) $ \n ->
        [q | Point x y <- concat (loopsOf n seed), q <- [x, y], toRational (fromRational q :: Double) /= q] === []
    it "begins with a corner at (12, 12) and one at (24, 24)" $
      property $ \seed -> map (take 1) (take 2 (loopsOf 5 seed)) === [[Point 12 12], [Point 24 24]]
    it "has its tiny triangles among the 256 by 256 points of the source, up to 46 of them" $
      property $ \seed ->
        let steps = [(q - 1 / 2) * 2 ^ (53 :: Int) | Point x y <- concat (drop 2 (loopsOf 46 seed)), q <- [x, y]]
         in (length steps, minimum steps >= 0, maximum steps < 256) === (46 * 6, True, True)
    it "is swept as brute force has it, by either sweep and under every exact arithmetic" $
      property $ \seed -> forAll (choose (1, 7)) $ \n ->
        fmap sweptRightly (sceneOf n seed) === Right True
    it "is beyond machine integers, so that the filter decides" $
      either (const False) byFilter (sceneOf 1 1) `shouldBe` True
  describe "the committed scenes" $
    forM_ [("kettner-a", 12, 1), ("kettner-b", 46, 2)] $ \(name, n, seed) -> describe name $ do
      it "is of the family" $
        inFile name $ \scene ->
          Right (cornerPoints scene) `shouldBe` fmap cornerPoints (sceneOf n seed)
      it "is swept as brute force has it, by either sweep and under every exact arithmetic" $
        inFile name $ \scene -> sweptRightly scene `shouldBe` True
      it "has corners that see both (12, 12) and (24, 24), and some exactly in line with them" $
        inFile name $ \scene -> do
          let seen = graphOf scene
              sees c p = Set.member (CornerName (Obstacle p) 0, c) seen
              both = [c | c <- map (cornerName scene) (corners scene), sees c 0, sees c 1]
              inLine = [v | v <- vertices scene, all (`elem` map (cornerName scene) (vertexCorners v)) targets]
          length both `shouldSatisfy` (>= 3)
          map (length . vertexCorners) inLine `shouldSatisfy` any (>= 3)
      it "closes exactly" $
        inFile name $ \scene ->
          [sideText s | (s, defect) <- closureDefect scene (measuresIn scene), sign defect /= Zero]
            `shouldBe` []
      it "has turns about (12, 12) and (24, 24) that Doubles do not find" $
        inFile name $ \scene -> do
          let turns arithmetic =
                [ turn (scenePoints (underArithmetic arithmetic scene)) c p q
                | [Just [CornerId p], Just [CornerId q]] <- [map (cornersNamed scene) targets]
                , CornerId c <- corners scene
                ]
          turns Filtered `shouldBe` turns Exact
          length (filter id (zipWith (/=) (turns UnsafeDouble) (turns Exact))) `shouldSatisfy` (> 10)
  where
    targets = [CornerName (Obstacle p) 0 | p <- [0, 1]]
    cornerPoints scene = [(cornerName scene c, cornerPoint scene c) | c <- corners scene]
    measuresIn scene = measures scene (vertices scene)
    byFilter scene = case pointsKernel (scenePoints scene) of
      FilterKernel _ -> True
      _ -> False

inFile :: String -> (Scene -> Expectation) -> Expectation
inFile name act =
  readSceneFile ("scenes/" <> name <> ".json") >>= either (expectationFailure . show) act

loopsOf :: Int -> Int -> [[Point]]
loopsOf n seed = maybe [] (map rawCorners . rawPolygons . rawOf seed) (size n)

rawOf :: Int -> Size -> RawScene
rawOf seed count = family Kettner count (Seed (fromIntegral seed))

sceneOf :: Int -> Int -> Either String Scene
sceneOf n seed = maybe (Left "no size") (either (Left . show) Right . validate . rawOf seed) (size n)

sweptRightly :: Scene -> Bool
sweptRightly scene =
  and
    [ sort (verticesBy scheduler (underArithmetic arithmetic scene)) == found
    | arithmetic <- [Filtered, Exact]
    , scheduler <- [Topological, Straight]
    ]
  where
    found = bruteForce scene
