module Visibility.Scene.TouchingSpec (spec) where

import Data.Either (isLeft)
import Data.Foldable (toList)
import Data.List (nub, sort)
import qualified Data.Set as Set
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck
import Visibility.Error (SceneError (..))
import Visibility.Exact.Point (Point (..))
import Visibility.Scene.Contact
import Visibility.Scene.Oracle
import Visibility.Scene.Outline
import Visibility.Scene.Raw
import Visibility.Scene.Sample
import Visibility.Scene.Touching
import Visibility.Scene.Validate (validate)

spec :: Spec
spec = do
  describe "touching: something is wrong exactly when the comparison of all pairs finds it; else the places are those \
           \that hold two corners or a corner and a side, and the cuts are all pairs of such a place and such a side" $
    modifyMaxSuccess (* 20) $ do
      prop "of walls" $ forAll walls $ mixed . scene . map rawWall
      prop "of triangles" $ forAll triangles $ mixed . scene . map rawPolygon
      prop "of a line of segments" $ forAll paths $ mixed . scene . pure . rawWall
      prop "of polygons around each other" $ forAll nested mixed
      prop "of fans: triangles and walls that meet in one point, and polygons that pass it" $
        forAll fans $ \raw -> cover 10 (isMany raw) "many in one point, valid" (mixed raw)
      prop "of cluttered scenes in which no polygon is wrong at its own corners" $
        forAll clutteredScenes $ \raw -> not (any isOwn (naiveErrors raw)) ==> mixed raw
  describe "tangled: of two sides that cross, one is found at least; there are not more sides found than pairs that \
           \cross or lie along each other; the cuts are all places with corners that others pass" $
    modifyMaxSuccess (* 20) $ do
      prop "of walls" $ forAll (listOf (near 9 2)) $ disentangled . scene . map rawWall
      prop "of triangles" $ forAll triangles $ disentangled . scene . map rawPolygon
      prop "of fans" $ forAll fans disentangled
      prop "of cluttered scenes" $ forAll clutteredScenes $ \raw ->
        all ((>= 3) . length . rawCorners . snd) (polygonsOf raw) ==> disentangled raw
  where
    disentangled raw =
      cover 5 (not (null knots)) "tangled" $
        conjoin
          [ [(s, t) | (s, t) <- crossing, s `notElem` knots, t `notElem` knots] === []
          , counterexample (show knots) (length knots <= length crossing + length along)
          , nub knots === knots
          , sort (nub [(placeOf o c, s) | (c, s) <- cuts, s `notElem` knots])
              === sort (nub [(placeOf o i, s) | i <- used o, s <- starts o, s `notElem` knots, inside o i s])
          ]
      where
        o = outline (polygonsOf raw)
        (knots, cuts) = tangled o
        pairs = [(s, t) | s <- starts o, t <- starts o, s < t]
        how (s, t) = meeting (outlineRanked o) (segmentFrom o s) (segmentFrom o t)
        crossing = [pair' | pair' <- pairs, how pair' == Crossing]
        along = [pair' | pair' <- pairs, Touching touches <- [how pair'], length (nub touches) > 1]
    used o = concatMap (cornersOf o) (polygonIndices o)
    starts o = concatMap (segmentStarts o) (polygonIndices o)
    inside o i s = case meeting (outlineRanked o) (Segment i i) (segmentFrom o s) of
      Touching touches -> FirstOnSecond i `elem` touches
      _ -> False
    mixed raw = cover 2 (isWrong raw) "wrong" $ cover 5 (not (isWrong raw)) "right" $ agrees raw
    isWrong = any isOfPlane . naiveErrors
    isMany raw = not (isWrong raw) && length (rawPolygons raw) > 4
    -- Where something is wrong, it is told as well.
    agrees raw
      | isWrong raw = isLeft found .&&. Set.fromList (either toList (const []) (validate raw)) === naiveErrors raw
      | otherwise = fmap told found === Right expected
      where
        told (Contacts places cuts) = (places, sort [(placeOf o c, s) | (c, s) <- cuts])
        o = outline (polygonsOf raw)
        found = touching o
        cuts' = nub [(placeOf o i, s) | i <- used o, s <- starts o, inside o i s]
        shared = [placeOf o i | i <- used o, j <- used o, i < j, placeOf o i == placeOf o j]
        expected = (length (nub (map fst cuts' <> shared)), sort cuts')
    isOfPlane e = case e of
      NoSuchSide _ _ -> False
      BadEmission _ _ -> False
      BadReflectivity _ _ -> False
      TooFewCorners _ _ -> False
      EmptyScene -> False
      _ -> True
    isOwn e = case e of
      TooFewCorners _ _ -> True
      EmptyScene -> True
      RepeatedCorner {} -> True
      ZeroArea _ -> True
      Spike _ _ -> True
      _ -> False
    scene = RawScene Nothing Nothing
    -- Triangles and walls from one point to places around it, side by side or not; and polygons that pass the point.
    fans = do
      n <- choose (1, 8)
      rim <- vectorOf (2 * n) (choose (0, 39)) >>= \found -> elements [sort found, found]
      k <- choose (0, 39)
      passing <- sublistOf [rawPolygon (map onRim [k, k + 20, k + 23]), rawWall (map onRim [k, k + 20])]
      scene <$> shuffle (parts rim <> take 1 passing)
    parts (a : b : rest)
      | 0 < b - a, b - a < 20 = rawPolygon [Point 0 0, onRim a, onRim b] : parts rest
      | otherwise = rawWall [Point 0 0, onRim a] : parts rest
    parts _ = []
    onRim k = case (fromIntegral (k `mod` 10), k `div` 10 `mod` 4 :: Int) of
      (d, 0) -> Point 5 (d - 5)
      (d, 1) -> Point (5 - d) 5
      (d, 2) -> Point (-5) (5 - d)
      (d, _) -> Point (d - 5) (-5)
    -- Squares and walls around each other and beside each other; with a room, which may be anywhere too.
    nested = do
      n <- choose (1, 5)
      polygons <- vectorOf n nest
      room <- oneof [pure Nothing, Just . rawPolygon <$> (square 20 =<< elements [9, 19])]
      pure (scene polygons) {rawEnclosure = room}
    nest = do
      reach <- elements [1, 2, 4, 8]
      corners <- square 20 reach
      -- In a polygon with a notch, sides also start where there is its solid around.
      notched <- notch corners <$> elements [1 / 8, 1 / 4, 3 / 8]
      elements $
        map rawPolygon [corners, reverse corners, notched, reverse notched]
          <> map rawWall [take 2 corners, take 3 corners]
    notch corners k = case corners of
      Point a b : others@[_, Point c d, _] -> Point (a * k + c * (1 - k)) (b * k + d * (1 - k)) : others
      _ -> corners
    -- A little turned, so that few corners are in one place and few sides on one line.
    square :: Rational -> Rational -> Gen [Point]
    square width reach = do
      x <- fromInteger <$> choose (0, floor width)
      y <- fromInteger <$> choose (0, floor width)
      tilt <- elements [0, 1 / 7]
      let (c, s) = (reach, tilt * reach)
      pure [Point (x + dx) (y + dy) | (dx, dy) <- [(c, s), (negate s, c), (negate c, negate s), (s, negate c)]]
    place width = Point <$> whole width <*> whole width
    whole width = fromInteger <$> choose (0, width)
    walls = do
      (n, width) <- elements [(3, 3), (6, 9), (6, 60), (30, 100), (30, 2 ^ (40 :: Int))]
      k <- choose (0, n)
      vectorOf k (near width 2)
    triangles = do
      n <- choose (0, 4)
      width <- elements [6, 12, 60]
      vectorOf n (near width 3 `suchThat` hasArea)
    -- Corners near to each other, so that some scenes are disjoint.
    near :: Integer -> Int -> Gen [Point]
    near width n = do
      Point x y <- place width
      reach <- elements [2, 4, 9]
      let corner = (\(Point dx dy) -> Point (x + dx) (y + dy)) <$> place reach
      vectorOf n corner `suchThat` (\c -> length (nub c) == n)
    paths = do
      n <- choose (2, 7)
      width <- elements [4, 9]
      (scanl1 plus <$> vectorOf n (place width)) `orJumble` vectorOf n (place width) `suchThat` hasNoSpike
    orJumble a b = oneof [a, b]
    plus (Point x y) (Point dx dy) = Point (x + dx) (y + 4 - dy)
    hasArea [a, b, c] = cross a b c /= 0
    hasArea _ = False
    hasNoSpike path = and (zipWith3 isOpen path (drop 1 path) (drop 2 path)) && and (zipWith (/=) path (drop 1 path))
    isOpen a b c = cross a b c /= 0 || dot b a c < 0
    cross (Point ax ay) (Point bx by) (Point cx cy) = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    dot (Point ox oy) (Point ax ay) (Point bx by) = (ax - ox) * (bx - ox) + (ay - oy) * (by - oy)
