-- | The laws of faces and their chains.
module Visibility.Complex.Law.Face
  ( faceLaws
  ) where

import Data.Maybe (isJust, isNothing)
import qualified Data.Vector.Unboxed as U
import Visibility.Complex.Law.Base
import Visibility.Complex.Reading
import Visibility.Complex.Table
import Visibility.Complex.Type
import Visibility.Count (facesBegun)
import Visibility.Exact.Predicate
import Visibility.Scene
import Visibility.Scene.Cone

-- | /Cost/ O(incidences) each.
faceLaws :: [Law Complex]
faceLaws =
  [ lawOf
      "a face has a stretch in its chains as often as the stretch has the face"
      "A stretch in a chain of a face has that face on the flank that the chain tells: above it in the lower chain, \
      \below it in the upper one, and the other way round after the end of the half turn. A face on a quarter of a \
      \stretch has the stretch in one such chain, once."
      incidence
  , lawOf
      "the chains of a bounded face lead from its first vertex to its last"
      "A bounded face has one first and one last vertex. Its upper and its lower chain begin at the first and end at \
      \the last, and each stretch begins where the one before it ends. Both go on over the end of the half turn, with \
      \the last stretch of their first part, or neither does; in that case the last vertex does not come later than \
      \the first, otherwise it does: so a face spans half a turn at most."
      $ \complex ->
        [ faceLabel complex f <> " from " <> vertexLabel complex from <> " to " <> vertexLabel complex to <> ": "
            <> fault
        | f <- faceIds complex
        , (Just from, Just to) <- [(faceFirst complex f, faceLast complex f)]
        , fault <- boundedChains complex f from to
        ]
  , lawOf
      "the lines that miss everything go around the scene"
      "Under the sky one face has no first and no last vertex, sees the sky at both ends and has no upper chain; its \
      \lower chain is closed: each stretch begins where the one before it ends, and the last stretch of each part, no \
      \other one, goes on over the end of the half turn. In a room all faces are bounded."
      $ \complex ->
        let outer = [f | f <- faceIds complex, isNothing (faceFirst complex f) || isNothing (faceLast complex f)]
            count = length outer
         in [show count <> " faces are not bounded: " <> show outer | count /= length (outerFace complex)]
              <> [faceLabel complex f <> ": " <> fault | f <- outer, fault <- outerChain complex f]
  , lawOf
      "an elementary pair begins one face and ends one"
      "Each vertex is the first vertex of as many bounded faces as it has elementary pairs, and the last vertex of as \
      \many. The pair of the two ends of a thin wall that nothing touches counts twice; of one that is touched, or has \
      \corners between its ends, each face has its own pairs."
      $ \complex ->
        let tally end =
              counted (vertexTotal complex) [v | f <- faceIds complex, Just (VertexId v) <- [end complex f]]
         in [ vertexLabel complex v <> " begins " <> show b <> " faces and ends " <> show e <> ", not " <> show want
            | (v, b, e) <- zip3 (vertexIds complex) (tally faceFirst) (tally faceLast)
            , let want = facesBegun (complexScene complex) (vertexAt complex v)
            , b /= want || e /= want
            ]
  , lawOf
      "the numbers of vertices, edges and faces fit"
      "V − E − B + F is W + 1 under the sky and W in a room: V vertices, E edges, B buried stretches, F \
      \faces, W straight walls that nothing touches, with corners between their ends or not. Contacts change nothing \
      \else: a corner in several cones of free space counts as often."
      $ \complex ->
        let euler = vertexTotal complex - stretchTotal complex + faceTotal complex
            expected = length (straightWalls (complexScene complex)) + length (outerFace complex)
         in ["V − E − B + F is " <> show euler <> ", not " <> show expected | euler /= expected]
  ]

incidence :: Complex -> [String]
incidence complex =
  [ faceLabel complex f <> " has in its chains " <> stretchLabel complex e <> ", which does not have it " <> show flank
  | Incident f e flank _ <- found
  , f `notElem` edgeFacesOn complex e flank
  ]
    <> [ stretchLabel complex e <> " is in the chains of " <> faceLabel complex f <> " " <> show times <> " times"
       | ((e, quarter), times) <- zip (map decoded [0 ..]) entered
       , Just f <- [faceAt complex e quarter]
       , times /= 1
       ]
  where
    found = chainIncidences complex
    entered =
      counted
        (4 * stretchTotal complex)
        [ code (e, quarter)
        | Incident f e flank _ <- found
        , quarter <- quartersOf flank
        , faceAt complex e quarter == Just f
        ]

-- | By number below a bound, how often it comes.
counted :: Int -> [Int] -> [Int]
counted bound found = U.toList (U.accum (+) (U.replicate bound 0) [(i, 1) | i <- found])

-- | What is wrong with the chains of a face that begins and ends at some vertices.
boundedChains :: Complex -> FaceId -> VertexId -> VertexId -> [String]
boundedChains complex f from to =
  [name <> " chain: " <> fault | (name, chain) <- [("upper", upper), ("lower", lower)], fault <- chainFaults chain]
    <> ["one chain goes on over the end of the half turn, the other does not" | goesOn upper /= goesOn lower]
    <> ["it spans more than half a turn" | goesOn upper == (compareLines complex from to == LT)]
  where
    (upper, lower) = (upperChain complex f, lowerChain complex f)
    goesOn (Chain before _) = any (wrapsAround complex) before
    chainFaults (Chain before after) =
      ["it does not begin at the first vertex" | map (edgeFirst complex) (take 1 whole) /= [from]]
        <> ["it does not end at the last vertex" | map (edgeLast complex) (lastOf whole) /= [to]]
        <> [ "it goes on over the end of the half turn wrongly"
           | null before || filter (wrapsAround complex) whole `notElem` (lastOf before : [[] | null after])
           ]
        <> gaps complex whole
      where
        whole = before <> after

-- | What is wrong with a face that has no vertex at one of its ends.
outerChain :: Complex -> FaceId -> [String]
outerChain complex f =
  ["it has a first or a last vertex" | isJust (faceFirst complex f) || isJust (faceLast complex f)]
    <> ["it sees a side" | faceBack complex f /= Sky || faceFront complex f /= Sky]
    <> ["it has an upper chain" | upperChain complex f /= Chain [] []]
    <> [ "a part of its lower chain goes on over the end of the half turn wrongly"
       | part <- [before, after]
       , null part || filter (wrapsAround complex) part /= lastOf part
       ]
    <> gaps complex (before <> after <> take 1 before)
  where
    Chain before after = lowerChain complex f

-- | Where a stretch of a chain does not begin where the one before it ends.
gaps :: Complex -> [EdgeId] -> [String]
gaps complex chain =
  [ stretchLabel complex b <> " does not follow " <> stretchLabel complex a
  | (a, b) <- zip chain (drop 1 chain)
  , edgeFirst complex b /= edgeLast complex a
  ]

lastOf :: [a] -> [a]
lastOf xs = drop (length xs - 1) xs

-- | The walks around walls that lie on one line: the first corner of each.
straightWalls :: Scene -> [CornerId]
straightWalls scene =
  [c | c <- filter (isWallEnd scene) (corners scene), walk <- [walkFrom c], all (>= c) walk, straight walk]
  where
    walkFrom c = c : takeWhile (/= c) (drop 1 (iterate (nextCorner scene) c))
    straight walk = and [onLine a b | (a, b) <- zip walk (drop 1 walk <> take 1 walk)]
    -- Flat, or an end: the sides before and after a corner are on one line.
    onLine a b = turned scene a b (nextCorner scene b) == Collinear
