module Visibility.Draw.OutlineSpec (spec) where

import Test.Hspec
import Test.QuickCheck hiding (sample)
import Visibility.Draw.Drawing hiding (Region)
import Visibility.Draw.Gallery
import Visibility.Draw.Outline
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Sight
import Visibility.Test.Generator

spec :: Spec
spec = do
  describe "inFront" $ do
    it "cuts a sight that reaches behind, in two where it goes all around" $ do
      let wholeSky d = [Sight d d Sky]
          ahead = [Sight (Direction 0 (-1)) (Direction 0 1) Sky]
      map joined (inFront (Direction 1 0) (wholeSky (Direction (-1) 0))) `shouldBe` [ahead]
      map joined (inFront (Direction 1 0) (wholeSky (Direction 1 0))) `shouldBe` [ahead]
      inFront (Direction 1 0) [Sight (Direction 1 1) (Direction 1 (-1)) Sky]
        `shouldBe` [ [Sight (Direction 0 (-1)) (Direction 1 (-1)) Sky]
                   , [Sight (Direction 1 1) (Direction 0 1) Sky]
                   ]
    it "keeps nothing from behind and all that counts for form factors" $
      property $ \(AnyScene s) (Normal normal) ->
        forAllViewpoints (sampleScene s) $ \_ sights ->
          let scene = sampleScene s
              front = concat (inFront normal sights)
           in conjoin
                [ counterexample (show front) (and [turnsLeft normal from /= Behind | Sight from _ _ <- front])
                , elementFactors scene normal front === elementFactors scene normal sights
                ]
  describe "sightLimits" $
    it "are all on lines through the viewpoint, two at each unbounded part" $
      property $ \(AnyScene s) ->
        forAllViewpoints (sampleScene s) $ \q sights ->
          let found = sightLimits q (bends (sampleScene s) q sights)
              unbounded = [part | part@(from, to) <- regionUnbounded (region (sampleScene s) q sights), from /= to]
           in conjoin
                [ length [() | (Here _, Beyond _ _) <- found] === length unbounded
                , length [() | (Beyond _ _, Here _) <- found] === length unbounded
                , [(a, b) | (Here a, Here b) <- found, slope q a /= slope q b, q `notElem` [a, b]] === []
                ]
  describe "outlinePlaces" $ do
    it "holds exactly the places that are seen" $
      property $ \(AnyScene s) ->
        forAllViewpoints (sampleScene s) $ \q sights -> holdsWhatIsSeen (sampleScene s) q [sights]
    it "holds exactly the places that are seen in front of a normal" $
      property $ \(AnyScene s) (Normal normal) ->
        forAllViewpoints (sampleScene s) $ \q sights -> holdsWhatIsSeen (sampleScene s) q (inFront normal sights)
  where
    slope (Point qx qy) (Point x y) = if x == qx then Nothing else Just ((y - qy) / (x - qx))

holdsWhatIsSeen :: Scene -> Point -> [[Sight]] -> Property
holdsWhatIsSeen scene q parts =
  forAll ((,) <$> choose (-4999, 4999) <*> choose (-4999, 4999)) $ \(i, j) ->
    let Point mx my = middle
        x = Point (mx + reach * (fromInteger i / 5003)) (my + reach * (fromInteger j / 5009))
     in all (clear (place x)) outlines ==>
          any (isInside (place x)) outlines === isSeen scene q (concat parts) x
  where
    (middle, reach) = surroundingsOf scene q
    place (Point x y) = let Point mx my = middle in Place (part (x - mx)) (part (y - my))
      where
        part v = fromRational (v / reach)
    outlines = [outlinePlaces (Box (-1) (-1) 1 1) place (place q) (bends scene q sights) | sights <- parts]

-- | A normal.
newtype Normal = Normal Direction
  deriving (Show)

instance Arbitrary Normal where
  arbitrary = do
    (x, y) <- arbitrary `suchThat` (/= (0, 0))
    pure (Normal (Direction x y))

data Before = Ahead | Aside | Behind
  deriving (Eq)

turnsLeft :: Direction -> Direction -> Before
turnsLeft (Direction nx ny) (Direction x y) = case compare (nx * x + ny * y) 0 of
  GT -> Ahead
  EQ -> Aside
  LT -> Behind

-- | The middle of the bounding box of the scene with the viewpoint, and more than half of its longer side, in the
-- file's units.
surroundingsOf :: Scene -> Point -> (Point, Rational)
surroundingsOf scene q = (Point ((left + right) / 2) ((low + high) / 2), 2 / 3 * maximum [right - left, high - low])
  where
    points = q : map (cornerPoint scene) (corners scene)
    (left, right) = (minimum [x | Point x _ <- points], maximum [x | Point x _ <- points])
    (low, high) = (minimum [y | Point _ y <- points], maximum [y | Point _ y <- points])

-- | Does a sight in which a point lies reach as far?
isSeen :: Scene -> Point -> [Sight] -> Point -> Bool
isSeen scene (Point qx qy) sights (Point x y) = or [reaches object | Sight from to object <- sights, holds from to]
  where
    (dx, dy) = (x - qx, y - qy)
    holds from to
      | aside from == 0 && ahead from > 0 = True
      | directionTurn from to == LeftTurn = aside from > 0 && aside to < 0
      | directionTurn from to == RightTurn = aside from > 0 || aside to < 0
      | sameWay from to = True
      | otherwise = aside from > 0
    aside (Direction a b) = fromInteger a * dy - fromInteger b * dx
    ahead (Direction a b) = fromInteger a * dx + fromInteger b * dy
    sameWay (Direction a b) (Direction c d) = a * c + b * d > 0
    reaches Sky = True
    -- The solid lies to the left of the side.
    reaches (Side s) =
      let Point ax ay = cornerPoint scene (sideStart s)
          Point bx by = cornerPoint scene (sideEnd scene s)
       in (bx - ax) * (y - ay) - (by - ay) * (x - ax) < 0

-- | Is a place inside an outline, by the number of its lines to the right?
isInside :: Place -> [Place] -> Bool
isInside (Place x y) outline = odd (length (filter crossed (zip outline (drop 1 outline <> take 1 outline))))
  where
    crossed (Place ax ay, Place bx by) = (ay > y) /= (by > y) && x < ax + (y - ay) * (bx - ax) / (by - ay)

-- | Is a place far enough from an outline for Doubles?
clear :: Place -> [Place] -> Bool
clear (Place x y) outline = not (any (segmentMeetsBox (Box (x - d) (y - d) (x + d) (y + d))) lines')
  where
    lines' = zip outline (drop 1 outline <> take 1 outline)
    d = 1e-6
