module Visibility.Scene.ValidateSpec (spec) where

import Data.Foldable (toList)
import Data.List (sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Ratio ((%))
import qualified Data.Set as Set
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck
import Visibility.Error
import Visibility.Exact.Point (Point (..))
import Visibility.Scene
import Visibility.Scene.Oracle
import Visibility.Scene.Raw
import Visibility.Scene.Sample
import Visibility.Scene.Validate

spec :: Spec
spec = do
  describe "validate: the errors are those of a comparison of all pairs" $ do
    modifyMaxSuccess (* 40) $
      prop "of cluttered scenes" $
        forAll clutteredScenes $ \raw ->
          classify (null (naiveErrors raw)) "valid" $
            tabulate "kinds" (map kind (Set.toList (naiveErrors raw))) $
              Set.fromList (errorsOf raw) === naiveErrors raw
    prop "whatever the scale" $
      forAll (clutteredScenes >>= similar) $ \raw -> Set.fromList (errorsOf raw) === naiveErrors raw
    it "meets every kind of error, and valid scenes" $
      checkCoverage $
        forAll clutteredScenes $ \raw ->
          let errors = naiveErrors raw
              kinds = Set.map kind errors
           in foldr (\k -> cover 0.5 (k `Set.member` kinds) k) (cover 1 (Set.null errors) "valid" True) allKinds
    prop "in order of polygon and then of corner or side, nothing twice" $
      forAll clutteredScenes $ \raw ->
        let places = map (\e -> (sceneErrorPlace e, e)) (errorsOf raw)
         in places === Set.toAscList (Set.fromList places)
  describe "validate: valid scenes" $ do
    prop "are valid to the oracle and to validate" $
      forAll validScenes $ \raw -> (errorsOf raw, naiveErrors raw) === ([], Set.empty)
    prop "keep their corners under the file's names" $
      forAllValid $ \raw scene ->
        sort [(cornerName scene c, cornerPoint scene c) | c <- corners scene]
          === sort
            [ (CornerName p k, point)
            | (p, polygon) <- polygonsOf raw
            , (k, point) <- zip [0 ..] (rawCorners polygon)
            ]
    prop "name sides by the file's corners k and k+1" $
      forAllValid $ \raw scene ->
        Map.fromList
          [ (sideName scene s, Set.fromList (map (cornerName scene) [sideStart s, sideEnd scene s]))
          | s <- sides scene
          ]
          === Map.fromList
            [ (SideName p k, Set.fromList [CornerName p k, CornerName p ((k + 1) `mod` n)])
            | (p, polygon) <- polygonsOf raw
            , let n = length (rawCorners polygon)
            , k <- [0 .. n - 1]
            ]
    prop "give each side its own material" $
      forAllValid $ \raw scene ->
        Map.fromList [(sideName scene s, sideMaterial scene s) | s <- sides scene]
          === Map.fromList
            [ (SideName p k, Material (fromMaybe (emission whole) e) (fromMaybe (reflectivity whole) r))
            | (p, polygon) <- polygonsOf raw
            , let whole = rawMaterial polygon
            , k <- [0 .. length (rawCorners polygon) - 1]
            , let MaterialOverride e r = Map.findWithDefault (MaterialOverride Nothing Nothing) k (rawSides polygon)
            ]
    prop "have the solid on the left of each side, and begin with the file's corner 0" $
      forAllValid $ \raw scene ->
        conjoin
          [ counterexample (show polygon) $
              conjoin
                [ polygonId polygon === p
                , polygonName polygon === rawPolygonName (snd from)
                , map (cornerName scene) (take 1 (polygonCorners polygon)) === [CornerName p 0]
                , signum (doubledArea (map (cornerPoint scene) (polygonCorners polygon)))
                    === (if length (polygonCorners polygon) == 2 then 0 else if p == Enclosure then -1 else 1)
                , map (nextCorner scene) (polygonCorners polygon)
                    === take (length (polygonCorners polygon)) (drop 1 (cycle (polygonCorners polygon)))
                ]
          | (polygon, from@(p, _)) <- zip (scenePolygons scene) (polygonsOf raw)
          ]
    prop "are in a room when they have an enclosure" $
      forAllValid $ \raw scene ->
        (surroundings scene, sceneTitle scene) === (maybe OpenSky (const Room) (rawEnclosure raw), rawName raw)
  describe "validate: a defect in a valid scene is found and named" $
    mapM_
      ( \(name, defect) ->
          prop name $ forAll (validScenes >>= defective defect) $ \(raw, expected) -> errorsOf raw === expected
      )
      defects
  describe "validate: one scene, one answer" $ do
    prop "turning the corners of a polygon around changes no verdict" $
      forAll clutteredScenes $ \raw ->
        let turned p = p {rawCorners = reverse (rawCorners p)}
            clean = raw {rawPolygons = map plain (rawPolygons raw), rawEnclosure = plain <$> rawEnclosure raw}
            plain p = p {rawMaterial = black, rawSides = Map.empty}
            other = clean {rawPolygons = map turned (rawPolygons clean), rawEnclosure = turned <$> rawEnclosure clean}
         in (length (errorsOf clean), Set.map kind (Set.fromList (errorsOf clean)))
              === (length (errorsOf other), Set.map kind (Set.fromList (errorsOf other)))
    it "an enclosure alone is a scene" $
      errorsOf (RawScene Nothing (Just (rawPolygon [at 0 0, at 1 0, at 0 1])) []) `shouldBe` []
    it "nothing is no scene" $
      errorsOf (RawScene Nothing Nothing []) `shouldBe` [EmptyScene]
  describe "validate: the least gap is a gap" $ do
    let tiny = 1 % 10 ^ (40 :: Int)
        square = rawPolygon [at 0 0, at 1 0, at 1 1, at 0 1]
        pair' gap = RawScene Nothing Nothing [square, rawPolygon [at (1 + gap) (1 % 3), at 2 0, at 2 1]]
        walls gap =
          RawScene Nothing Nothing [rawPolygon [at 0 0, at 3 1], rawPolygon [at 0 2, at (3 % 2) (1 % 2 + gap)]]
        corner p = CornerName (Obstacle p)
        side p = SideName (Obstacle p)
    it "beside a square" $ do
      errorsOf (pair' tiny) `shouldBe` []
      errorsOf (pair' 0) `shouldBe` [CornerOnSide (corner 1 0) (side 0 1) (at 1 (1 % 3))]
      errorsOf (pair' (-tiny))
        `shouldBe` [CrossingSides (side 0 1) (side 1 0), CrossingSides (side 0 1) (side 1 2)]
    it "beside a wall" $ do
      errorsOf (walls tiny) `shouldBe` []
      errorsOf (walls 0) `shouldBe` [CornerOnSide (corner 1 1) (side 0 0) (at (3 % 2) (1 % 2))]
      errorsOf (walls (-tiny)) `shouldBe` [CrossingSides (side 0 0) (side 1 0)]
  where
    forAllValid check = forAll validScenes $ \raw ->
      either (\e -> counterexample (show e) (property False)) (check raw) (validate raw)

errorsOf :: RawScene -> [SceneError]
errorsOf = either toList (const []) . validate

-- The constructor, and whether one polygon or two take part.
kind :: SceneError -> String
kind e = case e of
  CornerOnSide (CornerName p _) (SideName q _) _ -> constructor <> (if p == q then " itself" else "")
  CrossingSides (SideName p _) (SideName q _) -> constructor <> (if p == q then " itself" else "")
  _ -> constructor
  where
    constructor = takeWhile (/= ' ') (show e)

allKinds :: [String]
allKinds =
  words "EmptyScene TooFewCorners RepeatedCorner ZeroArea Spike NestedPolygon OutsideEnclosure NoSuchSide"
    <> words "BadEmission BadReflectivity CornerOnCorner CornerOnSide CrossingSides"
    <> ["CornerOnSide itself", "CrossingSides itself"]

-- | A polygon or two, in a free place of the plane, and the errors they cause when the first has this number.
type Defect = Int -> ([RawPolygon], [SceneError])

-- The defect, turned, scaled and shifted within a free cell of a scene before it is moved as a whole.
defective :: Defect -> RawScene -> Gen (RawScene, [SceneError])
defective defect raw = do
  let first = length (rawPolygons raw)
      (bad, errors) = defect first
      beyond = 1 + maximum (0 : [abs z | (_, p) <- polygonsOf raw, Point x y <- rawCorners p, z <- [x, y]])
      away = 20 * beyond
      frame = RawScene Nothing Nothing bad
  factor <- elements [1, 1 % 7, 1000]
  let place (Point x y) = Point (factor * x + away) (factor * y + away)
      moved p = p {rawCorners = map place (rawCorners p)}
  pure
    ( raw {rawEnclosure = Nothing, rawPolygons = rawPolygons raw <> map moved (rawPolygons frame)}
    , map (relocated place) errors
    )

relocated :: (Point -> Point) -> SceneError -> SceneError
relocated place e = case e of
  RepeatedCorner c j point -> RepeatedCorner c j (place point)
  Spike c point -> Spike c (place point)
  CornerOnCorner c d point -> CornerOnCorner c d (place point)
  CornerOnSide c s point -> CornerOnSide c s (place point)
  _ -> e

defects :: [(String, Defect)]
defects =
  [ ( "a repeated corner"
    , \p ->
        ( [rawPolygon [at 0 0, at 9 0, at 9 0, at 5 9]]
        , [RepeatedCorner (corner p 2) 1 (at 9 0)]
        )
    )
  , ( "a corner repeated later"
    , \p ->
        ( [rawPolygon [at 0 0, at 9 0, at 5 4, at 9 9, at 0 9, at 5 4]]
        , [RepeatedCorner (corner p 5) 2 (at 5 4)]
        )
    )
  , ( "a wall of no length"
    , \p ->
        ( [rawPolygon [at 1 1, at 1 1]]
        , [RepeatedCorner (corner p 1) 0 (at 1 1)]
        )
    )
  , ( "no area"
    , \p ->
        ( [rawPolygon [at 0 0, at 6 4, at 3 2]]
        , [ZeroArea (Obstacle p)]
        )
    )
  , ( "a spike outwards"
    , \p ->
        ( [rawPolygon [at 0 0, at 9 0, at 0 9, at 0 20]]
        , [Spike (corner p 3) (at 0 20)]
        )
    )
  , ( "a spike along a side"
    , \p ->
        ( [rawPolygon [at 0 0, at 9 0, at 9 9, at 9 4, at 0 4]]
        , [Spike (corner p 2) (at 9 9)]
        )
    )
  , ( "one corner"
    , \p ->
        ( [rawPolygon [at 1 1]]
        , [TooFewCorners (Obstacle p) 1]
        )
    )
  , ( "no corner"
    , \p ->
        ( [rawPolygon []]
        , [TooFewCorners (Obstacle p) 0]
        )
    )
  , ( "a bow tie"
    , \p ->
        ( [rawPolygon [at 0 0, at 9 9, at 9 0, at 0 9]]
        , [CrossingSides (side p 0) (side p 2)]
        )
    )
  , ( "a corner on an own side"
    , \p ->
        ( [rawPolygon [at 0 0, at 9 0, at 9 9, at 4 0, at 0 9]]
        , [CornerOnSide (corner p 3) (side p 0) (at 4 0)]
        )
    )
  , ( "nested polygons"
    , \p ->
        ( [square, rawPolygon [at 2 2, at 3 2, at 2 3]]
        , [NestedPolygon (Obstacle (p + 1)) (Obstacle p)]
        )
    )
  , ( "a wall inside a polygon, before it"
    , \p ->
        ( [rawPolygon [at 2 2, at 3 2], square]
        , [NestedPolygon (Obstacle p) (Obstacle (p + 1))]
        )
    )
  , ( "corners that touch"
    , \p ->
        ( [square, rawPolygon [at 9 9, at 12 9, at 12 12]]
        , [CornerOnCorner (corner p 2) (corner (p + 1) 0) (at 9 9)]
        )
    )
  , ( "a corner that touches a side"
    , \p ->
        ( [square, rawPolygon [at 12 9, at 9 4]]
        , [CornerOnSide (corner (p + 1) 1) (side p 1) (at 9 4)]
        )
    )
  , ( "a wall that touches from inside"
    , \p ->
        ( [square, rawPolygon [at 2 2, at 9 4]]
        , [CornerOnSide (corner (p + 1) 1) (side p 1) (at 9 4)]
        )
    )
  , ( "sides that overlap"
    , \p ->
        ( [square, rawPolygon [at 4 0, at 13 0, at 13 (-5)]]
        , [ CornerOnSide (corner p 1) (side (p + 1) 0) (at 9 0)
          , CornerOnSide (corner (p + 1) 0) (side p 0) (at 4 0)
          ]
        )
    )
  , ( "walls that cross"
    , \p ->
        ( [rawPolygon [at 0 0, at 9 9], rawPolygon [at 0 9, at 9 0]]
        , [CrossingSides (side p 0) (side (p + 1) 0)]
        )
    )
  , ( "a wall through a corner"
    , \p ->
        ( [rawPolygon [at 0 0, at 9 0, at 5 5], rawPolygon [at 0 5, at 9 5]]
        , [CornerOnSide (corner p 2) (side (p + 1) 0) (at 5 5)]
        )
    )
  , ( "an emission below 0"
    , \p ->
        ( [square {rawMaterial = Material (-1 % 9) 0}]
        , [BadEmission (OfPolygon (Obstacle p)) (-1 % 9)]
        )
    )
  , ( "a reflectivity of 1"
    , \p ->
        ( [square {rawMaterial = Material 0 1}]
        , [BadReflectivity (OfPolygon (Obstacle p)) 1]
        )
    )
  , ( "a side's bad material"
    , \p ->
        ( [square {rawSides = Map.fromList [(2, MaterialOverride (Just (-1)) (Just (-1)))]}]
        , [BadEmission (OfSide (side p 2)) (-1), BadReflectivity (OfSide (side p 2)) (-1)]
        )
    )
  , ( "a side number too large"
    , \p ->
        ( [square {rawSides = Map.fromList [(4, MaterialOverride Nothing Nothing)]}]
        , [NoSuchSide (side p 4) 4]
        )
    )
  ]
  where
    corner p = CornerName (Obstacle p)
    side p = SideName (Obstacle p)
    square = rawPolygon [at 0 0, at 9 0, at 9 9, at 0 9]
