module Visibility.Format.FactorsSpec (spec) where

import Data.ByteString.Builder (toLazyByteString)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Maybe (fromMaybe)
import Test.Hspec
import Visibility.Exact.Rounding
import Visibility.FormFactor
import Visibility.Format.Factors
import Visibility.Scene (Scene)
import Visibility.Sweep
import Visibility.Test.Generator

-- | A square and a thin wall in front of one of its sides: √2 − 1 of the light of each goes to the other.
pair :: Maybe Scene
pair = sampleScene <$> sampleOf [[(0, 0), (1, 0), (1, 1), (0, 1)], [(2, 0), (2, 1)]]

document :: FactorFormat -> Detail -> Scene -> [String]
document format detail scene =
  lines . Lazy.unpack . toLazyByteString . factorsDocument format detail wanted scene $
    formFactors scene (measures scene (vertices scene))
  where
    wanted = fromMaybe defaultDigits (digits 4)

spec :: Spec
spec = describe "factorsDocument" $ do
  it "writes CSV by the names of both, the sky last" $
    fmap (document FactorsCsv DecimalsOnly) pair
      `shouldBe` Just
        [ "from,to,value"
        , "0.0,sky,1.000"
        , "0.1,1.1,0.4142"
        , "0.1,sky,0.5858"
        , "0.2,sky,1.000"
        , "0.3,sky,1.000"
        , "1.0,sky,1.000"
        , "1.1,0.1,0.4142"
        , "1.1,sky,0.5858"
        ]
  it "adds the exact measure 2 L F on demand" $
    fmap (take 1 . drop 2 . document FactorsCsv WithExactMeasures) pair
      `shouldBe` Just ["0.1,1.1,0.4142,-2 + 2*sqrt(2)"]
  it "writes JSON that names its format, with every side and its length" $
    fmap (concatMap (take 92) . document FactorsJson DecimalsOnly) pair
      `shouldBe` Just
        "{\"format\":\"viscomplex/1\",\"sides\":[{\"id\":\"0.0\",\"length\":\"1.000\"},{\"id\":\"0.1\",\"length\":\"1.000\""
  it "writes a block for each side as text" $
    fmap (take 3 . drop 2 . document FactorsText WithExactMeasures) pair
      `shouldBe` Just
        [ "side 0.1, length 1.000, sees"
        , "  1.1       0.4142  = (-2 + 2*sqrt(2)) / (2 L)"
        , "  sky       0.5858  = (4 - 2*sqrt(2)) / (2 L)"
        ]
