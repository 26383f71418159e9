-- | Planar sections of the complex: all its faces at one direction, from top to bottom.
module Visibility.Complex.Law.Section
  ( sections
  , sectionsAgree
    -- * Sections
  , Interval (..)
  , sectionOf
  , sectionByRays
  , directionsFrom
  , isGeneric
  ) where

import Data.List (mapAccumL, nub, sort, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (isNothing)
import Data.Ord (Down (..))
import Data.Ratio ((%))
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Visibility.Complex.Law.Base
import Visibility.Complex.Reading
import Visibility.Complex.Type
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Ray
import Visibility.Scene
import Visibility.View (Flank (..), Incidence (..), incidences)

-- | A face at one direction: an interval of offsets, the objects at back and front, the corners whose curves bound it
-- from above and from below; 'Nothing' where there is no such corner.
data Interval = Interval
  { intervalBack :: !Object
  , intervalFront :: !Object
  , intervalUpper :: !(Maybe CornerId)
  , intervalLower :: !(Maybe CornerId)
  }
  deriving (Eq, Ord, Show)

-- | /Cost/ for each of the eight directions O(stretches + n log n), and two rays from each corner.
sections :: Law Complex
sections =
  lawOf
    "sections are those of the scene"
    "At eight exact directions, pseudo-random, the faces between the curves of all corners, from top to bottom, have \
    \the back, the front, the upper and the lower corner that rays shot from every corner give: the trapezoids into \
    \which the lines of that direction through all corners cut free space."
    (sectionsAgree (directionsFrom [1 .. 8]))

-- | The differences between the sections of a complex and those by rays at those of the directions that are parallel to
-- no line through two corners.
sectionsAgree :: [Direction] -> Complex -> [String]
sectionsAgree directions complex =
  [ "along " <> show (x, y) <> ": " <> intervalText i <> which
  | d@(Direction x y) <- directions
  , isGeneric scene d
  , let have = sort (section d)
  , let want = sort (sectionByRays rays scene d)
  , have /= want
  , (i, which) <- differences have want
  ]
  where
    scene = complexScene complex
    section = sectionOf complex
    rays = raysIn scene
    differences have want =
      [(i, " is in the complex only") | i <- Set.toList (Set.difference (Set.fromList have) (Set.fromList want))]
        <> [(i, " is in the scene only") | i <- Set.toList (Set.difference (Set.fromList want) (Set.fromList have))]
        <> [(i, " is there twice") | (i, j) <- zip have (drop 1 have), i == j]
    intervalText (Interval b f upper lower) =
      unwords
        [ objectLabel complex (Just b)
        , objectLabel complex (Just f)
        , "between"
        , bound upper
        , "and"
        , bound lower
        ]
    bound = maybe "nothing" (cornerLabel complex)

-- | Right-going directions, one from each seed, with components below 2³⁰.
directionsFrom :: [Integer] -> [Direction]
directionsFrom seeds =
  [ Direction (1 + x `mod` bound) (y `mod` (2 * bound - 1) - bound + 1)
  | seed <- seeds
  , let x = next seed
  , let y = next x
  ]
  where
    bound = 2 ^ (30 :: Int)
    -- A step of a linear congruential generator, its low bits left out of the result.
    next s = ((s * 6364136223846793005 + 1442695040888963407) `mod` 2 ^ (64 :: Int)) `div` 2 ^ (20 :: Int)

-- | Is the direction parallel to no line through corners in two places? /Cost/ O(n log n).
isGeneric :: Scene -> Direction -> Bool
isGeneric scene d = and (zipWith (/=) offsets (drop 1 offsets))
  where
    offsets = sort [offset scene d c | c : _ <- placeGroups scene]

-- | How far above the origin the line through a corner lies, times the length of the direction.
offset :: Scene -> Direction -> CornerId -> Rational
offset scene (Direction dx dy) c = (dx * y - dy * x) % w
  where
    LatticePoint x y w = cornerAt scene c

-- | The corners from top to bottom.
downwards :: Scene -> Direction -> [CornerId]
downwards scene d = sortOn (Down . offset scene d) (corners scene)

-- | The faces of the complex at a direction between those of its vertices.
--
-- /Degenerate cases/ where the tables are wrong there may be too many, or some without a corner that bounds them.
sectionOf :: Complex -> Direction -> [Interval]
sectionOf complex = section
  where
    -- The same at all directions.
    read' = readings complex
    lines' = V.fromList (map (vertexLine complex) (vertexIds complex))
    section d = sectionWith read' (V.convert (V.map (\line -> compareDirections line d == LT) lines')) complex d

