module Visibility.Mesh.ElementSpec (spec) where

import Data.List (nub, sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, mapMaybe)
import qualified Data.Vector as V
import Test.Hspec
import Test.QuickCheck hiding (sample)
import Visibility.Complex (build)
import Visibility.Complex.Law (violations)
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.RootSum (RootSum)
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Exact.SomeRoots
import Visibility.FormFactor
import Visibility.Mesh
import Visibility.Mesh.Type (Mesh (..))
import Visibility.Scene
import Visibility.Scene.Raw (Form (..), RawPolygon (..), RawScene (..))
import Visibility.Sweep
import Visibility.Test.BruteForce (bruteForce)
import Visibility.Test.Generator
import Visibility.Test.Landing (positionOn)
import Visibility.Test.Light (furnished)
import Visibility.Test.Metamorphic (doublesOf, roundedOf)

spec :: Spec
spec = do
  describe "elements" $ do
    it "cover all that is free of each side without gaps, in order from its start, numbered from 0" $
      forAllMeshes $ \mesh ->
        let scene = meshScene mesh
         in [(elementSide e, elementNumber e, elementFrom e, elementTo e) | e <- refinedElements (refined mesh)]
              === [ (side, k, from, to)
                  | side <- statedSides scene
                  , (k, (from, to)) <- zip [0 ..] (concatMap (divided mesh side) (freeParts scene side))
                  ]
    it "are where their parameters say, in the direction of their side" $
      forAllMeshes $ \mesh ->
        let cut = refined mesh
         in conjoin
              [ counterexample (elementText e) $
                  (map (positionOn scene side) [from, to], all (isOnLine (sideEnds scene side)) [from, to])
                    === ([elementFrom e, elementTo e], True)
              | e <- refinedElements cut
              , let scene = meshScene mesh
              , let side = elementSide e
              , let (from, to) = elementEnds cut e
              ]
    it "are the sides of the scene that they make, each free and of the material of its side" $
      forAllMeshes $ \mesh ->
        let cut = refined mesh
            fine = refinedScene cut
            named = map elementIn (refinedElements cut)
         in conjoin
              [ named === statedSides fine
              , map (fmap length . piecesOf fine) named === map (const (Just 1)) named
              , map (uncovered fine) named === map (const 1) named
              , map (statedMaterial fine) named
                  === map (statedMaterial (meshScene mesh) . elementSide) (refinedElements cut)
              ]
    it "have names of their own" $
      forAllMeshes $ \mesh ->
        let cut = refined mesh
            names = map elementText (refinedElements cut)
         in (nub names, map (elementNames cut . elementIn) (refinedElements cut)) === (names, names)
    it "are whole sides where nothing is cut" $
      property $ \(TouchingScene s) ->
        let cut = unrefined (sampleScene s)
         in map inWords (refinedElements cut) === [(name, 0, 0, 1, name) | name <- statedSides (sampleScene s)]
  describe "form factors of elements" $ do
    it "add up over the elements that are reached to that of the side" $
      forAllMeshes $ \mesh ->
        forAll (elements (statedSides (meshScene mesh))) $ \side ->
          let from cut = Map.filterWithKey (\((s, _), _) _ -> s == side) (reaching cut)
              scene = meshScene mesh
              -- From the whole side, or its pieces; and from its elements.
              fromPieces = (from (refined (emptyMesh scene)), from (refined (cutOnly (`notElem` both) mesh)))
              fromElements = (from (refined (cutOnly (`elem` both) mesh)), from (refined mesh))
              both = side : otherFace scene side
           in conjoin [uncurry (===) fromPieces, uncurry (===) fromElements]
    it "by their lengths add up over the elements that light leaves to that of the side by its length" $
      forAllMeshes $ \mesh ->
        forAll (elements (statedSides (meshScene mesh))) $ \side ->
          let whole = leaving (unrefined (meshScene mesh))
              onlyFrom = Map.filterWithKey (\(s, _) _ -> s == side)
           in conjoin
                [ leaving (refined mesh) === whole
                , onlyFrom (leaving (refined (cutOnly (== side) mesh))) === onlyFrom whole
                ]
    it "close and are reciprocal, exactly" $
      forAllMeshes (lawful . refined)
    it "as Doubles are the nearest ones" $
      forAllMeshes $ \mesh -> let fine = refinedScene (refined mesh) in doublesOf fine === roundedOf fine
  describe "the scene of elements" $ do
    it "is swept as brute force finds its vertices" $
      forAllMeshes $ \mesh ->
        let fine = refinedScene (refined (few mesh)) in sort (vertices fine) === bruteForce fine
    it "obeys all laws of the complex" $
      forAllMeshes $ \mesh ->
        let fine = refinedScene (refined (few mesh)) in violations (build fine (vertices fine)) === []
    it "has elements of its own, the same ones" $
      forAllMeshes $ \mesh ->
        let cut = refined mesh
            once' = refined (emptyMesh (refinedScene cut))
         in (map (elementEnds once') (refinedElements once'), doublesOf (refinedScene once'))
              === (map (elementEnds cut) (refinedElements cut), doublesOf (refinedScene cut))
  where
    inWords e = (elementSide e, elementNumber e, elementFrom e, elementTo e, elementIn e)

-- | Scenes of all kinds with light in them, those beyond machine integers too, with the discontinuity mesh, with fewer
-- of its break points, or cut into equal parts.
forAllMeshes :: Testable check => (Mesh -> check) -> Property
forAllMeshes check =
  forAll (resize 8 kinds >>= furnished) $ \s ->
    forAllBlind (choose (1, 4) `suchThatMap` elementCount) $ \parts ->
      let scene = sampleScene s
          full = discontinuityMesh scene (vertices scene)
          meshes =
            [ ("discontinuity", full)
            , ("shadow limits", shadowLimits full)
            , ("bounded by " <> show parts, fst (bounded parts full))
            , ("uniform by " <> show parts, uniformMesh parts scene)
            ]
       in forAllBlind (elements meshes) $ \(name, mesh) -> counterexample name (check mesh)
  where
    kinds =
      frequency
        [ (3, (\(SmallScene s) -> s) <$> arbitrary)
        , (3, (\(TouchingScene s) -> s) <$> arbitrary)
        , (2, (\(LatticeScene s) -> s) <$> arbitrary)
        , (1, thinWalls)
        , (2, (\(HardScene s) -> s) <$> arbitrary `suchThat` small)
        ]
    -- Slender triangles come in numbers.
    small (HardScene s) = cornerCount (sampleScene s) <= 16
    -- Walls alone.
    thinWalls = arbitrary `suchThatMap` \(ConvexScene s) ->
      let raw = sampleRaw s
       in sample raw {rawPolygons = [p | p <- rawPolygons raw, rawForm p == Polyline]}

-- | At most two elements on a side, where there are many: for what costs much.
few :: Mesh -> Mesh
few mesh
  | cornerCount (meshScene mesh) + breakCount mesh <= 24 = mesh
  | otherwise = maybe mesh (\most -> fst (bounded most mesh)) (elementCount 2)

-- | The break points on some sides only.
cutOnly :: (SideName -> Bool) -> Mesh -> Mesh
cutOnly wanted mesh = mesh {breakTable = V.imap keep (breakTable mesh)}
  where
    keep s points = if wanted (sideName (meshScene mesh) (SideId s)) then points else []

-- | What is free of a side, as parts of it, in order.
freeParts :: Scene -> SideName -> [(Rational, Rational)]
freeParts scene side = sort [(min a b, max a b) | piece <- fromMaybe [] (piecesOf scene side), (a, b) <- [ends piece]]
  where
    ends piece = (at (sideStart piece), at (sideEnd scene piece))
    at = positionOn scene side . cornerPoint scene

-- | The other face of a side of a thin wall.
otherFace :: Scene -> SideName -> [SideName]
otherFace scene (SideName p k) =
  [ SideName p (2 * length (polygonPoints polygon) - 3 - k)
  | polygon <- scenePolygons scene
  , polygonId polygon == p
  , polygonForm polygon == Polyline
  ]

-- | A part of a side cut at the break points in it, and at those on the other face of a thin wall.
divided :: Mesh -> SideName -> (Rational, Rational) -> [(Rational, Rational)]
divided mesh side (a, b) = zip stops (drop 1 stops)
  where
    stops = nub (sort ([a, b] <> [t | t <- here <> there, a < t, t < b]))
    here = map breakParameter (breaksOf mesh side)
    there = [1 - breakParameter p | other <- otherFace (meshScene mesh) side, p <- breaksOf mesh other]

isOnLine :: (Point, Point) -> Point -> Bool
isOnLine (Point ax ay, Point bx by) (Point x y) = (bx - ax) * (y - ay) == (by - ay) * (x - ax)

-- | The form factors of elements with what they reach on the sides of the file.
factorsOf :: Refined -> [(Element, Seen, FormFactor)]
factorsOf cut =
  [ (e, maybe TheSky (TheSide . elementSide) (reached (factorTo f)), f)
  | f <- formFactors fine (measures fine (vertices fine))
  , Just e <- [Map.lookup (factorFrom f) byName]
  ]
  where
    fine = refinedScene cut
    byName = Map.fromList [(elementIn e, e) | e <- refinedElements cut]
    reached seen = case seen of
      TheSide name -> Map.lookup name byName
      TheSky -> Nothing

-- | From each element to all the elements of a side together: Σ F(s, t_k).
reaching :: Refined -> Map.Map ((SideName, Int), Seen) RootSum
reaching cut =
  Map.fromListWith
    (+)
    [(((elementSide e, elementNumber e), to), factorValue f) | (e, to, f) <- factorsOf cut]

-- | From all the elements of a side together to all those of another one: Σ |s_k| F(s_k, t).
leaving :: Refined -> Map.Map (SideName, Seen) RootSum
leaving cut =
  Map.fromListWith
    (+)
    [((elementSide e, to), byLength (refinedScene cut) f) | (e, to, f) <- factorsOf cut]

-- | |s| F(s, t); the length of a side is one root.
byLength :: Scene -> FormFactor -> RootSum
byLength scene f = mconcat (mapMaybe times (RootSum.terms (sideLength scene (factorFrom f))))
  where
    times (c, n) = timesRoot c n (factorValue f)

-- | Rows that add up to 1, measures that close, |s| F(s, t) = |t| F(t, s).
lawful :: Refined -> Property
lawful cut =
  conjoin
    [ counterexample "closure" $ [s | (s, defect) <- closureDefect fine sums, defect /= RootSum.zero] === []
    , counterexample "rows" $
        Map.fromListWith (+) [(factorFrom f, factorValue f) | f <- factors]
          === Map.fromList [(s, RootSum.rational 1) | s <- statedSides fine]
    , counterexample "reciprocity" $
        conjoin
          [ fmap (byLength fine) (Map.lookup (to, TheSide (factorFrom f)) table) === Just (byLength fine f)
          | f <- factors
          , TheSide to <- [factorTo f]
          ]
    ]
  where
    fine = refinedScene cut
    sums = measures fine (vertices fine)
    factors = formFactors fine sums
    table = Map.fromList [((factorFrom f, factorTo f), f) | f <- factors]
