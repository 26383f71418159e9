-- | The laws of faces and their chains.
module Visibility.Complex.Law.Face
  ( incidence
  , boundedChains
  , outerChain
  , pairFaces
  , counts
  ) where

import Data.Maybe (isJust)
import qualified Data.Vector.Unboxed as U
import Visibility.Complex.Law.Base
import Visibility.Complex.Reading
import Visibility.Complex.Table
import Visibility.Complex.Type
import Visibility.Exact.Predicate
import Visibility.Scene

-- | /Cost/ O(incidences).
incidence :: Law Complex
incidence =
  lawOf
    "a face has a stretch in its chains as often as the stretch has the face"
    "A stretch in a chain of a face has that face on the flank that the chain tells: above it in the lower chain, \
    \below it in the upper one, and the other way round after the end of the half turn. A face on a quarter of a \
    \stretch has the stretch in one such chain, once."
    check
  where
    check complex =
      [ faceLabel complex f <> " has in its chains " <> stretchLabel complex e <> ", which does not have it "
          <> show flank
      | Incident (FaceId f) (EdgeId e) flank _ <- found
      , FaceId f `notElem` edgeFacesOn complex (EdgeId e) flank
      ]
        <> [ stretchLabel complex (q `quot` 4) <> " is in the chains of " <> faceLabel complex f <> " "
               <> show times
               <> " times"
           | (q, times) <- zip [0 ..] (U.toList entered)
           , Just (FaceId f) <- [at (stretchFaces complex) (decoded q)]
           , times /= 1
           ]
      where
        found = chainIncidences complex
        entered =
          U.accum
            (+)
            (U.replicate (4 * stretchTotal complex) (0 :: Int))
            [ (4 * raw e + fromEnum quarter, 1)
            | Incident f e flank _ <- found
            , quarter <- quartersOf flank
            , faceAt complex e quarter == Just f
            ]

isBounded :: Complex -> Int -> Bool
isBounded complex f = isJust (faceFirst complex (FaceId f)) && isJust (faceLast complex (FaceId f))

-- | /Cost/ O(incidences).
boundedChains :: Law Complex
boundedChains =
  lawOf
    "the chains of a bounded face lead from its first vertex to its last"
    "A bounded face has one first and one last vertex. Its upper and its lower chain begin at the first and end at the \
    \last, each stretch begins where the one before it ends, and directions increase. Both go on over the end of the \
    \half turn, with the last stretch of their first part, or neither does; in that case the last vertex does not come \
    \later than the first, otherwise it does: so a face spans half a turn at most."
    $ \complex ->
      [ faceLabel complex f <> " from " <> vertexLabel complex (entry (faceFirsts complex) f) <> " to "
          <> vertexLabel complex (entry (faceLasts complex) f)
          <> ": "
          <> fault
      | f <- [0 .. faceTotal complex - 1]
      , isBounded complex f
      , fault <- faultsOf complex f
      ]
  where
    faultsOf complex f = chainFaults "upper" upper <> chainFaults "lower" lower <> span'
      where
        first = entry (faceFirsts complex) f
        final = entry (faceLasts complex) f
        upper = upperChain complex (FaceId f)
        lower = lowerChain complex (FaceId f)
        goesOn (Chain before _) = any (wrapsAround complex) before
        span'
          | goesOn upper /= goesOn lower = ["one chain goes on over the end of the half turn, the other does not"]
          | goesOn upper == (compareLines complex first final == LT) = ["the last vertex comes later than half a turn"]
          | otherwise = []
        chainFaults name (Chain before after) =
          [name <> " chain: " <> text | text <- chainFault (before <> after) before after]
        chainFault whole before after
          | null before = ["no stretch begins it"]
          | map (startOf complex) (take 1 whole) /= [first] = ["it does not begin at the first vertex"]
          | map (endOf complex) (lastOf whole) /= [final] = ["it does not end at the last vertex"]
          | otherwise =
              [ stretchLabel complex (raw b) <> " does not follow " <> stretchLabel complex (raw a)
              | (a, b) <- zip whole (drop 1 whole)
              , startOf complex b /= endOf complex a
              ]
                <> [ stretchLabel complex (raw e) <> " does not end later than it begins"
                   | e <- whole
                   , not (wrapsAround complex e)
                   , compareLines complex (startOf complex e) (endOf complex e) /= LT
                   ]
                <> [ "it goes on over the end of the half turn before its first part ends"
                   | any (wrapsAround complex) (take (length before - 1) before)
                   ]
                <> [ "its first part does not go on over the end of the half turn"
                   | not (null after)
                   , not (all (wrapsAround complex) (lastOf before))
                   ]
                <> ["it goes on over the end of the half turn twice" | any (wrapsAround complex) after]

raw :: EdgeId -> Int
raw (EdgeId e) = e

lastOf :: [a] -> [a]
lastOf = foldl (\_ x -> [x]) []

