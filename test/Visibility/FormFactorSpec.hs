module Visibility.FormFactorSpec (spec) where

import Control.Monad (forM_)
import Data.Bifunctor (bimap)
import qualified Data.ByteString.Char8 as Bytes
import Data.List (sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isJust, mapMaybe)
import qualified Data.Set as Set
import Numeric (readFloat)
import System.Directory (doesFileExist, listDirectory)
import System.FilePath ((</>))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (Positive, sample)
import Visibility.Exact.Point
import Visibility.Exact.RootSum
import Visibility.Exact.Rounding (Digits, decimal, defaultDigits, digits, nearestDouble)
import Visibility.Exact.SomeRoots
import Visibility.Format.File (readSceneFile)
import Visibility.FormFactor
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Sweep
import Visibility.Test.Generator
import Visibility.Test.Metamorphic

spec :: Spec
spec = do
  describe "the measures" $
    modifyMaxSuccess (* 10) $ do
      it "close: a side's measures add up to twice the length of what is not covered of it, exactly" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
           in [ (sideText side, defect)
              | (side, defect) <- closureDefect scene (measuresIn scene)
              , sign defect /= Zero
              ]
                === []
      it "are positive" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
              sums = measuresIn scene
           in ( [ (objectText scene a, objectText scene b)
                | ((a, b), area) <- measureList scene sums
                , sign area /= Positive
                ]
              , [(seenText a, seenText b) | ((a, b), area) <- statedMeasures scene sums, sign area /= Positive]
              )
                === ([], [])
      it "are the same multiples of the same roots in machine integers, to the largest, as in larger ones" $
        property $ \(LatticeScene s) -> forAll (filling (2 ^ (31 :: Int) - 1) (sampleRaw s)) $ \raw ->
          onScene raw $ \scene -> onScene (changed (times 2) raw) $ \large ->
            let sumsOf made = [(pair, terms area) | (pair, area) <- measureList made (measuresIn made)]
             in (map (areSmall . pointPlaces . scenePoints) [scene, large] === [True, False])
                  .&&. ([(pair, [(2 * c, n) | (c, n) <- sums]) | (pair, sums) <- sumsOf scene] === sumsOf large)
      it "between sides of the file are those between all their pieces, added up" $
        property $ \(TouchingScene s) ->
          let scene = sampleScene s
              sums = measuresIn scene
              byName =
                Map.fromListWith
                  (+)
                  [(inOrder (both (seenAs scene) pair), area) | (pair, area) <- measureList scene sums]
           in Map.fromList [(inOrder pair, merged area) | (pair, area) <- statedMeasures scene sums]
                === fmap merged byName
      it "join no side to itself" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
           in [seenText a | ((a@(TheSide _), b), _) <- statedMeasures scene (measuresIn scene), a == b] === []
  describe "the form factors" $ do
    it "of a side add up to the part of it that is not covered, exactly" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            rows = Map.fromListWith (+) [(a, f) | ((a, _), f) <- Map.toList (factorsOf scene)]
         in fmap asRational rows
              === Map.fromList [(a, Just part) | a <- statedSides scene, let part = uncovered scene a, part > 0]
    it "are reciprocal, exactly" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            factors = formFactors scene (measuresIn scene)
            table = Map.fromList [((TheSide (factorFrom f), factorTo f), f) | f <- factors]
         in conjoin
              [ fmap (byLength scene) (Map.lookup (factorTo f, TheSide (factorFrom f)) table)
                  === Just (byLength scene f)
              | f <- factors
              , factorTo f /= TheSky
              ]
    it "are those that rays find, to the accuracy of sampling" $
      property $ \(ConvexScene s) -> agreesWithRays s
    it "are those that rays find where polygons are not convex and in rooms" $
      property $ \(SmallScene s) -> agreesWithRays s
    it "are those that rays find where polygons touch" $
      property $ \(TouchingScene s) -> agreesWithRays s
    it "of facing sides of equal length at that distance are the root of two less one" $
      lookupFactor (squareRoom []) ("E", 0) ("E", 2) `shouldBe` fromTerms [(1, 2), (-1, 1)]
    it "of adjacent sides of a square room are one less half the root of two" $
      lookupFactor (squareRoom []) ("E", 0) ("E", 1) `shouldBe` fromTerms [(1, 1), (-1 / 2, 2)]
    it "of the two faces of a thin wall under the sky are one each" $
      fmap (factorsOf . sampleScene) (sample (RawScene Nothing Nothing [rawPolygon [Point 0 0, Point 3 1]]))
        `shouldBe` Just (Map.fromList [((SideName (Obstacle 0) k, Nothing), rational 1) | k <- [0, 1]])
    it "of a floor and a wall in front of it are by its crossed strings less the uncrossed ones" $
      lookupFactor (squareRoom [[(1 / 2, 1 / 2), (3 / 4, 1 / 2)]]) ("E", 0) ("0", 0)
        `shouldBe` fromTerms [(1 / 8, 13), (-1 / 8, 5)]
  describe "exact measures with decimals" $ do
    it "are those of the exact form factors, a row for each side" $
      property $ \(AnyScene s) -> forAll someDigits $ \n -> areExact n (sampleScene s)
    it "are so where polygons touch" $
      property $ \(TouchingScene s) -> forAll someDigits $ \n -> areExact n (sampleScene s)
    it "are so on large lattices" $
      property $ \(LatticeScene s) -> forAll (elements [1 / 3 ^ (25 :: Int), 3 ^ (25 :: Int), 2 ^ (31 :: Int) / 7]) $ \k ->
        onScene (changed (times k) (sampleRaw s)) (areExact defaultDigits)
  describe "the nearest Doubles" $ do
    it "are those of the exact form factors, the same ones in the same order" $
      property $ \(AnyScene s) -> areNearest (sampleScene s)
    it "are so where polygons touch" $
      property $ \(TouchingScene s) -> areNearest (sampleScene s)
    it "are so on the lattice of large numbers" $
      property $ \(LatticeScene s) -> forAll (elements [3 ^ (25 :: Int), 3 ^ (80 :: Int), 7 ^ (400 :: Int)]) $ \k ->
        onScene (changed (times k) (sampleRaw s)) areNearest
    it "need roots for few of them, and so do decimals of 17 digits" $
      property $ \(ConvexScene s) ->
        let scene = sampleScene s
            few rows = sum (map rowByRoots rows) * 4 <= sum (map (length . rowFactors) rows) + 8
         in few (nearestFactors scene (measuresIn scene)) && few (decimalFactors defaultDigits scene (measuresIn scene))
    it "go to the even one exactly between two" $ do
      -- In a triangle with sides a = 2mn, b = m² − n² and a hypotenuse, (a + b − c) / (2a) is 1/2 − n/(2m).
      let m = 2 ^ (54 :: Int)
          between n = do
            scene <- sampleScene <$> sample (RawScene Nothing (Just (rawPolygon (triangle m n))) [])
            pure
              [ x
              | FactorRow (SideName Enclosure 0) found _ <- nearestFactors scene (measuresIn scene)
              , (TheSide (SideName Enclosure 2), x) <- found
              ]
          exactly n = fromRational (1 / 2 - n / (2 * m)) :: Double
      between 1 `shouldBe` Just [exactly 1]
      between 3 `shouldBe` Just [exactly 3]
      map exactly [1, 3] `shouldBe` [0.5, 0.5 - 2 / 2 ^ (54 :: Int)]
  describe "decimals" $ do
    it "are those of the exact form factors, the same ones in the same order" $
      property $ \(AnyScene s) -> forAll someDigits $ \n -> areDecimals n (sampleScene s)
    it "are so where polygons touch" $
      property $ \(TouchingScene s) -> forAll someDigits $ \n -> areDecimals n (sampleScene s)
    it "are so on the lattice of large numbers" $
      property $ \(LatticeScene s) -> forAll someDigits $ \n ->
        let k = 3 ^ (90 :: Int)
         in onScene (changed (\(Point x y) -> Point (k * x) (y / k)) (sampleRaw s)) (areDecimals n)
  describe "nothing but names" $
    modifyMaxSuccess (* 2) $ do
      it "changes when the scene is moved, scaled, turned or mirrored" $
        property $ \(AnyScene s) -> changesNothing s (similarity (sampleRaw s))
      it "changes when polygons and corners are counted otherwise" $
        property $ \(AnyScene s) -> changesNothing s (relabelling (sampleRaw s))
      it "changes when a side is cut by a flat corner: its parts add up to it" $
        property $ \(AnyScene s) ->
          forAll (splitSide (sampleRaw s)) $ maybe (property True) $ \split ->
            onScene (splitScene split) $ \scene ->
              let old = renamedFactors (splitSides split) (measuresOf (sampleScene s))
                  (first, second) = splitParts split
                  whole name = if name == second then first else name
                  new = Map.mapKeysWith (+) (bimap whole (fmap whole)) (measuresOf scene)
               in new === old
  describe "the shared vectors" $ do
    folders <- runIO (sort <$> listDirectory vectorFolder)
    it "are there" $
      length folders `shouldSatisfy` (>= 8)
    forM_ folders $ \folder -> do
      graphText <- runIO (textOf (vectorFolder </> folder </> "graph.txt"))
      factorsText <- runIO (textOf (vectorFolder </> folder </> "factors.csv"))
      it ("agree on " <> folder) $ do
        result <- readSceneFile (vectorFolder </> folder </> "scene.json")
        case result of
          Left problems -> expectationFailure (show problems)
          Right scene -> do
            -- The one folder without factors says so here; all have a graph.
            (isJust graphText, isJust factorsText) `shouldBe` (True, folder /= "thin-walls")
            forM_ graphText $ \text ->
              graphOf scene
                `shouldBe` Set.fromList
                  [(min p q, max p q) | line <- lines text, [p, q] <- [mapMaybe readCornerName (words line)]]
            forM_ factorsText $ \text -> do
              let expected = Map.fromList (mapMaybe row (drop 1 (lines text)))
                  got = Map.mapKeys (bimap sideText (maybe "sky" sideText)) (factorsOf scene)
              Map.keys got `shouldBe` Map.keys expected
              [ key
                | (key, q) <- Map.toList expected
                , Just f <- [Map.lookup key got]
                , let gap = f - rational q
                , let bound = rational (abs q / 10 ^ (28 :: Int))
                , gap > bound || negate gap > bound
                ]
                `shouldBe` []
  where
    both f (a, b) = (f a, f b)
    inOrder (a, b) = (min a b, max a b)
    measuresIn scene = measures scene (vertices scene)
    times k (Point x y) = Point (k * x) (k * y)
    areSmall places = case places of SmallPlaces _ -> True; LargePlaces _ -> False
    triangle m n = [Point 0 0, Point (2 * m * n) 0, Point 0 (m * m - n * n)]
    areNearest scene = doublesOf scene === roundedOf scene
    areDecimals n scene =
      [(from, to, Bytes.unpack text) | FactorRow from found _ <- decimalFactors n scene sums, (to, text) <- found]
        === [(factorFrom f, factorTo f, decimal n (factorValue f)) | f <- formFactors scene sums]
      where
        sums = measuresIn scene
    areExact n scene =
      conjoin
        [ concatMap flattened (exactFactors n scene sums)
            === [ (factorFrom f, factorTo f, decimal n (factorValue f), terms (factorMeasure f))
                | f <- formFactors scene sums
                ]
        , counterexample "each side has a row" $ map rowFrom (exactFactors n scene sums) === statedSides scene
        ]
      where
        sums = measuresIn scene
        flattened (FactorRow from found _) = [(from, to, Bytes.unpack text, terms area) | (to, (text, area)) <- found]
    -- Two Doubles are enough for the shorter ones.
    someDigits :: Gen Digits
    someDigits = fromMaybe defaultDigits . digits <$> choose (1, 40)
    byLength scene f = case terms (sideLength scene (factorFrom f)) of
      [(c, n)] -> timesRoot c n (factorValue f)
      _ -> Nothing
    lookupFactor made from to = do
      s <- made
      Map.lookup (sideOf from, Just (sideOf to)) (factorsOf (sampleScene s))
    sideOf (p, k) = SideName (if p == "E" then Enclosure else Obstacle (read p)) k
    squareRoom walls =
      sample (RawScene Nothing (Just (loop [(0, 0), (1, 0), (1, 1), (0, 1)])) (map loop walls))
    loop corners' = rawPolygon [Point x y | (x, y) <- corners']
    textOf path = doesFileExist path >>= \there -> if there then Just <$> readFile path else pure Nothing
    row line = case break (== ',') line of
      (from, ',' : rest) -> case break (== ',') rest of
        (to, ',' : value) -> case readFloat value of
          [(q, "")] -> Just ((from, to), q :: Rational)
          _ -> Nothing
        _ -> Nothing
      _ -> Nothing

