module Report.ArithmeticSpec (spec) where

import Control.Monad (forM_)
import Data.Maybe (isJust)
import Report.Arithmetic
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Point (Arithmetic (..), Kernel (..), Point (..), pointsKernel)
import Visibility.Scene
import Visibility.Scene.Family (Family (Random), Seed (..), family, size)
import Visibility.Scene.Raw (RawPolygon (..), RawScene (..))
import Visibility.Scene.Validate (validate)
import Visibility.Sweep
import Visibility.Test.BruteForce (bruteForce)
import Visibility.Test.Generator

spec :: Spec
spec = do
  describe "rationals" $
    it "find the same vertices in the same order" $
      property $ \(AnyScene s) ->
        forAll schedulers $ \scheduler ->
          let scene = sampleScene s in verticesBy scheduler (inRationals scene) === verticesBy scheduler scene
  describe "countingSigns" $ do
    modifyMaxSuccess (* 3) $
      it "changes no result, and counts where the filter decides" $
        property $ \(AnyScene s) ->
          forAll (elements [Filtered, Exact]) $ \arithmetic ->
            forAll schedulers $ \scheduler -> ioProperty $ do
              let scene = underArithmetic arithmetic (sampleScene s)
                  -- Fails where a vertex differs.
                  same found = if found == verticesBy scheduler scene then 1 else error "other vertices" :: Int
              counted <- countingSigns scene (same . verticesBy scheduler)
              pure ((isJust counted, sensible counted) === (byFilter scene, True))
    it "counts in every scene anew, and nothing that is not evaluated" $
      forM_ (sampleScene <$> sampleOf (lattice (10 ^ (12 :: Int)))) $ \scene -> do
        first <- countingSigns scene (swept Topological)
        second <- countingSigns scene (swept Topological)
        none <- countingSigns scene (const 0)
        second `shouldBe` first
        none `shouldBe` Just (Signs 0 0)
    it "finds at least each collinear corner left to integers" $
      forM_ [sampleScene <$> sampleOf (lattice (10 ^ k)) | k <- [12, 300 :: Int]] $
        maybe (expectationFailure "no scene") $ \scene -> do
          let collinear = sum [length (vertexCorners v) - 2 | v <- bruteForce scene]
          collinear `shouldSatisfy` (> 20)
          forM_ [Topological, Straight] $ \scheduler -> do
            counted <- countingSigns scene (swept scheduler)
            maybe 0 signsLeft counted `shouldSatisfy` (>= collinear)
    it "finds less than one sign in a thousand left to integers in general position, whatever the size of numbers" $
      forM_ [(huge, huge), (3 ^ (90 :: Int), 1), (1, huge), (huge, 1 / huge)] $ \factors ->
        case fmap (\n -> validate (stretched factors (family Random n (Seed 1)))) (size 150) of
          Just (Right scene) -> do
            counted <- countingSigns scene (swept Topological)
            maybe 0 signsDecided counted `shouldSatisfy` (> 100000)
            maybe 1 shareLeft counted `shouldSatisfy` (< 1 / 1000)
          _ -> expectationFailure "no scene"
    it "has a share of nothing where there is nothing" $
      map shareLeft [Signs 0 0, Signs 4 1] `shouldBe` [0, 1 / 4]
  where
    schedulers = elements [Topological, Straight]
    swept scheduler = length . verticesBy scheduler
    byFilter scene = case pointsKernel (scenePoints scene) of
      FilterKernel _ -> True
      _ -> False
    sensible = maybe True (\(Signs decided left) -> 0 <= left && left <= decided)
    lattice unit =
      [ [(unit * (x + dx), unit * (y + dy)) | (dx, dy) <- [(0, 0), (1, 0), (1, 1), (0, 1)]]
      | x <- [0, 2, 4]
      , y <- [0, 2, 4]
      ]
    huge = 10 ^ (300 :: Int)
    stretched factors raw = raw {rawPolygons = map (onCorners factors) (rawPolygons raw)}
    onCorners (a, b) p = p {rawCorners = [Point (a * x) (b * y) | Point x y <- rawCorners p]}
