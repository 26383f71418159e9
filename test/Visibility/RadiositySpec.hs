module Visibility.RadiositySpec (spec) where

import Control.Monad (forM_)
import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Ratio ((%))
import System.FilePath ((</>))
import Test.Hspec
import Test.QuickCheck hiding (sample, tolerance, within)
import Visibility.Exact.Point
import Visibility.Exact.RootSum
import Visibility.Exact.Rounding (Digits, defaultDigits, digits)
import Visibility.Format.File (readSceneFile)
import Visibility.FormFactor
import Visibility.Mesh
import Visibility.Radiosity
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Sweep
import Visibility.Test.Generator
import Visibility.Test.Light
import Visibility.Test.Metamorphic

spec :: Spec
spec = do
  describe "a white furnace" $ do
    forM_ [("in Doubles", close 12), ("to digits", ToDigits (count 25))] $ \(name, closeness) ->
      it ("has the radiosity E/(1 − ρ) everywhere, " <> name) $
        forAll closedRoom $ \s ->
          forAll ((,) <$> elements [1, 2 % 3, 10 ^ (40 :: Int)] <*> elements [0, 1 % 2, 7 % 10, 99 % 100]) $ \(e, r) ->
            onScene (everywhere (Material e r) (sampleRaw s)) $ \scene ->
              solved closeness scene $ \found ->
                [ elementText (litElement l)
                | l <- litElements found
                , litOpen l > 0
                , not (litRadiosity l `has` (e / (1 - r)))
                ]
                  === []
    it "has it on every element of a mesh too" $
      forAll (resize 15 closedRoom) $ \s ->
        forAll ((,) <$> elements [1, 2 % 3] <*> elements [0, 1 % 2, 99 % 100]) $ \(e, r) ->
          forAllBlind (choose (1, 3) `suchThatMap` elementCount) $ \parts ->
            onScene (everywhere (Material e r) (sampleRaw s)) $ \scene ->
              let (few, _) = bounded parts (discontinuityMesh scene (vertices scene))
               in forAllBlind (elements [refined few, refined (uniformMesh parts scene)]) $ \cut ->
                    either (\why -> counterexample (show why) False) property $ do
                      found <- radiosityOfElements (close 12) cut (measured (refinedScene cut))
                      Right $
                        [ elementText (litElement l)
                        | l <- litElements found
                        , not (litRadiosity l `has` (e / (1 - r)))
                        ]
                          === []
  describe "the bounds" $ do
    it "enclose the solution that elimination finds" $
      property $ \(SmallScene s) -> forAll (furnished s) $ \lit ->
        let scene = sampleScene lit
            truth = eliminated scene
            slack = maximum truth / 10 ^ (45 :: Int)
         in conjoin
              [ solved closeness scene $ \found ->
                  [ (name, bounds)
                  | (name, bounds) <- named found
                  , maybe True (not . near slack bounds) (Map.lookup name truth)
                  ]
                    === []
              | closeness <- [close 9, close 12, ToDigits (count 8), ToDigits (count 40)]
              ]
    it "in Doubles and from exact form factors meet" $
      property $ \(AnyScene s) -> forAll (furnished s) $ \lit ->
        let scene = sampleScene lit
         in solved (close 12) scene $ \rough -> solved (ToDigits (count 60)) scene $ \fine ->
              apart (named rough) (named fine) === []
    it "are as close as asked" $
      property $ \(AnyScene s) -> forAll (furnished s) $ \lit -> forAll (elements [1, 3, 9, 12]) $ \k ->
        solved (close k) (sampleScene lit) $ \found -> counterexample (show (named found)) (spread found * 10 ^ k <= 1)
    it "to digits are closer than those" $
      property $ \(TouchingScene s) -> forAll (furnished s) $ \lit -> forAll (elements [1, 10, 33]) $ \k ->
        solved (ToDigits (count k)) (sampleScene lit) $ \found ->
          counterexample (show (named found)) (spread found * 10 ^ (k + 1) <= 1)
    it "would be wrong if they were a hundred times as close, so they can fail" $ do
      scene <- flat
      either (fail . show) pure $ do
        rough <- solution (close 9) scene
        fine <- solution (ToDigits (count 30)) scene
        Right (length (apart (map (fmap (narrowed 100)) (named rough)) (named fine)) * 4 > length (named fine))
      >>= (`shouldBe` True)
    it "say where Doubles end, and hold there" $ do
      scene <- flat
      case solution (close 25) scene of
        Right _ -> expectationFailure "Doubles cannot prove 1e-25"
        Left (Shortfall Nothing _) -> expectationFailure "nothing was proved"
        Left (Shortfall (Just proved) _) -> do
          proved `shouldSatisfy` (< 1 % 10 ^ (14 :: Int))
          let possible = maybe (close 9) WithinTolerance (tolerance (proved * 10 / 9))
          either (const False) ((<= proved) . spread) (solution possible scene) `shouldBe` True
  describe "the radiosity" $ do
    it "is the emission where nothing is reflected" $
      property $ \(AnyScene s) -> forAll (furnished s) $ \lit ->
        let dull name = (statedMaterial (sampleScene lit) name) {reflectivity = 0}
         in onScene (withMaterials dull (sampleRaw lit)) $ \scene ->
              solved (close 12) scene $ \found ->
                [ elementText (litElement l)
                | l <- litElements found
                , not (litRadiosity l `has` emission (litMaterial l))
                ]
                  === []
    it "is exactly zero where no light comes" $
      property $ \(AnyScene s) -> forAll (furnished s) $ \lit ->
        onScene (withEmissions (\_ _ -> 0) lit) $ \scene ->
          solved (close 9) scene $ \found ->
            (map snd (named found), energy found) === (map (const (0, 0)) (named found), Balance (0, 0) (0, 0) (0, 0))
    it "of two lights is the sum of those of each" $
      property $ \(AnyScene s) -> forAll (furnished s) $ \lit ->
        let odds (SideName _ k) = odd k
            only wanted name e = if odds name == wanted then e else 0
            with f act = onScene (withEmissions f lit) (\scene -> solved (close 12) scene act)
         in with (only True) $ \a -> with (only False) $ \b -> with (const id) $ \both ->
              let sums = zipWith (\(name, (l, h)) (_, (l', h')) -> (name, (l + l', h + h'))) (named a) (named b)
               in apart sums (named both) === []
    it "does not change when a scene is moved, scaled, turned or mirrored" $
      property $ \(AnyScene s) -> forAll (furnished s) $ \lit -> forAll (similarity (sampleRaw lit)) $ \change ->
        onScene (moved change lit) $ \other ->
          solved (close 12) (sampleScene lit) $ \old -> solved (close 12) other $ \new ->
            apart (sortOn fst [(newSide change name, b) | (name, b) <- named old]) (sortOn fst (named new)) === []
    it "of two facing unit squares is by one geometric series" $ do
      let square x k e r =
            (rawPolygon [Point x 0, Point (x + 1) 0, Point (x + 1) 1, Point x 1])
              { rawSides = Map.fromList [(k, MaterialOverride (Just e) (Just r))]
              }
          raw = RawScene Nothing Nothing [square 0 1 1 (1 / 2), square 2 3 0 (2 / 3)]
          -- F = √2 − 1, F² = 3 − 2√2; B = 1 / (1 − F²/3) and 2/3 F B.
          loss = rational (1 - 3 / 3) + twice (2 / 3)
          twice q = fromMaybe zero (root q 2)
          forth = twice (2 / 3) - rational (2 / 3)
      forM_ [close 12, ToDigits (count 50)] $ \closeness ->
        case fmap (solution closeness . sampleScene) (sample raw) of
          Just (Right found) -> do
            let at name = fromMaybe (0, 0) (lookup name (named found))
                (low, high) = at (SideName (Obstacle 0) 1)
                (low', high') = at (SideName (Obstacle 1) 3)
            (scaled low loss <= rational 1, scaled high loss >= rational 1) `shouldBe` (True, True)
            (scaled low' loss <= forth, scaled high' loss >= forth) `shouldBe` (True, True)
          _ -> expectationFailure "there is no solution"
    it "of a side that is covered in part is that of the part that is free" $ do
      let lamp = (rawPolygon [Point 4 0, Point 5 0, Point 5 3, Point 4 3]) {rawMaterial = Material 1 (1 / 3)}
          box = rawPolygon [Point 2 0, Point 3 0, Point 3 1, Point 2 1]
          block loop = (rawPolygon loop) {rawMaterial = Material (1 / 5) (1 / 2)}
          whole = block [Point 0 0, Point 2 0, Point 2 3, Point 0 3]
          cut = block [Point 0 0, Point 2 0, Point 2 1, Point 2 3, Point 0 3]
          found polygons name = do
            s <- sample (RawScene Nothing Nothing polygons)
            f <- either (const Nothing) Just (solution (ToDigits (count 20)) (sampleScene s))
            (,) (energy f) <$> lookup name (named f)
      case (found [whole, box, lamp] (SideName (Obstacle 0) 1), found [cut, box, lamp] (SideName (Obstacle 0) 2)) of
        (Just (energy1, bounds1), Just (energy2, bounds2)) -> do
          (bounds1, bounds2) `shouldSatisfy` uncurry meets
          (lostPower energy1, lostPower energy2) `shouldSatisfy` uncurry meets
          fst bounds1 `shouldSatisfy` (> 1 / 5)
        _ -> expectationFailure "there is no solution"
  describe "energy" $ do
    it "is balanced within the bounds, and nothing is lost from a room" $
      property $ \(AnyScene s) -> forAll (furnished s) $ \lit ->
        solved (close 12) (sampleScene lit) $ \found ->
          conjoin
            [ balanceViolations (energy found) === []
            , property (surroundings (sampleScene lit) == OpenSky || lostPower (energy found) == (0, 0))
            ]
    it "that does not balance is found out" $ do
      scene <- flat
      case energy <$> solution (close 12) scene of
        Right balance -> do
          balanceViolations balance `shouldBe` []
          forM_ [999 % 1000, 1001 % 1000] $ \k -> do
            let both f (a, b) = (f a, f b)
            length (balanceViolations balance {absorbedPower = both (* k) (absorbedPower balance)}) `shouldBe` 1
        Left why -> expectationFailure (show why)
  describe "extremes" $ do
    it "of emission are no trouble" $
      forM_ [10 ^ (400 :: Int), 1 % 10 ^ (400 :: Int)] $ \e ->
        case fmap (solution (close 12) . sampleScene) (sample (everywhere (Material e (1 / 2)) emptyRoom)) of
          Just (Right found) -> [l | (_, l) <- named found, not (l `has` (2 * e))] `shouldBe` []
          _ -> expectationFailure "there is no solution"
    it "of reflectivity are solved, or refused without a wrong bound" $
      forM_ [1 - 1 % 10 ^ k | k <- [3, 6, 12, 30, 400 :: Int]] $ \r ->
        forM_ [close 6, ToDigits (count 20)] $ \closeness ->
          case fmap (solution closeness . sampleScene) (sample (everywhere (Material 1 r) emptyRoom)) of
            Just (Right found) -> [l | (_, l) <- named found, not (l `has` (1 / (1 - r)))] `shouldBe` []
            Just (Left _) -> r `shouldSatisfy` (> 1 - 1 % 10 ^ (9 :: Int))
            Nothing -> expectationFailure "the room is not valid"
  where
    emptyRoom = RawScene Nothing (Just (rawPolygon [Point 0 0, Point 5 0, Point 7 3, Point 0 2])) []