-- | By the readings, and by vertex: does it come before the direction?
sectionWith :: Readings -> U.Vector Bool -> Complex -> Direction -> [Interval]
sectionWith read' beforeLines complex d =
  intervals
    [(f, (Sky, Sky)) | f <- faceIds complex, isNothing (faceFirst complex f)]
    [ (c, concatMap (facesAt Above) alive, concatMap (facesAt Below) alive)
    | c@(CornerId i) <- downwards (complexScene complex) d
    , let alive = aliveByCorner V.! i
    ]
  where
    aliveByCorner =
      V.accum
        (flip (:))
        (V.replicate (cornerCount (complexScene complex)) [])
        [(c, (e, reading)) | e <- stretchIds complex, Just reading <- [readAt e], let CornerId c = edgeCorner complex e]
    -- Is the direction within the stretch, and before or after the end of the half turn?
    readAt e
      | wrapsAround complex e = if begun then Just Forwards else if ended then Nothing else Just Backwards
      | otherwise = if begun && not ended then Just Forwards else Nothing
      where
        begun = isBefore (edgeFirst complex e)
        ended = isBefore (edgeLast complex e)
        isBefore (VertexId v) = beforeLines U.! v
    facesAt flank (e, reading) =
      nub
        [ (f, label f (reading, readingAt read' e q))
        | q <- quartersOf (if reading == Forwards then flank else opposite' flank)
        , Just f <- [faceAt complex e q]
        ]
    label f (mine, its)
      | its == Just mine = (faceBack complex f, faceFront complex f)
      | otherwise = (faceFront complex f, faceBack complex f)
    opposite' Above = Below
    opposite' Below = Above

-- | The same by rays alone.
--
-- /Requires/ a generic direction. /Cost/ O(n log n), and two rays from each corner.
sectionByRays :: Rays -> Scene -> Direction -> [Interval]
sectionByRays rays scene d =
  intervals
    [((Sky, Sky), (Sky, Sky)) | surroundings scene == OpenSky]
    [ (c, on Above found, on Below found)
    | c <- downwards scene d
    , let found = incidences scene c (viewFrom rays c d)
    ]
  where
    on flank found = [((b, f), (b, f)) | Incidence flank' b f <- found, flank' == flank]

-- | What corners from top to bottom open and close: first those that are open above all corners, then, by corner, those
-- above it, which it closes, and those below it, which it opens. A face has a key and a label.
intervals
  :: Ord k
  => [(k, (Object, Object))]
  -> [(CornerId, [(k, (Object, Object))], [(k, (Object, Object))])]
  -> [Interval]
intervals outermost line = concat found <> map unclosed (Map.elems open)
  where
    (open, found) = mapAccumL at (Map.fromList [(k, (label, Nothing)) | (k, label) <- outermost]) line
    at now (c, above, below) = (opened, closedNow <> lost)
      where
        closedNow = [made label (upperOf k) (Just c) | (k, label) <- above]
        upperOf k = Map.lookup k now >>= snd
        left = foldr (Map.delete . fst) now above
        lost = [made label upper Nothing | (k, _) <- below, Just (label, upper) <- [Map.lookup k left]]
        opened = foldr (\(k, label) -> Map.insert k (label, Just c)) left below
    unclosed (label, upper) = made label upper Nothing
    made (b, f) = Interval b f
