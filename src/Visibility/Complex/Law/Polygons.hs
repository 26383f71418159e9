-- | What must hold of the complex of polygons. Each law is decided from its tables and the views of stretches; how the
-- tables were made does not matter.
module Visibility.Complex.Law.Polygons
  ( polygonLaws
  , isGeneral
  ) where

import Control.Monad (foldM)
import Data.List (elemIndex, nub, sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (isNothing)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Complex.Law.Base
import Visibility.Complex.Polygons
import Visibility.Complex.Type
import Visibility.Scene
import Visibility.Sorting
import Visibility.View (Flank (..), View (..))

-- | Does every tangent line touch exactly two polygons, each on one flank? Then moving the corners by little enough
-- changes nothing. The laws of the literature ask for this.
isGeneral :: Outlines -> Bool
isGeneral = all ((== 2) . length . touchedBy) . tangentLines

-- | All laws; all but the first two are about outlines, and hold where there are none.
--
-- /Requires/ the complex of polygons of a complex that satisfies its own laws. /Cost/ O(S log S) together, for S
-- stretches.
polygonLaws :: [Law PolygonComplex]
polygonLaws =
  [ law "quotient: regions partition the faces" "Every face is in exactly one region." $ \made ->
      orElse "a face is missing or in two regions" $
        sort (concatMap regionFaces (regions made)) == faceIds (sideComplex made)
  , law
      "quotient: labels of a region"
      "All faces of a region have the region's polygons at their ends, read one way or the other."
      memberLabels
  , onOutlines
      "quotient: tangencies of a vertex"
      "A vertex touches two different polygons or more; as many edges end as begin there: one for each flank touched."
      vertexEdges'
  , onOutlines
      "quotient: general vertex"
      "A vertex that touches two polygons on one flank each has 4 edges and 6 faces, as often as they are met."
      generalVertex
  , onOutlines
      "quotient: faces of an edge"
      "An edge has three faces, as often as they are met, the same all along it, with the polygons at their ends that \
      \the contact sees."
      edgeFaces
  , onOutlines
      "quotient: curves"
      "The edges of a polygon are one closed curve that goes over the end of the half turn twice."
      curves
  , onOutlines
      "quotient: chains"
      "Every bounded face has one first and one last vertex, and two chains of edges from one to the other; the chains \
      \of the lines that miss everything, or meet one polygon that is alone, are closed. An edge is in the chains of \
      \its three faces, once each, and in no others."
      chainsLink
  , onOutlines
      "quotient: numbers"
      "A vertex with t edges after it and w thin walls between its first and last tangency opens t − 1 + w faces and \
      \closes as many. So V − E + F = 1 + w, w summed over all vertices."
      numbersFit
  , onOutlines
      "quotient: numbers in general position"
      "If every vertex touches two polygons on one flank each: E = 2V, F = V + 1, V ≥ 4n − 4."
      $ \made found ->
        let (vs, es, fs) = sizes made found
            n = length (scenePolygons (complexScene (sideComplex made)))
            fits = es == 2 * vs && fs == vs + 1 && vs >= 4 * n - 4
         in orElse (show (vs, es, fs)) (n < 2 || not (isGeneral found) || fits)
  , onOutlines
      "quotient: cuts"
      "At every direction between those of vertices, 2n edges separate 3n + 1 faces, as often as they are met. A \
      \vertex opens as many of each as it closes, by other laws; so they are counted at the end of the half turn."
      $ \made found ->
        let n = length (scenePolygons (complexScene (sideComplex made)))
            turned = sum . map (arcTurns (sideComplex made))
            edges = turned (V.toList (arcs found))
            -- The unbounded face is met above all and below all, and has no upper chain.
            bounded = turned [arcOf found a | (a, _) <- concatMap upperArcs (boundaries found)]
         in orElse (show (edges, bounded)) (n < 1 || (edges, bounded) == (2 * n, 3 * n - 1))
  ]
  where
    onOutlines name statement check = law name statement (\made -> maybe [] (check made) (outlines made))

type Check = PolygonComplex -> Outlines -> [String]

orElse :: String -> Bool -> [String]
orElse text holds = [text | not holds]

sizes :: PolygonComplex -> Outlines -> (Int, Int, Int)
sizes made found = (V.length (tangentLines found), V.length (arcs found), V.length (regions made))

-- | The polygons that a line touches, with the flanks on which they lie just after it.
touchedBy :: TangentLine -> [(PolygonId, Flank)]
touchedBy line = [(tangencyPolygon t, flank) | t <- lineTangencies line, flank <- tangencyFlanks t]

-- | Thin walls on a line between its first and its last tangency.
wallsBetween :: TangentLine -> Int
wallsBetween line = length (filter ((== 2) . length . tangencyFlanks) (drop 1 (take (length touching - 1) touching)))
  where
    touching = lineTangencies line

numberedLines :: Outlines -> [(LineId, TangentLine)]
numberedLines = zip (map LineId [0 ..]) . V.toList . tangentLines

arcOf :: Outlines -> ArcId -> Arc
arcOf found (ArcId a) = arcs found V.! a

-- | The edges that begin or end at a vertex, in order; or those of closed curves, which do so nowhere.
arcsAt :: (Arc -> Maybe LineId) -> Outlines -> Maybe LineId -> [ArcId]
arcsAt end found = map ArcId . bucketOf table . place
  where
    table = bucketsBy (nowhere + 1) (U.fromList (map (fromIntegral . place . end) (V.toList (arcs found))))
    place = maybe nowhere (\(LineId i) -> i)
    nowhere = V.length (tangentLines found)

lineText :: PolygonComplex -> TangentLine -> String
lineText made = vertexLabel (sideComplex made) . lineVertex

arcText :: Arc -> String
arcText arc = unwords ["edge of", polygonText (arcPolygon arc), show (arcFlank arc), show (arcFirst arc, arcLast arc)]

-- | A face as it is met so many half turns later.
later :: Int -> Aspect -> Aspect
later more (Aspect r turns) = Aspect r (turns + more)

memberLabels :: PolygonComplex -> [String]
memberLabels made =
  [ show (r, f, own)
  | (r, region) <- zip [0 :: Int ..] (V.toList (regions made))
  , f <- regionFaces region
  , let own = (label (faceBack complex f), label (faceFront complex f))
  , own `notElem` [(regionBack region, regionFront region), (regionFront region, regionBack region)]
  ]
  where
    complex = sideComplex made
    label = polygonLabel (complexScene complex)

vertexEdges' :: Check
vertexEdges' made found = concatMap check (numberedLines found)
  where
    begun = map (\a -> (arcPolygon a, arcFlank a)) . edgesAt arcFirst
    ended = map (\a -> (arcPolygon a, endFlank made a)) . edgesAt arcLast
    edgesAt end = map (arcOf found) . arcsAt end found . Just
    check (i, line) =
      orElse (lineText made line <> ": " <> show touched) $
        length (nub (map fst touched)) >= 2
          && begun i == touched
          && sort (ended i) == sort touched
          && contacts == sort (nub contacts)
      where
        touched = touchedBy line
        contacts = map tangencyCorner (lineTangencies line)

-- | The flank on which the polygon of an edge lies where the edge ends.
endFlank :: PolygonComplex -> Arc -> Flank
endFlank made arc = flankAfter (arcTurns (sideComplex made) arc) (arcFlank arc)

generalVertex :: Check
generalVertex made found =
  [ lineText made line <> ": " <> show faces
  | (i, line) <- numberedLines found
  , length (touchedBy line) == 2
  , let faces = nub (map once (concatMap arcFaces (begun i) <> concatMap facesAfter (ended i)))
  , length faces /= 6
  ]
  where
    (begun, ended) = (edgesAt arcFirst, edgesAt arcLast)
    edgesAt end = map (arcOf found) . arcsAt end found . Just
    facesAfter a = map (later (arcTurns (sideComplex made) a)) (arcFaces a)
    -- The lines that miss everything come again after a full turn.
    once aspect@(Aspect r@(RegionId k) turns)
      | isNothing (firstLine (boundaries found V.! k)) = Aspect r (turns `mod` 2)
      | otherwise = aspect

edgeFaces :: Check
edgeFaces made found = concatMap check (arcs found)
  where
    complex = sideComplex made
    scene = complexScene complex
    label = polygonLabel scene
    regionOf =
      U.replicate (faceTotal complex) (-1)
        U.// [(f, r) | (r, region) <- zip [0 ..] (V.toList (regions made)), FaceId f <- regionFaces region]
    regionAt e q = (\(FaceId f) -> RegionId (regionOf U.! f)) <$> faceAt complex e q
    seenAs' (Aspect (RegionId r) turns)
      | odd turns = (regionFront region, regionBack region)
      | otherwise = (regionBack region, regionFront region)
      where
        region = regions made V.! r
    check arc =
      orElse (arcText arc <> ": not three faces") (length (nub (arcFaces arc)) == 3 && not (null (arcStretches arc)))
        <> concat (zipWith stretch passed (arcStretches arc))
      where
        -- The half turns from where the edge begins to each stretch.
        passed = scanl (+) 0 (map (fromEnum . wrapsAround complex) (arcStretches arc))
        own = OfPolygon (arcPolygon arc)
        stretch turns e = case edgeView complex e of
          Tangent flank back front ->
            orElse text $
              flank == flankAfter turns (arcFlank arc)
                && polygonOfCorner scene (edgeCorner complex e) == arcPolygon arc
                && map (Just . aspectRegion) faces == map (regionAt e) quarters
                && map seenAs' faces == [(label back, label front), (label back, own), (own, label front)]
            where
              quarters = case flank of
                Above -> [BelowBack, AboveBack, AboveFront]
                Below -> [AboveBack, BelowBack, BelowFront]
          _ -> [text]
          where
            text = arcText arc <> " at " <> stretchLabel complex e
            faces
              | odd turns = map (later turns) [arcAcross arc, arcFront arc, arcBack arc]
              | otherwise = map (later turns) (arcFaces arc)

curves :: Check
curves made found =
  [ "polygon " <> polygonText p
  | p <- map polygonId (scenePolygons (complexScene (sideComplex made)))
  , let own = Map.findWithDefault [] p byPolygon
  , let turns = sum (map (arcTurns (sideComplex made) . arcOf found) own)
  , turns /= 2 || not (and [goesAround a (length own) a | a <- take 1 own])
  ]
  where
    byPolygon = Map.fromListWith (<>) [(arcPolygon a, [ArcId i]) | (i, a) <- zip [0 ..] (V.toList (arcs found))]
    begun = arcsAt arcFirst found
    -- Does one come back to an edge after so many steps from another, not before?
    goesAround start steps a = case filter (follows (arcOf found a) . arcOf found) (begun (arcLast (arcOf found a))) of
      next : _ | next == start -> steps == 1
               | otherwise -> steps > (1 :: Int) && goesAround start (steps - 1) next
      [] -> False
    follows a b = arcPolygon a == arcPolygon b && endFlank made a == arcFlank b

chainsLink :: Check
chainsLink made found = concat (V.toList (V.imap check (boundaries found))) <> once
  where
    complex = sideComplex made
    isOuter r = any (isNothing . faceFirst complex) (regionFaces (regions made V.! r))
    check r (Boundary from to upper lower) = orElse ("face " <> show r) $ case (from, to) of
      (Just _, Just _) -> case (follow (from, 0) upper, follow (from, 0) lower) of
        (Just end, Just end') -> end == end' && fst end == to
        _ -> False
      (Nothing, Nothing)
        | isOuter r -> null upper && isClosed lower && all ((`elem` [0, 1]) . snd) (take 1 lower)
        | otherwise -> length (scenePolygons (complexScene complex)) == 1 && isClosed upper && isClosed lower
      _ -> False
    isClosed chain =
      or
        [ follow from chain == Just ((+ 2) <$> from)
        | (a, turns) <- take 1 chain
        , let from = (arcFirst (arcOf found a), turns)
        ]
    -- From a vertex, and how many half turns it comes later, along the edges of a chain.
    follow = foldM $ \from (a, turns) ->
      let arc = arcOf found a
       in if from == (arcFirst arc, turns) then Just (arcLast arc, turns + arcTurns complex arc) else Nothing

    -- Each entry of a chain is one of the three faces of its edge, from that flank; and each of these is met once.
    once = orElse "edges in chains" (U.all (== 1) (U.init counts) && U.last counts == 0)
    counts = U.accum (+) (U.replicate (others + 1) (0 :: Int)) (map (\i -> (i, 1)) met)
    others = 3 * V.length (arcs found)
    met =
      [ maybe others (3 * a +) (elemIndex seen (bounding (arcOf found (ArcId a))))
      | (r, boundary) <- zip [0 ..] (V.toList (boundaries found))
      , (chain, flank) <- [(upperArcs boundary, Below), (lowerArcs boundary, Above)]
      , (ArcId a, turns) <- chain
      , let seen = (Aspect (RegionId r) turns, flankAfter turns flank)
      ]
    bounding arc = zip (arcFaces arc) (flankAfter 1 (arcFlank arc) : repeat (arcFlank arc))

numbersFit :: Check
numbersFit made found =
  orElse (show (vs, es, fs)) (vs - es + fs == 1 + sum (fmap wallsBetween (tangentLines found)))
    <> [ lineText made line
       | (LineId i, line) <- numberedLines found
       , let expected = length (touchedBy line) - 1 + wallsBetween line
       , any ((/= expected) . (U.! i)) ends
       ]
  where
    (vs, es, fs) = sizes made found
    ends = [U.accum (+) (U.replicate vs 0) [(i, 1) | Just (LineId i) <- map end bounded] | end <- [firstLine, lastLine]]
    bounded = V.toList (boundaries found)
