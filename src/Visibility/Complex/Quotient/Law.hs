-- | What must hold of the polygon-labelled quotient. Each law is decided from the tables of the quotient and the views
-- of stretches; how the quotient was made does not matter.
module Visibility.Complex.Quotient.Law
  ( QuotientLaw (..)
  , quotientLaws
  , isGeneral
  ) where

import Data.List (groupBy, nub, sort, sortBy)
import qualified Data.Map.Strict as Map
import Data.Maybe (isNothing)
import qualified Data.Vector as V
import Visibility.Complex.Quotient.Type
import Visibility.Complex.Quotient.Union
import Visibility.Complex.Type
import Visibility.Exact.Predicate (compareDirections)
import Visibility.Law
import Visibility.Scene
import Visibility.Sweep.Vertex
import Visibility.View (Flank (..), View (..))

-- | A law with its name, its statement, and a check that finds all that breaks it.
data QuotientLaw = QuotientLaw
  { quotientLawName :: !String
  , quotientLawStatement :: !String
  , quotientLawViolations :: Quotient -> [Violation]
  }

-- | Does every tangent line touch exactly two polygons, each on one flank? Then moving the corners by little enough
-- changes nothing. The laws of the literature ask for this.
isGeneral :: Convex -> Bool
isGeneral convex = all ((== 2) . length . lineArcs) (tangentLines convex)

-- | All laws of quotients; all but the first two are about those of convex scenes and hold of others in an empty way.
--
-- /Requires/ a quotient of a complex that satisfies its own laws. /Cost/ O(S log S) together, for S stretches.
quotientLaws :: [QuotientLaw]
quotientLaws =
  [ law "quotient: regions partition the faces" "Every face is in exactly one region." partition
  , law
      "quotient: labels of a region"
      "All faces of a region have the region's polygons at their ends, read one way or the other."
      memberLabels
  , onConvex
      "quotient: tangencies of a vertex"
      "A vertex touches two different polygons or more; as many edges end as begin there: one for each flank touched."
      vertexEdgesLaw
  , onConvex
      "quotient: general vertex"
      "A vertex that touches two polygons on one flank each has 4 edges and 6 faces, as often as they are met."
      generalVertexLaw
  , onConvex
      "quotient: faces of an edge"
      ( "An edge has three faces, as often as they are met, the same all along it, with the polygons at their ends "
          <> "that the contact sees."
      )
      edgeFacesLaw
  , onConvex
      "quotient: curves"
      "The edges of a polygon are one closed curve that goes over the end of the half turn twice."
      curveLaw
  , onConvex
      "quotient: chains"
      ( "Every bounded face has one first and one last vertex, and two chains of edges from one to the other; an edge "
          <> "is in the chains of its three faces, once each, and in no others."
      )
      chainLaw
  , onConvex
      "quotient: numbers"
      ( "A vertex with t edges after it and w thin walls between its first and last tangency opens t − 1 + w "
          <> "faces and closes as many. So for two polygons or more V − E + F = 1 + w, w summed over all vertices; one "
          <> "polygon has F = 2."
      )
      numbersLaw
  , onConvex
      "quotient: numbers in general position"
      "If every vertex touches two polygons on one flank each: E = 2V, F = V + 1, V ≥ 4n − 4."
      generalNumbersLaw
  , onConvex
      "quotient: cuts"
      "At every direction between those of vertices, 2n edges separate 3n + 1 faces, as often as they are met."
      cutLaw
  ]
  where
    law name statement check = QuotientLaw name statement (check name)
    onConvex name statement check = QuotientLaw name statement (ofConvex (check name))
    ofConvex check (ConvexQuotient complex union convex) = check complex union convex
    ofConvex _ (UnionQuotient _ _) = []

complexOf :: Quotient -> Complex
complexOf (ConvexQuotient complex _ _) = complex
complexOf (UnionQuotient complex _) = complex

partition :: String -> Quotient -> [Violation]
partition name found =
  ensure name "a face is missing or in two regions" (sort (concatMap snd listed) == faceIds (complexOf found))
    <> [ Violation name (show (f, r))
       | (r, fs) <- listed
       , f <- fs
       , regionOf union f /= r
       ]
  where
    union = quotientUnion found
    listed = [(r, regionMembers union r) | r <- regionIds found]

memberLabels :: String -> Quotient -> [Violation]
memberLabels name found =
  [ Violation name (show (r, f, ends, own))
  | r <- regionIds found
  , let ends@(back, front) = regionPolygons found r
  , f <- regionMembers (quotientUnion found) r
  , let own = (label (faceBack complex f), label (faceFront complex f))
  , own /= ends && own /= (front, back)
  ]
  where
    complex = complexOf found
    label = polygonLabel (complexScene complex)

