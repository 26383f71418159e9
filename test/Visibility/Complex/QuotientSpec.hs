module Visibility.Complex.QuotientSpec (spec) where

import Control.Monad (forM_)
import Data.List (nub, sort, sortBy)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import qualified Data.Vector as V
import System.FilePath ((</>))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Complex.Build
import Visibility.Complex.Quotient
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
import Visibility.View (Flank (..))

spec :: Spec
spec = do
  describe "the laws of the quotient" $ do
    it "have names of their own" $
      length (nub (map quotientLawName quotientLaws)) `shouldBe` length quotientLaws
    modifyMaxSuccess (* 20) $
      it "hold in convex scenes" $
        property $ \(ConvexScene s) -> broken' (quotientOf s) === []
    modifyMaxSuccess (* 5) $
      it "hold in scenes of any kind" $
        property $ \(AnyScene s) -> broken' (quotientOf s) === []
    it "hold where vertices come by direction" $
      property $ \(ConvexScene s) ->
        let scene = sampleScene s
            byDirection v w = compareDirections (vertexDirection scene v) (vertexDirection scene w)
         in broken' (quotient (build scene (sortBy byDirection (vertices scene)))) === []
    forM_ mutations $ \(name, noticed, mutate) ->
      it ("notice " <> name) $
        property $ \(ConvexScene s) -> case quotientOf s of
          ConvexQuotient complex union convex
            | V.length (arcs convex) >= 8 ->
                let found = map violatedLaw (broken' (ConvexQuotient complex union (mutate convex)))
                 in counterexample (show (nub found)) (noticed `elem` found)
          _ -> property Discard
    it "notice the union of another complex" $
      property $ \(ConvexScene s) -> case (quotientOf s, quotientOf <$> sampleOf [[(0, 0), (4, 0), (4, 3)]]) of
        (ConvexQuotient complex _ convex, Just other)
          | length (faceIds complex) > 5 ->
              let mixed = ConvexQuotient complex (quotientUnion other) convex
               in property (not (null (concatMap (`quotientLawViolations` mixed) (take 1 quotientLaws))))
        _ -> property Discard
  it "every law but the first, of the union, has a mutation that it must notice" $
    Set.fromList [noticed | (_, noticed, _) <- mutations]
      `shouldBe` Set.fromList (map quotientLawName (drop 1 quotientLaws))
  describe "the quotient" $ do
    it "has vertices and edges where all polygons are convex and none touches another, under the sky" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
         in isConvex (quotientOf s)
              === and
                [ surroundings scene == OpenSky
                , all isConvexPolygon (scenePolygons scene)
                , sceneContacts scene == 0
                ]
    modifyMaxSuccess (* 5) $
      it "does not change where a flat corner splits a side" $
        property $ \(ConvexScene s) -> forAll (splitSide (sampleRaw s)) $ \split ->
          case split >>= \found -> (,) found <$> sample (splitScene found) of
            Just (found, s') -> namedQuotient (splitNames found) (quotientOf s) === namedQuotient id (quotientOf s')
            Nothing -> property True
    it "has the regions that the chains tell, where there are no thin walls" $
      property $ \(AnyScene s) ->
        not (any (isWallEnd (sampleScene s)) (corners (sampleScene s))) ==>
          let c = complexOf s
              union = quotientUnion (quotient c)
           in Set.fromList (map (Set.fromList . regionMembers union) (regionIds (quotient c)))
                === Set.fromList (componentsByChains c)
    modifyMaxSuccess (* 3) $
      it "has as many regions in a convex room as under the sky" $
        property $ \(ConvexScene s) ->
          fmap (length . regionIds . quotientOf) (sample (inRoom (sampleRaw s)))
            === Just (length (regionIds (quotientOf s)))
    modifyMaxSuccess (* 3) $
      it "takes thin walls as infinitesimally slim polygons" $
        property $ \(ConvexScene s) -> case (quotientOf s, quotientOf <$> sample (thickened (sampleRaw s))) of
          (ConvexQuotient _ _ convex, Just (ConvexQuotient _ _ convex'))
            | isGeneral convex -> property (isGeneral convex') .&&. sizes convex === sizes convex'
          _ -> property Discard
    forM_ ["city", "skewer", "pillars", "thin-walls", "spiral-room", "hooks"] $ \name ->
      it ("obeys its laws in scenes/" <> name <> ".json") $ do
        result <- readSceneFile ("scenes" </> (name <> ".json"))
        case result of
          Left problems -> expectationFailure (show problems)
          Right scene -> broken' (quotient (build scene (vertices scene))) `shouldBe` []
    forM_ expected $ \(file, size) ->
      it ("has the numbers that the flips of free bitangents give: " <> file) $ do
        result <- readSceneFile file
        case result of
          Left problems -> expectationFailure (show problems)
          Right scene -> length (regionIds (quotient (build scene (vertices scene)))) `shouldBe` size
    it "has a closed curve for a polygon that is alone" $
      case sampleOf [[(0, 0), (4, 0), (4, 3)]] of
        Just s -> case quotientOf s of
          ConvexQuotient _ _ convex -> do
            sizes convex `shouldBe` (0, 0, 2)
            map curvePolygon (closedCurves convex) `shouldBe` [Obstacle 0]
            map (length . curveStretches) (closedCurves convex) `shouldBe` [3]
          UnionQuotient _ _ -> expectationFailure "convex"
        Nothing -> expectationFailure "valid"
    it "has one vertex for two thin walls in a line" $
      case sampleOf [[(0, 0), (4, 0)], [(5, 0), (7, 0)]] of
        Just s -> case quotientOf s of
          ConvexQuotient _ _ convex -> do
            sizes convex `shouldBe` (1, 4, 4)
            V.toList (V.map (map tangencyTouch . lineTangencies) (tangentLines convex))
              `shouldBe` [[BothFlanks, BothFlanks]]
          UnionQuotient _ _ -> expectationFailure "convex"
        Nothing -> expectationFailure "valid"

    it "has faces that turn by more than a full turn" $
      case sampleOf [[(12, 1), (9, 4)], [(0, 9), (4, 9)]] of
        Just s -> case quotientOf s of
          ConvexQuotient complex _ convex ->
            let turned region = sum (map (arcTurns complex . arcOf convex) (arcsOfChain (regionUpper region)))
                directionAt = fmap (vertexDirection (sampleScene s) . vertexAt complex . lineVertex . lineOf convex)
             in [ (turned region, regionBack region, regionFront region)
                | region <- V.toList (regions convex)
                , turned region >= 2
                , Just from <- [directionAt (regionFirst region)]
                , Just to <- [directionAt (regionLast region)]
                , compareDirections from to == LT
                ]
                  `shouldBe` [(2, OfPolygon (Obstacle 1), OfSky)]
          UnionQuotient _ _ -> expectationFailure "convex"
        Nothing -> expectationFailure "valid"

complexOf :: Sample -> Complex
complexOf s = build (sampleScene s) (vertices (sampleScene s))

quotientOf :: Sample -> Quotient
quotientOf = quotient . complexOf

broken' :: Quotient -> [Violation]
broken' found = [v | law <- quotientLaws, v <- quotientLawViolations law found]

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

isConvex :: Quotient -> Bool
isConvex ConvexQuotient {} = True
isConvex UnionQuotient {} = False

sizes :: Convex -> (Int, Int, Int)
sizes convex = (V.length (tangentLines convex), V.length (arcs convex), V.length (regions convex))

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
mutations :: [(String, String, Convex -> Convex)]
mutations =
  [ ( "a region with another label"
    , "quotient: labels of a region"
    , onRegion (\region -> region {regionBack = OfPolygon Enclosure})
    )
  , ( "a missing tangency"
    , "quotient: tangencies of a vertex"
    , onLine (\line -> line {lineTangencies = drop 1 (lineTangencies line)})
    )
  , ( "tangencies out of order"
    , "quotient: tangencies of a vertex"
    , onLine (\line -> line {lineTangencies = reverse (lineTangencies line)})
    )
  , ("an edge with another flank", "quotient: curves", onArc (\arc -> arc {arcFlank = other (arcFlank arc)}))
  , ("two faces of an edge exchanged", "quotient: faces of an edge", onArc exchanged)
  , ("an edge without stretches", "quotient: faces of an edge", onArc (\arc -> arc {arcStretches = []}))
  , ( "an edge missing in a chain"
    , "quotient: chains"
    , onBounded (\region -> region {regionUpper = shorter (regionUpper region)})
    )
  , ( "chains exchanged"
    , "quotient: chains"
    , onBounded (\region -> region {regionUpper = regionLower region, regionLower = regionUpper region})
    )
  , ("a face without a first vertex", "quotient: chains", onBounded (\region -> region {regionFirst = Nothing}))
  , ("a face too many", "quotient: numbers", \convex -> convex {regions = regions convex <> V.take 1 (regions convex)})
  , ( "a face that opens and closes at one vertex"
    , "quotient: numbers"
    , -- Some faces end where they begin, half a turn later; this one does not.
      \convex ->
        convex
          { regions =
              atFirst
                (\region -> regionFirst region /= regionLast region)
                (\region -> region {regionFirst = regionLast region})
                (regions convex)
          }
    )
  , ( "far too many faces, where all vertices are general"
    , "quotient: numbers in general position"
    , \convex ->
        convex
          { regions = regions convex <> V.concatMap (const (regions convex)) (arcs convex)
          , tangentLines = V.map (\line -> line {lineArcs = take 2 (lineArcs line)}) (tangentLines convex)
          }
    )
  , ( "an edge that bounds one face on three sides"
    , "quotient: general vertex"
    , \convex ->
        convex
          { arcs = V.map (\arc -> arc {arcBack = arcAcross arc, arcFront = arcAcross arc}) (arcs convex)
          , tangentLines = V.map (\line -> line {lineArcs = take 2 (lineArcs line)}) (tangentLines convex)
          }
    )
  , ( "faces that end before the end of the half turn"
    , "quotient: cuts"
    , \convex -> convex {regions = V.map (\region -> region {regionUpper = ArcChain []}) (regions convex)}
    )
  ]
  where
    onLine f convex = convex {tangentLines = atFirst (const True) f (tangentLines convex)}
    onArc f convex = convex {arcs = atFirst (const True) f (arcs convex)}
    onRegion f convex = convex {regions = atFirst (const True) f (regions convex)}
    onBounded f convex = convex {regions = atFirst ((/= Nothing) . regionFirst) f (regions convex)}
    atFirst wanted f table = case V.findIndex wanted table of
      Just i -> V.imap (\j x -> if i == j then f x else x) table
      Nothing -> table
    other flank = if flank == Above then Below else Above
    exchanged arc = arc {arcBack = arcFront arc, arcFront = arcBack arc}
    shorter (ArcChain found) = ArcChain (drop 1 found)

-- | The polygon-labelled complex by names: vertices, edges and faces.
data Named = Named
  { namedLines :: [[(PolygonId, CornerName, Touch)]]
  , namedArcs :: [(ArcName, [CornerName], [(PolygonLabel, PolygonLabel)])]
  , namedRegions :: [((PolygonLabel, PolygonLabel), Maybe [CornerName], Maybe [CornerName], [[(ArcName, Int)]])]
  }
  deriving (Eq, Show)

type ArcName = (PolygonId, Flank, [CornerName])

namedQuotient :: (CornerName -> CornerName) -> Quotient -> Maybe Named
namedQuotient rename (ConvexQuotient complex _ convex) =
  Just
    Named
      { namedLines = sort [map tangency (lineTangencies line) | line <- V.toList (tangentLines convex)]
      , namedArcs =
          sort
            [ (arcName a, lineName (arcLast arc), map (aspectPolygons convex) faces)
            | a <- arcIds convex
            , let arc = arcOf convex a
            , let faces = [arcAcross arc, arcBack arc, arcFront arc]
            ]
      , namedRegions =
          sort
            [ ( (regionBack r, regionFront r)
              , lineName <$> regionFirst r
              , lineName <$> regionLast r
              , map (chainName r) [regionUpper r, regionLower r]
              )
            | r <- V.toList (regions convex)
            ]
      }
  where
    tangency t = (tangencyPolygon t, nameOf (tangencyCorner t), tangencyTouch t)
    nameOf = rename . cornerName (complexScene complex)
    lineName i = map (nameOf . tangencyCorner) (lineTangencies (lineOf convex i))
    arcName a = let arc = arcOf convex a in (arcPolygon arc, arcFlank arc, lineName (arcFirst arc))
    -- A closed chain may begin anywhere.
    chainName r (ArcChain found) = case regionFirst r of
      Nothing -> sort [(arcName a, turns `mod` 2) | (a, turns) <- found]
      Just _ -> [(arcName a, turns) | (a, turns) <- found]
namedQuotient _ (UnionQuotient _ _) = Nothing

-- | Components of the faces, where two are joined if a stretch is in the upper chain of one and in the lower chain of
-- the other, and they end at the same polygons as they are met there.
componentsByChains :: Complex -> [Set.Set FaceId]
componentsByChains complex = go (Set.fromList (faceIds complex))
  where
    scene = complexScene complex
    go left = case Set.minView left of
      Nothing -> []
      Just (f, _) -> let found = reach Set.empty [f] in found : go (left `Set.difference` found)
    reach seen [] = seen
    reach seen (f : rest)
      | f `Set.member` seen = reach seen rest
      | otherwise = reach (Set.insert f seen) (Map.findWithDefault [] f beside <> rest)
    beside =
      Map.fromListWith
        (<>)
        (concat [[(f, [g]), (g, [f])] | (key, fs) <- Map.toList below, f <- fs, g <- Map.findWithDefault [] key above])
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
