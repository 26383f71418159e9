-- | Scenes at the ends of what coordinates can be: huge and tiny ones together, long denominators, near-collinearities,
-- slits. What is exact does not depend on size.
module Visibility.ExtremeSpec (spec) where

import Control.Exception (evaluate)
import Control.Monad (forM_)
import Data.ByteString.Builder (toLazyByteString)
import qualified Data.ByteString.Lazy as Lazy
import Data.List (nub, sort)
import qualified Data.Map.Strict as Map
import Data.Ratio ((%))
import Numeric (readFloat, readSigned)
import System.Timeout (timeout)
import Test.Hspec
import Visibility.Complex (complexOf)
import Visibility.Complex.Law (violations)
import Visibility.Exact.Bisection (bisected)
import Visibility.Exact.Point
import Visibility.Exact.RootSum
import Visibility.Exact.Rounding
import Visibility.FormFactor
import Visibility.Format.Json (readScene, sceneDocument)
import Visibility.Law (Violation (..))
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Scene.Validate (validate)
import Visibility.Sweep
import Visibility.Test.BruteForce (bruteForce)
import Visibility.Test.Metamorphic

spec :: Spec
spec = do
  describe "an extreme scene" $
    forM_ extremeScenes $ \(name, raw) -> describe name $ do
      it "is valid, and beyond machine integers" $
        case pointsKernel . scenePoints <$> validate raw of
          Right (FilterKernel _) -> pure ()
          Right _ -> expectationFailure "no filter is needed"
          Left problems -> expectationFailure (show problems)
      it "is written to a file and read again as it is" $
        readScene "" (Lazy.toStrict (toLazyByteString (sceneDocument raw))) `shouldBe` Right raw
      it "has the vertices of brute force, by either sweep and under every exact arithmetic" $
        onScene raw $ \scene -> do
          let found = bruteForce scene
          [ (arithmetic, scheduler)
            | arithmetic <- [Filtered, Exact]
            , scheduler <- [Topological, Straight]
            , sort (verticesBy scheduler (underArithmetic arithmetic scene)) /= found
            ]
            `shouldBe` []
          vertices (underArithmetic Exact scene) `shouldBe` vertices (underArithmetic Filtered scene)
      it "closes exactly" $
        onScene raw $ \scene -> do
          let defects = closureDefect scene (measuresIn scene)
          length defects `shouldBe` cornerCount scene
          [sideText side | (side, defect) <- defects, sign defect /= Zero] `shouldBe` []
      it "has the same measures under every exact arithmetic, and all are positive" $
        onScene raw $ \scene -> do
          let under arithmetic = measureList scene (measuresIn (underArithmetic arithmetic scene))
              spelt = map (fmap terms) . under
          spelt Exact `shouldBe` spelt Filtered
          [objects | (objects, area) <- under Filtered, sign area /= Positive] `shouldBe` []
      it "has a complex that obeys every law" $
        onScene raw $ \scene -> map violatedLaw (violations (complexOf scene)) `shouldBe` []
      it "has form factors that are printed in no time" $
        onScene raw $ \scene ->
          timeout 10000000 (evaluate (sum (map length (printed 40 scene)))) >>= (`shouldSatisfy` maybe False (> 0))
      it "has the Doubles nearest to its form factors" $
        onScene raw $ \scene -> doublesOf scene `shouldBe` roundedOf scene
  describe "an ordinary scene" $ do
    forM_ similarities $ \(name, map') ->
      it ("keeps its graph and its form factors, exactly and to the last digit, " <> name) $
        onScene ordinary $ \plain -> onScene (onPoints map' ordinary) $ \scene -> do
          graphOf scene `shouldBe` graphOf plain
          factorsOf scene `shouldBe` factorsOf plain
          printed 30 scene `shouldBe` printed 30 plain
          Map.size (factorsOf plain) `shouldSatisfy` (> 20)
    forM_ affinities $ \(name, map') ->
      it ("keeps its graph " <> name) $
        onScene ordinary $ \plain -> onScene (onPoints map' ordinary) $ \scene ->
          graphOf scene `shouldBe` graphOf plain
  describe "a form factor" $ do
    forM_ [1, 30, 300] $ \k ->
      it ("through a slit of relative width 1e-" <> show k <> " is positive and printed correctly rounded") $
        onScene (slit (tiny k)) $ \scene ->
          -- All lines from the slit to the wall behind it come from the wall in front.
          factorBetween scene 0 3 `isPrintedAs` throughSlit (tiny k)
    it "through a slit is nearly the width times 0.3 / √13, the less the narrower" $
      [onFactor (slit (tiny k)) 0 3 (decimal' 9) | k <- [40, 80, 300]]
        `shouldBe` [Just ("8.32050294e-" <> show (k + 2 :: Int)) | k <- [40, 80, 300]]
    forM_ [1, 30, 300] $ \k ->
      it ("of a wall as small as 1e-" <> show k <> " seen from a large one is positive and printed correctly rounded") $
        onScene (facing (tiny k)) $ \scene -> do
          factorBetween scene 0 1 `isPrintedAs` hottel 1 (facingStrings (tiny k))
          factorBetween scene 1 0 `isPrintedAs` hottel (tiny k) (facingStrings (tiny k))
    forM_ [300, 308, 310, 320, 323, 324, 330, 500] $ \k ->
      it ("of about 1e-" <> show k <> " is the nearest Double, if that is subnormal or 0, and is listed") $ do
        onScene (facing (tiny k)) $ \scene ->
          nearestBetween scene 0 1 `shouldBe` rounded (hottel 1 (facingStrings (tiny k)))
        onScene (slit (tiny k)) $ \scene ->
          nearestBetween scene 0 3 `shouldBe` rounded (throughSlit (tiny k))
    it "is subnormal at about 1e-310, and 0 at about 1e-330" $
      onScene (slit (tiny 310)) $ \wider -> onScene (slit (tiny 330)) $ \narrower -> do
        map (\x -> (x > 0, isDenormalized x)) (nearestBetween wider 0 3) `shouldBe` [(True, True)]
        nearestBetween narrower 0 3 `shouldBe` [0]
    it "between walls 1e300 times as long and 1e300 times as far is that between the walls" $
      onFactor (onPoints (scaledTo huge huge) (facing (1 / 3))) 0 1 (decimal' 50)
        `shouldBe` onFactor (facing (1 / 3)) 0 1 (decimal' 50)
  where
    measuresIn scene = measures scene (vertices scene)
    -- One Double, if both ends of an enclosure are rounded to it.
    rounded (low, high) = nub [fromRational low, fromRational high]
    printed n scene = [maybe "" (`decimal` f) (digits n) | f <- Map.elems (factorsOf scene)]

decimal' :: Int -> RootSum -> String
decimal' n f = maybe "" (`decimal` f) (digits n)

onScene :: RawScene -> (Scene -> Expectation) -> Expectation
onScene raw act = either (expectationFailure . ("not valid: " <>) . show) act (validate raw)

onFactor :: RawScene -> Int -> Int -> (RootSum -> a) -> Maybe a
onFactor raw from to act = case validate raw of
  Right scene -> act <$> factorBetween scene from to
  Left _ -> Nothing

-- | The form factor from one polygon to another, of which one side each sees the other.
factorBetween :: Scene -> Int -> Int -> Maybe RootSum
factorBetween scene from to =
  case [f | ((SideName p _, Just (SideName q _)), f) <- Map.toList (factorsOf scene), (p, q) == wanted] of
    [f] -> Just f
    _ -> Nothing
  where
    wanted = (Obstacle from, Obstacle to)

-- | The Doubles that stand for the form factors from one polygon to another.
nearestBetween :: Scene -> Int -> Int -> [Double]
nearestBetween scene from to =
  [x | (SideName p _, TheSide (SideName q _), x) <- doublesOf scene, (p, q) == (Obstacle from, Obstacle to)]

-- | Is a number positive, and every decimal of it within half a unit of its last digit of both ends of an enclosure
-- that was found in another way?
isPrintedAs :: Maybe RootSum -> (Rational, Rational) -> Expectation
isPrintedAs factor (low, high) = do
  low `shouldSatisfy` (> 0)
  fmap sign factor `shouldBe` Just Positive
  [ (n, text)
    | n <- [1, 2, 5, 17, 40, 100]
    , text <- maybe [""] (\f -> [decimal' n f]) factor
    , not (any (nearest n) (spelt text))
    ]
    `shouldBe` []
  where
    spelt text = [q | (q, "") <- readSigned readFloat text]
    nearest n q =
      let half = 10 ^^ (exponentOf q + 1 - n) / 2 in q - half <= low && high <= q + half
    -- The e with 10ᵉ ≤ q < 10ᵉ⁺¹.
    exponentOf q = go (0 :: Int)
      where
        go e
          | 10 ^^ e > q = go (e - 1)
          | 10 ^^ (e + 1) <= q = go (e + 1)
          | otherwise = e

-- Scenes -----------------------------------------------------------------------------------------------------------

huge :: Rational
huge = 10 ^ (300 :: Int)

tiny :: Int -> Rational
tiny k = 1 / 10 ^ k

-- | The least prime of 300 digits.
longPrime :: Integer
longPrime = 10 ^ (299 :: Int) + 669

scene' :: [[(Rational, Rational)]] -> RawScene
scene' loops = RawScene Nothing Nothing (map (rawPolygon . map (uncurry Point)) loops)

onPoints :: (Point -> Point) -> RawScene -> RawScene
onPoints f raw =
  raw {rawEnclosure = moved <$> rawEnclosure raw, rawPolygons = map moved (rawPolygons raw)}
  where
    moved p = p {rawCorners = map f (rawCorners p)}

scaledTo :: Rational -> Rational -> Point -> Point
scaledTo a b (Point x y) = Point (a * x) (b * y)

-- | Ten corners; some are on a line, and sides are parallel.
ordinary :: RawScene
ordinary = scene' [[(0, 0), (2, 0), (1, 2)], [(4, 1), (6, 2), (5, 4), (3, 3)], [(2, 5), (4, 6), (1, 8)]]

similarities :: [(String, Point -> Point)]
similarities =
  [ ("1e300 times as large", scaledTo huge huge)
  , ("1e-300 times as large", scaledTo (1 / huge) (1 / huge))
  , ("divided by a prime of 300 digits", scaledTo (1 % longPrime) (1 % longPrime))
  , ("1e300 away from the origin", \(Point x y) -> Point (x - huge) (y + huge))
  , ("turned by 3, 4, 5 and divided", \(Point x y) -> scaledTo part part (Point (3 * x - 4 * y) (4 * x + 3 * y)))
  ]
  where
    part = 1 % (5 * longPrime)

affinities :: [(String, Point -> Point)]
affinities =
  [ ("stretched by 1e300 in x and shrunk by 1e-300 in y", scaledTo huge (1 / huge))
  , ("sheared by 1e300", \(Point x y) -> Point (x + huge * y) y)
  , ("divided by long numbers, one for x and one for y", scaledTo (1 % longPrime) (1 % (longPrime + 2)))
  ]

extremeScenes :: [(String, RawScene)]
extremeScenes =
  [ ("1e300 times as large as an ordinary one", onPoints (scaledTo huge huge) ordinary)
  , ("1e300 times as long and 1e-300 times as high", onPoints (scaledTo huge (1 / huge)) ordinary)
  , ("sheared by 1e300", onPoints (\(Point x y) -> Point (x + huge * y) y) ordinary)
  ,
    ( "of corners 1e-300 and 1e300 from each other"
    , scene'
        [ [(0, 0), (2 / huge, 0), (1 / huge, 2 / huge)]
        , [(3, 1), (4, 1), (4, 5)]
        , [(huge, huge), (2 * huge, huge + 1 / huge), (huge, 2 * huge), (huge - 1 / huge, huge + 1 / huge)]
        ]
    )
  ,
    ( "in a room 1e300 large with things 1e-300 small"
    , (scene' [[(0, 0), (1 / huge, 0), (0, 1 / huge)], [(2, 0), (huge / 2, 0)], [(-3 / huge, 0), (-2 / huge, 1)]])
        { rawEnclosure =
            Just (rawPolygon [Point (-huge) (-huge), Point huge (-huge), Point huge huge, Point (-huge) (huge / 3)])
        }
    )
  , ("of many denominators of 300 digits", longDenominators ordinary)
  , ("of collinear corners moved by 2^-200 or not", nearlyInLine (1 / 2 ^ (200 :: Int)))
  , ("of collinear corners moved by 2^-1100 or not, which no Double sees", nearlyInLine (1 / 2 ^ (1100 :: Int)))
  , ("with a slit of relative width 1e-30", slit (tiny 30))
  , ("with a slit of relative width 1e-300", slit (tiny 300))
  ]

-- | Adds to each coordinate less than 10⁻², over a denominator of 300 digits of its own.
longDenominators :: RawScene -> RawScene
longDenominators raw = raw {rawPolygons = zipWith polygon [0 ..] (rawPolygons raw)}
  where
    polygon i p = p {rawCorners = zipWith (corner . (+ 20 * i)) [0 ..] (rawCorners p)}
    corner k (Point x y) = Point (x + shift (4 * k)) (y + shift (4 * k + 2))
    shift k = (longPrime `div` (100 + k)) % (longPrime + k)

-- | Corners of five triangles on or beside one line by a little, on both flanks; its slope is 1/3.
nearlyInLine :: Rational -> RawScene
nearlyInLine little =
  scene'
    [ [(0, 0), (1, -1), (2, 2 / 3 + little)]
    , [(3, 1 - little), (5, 5 / 3), (4, 2)]
    , [(6, 2 + little), (7, -1), (9, 3)]
    , [(10, 10 / 3), (11, 11 / 3 - little), (11, 5)]
    , [(12, 4), (13, 13 / 3)]
    ]

-- | A wall of length 10 at x = 0, a slit at x = 1 in the middle, a wall of length 6 at x = 3.
slit :: Rational -> RawScene
slit width =
  scene' [[(0, 0), (0, 10)], [(1, -90), (1, 5 - width / 2)], [(1, 5 + width / 2), (1, 90)], [(3, 2), (3, 8)]]

-- | Two parallel walls a unit apart, of length 1 and of this length, and a third one far away.
facing :: Rational -> RawScene
facing size = scene' [[(0, 0), (1, 0)], [(0, 1), (size, 1)], [(huge, huge), (huge, huge + 1)]]

-- Enclosures, in another way ------------------------------------------------------------------------------------------

-- | A length between two points, taken once or taken away.
data StringPart = Crossed Point Point | Uncrossed Point Point

facingStrings :: Rational -> [StringPart]
facingStrings size =
  [ Crossed (Point 0 0) (Point size 1)
  , Crossed (Point 1 0) (Point 0 1)
  , Uncrossed (Point 0 0) (Point 0 1)
  , Uncrossed (Point 1 0) (Point size 1)
  ]

throughSlit :: Rational -> (Rational, Rational)
throughSlit width =
  hottel
    10
    [ Crossed (Point 1 (5 - width / 2)) (Point 3 8)
    , Crossed (Point 1 (5 + width / 2)) (Point 3 2)
    , Uncrossed (Point 1 (5 - width / 2)) (Point 3 2)
    , Uncrossed (Point 1 (5 + width / 2)) (Point 3 8)
    ]

-- | An enclosure of half the crossed strings less the uncrossed ones, by a length: Hottel's rule.
hottel :: Rational -> [StringPart] -> (Rational, Rational)
hottel size parts = (sum (map fst bounds) / (2 * size), sum (map snd bounds) / (2 * size))
  where
    bounds = map bound parts
    bound (Crossed p q) = apart p q
    bound (Uncrossed p q) = let (low, high) = apart p q in (negate high, negate low)
    apart (Point ax ay) (Point bx by) = enclosedRoot ((bx - ax) * (bx - ax) + (by - ay) * (by - ay))

-- | The root of a rational in an interval of 10⁻⁸⁰⁰.
enclosedRoot :: Rational -> (Rational, Rational)
enclosedRoot q = (fromInteger r / unit, fromInteger (r + 1) / unit)
  where
    unit = 10 ^ (800 :: Int)
    n = floor (q * unit * unit) :: Integer
    r = bisected n
