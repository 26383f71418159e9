{-# LANGUAGE OverloadedStrings #-}

module Visibility.Format.FactorsSpec (spec) where

import qualified Data.Aeson as Aeson
import Data.Aeson.Types (parseMaybe)
import Data.ByteString.Builder (toLazyByteString)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Foldable (for_)
import Data.List (isPrefixOf)
import Data.Maybe (fromMaybe)
import Numeric (readFloat)
import Test.Hspec
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.Rounding
import Visibility.FormFactor
import Visibility.Format.Factors
import Visibility.Scene (Scene)
import Visibility.Scene.Raw (RawScene (..), rawPolygon)
import Visibility.Sweep
import Visibility.Test.Generator

-- | A square and a thin wall in front of one of its sides: √2 − 1 of the light of each goes to the other.
pair :: Maybe Scene
pair = pairTimes 1

-- | The same, all coordinates times as much.
pairTimes :: Rational -> Maybe Scene
pairTimes k = squareAndWall [(2 * k, 0), (2 * k, k)] k

-- | A wall and a square of this size.
squareAndWall :: [(Rational, Rational)] -> Rational -> Maybe Scene
squareAndWall wall k = sampleScene <$> sample (RawScene Nothing Nothing (map loop [square, wall]))
  where
    square = [(0, 0), (k, 0), (k, k), (0, k)]
    loop = rawPolygon . map (uncurry Point)

document :: FactorFormat -> Detail -> Scene -> [String]
document format detail scene =
  lines . Lazy.unpack . toLazyByteString $ case detail of
    DecimalsOnly -> decimalDocument format wanted OwnNames scene (decimalFactors wanted scene sums)
    WithExactMeasures -> exactDocument format wanted OwnNames scene (exactFactors wanted scene sums)
  where
    sums = measures scene (vertices scene)
    wanted = fromMaybe defaultDigits (digits 4)

doubles :: FactorFormat -> Scene -> String
doubles format scene =
  Lazy.unpack . toLazyByteString $
    nearestDocument format OwnNames scene (nearestFactors scene (measures scene (vertices scene)))

-- | The lengths that a JSON document tells, as text and as numbers, with the number of its sides.
lengthsIn :: String -> Maybe (Int, [(String, Rational)])
lengthsIn text = do
  document' <- Aeson.decode (Lazy.pack text)
  stated <- parseMaybe (Aeson.withObject "document" (Aeson..: "sides")) document'
  found <- traverse (parseMaybe (Aeson.withObject "side" (Aeson..: "length"))) (stated :: [Aeson.Value])
  pure (length stated, [(word, q) | word <- found, (q, "") <- readFloat word])

spec :: Spec
spec = do
  documents
  nearest

nearest :: Spec
nearest = describe "nearestDocument" $ do
  it "writes the shortest decimals of the Doubles" $
    fmap (take 3 . lines . doubles FactorsCsv) pair
      `shouldBe` Just ["from,to,value", "0.0,sky,1", "0.1,1.1,0.41421356237309503"]
  it "writes lengths beyond the range of Doubles as correctly rounded decimals, in JSON" $
    for_ [(10 ^ (400 :: Int) / 3, "3.3333333333333333e399"), (1 / 10 ^ (400 :: Int) / 3, "3.3333333333333333e-401")] $
      \(k, word) -> do
        found <- maybe (fail "no scene") (pure . lengthsIn . doubles FactorsJson) (pairTimes k)
        fmap fst found `shouldBe` Just 6
        fmap (map fst . snd) found `shouldBe` Just (replicate 6 word)
  it "writes them so as text" $
    fmap (take 1 . lines . doubles FactorsText) (pairTimes (10 ^ (400 :: Int)))
      `shouldBe` Just ["side 0.0, length 1.0000000000000000e400, sees"]
  it "writes those in the range as Doubles, to its ends" $
    for_ [(3, "3"), (10 ^ (308 :: Int), "1e308"), (1 / 10 ^ (320 :: Int), "1e-320")] $ \(k, word) -> do
      found <- maybe (fail "no scene") (pure . lengthsIn . doubles FactorsJson) (pairTimes k)
      fmap (map fst . snd) found `shouldBe` Just (replicate 6 word)
  it "lists a form factor that is too small for a Double as 0" $
    fmap (filter ("0.1,1" `isPrefixOf`) . lines . doubles FactorsCsv) (squareAndWall [(2, 0), (2, tiny)] 1)
      `shouldBe` Just ["0.1,1.1,0"]
  where
    tiny = 1 / 10 ^ (330 :: Int)

documents :: Spec
documents = describe "documents of decimals" $ do
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
        "{\"format\":\"viscomplex/1\",\"sides\":[\
        \{\"id\":\"0.0\",\"length\":\"1.000\"},{\"id\":\"0.1\",\"length\":\"1.000\""
  it "writes a block for each side as text" $
    fmap (take 3 . drop 2 . document FactorsText WithExactMeasures) pair
      `shouldBe` Just
        [ "side 0.1, length 1.000, sees"
        , "  1.1       0.4142  = (-2 + 2*sqrt(2)) / (2 L)"
        , "  sky       0.5858  = (4 - 2*sqrt(2)) / (2 L)"
        ]
