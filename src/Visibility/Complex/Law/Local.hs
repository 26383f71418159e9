-- | The laws of the complex around one stretch or one vertex.
module Visibility.Complex.Law.Local
  ( localLaws
  , raysConfirm
  ) where

import Data.List (nub)
import Data.Maybe (isJust)
import Data.Tuple (swap)
import Visibility.Complex.Law.Base
import Visibility.Complex.Reading
import Visibility.Complex.Table
import Visibility.Complex.Type
import Visibility.Exact.Predicate
import Visibility.Ray
import Visibility.Scene
import Visibility.Scene.Cone
import Visibility.Sweep.Vertical (solid)
import Visibility.View (End (..), Flank (..), View (..))

-- | The numbers of the second law are derived in docs\/complex.md. /Cost/ O(stretches) each.
localLaws :: [Law Complex]
localLaws =
  [ lawOf
      "a ray is solid where it enters the solid at its corner"
      "During a stretch the rays of its corner that enter the solid there, by the two sides of the corner, are those \
      \that the view leaves out, and the following corner is on the flank that the table says: just after the vertex \
      \where the stretch begins and just before the one where it ends. So the edges of a corner cover exactly the \
      \directions in which it is not buried."
      solidEnds
  , lawOf
      "a vertex has the edges and faces that its corners demand"
      "At each corner of a vertex, just before and just after it, 3, 2 or 1 faces meet where 2, 1 or none of the \
      \corner's rays are free, and none free means no edge. A stretch has as many faces; a vertex has as many edges as \
      \there are free corners before and after, and as many faces as the sum over its corners, before as after. Two \
      \corners: 4 edges and 6 faces where both are tangent, 5 for tangent and ending, 4 for ending and ending; on a \
      \side 4 and 5 between convex corners, 3 and 4 between a convex and a reflex one, 2 and 3 between reflex ones."
      degrees
  , lawOf
      "the faces at a stretch see what its view demands"
      "With the side that leaves the corner and the one that arrives there, the view tells the objects at the back and \
      \at the front on each quarter. The face there has them, read as the stretch is where the face has it before the \
      \end of the half turn, and backwards where it has it after; no face where the solid is."
      stretchLabels
  ]

solidEnds :: Complex -> [String]
solidEnds complex =
  [ stretchLabel complex e <> ", at its " <> place <> ": the rays " <> show found <> ", the tables " <> show told
  | e <- stretchIds complex
  , let isSolid table = numberAt (table complex) e == solid
  , let told = (isSolid stretchBacks, isSolid stretchFronts, flankOf e)
  , let c = edgeCorner complex e
  , (place, moment, d) <- [("beginning", JustAfter, edgeFrom complex e), ("end", JustBefore, turnedTo complex e)]
  , let found = (entersSolid scene moment c (reversed d), entersSolid scene moment c d, nextFlank scene moment c d)
  , found /= told
  ]
  where
    scene = complexScene complex
    flankOf e = if numberAt (stretchFlanks complex) e == 1 then Above else Below

-- | The direction where a stretch ends, reached from its beginning by turning left.
turnedTo :: Complex -> EdgeId -> Direction
turnedTo complex e = (if wrapsAround complex e then reversed else id) (edgeTo complex e)

degrees :: Complex -> [String]
degrees complex = concatMap stretch (stretchIds complex) <> concatMap vertex (vertexIds complex)
  where
    scene = complexScene complex
    read' = readings complex
    free moment d c = length (filter (not . entersSolid scene moment c) [d, reversed d])
    stretch e =
      [ stretchLabel complex e <> " has " <> show have <> " faces, not " <> show want
      | let have = length (nub (concatMap (edgeFacesOn complex e) [Above, Below]))
      , let want = 1 + free JustAfter (edgeFrom complex e) (edgeCorner complex e)
      , have /= want
      ]
    vertex v =
      [ vertexLabel complex v <> " has " <> show have <> " edges and faces, not " <> show want
          <> (if sum before == sum after then "" else ", and " <> show (sum after) <> " faces after it")
      | let d = vertexLine complex v
      , let before = map ((+ 1) . free JustBefore d) (cornersOf complex v)
      , let after = map ((+ 1) . free JustAfter d) (cornersOf complex v)
      , let want = (length (filter (> 1) (before <> after)), sum before)
      , let have = (length (vertexEdges complex v), length (nub (around v)))
      , have /= want || sum before /= sum after
      ]
    around v = concatMap (places id) (vertexEdgesAfter complex v) <> concatMap ending (vertexEdgesAfter complex v)
    ending after = let e = edgeBefore complex after in places (turnedIn e) e
    turnedIn e = if wrapsAround complex e then opposed else id
    places turn' e =
      [(f, turn' <$> readingAt read' e q) | q <- [minBound ..], Just f <- [faceAt complex e q]]
    opposed Forwards = Backwards
    opposed Backwards = Forwards

