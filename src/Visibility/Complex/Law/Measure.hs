-- | The laws of the measures of faces, each from the face's own boundary.
module Visibility.Complex.Law.Measure
  ( measureLaws
  , Measured
  , measured
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

-- | A complex, the faces whose measures are not positive, with these, and for each two objects, the smaller first, the
-- sum of the measures of the faces between them.
data Measured = Measured !Complex [(FaceId, RootSum)] (Map.Map (Object, Object) RootSum)

-- | What the laws of measures are decided by: each measure is found once for all of them.
--
-- /Cost/ O(incidences) multiplications; a sum of square roots per face and its sign.
measured :: Complex -> Measured
measured made = Measured complex [face | face@(_, area) <- found, RootSum.sign area /= Positive] (RootSum.totalsBy sums)
  where
    complex = exactly made
    found = boundaryMeasures complex
    sums = [(ordered (faceBack complex f, faceFront complex f), area) | (f, area) <- found]

ordered :: Ord a => (a, a) -> (a, a)
ordered (a, b) = (min a b, max a b)

-- | /Cost/ that of adding up; of the second that of the sweep and its form factors, too.
measureLaws :: [Law Measured]
measureLaws =
  [ law
      "every bounded face has a positive measure"
      "The measure of the lines of a bounded face, an exact sum of square roots from its own boundary, is positive."
      $ \(Measured complex wrong _) ->
        [faceLabel complex f <> " has the measure " <> show (RootSum.terms area) | (f, area) <- wrong]
  , law
      "the measures of faces add up to those of the sweep"
      "For each two sides, or a side and the sky, the measures of the faces between them, each from its own boundary, \
      \add up exactly to the measure that the stream of the sweep gives."
      $ \(Measured complex _ sums) ->
        let scene = complexScene complex
            streamed = [(ordered seen, area) | (seen, area) <- measureList scene (measures scene (vertices scene))]
         in [ objectLabel complex (Just a) <> ", " <> objectLabel complex (Just b) <> ": too much by "
                <> show (RootSum.terms more)
            | ((a, b), more) <- differences (Map.toList (Map.delete (Sky, Sky) sums)) streamed
            ]
  , law
      "the measures of a side's faces add up to twice its length"
      "Every line that meets a side belongs to one of its faces, and the lines that meet it have the measure 2 L: so \
      \the measures of its faces, each from its own boundary, add up to that exactly. This takes nothing from the \
      \sweep."
      $ \(Measured complex _ sums) ->
        let scene = complexScene complex
            lengths =
              [ (s, RootSum.hypotenuse (2 % (latticeScale (sceneLattice scene) * w)) x y)
              | s <- sides scene
              , let Way (Vector2 x y) w = way (cornerAt scene (sideStart s)) (cornerAt scene (sideEnd scene s))
              ]
         in [ objectLabel complex (Just (Side s)) <> ": too much by " <> show (RootSum.terms more)
            | (s, more) <- differences [(s, area) | ((a, b), area) <- Map.toList sums, Side s <- [a, b]] lengths
            ]
  ]

-- | By key, the total of one list less that of another, where that is not zero.
differences :: Ord k => [(k, RootSum)] -> [(k, RootSum)] -> [(k, RootSum)]
differences found expected =
  filter ((/= RootSum.zero) . snd) (Map.toList (RootSum.totalsBy (found <> [(k, negate x) | (k, x) <- expected])))
