module Visibility.SightSpec (spec) where

import Data.List (nub)
import Data.Ratio ((%))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.Predicate
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Law (broken)
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Sight
import Visibility.Test.Generator
import Visibility.Test.Metamorphic
import Visibility.Test.Scan

spec :: Spec
spec = do
  describe "joined sights" $ do
    modifyMaxSuccess (* 5) $
      it "are what they were before they were cut in two and begun elsewhere" $
        looking $ \_ _ sights -> forAll (choose (0, 2 * length sights)) $ \k ->
          let pieces = concatMap halved sights in joined (drop k pieces <> take k pieces) === sights
    it "are one where one object is all around" $ do
      joined [Sight (Direction 3 3) (Direction (-1) 0) Sky, Sight (Direction (-2) 0) (Direction 1 1) Sky]
        `shouldBe` [Sight (Direction 1 0) (Direction 1 0) Sky]
      joined [Sight (Direction 3 3) (Direction 3 3) Sky] `shouldBe` [Sight (Direction 1 0) (Direction 1 0) Sky]
      joined [] `shouldBe` []
  describe "the visibility polygon" $ do
    it "of a point before a square goes along the near side, and to infinity" $
      regionFrom (under [square]) (Point 0 (-1))
        `shouldBe` Region [Point 1 1, Point (-1) 1] [(Direction (-1) 2, Direction 1 2)]
    it "of a point on a free side is a half plane, and has that one point" $
      regionFrom (under [square]) (Point 0 1) `shouldBe` Region [Point 0 1] [(Direction (-1) 0, Direction 1 0)]
    it "of a corner leaves the solid out" $
      regionFrom (under [square]) (Point 1 1) `shouldBe` Region [Point 1 1] [(Direction (-1) 0, Direction 0 1)]
    it "is the whole plane where a wall is seen edge-on, or is what one stands on" $ do
      let plane = Region [] [(Direction 1 0, Direction 1 0)]
      regionFrom (under [[(0, 0), (2, 1)]]) (Point 4 2) `shouldBe` plane
      regionFrom (under [[(0, 0), (2, 1)]]) (Point 1 (1 % 2)) `shouldBe` plane
      regionFrom (under [[(0, 0), (2, 1)]]) (Point 2 1) `shouldBe` plane
    it "does not end at a wall that is seen edge-on" $
      regionFrom (under [[(0, 1), (2, 1)], [(-1, 1), (-3, 3)]]) (Point 0 0)
        `shouldBe` Region [Point 2 1, Point 0 1] [(Direction 0 1, Direction 2 1)]
    it "begins after its first way to infinity, turning from the right" $
      regionFrom (under [[(-1, 1), (1, 1)], [(-1, -1), (1, -1)]]) (Point 0 0)
        `shouldBe` Region
          [Point (-1) (-1), Point 1 (-1), Point 1 1, Point (-1) 1]
          [(Direction (-1) 1, Direction (-1) (-1)), (Direction 1 (-1), Direction 1 1)]
    it "of a point in a room goes along shadows, and begins with the least point" $
      regionFrom (inRoom [(0, 0), (4, 0), (4, 4), (0, 4)] [[(1, 2), (3, 2)]]) (Point 1 1)
        `shouldBe` Region
          [Point 0 0, Point 4 0, Point 4 (5 % 2), Point 3 2, Point 1 2, Point 1 4, Point 0 4]
          []
    modifyMaxSuccess (* 5) $ do
      it "is bounded where rays end" $
        looking $ \scene eye sights -> forAll (vectorOf 5 ray) $ \rays ->
          conjoin
            [ counterexample (show d) $ distanceOf (region scene eye sights) eye d === shotDistance scene eye d
            | d <- filter (missesCorners scene eye) rays
            ]
      it "has no repeated and no flat points, but for that of a half plane, and the eye where solid rays are in parts" $
        looking $ \scene eye sights ->
          let found = region scene eye sights
              points = regionPoints found
              elsewhere = filter (/= eye) points
              triples = zip3 points (drop 1 (cycle points)) (drop 2 (cycle points))
           in counterexample (show found) $
                length (nub elsewhere) === length elsewhere
                  .&&. length points - length elsewhere <= length (solidRays sights)
                  .&&. (not (null (regionUnbounded found)) || (length points >= 3 && not (any straight triples)))
      it "does not change where a side is cut by a flat corner" $
        property $ \(AnyScene s) -> forAll (splitSide (sampleRaw s)) $ \split ->
          case split >>= sample . splitScene of
            Nothing -> property Discard
            Just cut -> forAll (somePoint (sampleScene s)) $ \eye ->
              (region (sampleScene s) eye <$> scan (sampleScene s) eye)
                === (region (sampleScene cut) eye <$> scan (sampleScene cut) eye)
  describe "the form factors of an element" $ do
    let wall = under [[(-1, 1), (1, 1)]]
        near = [(TheSide (SideName (Obstacle 0) 0), RootSum.hypotenuse (1 % 2) 1 1)]
        rest = RootSum.rational 1 - RootSum.hypotenuse (1 % 2) 1 1
    it "are differences of sines" $ do
      factorsFrom wall (Point 0 0) (Direction 0 1) `shouldBe` near <> [(TheSky, rest)]
      factorsFrom wall (Point 0 0) (Direction 0 7) `shouldBe` near <> [(TheSky, rest)]
    it "leave out what lies behind" $ do
      factorsFrom wall (Point 0 0) (Direction 0 (-1)) `shouldBe` [(TheSky, RootSum.rational 1)]
      factorsFrom wall (Point 0 0) (Direction 1 0)
        `shouldBe` [ (TheSide (SideName (Obstacle 0) 0), RootSum.scaled (1 % 2) rest)
                   , (TheSky, RootSum.rational 1 - RootSum.scaled (1 % 2) rest)
                   ]
    modifyMaxSuccess (* 5) $ do
      it "add up to 1, less what the solid takes" $
        looking $ \scene _ sights -> forAll normals $ \normal ->
          let open = elementFactors scene normal sights
              closed = elementFactors scene normal (solidRays sights)
           in counterexample (show (open, closed)) $
                mconcat (map snd (open <> closed)) === RootSum.rational 1
                  .&&. (null (solidRays sights) ==> null closed)
      it "are positive, and add up to 1 on a side that one looks from straight ahead" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
           in not (null (sides scene)) ==> forAll (elements (sides scene)) $ \side ->
                let Point ax ay = cornerPoint scene (sideStart side)
                    Point bx by = cornerPoint scene (sideEnd scene side)
                    CornerId a = sideStart side
                    CornerId b = sideEnd scene side
                    Direction ex ey = direction (scenePoints scene) a b
                    eye = Point ((ax + 2 * bx) / 3) ((ay + 2 * by) / 3)
                 in case scan scene eye of
                      Left polygon -> counterexample (show polygon) False
                      Right sights ->
                        let found = map snd (elementFactors scene (Direction ey (negate ex)) sights)
                         in mconcat found === RootSum.rational 1
                              .&&. conjoin [RootSum.sign f === RootSum.Positive | f <- found]
      it "do not change where sights are cut" $
        looking $ \scene _ sights -> forAll normals $ \normal ->
          elementFactors scene normal (concatMap halved sights) === elementFactors scene normal sights
  where
    square = [(-1, 1), (1, 1), (1, 3), (-1, 3)]
    straight (Point ax ay, Point bx by, Point cx cy) = (bx - ax) * (cy - by) == (by - ay) * (cx - bx)
    ray = Direction <$> choose (-99, 99) <*> elements [-97, -89, -61, -31, 7, 37, 71, 101]
    normals = suchThat (Direction <$> choose (-3, 3) <*> choose (-3, 3)) (/= Direction 0 0)

