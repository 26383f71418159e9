module Visibility.Test.SoakSpec (spec) where

import Control.Monad (forM_)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck
import Visibility.Test.Generator
import Visibility.Test.Soak

-- | A thousandth of what @make soak@ does, 1000 scenes.
spec :: Spec
spec =
  describe "a soak finds no fault in any scene, shared out over all families" $
    modifyMaxSuccess share $
      forM_ soakFamilies $ \kind ->
        it (soakName kind) $
          forAllShrink (soakScenes kind) shrinkSample $ \s -> faults s === []
  where
    share n = (10 * n + length soakFamilies - 1) `div` length soakFamilies
