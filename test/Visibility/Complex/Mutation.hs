-- | Complexes that are broken on purpose, in one place each, with the law that has to notice.
module Visibility.Complex.Mutation
  ( Mutation (..)
  , mutations
  , anyWrongNumber
  , allTables
  , Column (..)
  ) where

import Data.Int (Int32)
import Data.List (nub)
import qualified Data.Vector.Unboxed as U
import Visibility.Complex.Table
import Visibility.Complex.Type
import Visibility.Scene
import Visibility.Sweep (vertexCorners)
import Visibility.Test.BruteForce (isElementary)

-- | A way to break a complex: what it does, the name of the law that must be among those violated, and all complexes
-- that it makes of one, which may be none.
data Mutation = Mutation
  { mutationName :: String
  , noticedBy :: String
  , mutants :: Complex -> [Complex]
  }

-- | A table of the complex: its name, itself, the complex with another one, and the numbers that may stand in it.
data Column = Column
  { tableName :: String
  , tableOf :: Complex -> U.Vector Int32
  , withTable :: U.Vector Int32 -> Complex -> Complex
  , numbers :: Complex -> (Int, Int)
  }

instance Show Column where show = tableName

-- | All tables.
allTables :: [Column]
allTables =
  [ column "vertexStarts" vertexStarts (\t c -> c {vertexStarts = t}) (\c -> (0, stretchTotal c))
  , column "stretchCorners" stretchCorners (\t c -> c {stretchCorners = t}) (\c -> (0, cornerTotal c - 1))
  , column "stretchVertices" stretchVertices (\t c -> c {stretchVertices = t}) (\c -> (0, vertexTotal c - 1))
  , column "stretchesBefore" stretchesBefore (\t c -> c {stretchesBefore = t}) (\c -> (0, stretchTotal c - 1))
  , column "stretchesAfter" stretchesAfter (\t c -> c {stretchesAfter = t}) (\c -> (0, stretchTotal c - 1))
  , column "stretchBacks" stretchBacks (\t c -> c {stretchBacks = t}) (\c -> (-1, objectTotal c - 1))
  , column "stretchFronts" stretchFronts (\t c -> c {stretchFronts = t}) (\c -> (-1, objectTotal c - 1))
  , column "stretchFlanks" stretchFlanks (\t c -> c {stretchFlanks = t}) (const (0, 1))
  , column "stretchFaces" stretchFaces (\t c -> c {stretchFaces = t}) (\c -> (-1, faceTotal c - 1))
  , column "lastStretches" lastStretches (\t c -> c {lastStretches = t}) (\c -> (0, stretchTotal c - 1))
  , column "faceFirsts" faceFirsts (\t c -> c {faceFirsts = t}) (\c -> (-1, vertexTotal c - 1))
  , column "faceLasts" faceLasts (\t c -> c {faceLasts = t}) (\c -> (-1, vertexTotal c - 1))
  , column "faceBacks" faceBacks (\t c -> c {faceBacks = t}) (\c -> (0, objectTotal c - 1))
  , column "faceFronts" faceFronts (\t c -> c {faceFronts = t}) (\c -> (0, objectTotal c - 1))
  , column "chainStarts" chainStarts (\t c -> c {chainStarts = t}) (\c -> (0, tableLength (chains c)))
  , column "chains" chains (\t c -> c {chains = t}) (\c -> (0, stretchTotal c - 1))
  ]

column
  :: String
  -> (Complex -> Table index item)
  -> (Table index item -> Complex -> Complex)
  -> (Complex -> (Int, Int))
  -> Column
column name table with = Column name (tableNumbers . table) (with . Table)

cornerTotal, objectTotal :: Complex -> Int
cornerTotal = cornerCount . complexScene
objectTotal c = cornerTotal c + (case surroundings (complexScene c) of OpenSky -> 1; Room -> 0)