vectorFolder :: FilePath
vectorFolder = "test" </> "vectors"

changesNothing :: Sample -> Gen Change -> Property
changesNothing s change = forAll change $ \c ->
  onScene (changedScene c) $ \scene -> factorsOf scene === renamedFactors (newSide c) (factorsOf (sampleScene s))

-- | The scene with all its corners elsewhere.
changed :: (Point -> Point) -> RawScene -> RawScene
changed f (RawScene name room polygons) = RawScene name (moved <$> room) (map moved polygons)
  where
    moved p = p {rawCorners = map f (rawCorners p)}

-- | The image of a scene with whole coordinates under an integer matrix: about so wide and so high, but no more.
filling :: Integer -> RawScene -> Gen RawScene
filling extent raw = do
  (a, b, c, d) <- ((,,,) <$> entry <*> entry <*> entry <*> entry) `suchThat` \(a, b, c, d) -> a * d /= b * c
  let (ka, kb) = stretched a b
      (kc, kd) = stretched c d
  pure (changed (\(Point x y) -> Point (ka * x + kb * y) (kc * x + kd * y)) raw)
  where
    entry = fromInteger <$> choose (-99, 99)
    points = concatMap rawCorners (maybe id (:) (rawEnclosure raw) (rawPolygons raw))
    spanOf along = let xs = map along points in maximum xs - minimum xs
    -- Rounding moves nothing by more than the slack, nor can it make the determinant zero: a row is thousands of times
    -- as long as its like.
    slack = spanOf (\(Point x _) -> x) + spanOf (\(Point _ y) -> y)
    stretched u v = (whole (k * u), whole (k * v))
      where
        k = (fromInteger extent - slack) / max 1 (spanOf (\(Point x y) -> u * x + v * y))
    whole q = fromInteger (round q)

