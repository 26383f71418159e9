module Visibility.RaySpec (spec) where

import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Complex.Law.Section (directionsFrom, isGeneric)
import Visibility.Exact.Point (Point (..), coordinates)
import Visibility.Exact.Predicate
import Visibility.Ray
import Visibility.Test.Ray
import Visibility.Scene
import Visibility.Scene.Cone
import Visibility.Scene.Raw
import Visibility.Test.Generator

spec :: Spec
spec = do
  describe "a ray" $
    modifyMaxSuccess (* 3) $ do
      it "meets the nearest of all sides, by fractions" $
        property $ \(AnyScene s) -> forAll (genericIn (sampleScene s)) $ \d ->
          let scene = sampleScene s
           in conjoin [shoot scene c way === nearest scene c way | c <- corners scene, way <- [d, reversed d]]
      it "is the same beyond machine integers" $
        property $ \(AnyScene s) -> forAll (genericIn (sampleScene s)) $ \d ->
          case sample (enlarged (sampleRaw s)) of
            Nothing -> counterexample "not valid" False
            Just hard ->
              conjoin
                [viewAt (sampleScene s) c d === viewAt (sampleScene hard) c d | c <- corners (sampleScene s)]
  describe "the solid at a corner" $
    it "has the next corner above or below as it has next to it" $
      property $ \(TouchingScene s) ->
        let scene = sampleScene s
         in conjoin
              [ nextFlank scene moment c d === nextFlank scene JustThen c (nudged signed d)
              | c <- corners scene
              , (moment, signed) <- [(JustBefore, negate), (JustAfter, id)]
              , d <- [heading scene c (nextCorner scene c), reversed (heading scene c (nextCorner scene c))]
              ]
  where
    -- A little to the left; less than lattice directions of a small extent differ.
    nudged signed (Direction x y) =
      let k = 10 ^ (12 :: Int) in Direction (k * x - signed y) (k * y + signed x)
    enlarged raw = raw {rawEnclosure = fmap bigger (rawEnclosure raw), rawPolygons = map bigger (rawPolygons raw)}
    bigger polygon = polygon {rawCorners = [Point (large * x) (large * y) | Point x y <- rawCorners polygon]}
    large = 2 ^ (40 :: Int)

-- | A direction parallel to no line through two corners.
genericIn :: Scene -> Gen Direction
genericIn scene = do
  seed <- arbitrary
  case filter (isGeneric scene) (directionsFrom [seed .. seed + 20]) of
    d : _ -> pure d
    [] -> discard

-- | What a ray meets, written from the definition in rationals: the first side that it crosses. If it crosses that
-- one from the solid to the free, it was in the solid all the way. A ray through another cone of free space in the same
-- place is solid for this corner.
nearest :: Scene -> CornerId -> Direction -> Hit
nearest scene c d@(Direction dx dy)
  | any isElsewhere (concat [group | group <- placeGroups scene, c `elem` group]) = Solid
  | null hits = case surroundings scene of OpenSky -> Meets Sky; Room -> Solid
  | otherwise = case [s | (t, s, True) <- hits, t == minimum [u | (u, _, _) <- hits]] of
      s : _ -> Meets (Side s)
      [] -> Solid
  where
    (cx, cy) = coordinates (cornerAt scene c)
    isElsewhere other = other /= c && isFree other
    -- Does the ray run counter-clockwise between the preceding side and the following one?
    isFree other
      | directionTurn from to == LeftTurn = leftOf from d && leftOf d to
      | directionTurn from to == RightTurn = leftOf from d || leftOf d to
      | otherwise = leftOf from d
      where
        from = heading scene other (previousCorner scene other)
        to = heading scene other (nextCorner scene other)
    leftOf a b = directionTurn a b == LeftTurn
    hits =
      [ (t, s, inward > 0)
      | s <- sides scene
      , sideStart s /= c
      , sideEnd scene s /= c
      , let (ax, ay) = coordinates (cornerAt scene (sideStart s))
      , let (bx, by) = coordinates (cornerAt scene (sideEnd scene s))
      , let (ex, ey) = (bx - ax, by - ay)
      , let inward = ex * fromInteger dy - ey * fromInteger dx
      , inward /= 0
      , let t = ((ax - cx) * ey - (ay - cy) * ex) / negate inward
      , let u = ((ax - cx) * fromInteger dy - (ay - cy) * fromInteger dx) / negate inward
      , t > 0
      , u > 0
      , u < 1
      ]
