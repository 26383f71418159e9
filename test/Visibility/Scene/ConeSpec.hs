module Visibility.Scene.ConeSpec (spec) where

import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Scene.Cone
import Visibility.Test.Generator

spec :: Spec
spec = do
  describe "the solid at a corner" $ do
    it "is entered just before and just after a direction as it is next to it" $
      property $ \(LatticeScene s) -> entersAsNextToIt (sampleScene s)
    it "is entered just before and just after a direction as it is next to it, where polygons touch" $
      property $ \(TouchingScene s) -> entersAsNextToIt (sampleScene s)
    modifyMaxSuccess (* 3) $
      it "is the meeting of two half planes, or their union, or one of them; a free end of a wall has none" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
           in forAll (vectorOf 5 direction') $ \ds ->
                conjoin
                  [ counterexample (show (c, d)) $ entersSolid scene JustThen c d === byHalfPlanes scene c d
                  | c <- corners scene
                  , d <- ds <> [heading scene c q | q <- corners scene, not (samePlace scene c q)]
                  ]
  describe "a heading" $
    it "leads from one corner to another, and back the other way" $
      property $ \(TouchingScene s) ->
        let scene = sampleScene s
         in conjoin
              [ (heading scene q p === reversed (heading scene p q))
                  .&&. sameWay (heading scene p q) (heading scene p q)
                  .&&. not (sameWay (heading scene p q) (heading scene q p))
              | p <- corners scene
              , q <- corners scene
              , not (samePlace scene p q)
              ]
  where
    direction' = suchThat (Direction <$> choose (-99, 99) <*> choose (-99, 99)) (/= Direction 0 0)

entersAsNextToIt :: Scene -> Property
entersAsNextToIt scene =
  conjoin
    [ counterexample (show (c, side)) $ entersSolid scene moment c d === entersSolid scene JustThen c (nudged signed d)
    | c <- corners scene
    , side <- [nextCorner scene c, previousCorner scene c]
    , (moment, signed) <- [(JustBefore, negate), (JustAfter, id)]
    , d <- [heading scene c side, reversed (heading scene c side)]
    ]
  where
    -- A little to the left; less than lattice directions of a small extent differ.
    nudged signed (Direction x y) =
      let k = 10 ^ (12 :: Int) in Direction (k * x - signed y) (k * y + signed x)

-- | The solid lies to the left of the sides that arrive at a corner and leave it; it is open.
byHalfPlanes :: Scene -> CornerId -> Direction -> Bool
byHalfPlanes scene c d = case (directionTurn arriving leaving, sameWay arriving leaving) of
  (LeftTurn, _) -> leftOf arriving && leftOf leaving
  (RightTurn, _) -> not (rightOrAlong arriving && rightOrAlong leaving)
  (Collinear, True) -> leftOf leaving
  (Collinear, False) -> False
  where
    arriving = heading scene (previousCorner scene c) c
    leaving = heading scene c (nextCorner scene c)
    leftOf side = directionTurn side d == LeftTurn
    rightOrAlong side = directionTurn side d /= LeftTurn
