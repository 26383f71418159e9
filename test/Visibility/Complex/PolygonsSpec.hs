module Visibility.Complex.PolygonsSpec (spec) where

import Control.Monad (forM_)
import Data.List (nub, sort, sortBy)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust)
import qualified Data.Set as Set
import Data.Tuple (swap)
import qualified Data.Vector as V
import System.FilePath ((</>))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Complex.Build
import Visibility.Complex.Canonical
import Visibility.Complex.Law
import Visibility.Complex.Law.Polygons
import Visibility.Complex.Polygons
import Visibility.Complex.Type
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.Predicate
import Visibility.Format.File (readSceneFile)
import Visibility.Law
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Sweep
import Visibility.Test.Generator
import Visibility.Test.Metamorphic
import Visibility.View (Flank (..), Incidence (..), incidences)

spec :: Spec
spec = do
  describe "the laws of the complex of polygons" $ do
    it "have names of their own" $
      length (nub (map lawName polygonLaws)) `shouldBe` length polygonLaws
    modifyMaxSuccess (* 20) $
      it "hold in convex scenes" $
        property $ \(ConvexScene s) -> broken' (polygonsOf s) === []
    modifyMaxSuccess (* 5) $
      it "hold in scenes of any kind" $
        property $ \(AnyScene s) -> broken' (polygonsOf s) === []
    it "hold where vertices come by direction" $
      property $ \(ConvexScene s) ->
        let scene = sampleScene s
            byDirection v w = compareDirections (vertexDirection scene v) (vertexDirection scene w)
         in broken' (polygonComplex (build scene (sortBy byDirection (vertices scene)))) === []
    forM_ mutations $ \(name, noticed, mutate) ->
      it ("notice " <> name) $
        property $ \(ConvexScene s) ->
          let made = polygonsOf s
              found = map violatedLaw (broken' (mutate made))
           in maybe 0 (V.length . arcs) (outlines made) >= 8 ==>
                counterexample (show (nub found)) (noticed `elem` found)
    it "notice the regions of another complex" $
      property $ \(ConvexScene s) -> case polygonsOf <$> sampleOf [[(0, 0), (4, 0), (4, 3)]] of
        Just other ->
          let made = polygonsOf s
           in length (faceIds (sideComplex made)) > 5 ==>
                not (null (concatMap (`lawViolations` made {regions = regions other}) (take 1 polygonLaws)))
        Nothing -> property Discard
  it "every law but the first, of the partition, has a mutation that it must notice" $
    Set.fromList [noticed | (_, noticed, _) <- mutations]
      `shouldBe` Set.fromList (map lawName (drop 1 polygonLaws))
  describe "the complex of polygons" $ do
    it "has vertices and edges where all polygons are convex and none touches another, under the sky" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
         in isJust (outlines (polygonsOf s))
              === and
                [ surroundings scene == OpenSky
                , all isConvexPolygon (scenePolygons scene)
                , sceneContacts scene == 0
                ]
    modifyMaxSuccess (* 5) $
      it "does not change where a flat corner splits a side" $
        property $ \(ConvexScene s) -> forAll (splitSide (sampleRaw s)) $ \split ->
          case split >>= \found -> (,) found <$> sample (splitScene found) of
            Just (found, s') -> named (splitNames found) (polygonsOf s) === named id (polygonsOf s')
            Nothing -> property True
    it "has the regions that the chains tell, where there are no thin walls" $
      property $ \(AnyScene s) -> hasNoWalls s ==> regionSets s === Set.fromList (componentsByChains (complexOf s))
    it "has the regions that the views tell, where there are no thin walls" $
      property $ \(AnyScene s) -> hasNoWalls s ==> regionSets s === Set.fromList (componentsByViews (complexOf s))
    modifyMaxSuccess (* 3) $
      it "has as many regions in a convex room as under the sky" $
        property $ \(ConvexScene s) ->
          fmap (length . regions . polygonsOf) (sample (inRoom (sampleRaw s)))
            === Just (length (regions (polygonsOf s)))
    modifyMaxSuccess (* 3) $
      it "takes thin walls as infinitesimally slim polygons" $
        property $ \(ConvexScene s) ->
          let sizesOf = traverse (\made -> (,) (sizes made) . isGeneral <$> outlines made)
           in case (sizesOf (Just (polygonsOf s)), sizesOf (polygonsOf <$> sample (thickened (sampleRaw s)))) of
                (Just (Just (size, True)), Just (Just found)) -> found === (size, True)
                _ -> property Discard
    it "begins each region with the first of its faces, and lists the regions by these" $
      property $ \(AnyScene s) ->
        let made = polygonsOf s
            owner = polygonLabel (sampleScene s)
            number = faceNumber (canonicalNumbering (sideComplex made))
            firsts = [f | region <- V.toList (regions made), f <- take 1 (regionFaces region)]
         in conjoin
              [ map number firsts === sort (map number firsts)
              , [(owner (faceBack (sideComplex made) f), owner (faceFront (sideComplex made) f)) | f <- firsts]
                  === [(regionBack region, regionFront region) | region <- V.toList (regions made)]
              ]
    it "begins each face at the first vertex of its first face of sides" $
      property $ \(ConvexScene s) ->
        let made = polygonsOf s
            vertexOf found (LineId i) = lineVertex (tangentLines found V.! i)
         in conjoin
              [ fmap (vertexOf found) (firstLine boundary) === (listed >>= faceFirst (sideComplex made))
              | Just found <- [outlines made]
              , V.length (tangentLines found) > 0
              , (region, boundary) <- zip (V.toList (regions made)) (V.toList (boundaries found))
              , let listed = foldr (const . Just) Nothing (regionFaces region)
              ]
    forM_ ["city", "skewer", "pillars", "thin-walls", "spiral-room", "hooks"] $ \name ->
      it ("obeys its laws in scenes/" <> name <> ".json") $ do
        result <- readSceneFile ("scenes" </> (name <> ".json"))
        case result of
          Left problems -> expectationFailure (show problems)
          Right scene -> broken' (polygonComplex (build scene (vertices scene))) `shouldBe` []
    forM_ expected $ \(file, size) ->
      it ("has the numbers that the flips of free bitangents give: " <> file) $ do
        result <- readSceneFile file
        case result of
          Left problems -> expectationFailure (show problems)
          Right scene -> length (regions (polygonComplex (build scene (vertices scene)))) `shouldBe` size
    it "has a closed curve for a polygon that is alone" $
      outlined [[(0, 0), (4, 0), (4, 3)]] $ \made found -> do
        sizes made `shouldBe` (0, 1, 2)
        [(arcPolygon a, arcFirst a, arcLast a, length (arcStretches a)) | a <- V.toList (arcs found)]
          `shouldBe` [(Obstacle 0, Nothing, Nothing, 3)]
    it "has one vertex for two thin walls in a line" $
      outlined [[(0, 0), (4, 0)], [(5, 0), (7, 0)]] $ \made found -> do
        sizes made `shouldBe` (1, 4, 4)
        V.toList (V.map (map tangencyFlanks . lineTangencies) (tangentLines found))
          `shouldBe` [[[Above, Below], [Above, Below]]]
    it "has faces that turn by more than a full turn" $
      outlined [[(12, 1), (9, 4)], [(0, 9), (4, 9)]] $ \made found ->
        let complex = sideComplex made
            turned boundary = sum [arcTurns complex (arcs found V.! a) | (ArcId a, _) <- upperArcs boundary]
            directionAt (LineId i) =
              vertexDirection (complexScene complex) (vertexAt complex (lineVertex (tangentLines found V.! i)))
         in [ (turned boundary, regionBack region, regionFront region)
            | (region, boundary) <- zip (V.toList (regions made)) (V.toList (boundaries found))
            , turned boundary >= 2
            , Just from <- [directionAt <$> firstLine boundary]
            , Just to <- [directionAt <$> lastLine boundary]
            , compareDirections from to == LT
            ]
              `shouldBe` [(2, OfPolygon (Obstacle 1), OfSky)]

complexOf :: Sample -> Complex
complexOf s = build (sampleScene s) (vertices (sampleScene s))

polygonsOf :: Sample -> PolygonComplex
polygonsOf = polygonComplex . complexOf

broken' :: PolygonComplex -> [Violation]
broken' made = [v | law <- polygonLaws, v <- lawViolations law made]

-- | Of a scene that has outlines.
outlined :: [[(Integer, Integer)]] -> (PolygonComplex -> Outlines -> Expectation) -> Expectation
outlined polygons check = case polygonsOf <$> sampleOf polygons of
  Just made | Just found <- outlines made -> check made found
  _ -> expectationFailure "valid and convex"

hasNoWalls :: Sample -> Bool
hasNoWalls s = not (any (isWallEnd (sampleScene s)) (corners (sampleScene s)))

regionSets :: Sample -> Set.Set (Set.Set FaceId)
regionSets s = Set.fromList (map (Set.fromList . regionFaces) (V.toList (regions (polygonsOf s))))

sizes :: PolygonComplex -> (Int, Int, Int)
sizes made = (count tangentLines, count arcs, length (regions made))
  where
    count :: (Outlines -> V.Vector a) -> Int
    count table = maybe 0 (V.length . table) (outlines made)

-- | Are all turns of a ring of one kind? A thin wall is convex where it has two corners.
isConvexPolygon :: Polygon -> Bool
isConvexPolygon polygon = case polygonForm polygon of
  Polyline -> length points == 2
  Ring -> not (any (> 0) turns && any (< 0) turns)
  where
    points = polygonPoints polygon
    turns =
      [ (bx - ax) * (cy - by) - (by - ay) * (cx - bx)
      | (Point ax ay, Point bx by, Point cx cy) <- zip3 points (drop 1 (cycle points)) (drop 2 (cycle points))
      ]

-- | The number of faces by the rules for flips of free bitangents, from a program that keeps the cut of the
-- polygon-labelled complex only, less the faces without extent that it makes at degenerate vertices.
expected :: [(FilePath, Int)]
expected =
  [ ("test" </> "vectors" </> "flat-corners" </> "scene.json", 5)
  , ("test" </> "vectors" </> "grid-4x4" </> "scene.json", 21)
  , ("test" </> "vectors" </> "random-10x4" </> "scene.json", 136)
  , ("test" </> "vectors" </> "random-3x4" </> "scene.json", 13)
  , ("test" </> "vectors" </> "thin-walls" </> "scene.json", 22)
  , ("test" </> "vectors" </> "grid-9x4" </> "scene.json", 73)
  , ("scenes" </> "forty-digits.json", 55)
  , ("scenes" </> "grid.json", 321)
  , ("scenes" </> "needles.json", 397)
  , ("scenes" </> "ordp-2.json", 12)
  , ("scenes" </> "ordp-4.json", 20)
  , ("scenes" </> "ordp-6.json", 35)
  , ("scenes" </> "ordp-7.json", 23)
  , ("scenes" </> "two-squares.json", 5)
  ]

-- | Changes of tables, with the law that must notice each.
mutations :: [(String, String, PolygonComplex -> PolygonComplex)]
mutations =
  [ ( "a region with another label"
    , "quotient: labels of a region"
    , \made ->
        made {regions = atFirst (const True) (\region -> region {regionBack = OfPolygon Enclosure}) (regions made)}
    )
  , ( "a missing tangency"
    , "quotient: tangencies of a vertex"
    , onLine (\line -> line {lineTangencies = drop 1 (lineTangencies line)})
    )
  , ( "tangencies out of order"
    , "quotient: tangencies of a vertex"
    , onLine (\line -> line {lineTangencies = reverse (lineTangencies line)})
    )
  , ("an edge with another flank", "quotient: curves", onArc (\arc -> arc {arcFlank = flankAfter 1 (arcFlank arc)}))
  , ("two faces of an edge exchanged", "quotient: faces of an edge", onArc exchanged)
  , ("an edge without stretches", "quotient: faces of an edge", onArc (\arc -> arc {arcStretches = []}))
  , ( "an edge missing in a chain"
    , "quotient: chains"
    , onBounded (\boundary -> boundary {upperArcs = drop 1 (upperArcs boundary)})
    )
  , ( "chains exchanged"
    , "quotient: chains"
    , onBounded (\boundary -> boundary {upperArcs = lowerArcs boundary, lowerArcs = upperArcs boundary})
    )
  , ("a face without a first vertex", "quotient: chains", onBounded (\boundary -> boundary {firstLine = Nothing}))
  , ( "a face without a first and a last vertex"
    , "quotient: chains"
    , onBounded (\boundary -> boundary {firstLine = Nothing, lastLine = Nothing})
    )
  , ("a face too many", "quotient: numbers", \made -> made {regions = regions made <> V.take 1 (regions made)})
  , ( "a face that opens and closes at one vertex"
    , "quotient: numbers"
    , -- Some faces end where they begin, half a turn later; this one does not.
      inOutlines $ \found ->
        found
          { boundaries =
              atFirst
                (\boundary -> firstLine boundary /= lastLine boundary)
                (\boundary -> boundary {firstLine = lastLine boundary})
                (boundaries found)
          }
    )
  , ( "far too many faces, where all vertices are general"
    , "quotient: numbers in general position"
    , \made ->
        inOutlines
          (\found -> found {tangentLines = V.map asGeneral (tangentLines found)})
          made {regions = V.concat (replicate 1000 (regions made))}
    )
  , ( "an edge that bounds one face on three sides"
    , "quotient: general vertex"
    , inOutlines $ \found ->
        found
          { arcs = V.map (\arc -> arc {arcBack = arcAcross arc, arcFront = arcAcross arc}) (arcs found)
          , tangentLines = V.map asGeneral (tangentLines found)
          }
    )
  , ( "faces that end before the end of the half turn"
    , "quotient: cuts"
    , inOutlines $ \found -> found {boundaries = V.map (\boundary -> boundary {upperArcs = []}) (boundaries found)}
    )
  ]
  where
    inOutlines change made = made {outlines = change <$> outlines made}
    onLine f = inOutlines (\found -> found {tangentLines = atFirst (const True) f (tangentLines found)})
    onArc f = inOutlines (\found -> found {arcs = atFirst (const True) f (arcs found)})
    onBounded f = inOutlines (\found -> found {boundaries = atFirst (isJust . firstLine) f (boundaries found)})
    atFirst wanted f table = case V.findIndex wanted table of
      Just i -> V.imap (\j x -> if i == j then f x else x) table
      Nothing -> table
    exchanged arc = arc {arcBack = arcFront arc, arcFront = arcBack arc}
    asGeneral line =
      line {lineTangencies = [t {tangencyFlanks = take 1 (tangencyFlanks t)} | t <- take 2 (lineTangencies line)]}

-- | The complex of polygons by names: vertices, edges and faces.
data Named = Named
  { namedLines :: [[(PolygonId, CornerName, [Flank])]]
  , namedArcs :: [(ArcName, Maybe [CornerName], [(PolygonLabel, PolygonLabel)])]
  , namedRegions :: [((PolygonLabel, PolygonLabel), Maybe [CornerName], Maybe [CornerName], [[(ArcName, Int)]])]
  }
  deriving (Eq, Show)

type ArcName = (PolygonId, Flank, Maybe [CornerName])

named :: (CornerName -> CornerName) -> PolygonComplex -> Maybe Named
named rename made = byNames <$> outlines made
  where
    nameOf = rename . cornerName (complexScene (sideComplex made))
    byNames found =
      Named
        { namedLines = sort [map tangency (lineTangencies line) | line <- V.toList (tangentLines found)]
        , namedArcs =
            sort [(arcName arc, lineName (arcLast arc), map ends (arcFaces arc)) | arc <- V.toList (arcs found)]
        , namedRegions =
            sort
              [ ( (regionBack region, regionFront region)
                , lineName (firstLine boundary)
                , lineName (lastLine boundary)
                , map (chainName boundary) [upperArcs boundary, lowerArcs boundary]
                )
              | (region, boundary) <- zip (V.toList (regions made)) (V.toList (boundaries found))
              ]
        }
      where
        tangency t = (tangencyPolygon t, nameOf (tangencyCorner t), tangencyFlanks t)
        lineName = fmap (\(LineId i) -> map (nameOf . tangencyCorner) (lineTangencies (tangentLines found V.! i)))
        arcName arc = (arcPolygon arc, arcFlank arc, lineName (arcFirst arc))
        ends (Aspect (RegionId r) turns) =
          (if odd turns then swap else id) (regionBack region, regionFront region)
          where
            region = regions made V.! r
        -- A closed chain may begin anywhere.
        chainName boundary chain = case firstLine boundary of
          Nothing -> sort [(arcName (arcs found V.! a), turns `mod` 2) | (ArcId a, turns) <- chain]
          Just _ -> [(arcName (arcs found V.! a), turns) | (ArcId a, turns) <- chain]

-- | Components of the faces, where those of each pair are one.
components :: Complex -> [(FaceId, FaceId)] -> [Set.Set FaceId]
components complex pairs = go (Set.fromList (faceIds complex))
  where
    go left = case Set.minView left of
      Nothing -> []
      Just (f, _) -> let found = reach Set.empty [f] in found : go (left `Set.difference` found)
    reach seen [] = seen
    reach seen (f : rest)
      | f `Set.member` seen = reach seen rest
      | otherwise = reach (Set.insert f seen) (Map.findWithDefault [] f beside <> rest)
    beside = Map.fromListWith (<>) (concat [[(f, [g]), (g, [f])] | (f, g) <- pairs])

-- | Two faces are one if a stretch is in the upper chain of one and in the lower chain of the other, and they end at
-- the same polygons as they are met there.
componentsByChains :: Complex -> [Set.Set FaceId]
componentsByChains complex =
  components complex [(f, g) | (key, fs) <- Map.toList below, f <- fs, g <- Map.findWithDefault [] key above]
  where
    scene = complexScene complex
    -- By stretch and label as it is where the stretch begins.
    below = Map.fromListWith (<>) [entry | (True, entry) <- met]
    above = Map.fromListWith (<>) [entry | (False, entry) <- met]
    met =
      [ (isBelow, ((e, if isCut then swapped else ends), [f]))
      | f <- faceIds complex
      , let Chain upper upperAfter = upperChain complex f
      , let Chain lower lowerAfter = lowerChain complex f
      , let ends@(back, front) = (owner (faceBack complex f), owner (faceFront complex f))
      , let swapped = (front, back)
      , (isBelow, isCut, es) <-
          [(True, False, upper), (False, True, upperAfter), (False, False, lower), (True, True, lowerAfter)]
      , e <- es
      ]
    owner = polygonLabel scene

-- | Two faces are one if they lie on opposite flanks of a stretch, and end at the same polygons by what the corner
-- sees.
componentsByViews :: Complex -> [Set.Set FaceId]
componentsByViews complex =
  components complex [(f, g) | e <- stretchIds complex, (f, a) <- seen e Above, (g, b) <- seen e Below, a == b]
  where
    scene = complexScene complex
    seen e flank =
      zip
        (edgeFacesOn complex e flank)
        [ (polygonLabel scene back, polygonLabel scene front)
        | Incidence flank' back front <- incidences scene (edgeCorner complex e) (edgeView complex e)
        , flank' == flank
        ]

-- | The scene in a large square.
inRoom :: RawScene -> RawScene
inRoom raw = raw {rawEnclosure = Just (rawPolygon room)}
  where
    room = [Point (-far) (-far), Point far (-far), Point (far + 1) (far + 2), Point (-far) far]
    far = 10 ^ (6 :: Int)

-- | The scene with thin walls replaced by slim triangles.
thickened :: RawScene -> RawScene
thickened raw = raw {rawPolygons = map thick (rawPolygons raw)}
  where
    thick polygon = case rawCorners polygon of
      [a@(Point ax ay), b@(Point bx by)] ->
        polygon {rawCorners = [a, b, Point ((ax + bx) / 2 - tiny * (by - ay)) ((ay + by) / 2 + tiny * (bx - ax))]}
      _ -> polygon
    tiny = 1 / 10 ^ (12 :: Int)