-- | 10^−k.
close :: Int -> Closeness
close k = maybe (WithinTolerance defaultTolerance) WithinTolerance (tolerance (1 % 10 ^ k))

count :: Int -> Digits
count = fromMaybe defaultDigits . digits

solution :: Closeness -> Scene -> Either Shortfall Radiosity
solution closeness scene = radiosity closeness scene (measured scene)

measured :: Scene -> Measures
measured scene = measures scene (vertices scene)

solved :: Testable p => Closeness -> Scene -> (Radiosity -> p) -> Property
solved closeness scene act = case solution closeness scene of
  Right found -> property (act found)
  Left why -> counterexample (show why) False

onScene :: Testable p => RawScene -> (Scene -> p) -> Property
onScene raw act = maybe (counterexample "the scene is not valid" False) (property . act . sampleScene) (sample raw)

named :: Radiosity -> [(SideName, (Rational, Rational))]
named found = [(elementIn (litElement l), litRadiosity l) | l <- litElements found]

has :: (Rational, Rational) -> Rational -> Bool
has (low, high) x = low <= x && x <= high

meets :: (Rational, Rational) -> (Rational, Rational) -> Bool
meets (a, b) (c, d) = a <= d && c <= b

-- | What has bounds that exclude each other.
apart :: [(SideName, (Rational, Rational))] -> [(SideName, (Rational, Rational))] -> [SideName]
apart as bs = [name | ((name, a), (other, b)) <- zip as bs, name /= other || not (meets a b)]

