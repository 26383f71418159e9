module Visibility.CountSpec (spec) where

import Control.Exception (evaluate)
import Control.Monad (forM_)
import Data.List (nub, partition)
import Data.Maybe (isJust)
import qualified Data.Set as Set
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Count
import Visibility.Exact.Point (Arithmetic (..), Kernel (..), Point (..), pointsKernel)
import Visibility.Scene
import Visibility.Scene.Family (Family (Random), Seed (..), family, size)
import Visibility.Scene.Raw (Form (..), RawPolygon (..), RawScene (..))
import Visibility.Scene.Validate (validate)
import Visibility.Sweep
import Visibility.Test.Generator
import Visibility.View

spec :: Spec
spec = counting >> signs

counting :: Spec
counting = describe "count" $ do
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

signs :: Spec
signs = describe "countingSigns" $ do
  modifyMaxSuccess (* 3) $
    it "changes no result, and counts where the filter decides" $
      property $ \(AnyScene s) ->
        forAll (elements [Filtered, Exact]) $ \arithmetic ->
          forAll (elements [Topological, Straight]) $ \scheduler -> ioProperty $ do
            let scene = underArithmetic arithmetic (sampleScene s)
            (found, counted) <- countingSigns scene (swept scheduler)
            pure ((found, isJust counted, sensible counted) === (verticesBy scheduler scene, byFilter scene, True))
  it "counts in every scene anew, and nothing that is not evaluated" $
    forM_ (sampleScene <$> sampleOf (lattice (10 ^ (12 :: Int)))) $ \scene -> do
      (_, first) <- countingSigns scene (swept Topological)
      (_, second) <- countingSigns scene (swept Topological)
      (_, none) <- countingSigns scene (pure . vertices)
      second `shouldBe` first
      none `shouldBe` Just (Signs 0 0)
  it "finds at least each collinear corner left to integers" $
    forM_ [sampleScene <$> sampleOf (lattice (10 ^ k)) | k <- [12, 300 :: Int]] $
      maybe (expectationFailure "no scene") $ \scene -> do
        let collinear = sum [length (vertexCorners v) - 2 | v <- bruteForce scene]
        collinear `shouldSatisfy` (> 20)
        forM_ [Topological, Straight] $ \scheduler -> do
          (_, counted) <- countingSigns scene (swept scheduler)
          maybe 0 signsLeft counted `shouldSatisfy` (>= collinear)
  it "finds less than one sign in a thousand left to integers in general position, whatever the size of numbers" $
    forM_ [(huge, huge), (3 ^ (90 :: Int), 1), (1, huge), (huge, 1 / huge)] $ \factors ->
      case fmap (\n -> validate (stretched factors (family Random n (Seed 1)))) (size 150) of
        Just (Right scene) -> do
          (_, counted) <- countingSigns scene (swept Topological)
          maybe 0 signsDecided counted `shouldSatisfy` (> 100000)
          maybe 1 shareLeft counted `shouldSatisfy` (< 1 / 1000)
        _ -> expectationFailure "no scene"
  it "has a share of nothing where there is nothing" $
    map shareLeft [Signs 0 0, Signs 4 1] `shouldBe` [0, 1 / 4]
  where
    swept scheduler scene = let found = verticesBy scheduler scene in found <$ evaluate (length found)
    byFilter scene = case pointsKernel (scenePoints scene) of
      FilterKernel _ -> True
      _ -> False
    sensible = maybe True (\(Signs decided left) -> 0 <= left && left <= decided)
    lattice unit =
      [ [(unit * (x + dx), unit * (y + dy)) | (dx, dy) <- [(0, 0), (1, 0), (1, 1), (0, 1)]]
      | x <- [0, 2, 4]
      , y <- [0, 2, 4]
      ]
    huge = 10 ^ (300 :: Int)
    stretched factors raw = raw {rawPolygons = map (onCorners factors) (rawPolygons raw)}
    onCorners (a, b) p = p {rawCorners = [Point (a * x) (b * y) | Point x y <- rawCorners p]}

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
