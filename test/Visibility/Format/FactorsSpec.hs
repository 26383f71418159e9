{-# LANGUAGE OverloadedStrings #-}

module Visibility.Format.FactorsSpec (spec) where

import qualified Data.Aeson as Aeson
import Data.Aeson.Types (parseMaybe)
import Data.ByteString.Builder (Builder, string7, toLazyByteString)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Char (isDigit)
import Data.Foldable (for_)
import Data.List (isPrefixOf)
import Data.Maybe (fromMaybe)
import Data.Ratio ((%))
import Numeric (readFloat)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Point (Point (..))
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Exact.Rounding
import Visibility.FormFactor
import Visibility.Format.Factors
import Visibility.Scene
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
    DecimalsOnly -> decimalDocument format fourDigits sideBuilder scene (decimalFactors fourDigits scene sums)
    WithExactMeasures -> exactly format sideBuilder scene
  where
    sums = measures scene (vertices scene)

exactly :: FactorFormat -> Naming -> Scene -> Builder
exactly format naming scene =
  exactDocument format fourDigits naming scene (exactFactors fourDigits scene (measures scene (vertices scene)))

fourDigits :: Digits
fourDigits = fromMaybe defaultDigits (digits 4)

doubles :: FactorFormat -> Scene -> String
doubles format scene =
  Lazy.unpack . toLazyByteString $
    nearestDocument format sideBuilder scene (nearestFactors scene (measures scene (vertices scene)))

-- | The lengths that a JSON document tells, as text and as numbers, with the number of its sides.
lengthsIn :: String -> Maybe (Int, [(String, Rational)])
lengthsIn text = do
  document' <- Aeson.decode (Lazy.pack text)
  stated <- parseMaybe (Aeson.withObject "document" (Aeson..: "sides")) document'
  found <- traverse (parseMaybe (Aeson.withObject "side" (Aeson..: "length"))) (stated :: [Aeson.Value])
  pure (length stated, [(word, q) | word <- found, (q, "") <- readFloat word])

-- | Names of sides, and how a document is told of them.
data Named = Named String (SideName -> String) Naming

instance Show Named where
  show (Named text _ _) = text

someNames :: Gen Named
someNames = elements [Named "own names" sideText sideBuilder, Named "long names" long (string7 . long)]
  where
    long s = sideText s <> "#an-element"

-- | The terms of a sum as people read it.
readTerms :: String -> [(Rational, Integer)]
readTerms text = case words text of
  ('-' : first) : others -> term (-1) first : following others
  first : others -> term 1 first : following others
  [] -> []
  where
    following (sign : word : others) = term (if sign == "-" then -1 else 1) word : following others
    following _ = []
    term sign word = case break (== '*') word of
      (c, '*' : n) -> (sign * rationalIn c, radicand n)
      (c, _) | "sqrt" `isPrefixOf` c -> (sign, radicand c)
      (c, _) -> (sign * rationalIn c, 1)
    radicand = read . filter isDigit
    rationalIn c = case break (== '/') c of
      (p, '/' : q) -> read p % read q
      (p, _) -> read p % 1

spec :: Spec
spec = do
  documents
  exactDocuments
  nearest

exactDocuments :: Spec
exactDocuments = describe "exactDocument" . modifyMaxSuccess (`div` 2) $ do
  it "has a line of CSV for each factor, with terms that are read back" $
    forAllNamed $ \name naming scene ->
      let (header, rows) = splitAt 1 (map (parted ',') (lines (Lazy.unpack (toLazyByteString (exactly FactorsCsv naming scene)))))
       in (header === [["from", "to", "value", "measure"]])
            .&&. (map (take 3) rows === [[name from, toText name to, value] | (from, to, value, _) <- factorsIn scene])
            .&&. (map (map readTerms . drop 3) rows === [[found] | (_, _, _, found) <- factorsIn scene])
  it "tells in JSON what there is to tell, the measure as a list of terms" $
    forAllNamed $ \name naming scene ->
      Aeson.decode (toLazyByteString (exactly FactorsJson naming scene))
        === Just
          ( Aeson.object
              [ "format" Aeson..= ("viscomplex/1" :: String)
              , "sides"
                  Aeson..= [ Aeson.object $
                              ["id" Aeson..= name s, "length" Aeson..= decimal fourDigits (sideLength scene s)]
                                <> ["uncovered" Aeson..= rationalText part | part <- covered scene s]
                           | s <- statedSides scene
                           ]
              , "factors"
                  Aeson..= [ Aeson.object
                              [ "from" Aeson..= name from
                              , "to" Aeson..= toText name to
                              , "value" Aeson..= value
                              , "measure" Aeson..= [[rationalText c, show n] | (c, n) <- found]
                              ]
                           | (from, to, value, found) <- factorsIn scene
                           ]
              ]
          )
  it "tells the same as text, a block for each side" $
    forAllNamed $ \name naming scene ->
      map asRead (lines (Lazy.unpack (toLazyByteString (exactly FactorsText naming scene))))
        === concat
          [ ( ["side", name s <> ",", "length", decimal fourDigits (sideLength scene s) <> ","]
                <> concat [[rationalText part, "of", "it", "uncovered,"] | part <- covered scene s]
                <> ["sees"]
            , []
            )
            : [([toText name to, value], found) | (from, to, value, found) <- factorsIn scene, from == s]
          | s <- statedSides scene
          ]
  it "writes no factor 1 and no root of 1, and an empty sum as 0" $
    for_
      [ ([], "0")
      , ([(1, 1)], "1")
      , ([(-1, 1), (1, 2), (-1, 3)], "-1 + sqrt(2) - sqrt(3)")
      , ([(-1, 2)], "-sqrt(2)")
      , ([(-1 / 2, 5), (3, 7)], "-1/2*sqrt(5) + 3*sqrt(7)")
      ]
      $ \(found, text) -> do
        scene <- maybe (fail "no scene") pure pair
        made <- maybe (fail "no sum") pure (RootSum.fromTerms found)
        let row = FactorRow (SideName (Obstacle 0) 0) [(TheSky, ("0.5", made))] 0
        Lazy.unpack (toLazyByteString (exactDocument FactorsCsv fourDigits sideBuilder scene [row]))
          `shouldBe` "from,to,value,measure\n0.0,sky,0.5," <> text <> "\n"
  where
    forAllNamed :: ((SideName -> String) -> Naming -> Scene -> Property) -> Property
    forAllNamed check =
      property $ \(AnyScene s) -> forAll someNames $ \(Named _ name naming) -> check name naming (sampleScene s)
    factorsIn scene =
      [ (factorFrom f, factorTo f, decimal fourDigits (factorValue f), RootSum.terms (factorMeasure f))
      | f <- formFactors scene (measures scene (vertices scene))
      ]
    toText name to = case to of
      TheSide s -> name s
      TheSky -> "sky"
    covered scene s = [part | let part = uncovered scene s, part /= 1]
    parted mark text = case break (== mark) text of
      (first, _ : others) -> first : parted mark others
      (first, []) -> [first]
    -- The words of a line up to a sum, and its terms.
    asRead line = case break (== '(') line of
      (names, '(' : sums) -> (takeWhile (/= "=") (words names), readTerms (unbracketed sums))
      (names, _) -> (words names, [])
    -- A sum has brackets of its own.
    unbracketed sums = take (length sums - length (") / (2 L)" :: String)) sums

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
