-- | Scenes with light in them: materials for the polygons of a sample.
module Visibility.Test.Light
  ( furnished
  , everywhere
  , withMaterials
  , withEmissions
  , closedRoom
  ) where

import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Ratio ((%))
import Test.QuickCheck hiding (sample)
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Test.Generator

-- | The same polygons with any materials, now and then of single sides: dark ones, lamps, mirrors nearly.
furnished :: Sample -> Gen Sample
furnished plain = fromMaybe plain . sample <$> (RawScene name <$> traverse polygon room <*> traverse polygon obstacles)
  where
    RawScene name room obstacles = sampleRaw plain
    polygon p = do
      whole <- material
      overridden <- sublistOf [0 .. sideTotal p - 1]
      special <- mapM (\k -> (,) k <$> override) overridden
      chosen <- frequency [(2, pure []), (1, pure special)]
      pure p {rawMaterial = whole, rawSides = Map.fromList chosen}
    override = MaterialOverride <$> oneof [pure Nothing, Just <$> shining] <*> oneof [pure Nothing, Just <$> reflecting]

material :: Gen Material
material = Material <$> shining <*> reflecting

shining :: Gen Rational
shining = frequency [(4, pure 0), (2, pure 1), (2, (% 7) <$> choose (1, 50)), (1, elements [large, 1 / large])]
  where
    large = 10 ^ (30 :: Int)

reflecting :: Gen Rational
reflecting =
  frequency
    [(1, pure 0), (4, (% 10) <$> choose (0, 9)), (2, (% 97) <$> choose (1, 96)), (1, pure (999 % 1000))]

-- | The same polygons, all of one material.
everywhere :: Material -> RawScene -> RawScene
everywhere given (RawScene name room obstacles) = RawScene name (polygon <$> room) (map polygon obstacles)
  where
    polygon p = p {rawMaterial = given, rawSides = Map.empty}

-- | The same polygons, with the materials that a function gives to sides, by name.
withMaterials :: (SideName -> Material) -> RawScene -> RawScene
withMaterials given (RawScene name room obstacles) =
  RawScene name (polygon Enclosure <$> room) [polygon (Obstacle k) p | (k, p) <- zip [0 ..] obstacles]
  where
    polygon p raw = raw {rawSides = Map.fromList [(k, whole (given (SideName p k))) | k <- [0 .. sideTotal raw - 1]]}
    whole (Material e r) = MaterialOverride (Just e) (Just r)

-- | The same scene with the emission of each side by its old one and its name.
withEmissions :: (SideName -> Rational -> Rational) -> Sample -> RawScene
withEmissions f s = withMaterials changed (sampleRaw s)
  where
    changed name = let Material e r = statedMaterial (sampleScene s) name in Material (f name e) r

-- | Any scene without a sky.
closedRoom :: Gen Sample
closedRoom = (\(AnyScene s) -> s) <$> (arbitrary `suchThat` \(AnyScene s) -> surroundings (sampleScene s) == Room)
