{-# LANGUAGE BangPatterns #-}

-- | Measures of faces by the telescoping string rule, and form factors, as exact sums of square roots.
--
-- /Source/ Orti, Rivière, Durand, Puech, Using the visibility complex for radiosity computation, propositions 1 and 2
-- (measure of a face as an area in the dual); Hottel (string rule).
module Visibility.FormFactor
  ( -- * Measures of lines
    Measures
  , measures
  , measureList
  , statedMeasures
    -- * Form factors
  , FormFactor (..)
  , formFactors
  , formFactor
  , sideLength
    -- * Laws
  , closureDefect
  ) where

import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl')
import qualified Data.Map.Strict as Map
import Data.Ratio ((%))
import qualified Data.Vector.Unboxed as U
import Visibility.Law (broken)
import Visibility.Exact.Point
import Visibility.Exact.RootSum (RootSum)
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Scene
import Visibility.Sweep.Vertex
import Visibility.View

-- Note [Measures along the stream]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
-- An edge of corner c between the directions a and b adds ±(t_c(b) − t_c(a)) to each face at its curve, + where the
-- face lies below the curve. Sorted by vertices instead of edges: at a vertex of direction d each corner c on the line
-- adds ±t_c(d) for its faces before the vertex and takes it away for its faces after it. A face that meets the vertex
-- has there, before and after together, as many upper as lower incidences, counted with these signs. So t may be
-- measured from any point of the line, and the first corner is taken: then every t is an integer multiple of the length
-- of the primitive lattice vector along the line, and the sums need integers only. The half turn begins and ends with
-- the same lines, read the other way: t changes its sign, above and below change places, and both contributions cancel.
-- So the cut at ±90° adds nothing.

-- Under an open sky the lines that miss everything have no finite measure; that pair is left out.

-- | The measure of the lines (du dθ) between each pair of objects that see each other, on the lattice: the total area
-- of all faces of one label, A(s, t) = A(t, s). Not of the sky with itself.
newtype Measures = Measures (IntMap.IntMap (Map.Map Integer Integer))

-- | Adds up the contributions of a stream of events, which must be that of the whole half turn.
--
-- /Degenerate cases/ none: collinear corners, sides on a line and flat corners are summed like all else; no general
-- position is needed.
--
-- /Cost/ O(log n) and one gcd per elementary pair; live memory O(n) besides the result.
--
-- /Laws/ every measure is positive; closure: see 'closureDefect'.
measures :: Scene -> [Event] -> Measures
measures scene = Measures . foldl' add IntMap.empty
  where
    add sums event = foldl' (addTerm radicand) sums (Map.toList contributions)
      where
        (radicand, positions) = alongLine scene (eventVertex event)
        contributions = foldl' put Map.empty (zip3 (vertexCorners (eventVertex event)) positions views)
        views = zip (viewsBefore event) (viewsAfter event)
    skyToSky = pairKey scene Sky Sky
    put !sums (c, position, (before, after))
      | position == 0 || before == after = sums
      | otherwise = weighed (negate position) after (weighed position before sums)
      where
        weighed k view total = foldl' (weigh k) total (incidences scene c view)
    weigh position sums (Incidence flank back front) =
      Map.insertWith (+) (pairKey scene back front) (case flank of Above -> negate position; Below -> position) sums
    addTerm radicand sums (key, k)
      | k == 0 || key == skyToSky = sums
      | otherwise = IntMap.insertWith (\_ -> addRoot radicand k) key (Map.singleton radicand k) sums
    addRoot radicand k = Map.alter (nonZero . maybe k (+ k)) radicand
    nonZero k = if k == 0 then Nothing else Just k

-- | The square of the length of the primitive lattice vector along the line of a vertex, and each corner's distance
-- from the first one in such lengths.
alongLine :: Scene -> Vertex -> (Integer, [Integer])
alongLine scene vertex = (px * px + py * py, map position displacements)
  where
    line = vertexCorners vertex
    displacements = map (difference (cornerAt scene (vertexFirst vertex)) . cornerAt scene) line
    Vector2 dx dy = difference (cornerAt scene (vertexFirst vertex)) (cornerAt scene (vertexLast vertex))
    divisor = gcd dx dy
    (px, py) = (dx `quot` divisor, dy `quot` divisor)
    position (Vector2 x y) = if px == 0 then y `quot` py else x `quot` px
-- | One number for an unordered pair of objects.
pairKey :: Scene -> Object -> Object -> Int
pairKey scene a b = min x y * (n + 1) + max x y
  where
    n = cornerCount scene
    x = code a
    y = code b
    code (Side (SideId s)) = s
    code Sky = n

-- | The objects of 'pairKey'.
keyPair :: Scene -> Int -> (Object, Object)
keyPair scene key = (object a, object b)
  where
    n = cornerCount scene
    (a, b) = key `quotRem` (n + 1)
    object k = if k == n then Sky else Side (SideId k)

-- | All pairs of objects with a measure that is not exactly zero, each pair once, in the file's units, terms merged.
measureList :: Scene -> Measures -> [((Object, Object), RootSum)]
measureList scene (Measures sums) =
  [ (keyPair scene key, total)
  | (key, roots) <- IntMap.toAscList sums
  , let total = toRootSum scene roots
  , not (null (RootSum.terms total))
  ]

toRootSum :: Scene -> Map.Map Integer Integer -> RootSum
toRootSum scene roots =
  case RootSum.fromTerms [(k % latticeScale (sceneLattice scene), n) | (n, k) <- Map.toAscList roots] of
    Just total -> RootSum.merged total
    Nothing -> broken "squares of lengths are positive" (show (Map.keys roots))

-- | A form factor that is not exactly zero.
data FormFactor = FormFactor
  { factorFrom :: !SideName
  , factorTo :: !Seen
  , factorMeasure :: !RootSum
  -- ^ A(s, t), in the file's units: 2 L_s F_st.
  , factorValue :: RootSum
  -- ^ F_st: the part of the light leaving s, uniform and diffuse, that reaches t.
  }

-- | All form factors that are not exactly zero, by the side they leave and what they reach, the sky last.
--
-- /Degenerate cases/ a side whose parts are covered counts as a whole, with its whole length; what leaves a covered
-- part reaches nothing.
--
-- /Laws/ Σ_t F_st is the part of s that is not covered, 1 where nothing is (closure); L_s F_st = L_t F_ts
-- (reciprocity); both exact.
formFactors :: Scene -> Measures -> [FormFactor]
formFactors scene sums =
  [ formFactor scene s t total
  | (s, row) <- Map.toAscList bySide
  , (t, total) <- Map.toAscList row
  ]
  where
    bySide = Map.fromListWith Map.union [(s, Map.singleton t total) | (s, t, total) <- entries]
    entries = concatMap both (statedMeasures scene sums)
    both ((a, b), total) = [(s, b, total) | TheSide s <- [a]] <> [(s, a, total) | TheSide s <- [b]]

-- | The measure of the lines between each two things of the file that see each other, each pair once: those of all
-- pieces of a side, added up.
statedMeasures :: Scene -> Measures -> [((Seen, Seen), RootSum)]
statedMeasures scene (Measures sums) =
  [((seenAs scene a, seenAs scene b), total) | ((a, b), total) <- measureList scene (Measures merged)]
  where
    -- Each piece counts as the first one of its side.
    leaders = U.fromList [leader s | s <- sides scene]
    leader s = case piecesOf scene (sideName scene s) of
      Just (SideId least : _) -> least
      _ -> let SideId own = s in own
    merged
      | U.and (U.imap (==) leaders) = sums
      | otherwise = IntMap.filter (not . Map.null) (IntMap.fromListWith addRoots (map lead (IntMap.toList sums)))
    lead (key, roots) = let (a, b) = keyPair scene key in (pairKey scene (first a) (first b), roots)
    first (Side (SideId s)) = Side (SideId (leaders U.! s))
    first Sky = Sky
    addRoots a b = Map.filter (/= 0) (Map.unionWith (+) a b)

-- | The form factor from a side to something seen, from the measure of the lines between them in the file's units.
formFactor :: Scene -> SideName -> Seen -> RootSum -> FormFactor
formFactor scene s t total = FormFactor s t total $
  case RootSum.terms (sideLength scene s) of
    [(c, n)] | Just value <- RootSum.quotientByRoot total (2 * c) n -> value
    _ -> broken "a side has a length" (sideText s)

-- | The length of a side in the file's units, a single root. /Requires/ the name of a side.
sideLength :: Scene -> SideName -> RootSum
sideLength scene s = RootSum.hypotenuse (1 % latticeScale (sceneLattice scene)) dx dy
  where
    Vector2 dx dy = sideSpan scene s

-- | What a side lacks to closure: Σ_t A(s, t) − 2 u L_s for all sides by name, u being the part of it that nothing
-- covers. Each is exactly zero.
closureDefect :: Scene -> Measures -> [(SideName, RootSum)]
closureDefect scene sums =
  [ (s, Map.findWithDefault RootSum.zero s rows `RootSum.minus` expected)
  | s <- statedSides scene
  , let expected = RootSum.scaled (2 * uncovered scene s) (sideLength scene s)
  ]
  where
    rows =
      Map.fromListWith
        RootSum.plus
        [ (s, total)
        | ((a, b), total) <- statedMeasures scene sums
        , TheSide s <- [a, b]
        ]
