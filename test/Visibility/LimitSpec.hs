-- | Polygons that touch against polygons that do so all but, with a slit between them.
--
-- Let every obstacle, a ring that is seen whole from a point c inside it, shrink towards c by the factor 1 − ε. Then it
-- lies inside of what it was, so nothing touches any more. Let n be the number of corners of all obstacles, and D the
-- greatest distance of one from its c: no corner moves by more than Dε.
--
-- Take a line that passes every corner at more than this distance. While ε shrinks to 0, no corner comes to lie on it,
-- so it crosses the same sides all the time, and those of one obstacle in the same order; obstacles do not meet, so the
-- order of all that it crosses is the same, too. Hence at ε it has the free segments that it has at 0, between the same
-- sides, and besides, for each place where it leads from one polygon into another through what these cover of each
-- other, one more, through the slit, between the two sides that touch there.
--
-- All lines through the common piece of two sides, of length c(s, t), have the measure 2 c(s, t), and all other lines,
-- those that pass a corner at Dε at most, have no more than 2π n D ε. So
--
-- > |A_ε(s, t) − A(s, t) − 2 c(s, t)| ≤ 2π n D ε
--
-- for all sides s and t, and for the sky in place of t, with c = 0. Divided by twice the length L of s, which shrinks
-- too, that is the law below, as F_ε ≤ 1:
--
-- > |F_ε(s, t) − F(s, t) − c(s, t) / L| ≤ (1 + π n D / L) ε
--
-- In words: what sides do not cover of each other exchanges light as in the limit. What they cover sees, however small
-- the slit, what covers it, with the fraction that is covered; the scene in which they touch does not have that, as
-- covered parts see nothing there.
module Visibility.LimitSpec (spec) where

import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)
import Test.Hspec
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.RootSum (RootSum)
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Test.Generator
import Visibility.Test.Metamorphic

spec :: Spec
spec =
  describe "form factors of polygons that touch" $ do
    it "are, but for what covers a side, the limit of those of polygons that shrink" $
      checkCoverage $
        forAllShrink (touchingScene `suchThat` (not . null . rawPolygons . seenWhole . sampleRaw)) shrinkSample $ \s ->
          case sample (seenWhole (sampleRaw s)) of
            Nothing -> counterexample "not valid" False
            Just limit ->
              let common = commonParts (sampleScene limit)
               in cover 40 (not (Map.null common)) "sides that cover each other" $
                    cover 40 (sceneContacts (sampleScene limit) > 0) "contacts" $
                      conjoin [nearLimit limit common epsilon | epsilon <- [1 / 2 ^ (20 :: Int), 1 / 2 ^ (40 :: Int)]]
    it "are those of the slit but for its sides, where two squares share a side" $
      once $ case pairOfSquares of
        Nothing -> property False
        Just limit ->
          let common = commonParts (sampleScene limit)
           in conjoin
                [ Map.toList common === [((side 0 1, side 1 3), 1 / 2), ((side 1 3, side 0 1), 1)]
                , Map.lookup (side 0 1, Just (side 1 3)) (factorsOf (sampleScene limit)) === Nothing
                , Map.lookup (side 0 1, Nothing) (factorsOf (sampleScene limit)) === Just rest
                , nearLimit limit common (1 / 2 ^ (60 :: Int))
                ]
  where
    side p = SideName (Obstacle p)
    pairOfSquares = sampleOf [[(0, 0), (2, 0), (2, 2), (0, 2)], [(2, 1), (3, 1), (3, 2), (2, 2)]]
    -- The lower half of the side sees the lower side of the other square at a right angle.
    rest = RootSum.scaled (1 / 4) (RootSum.hypotenuse 1 1 1)

-- | The rings of a scene that are seen whole from the mean of their corners, and the enclosure.
seenWhole :: RawScene -> RawScene
seenWhole raw = raw {rawPolygons = filter isSeenWhole (rawPolygons raw)}
  where
    isSeenWhole polygon = rawForm polygon == Ring && (all (> 0) (turnsOf polygon) || all (< 0) (turnsOf polygon))
    turnsOf polygon =
      [ (ax - x) * (by - y) - (ay - y) * (bx - x)
      | let Point x y = middleOf polygon
      , (Point ax ay, Point bx by) <- zip (rawCorners polygon) (drop 1 (cycle (rawCorners polygon)))
      ]

