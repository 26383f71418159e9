-- | @viscomplex complex@ as its users see it.
module Command.ComplexSpec (spec) where

import Command.Run
import Control.Monad (forM_)
import Test.Hspec

spec :: Spec
spec = forM_ [("of sides", [], ".json"), ("of polygons", ["--polygons"], ".polygons.json")] $ \(what, options, ending) ->
  it ("prints the complex " <> what) $ do
    printed <- output (["complex", golden <> ".scene.json"] <> options) ""
    expected <- readFile (golden <> ending)
    printed `shouldBe` expected
  where
    golden = "test/golden/complex/two-squares"
