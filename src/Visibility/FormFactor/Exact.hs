-- | Measures of faces by the telescoping string rule, and form factors, as exact sums of square roots.
--
-- /Source/ Orti, Rivière, Durand, Puech, Using the visibility complex for radiosity computation, propositions 1 and 2
-- (measure of a face as an area in the dual); Hottel (string rule).
module Visibility.FormFactor.Exact
  ( -- * Measures of lines
    Measures (..)
  , measures
  , measuresInPieces
  , measureList
  , statedMeasures
    -- * Form factors
  , FormFactor (..)
  , formFactors
  , formFactor
  , sideLength
    -- * Laws
  , closureDefect
    -- * By groups of terms
  , byName
  , factorRows
  , groupSums
  ) where

import Control.Monad (forM_)
import Data.Bits (Bits)
import Data.Int (Int32)
import Data.List (foldl')
import qualified Data.Map.Strict as Map
import Data.Ratio ((%))
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Visibility.Exact.Point
import Visibility.Exact.RootSum (RootSum)
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Exact.Rounding (decimal, defaultDigits)
import Visibility.Exact.SquareClass
import Visibility.FormFactor.Terms
import Visibility.Law (broken)
import Visibility.Scene
import Visibility.Sweep.Piece
import Visibility.Sweep.Vertex

-- | The measure of the lines (du dθ) between each pair of objects that see each other, on the lattice: the total area
-- of all faces of one label, A(s, t) = A(t, s). Not of the sky with itself. Shown as @\<measures: 6 distances\>@: of so
-- many distances between corners they are multiples.
newtype Measures = Measures Terms

instance Show Measures where
  show (Measures terms) = "<measures: " <> show (slotCount terms) <> " distances>"

-- | Adds up a stream of vertices, which must be that of the whole half turn.
--
-- /Degenerate cases/ none: collinear corners, sides on a line and flat corners are summed like all else; no general
-- position is needed.
--
-- /Cost/ O(1) per elementary pair; live memory O(n) besides the result. Sums of roots are made by those who read them.
--
-- /Laws/ every measure is positive; closure: see 'closureDefect'.
measures :: Scene -> [Vertex] -> Measures
measures scene = measuresInPieces scene . inPieces

-- | The same of a stream in pieces.
measuresInPieces :: Scene -> [Piece] -> Measures
measuresInPieces scene = Measures . termsInPieces scene

-- | All pairs of objects with a measure that is not exactly zero, each pair once, in the file's units, terms merged.
measureList :: Scene -> Measures -> [((Object, Object), RootSum)]
measureList scene (Measures terms) =
  [ ((object a, object b), total)
  | ((a, b), total) <- exactSums scene terms (groupedBy (n + 1) (U.enumFromN 0 (n + 1)) terms)
  ]
  where
    n = cornerCount scene
    object k = if k == n then Sky else Side (SideId k)

-- | The measure of the lines between each two things of the file that see each other, each pair once: those of all
-- pieces of a side, added up. In the order of their names, the sky last.
statedMeasures :: Scene -> Measures -> [((Seen, Seen), RootSum)]
statedMeasures scene (Measures terms) =
  [((seen V.! a, seen V.! b), total) | ((a, b), total) <- exactSums scene terms (byName scene terms)]
  where
    seen = seenByRank scene

-- | The measures of groups that are not exactly zero, with the numbers that they belong to.
exactSums :: Scene -> Terms -> Groups -> [((Int, Int), RootSum)]
exactSums scene terms groups =
  [ (groupPair groups g, total)
  | g <- [0 .. groupCount groups - 1]
  , let total = sumOf g
  , not (null (RootSum.terms total))
  ]
  where
    sumOf = groupSums scene terms groups

-- | The terms by the ranks of what the file calls objects.
byName :: Scene -> Terms -> Groups
byName scene = groupedBy (n + 1) (U.snoc (U.map fromIntegral (facedSides scene)) n)
  where
    n = length (statedSides scene)

-- | Sides of the file by name, then the sky.
seenByRank :: Scene -> V.Vector Seen
seenByRank scene = V.fromList (map TheSide (statedSides scene) <> [TheSky])

-- | A form factor that is not exactly zero. Shown as @\<0.1 to 1.3: 0.4142136\>@, rounded.
data FormFactor = FormFactor
  { factorFrom :: !SideName
  , factorTo :: !Seen
  , factorMeasure :: !RootSum
  -- ^ A(s, t), in the file's units: 2 L_s F_st.
  , factorValue :: RootSum
  -- ^ F_st: the part of the light leaving s, uniform and diffuse, that reaches t.
  }

instance Show FormFactor where
  show f = "<" <> sideText (factorFrom f) <> " to " <> seenText (factorTo f) <> ": " <> value <> ">"
    where
      value = decimal defaultDigits (factorValue f)

-- | All form factors that are not exactly zero, by the side they leave and what they reach, the sky last.
--
-- /Degenerate cases/ a side whose parts are covered counts as a whole, with its whole length; what leaves a covered
-- part reaches nothing.
--
-- /Laws/ Σ_t F_st is the part of s that is not covered, 1 where nothing is (closure); L_s F_st = L_t F_ts
-- (reciprocity); both exact.
formFactors :: Scene -> Measures -> [FormFactor]
formFactors scene (Measures terms) =
  [ value other total
  | (_, name, row) <- factorRows scene groups
  , let value = formFactor scene name
  , (other, g) <- row
  , let total = totals g
  , not (null (RootSum.terms total))
  ]
  where
    groups = byName scene terms
    totals = groupSums scene terms groups

-- | The sides of the file by name, each with its rank, and with what it reaches and the group of both.
factorRows :: Scene -> Groups -> [(Int, SideName, [(Seen, Int)])]
factorRows scene groups =
  [(r, name, [(seen V.! other, g) | (other, g) <- rows r]) | (r, TheSide name) <- zip [0 ..] (V.toList seen)]
  where
    seen = seenByRank scene
    rows = rowsOf (V.length seen) groups

-- | The form factor from a side to something seen, from the measure of the lines between them in the file's units.
formFactor :: Scene -> SideName -> Seen -> RootSum -> FormFactor
formFactor scene s = \t total -> FormFactor s t total $ case twice of
  [(c, n)] | Just value <- RootSum.quotientByRoot total c n -> value
  _ -> broken "a side has a length" (sideText s)
  where
    twice = RootSum.terms (RootSum.scaled 2 (sideLength scene s))

-- | The length of a side in the file's units, a single root. /Requires/ the name of a side.
sideLength :: Scene -> SideName -> RootSum
sideLength scene s = RootSum.hypotenuse (1 % (latticeScale (sceneLattice scene) * w)) dx dy
  where
    Way (Vector2 dx dy) w = sideSpan scene s

-- | What a side lacks to closure: Σ_t A(s, t) − 2 u L_s for all sides by name, u being the part of it that nothing
-- covers. Each is exactly zero.
closureDefect :: Scene -> Measures -> [(SideName, RootSum)]
closureDefect scene sums =
  [ (s, Map.findWithDefault RootSum.zero s rows - expected)
  | s <- statedSides scene
  , let expected = RootSum.scaled (2 * uncovered scene s) (sideLength scene s)
  ]
  where
    rows =
      RootSum.totalsBy
        [ (s, total)
        | ((a, b), total) <- statedMeasures scene sums
        , TheSide s <- [a, b]
        ]

-- Where places are small, a distance is three machine words: as integers of any size for all scenes, @factors --exact@
-- of 1 000 quadrilaterals takes 1.3 times as long and 1.2 times the memory.

-- | The measure of a group, in the file's units, terms merged.
--
-- /Cost/ that of 'RootSum.mergedSum'. Where places are small, all distances are found when the first one is needed, and
-- kept in three words each; a sum asked for again is added up again, which takes less than to keep them all. Where they
-- are large, distances and sums are kept once they are found.
groupSums :: Scene -> Terms -> Groups -> Int -> RootSum
groupSums scene terms groups = case pointPlaces (scenePoints scene) of
  SmallPlaces xs -> smallSum (smallDistances xs)
  LargePlaces points ->
    let distances = V.generate (slotCount terms) (largeDistance points . slotEnds terms)
     in (V.generate (groupCount groups) (largeSum distances) V.!)
  where
    scale = latticeScale (sceneLattice scene)

    smallSum distances g = RootSum.mergedSum scale (groupTerms weigh [] groups g)
      where
        weigh sums slot k =
          let at part = distances U.! (3 * slot + part)
           in (toInteger (k * at 0), PreparedRoot (at 1) 1 (at 2)) : sums
    -- Those of one distance lie together in memory.
    smallDistances xs = U.create $ do
      table <- M.new (3 * slotCount terms)
      forM_ [0 .. slotCount terms - 1] $ \slot -> do
        let (n, PreparedRoot key s m) = smallDistance xs (slotEnds terms slot)
        M.write table (3 * slot) (n * s)
        M.write table (3 * slot + 1) key
        M.write table (3 * slot + 2) m
      pure table

    largeSum distances g =
      RootSum.mergedSum (scale * common) [(n * (common `quot` w), root) | Distance n w root <- found]
      where
        found = groupTerms weigh [] groups g
        weigh sums slot k = let Distance n w root = distances V.! slot in Distance (toInteger k * n) w root : sums
        common = foldl' (\sofar (Distance _ w _) -> if w == 1 then sofar else lcm sofar w) 1 found

-- | A distance on the lattice: a multiple of a root, the factor a fraction.
data Distance = Distance !Integer !Integer !(PreparedRoot Integer)

-- | The distance between two corners in lengths of the primitive lattice vector along their line: between whole points
-- it is an integer multiple of one root.
largeDistance :: V.Vector LatticePoint -> (Int, Int) -> Distance
largeDistance points (a, b) = let (n, root) = inPrimitives x y in Distance n w root
  where
    Way (Vector2 x y) w = (points V.! a) `way` (points V.! b)

-- | The same of whole points with coordinates below 2^31. So the square of a distance is below 2^63.
smallDistance :: U.Vector Int32 -> (Int, Int) -> (Int, PreparedRoot Int)
smallDistance xs (a, b) = inPrimitives (along 0) (along 1)
  where
    along k = fromIntegral (xs U.! (2 * b + k)) - fromIntegral (xs U.! (2 * a + k)) :: Int
{-# INLINE smallDistance #-}

-- | A vector, which is not 0, as a multiple of a primitive one, and the length of that.
inPrimitives :: (Integral a, Bits a) => a -> a -> (a, PreparedRoot a)
inPrimitives x y = (n, preparedRoot (px * px + py * py))
  where
    n = gcd x y
    (px, py) = (x `quot` n, y `quot` n)
{-# INLINE inPrimitives #-}
