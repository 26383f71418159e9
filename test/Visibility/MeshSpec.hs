module Visibility.MeshSpec (spec) where

import Data.Foldable (for_)
import Data.List (sort)
import qualified Data.Map.Strict as Map
import Data.Ratio ((%))
import qualified Data.Set as Set
import System.Directory (listDirectory)
import Report.Union (meshUnion)
import System.FilePath (takeExtension, (</>))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Point (Point (..))
import Visibility.Format.File (readSceneFile)
import Visibility.Mesh
import Visibility.Scene
import Visibility.Scene.Raw (Form (..), RawScene (..), rawPolygon)
import Visibility.Sight
import Visibility.Sweep
import Visibility.Test.Generator
import Visibility.Test.Landing
import Visibility.Test.Metamorphic
import Visibility.Test.Scan

meshOf :: Scene -> Mesh
meshOf scene = discontinuityMesh scene (vertices scene)

spec :: Spec
spec = do
  describe "the discontinuity mesh" $ do
    modifyMaxSuccess (* 2) $ do
      it "has the break points, kinds and casters that lengthened pairs of corners have" $
        property $ \(AnyScene s) -> asByRays (sampleScene s)
      it "has them where polygons touch" $
        property $ \(TouchingScene s) -> asByRays (sampleScene s)
    it "has them beyond machine integers" $
      property $ \(HardScene s) -> asByRays (sampleScene s)
    it "has them in every scene of scenes/degenerate" $ do
      files <- sort . filter ((== ".json") . takeExtension) <$> listDirectory "scenes/degenerate"
      length files `shouldSatisfy` (> 40)
      for_ files $ \file -> do
        outcome <- readSceneFile ("scenes/degenerate" </> file)
        case outcome of
          Left problems -> expectationFailure (show problems)
          Right scene -> (file, landedIn (meshOf scene)) `shouldBe` (file, landedByRays scene)
    it "is the same for every order of the vertices" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
         in landedIn (discontinuityMesh scene (straightVertices scene)) === landedIn (meshOf scene)
    modifyMaxSuccess (* 2) $
      it "is where what is seen along a side changes: there, and nowhere else" $
        property $ \(AnyScene s) ->
          let mesh = meshOf (sampleScene s)
           in forAllBlind (take 3 <$> shuffle (windows mesh)) (conjoin . map (changing (meshScene mesh)))
    it "is moved, scaled, turned and mirrored with the scene" $
      property $ \(AnyScene s) -> changesNothing s (affinity (sampleRaw s))
    it "keeps everything but names when polygons and corners are stated in another order" $
      property $ \(AnyScene s) -> changesNothing s (relabelling (sampleRaw s))
    it "has ten lines at eight points in a square room with a wall in its middle" $
      fmap cut (sampleScene <$> sample roomWithWall)
        `shouldBe` Just
          [ ("E.0", [(1 / 2, [(Kink, "0.0 E.3"), (Kink, "0.1 E.2")])])
          , ("E.1", [(1 / 3, [(Kink, "0.1 E.3")]), (1 / 2, [(Kink, "0.1 0.0")]), (2 / 3, [(Kink, "0.1 E.0")])])
          , ("E.2", [(1 / 2, [(Kink, "0.0 E.0"), (Kink, "0.1 E.1")])])
          , ("E.3", [(1 / 3, [(Kink, "0.0 E.1")]), (1 / 2, [(Kink, "0.0 0.1")]), (2 / 3, [(Kink, "0.0 E.2")])])
          ]
    it "has the limits of the shadows of a wall that another one lights, and the feet of both, on a floor" $
      fmap cut (sampleScene <$> sampleOf [floor', [(0, 0), (0, 1)], [(2, 1), (2, 2)]])
        `shouldBe` Just
          [
            ( "0.2"
            , [ (2 / 5, [(Kink, "2.0 2.1")])
              , (1 / 2, [(Kink, "1.0 1.1")])
              , (11 / 20, [(ShadowLimit, "1.0 2.1")])
              , (3 / 5, [(ShadowLimit, "1.0 2.0")])
              , (7 / 10, [(ShadowLimit, "1.1 2.1")])
              ]
            )
          , ("2.1", [(3 / 5, [(ShadowLimit, "1.1 0.3")])])
          ]

  describe "break points" $ do
    it "are strictly between the ends of their piece, in order from its start, each where its parameter says" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
         in conjoin [inPlace mesh side | mesh <- meshOf scene : uniform scene, side <- sides scene]
    it "of a side are those of its pieces, strictly increasing between 0 and 1" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            mesh = meshOf scene
         in conjoin
              [ counterexample (sideText side) $
                  sort (map breakParameter (concatMap (breaksOn mesh) (concat (piecesOf scene side))))
                    === map breakParameter points
                    .&&. property (strictly ([0] <> map breakParameter points <> [1]))
              | (side, points) <- meshSides mesh
              ]
    it "are counted" $
      property $ \(AnyScene s) ->
        let mesh = meshOf (sampleScene s) in breakCount mesh === length (concatMap snd (meshSides mesh))
    it "are none on a side that the scene has not" $
      property $ \(SmallScene s) -> breaksOf (meshOf (sampleScene s)) (SideName (Obstacle 1000) 0) === []

  describe "shadow limits" $
    it "are the break points with a free bitangent among their lines" $
      property $ \(AnyScene s) ->
        let mesh = meshOf (sampleScene s)
            isLimit point = ShadowLimit `elem` map casterKind (breakCasters point)
         in map snd (meshSides (shadowLimits mesh)) === map (filter isLimit . snd) (meshSides mesh)

  describe "a uniform mesh" $ do
    it "has the break points that are told side by side" $
      property $ \(AnyScene s) ->
        forAll (choose (1, 12) `suchThatMap` elementCount) $ \parts ->
          uniformSides parts (sampleScene s) === meshSides (uniformMesh parts (sampleScene s))
    it "has every k/N that is not covered" $
      property $ \(AnyScene s) ->
        forAll (choose (1, 12) `suchThatMap` elementCount) $ \parts ->
          let scene = sampleScene s
              n = countedElements parts
              ends piece = sort (map (positionOn scene (sideName scene piece)) (endPoints scene piece))
              isFree side t = or [a < t && t < b | piece <- concat (piecesOf scene side), [a, b] <- [ends piece]]
              wanted side = [t | k <- [1 .. n - 1], let t = toInteger k % toInteger n, isFree side t]
              mesh = uniformMesh parts scene
           in [(side, map breakParameter points) | (side, points) <- meshSides mesh]
                === [(side, wanted side) | side <- statedSides scene]

  describe "the union of two meshes" $ do
    it "cuts where either does, with the casters that there are, whichever comes first" $
      property $ \(AnyScene s) ->
        forAllBlind (vectorOf 2 (someMesh (sampleScene s))) $ \meshes ->
          let causes points = Map.fromListWith casting [(breakParameter p, breakCause p) | p <- points]
              casting new old = if new == EqualParts then old else new
           in conjoin
                [ conjoin
                    [ map breakParameter points === Map.keys wanted
                    , map breakCause points === Map.elems wanted
                    ]
                | union <- [foldr1 meshUnion meshes, foldr1 meshUnion (reverse meshes)]
                , (side, points) <- meshSides union
                , let wanted = causes (concatMap (`breaksOf` side) meshes)
                ]
    it "has its points in order from the start of each piece, each where its parameter says" $
      property $ \(AnyScene s) ->
        forAllBlind (vectorOf 3 (someMesh (sampleScene s))) $ \meshes ->
          conjoin [inPlace (foldr1 meshUnion meshes) side | side <- sides (sampleScene s)]
    it "changes nothing with the mesh itself or with none, and may be grouped in any way" $
      property $ \(AnyScene s) ->
        let mesh = someMesh (sampleScene s)
         in forAllBlind ((,,) <$> mesh <*> mesh <*> mesh) $ \(a, b, c) ->
              conjoin
                [ meshSides (meshUnion a a) === meshSides a
                , meshSides (meshUnion a (emptyMesh (sampleScene s))) === meshSides a
                , meshSides (meshUnion (emptyMesh (sampleScene s)) a) === meshSides a
                , meshSides (meshUnion a (meshUnion b c)) === meshSides (meshUnion (meshUnion a b) c)
                ]

-- | A mesh of any kind.
someMesh :: Scene -> Gen Mesh
someMesh scene =
  oneof
    [ pure (meshOf scene)
    , pure (shadowLimits (meshOf scene))
    , (`uniformMesh` scene) <$> counts
    , (\n -> fst (bounded n (meshOf scene))) <$> counts
    ]
  where
    counts = choose (1, 8) `suchThatMap` elementCount

-- | What is cut, in text: parameters with the kinds and corners of all casters.
cut :: Scene -> [(String, [(Rational, [(Kind, String)])])]
cut scene =
  [ (sideText side, [(t, map inText casts) | Landed t _ casts <- found])
  | (side, found) <- Map.toList (landedIn (meshOf scene))
  , not (null found)
  ]
  where
    inText (kind, (p, q)) = (kind, cornerText p <> " " <> cornerText q)

floor' :: [(Integer, Integer)]
floor' = [(-10, -2), (10, -2), (10, -1), (-10, -1)]

roomWithWall :: RawScene
roomWithWall = RawScene Nothing (Just (rawPolygon (points [(0, 0), (4, 0), (4, 4), (0, 4)]))) [wall']
  where
    wall' = rawPolygon (points [(1, 2), (3, 2)])
    points = map (uncurry Point)

-- | Two break points, or ends of a side, that follow each other, and the next one if there is one; on all sides of
-- rings. A wall has free space on both sides, so what is seen from a point of it says less.
data Window = Window SideName Point Point (Maybe Point)
  deriving (Show)

windows :: Mesh -> [Window]
windows mesh =
  [ Window name a b c
  | side <- sides scene
  , let name@(SideName owner _) = sideName scene side
  , Ring <- [polygonForm polygon | polygon <- scenePolygons scene, polygonId polygon == owner]
  , [from, to] <- [endPoints scene side]
  , let stops = from : map breakAt (breaksOn mesh side) <> [to]
  , (a, b, c) <- zip3 stops (drop 1 stops) (map Just (drop 2 stops) <> [Nothing])
  ]
  where
    scene = meshScene mesh

-- | Between two break points all points see the same objects in the same order, and beyond the second one they see
-- others.
changing :: Scene -> Window -> Property
changing scene window@(Window _ a b c) =
  counterexample (show window) $
    conjoin [early === late, counterexample "beyond" (maybe True ((/= early) . seenAt . between (1 / 5) b) c)]
  where
    (early, late) = (seenAt (between (1 / 7) a b), seenAt (between (9 / 10) a b))
    between t (Point ax ay) (Point bx by) = Point (ax + t * (bx - ax)) (ay + t * (by - ay))
    seenAt = fmap (map sightObject) . scan scene

changesNothing :: Sample -> Gen Change -> Property
changesNothing s changes =
  forAll changes $ \change -> case sample (changedScene change) of
    Nothing -> counterexample "not valid" False
    Just t -> told id id (sampleScene t) === told (newCorner change) (newSide change) (sampleScene s)

-- | A mesh in names that may be changed: a point by its distances to the two ends of its side.
told
  :: (CornerName -> CornerName)
  -> (SideName -> SideName)
  -> Scene
  -> Map.Map SideName (Set.Set (Set.Set (CornerName, Rational), Set.Set (Kind, Set.Set CornerName, Set.Set CornerName)))
told corner side scene =
  Map.fromList [(side name, Set.fromList (map (point name) found)) | (name, found) <- meshSides mesh]
  where
    mesh = meshOf scene
    point name p = (Set.fromList (zip (ends name) [t, 1 - t]), Set.fromList (map cast (breakCasters p)))
      where
        t = breakParameter p
    cast caster = (casterKind caster, here (casterNear caster), here (casterFar caster))
    here = Set.fromList . map corner . namesHere scene
    -- The corners that the side joins, in the order of the file.
    ends (SideName p k) =
      [ corner (CornerName p j)
      | polygon <- scenePolygons scene
      , polygonId polygon == p
      , let n = length (polygonPoints polygon)
      , j <- case polygonForm polygon of
          Ring -> [k, (k + 1) `mod` n]
          Polyline -> if k < n - 1 then [k, k + 1] else [2 * n - 2 - k, 2 * n - 3 - k]
      ]

-- | Each side in three parts.
uniform :: Scene -> [Mesh]
uniform scene = [uniformMesh parts scene | Just parts <- [elementCount 3]]

strictly :: [Rational] -> Bool
strictly ts = and (zipWith (<) ts (drop 1 ts))

asByRays :: Scene -> Property
asByRays scene = landedIn (meshOf scene) === landedByRays scene

endPoints :: Scene -> SideId -> [Point]
endPoints scene side = map (cornerPoint scene) [sideStart side, sideEnd scene side]

inPlace :: Mesh -> SideId -> Property
inPlace mesh side =
  counterexample (show side) $
    conjoin
      [ map (positionOn scene name . breakAt) points === map breakParameter points
      , property (strictly along .||. strictly (reverse along))
      , conjoin [property (cross (breakAt p) == 0) | p <- points]
      ]
  where
    scene = meshScene mesh
    name = sideName scene side
    points = breaksOn mesh side
    along = case map (positionOn scene name) (endPoints scene side) of
      [a, b] -> [a] <> map breakParameter points <> [b]
      _ -> []
    -- On the line of the side.
    cross (Point x y) = case endPoints scene side of
      [Point ax ay, Point bx by] -> (bx - ax) * (y - ay) - (by - ay) * (x - ax)
      _ -> 1