-- | A free point of a scene, and what it sees.
looking :: Testable p => (Scene -> Point -> [Sight] -> p) -> Property
looking f = property $ \(AnyScene s) ->
  let scene = sampleScene s
   in forAll (somePoint scene) $ \eye -> case scan scene eye of
        Left _ -> property Discard
        Right sights -> property (f scene eye sights)

-- | A sight cut in its middle, more or less.
halved :: Sight -> [Sight]
halved (Sight from@(Direction ax ay) to@(Direction bx by) object) = [Sight from middle object, Sight middle to object]
  where
    middle = case directionTurn from to of
      LeftTurn -> Direction (ax + bx) (ay + by)
      RightTurn -> Direction (negate (ax + bx)) (negate (ay + by))
      Collinear -> if from == to then Direction (negate ax) (negate ay) else Direction (negate ay) ax

-- | The rays that lead into the solid, as if they ended at the sky.
solidRays :: [Sight] -> [Sight]
solidRays sights =
  [ Sight (sightTo a) (sightFrom b) Sky
  | (a, b) <- zip sights (drop 1 sights <> take 1 sights)
  , sightTo a /= sightFrom b
  ]

-- | How far it is to the boundary of a region along a ray, in lengths of the ray's vector: 'Nothing' into the solid.
distanceOf :: Region -> Point -> Direction -> Maybe (Either Object Rational)
distanceOf found (Point x y) d@(Direction dx dy)
  | any isWithin (regionUnbounded found) = Just (Left Sky)
  | otherwise = case crossed of
      [t] -> Just (Right t)
      [] -> Nothing
      _ -> broken "a ray meets the boundary once" (show crossed)
  where
    isWithin (from, to)
      | from == to = True
      | directionTurn from to == LeftTurn = leftOf from d && leftOf d to
      | directionTurn from to == RightTurn = leftOf from d || leftOf d to
      | otherwise = leftOf from d
    leftOf a b = directionTurn a b == LeftTurn
    points = regionPoints found
    crossed =
      [ (ax * ey - ay * ex) / (fromInteger dx * ey - fromInteger dy * ex)
      | (Point px py, Point qx qy) <- zip points (drop 1 points <> take 1 points)
      , let (ax, ay) = (px - x, py - y)
      , let (bx, by) = (qx - x, qy - y)
      , let (ex, ey) = (bx - ax, by - ay)
      , ax * by - ay * bx > 0
      , ax * fromInteger dy - ay * fromInteger dx > 0
      , fromInteger dx * by - fromInteger dy * bx > 0
      ]