-- | A check of the quotient of a convex scene, given the name of its law.
type Check = String -> Complex -> Union -> Convex -> [Violation]

-- | A vertex by the names of its corners.
lineText :: Complex -> Convex -> LineId -> String
lineText complex convex i =
  unwords (map (cornerText . cornerName (complexScene complex)) (vertexCorners (vertexAt complex v)))
  where
    v = lineVertex (lineOf convex i)

arcText :: Complex -> Convex -> ArcId -> String
arcText complex convex a =
  unwords
    [ show a
    , polygonText (arcPolygon arc)
    , show (arcFlank arc)
    , "from"
    , lineText complex convex (arcFirst arc)
    , "to"
    , lineText complex convex (arcLast arc)
    ]
  where
    arc = arcOf convex a

vertexEdgesLaw :: Check
vertexEdgesLaw name complex _ convex = concatMap check (lineIds convex)
  where
    ending = Map.fromListWith (<>) [(arcLast arc, [flankAtEnd complex arc]) | arc <- V.toList (arcs convex)]
    check i =
      ensure name text (length (nub (map fst touched)) >= 2)
        <> ensure name (text <> ": " <> show begun) (begun == touched)
        <> ensure name (text <> ": " <> show ended) (ended == sort touched)
        <> ensure name (text <> ": order of contacts") (contacts == sort (nub contacts))
      where
        text = lineText complex convex i
        line = lineOf convex i
        contacts = map tangencyCorner (lineTangencies line)
        touched = [(tangencyPolygon t, flank) | t <- lineTangencies line, flank <- touchFlanks (tangencyTouch t)]
        begun = [(arcPolygon arc, arcFlank arc) | a <- lineArcs line, let arc = arcOf convex a, arcFirst arc == i]
        ended = sort (Map.findWithDefault [] i ending)

-- | The polygon of an edge and the flank on which it lies where the edge ends.
flankAtEnd :: Complex -> Arc -> (PolygonId, Flank)
flankAtEnd complex arc = (arcPolygon arc, flankAfter (arcTurns complex arc) (arcFlank arc))

-- | A flank as it is read after so many half turns.
flankAfter :: Int -> Flank -> Flank
flankAfter turns flank
  | not (isBackwards turns) = flank
  | flank == Above = Below
  | otherwise = Above

-- | A face as it is met so many half turns later.
later :: Int -> Aspect -> Aspect
later more (Aspect r turns) = Aspect r (turns + more)

generalVertexLaw :: Check
generalVertexLaw name complex _ convex =
  [ Violation name (lineText complex convex i <> ": " <> show faces)
  | i <- lineIds convex
  , let begun = lineArcs (lineOf convex i)
  , length begun == 2
  , let ended = Map.findWithDefault [] i ending
  , let faces = nub (map once (concatMap (facesAfter 0) begun <> concatMap (\a -> facesAfter (turnsOf a) a) ended))
  , length faces /= 6
  ]
  where
    ending = Map.fromListWith (<>) [(arcLast (arcOf convex a), [a]) | a <- arcIds convex]
    -- The lines that miss everything come again after a full turn.
    once aspect@(Aspect r turns)
      | isNothing (regionFirst (regionIn convex r)) = Aspect r (turns `mod` 2)
      | otherwise = aspect
    turnsOf = arcTurns complex . arcOf convex
    facesAfter turns = map (later turns) . arcFaces . arcOf convex

arcFaces :: Arc -> [Aspect]
arcFaces arc = [arcAcross arc, arcBack arc, arcFront arc]

