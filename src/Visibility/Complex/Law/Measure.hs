-- | The laws of the measures of faces, each from the face's own boundary.
module Visibility.Complex.Law.Measure
  ( measureLaws
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

-- | /Cost/ O(incidences) and a sum of square roots per face; the second that of the sweep and its form factors, too.
measureLaws :: [Law Complex]
measureLaws =
  [ lawOf
      "every bounded face has a positive measure"
      "The measure of the lines of a bounded face, an exact sum of square roots from its own boundary, is positive."
      $ \complex ->
        [ faceLabel complex f <> " has the measure " <> show (RootSum.terms area)
        | (FaceId f, area) <- boundaryMeasures complex
        , RootSum.sign area /= Positive
        ]
  , lawOf
      "the measures of faces add up to those of the sweep"
      "For each two sides, or a side and the sky, the measures of the faces between them, each from its own boundary, \
      \add up exactly to the measure that the stream of the sweep gives."
      $ \complex ->
        let scene = complexScene complex
            ordered (a, b) = (min a b, max a b)
            streamed = [(ordered seen, area) | (seen, area) <- measureList scene (measures scene (vertices scene))]
         in [ objectLabel complex (Just a) <> ", " <> objectLabel complex (Just b) <> ": too much by "
                <> show (RootSum.terms more)
            | ((a, b), more) <- differences (sumsBy (\seen -> [ordered seen | seen /= (Sky, Sky)]) complex) streamed
            ]
  , lawOf
      "the measures of a side's faces add up to twice its length"
      "Every line that meets a side belongs to one of its faces, and the lines that meet it have the measure 2 L: so \
      \the measures of its faces, each from its own boundary, add up to that exactly. This takes nothing from the \
      \sweep."
      $ \complex ->
        let scene = complexScene complex
            lengths =
              [ (s, RootSum.hypotenuse (2 % (latticeScale (sceneLattice scene) * w)) x y)
              | s <- sides scene
              , let Way (Vector2 x y) w = way (cornerAt scene (sideStart s)) (cornerAt scene (sideEnd scene s))
              ]
         in [ objectLabel complex (Just (Side s)) <> ": too much by " <> show (RootSum.terms more)
            | (s, more) <- differences (sumsBy (\(a, b) -> [s | Side s <- [a, b]]) complex) lengths
            ]
  ]

-- | The measures of all bounded faces, by what their two objects are counted for.
sumsBy :: ((Object, Object) -> [k]) -> Complex -> [(k, RootSum)]
sumsBy keys complex =
  [(key, area) | (f, area) <- boundaryMeasures complex, key <- keys (faceBack complex f, faceFront complex f)]

-- | By key, the total of one list less that of another, where that is not zero.
differences :: Ord k => [(k, RootSum)] -> [(k, RootSum)] -> [(k, RootSum)]
differences found expected =
  filter ((/= RootSum.zero) . snd) (Map.toList (RootSum.totalsBy (found <> [(k, negate x) | (k, x) <- expected])))
