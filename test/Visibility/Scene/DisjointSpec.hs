module Visibility.Scene.DisjointSpec (spec) where

import Data.List (nub, tails)
import qualified Data.Set as Set
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck
import Visibility.Error (SceneError (..))
import Visibility.Exact.Point (Point (..))
import Visibility.Scene.Contact
import Visibility.Scene.Disjoint
import Visibility.Scene.Oracle
import Visibility.Scene.Outline
import Visibility.Scene.Raw
import Visibility.Scene.Sample

spec :: Spec
spec = modifyMaxSuccess (* 20) $ do
  prop ("boundaries: Meet exactly when meeting is not Apart for two segments without a common corner, "
         <> "or two corners are in one place") $
    forAll walls $ mixed . scene . map rawWall
  prop "the same for triangles" $
    forAll triangles $ mixed . scene . map rawPolygon
  prop "the same for a line of segments" $
    forAll paths $ mixed . scene . pure . rawWall
  prop "else Misplaced exactly when an obstacle is inside of another one or outside of the enclosure" $
    forAll nested $ \raw ->
      cover 10 (verdict raw == Misplaced) "misplaced" $ cover 10 (verdict raw == Disjoint) "disjoint" $ agrees raw
  where
    mixed raw = cover 5 (verdict raw == Meet) "meet" $ cover 10 (verdict raw /= Meet) "apart" $ agrees raw
    agrees raw = boundaries (outline (polygonsOf raw)) === verdict raw
    scene = RawScene Nothing Nothing
    verdict raw
      | meets raw = Meet
      | any isPosition (Set.toList (naiveErrors raw)) = Misplaced
      | otherwise = Disjoint
    isPosition e = case e of
      NestedPolygon _ _ -> True
      OutsideEnclosure _ -> True
      _ -> False
    meets raw =
      let o = outline (polygonsOf raw)
          r = outlineRanked o
          used = concatMap (cornersOf o) (polygonIndices o)
          segments = map (segmentFrom o) (concatMap (segmentStarts o) (polygonIndices o))
       in or [samePlace r i j | i <- used, j <- used, i < j]
            || or [meeting r s t /= Apart | s : later <- tails segments, t <- later, apart s t]
    apart (Segment a b) (Segment c d) = all (`notElem` [c, d]) [a, b]
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
