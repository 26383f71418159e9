module Visibility.Complex.WalkSpec (spec) where

import Data.List (sort)
import Data.Maybe (isNothing, mapMaybe)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Complex (complexOf)
import Visibility.Complex.Locate
import Visibility.Complex.Type hiding (Kind)
import Visibility.Complex.Walk
import Visibility.Complex.Walk.Side
import Visibility.Exact.Point (Point (..))
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.FormFactor
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Sight
import Visibility.Sweep
import Visibility.Test.Generator
import Visibility.Test.Scan

spec :: Spec
spec = do
  describe "looking around" $ do
    modifyMaxSuccess (* 10) $ do
      it "from a point finds what an angular scan finds" $
        property $ \(AnyScene s) -> seesLikeScan (sampleScene s)
      it "from a point finds what an angular scan finds, where polygons touch" $
        property $ \(TouchingScene s) -> seesLikeScan (sampleScene s)
      it "from a point finds what an angular scan finds, in small scenes" $
        property $ \(SmallScene s) -> seesLikeScan (sampleScene s)
    modifyMaxSuccess (* 2) $ do
      it "from a point finds what an angular scan finds, in hard coordinates" $
        property $ \(HardScene s) -> seesLikeScan (sampleScene s)
      it "from all corners and the middles of all sides finds what an angular scan finds" $
        property $ \(SmallScene s) -> seesLikeScanFromAll (sampleScene s)
      it "from all corners and the middles of all sides finds what an angular scan finds, where polygons touch" $
        property $ \(TouchingScene s) -> seesLikeScanFromAll (sampleScene s)
      it "from a corner by name is the same as from its place; nothing, where it is all covered" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
              complex = complexOf scene
              fromName name point = lookAround complex (AtCorner name point)
           in conjoin
                [ counterexample (show name) $ case lookAround complex (AtPoint point) of
                    Left _ -> (cornersNamed scene name, fromName name point) === (Just [], Right (Look [] 0))
                    found -> fromName name point === found
                | (name, point) <- statedCorners scene
                ]
    it "in a room that is filled sees nothing, and tells what is in the way" $
      fmap
        (\s -> map (lookAround (complexOf (sampleScene s)) . AtPoint) [Point (1 / 2) (1 / 3), Point 0 0, Point 2 0])
        filled
        `shouldBe` Just [Left (Obstacle 0), Left (Obstacle 0), Left Enclosure]
    it "is tested from places of every kind" $
      checkCoverage $ \(AnyScene s) ->
        let scene = sampleScene s
            complex = complexOf scene
         in forAll (somePoint scene) $ \eye ->
              let kind = kindOf complex (snd (locate complex eye))
               in foldr (\k -> cover 1 (k == kind) (show k)) (property True) [minBound ..]
    it "makes the same visibility polygon as an angular scan" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
         in forAll (somePoint scene) $ \eye ->
              (region scene eye . lookSights <$> lookAround (complexOf scene) (AtPoint eye))
                === (region scene eye <$> scan scene eye)
    it "visits no more faces than there are corners to pass, twice" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
         in forAll (somePoint scene) $ \eye -> case lookAround (complexOf scene) (AtPoint eye) of
              Left _ -> property Discard
              Right found -> property (lookSteps found <= 2 * (cornerCount scene + 1))
  describe "what a side sees" $ do
    modifyMaxSuccess (* 3) $
      it "are the form factors that are added up along the sweep, exactly" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
              streamed = formFactors scene (measures scene (vertices scene))
              found = concat (mapMaybe (sees (complexOf scene)) (statedSides scene))
           in sort (map entry found) === sort (map entry streamed)
    it "is in order, the sky last, and adds up to the part of the side that is not covered" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            complex = complexOf scene
         in conjoin
              [ map factorTo seen === sort (map factorTo seen)
                  .&&. mconcat (map factorValue seen) === RootSum.rational (uncovered scene side)
              | side <- statedSides scene
              , Just seen <- [sees complex side]
              ]
  where
    filled = sample (RawScene Nothing (Just unit) [unit])
    unit = rawPolygon [Point 0 0, Point 1 0, Point 1 1, Point 0 1]
    entry f = (factorFrom f, factorTo f, factorMeasure f, factorValue f)

seesLikeScan :: Scene -> Property
seesLikeScan scene = forAll (vectorOf 5 (somePoint scene)) $ \eyes -> conjoin (map (sameFrom complex) eyes)
  where
    complex = complexOf scene

seesLikeScanFromAll :: Scene -> Property
seesLikeScanFromAll scene = conjoin (map (sameFrom (complexOf scene)) (pointsOfInterest scene))

-- | Where a point may lie.
data Kind = AtACorner | OnASide | OnAWall | InASolid | InTheFree | BesideAll
  deriving (Eq, Ord, Show, Enum, Bounded)

kindOf :: Complex -> Place -> Kind
kindOf complex place = case place of
  OnCorners _ -> AtACorner
  OnSides [_] -> OnASide
  OnSides _ -> OnAWall
  InSolid _ -> InASolid
  InFree (Start face _) -> if isNothing (faceFirst complex face) then BesideAll else InTheFree

-- | Is what is seen from a point the same as by scanning?
sameFrom :: Complex -> Point -> Property
sameFrom complex eye =
  counterexample (show eye) $
    (lookSights <$> lookAround complex (AtPoint eye)) === scan (complexScene complex) eye