narrowed :: Rational -> (Rational, Rational) -> (Rational, Rational)
narrowed k (low, high) = (middle - (middle - low) / k, middle + (high - middle) / k)
  where
    middle = (low + high) / 2

-- | The changed scene. What a wall has on one face it has on the other one in a mirror: materials go with their sides.
moved :: Change -> Sample -> RawScene
moved change s = withMaterials material (changedScene change)
  where
    material name = Map.findWithDefault black name materials
    materials = Map.fromList [(newSide change name, statedMaterial scene name) | name <- statedSides scene]
    scene = sampleScene s

-- | The largest distance of bounds, as a part of the largest radiosity.
spread :: Radiosity -> Rational
spread found = if widest == 0 then 0 else widest / maximum (map fst bounds)
  where
    bounds = map snd (named found)
    widest = maximum (0 : [high - low | (low, high) <- bounds])

flat :: IO Scene
flat = readSceneFile ("scenes" </> "flat.json") >>= either (fail . show) pure

-- | Radiosities by Gaussian elimination in rationals, with form factors to 200 places: their errors are far below all
-- that is compared.
eliminated :: Scene -> Map.Map SideName Rational
eliminated scene = Map.fromList (zip names (gauss [row i | i <- [0 .. length names - 1]]))
  where
    names = statedSides scene
    known =
      Map.fromList
        [ ((factorFrom f, factorTo f), fst (enclosure 200 (factorValue f)))
        | f <- formFactors scene (measured scene)
        ]
    row i =
      let name = names !! i
          Material e r = statedMaterial scene name
          open = uncovered scene name
          gain = if open == 0 then 0 else r / open
       in [ (if j == i then 1 else 0) - gain * Map.findWithDefault 0 (name, TheSide other) known
          | (j, other) <- zip [0 ..] names
          ]
            <> [e]

-- | Solves rows of coefficients with the right side last; the diagonal dominates.
gauss :: [[Rational]] -> [Rational]
gauss [] = []
gauss (row : rest) = case row of
  pivot : more -> x : others
    where
      others = gauss [zipWith (\a b -> shortened (b - a * (first / pivot))) more below | first : below <- rest]
      x = (lastOf more - sum (zipWith (*) more others)) / pivot
  [] -> []
  where
    lastOf = foldl (const id) 0

-- | Cut to 300 places, so that numbers stay short.
shortened :: Rational -> Rational
shortened q = fromInteger (floor (q * unit)) / unit
  where
    unit = 2 ^ (300 :: Int)

-- | Between the bounds, but for the errors of elimination.
near :: Rational -> (Rational, Rational) -> Rational -> Bool
near slack (low, high) x = low - slack <= x && x <= high + slack
