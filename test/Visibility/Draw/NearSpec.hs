module Visibility.Draw.NearSpec (spec) where

import Test.Hspec
import Test.QuickCheck
import Visibility.Draw.Band
import Visibility.Draw.Drawing

spec :: Spec
spec = describe "what is near" $ do
  it "is all that has a place nearer than the reach, by places along both segments" $
    forAll scattered $ \(reach, one, segments) ->
      let found = nearTo reach segments one
          missing =
            [ (k, s)
            | (k, s) <- zip [0 ..] segments
            , k `notElem` found
            , or [long p q < reach | p <- along one, q <- along s]
            ]
       in cover 50 (length found < length segments) "some are not" $ missing === []
  it "is told in order, each once" $
    forAll scattered $ \(reach, one, segments) ->
      let found = nearTo reach segments one
       in found === [k | k <- [0 .. length segments - 1], k `elem` found]
  it "is nothing that is further than three squares in both coordinates" $
    forAll scattered $ \(reach, one, segments) ->
      let found = nearTo reach segments one
          far (Place x y, Place x' y') (Place a b, Place a' b') =
            min x x' > max a a' + 3 * reach || min a a' > max x x' + 3 * reach
              || min y y' > max b b' + 3 * reach
              || min b b' > max y y' + 3 * reach
       in [k | k <- found, far one (segments !! k)] === []
  where
    along (Place x y, Place x' y') =
      [Place (x + t * (x' - x)) (y + t * (y' - y)) | k <- [0 .. 20 :: Int], let t = fromIntegral k / 20]
    long (Place x y) (Place x' y') = sqrt ((x' - x) * (x' - x) + (y' - y) * (y' - y))
    scattered = (,,) <$> choose (1, 40) <*> segment <*> listOf segment
    -- Long and short ones, upright ones, points.
    segment = do
      Place x y <- Place <$> coordinate <*> coordinate
      to <-
        oneof
          [Place <$> coordinate <*> coordinate, Place x <$> coordinate, pure (Place x y), Place <$> step x <*> step y]
      pure (Place x y, to)
    coordinate = oneof [choose (0, 200), fromIntegral <$> choose (0, 20 :: Int)] :: Gen Double
    step v = (v +) <$> choose (-5, 5)
