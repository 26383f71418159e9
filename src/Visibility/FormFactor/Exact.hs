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
    -- * By the names of the file
  , byName
  , seenByRank
  ) where

import qualified Data.Map.Strict as Map
import Data.Ratio ((%))
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Exact.Point
import Visibility.Exact.RootSum (RootSum)
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Exact.Rounding (decimal, defaultDigits)
import Visibility.FormFactor.Sums
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
byName scene = groupedBy (V.length (seenByRank scene)) (ranks scene)

-- | Sides of the file by name, then the sky.
seenByRank :: Scene -> V.Vector Seen
seenByRank scene = V.fromList (map TheSide (statedSides scene) <> [TheSky])

-- | By object: the rank of the side of the file that it is, or is a piece of; the sky last.
ranks :: Scene -> U.Vector Int
ranks scene = U.snoc (U.map fromIntegral (facedSides scene)) (length (statedSides scene))

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
  [ value (seen V.! other) total
  | (r, TheSide name) <- zip [0 ..] (V.toList seen)
  , let value = formFactor scene name
  , (other, g) <- rows r
  , let total = totals g
  , not (null (RootSum.terms total))
  ]
  where
    seen = seenByRank scene
    groups = byName scene terms
    rows = rowsOf (V.length seen) groups
    totals = groupSums scene terms groups

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
