-- | The laws of the measures of faces, each from the face's own boundary.
module Visibility.Complex.Law.Measure
  ( positiveMeasures
  , summedMeasures
  , closedMeasures
  , boundaryMeasures
  ) where

import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Ratio ((%))
import qualified Data.Vector as V
import Visibility.Complex.Law.Base
import Visibility.Complex.Type
import Visibility.Exact.Point
import Visibility.Exact.Predicate
import Visibility.Exact.RootSum (RootSum, Sign (..))
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.FormFactor
import Visibility.Scene
import Visibility.Sweep

-- Note [Measure of one face]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~~
-- The measure of a face is the sum of t_c(end) − t_c(beginning) over its upper chain, less that over its lower chain,
-- for the corner c of each stretch and t_c = (c·d)/|d|, its position along the line of direction d. Sorted by
-- vertices: where corner a follows corner b in the upper chain at a vertex, the sum has t_b − t_a, and at the ends of
-- the chains, the first and the last vertex, it has the difference of an upper and a lower corner. So t may be
-- measured from anywhere on the line, and with p the primitive lattice vector along it all terms are ((b − a)·p) /
-- (p·p) · √(p·p), an integer multiple of a root. After the end of the half turn lines are read backwards, and the
-- sign changes.

-- | The measure of the lines (du dθ) of each bounded face on the lattice, from its own boundary.
--
-- /Requires/ well-formed tables. /Cost/ O(incidences) multiplications.
boundaryMeasures :: Complex -> [(FaceId, RootSum)]
boundaryMeasures complex =
  [ (f, total f first final)
  | f <- faceIds complex
  , Just first <- [faceFirst complex f]
  , Just final <- [faceLast complex f]
  ]
  where
    lines' = V.generate (vertexTotal complex) (primitiveLine . lineOf complex)
    total f (VertexId first) (VertexId final) =
      sumOf (joints id (upperChain complex f) <> joints negate (lowerChain complex f) <> ends)
      where
        ends =
          concat
            [ term 1 first (cornerOf lower) (cornerOf upper)
            | (upper, lower) <- zip (starts (upperChain complex f)) (starts (lowerChain complex f))
            ]
            <> concat
              [ term (readingOf (upperChain complex f)) final (cornerOf upper) (cornerOf lower)
              | (upper, lower) <- zip (finals (upperChain complex f)) (finals (lowerChain complex f))
              ]
    starts (Chain before after) = take 1 (before <> after)
    finals (Chain before after) = foldl (\_ e -> [e]) [] (before <> after)
    -- −1 where the chain's end is read backwards.
    readingOf (Chain before after)
      | not (null after) || any (wrapsAround complex) before = -1
      | otherwise = 1
    joints toSign (Chain before after) =
      concat
        [ term (toSign (if forward then 1 else -1)) v (cornerOf a) (cornerOf b)
        | (a, b, forward) <- zip3 whole (drop 1 whole) (map (const True) (drop 1 before) <> repeat False)
        , let VertexId v = edgeFirst complex b
        ]
      where
        whole = before <> after
    cornerOf = edgeCorner complex
    -- The sign times t_a − t_b at a vertex.
    term signed v a b = case lines' V.! v of
      Nothing -> []
      Just (px, py, square) ->
        [ (toRational (signed :: Integer) * ((x * px + y * py) % (square * w)), square)
        | a /= b
        , let Way (Vector2 x y) w = way (cornerAt scene b) (cornerAt scene a)
        ]
    scene = complexScene complex
    sumOf = fromMaybe RootSum.zero . RootSum.fromTerms

-- | The primitive vector along a direction, and the square of its length.
primitiveLine :: Direction -> Maybe (Integer, Integer, Integer)
primitiveLine (Direction x y)
  | g == 0 = Nothing
  | otherwise = Just (px, py, px * px + py * py)
  where
    g = gcd x y
    px = x `quot` g
    py = y `quot` g

-- | /Cost/ O(incidences), and a sum of square roots per face.
positiveMeasures :: Law Complex
positiveMeasures =
  lawOf
    "every bounded face has a positive measure"
    "The measure of the lines of a bounded face, an exact sum of square roots from its own boundary, is positive."
    $ \complex ->
      [ faceLabel complex f <> " has the measure " <> show (RootSum.terms area)
      | (FaceId f, area) <- boundaryMeasures complex
      , RootSum.sign area /= Positive
      ]

-- | /Cost/ O(incidences), and that of the sweep and its form factors.
summedMeasures :: Law Complex
summedMeasures =
  lawOf
    "the measures of faces add up to those of the sweep"
    "For each two sides, or a side and the sky, the measures of the faces between them, each from its own boundary, \
    \add up exactly to the measure that the stream of the sweep gives."
    $ \complex ->
      let scene = complexScene complex
          bySides = sumsBy (\(a, b) -> [(min a b, max a b) | (a, b) /= (Sky, Sky)]) complex
          streamed =
            Map.fromList
              [ ((min a b, max a b), RootSum.scaled (latticeScale (sceneLattice scene) % 1) area)
              | ((a, b), area) <- measureList scene (measures scene (vertices scene))
              ]
          both = Map.unionWith (\(a, _) (_, b) -> (a, b)) (with RootSum.zero <$> bySides) (withFirst <$> streamed)
       in [ objectLabel complex (Just a) <> ", " <> objectLabel complex (Just b) <> ": " <> show (RootSum.terms own)
              <> " by faces, "
              <> show (RootSum.terms total)
              <> " by the sweep"
          | ((a, b), (own, total)) <- Map.toList both
          , not (equal own total)
          ]
  where
    with b a = (a, b)
    withFirst b = (RootSum.zero, b)

-- | /Cost/ O(incidences).
closedMeasures :: Law Complex
closedMeasures =
  lawOf
    "the measures of a side's faces add up to twice its length"
    "Every line that meets a side belongs to one of its faces, and the lines that meet it have the measure 2 L: so the \
    \measures of its faces, each from its own boundary, add up to that exactly. This takes nothing from the sweep."
    $ \complex ->
      let scene = complexScene complex
          found = sumsBy (\(a, b) -> [s | Side s <- [a, b]]) complex
       in [ objectLabel complex (Just (Side s)) <> ": " <> show (RootSum.terms total) <> ", twice its length is "
              <> show (RootSum.terms twice)
          | s <- sides scene
          , let Way (Vector2 x y) w = way (cornerAt scene (sideStart s)) (cornerAt scene (sideEnd scene s))
          , let twice = RootSum.hypotenuse (2 % w) x y
          , let total = Map.findWithDefault RootSum.zero s found
          , not (equal total twice)
          ]

-- | The measures of all bounded faces, added up by what their two objects are counted for.
sumsBy :: Ord k => ((Object, Object) -> [k]) -> Complex -> Map.Map k RootSum
sumsBy keys complex =
  RootSum.totalsBy
    [(key, area) | (f, area) <- boundaryMeasures complex, key <- keys (faceBack complex f, faceFront complex f)]

-- | Merged sums with the same terms are equal; others have to be compared.
equal :: RootSum -> RootSum -> Bool
equal a b =
  RootSum.terms (RootSum.merged a) == RootSum.terms (RootSum.merged b) || RootSum.sign (RootSum.minus a b) == Zero
