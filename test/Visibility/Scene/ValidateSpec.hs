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
    prop "keep their corners under the file's names, those between the ends of a wall twice, once for each face" $
      forAllValid $ \raw scene ->
        conjoin
          [ sort [(cornerName scene c, cornerPoint scene c) | c <- corners scene]
              === sort
                [ (CornerName p k, point)
                | (p, polygon) <- polygonsOf raw
                , (k, point) <- zip [0 ..] (rawCorners polygon)
                , _ <- [() | rawForm polygon == Polyline, k > 0, k < length (rawCorners polygon) - 1] <> [()]
                ]
          , statedCorners scene
              === [ (CornerName p k, point)
                  | (p, polygon) <- polygonsOf raw
                  , (k, point) <- zip [0 ..] (rawCorners polygon)
                  ]
          , conjoin [namesHere scene c === [cornerName scene c] | c <- corners scene]
          , sceneContacts scene === 0
          ]
    prop "name sides by the file's corners k and k+1" $
      forAllValid $ \raw scene ->
        Map.fromList
          [ (sideName scene s, Set.fromList (map (cornerName scene) [sideStart s, sideEnd scene s]))
          | s <- sides scene
          ]
          === Map.fromList
            [ (SideName p k, Set.fromList [CornerName p i, CornerName p j])
            | (p, polygon) <- polygonsOf raw
            , let n = length (rawCorners polygon)
            , (k, i, j) <- case rawForm polygon of
                Ring -> [(k, k, (k + 1) `mod` n) | k <- [0 .. n - 1]]
                Polyline -> concat [[(k, k, k + 1), (2 * n - 3 - k, k + 1, k)] | k <- [0 .. n - 2]]
            ]
    prop "give each side its own material" $
      forAllValid $ \raw scene ->
        Map.fromList [(sideName scene s, sideMaterial scene s) | s <- sides scene]
          === Map.fromList
            [ (SideName p k, Material (fromMaybe (emission whole) e) (fromMaybe (reflectivity whole) r))
            | (p, polygon) <- polygonsOf raw
            , let whole = rawMaterial polygon
            , k <- [0 .. sideTotal polygon - 1]
            , let MaterialOverride e r = Map.findWithDefault (MaterialOverride Nothing Nothing) k (rawSides polygon)
            ]
    prop "have the solid on the left of each side" $
      forAllValid $ \raw scene ->
        conjoin
          [ counterexample (show (p, map (cornerName scene) walk)) $
              conjoin
                [ signum (doubledArea (map (cornerPoint scene) walk))
                    === (if rawForm polygon == Polyline then 0 else if p == Enclosure then -1 else 1)
                , length walk === sideTotal polygon
                , map (previousCorner scene) (drop 1 walk <> take 1 walk) === walk
                ]
          | (p, polygon) <- polygonsOf raw
          , first <- concatMap (take 1) (cornersNamed scene (CornerName p 0))
          , let walk = first : takeWhile (/= first) (drop 1 (iterate (nextCorner scene) first))
          ]
    prop "have the polygons that the file states" $
      forAllValid $ \raw scene ->
        scenePolygons scene
          === [ Polygon p (rawPolygonName polygon) (rawForm polygon) (rawCorners polygon)
              | (p, polygon) <- polygonsOf raw
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
  describe "validate: contacts are no defects" $
    mapM_
      ( \(name, polygons, places) ->
          prop name $
            forAll (similar (RawScene Nothing Nothing polygons)) $ \raw ->
              (errorsOf raw, sceneContacts <$> either (const Nothing) Just (validate raw)) === ([], Just places)
      )
      contactsWithoutDefect
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
        inside gap =
          RawScene Nothing (Just square) [rawPolygon [at (1 % 2) (1 % 2), at (1 - gap) (1 % 3), at (1 - gap) (2 % 3)]]
        side p = SideName (Obstacle p)
        contactsOf raw = either (Left . toList) (Right . sceneContacts) (validate raw)
    it "beside a square" $ do
      contactsOf (pair' tiny) `shouldBe` Right 0
      contactsOf (pair' 0) `shouldBe` Right 1
      errorsOf (pair' (-tiny))
        `shouldBe` [CrossingSides (side 0 1) (side 1 0), CrossingSides (side 0 1) (side 1 2)]
    it "beside a wall" $ do
      contactsOf (walls tiny) `shouldBe` Right 0
      contactsOf (walls 0) `shouldBe` Right 1
      errorsOf (walls (-tiny)) `shouldBe` [CrossingSides (side 0 0) (side 1 0)]
    it "along the side of a room" $ do
      contactsOf (inside tiny) `shouldBe` Right 0
      contactsOf (inside 0) `shouldBe` Right 2
      errorsOf (inside (-tiny))
        `shouldBe` [ CrossingSides (side 0 0) (SideName Enclosure 1)
                   , CrossingSides (side 0 2) (SideName Enclosure 1)
                   ]
  where
    forAllValid check = forAll validScenes $ \raw ->
      either (\e -> counterexample (show e) (property False)) (check raw) (validate raw)

errorsOf :: RawScene -> [SceneError]
errorsOf = either toList (const []) . validate

-- The constructor, and whether one polygon or two take part, or the enclosure.
kind :: SceneError -> String
kind e = case e of
  CrossingSides (SideName p _) (SideName q _) -> constructor <> (if p == q then " itself" else "")
  OverlappingWalls p q -> constructor <> (if p == q then " itself" else "")
  OverlappingPolygons _ q -> constructor <> (if q == Enclosure then " enclosure" else "")
  _ -> constructor
  where
    constructor = takeWhile (/= ' ') (show e)

allKinds :: [String]
allKinds =
  words "EmptyScene TooFewCorners RepeatedCorner ZeroArea Spike NestedPolygon OutsideEnclosure NoSuchSide"
    <> words "BadEmission BadReflectivity CornerOnSide CrossingSides OverlappingPolygons OverlappingWalls"
    <> ["CrossingSides itself", "OverlappingWalls itself", "OverlappingPolygons enclosure"]

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
  , ( "a polygon inside another that touches it in a corner"
    , \p ->
        ( [square, rawPolygon [at 9 9, at 5 4, at 4 5]]
        , [OverlappingPolygons (Obstacle p) (Obstacle (p + 1))]
        )
    )
  , ( "a polygon inside another that touches a side of it"
    , \p ->
        ( [square, rawPolygon [at 2 2, at 9 4, at 2 6]]
        , [OverlappingPolygons (Obstacle p) (Obstacle (p + 1))]
        )
    )
  , ( "a wall that touches from inside"
    , \p ->
        ( [square, rawPolygon [at 2 2, at 9 4]]
        , [OverlappingPolygons (Obstacle p) (Obstacle (p + 1))]
        )
    )
  , ( "a wall from a corner to a corner through a polygon, before it"
    , \p ->
        ( [rawPolygon [at 9 9, at 0 0], square]
        , [OverlappingPolygons (Obstacle p) (Obstacle (p + 1))]
        )
    )
  , ( "a wall that goes through a polygon by a corner and a flat corner"
    , \p ->
        ( [rawPolygon [at 2 2, at 4 2, at 9 2, at 9 9, at 2 9], rawPolygon [at 4 0, at 4 12]]
        , [CrossingSides (side p 3) (side (p + 1) 0)]
        )
    )
  , ( "a bent wall that comes in by one corner and goes out by another"
    , \p ->
        ( [square, rawWall [at 10 12, at 9 9, at 4 5, at 9 0, at 12 0]]
        , [OverlappingPolygons (Obstacle p) (Obstacle (p + 1))]
        )
    )
  , ( "sides along each other with the solid on one side"
    , \p ->
        ( [square, rawPolygon [at 4 0, at 9 0, at 6 3]]
        , [OverlappingPolygons (Obstacle p) (Obstacle (p + 1))]
        )
    )
  , ( "one polygon twice, from other corners and the other way round"
    , \p ->
        ( [square, rawPolygon [at 0 9, at 9 9, at 9 0, at 0 0]]
        , [OverlappingPolygons (Obstacle p) (Obstacle (p + 1))]
        )
    )
  , ( "three polygons in one place, of which two overlap"
    , \p ->
        ( [square, rawPolygon [at 9 9, at 20 9, at 20 20], rawPolygon [at 9 9, at 20 10, at 20 12]]
        , [OverlappingPolygons (Obstacle (p + 1)) (Obstacle (p + 2))]
        )
    )
  , ( "walls along each other"
    , \p ->
        ( [rawPolygon [at 0 0, at 6 3], rawWall [at 9 0, at 8 4, at 4 2]]
        , [OverlappingWalls (Obstacle p) (Obstacle (p + 1))]
        )
    )
  , ( "a wall along itself"
    , \p ->
        ( [rawWall [at 0 0, at 9 0, at 9 5, at 5 0, at 3 0]]
        , [OverlappingWalls (Obstacle p) (Obstacle p)]
        )
    )
  , ( "a wall that turns back"
    , \p ->
        ( [rawWall [at 0 0, at 9 0, at 5 0, at 5 5]]
        , [Spike (corner p 1) (at 9 0)]
        )
    )
  , ( "a wall that repeats a corner"
    , \p ->
        ( [rawWall [at 0 0, at 9 0, at 9 0, at 9 9, at 0 0]]
        , [RepeatedCorner (corner p 2) 1 (at 9 0)]
        )
    )
  , ( "a wall across itself"
    , \p ->
        ( [rawWall [at 0 0, at 9 9, at 9 0, at 0 9]]
        , [CrossingSides (side p 0) (side p 2)]
        )
    )
  , ( "walls that cross"
    , \p ->
        ( [rawPolygon [at 0 0, at 9 9], rawPolygon [at 0 9, at 9 0]]
        , [CrossingSides (side p 0) (side (p + 1) 0)]
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
  , ( "a side number too large for a wall"
    , \p ->
        ( [ (rawWall [at 0 0, at 4 0, at 4 4])
              { rawSides = Map.fromList [(k, MaterialOverride Nothing Nothing) | k <- [3, 4]]
              }
          ]
        , [NoSuchSide (side p 4) 4]
        )
    )
  ]
  where
    corner p = CornerName (Obstacle p)
    side p = SideName (Obstacle p)
    square = rawPolygon [at 0 0, at 9 0, at 9 9, at 0 9]

-- | Polygons that touch as they may, and the number of places where they do.
contactsWithoutDefect :: [(String, [RawPolygon], Int)]
contactsWithoutDefect =
  [ ("corners that touch", [square, rawPolygon [at 9 9, at 12 9, at 12 12]], 1)
  , ("a corner that touches a side", [square, rawPolygon [at 12 9, at 9 4]], 1)
  , ("a corner in a reflex one", [rawPolygon [at 0 0, at 9 0, at 4 4, at 8 9], rawPolygon [at 4 4, at 9 2, at 9 6]], 1)
  , ("sides along each other", [square, rawPolygon [at 4 0, at 13 0, at 13 (-5)]], 2)
  , ("a whole side along another one", [square, rawPolygon [at 9 0, at 20 0, at 20 9, at 9 9]], 2)
  , ("a side that covers two others", [square, rawPolygon [at 0 9, at 9 9, at 9 20, at 0 20], tall], 4)
  , ("a polygon that fills a notch", [notched, rawPolygon [at 3 3, at 6 3, at 6 9, at 3 9]], 4)
  , ("a wall through a corner", [rawPolygon [at 0 0, at 9 0, at 5 5], rawPolygon [at 0 5, at 9 5]], 1)
  , ("a wall along a side, and beyond it", [square, rawPolygon [at 4 9, at 12 9]], 2)
  , ("a wall between two polygons that touch", [square, tall, rawPolygon [at 9 0, at 9 9]], 2)
  , ("a wall from polygon to polygon", [square, rawPolygon [at 12 0, at 20 0, at 20 9], rawWall [at 9 4, at 12 0]], 2)
  , ("walls that share an end", [rawPolygon [at 0 0, at 4 4], rawPolygon [at 4 4, at 9 0]], 1)
  , ("walls on one line that share an end", [rawPolygon [at 0 0, at 4 4], rawPolygon [at 4 4, at 9 9]], 1)
  , ("a wall that ends on a wall", [rawPolygon [at 0 0, at 9 9], rawPolygon [at 4 4, at 9 0]], 1)
  , ("walls that cross in corners", [rawWall [at 0 0, at 4 4, at 9 0], rawWall [at 0 9, at 4 4, at 4 (-9)]], 1)
  , ("a wall that comes back to its beginning", [rawWall [at 0 0, at 9 0, at 5 5, at 0 0]], 1)
  , ("a wall that ends on itself", [rawWall [at 0 0, at 9 0, at 9 9, at 4 0]], 1)
  , ("a wall that goes through itself by a corner", [rawWall [at 0 0, at 5 5, at 9 9, at 9 0, at 5 5, at 0 9]], 1)
  ]
  where
    square = rawPolygon [at 0 0, at 9 0, at 9 9, at 0 9]
    tall = rawPolygon [at 9 0, at 15 0, at 15 20, at 9 20]
    notched = rawPolygon [at 0 0, at 9 0, at 9 9, at 6 9, at 6 3, at 3 3, at 3 9, at 0 9]