edgeFacesLaw :: Check
edgeFacesLaw name complex union convex = concatMap check (arcIds convex)
  where
    scene = complexScene complex
    label = polygonLabel scene
    check a =
      ensure name (text <> ": not three faces") (length (nub (arcFaces arc)) == 3)
        <> ensure name (text <> ": no stretch") (not (null (arcStretches arc)))
        <> concat (zipWith (stretch arc text) passed (arcStretches arc))
      where
        arc = arcOf convex a
        text = arcText complex convex a
        -- The half turns from where the edge begins to each stretch.
        passed = scanl (+) 0 (map (fromEnum . wrapsAround complex) (arcStretches arc))
    stretch arc text turns e = case edgeView complex e of
      Tangent flank back front ->
        concat
          [ law "flank" (flank == flankAfter turns (arcFlank arc))
          , law "polygon" (polygonOfCorner scene (edgeCorner complex e) == arcPolygon arc)
          , law "faces" $
              map (Just . aspectRegion) faces == [regionOf union <$> faceAt complex e q | q <- quarters flank]
          , law "labels" (map (aspectPolygons convex) faces == [(b, f), (b, own), (own, f)])
          ]
        where
          (b, f) = (label back, label front)
      found -> law (show found) False
      where
        law what = ensure name (text <> ": " <> what <> " at " <> show e)
        own = OfPolygon (arcPolygon arc)
        faces
          | isBackwards turns = map (later turns) [arcAcross arc, arcFront arc, arcBack arc]
          | otherwise = map (later turns) (arcFaces arc)
    quarters flank = case flank of
      Above -> [BelowBack, AboveBack, AboveFront]
      Below -> [AboveBack, BelowBack, BelowFront]

curveLaw :: Check
curveLaw name complex _ convex = concatMap check (scenePolygons (complexScene complex))
  where
    byPolygon = Map.fromListWith (flip (<>)) [(arcPolygon arc, [arc]) | arc <- V.toList (arcs convex)]
    closed = Map.fromListWith (<>) [(curvePolygon curve, [curve]) | curve <- closedCurves convex]
    check polygon = case (Map.lookup p byPolygon, Map.lookup p closed) of
      (Just own, Nothing) -> ensure name text (isCurve own)
      (Nothing, Just [curve]) ->
        ensure name text (length (filter (wrapsAround complex) (curveStretches curve)) == 2)
          <> ensure name text (curveAcross curve /= curveParts curve)
      (own, curves) -> [Violation name (text <> ": " <> show (own, curves))]
      where
        p = polygonId polygon
        text = polygonText p
    isCurve own =
      sort (map start own) == sort (map end own)
        && sum (map (arcTurns complex) own) == 2
        && length (cycleFrom own) == length own
    start arc = (arcFirst arc, arcFlank arc)
    end arc = (arcLast arc, snd (flankAtEnd complex arc))
    -- From one edge to the next, until the first comes again.
    cycleFrom own = case own of
      first : _ -> first : takeWhile ((/= start first) . start) (steps (length own) (next first))
      [] -> []
      where
        starts = Map.fromList [(start arc, arc) | arc <- own]
        next arc = Map.lookup (end arc) starts
        steps :: Int -> Maybe Arc -> [Arc]
        steps count (Just arc) | count > 0 = arc : steps (count - 1) (next arc)
        steps _ _ = []