-- | The same by shooting.
shotDistance :: Scene -> Point -> Direction -> Maybe (Either Object Rational)
shotDistance scene eye@(Point x y) d@(Direction dx dy) = case shootFrom scene eye d of
  Solid -> Nothing
  Meets Sky -> Just (Left Sky)
  Meets (Side s) ->
    let Point ax ay = cornerPoint scene (sideStart s)
        Point bx by = cornerPoint scene (sideEnd scene s)
        (ex, ey) = (bx - ax, by - ay)
     in Just (Right (((ax - x) * ey - (ay - y) * ex) / (fromInteger dx * ey - fromInteger dy * ex)))

missesCorners :: Scene -> Point -> Direction -> Bool
missesCorners scene (Point x y) (Direction dx dy) = not (any isAhead (corners scene))
  where
    isAhead c = let Point cx cy = cornerPoint scene c in (cx - x) * fromInteger dy == (cy - y) * fromInteger dx

regionFrom :: Scene -> Point -> Region
regionFrom scene eye = region scene eye (sightsFrom scene eye)

factorsFrom :: Scene -> Point -> Direction -> [(Seen, RootSum.RootSum)]
factorsFrom scene eye normal = elementFactors scene normal (sightsFrom scene eye)

sightsFrom :: Scene -> Point -> [Sight]
sightsFrom scene eye = either (broken "the point is free" . show) id (scan scene eye)

under :: [[(Integer, Integer)]] -> Scene
under = made Nothing

inRoom :: [(Integer, Integer)] -> [[(Integer, Integer)]] -> Scene
inRoom room = made (Just (ring room))

made :: Maybe RawPolygon -> [[(Integer, Integer)]] -> Scene
made room loops = case sample (RawScene Nothing room (map ring loops)) of
  Just s -> sampleScene s
  Nothing -> broken "the scene is valid" (show loops)

ring :: [(Integer, Integer)] -> RawPolygon
ring loop = rawPolygon [Point (fromInteger x) (fromInteger y) | (x, y) <- loop]