-- | /Cost/ O(incidences of that face).
outerChain :: Law Complex
outerChain =
  lawOf
    "the lines that miss everything go around the scene"
    "Under the sky one face has no first and no last vertex, sees the sky at both ends and has no upper chain; its \
    \lower chain is closed: each stretch begins where the one before it ends, in both parts by increasing direction, \
    \and the last stretch of each part goes on over the end of the half turn. In a room all faces are bounded."
    $ \complex ->
      let outer = [f | f <- [0 .. faceTotal complex - 1], not (isBounded complex f)]
          expected = case surroundings (complexScene complex) of OpenSky -> 1; Room -> 0
       in [ show (length outer) <> " faces are not bounded: " <> unwords (map show outer)
          | length outer /= expected
          ]
            <> [faceLabel complex f <> ": " <> fault | f <- outer, fault <- faultsOf complex f]
  where
    faultsOf complex f =
      [ "it has a first or a last vertex"
      | isJust (faceFirst complex (FaceId f)) || isJust (faceLast complex (FaceId f))
      ]
        <> ["it sees a side" | faceBack complex (FaceId f) /= Sky || faceFront complex (FaceId f) /= Sky]
        <> ["it has an upper chain" | upperChain complex (FaceId f) /= Chain [] []]
        <> ["a part of its lower chain is empty" | null before || null after]
        <> [ stretchLabel complex (raw b) <> " does not follow " <> stretchLabel complex (raw a)
           | (a, b) <- zip whole (drop 1 whole <> take 1 whole)
           , startOf complex b /= endOf complex a
           ]
        <> [ stretchLabel complex (raw e) <> " goes on over the end of the half turn or not, wrongly"
           | part <- [before, after]
           , (e, isLast) <- zip (reverse part) (True : repeat False)
           , wrapsAround complex e /= isLast
           ]
      where
        Chain before after = lowerChain complex (FaceId f)
        whole = before <> after

-- | /Cost/ O(faces + stretches).
pairFaces :: Law Complex
pairFaces =
  lawOf
    "an elementary pair begins one face and ends one"
    "Each vertex is the first vertex of as many bounded faces as it has elementary pairs, and the last vertex of as \
    \many. The pair of the two ends of a thin wall that nothing touches counts twice; of one that is touched, or has \
    \corners between its ends, each face has its own pairs."
    $ \complex ->
      let tally end =
            U.accum
              (+)
              (U.replicate (vertexTotal complex) (0 :: Int))
              [(v, 1) | f <- faceIds complex, Just (VertexId v) <- [end complex f]]
          begun = tally faceFirst
          ended = tally faceLast
       in [ vertexLabel complex v <> " begins " <> show b <> " faces and ends " <> show e <> ", not " <> show want
          | v <- [0 .. vertexTotal complex - 1]
          , let (b, e, want) = (begun U.! v, ended U.! v, facesOfPairs complex (cornersOf complex v))
          , b /= want || e /= want
          ]

-- | The faces that a line of corners begins.
facesOfPairs :: Complex -> [Int] -> Int
facesOfPairs complex line = sum (map faces (pairsOf complex line))
  where
    scene = complexScene complex
    faces (p, q) = if nextCorner scene p == q && previousCorner scene p == q then 2 else 1 :: Int

-- | /Cost/ O(stretches).
counts :: Law Complex
counts =
  lawOf
    "the numbers of vertices, edges and faces fit"
    "The bounded faces are as many as elementary pairs, those between the two ends of an untouched thin wall counted \
    \twice, and V − E − B + F is W + 1 under the sky and W in a room: V vertices, E edges, B buried stretches, F \
    \faces, W straight walls that nothing touches, with corners between their ends or not. Contacts change nothing \
    \else: a corner in several cones of free space counts as often."
    $ \complex ->
      let scene = complexScene complex
          total = stretchTotal complex
          edges = length (filter (isEdge complex . EdgeId) [0 .. total - 1])
          begun = sum (map (facesOfPairs complex . cornersOf complex) [0 .. vertexTotal complex - 1])
          walls = length (straightWalls scene)
          outer = case surroundings scene of OpenSky -> 1; Room -> 0
          bounded = length (filter (isBounded complex) [0 .. faceTotal complex - 1])
          euler = vertexTotal complex - edges - (total - edges) + faceTotal complex
       in [show bounded <> " bounded faces, " <> show begun <> " begun by pairs" | bounded /= begun]
            <> ["V − E − B + F is " <> show euler <> ", not " <> show (walls + outer) | euler /= walls + outer]

-- | The walks around walls that lie on one line: the first corner of each.
straightWalls :: Scene -> [CornerId]
straightWalls scene =
  [c | c <- filter (isWallEnd scene) (corners scene), walk <- [walkFrom c], all (>= c) walk, straight walk]
  where
    walkFrom c = c : takeWhile (/= c) (drop 1 (iterate (nextCorner scene) c))
    straight walk = and [onLine a b | (a, b) <- zip walk (drop 1 walk <> take 1 walk)]
    -- Flat, or an end: the sides before and after a corner are on one line.
    onLine (CornerId a) b@(CornerId i) = turn (scenePoints scene) a i c == Collinear
      where
        CornerId c = nextCorner scene b