-- | The mean of all corners.
middleOf :: RawPolygon -> Point
middleOf polygon = Point (mean [x | Point x _ <- rawCorners polygon]) (mean [y | Point _ y <- rawCorners polygon])
  where
    mean values = sum values / fromIntegral (length values)

-- | All obstacles shrunk by the factor 1 − ε.
shrunk :: Rational -> RawScene -> RawScene
shrunk epsilon raw = raw {rawPolygons = map smaller (rawPolygons raw)}
  where
    smaller polygon = polygon {rawCorners = map (nearer (middleOf polygon)) (rawCorners polygon)}
    nearer (Point x y) (Point px py) = Point (px + epsilon * (x - px)) (py + epsilon * (y - py))

-- | Does the law hold at some ε? The parts that sides have in common are given.
nearLimit :: Sample -> Map.Map (SideName, SideName) Rational -> Rational -> Property
nearLimit limit common epsilon = case sample (shrunk epsilon (sampleRaw limit)) of
  Nothing -> counterexample "not valid when shrunk" False
  Just near ->
    let touching = factorsOf (sampleScene limit)
        apart = factorsOf (sampleScene near)
        partOf (s, t) = maybe RootSum.zero (\t' -> RootSum.rational (Map.findWithDefault 0 (s, t') common)) t
        keys = Map.keys (Map.unions [touching, apart, RootSum.rational <$> Map.mapKeys (fmap Just) common])
        valueIn table key = Map.findWithDefault RootSum.zero key table
     in counterexample ("at " <> show epsilon) $
          (sceneContacts (sampleScene near) === 0)
            .&&. conjoin
              [ counterexample (show (key, gap)) (magnitude gap <= RootSum.rational (bound key * epsilon))
              | key <- keys
              , let gap = (valueIn apart key - valueIn touching key) - partOf key
              ]
  where
    obstacles = rawPolygons (sampleRaw limit)
    count = fromIntegral (sum (map (length . rawCorners) obstacles)) :: Rational
    -- No less than the distance.
    farthest =
      maximum
        (0 : [abs (px - x) + abs (py - y) | p <- obstacles, Point x y <- [middleOf p], Point px py <- rawCorners p])
    bound (s, _) = 1 + 22 / 7 * count * farthest / leastLength s
    -- No more than the length.
    leastLength s = Map.findWithDefault 1 s lengths
    lengths =
      Map.fromList
        [ (name, max (abs (bx - ax)) (abs (by - ay)))
        | (name, (Point ax ay, Point bx by)) <- sidesIn (sampleScene limit)
        ]

magnitude :: RootSum -> RootSum
magnitude x = case RootSum.sign x of
  RootSum.Negative -> negate x
  _ -> x

-- | The parts of sides that other sides cover, by both: along both sides there is some of the same line.
commonParts :: Scene -> Map.Map (SideName, SideName) Rational
commonParts scene = Map.fromList (mapMaybe common [(s, t) | s <- sidesIn scene, t <- sidesIn scene])
  where
    common ((s@(SideName p _), (a@(Point ax ay), b@(Point bx by))), (t@(SideName q _), (c, d)))
      | p /= q && onLine c && onLine d && low < high = Just ((s, t), high - low)
      | otherwise = Nothing
      where
        onLine (Point x y) = (bx - ax) * (y - ay) == (by - ay) * (x - ax)
        along (Point x y) = if ax == bx then (y - ay) / (by - ay) else (x - ax) / (bx - ax)
        low = max (along a) (min (along c) (along d))
        high = min (along b) (max (along c) (along d))

-- | The sides of all rings, by name.
sidesIn :: Scene -> [(SideName, (Point, Point))]
sidesIn scene =
  [ (SideName (polygonId polygon) k, ends)
  | polygon <- scenePolygons scene
  , (k, ends) <- zip [0 ..] (zip (polygonPoints polygon) (drop 1 (cycle (polygonPoints polygon))))
  ]
