module Visibility.CountSpec (spec) where

import Data.List (nub, partition)
import qualified Data.Set as Set
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Count
import Visibility.Exact.Point (Point (..))
import Visibility.Scene
import Visibility.Scene.Family (Family (Random), Seed (..), family, size)
import Visibility.Scene.Raw (Form (..))
import Visibility.Scene.Validate (validate)
import Visibility.Sweep
import Visibility.Test.BruteForce (bruteForce)
import Visibility.Test.Generator
import Visibility.View

spec :: Spec
spec = describe "count" $ do
  modifyMaxSuccess (* 5) $ do
    it "obeys V - E - B + F = W + 1 under an open sky, W in a room" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            c = counted scene
            walls = length (filter isStraightWall (heaps scene))
            whole = case surroundings scene of OpenSky -> 1; Room -> 0
         in counterexample (show c) $
              vertexCount c - edgeCount c - buriedCount c + faceCount c === walls + whole
    it "counts pairs, vertices and bitangents as brute force has them, by the file's names" $
      property $ \(AnyScene s) ->
        let scene = sampleScene s
            c = counted scene
            brute = bruteForce scene
            free (p, q) =
              q `notElem` [nextCorner scene p, previousCorner scene p] && isTangent scene p q && isTangent scene q p
            places v = Set.fromList (map (cornerPoint scene) (vertexCorners v))
            pairs = concatMap (vertexPairs scene) brute
         in (vertexCount c, degenerateCount c, pairCount c, bitangentCount c)
              === ( length brute
                  , length (filter ((> 2) . Set.size . places) brute)
                  , Set.size (named scene pairs)
                  , Set.size (named scene (filter free pairs))
                  )
  it "finds, for two squares, what can be counted by hand" $
    -- Pairs: eight sides and four across the gap. The two horizontal lines are one vertex each, for three pairs; beside
    -- them there are four vertical sides and two diagonals. The inner corners have three vertices each, the outer ones
    -- two, and an edge from each to the next.
    fmap (counted . sampleScene) (sampleOf [square 0, square 2]) `shouldBeJust` Counts 8 2 12 4 20 0 13
  it "has two edges a vertex and a face more than vertices, for convex polygons in general position" $
    forAll ((,) <$> choose (1, 8) <*> fmap Seed arbitrary) $ \(n, seed) ->
      case fmap (\k -> validate (family Random k seed)) (size n) of
        Just (Right scene) ->
          let c = counted scene
           in degenerateCount c == 0 ==> (edgeCount c, faceCount c) === (2 * vertexCount c, vertexCount c + 1)
        _ -> property False
  where
    -- Each corner of the file in the place of one with each in the place of the other.
    named scene pairs =
      Set.fromList
        [Set.fromList [a, b] | (p, q) <- pairs, a <- namesAt scene p, b <- namesAt scene q]
    namesAt scene c = [name | (name, point) <- statedCorners scene, point == cornerPoint scene c]
    counted scene = count scene (events scene (vertices scene))
    square x = [(x, 0), (x + 1, 0), (x + 1, 1), (x, 1)]
    shouldBeJust actual expected = actual `shouldBe` Just expected

-- | The polygons that hang together by contacts.
heaps :: Scene -> [[Polygon]]
heaps scene = foldr join [] (scenePolygons scene)
  where
    join p found = (p : concat touching) : apart
      where
        (touching, apart) = partition (any (touches p)) found
    touches p q =
      or [on a s | a <- polygonPoints p, s <- segments q] || or [on b s | b <- polygonPoints q, s <- segments p]
    segments p = zip points (drop 1 points <> [a | Ring <- [polygonForm p], a <- take 1 points])
      where
        points = polygonPoints p
    on c (a, b) = cross a b c == 0 && between c a b

-- | Are these thin walls, all on one line?
isStraightWall :: [Polygon] -> Bool
isStraightWall found =
  all ((== Polyline) . polygonForm) found
    && and [cross a b c == 0 | let points = concatMap polygonPoints found, a : b : _ <- [nub points], c <- points]

cross :: Point -> Point -> Point -> Rational
cross (Point ax ay) (Point bx by) (Point cx cy) = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)

-- | Of three points on a line, is the first between the others, or at one of them?
between :: Point -> Point -> Point -> Bool
between c a b = min a b <= c && c <= max a b
