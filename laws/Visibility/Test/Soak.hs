-- | What a soak asks of a scene: that the sweep finds what brute force finds, and that closure is exact. Also the
-- families of scenes that it is asked of.
module Visibility.Test.Soak
  ( SoakFamily (..)
  , soakFamilies
  , faults
  ) where

import Data.List (sort)
import Test.QuickCheck (Gen)
import Visibility.Exact.RootSum (Sign (..), sign)
import Visibility.FormFactor
import Visibility.Scene
import Visibility.Sweep
import Visibility.Test.BruteForce (bruteForce)
import Visibility.Test.Generator

-- | A kind of scenes, by name.
data SoakFamily = SoakFamily {soakName :: String, soakScenes :: Gen Sample}

-- | All kinds that aim at degeneracy.
soakFamilies :: [SoakFamily]
soakFamilies =
  [ SoakFamily "lattice" latticeScene
  , SoakFamily "touching" touchingScene
  , SoakFamily "grid" gridScene
  , SoakFamily "needles" needleScene
  , SoakFamily "families" familyScene
  , SoakFamily "lattice, hard coordinates" (latticeScene >>= dressed)
  , SoakFamily "touching, hard coordinates" (touchingScene >>= dressed)
  ]

-- | What is wrong with the results for a scene; nothing.
--
-- /Cost/ O(n³), for brute force.
faults :: Sample -> [String]
faults (Sample _ scene) =
  ["the topological sweep and brute force differ" | swept /= bruteForce scene]
    <> ["the straight sweep and brute force differ" | sort (straightVertices scene) /= swept]
    <> ["side " <> sideText s <> " does not close" | (s, defect) <- closureDefect scene sums, sign defect /= Zero]
    <> [ "what " <> seenText a <> " and " <> seenText b <> " see of each other is negative"
       | ((a, b), total) <- statedMeasures scene sums
       , sign total /= Positive
       ]
  where
    found = vertices scene
    swept = sort found
    sums = measures scene found