onScene :: Testable p => RawScene -> (Scene -> p) -> Property
onScene raw f = maybe (counterexample ("not valid: " <> sampleText raw) False) (property . f . sampleScene) (sample raw)

-- | Form factors by rays, in Doubles: from points spread over what is not covered of a side, the angles to all corners
-- cut the half plane in front of it into intervals, in each of which one object is seen.
agreesWithRays :: Sample -> Property
agreesWithRays s =
  conjoin
    [ counterexample (show (sideText side, seenText object, value, sampled)) $
        abs (value - sampled) < 0.02
    | side <- statedSides scene
    , let exact = Map.fromList [(factorTo f, nearestDouble (factorValue f)) | f <- factors, factorFrom f == side]
    , let byRays =
            Map.fromListWith
              (+)
              [ (seenAs scene object, spanOf piece / nearestDouble (sideLength scene side) * f)
              | piece <- concat (piecesOf scene side)
              , (object, f) <- Map.toList (sampledOn piece)
              ]
    , object <- Map.keys (Map.union exact byRays)
    , let value = Map.findWithDefault 0 object exact
    , let sampled = Map.findWithDefault 0 object byRays
    ]
  where
    scene = sampleScene s
    sampledOn = sampledFactors scene
    spanOf piece =
      let Point ax ay = cornerPoint scene (sideStart piece)
          Point bx by = cornerPoint scene (sideEnd scene piece)
       in sqrt (fromRational ((bx - ax) * (bx - ax) + (by - ay) * (by - ay))) :: Double
    factors = formFactors scene (measures scene (vertices scene))