chainLaw :: Check
chainLaw name complex _ convex = concatMap check numbered <> once
  where
    several = length (scenePolygons (complexScene complex)) >= 2
    numbered = [(r, region) | (r, region) <- zip (map RegionId [0 ..]) (V.toList (regions convex))]
    unbounded = [r | (r, region) <- numbered, any (isNothing . faceFirst complex) (regionFaces region)]
    check (r, region)
      | not several = []
      | [r] == unbounded = ensure name (text <> ": closed chain") (closedChain region)
      | otherwise = case (regionFirst region, regionLast region) of
          (Just from, Just to) ->
            ensure name (text <> ": upper chain") (chainBetween from to (regionUpper region))
              <> ensure name (text <> ": lower chain") (chainBetween from to (regionLower region))
              <> ensure name (text <> ": span") (turnsOf (regionUpper region) == turnsOf (regionLower region))
          _ -> [Violation name (text <> ": first and last vertex")]
      where
        text = show r
    arc = arcOf convex
    turnsOf = sum . map (arcTurns complex . arc) . arcsOfChain
    chainBetween from to chain =
      map (arcFirst . arc) (take 1 edges) == [from]
        && map (arcLast . arc) (take 1 (reverse edges)) == [to]
        && linked chain
        && startsAt 0 chain
      where
        edges = arcsOfChain chain
    closedChain region =
      isNothing (regionFirst region)
        && isNothing (regionLast region)
        && null (arcsOfChain (regionUpper region))
        && linked (ArcChain (found <> [(a, turns + 2) | (a, turns) <- take 1 found]))
        && (startsAt 0 (regionLower region) || startsAt 1 (regionLower region))
        && turnsOf (regionLower region) == 2
      where
        ArcChain found = regionLower region
    linked (ArcChain found) = and (zipWith follows found (drop 1 found))
    startsAt turns (ArcChain found) = map snd (take 1 found) == [turns]
    follows (a, turns) (b, turns') = arcLast (arc a) == arcFirst (arc b) && turns + arcTurns complex (arc a) == turns'

    -- Which face bounds which edge from where, by the chains and by the edges.
    once = ensure name "edges in chains" (not several || sort byChains == sort byEdges)
    byChains =
      [ (a, Aspect r turns, flankAfter turns flank)
      | (r, region) <- numbered
      , (ArcChain found, flank) <- [(regionUpper region, Below), (regionLower region, Above)]
      , (a, turns) <- found
      ]
    byEdges =
      [ (a, aspect, flank)
      | a <- arcIds convex
      , let own = arcFlank (arc a)
      , (aspect, flank) <- zip (arcFaces (arc a)) [flankAfter 1 own, own, own]
      ]

numbersLaw :: Check
numbersLaw name complex _ convex
  | length (scenePolygons (complexScene complex)) == 1 =
      ensure name (show counts) (counts == (0, 0, 2) && length (closedCurves convex) == 1)
  | otherwise =
      ensure name (show counts) (vs - es + fs == 1 + sum (map wallsBetween (lineIds convex)))
        <> ensure name "a curve without a vertex" (null (closedCurves convex))
        <> [ Violation name (lineText complex convex i)
           | i <- lineIds convex
           , let expected = length (lineArcs (lineOf convex i)) - 1 + wallsBetween i
           , Map.findWithDefault 0 i opened /= expected || Map.findWithDefault 0 i closed /= expected
           ]
  where
    counts@(vs, es, fs) = sizes convex
    wallsBetween i = case drop 1 (map tangencyTouch (lineTangencies (lineOf convex i))) of
      [] -> 0
      touches -> length (filter (== BothFlanks) (take (length touches - 1) touches))
    opened = Map.fromListWith (+) [(i, 1 :: Int) | region <- V.toList (regions convex), Just i <- [regionFirst region]]
    closed = Map.fromListWith (+) [(i, 1 :: Int) | region <- V.toList (regions convex), Just i <- [regionLast region]]

sizes :: Convex -> (Int, Int, Int)
sizes convex = (V.length (tangentLines convex), V.length (arcs convex), V.length (regions convex))

generalNumbersLaw :: Check
generalNumbersLaw name complex _ convex
  | n >= 2 && isGeneral convex = ensure name (show counts) (es == 2 * vs && fs == vs + 1 && vs >= 4 * n - 4)
  | otherwise = []
  where
    n = length (scenePolygons (complexScene complex))
    counts@(vs, es, fs) = sizes convex

cutLaw :: Check
cutLaw name complex _ convex
  | n < 2 = []
  | otherwise =
      [ Violation name (place <> ": " <> show (edges, faces))
      | (place, edges, faces) <- ("before all vertices", edgesAt, facesAt) : passing edgesAt facesAt groups
      , edges /= 2 * n || faces /= 3 * n - 1
      ]
  where
    n = length (scenePolygons (complexScene complex))
    edgesAt = sum (map (arcTurns complex) (V.toList (arcs convex)))
    -- The bounded faces, as often as the end of the half turn cuts them. The unbounded one is met above all and below
    -- all.
    facesAt =
      sum
        [ sum (map (arcTurns complex . arcOf convex) (arcsOfChain (regionUpper region)))
        | region <- V.toList (regions convex)
        ]
    groups =
      groupBy (\a b -> compareDirections (fst a) (fst b) == EQ) $
        sortBy
          (\a b -> compareDirections (fst a) (fst b))
          [ (edgeFrom complex e, i)
          | i <- lineIds convex
          , e : _ <- [vertexEdgesAfter complex (lineVertex (lineOf convex i))]
          ]
    passing :: Int -> Int -> [[(a, LineId)]] -> [(String, Int, Int)]
    passing _ _ [] = []
    passing edges faces (group : rest) = (place, edges', faces') : passing edges' faces' rest
      where
        at table = sum [Map.findWithDefault 0 i table | (_, i) <- group]
        edges' = edges + at begun - at ended
        faces' = faces + at opened - at closed
        place = concat ["after " <> lineText complex convex i | (_, i) <- take 1 group]
    count found = Map.fromListWith (+) [(i, 1 :: Int) | i <- found]
    begun = count (map arcFirst (V.toList (arcs convex)))
    ended = count (map arcLast (V.toList (arcs convex)))
    opened = count [i | region <- V.toList (regions convex), Just i <- [regionFirst region]]
    closed = count [i | region <- V.toList (regions convex), Just i <- [regionLast region]]
