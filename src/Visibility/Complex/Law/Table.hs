-- | The laws of the tables themselves, of vertices and of the stretches along each corner.
module Visibility.Complex.Law.Table
  ( wellFormed
  , vertexStretches
  , cornerLinks
  , cornerDirections
  , cornersOnLine
  , pairsSee
  , sweptVertices
  ) where

import Data.Int (Int32)
import Data.List (groupBy, sort)
import qualified Data.Map.Strict as Map
import qualified Data.Vector.Unboxed as U
import Visibility.Complex.Law.Base
import Visibility.Complex.Table
import Visibility.Complex.Type
import Visibility.Exact.Predicate
import Visibility.Ray
import Visibility.Scene
import Visibility.Scene.Cone
import Visibility.Sweep
import Visibility.Sweep.Vertical (skyCode)

-- | Lengths fit, and every number is one of something. /Cost/ O(size of the tables).
wellFormed :: Law Complex
wellFormed =
  lawOf
    "the tables are well formed"
    "All tables of one kind have one length, every number in them stands for something that exists, and rows that \
    \are cut out of a table follow each other."
    check
  where
    check complex = if null lengths then numbers <> rows else lengths <> numbers
      where
        n = cornerCount (complexScene complex)
        v = vertexTotal complex
        e = stretchTotal complex
        f = faceTotal complex
        sky = case surroundings (complexScene complex) of
          OpenSky -> skyCode (complexScene complex)
          Room -> skyCode (complexScene complex) - 1
        -- Each table with the entries that it should have, and the least and the greatest number that may stand there.
        tables =
          [ ("vertexStarts", numbersOf vertexStarts, max 1 (v + 1), 0, e)
          , ("stretchCorners", numbersOf stretchCorners, e, 0, n - 1)
          , ("stretchVertices", numbersOf stretchVertices, e, 0, v - 1)
          , ("stretchesBefore", numbersOf stretchesBefore, e, 0, e - 1)
          , ("stretchesAfter", numbersOf stretchesAfter, e, 0, e - 1)
          , ("stretchBacks", numbersOf stretchBacks, e, -1, sky)
          , ("stretchFronts", numbersOf stretchFronts, e, -1, sky)
          , ("stretchFlanks", numbersOf stretchFlanks, e, 0, 1)
          , ("stretchFaces", numbersOf stretchFaces, 4 * e, -1, f - 1)
          , ("lastStretches", numbersOf lastStretches, n, 0, e - 1)
          , ("faceFirsts", numbersOf faceFirsts, f, -1, v - 1)
          , ("faceLasts", numbersOf faceLasts, f, -1, v - 1)
          , ("faceBacks", numbersOf faceBacks, f, 0, sky)
          , ("faceFronts", numbersOf faceFronts, f, 0, sky)
          , ("chainStarts", numbersOf chainStarts, 4 * f + 1, 0, chained)
          , ("chains", numbersOf chains, chained, 0, e - 1)
          ]
        numbersOf :: (Complex -> Table index item) -> U.Vector Int32
        numbersOf table = tableNumbers (table complex)
        listed = map fromIntegral . U.toList :: U.Vector Int32 -> [Int]
        chained = tableLength (chains complex)
        lengths =
          [ name <> " has " <> show found <> " entries, not " <> show expected
          | (name, table, expected, _, _) <- tables
          , let found = U.length table
          , found /= expected
          ]
        numbers =
          [ name <> " has " <> show x <> " at " <> show i <> ", not one of " <> show low <> " to " <> show high
          | (name, table, _, low, high) <- tables
          , (i, x) <- zip [0 :: Int ..] (listed table)
          , x < low || x > high
          ]
        rows =
          [ "vertexStarts does not rise by 2 or more from 0 to the number of stretches"
          | let starts = listed (numbersOf vertexStarts)
          , or (zipWith (\a b -> b - a < 2) starts (drop 1 starts)) || take 1 starts /= [0] || drop v starts /= [e]
          ]
            <> [ "a chain of face " <> show (i `quot` 4) <> " ends before it begins"
               | let starts = listed (numbersOf chainStarts)
               , (i, a, b) <- zip3 [0 :: Int ..] starts (drop 1 starts)
               , a > b
               ]
            <> [ "the chains do not fill their table"
               | let starts = listed (numbersOf chainStarts)
               , take 1 starts /= [0] || drop (4 * f) starts /= [chained]
               ]

-- | /Cost/ O(stretches).
vertexStretches :: Law Complex
vertexStretches =
  lawOf
    "a stretch begins at its vertex"
    "The stretches in the row of a vertex are those that name it as the vertex where they begin."
    $ \complex ->
      [ stretchLabel complex e <> " stands in the row of " <> vertexLabel complex v
      | v <- vertexIds complex
      , e <- vertexEdgesAfter complex v
      , edgeFirst complex e /= v
      ]

-- | /Cost/ O(stretches).
cornerLinks :: Law Complex
cornerLinks =
  lawOf
    "the stretches of a corner are linked both ways"
    "The stretch after a stretch is one of the same corner, and the stretch before that one is the first again; and \
    \the other way round."
    $ \complex ->
      [ stretchLabel complex e <> " has " <> which <> " it " <> stretchLabel complex there
          <> ", which leads back to stretch "
          <> show (code back)
      | e <- stretchIds complex
      , (which, one, other) <- [("after", edgeAfter, edgeBefore), ("before", edgeBefore, edgeAfter)]
      , let there = one complex e
      , let back = other complex there
      , back /= e || edgeCorner complex there /= edgeCorner complex e
      ]

