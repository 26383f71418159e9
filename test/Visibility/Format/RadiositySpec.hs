module Visibility.Format.RadiositySpec (spec) where

import Data.ByteString.Builder (toLazyByteString)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Maybe (fromMaybe)
import Test.Hspec
import Visibility.Exact.Point
import Visibility.Exact.Rounding (defaultDigits, digits)
import Visibility.FormFactor
import Visibility.Format.Radiosity
import Visibility.Radiosity
import Visibility.Scene.Raw
import Visibility.Sweep
import Visibility.Test.Generator

-- | The document of a triangular room of one material, to five digits.
document :: Material -> Maybe String
document material = do
  found <- sample (RawScene Nothing (Just triangle) [])
  let scene = sampleScene found
  solved <- either (const Nothing) Just (radiosity (ToDigits wanted) scene (measures scene (vertices scene)))
  Just (Lazy.unpack (toLazyByteString (radiosityDocument solved)))
  where
    triangle = (rawPolygon [Point 0 0, Point 4 0, Point 4 3]) {rawMaterial = material}
    wanted = fromMaybe defaultDigits (digits 5)

spec :: Spec
spec = describe "radiosityDocument" $ do
  it "has elements, sides, and powers with their bounds" $
    document (Material (1 / 3) (1 / 4))
      `shouldBe` Just
        ( "{\"format\":\"viscomplex/1\",\"elements\":["
            <> element "0"
            <> ","
            <> element "1"
            <> ","
            <> element "2"
            <> "],\"sides\":["
            <> concatMap (\k -> side k <> (if k == "2" then "" else ",")) ["0", "1", "2"]
            <> "],\"iterations\":1,\"fill\":\"0.666667\""
            <> ",\"emitted\":\"4.0000\",\"emittedBounds\":[\"3.9999\",\"4.0001\"]"
            <> ",\"absorbed\":\"4.0000\",\"absorbedBounds\":[\"3.9999\",\"4.0001\"]"
            <> ",\"lost\":\"0\",\"lostBounds\":[\"0\",\"0\"]}\n"
        )
  it "writes zeros of a room without light" $
    fmap (takeWhile (/= '}')) (document (Material 0 (1 / 2)))
      `shouldBe` Just
        ( "{\"format\":\"viscomplex/1\",\"elements\":[{\"id\":\"E.0#0\",\"from\":\"0\",\"to\":\"1\""
            <> ",\"emission\":\"0\",\"reflectivity\":\"0.5\",\"radiosity\":[\"0\",\"0\"]"
        )
  where
    element k =
      "{\"id\":\"E."
        <> k
        <> "#0\",\"from\":\"0\",\"to\":\"1\",\"emission\":\"1/3\",\"reflectivity\":\"0.25\",\"radiosity\":"
        <> bounds
        <> "}"
    side k = "{\"id\":\"E." <> k <> "\",\"radiosity\":" <> bounds <> "}"
    bounds = "[\"0.44444\",\"0.44445\"]"