-- | A table with another number at one entry.
anyWrongNumber :: Column -> Int -> Int -> Complex -> Complex
anyWrongNumber table i x c = withTable table (tableOf table c U.// [(i, fromIntegral x)]) c

-- | All of them, most by one wrong entry or two exchanged ones.
mutations :: [Mutation]
mutations =
  [ Mutation "a number that stands for nothing" "the tables are well formed" $ \c ->
      [ anyWrongNumber table i x c
      | table <- allTables
      , let (low, high) = numbers table c
      , i <- sampled (U.length (tableOf table c))
      , x <- [low - 1, high + 1, 1000000]
      , x > high || x < low
      ]
  , Mutation "a table without its last entry" "the tables are well formed" $ \c ->
      [withTable table (U.init (tableOf table c)) c | table <- allTables, not (U.null (tableOf table c))]
  , Mutation "a chain that ends before it begins" "the tables are well formed" $ \c ->
      [c {chainStarts = swapped (4 * f + 2) (4 * f + 6) (chainStarts c)} | f <- [0 .. faceTotal c - 2]]
  , Mutation "a stretch that names another vertex" "a stretch begins at its vertex" $ \c ->
      [ c {stretchVertices = changed e v (stretchVertices c)}
      | e <- stretchesIn c
      , v <- otherThan (value (stretchVertices c) e) (vertexTotal c)
      ]
  , Mutation "a stretch after a stretch that is another one" "the stretches of a corner are linked both ways" $ \c ->
      [ c {stretchesAfter = changed e x (stretchesAfter c)}
      | e <- stretchesIn c
      , x <- otherThan (value (stretchesAfter c) e) (stretchTotal c)
      ]
  , Mutation "a stretch before a stretch that is another one" "the stretches of a corner are linked both ways" $ \c ->
      [ c {stretchesBefore = changed e x (stretchesBefore c)}
      | e <- stretchesIn c
      , x <- otherThan (value (stretchesBefore c) e) (stretchTotal c)
      ]
  , Mutation "a last stretch that is the one before it" "the vertices of a corner come by increasing direction" $ \c ->
      [ c {lastStretches = changed i before (lastStretches c)}
      | i <- [0 .. cornerTotal c - 1]
      , let e = value (lastStretches c) i
      , let before = value (stretchesBefore c) e
      , before /= e
      ]
  , Mutation "two corners of a vertex in the wrong order" "the corners of a vertex lie on its line, in order" $ \c ->
      [ c {stretchCorners = swapped e (e + 1) (stretchCorners c)}
      | v <- [0 .. vertexTotal c - 1]
      , e <- [value (vertexStarts c) v .. value (vertexStarts c) (v + 1) - 2]
      ]
  , Mutation "a corner of a vertex that is another one" "the vertices are those of the scene" $ \c ->
      [ c {stretchCorners = changed e x (stretchCorners c)}
      | e <- stretchesIn c
      , x <- otherThan (value (stretchCorners c) e) (cornerTotal c)
      ]
  , Mutation "a corner of a vertex that does not see the other" "consecutive corners of a vertex see each other" $ \c ->
      [ c {stretchCorners = changed e x (stretchCorners c)}
      | v <- [0 .. vertexTotal c - 1]
      , let e = value (vertexStarts c) v
      , let p = value (stretchCorners c) e
      , let q = value (stretchCorners c) (e + 1)
      , x <- [0 .. q - 1]
      , -- Where a line runs along both faces of a wall, its pairs are not those of neighbours in the list.
        not (any (isSplitEnd (complexScene c)) (CornerId x : vertexCorners (vertexAt c (VertexId v))))
      , not (any (samePlace (complexScene c) (CornerId x)) [CornerId p, CornerId q])
      , not (isElementary (complexScene c) (CornerId x) (CornerId q))
      ]
  , Mutation "a vertex missing, its corners left to the one before it" "the vertices are those of the scene" $ \c ->
      [withoutVertex v c | v <- [1 .. vertexTotal c - 1]]
  , Mutation "a flank that is the other one" "a ray is solid where it enters the solid at its corner" $ \c ->
      [c {stretchFlanks = changed e (1 - value (stretchFlanks c) e) (stretchFlanks c)} | e <- stretchesIn c]
  , Mutation "a free ray that is solid" "a ray is solid where it enters the solid at its corner" $ \c ->
      [ c {stretchBacks = changed e (-1) (stretchBacks c)} | e <- stretchesIn c, value (stretchBacks c) e >= 0]
  , Mutation "two faces on a flank that are one" "a vertex has the edges and faces that its corners demand" $ \c ->
      [ c {stretchFaces = changed (q + 1) (value (stretchFaces c) q) (stretchFaces c)}
      | q <- [0, 2 .. 4 * stretchTotal c - 2]
      , differ (stretchFaces c) q (q + 1)
      ]
  , Mutation "two faces that are one everywhere" "a vertex has the edges and faces that its corners demand" $ \c ->
      [ c {stretchFaces = edited (U.map (\x -> if x == g then f else x)) (stretchFaces c)}
      | q <- [0, 2 .. 4 * stretchTotal c - 2]
      , differ (stretchFaces c) q (q + 1)
      , let f = tableNumbers (stretchFaces c) U.! q
      , let g = tableNumbers (stretchFaces c) U.! (q + 1)
      ]
  , Mutation "two faces on a flank exchanged" "the faces at a stretch see what its view demands" $ \c ->
      [ c {stretchFaces = swapped q (q + 1) (stretchFaces c)}
      | q <- [0, 2 .. 4 * stretchTotal c - 2]
      , differ (stretchFaces c) q (q + 1)
      ]
  , Mutation "a quarter without its face" "the faces at a stretch see what its view demands" $ \c ->
      [ c {stretchFaces = changed q (-1) (stretchFaces c)}
      | q <- [0 .. 4 * stretchTotal c - 1]
      , value (stretchFaces c) q >= 0
      ]
  , Mutation "a face whose back is another object" "the faces at a stretch see what its view demands" otherBack
  , Mutation "a face whose back and front are exchanged" "the faces at a stretch see what its view demands" $ \c ->
      [ c {faceBacks = changed f front (faceBacks c), faceFronts = changed f back (faceFronts c)}
      | f <- [0 .. faceTotal c - 1]
      , let back = value (faceBacks c) f
      , let front = value (faceFronts c) f
      , back /= front
      ]
  , Mutation "the faces above and below a stretch exchanged" incidenceLaw $ \c ->
      [ c {stretchFaces = swapped (4 * e) (4 * e + 2) (swapped (4 * e + 1) (4 * e + 3) (stretchFaces c))}
      | e <- stretchesIn c
      ]
  , Mutation "a chain without one of its stretches" incidenceLaw $ \c ->
      [ inFace f (\parts -> replaced k (withoutAt i (parts !! k)) parts) c
      | (f, k, i) <- placesInChains c
      ]
  , Mutation "a stretch twice in a chain" incidenceLaw $ \c ->
      [ inFace f (\parts -> replaced k (let es = parts !! k in take (i + 1) es <> drop i es) parts) c
      | (f, k, i) <- placesInChains c
      ]
  , Mutation "a stretch in the other chain" incidenceLaw $ \c ->
      [ inFace f (moved k i ((k + 2) `mod` 4)) c
      | (f, k, i) <- placesInChains c
      ]
  , Mutation "a first vertex that is another one" chainLaw $ \c ->
      [ c {faceFirsts = changed f v (faceFirsts c)}
      | f <- boundedFaces c
      , v <- otherThan (value (faceFirsts c) f) (vertexTotal c)
      ]
  , Mutation "a last vertex that is another one" chainLaw $ \c ->
      [ c {faceLasts = changed f v (faceLasts c)}
      | f <- boundedFaces c
      , v <- otherThan (value (faceLasts c) f) (vertexTotal c)
      ]
  , Mutation "two stretches of a chain in the wrong order" chainLaw $ \c ->
      [ inFace f (\parts -> replaced k (swappedAt i (parts !! k)) parts) c
      | (f, k, i) <- placesInChains c
      , f `elem` boundedFaces c
      , i + 1 < length (chainParts c !! f !! k)
      ]
  , Mutation "a turn of a chain too early" chainLaw $ \c ->
      [ inFace f turnedEarly c
      | f <- boundedFaces c
      ]
  , Mutation "the closed chain without one of its stretches" outerLaw $ \c ->
      [ inFace f (\parts -> replaced k (withoutAt i (parts !! k)) parts) c
      | (f, k, i) <- placesInChains c
      , f `notElem` boundedFaces c
      ]
  , Mutation "a first and a last vertex of the lines that miss everything" outerLaw $ \c ->
      [ c {faceFirsts = changed f v (faceFirsts c), faceLasts = changed f v (faceLasts c)}
      | f <- outerFaces c
      , v <- [0 .. vertexTotal c - 1]
      ]
  , Mutation "a vertex that begins one face more, and another one less" pairLaw $ \c ->
      [ c {faceFirsts = changed f v (faceFirsts c)}
      | f <- boundedFaces c
      , v <- otherThan (value (faceFirsts c) f) (vertexTotal c)
      ]
  , Mutation "a face that is there twice" "the numbers of vertices, edges and faces fit" $ \c ->
      [withCopyOf f c | f <- boundedFaces c]
  , Mutation "the chains of a face exchanged" "every bounded face has a positive measure" $ \c ->
      [inFace f (\parts -> drop 2 parts <> take 2 parts) c | f <- boundedFaces c]
  , Mutation "measured between another side and the front" "the measures of faces add up to those of the sweep" $ \c ->
      filter (\m -> faceBacks m `sameOn` faceBacks c $ outerFaces c) (otherBack c)
  , Mutation "counted for another side" "the measures of a side's faces add up to twice its length" $ \c ->
      filter (\m -> faceBacks m `sameOn` faceBacks c $ outerFaces c) (otherBack c)
  , Mutation "a view with back and front exchanged" "rays confirm every view" $ \c ->
      [ c {stretchBacks = changed e f (stretchBacks c), stretchFronts = changed e b (stretchFronts c)}
      | e <- stretchesIn c
      , let b = value (stretchBacks c) e
      , let f = value (stretchFronts c) e
      , b /= f
      ]
  , Mutation "a view of another object" "rays confirm every view" $ \c ->
      [ c {stretchFronts = changed e x (stretchFronts c)}
      | e <- stretchesIn c
      , value (stretchFronts c) e >= 0
      , x <- otherThan (value (stretchFronts c) e) (objectTotal c)
      ]
  , Mutation "all faces read backwards" "sections are those of the scene" $ \c ->
      [c {faceBacks = faceFronts c, faceFronts = faceBacks c}]
  , Mutation "lines that miss everything, but for a side" "sections are those of the scene" $ \c ->
      [c {faceFronts = changed f s (faceFronts c)} | f <- outerFaces c, s <- [0 .. cornerTotal c - 1]]
  ]
  where
    incidenceLaw = "a face has a stretch in its chains as often as the stretch has the face"
    chainLaw = "the chains of a bounded face lead from its first vertex to its last"
    outerLaw = "the lines that miss everything go around the scene"
    pairLaw = "an elementary pair begins one face and ends one"
    sampled size = nub (filter (< size) [0, size `div` 2, size - 1])
    stretchesIn c = [0 .. stretchTotal c - 1]
    differ table i j = value table i >= 0 && value table j >= 0 && value table i /= value table j
    otherThan x size = filter (/= x) (nub [(x + 1) `mod` size, (x + size `div` 2) `mod` size, size - 1])
    otherBack c =
      [ c {faceBacks = changed f x (faceBacks c)}
      | f <- [0 .. faceTotal c - 1]
      , x <- otherThan (value (faceBacks c) f) (objectTotal c)
      ]
    sameOn a b is = and [value a i == value b i | i <- is]
    turnedEarly [upper, upperRest, lower, lowerRest] =
      [take (length upper - 1) upper, drop (length upper - 1) upper <> upperRest, lower, lowerRest]
    turnedEarly parts = parts

value :: Table index item -> Int -> Int
value (Table numbers') i = fromIntegral (numbers' U.! i)

edited :: (U.Vector Int32 -> U.Vector Int32) -> Table index item -> Table index item
edited edit (Table numbers') = Table (edit numbers')

changed :: Int -> Int -> Table index item -> Table index item
changed i x = edited (U.// [(i, fromIntegral x)])

swapped :: Int -> Int -> Table index item -> Table index item
swapped i j = edited (\t -> t U.// [(i, t U.! j), (j, t U.! i)])

boundedFaces, outerFaces :: Complex -> [Int]
boundedFaces c = [f | f <- [0 .. faceTotal c - 1], value (faceFirsts c) f >= 0]
outerFaces c = [f | f <- [0 .. faceTotal c - 1], value (faceFirsts c) f < 0]

-- | By face: its upper chain before and after the turn, and its lower one.
chainParts :: Complex -> [[[Int]]]
chainParts c =
  [ [map raw a, map raw b, map raw d, map raw e]
  | f <- faceIds c
  , let Chain a b = upperChain c f
  , let Chain d e = lowerChain c f
  ]
  where
    raw (EdgeId e) = e

withChainParts :: [[[Int]]] -> Complex -> Complex
withChainParts parts c =
  c
    { chainStarts = Table (U.fromList (map fromIntegral (scanl (+) 0 (map length (concat parts)))))
    , chains = Table (U.fromList (map fromIntegral (concat (concat parts))))
    }

-- | The complex with other chains of one face.
inFace :: Int -> ([[Int]] -> [[Int]]) -> Complex -> Complex
inFace f edit c = withChainParts [if g == f then edit parts else parts | (g, parts) <- zip [0 ..] (chainParts c)] c

-- | All entries of chains: face, part, place.
placesInChains :: Complex -> [(Int, Int, Int)]
placesInChains c =
  [(f, k, i) | (f, parts) <- zip [0 ..] (chainParts c), (k, es) <- zip [0 ..] parts, i <- [0 .. length es - 1]]

replaced :: Int -> a -> [a] -> [a]
replaced k x xs = take k xs <> [x] <> drop (k + 1) xs

withoutAt :: Int -> [a] -> [a]
withoutAt i xs = take i xs <> drop (i + 1) xs

swappedAt :: Int -> [a] -> [a]
swappedAt i xs = take i xs <> reverse (take 2 (drop i xs)) <> drop (i + 2) xs

-- | Entry i of part k moved to the beginning of another part.
moved :: Int -> Int -> Int -> [[Int]] -> [[Int]]
moved k i j parts = [part m | m <- [0 .. length parts - 1]]
  where
    part m
      | m == k = withoutAt i (parts !! k)
      | m == j = take 1 (drop i (parts !! k)) <> parts !! j
      | otherwise = parts !! m

-- | The row of a vertex added to the row of the one before it, all later vertices counted anew.
withoutVertex :: Int -> Complex -> Complex
withoutVertex v c =
  c
    { vertexStarts = edited (U.ifilter (\i _ -> i /= v)) (vertexStarts c)
    , stretchVertices = edited (U.map lower) (stretchVertices c)
    , faceFirsts = edited (U.map lower) (faceFirsts c)
    , faceLasts = edited (U.map lower) (faceLasts c)
    }
  where
    lower w = if w >= fromIntegral v then w - 1 else w

withCopyOf :: Int -> Complex -> Complex
withCopyOf f c = withChainParts (parts <> [parts !! f]) grown
  where
    parts = chainParts c
    again :: Table index item -> Table index item
    again = edited (\t -> U.snoc t (t U.! f))
    grown =
      c
        { faceFirsts = again (faceFirsts c)
        , faceLasts = again (faceLasts c)
        , faceBacks = again (faceBacks c)
        , faceFronts = again (faceFronts c)
        }
