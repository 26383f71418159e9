module Visibility.Radiosity.SystemSpec (spec) where

import Data.Maybe (fromMaybe)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Test.Hspec
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Interval hiding (around)
import Visibility.Exact.Point
import Visibility.Exact.Rounding (defaultDigits, digits)
import Visibility.FormFactor
import Visibility.Mesh.Element
import Visibility.Radiosity
import Visibility.Radiosity.System
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Sweep
import Visibility.Test.Generator
import Visibility.Test.Light (withMaterials)

spec :: Spec
spec = do
  describe "the factors of both systems" $ do
    it "are the same, as closely as each is known" $
      property $ \(AnyScene s) ->
        let (near, exact) = both (sampleScene s)
            lower = case factorPrecision (systemMatrix exact) of
              Enclosed found -> V.toList found
              CorrectlyRounded -> []
            -- F is between a and a + 2 units, and within x 2^-52 or 2^-1074 of the nearest Double x.
            disagree x a =
              let (low, high) = ends places (Interval a (a + 2))
                  slack = toRational x * powerOfTwo (-52) + powerOfTwo (-1074)
               in low > toRational x + slack || high < toRational x - slack
         in conjoin
              [ rowStarts (systemMatrix near) === rowStarts (systemMatrix exact)
              , columns (systemMatrix near) === columns (systemMatrix exact)
              , [x | (x, a) <- zip (U.toList (factorDoubles (systemMatrix near))) lower, disagree x a] === []
              , [ x
                | (x, a) <- zip (U.toList (factorDoubles (systemMatrix exact))) lower
                , toRational x < snd (ends places (Interval a (a + 2)))
                ]
                  === []
              ]
    it "add up to the part that is not covered, the sky's among them" $
      property $ \(AnyScene s) ->
        let (near, _) = both (sampleScene s)
            matrix = systemMatrix near
            row i =
              let begin = rowStarts matrix U.! i
                  entries = U.slice begin (rowStarts matrix U.! (i + 1) - begin) (factorDoubles matrix)
               in sum (map toRational (U.toList entries))
            closes i patch = abs (row i + snd (ends places (patchSky patch)) - patchOpen patch) <= 4 * powerOfTwo (-52)
         in [ sideText (elementIn (patchElement p))
            | (i, p) <- zip [0 ..] (V.toList (systemPatches near))
            , not (closes i p)
            ]
              === []
  describe "what is lit" $
    it "is what the light of one lamp comes to, and nothing on the other side of a wall" $ do
      let wall = rawWall [Point 3 0, Point 3 4]
          room lampAt =
            RawScene
              Nothing
              (Just (rawPolygon [Point 0 0, Point 3 0, Point 6 0, Point 6 4, Point 3 4, Point 0 4]))
              [wall, rawPolygon [Point lampAt 1, Point (lampAt + 1) 1, Point lampAt 2]]
          material (SideName polygon k) = case polygon of
            Obstacle 1 -> Material (if k == 0 then 1 else 0) 0
            _ -> Material 0 (1 / 2)
          litIn raw = do
            scene <- sampleScene <$> sample (withMaterials material raw)
            Just [sideText s | (s, True) <- zip (statedSides scene) (U.toList (systemLit (fst (both scene))))]
      litIn (room 1) `shouldBe` Just ["0.1", "1.0", "E.0", "E.4", "E.5"]
      litIn (room 4) `shouldBe` Just ["0.0", "1.0", "E.1", "E.2", "E.3"]
  describe "elements of refined sides" $
    it "have their places on the sides of the file, and count by their lengths there" $ do
      let material = Material 0 (1 / 2)
          lamp = (rawPolygon [Point 2 1, Point 3 1, Point 2 2]) {rawMaterial = Material 1 0}
          room = (rawPolygon [Point 0 0, Point 1 0, Point 6 0, Point 6 4, Point 0 4]) {rawMaterial = material}
          element (SideName polygon k) = case polygon of
            Enclosure
              | k == 0 -> Element (SideName Enclosure 0) 0 0 (1 / 6) (SideName Enclosure 0)
              | k == 1 -> Element (SideName Enclosure 0) 1 (1 / 6) 1 (SideName Enclosure 1)
              | otherwise -> Element (SideName Enclosure (k - 1)) 0 0 1 (SideName Enclosure k)
            Obstacle _ -> Element (SideName polygon k) 0 0 1 (SideName polygon k)
          solved = do
            scene <- sampleScene <$> sample (RawScene Nothing (Just room) [lamp])
            let closeness = ToDigits (fromMaybe defaultDigits (digits 20))
                sums = measures scene (vertices scene)
                cut = Refined scene (map element (statedSides scene))
            either (const Nothing) Just (radiosityOfElements closeness cut sums)
      case solved of
        Nothing -> expectationFailure "there is no solution"
        Just found -> do
          let bounds text = lookup text [(elementText (litElement l), litRadiosity l) | l <- litElements found]
          map fst (sideAverages found)
            `shouldBe` map (SideName (Obstacle 0)) [0 .. 2] <> map (SideName Enclosure) [0 .. 3]
          case (bounds "E.0#0", bounds "E.0#1", lookup (SideName Enclosure 0) (sideAverages found)) of
            (Just (a, b), Just (c, d), Just mean) -> mean `shouldBe` ((a + 5 * c) / 6, (b + 5 * d) / 6)
            _ -> expectationFailure "an element is missing"

places :: BinaryPlaces
places = BinaryPlaces 100

both :: Scene -> (System, System)
both scene =
  ( fromNearest places (unrefined scene) (nearestFactors scene sums)
  , fromExact places (unrefined scene) (formFactors scene sums)
  )
  where
    sums = measures scene (vertices scene)
