module Visibility.Complex.LawSpec (spec) where

import Control.Monad (forM_)
import Data.List (nub, sort, (\\))
import qualified Data.Vector.Unboxed as U
import System.Directory (listDirectory)
import System.FilePath (takeExtension, (</>))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Complex.Build
import Visibility.Complex.Law
import Visibility.Complex.Law.Measure
import Visibility.Complex.Law.Section
import Visibility.Complex.Mutation
import Visibility.Complex.Type
import Visibility.Exact.Point (Arithmetic (..))
import Visibility.Exact.Predicate
import Visibility.Exact.RootSum (fromTerms)
import Visibility.Format.File (readSceneFile)
import Visibility.Law
import Visibility.Ray
import Visibility.Test.Ray
import Visibility.Scene
import Visibility.Sweep
import Visibility.Test.Generator
import Visibility.View (Event (..), Flank (..), Incidence (..), events, incidences)

spec :: Spec
spec = do
  describe "the laws of the complex" $ do
    it "have names of their own" $
      length (nub (map lawName laws)) `shouldBe` length laws
    modifyMaxSuccess (* 30) $
      it "hold in scenes of any kind" $
        property $ \(AnyScene s) -> violations (complexOf s) === []
    modifyMaxSuccess (* 10) $
      it "hold where polygons touch" $
        property $ \(TouchingScene s) -> violations (complexOf s) === []
    it "hold beyond machine integers" $
      property $ \(HardScene s) -> violations (complexOf s) === []
    it "judge by exact signs, whatever the arithmetic of the scene" $
      property $ \(HardScene s) ->
        let c = complexOf s
         in violations c {sweptScene = underArithmetic UnsafeDouble (complexScene c)} === []
    it "hold whatever order the vertices come in" $
      property $ \(LatticeScene s) ->
        forAll arbitrary $ \seed ->
          let scene = sampleScene s
           in violations (build scene (reordered seed scene)) === []
    files <- runIO (concat <$> mapM sceneFiles ["scenes", "test" </> "vectors"])
    forM_ files $ \file ->
      it ("hold for " <> file) $ do
        result <- readSceneFile file
        case result of
          Left problems -> expectationFailure (show problems)
          Right scene -> violations (build scene (vertices scene)) `shouldBe` []
  describe "every law" $
    it "has a mutation that it must notice" $
      map lawName laws \\ map noticedBy mutations `shouldBe` []
  describe "the laws notice" $ do
    forM_ mutations $ \mutation ->
      it (mutationName mutation) $
        forAllShrink smallScenes shrinkSample $ \s ->
          let broken' = mutants mutation (complexOf s)
           in not (null broken') ==> forAll (choose (0, length broken' - 1)) $ \k ->
                conjoin
                  [ counterexample (show (nub found)) (noticedBy mutation `elem` found)
                  | c <- take 1 (drop k broken')
                  , let found = map violatedLaw (violations c)
                  ]
    modifyMaxSuccess (* 10) $
      it "any one wrong number in any table" $
        forAllShrink smallScenes shrinkSample $ \s -> forAll (elements allTables) $ \table ->
          let c = complexOf s
              size = U.length (tableOf table c)
           in size > 0 ==> forAll (choose (0, size - 1)) $ \i -> forAll (choose (numbers table c)) $ \x ->
                x /= fromIntegral (tableOf table c U.! i) ==>
                  counterexample (tableName table) $
                    not (null (violations (anyWrongNumber table i x c)))
  describe "sections" $ do
    it "are those of the scene at any direction" $
      property $ \(AnyScene s) -> forAll (vectorOf 3 arbitrary) $ \seeds ->
        sectionsAgree (directionsFrom seeds) (complexOf s) === []
    it "are those of the scene within the stretches" $
      property $ \(SmallScene s) ->
        let c = complexOf s
            inside = [d | e <- stretchIds c, not (wrapsAround c e), let d = between (edgeFrom c e) (edgeTo c e)]
         in sectionsAgree inside c === []
    it "have as many faces as begin below corners, and one more under the sky" $
      property $ \(AnyScene s) -> forAll (vectorOf 3 arbitrary) $ \seeds ->
        let scene = sampleScene s
            outer = case surroundings scene of OpenSky -> 1; Room -> 0
         in conjoin
              [ length (sectionOf (complexOf s) d)
                  === outer
                  + length [() | c <- corners scene, Incidence Below _ _ <- incidences scene c (viewAt scene c d)]
              | d <- directionsFrom seeds
              , isGeneric scene d
              ]
  describe "a vertex of two corners" $
    modifyMaxSuccess (* 3) $
      it "has the edges and faces of its kind" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
              faces views e = sum (map length (zipWith (incidences scene) (vertexCorners (eventVertex e)) (views e)))
           in conjoin
                [ counterexample (show v) $
                    (length (vertexEdges c i), faces viewsBefore e, faces viewsAfter e) === (edges, expected, expected)
                | let c = complexOf s
                , (i, e) <- zip (vertexIds c) (events scene (vertices scene))
                , let v = eventVertex e
                , length (vertexCorners v) == 2
                , let (edges, expected) = degreesByKind scene v (vertexKinds c i)
                ]
  describe "the measures of faces" $
    it "of a thin wall's two faces are twice its length each" $
      fmap (map snd . boundaryMeasures . complexOf) (sampleOf [[(0, 0), (3, 1)]])
        `shouldBe` fmap (replicate 2) (fromTerms [(2, 10)])

-- | Few corners, and polygons that touch as often as not.
smallScenes :: Gen Sample
smallScenes =
  oneof
    [ (\(SmallScene s) -> s) <$> arbitrary
    , resize 10 touchingScene `suchThat` ((<= 24) . cornerCount . sampleScene)
    ]

complexOf :: Sample -> Complex
complexOf s = build (sampleScene s) (vertices (sampleScene s))

-- | The vertices by direction; those of one direction in any order.
reordered :: Int -> Scene -> [Vertex]
reordered seed scene = map third (sort [(Slope (vertexDirection scene v), key v, v) | v <- vertices scene])
  where
    third (_, _, v) = v
    key v = sum [(k * 7919 + seed) `mod` 101 | CornerId k <- vertexCorners v]

-- | Directions in their order.
newtype Slope = Slope Direction

instance Eq Slope where
  a == b = compare a b == EQ

instance Ord Slope where
  compare (Slope a) (Slope b) = compareDirections a b

-- | Edges and faces of a vertex of two corners.
degreesByKind :: Scene -> Vertex -> [Kind] -> (Int, Int)
degreesByKind scene v kinds = case (vertexCorners v, kinds) of
  ([p, q], [AlongSide, AlongSide])
    | nextCorner scene p == q && previousCorner scene p == q -> (4, 6)
    | otherwise -> case length (filter isReflex [p, q]) of
        0 -> (4, 5)
        1 -> (3, 4)
        _ -> (2, 3)
  (_, found) -> (4, 6 - length [() | EndingAt _ <- found])
  where
    isReflex c =
      turn (scenePoints scene) (index (previousCorner scene c)) (index c) (index (nextCorner scene c)) == RightTurn
    index (CornerId k) = k

sceneFiles :: FilePath -> IO [FilePath]
sceneFiles folder = concatMap found . sort <$> listDirectory folder
  where
    found name
      | takeExtension name == ".json" = [folder </> name]
      | folder == "scenes" = []
      | otherwise = [folder </> name </> "scene.json"]
