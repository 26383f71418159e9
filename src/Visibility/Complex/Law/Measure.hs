-- | The laws of the measures of faces, each from the face's own boundary.
module Visibility.Complex.Law.Measure
  ( positiveMeasures
  , summedMeasures
  , closedMeasures
  , boundaryMeasures
  ) where

import qualified Data.Map.Strict as Map
import Data.Ratio ((%))
import Visibility.Complex.Law.Base
import Visibility.Complex.Type
import Visibility.Complex.Walk.Side (faceMeasure)
import Visibility.Exact.Point
import Visibility.Exact.RootSum (RootSum, Sign (..))
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.FormFactor
import Visibility.Scene
import Visibility.Sweep

-- | The measure of the lines (du dθ) of each bounded face in the file's units, from its own boundary.
--
-- /Requires/ well-formed tables. /Cost/ O(incidences) multiplications.
boundaryMeasures :: Complex -> [(FaceId, RootSum)]
boundaryMeasures complex = [(f, faceMeasure complex f) | f <- faceIds complex, Just _ <- [faceFirst complex f]]

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
              [ ((min a b, max a b), area)
              | ((a, b), area) <- measureList scene (measures scene (vertices scene))
              ]
          both = Map.unionWith (\(a, _) (_, b) -> (a, b)) (with RootSum.zero <$> bySides) (withFirst <$> streamed)
       in [ objectLabel complex (Just a) <> ", " <> objectLabel complex (Just b) <> ": " <> show (RootSum.terms own)
              <> " by faces, "
              <> show (RootSum.terms total)
              <> " by the sweep"
          | ((a, b), (own, total)) <- Map.toList both
          , own /= total
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
          , let twice = RootSum.hypotenuse (2 % (latticeScale (sceneLattice scene) * w)) x y
          , let total = Map.findWithDefault RootSum.zero s found
          , total /= twice
          ]

-- | The measures of all bounded faces, added up by what their two objects are counted for.
sumsBy :: Ord k => ((Object, Object) -> [k]) -> Complex -> Map.Map k RootSum
sumsBy keys complex =
  RootSum.totalsBy
    [(key, area) | (f, area) <- boundaryMeasures complex, key <- keys (faceBack complex f, faceFront complex f)]