stretchLabels :: Complex -> [String]
stretchLabels complex =
  [ stretchLabel complex e <> " has " <> show quarter <> " " <> maybe "no face" (faceLabel complex) f
      <> (if reading == Just Backwards then " read backwards" else "")
      <> ", not "
      <> maybe "no face" (\(b, t) -> objectLabel complex (Just b) <> ", " <> objectLabel complex (Just t)) want
  | e <- stretchIds complex
  , (quarter, want) <- demands (complexScene complex) (edgeCorner complex e) (edgeView complex e)
  , let f = faceAt complex e quarter
  , let reading = readingAt read' e quarter
  , maybe (isJust want) (\i -> want `notElem` map Just (labels i reading)) f
  ]
  where
    read' = readings complex
    labels f reading = [label | (how, label) <- [(Forwards, seen), (Backwards, swap seen)], all (== how) reading]
      where
        seen = (faceBack complex f, faceFront complex f)

-- | The objects at back and front on each quarter of a corner's line under a view.
demands :: Scene -> CornerId -> View Object -> [(Quarter, Maybe (Object, Object))]
demands scene c view = zip [AboveBack, AboveFront, BelowBack, BelowFront] $ case view of
  Tangent Above b f -> [Just (b, arriving), Just (leaving, f), Just (b, f), Just (b, f)]
  Tangent Below b f -> [Just (b, f), Just (b, f), Just (b, leaving), Just (arriving, f)]
  Ending Front b -> [Just (b, arriving), Nothing, Just (b, leaving), Nothing]
  Ending Back f -> [Nothing, Just (leaving, f), Nothing, Just (arriving, f)]
  Buried Above -> [Just (leaving, arriving), Just (leaving, arriving), Nothing, Nothing]
  Buried Below -> [Nothing, Nothing, Just (arriving, leaving), Just (arriving, leaving)]
  where
    CornerId start = c
    CornerId previous = previousCorner scene c
    leaving = Side (SideId start)
    arriving = Side (SideId previous)

-- | /Cost/ two rays for each stretch ('viewFrom').
raysConfirm :: Law Complex
raysConfirm =
  lawOf
    "rays confirm every view"
    "Rays shot from the corner at a direction within each stretch, backward and forward, see what the view says. A \
    \stretch that goes on over the end of the half turn is tried before it and after it."
    $ \complex ->
      let rays = raysIn (complexScene complex)
       in [ stretchLabel complex e <> " sees " <> shown complex told <> ", but rays along " <> show (x, y) <> " see "
              <> shown complex seen
          | e <- stretchIds complex
          , let told = edgeView complex e
          , d@(Direction x y) <- samplesOf complex e
          , let seen = viewFrom rays (edgeCorner complex e) d
          , told /= seen
          ]
  where
    shown complex view = case view of
      Tangent flank b f -> objects complex [b, f] <> ", tangent to the polygon " <> show flank
      Ending Front b -> objects complex [b] <> " at the back only"
      Ending Back f -> objects complex [f] <> " in front only"
      Buried flank -> "nothing, buried with its free cone " <> show flank
    objects complex = unwords . map (objectLabel complex . Just)

-- | Directions within a stretch, reached from its beginning by turning left: one, or one before the end of the half
-- turn and one after it.
samplesOf :: Complex -> EdgeId -> [Direction]
samplesOf complex e
  | wrapsAround complex e = [between from upwards | directionTurn from upwards /= Collinear] <> [between upwards to]
  | otherwise = [between from to]
  where
    from = edgeFrom complex e
    to = turnedTo complex e