-- | /Cost/ O(stretches).
cornerDirections :: Law Complex
cornerDirections =
  lawOf
    "the vertices of a corner come by increasing direction"
    "Along the stretches of a corner the direction increases, but for one of them, the last one of the corner, which \
    \goes on over the end of the half turn to the first; every corner has stretches."
    $ \complex ->
      [ stretchLabel complex e <> " ends at " <> vertexLabel complex (edgeLast complex e)
          <> (if isLast then ", though it is the last of its corner" else ", which does not come later")
      | e <- stretchIds complex
      , let isLast = wrapsAround complex e
      , (compareLines complex (edgeFirst complex e) (edgeLast complex e) == LT) == isLast
      ]
        <> [ "the last stretch of corner " <> cornerLabel complex c <> " is " <> stretchLabel complex e
           | c <- corners (complexScene complex)
           , let e = lastEdgeOf complex c
           , edgeCorner complex e /= c
           ]

-- | /Cost/ O(stretches).
cornersOnLine :: Law Complex
cornersOnLine =
  lawOf
    "the corners of a vertex lie on its line, in order"
    "The corners of a vertex are collinear and come from left to right, that is, by increasing id; not all in one \
    \place."
    $ \complex ->
      [ vertexLabel complex v
      | let scene = complexScene complex
      , v <- vertexIds complex
      , let line = cornersOf complex v
      , let (a, b) = (vertexFirst (vertexAt complex v), vertexLast (vertexAt complex v))
      , or (zipWith (>=) line (drop 1 line)) || any ((/= Collinear) . turned scene a b) line || samePlace scene a b
      ]

-- | /Cost/ that of 'hiders' for each elementary pair.
pairsSee :: Law Complex
pairsSee =
  lawOf
    "consecutive corners of a vertex see each other"
    "Between two corners that follow each other on a vertex the open segment meets no corner, crosses no side, and \
    \leaves the cone of free space at neither end, and where it runs along a side it joins the ends of that side: they \
    \are an elementary pair. There is one between any two places that follow each other, and every corner is in one."
    $ \complex ->
      [ fault
      | let rays = raysIn (complexScene complex)
      , v <- vertexIds complex
      , let pairs = vertexPairs (complexScene complex) (vertexAt complex v)
            here = vertexLabel complex v
      , fault <-
          [ cornerLabel complex p <> " and " <> cornerLabel complex q <> " of " <> here <> ": " <> fault
          | (p, q) <- pairs
          , fault <- faults complex rays p q
          ]
            <> [here <> " has corners without a pair" | areMissing complex (cornersOf complex v) pairs]
      ]
  where
    areMissing complex line pairs =
      any (`notElem` concat [[p, q] | (p, q) <- pairs]) line
        || or [null [() | (p, q) <- pairs, p `elem` ps, q `elem` qs] | (ps, qs) <- zip groups (drop 1 groups)]
      where
        groups = groupBy (samePlace (complexScene complex)) line
    faults complex rays p q =
      [ "the solid begins between them, at " <> cornerLabel complex a
      | (a, b) <- [(p, q), (q, p)]
      , entersSolid scene JustThen a (heading scene a b)
      ]
        <> [ "the side from " <> cornerLabel complex a <> " leads to another corner there, " <> cornerLabel complex r
           | (a, b) <- [(p, q), (q, p)]
           , b `notElem` besides scene a
           , r <- besides scene a
           , samePlace scene r b
           ]
        <> ["they are in one place" | samePlace scene p q]
        <> [ "corner " <> cornerLabel complex r <> " or the side from it lies between them" | r <- hiders rays p q]
      where
        scene = complexScene complex

-- | /Cost/ that of the sweep; O(log m) per vertex where the vertices come in another order.
sweptVertices :: Law Complex
sweptVertices =
  lawOf
    "the vertices are those of the scene"
    "A sweep of the scene finds the same vertices, each once: maximal free segments with two or more corners, all of \
    \them, so that consecutive ones see each other."
    $ \complex ->
      if map (vertexAt complex) (vertexIds complex) == vertices (complexScene complex)
        then []
        else otherVertices complex

-- | How the vertices of a complex differ from those of a sweep of its scene, in whatever order both come.
otherVertices :: Complex -> [String]
otherVertices complex =
  [ text line <> (if times > (1 :: Int) then " is there " <> show times <> " times" else " is no vertex")
  | (line, times) <- Map.toList have
  , Map.lookup line found /= Just times
  ]
    <> [text line <> " is missing" | line <- sort (Map.keys (Map.difference found have))]
  where
    have = counted (map (cornersOf complex) (vertexIds complex))
    found = counted (map vertexCorners (vertices (complexScene complex)))
    text = unwords . map (cornerLabel complex)
    counted lists = Map.fromListWith (+) [(line, 1) | line <- lists]
{-# NOINLINE otherVertices #-}