-- | By rays from the middles of a hundred parts of a side, between the directions to all corners.
sampledFactors :: Scene -> SideId -> Map.Map Object Double
sampledFactors scene = \side -> sampledFrom side (ends side)
  where
    at c = let Point x y = cornerPoint scene c in (fromRational x, fromRational y) :: (Double, Double)
    ends s = (at (sideStart s), at (sideEnd scene s))
    -- Converted once, not for each ray.
    places = map at (corners scene)
    boundary = [(s, ends s) | s <- sides scene]
    sampledFrom side = sampledAlong scene places [other | other@(s, _) <- boundary, s /= side]

-- | The same by the places of all corners, the ends of all other sides, and those of the side.
sampledAlong
  :: Scene -> [Place] -> [(SideId, (Place, Place))] -> (Place, Place) -> Map.Map Object Double
sampledAlong scene places others ((ax, ay), (bx, by)) =
  Map.fromListWith (+) (concatMap fromPoint [(fromIntegral i + 0.5) / fromIntegral count | i <- [0 .. count - 1]])
  where
    count = 100 :: Int
    len = sqrt ((bx - ax) * (bx - ax) + (by - ay) * (by - ay))
    -- Along the side, and to the right of it, where the space is free.
    (tx, ty) = ((bx - ax) / len, (by - ay) / len)
    (nx, ny) = (ty, negate tx)
    fromPoint t =
      [ (object, (sin b - sin a) / 2 / fromIntegral count)
      | (a, b) <- zip bounds (drop 1 bounds)
      , b > a
      , Just object <- [firstHit ((a + b) / 2)]
      ]
      where
        (px, py) = (ax + t * (bx - ax), ay + t * (by - ay))
        bounds = sort (negate (pi / 2) : pi / 2 : [atan2 along out | (along, out) <- seen, out > 1e-9 * len])
        seen = map local places
        here = [(s, local a, local b) | (s, (a, b)) <- others]
        local (x, y) = ((x - px) * tx + (y - py) * ty, (x - px) * nx + (y - py) * ny)
        firstHit angle = case [(r, s) | (s, a, b) <- here, Just r <- [distanceTo (sin angle, cos angle) a b]] of
          [] -> case surroundings scene of OpenSky -> Just Sky; Room -> Nothing
          hits -> Just (Side (snd (minimum hits)))
        -- Sides are met from their right. The ray leaves the side itself, and the other face of a wall is behind it.
        distanceTo (rx, ry) (cx, cy) (dx, dy)
          | inward > 0, r > 1e-9 * len, u >= 0, u <= 1 = Just r
          | otherwise = Nothing
          where
            (ex, ey) = (dx - cx, dy - cy)
            -- Local axes (along, out) are a mirror image of (x, y).
            inward = negate (ex * ry - ey * rx)
            r = (cx * ey - cy * ex) / (rx * ey - ry * ex)
            u = (cx * ry - cy * rx) / (rx * ey - ry * ex)

-- | Coordinates.
type Place = (Double, Double)
