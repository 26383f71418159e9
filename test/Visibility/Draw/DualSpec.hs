{-# LANGUAGE OverloadedStrings #-}

module Visibility.Draw.DualSpec (spec) where

import Control.Monad ((>=>))
import Data.Foldable (for_)
import Data.List (sort, sortBy, sortOn)
import Data.Maybe (mapMaybe)
import Data.Ratio ((%))
import qualified Data.Text as Text
import Test.Hspec
import Test.QuickCheck hiding (sample)
import Visibility.Draw.Checks
import Visibility.Draw.Drawing
import Visibility.Draw.Dual
import Visibility.Draw.Gallery
import Visibility.Draw.Scale
import Visibility.Exact.Point
import Visibility.Exact.Predicate (Direction (..), compareDirections)
import Visibility.Scene
import Visibility.Sweep
import Visibility.Test.Generator
import Visibility.View

spec :: Spec
spec = do
  describe "every scene in scenes/" $
    withGallery $ \name scene -> legible name (drawn scene)
  describe "of any scene" $ do
    it "has a dot for each vertex, and one more for each vertical one" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            isVertical v = case vertexDirection scene v of Direction dx _ -> dx == 0
            expected = concat [replicate (if isVertical v then 2 else 1) (names scene v) | v <- sort (vertices scene)]
         in map markName (marksIn "vertices" (drawn scene)) === expected
    it "has a curve for each edge and each buried stretch, by its kind" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            drawing = drawn scene
            named keep =
              [ Text.pack (cornerText (cornerName scene (edgeCorner e)))
              | e <- sortOn edgeCorner (stretches scene (events scene (vertices scene)))
              , keep (edgeView e)
              ]
            isTangent' view = case view of Tangent {} -> True; _ -> False
            isEnding view = case view of Ending _ _ -> True; _ -> False
         in conjoin
              [ map markName (marksIn "ending" drawing) === named isEnding
              , map markName (marksIn "tangent" drawing) === named isTangent'
              , map markName (marksIn "buried" drawing) === named isBuried
              ]
    it "is the same whatever the order of the stream" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            byDirection v w = compareDirections (vertexDirection scene v) (vertexDirection scene w)
         in dualDrawing scene (events scene (sortBy byDirection (vertices scene))) === drawn scene
    it "has curves that satisfy u = -x sin θ + y cos θ, and run from left to right" $
      property $ \(AnyScene s) -> followsItsEquation (sampleScene s)
    it "has curves that satisfy it also far from the origin" $
      property $ \(AnyScene s) ->
        either
          (\problems -> counterexample (show problems) False)
          followsItsEquation
          (displaced (10 ^ (60 :: Int) + 1 / 7) (sampleRaw s))
    it "has its dots on the curves of all corners of the vertex" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            frame = frameFor scene (events scene (vertices scene))
         in conjoin
              [ counterexample (show (mark, c)) (abs (u - curve scene frame c theta) < 1e-9)
              | let drawing = drawn scene
              , mark <- marksIn "vertices" drawing
              , Dot place <- [markShape mark]
              , let (theta, u) = offCanvas drawing frame place
              , c <- namedCorners scene (markName mark)
              ]
    it "no label covers anything, and nothing leaves the canvas" $
      property $ \(AnyScene s) ->
        isLegible (drawn (sampleScene s))
  describe "the ticks" $ do
    it "are at the values that they state" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            frame = frameFor scene (events scene (vertices scene))
            drawing = drawn scene
            stated = [text | Mark _ TickLabel (Label EndAnchor _ text) <- marksIn "frame" drawing]
            ys = [y | Mark _ Tick (Polyline [Place _ y, Place _ y']) <- marksIn "frame" drawing, y == y']
         in length stated >= 3 .&&. stated === mapMaybe (\y -> nearestTick drawing frame y stated) ys
    it "of a distant scene count from a point in it, which is named" $ do
      case displaced (10 ^ (40 :: Int)) (snd (head' goldenScenes)) of
        Left problems -> expectationFailure (show problems)
        Right scene -> do
          let frame = frameFor scene (events scene (vertices scene))
              Point x y = frameOrigin frame
          (abs (x - 10 ^ (40 :: Int)) <= 10, abs (y - 10 ^ (40 :: Int)) <= 10) `shouldBe` (True, True)
          (x, y) `shouldNotBe` (0, 0)
          let captions = [text | Mark _ Caption (Label _ _ text) <- marksIn "legend" (drawn scene)]
          captions `shouldSatisfy` any (Text.isInfixOf ("u measured from (" <> decimalText x))
  describe "golden drawings" $
    for_ goldenScenes $ \(name, raw) ->
      it name $ withValid raw $ \scene -> drawn scene `shouldBeListedIn` (name <> "-dual.txt")
  where
    drawn scene = dualDrawing scene (events scene (vertices scene))
    names scene v = Text.unwords [Text.pack (cornerText (cornerName scene c)) | c <- vertexCorners v]
    namedCorners scene text =
      concat (mapMaybe (readCornerName . Text.unpack >=> cornersNamed scene) (Text.words text))
    followsItsEquation scene =
      conjoin
        [ counterexample (show mark) $
          and [abs (u - curve scene frame c theta) < 1e-9 | (theta, u) <- points, c <- owners]
            && length (filter (any (`elem` owners)) (placeGroups scene)) == 1
            && and (zipWith (<=) (map fst points) (drop 1 (map fst points)))
        | layer <- ["ending", "tangent"]
        , mark@(Mark _ _ (Polyline places)) <- marksIn layer drawing
        , let points = map (offCanvas drawing frame) places
        , let owners = namedCorners scene (markName mark)
        ]
      where
        drawing = drawn scene
        frame = frameFor scene (events scene (vertices scene))
    -- From the file's coordinates, exactly but for the last steps.
    curve scene frame c theta = near (y - oy) * cos theta - near (x - ox) * sin theta
      where
        Point x y = cornerPoint scene c
        Point ox oy = frameOrigin frame
        near v = fromRational (v / frameUnit frame) :: Double
    -- The statement among those given that belongs to a height on the canvas.
    nearestTick drawing frame y texts =
      let (_, u) = offCanvas drawing frame (Place 100 y)
       in case [text | text <- texts, Just v <- [readDecimal (Text.unpack text)], isAt u (v / frameUnit frame)] of
            [text] -> Just text
            _ -> Nothing
    isAt u v = abs (v - toRational u) < 1e-9
    head' = foldr const (error "no golden scenes")

-- | Reads finite decimals as the figure writes them.
readDecimal :: String -> Maybe Rational
readDecimal ('−' : digits) = negate <$> readDecimal digits
readDecimal text = case break (== 'e') text of
  (mantissa, "") -> unsigned mantissa
  (mantissa, _ : '−' : power) -> (\m k -> m / 10 ^ k) <$> unsigned mantissa <*> natural power
  (mantissa, _ : power) -> (\m k -> m * 10 ^ k) <$> unsigned mantissa <*> natural power
  where
    unsigned digits = case break (== '.') digits of
      (whole, "") -> fromInteger <$> natural whole
      (whole, _ : part) -> (\n -> n % (10 ^ length part)) <$> natural (whole <> part)
    natural digits
      | not (null digits), all (`elem` ['0' .. '9']) digits = Just (read digits :: Integer)
      | otherwise = Nothing

-- | (θ, u) of a place in the drawing: undoes 'onCanvas', up to rounding. A drawing with a longer caption is higher, and
-- all else stands higher in it by as much.
offCanvas :: Drawing -> Frame -> Place -> (Double, Double)
offCanvas drawing frame (Place x y) = ((x - x0) / (x1 - x0), (y - lift - y0) / (y1 - y0))
  where
    lift = drawingHeight drawing - 580
    (Place x0 y0, Place x1 y1) = (onCanvas frame (0, 0), onCanvas frame (1, 1))
