module Visibility.Format.MeshSpec (spec) where

import Data.ByteString.Builder (toLazyByteString)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Test.Hspec
import Visibility.Format.Mesh
import Visibility.Mesh
import Visibility.Scene
import Visibility.Sweep
import Visibility.Test.Generator

-- | Two thin walls, one above the other, and a shelf whose upper side lies below both.
shelf :: Maybe Scene
shelf = sampleScene <$> sampleOf [[(0, 0), (4, 0), (2, -1)], [(1, 1), (3, 1)], [(1, 2), (3, 2)]]

textOf :: Mesh -> Mesh -> String
textOf kept dropped = Lazy.unpack (toLazyByteString (meshDocument kept dropped))

-- | Cut into five parts, told one by one.
inFive :: Scene -> Maybe String
inFive scene = Lazy.unpack . toLazyByteString . (`uniformDocument` scene) <$> elementCount 5

spec :: Spec
spec =
  describe "meshDocument" $ do
    it "writes exact places, kinds and casters, of a side the file's way round" $
      fmap (\scene -> textOf (discontinuityMesh scene (vertices scene)) (emptyMesh scene)) shelf
        `shouldBe` Just
          ( "{\"format\":\"viscomplex/1\",\"sides\":[{\"id\":\"0.0\",\"points\":["
              <> "{\"at\":[\"1\",\"0\"],\"parameter\":\"1/4\",\"kind\":\"shadow-limit\",\"caster\":[\"1.0\",\"2.0\"]},"
              <> "{\"at\":[\"3\",\"0\"],\"parameter\":\"3/4\",\"kind\":\"shadow-limit\",\"caster\":[\"1.1\",\"2.1\"]}]},"
              <> "{\"id\":\"0.1\",\"points\":[]},{\"id\":\"0.2\",\"points\":[]},"
              <> "{\"id\":\"1.0\",\"points\":[]},{\"id\":\"1.1\",\"points\":[]},{\"id\":\"2.0\",\"points\":["
              <> "{\"at\":[\"2\",\"2\"],\"parameter\":\"1/2\",\"kind\":\"shadow-limit\",\"caster\":[\"1.0\",\"0.0\"],"
              <> "\"others\":[{\"caster\":[\"1.1\",\"0.1\"],\"kind\":\"shadow-limit\"}]}]},"
              <> "{\"id\":\"2.1\",\"points\":[]}]}\n"
          )
    it "is the same of sides in equal parts, told one by one" $
      fmap inFive shelf
        `shouldBe` fmap (\scene -> (`textOf` emptyMesh scene) . (`uniformMesh` scene) <$> elementCount 5) shelf
    it "lists what was dropped, and cuts into equal parts without casters" $
      fmap
        ( \scene -> case (elementCount 3, elementCount 2) of
            (Just three, Just two) -> take 197 (uncurry textOf (bounded two (uniformMesh three scene)))
            _ -> ""
        )
        shelf
        `shouldBe` Just
          ( "{\"format\":\"viscomplex/1\",\"sides\":[{\"id\":\"0.0\",\"points\":["
              <> "{\"at\":[\"8/3\",\"0\"],\"parameter\":\"2/3\",\"kind\":\"equal-parts\"}],\"dropped\":["
              <> "{\"at\":[\"4/3\",\"0\"],\"parameter\":\"1/3\",\"kind\":\"equal-parts\"}]},{\"id\":\"0.1\""
          )
