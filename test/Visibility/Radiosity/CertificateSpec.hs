module Visibility.Radiosity.CertificateSpec (spec) where

import Data.Maybe (fromMaybe)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Test.Hspec
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Interval hiding (around)
import Visibility.Exact.Rounding (defaultDigits, digits)
import Visibility.FormFactor
import Visibility.Mesh.Element
import Visibility.Radiosity
import Visibility.Radiosity.Certificate
import Visibility.Radiosity.System
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Sweep
import Visibility.Test.Generator
import Visibility.Test.Light

places :: BinaryPlaces
places = BinaryPlaces 160

systemOf :: Scene -> System
systemOf scene = fromNearest places (unrefined scene) (nearestFactors scene (measures scene (vertices scene)))

-- | A number in units of a system, rounded down.
units :: System -> Rational -> Integer
units system q = let Interval low _ = between places (scaled, scaled) in low
  where
    scaled = q * powerOfTwo (negate (systemScale system))

-- | The guesses that are allowed: nothing where no light leaves.
guesses :: System -> (Int -> Integer) -> V.Vector Integer
guesses system f = V.generate (systemSize system) (\i -> if systemLit system U.! i then max 0 (f i) else 0)

spec :: Spec
spec = do
  describe "enclosureFrom" $ do
    it "encloses the solution whatever was guessed" $
      property $ \(AnyScene s) -> forAll (furnished s) $ \lit ->
        let scene = sampleScene lit
            system = systemOf scene
         in forAll (vectorOf (systemSize system) (choose (0, 2 ^ (12 :: Int)))) $ \wild ->
              forAll (elements [0, 30, 100, 150, 170]) $ \bits ->
                let truth = either (const []) (map litRadiosity . litElements) (radiosity fine scene sums)
                    sums = measures scene (vertices scene)
                    exact = V.fromList (map fst truth)
                    guess = guesses system (\i -> units system (exact V.! i) + (wild !! i) * 2 ^ (bits :: Int))
                    bounds = fmap (V.toList . radiosityWithin) (enclosureFrom system (residuals system guess))
                    unit = powerOfTwo (systemScale system)
                    apart =
                      [ i
                      | (i, (a, b), interval) <- zip3 [0 :: Int ..] truth (fromMaybe [] bounds)
                      , let (low, high) = ends places interval
                      , b < low * unit || a > high * unit
                      ]
                 in (length truth, length <$> bounds, apart) === (systemSize system, Just (systemSize system), [])
    it "is tight in a white furnace, where any smaller bound is wrong" $
      forAll closedRoom $ \s -> forAll (choose (1, 9)) $ \k ->
        maybe (counterexample "the scene is not valid" False) (tight (fromInteger k / 10) . sampleScene) $
          sample (everywhere (Material 1 (fromInteger k / 10)) (sampleRaw s))
  where
    fine = ToDigits (fromMaybe defaultDigits (digits 50))
    -- A guess that is too high by as much everywhere is too high by no more than the bounds say, and by no less.
    tight rho scene =
      let system = systemOf scene
          free = V.map ((> 0) . patchOpen) (systemPatches system)
          excess = 2 ^ (150 :: Int)
          guess = guesses system (\i -> if free V.! i then units system (1 / (1 - rho)) + excess else units system 1)
          found = residuals system guess
          weaker = V.map (\r -> r {residualWithin = shrunk (residualWithin r)}) found
          shrunk (Interval low high) = Interval (low * 9 `div` 10) (high * 9 `div` 10)
          target = units system (1 / (1 - rho))
          lows bounds = [low | (True, Interval low _) <- zip (V.toList free) (V.toList (radiosityWithin bounds))]
       in case (enclosureFrom system found, enclosureFrom system weaker) of
            (Just good, Just bad) ->
              conjoin
                [ counterexample "too high" (all (<= target) (lows good))
                , counterexample "too low" (all (>= target - excess `div` 1000000) (lows good))
                , counterexample "too small a residual does not show" (any (> target + 1) (lows bad))
                ]
            _ -> counterexample "there are no bounds" False

systemSize :: System -> Int
systemSize = V.length . systemPatches
