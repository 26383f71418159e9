-- | The laws of the measures of faces, each from the face's own boundary.
module Visibility.Complex.Law.Measure
  ( measureLaws
  , Measured
  , measured
  , boundaryMeasures
  ) where

import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust)
import Data.Ratio ((%))
import Visibility.Complex.Law.Base
import Visibility.Complex.Table
import Visibility.Complex.Type
import Visibility.Complex.Walk.Side (faceMeasure)
import Visibility.Exact.Point
import Visibility.Exact.RootSum (RootSum, Sign (..))
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.FormFactor
import Visibility.Scene
import Visibility.Sorting
import Visibility.Sweep
import Visibility.Sweep.Vertical (objectAt, skyCode)

-- | The measure of the lines (du dθ) of each bounded face in the file's units, from its own boundary.
--
-- /Requires/ well-formed tables. /Cost/ O(incidences) multiplications.
boundaryMeasures :: Complex -> [(FaceId, RootSum)]
boundaryMeasures complex = [(f, faceMeasure complex f) | f <- faceIds complex, Just _ <- [faceFirst complex f]]

-- | A complex, and what breaks the laws of measures in it, object by object.
data Measured = Measured !Complex [Row]

-- | What is wrong with the faces of one object: measures that are not positive, and by how much those with an object
-- that does not come before it, and all together, differ from what they should be.
data Row = Row ![(FaceId, RootSum)] ![((Object, Object), RootSum)] ![(SideId, RootSum)]

-- | What the laws of measures are decided by. Each measure is found twice, at each of the objects that its face sees,
-- so that no more than those of one object need be kept.
--
-- /Cost/ O(incidences) multiplications; a sum of square roots per face and its sign; those of the sweep.
measured :: Complex -> Measured
measured made = Measured complex (rows [0 .. skyCode scene] (measureList scene (measures scene (vertices scene))))
  where
    complex = exactly made
    scene = complexScene complex
    rows (k : others) streamed = case row k own of checked@Row {} -> checked : rows others (drop (length own) streamed)
      where
        own = takeWhile ((== objectAt scene k) . fst . fst) streamed
    rows [] _ = []
    facesBy side = bucketOf (bucketsBy (skyCode scene + 1) (tableNumbers (side complex)))
    (byBack, byFront) = (facesBy faceBacks, facesBy faceFronts)
    row k streamed = foldr seq (Row wrong offSweep offLength) [length wrong, length offSweep, length offLength]
      where
        object = objectAt scene k
        here side found =
          [(side complex f, (f, faceMeasure complex f)) | f <- map FaceId (found k), isJust (faceFirst complex f)]
        (behind, ahead) = (here faceFront byBack, here faceBack byFront)
        own = filter ((>= object) . fst) behind <> filter ((> object) . fst) ahead
        wrong = [face | (_, face@(_, area)) <- own, RootSum.sign area /= Positive]
        offSweep = differences [((object, other), area) | object /= Sky, (other, (_, area)) <- own] streamed
        offLength =
          concat
            [differences [(s, area) | (_, (_, area)) <- behind <> ahead] [doubled s] | Side s <- [object]]
    doubled s =
      let Way (Vector2 x y) w = way (cornerAt scene (sideStart s)) (cornerAt scene (sideEnd scene s))
       in (s, RootSum.hypotenuse (2 % (latticeScale (sceneLattice scene) * w)) x y)

-- | /Cost/ that of going through what is wrong.
measureLaws :: [Law Measured]
measureLaws =
  [ law
      "every bounded face has a positive measure"
      "The measure of the lines of a bounded face, an exact sum of square roots from its own boundary, is positive."
      $ \(Measured complex rows) ->
        [ faceLabel complex f <> " has the measure " <> show (RootSum.terms area)
        | (f, area) <- sortOn fst (concat [wrong | Row wrong _ _ <- rows])
        ]
  , law
      "the measures of faces add up to those of the sweep"
      "For each two sides, or a side and the sky, the measures of the faces between them, each from its own boundary, \
      \add up exactly to the measure that the stream of the sweep gives."
      $ \(Measured complex rows) ->
        [ objectLabel complex (Just a) <> ", " <> objectLabel complex (Just b) <> tooMuch more
        | Row _ offSweep _ <- rows
        , ((a, b), more) <- offSweep
        ]
  , law
      "the measures of a side's faces add up to twice its length"
      "Every line that meets a side belongs to one of its faces, and the lines that meet it have the measure 2 L: so \
      \the measures of its faces, each from its own boundary, add up to that exactly. This takes nothing from the \
      \sweep."
      $ \(Measured complex rows) ->
        [objectLabel complex (Just (Side s)) <> tooMuch more | Row _ _ offLength <- rows, (s, more) <- offLength]
  ]
  where
    tooMuch more = ": too much by " <> show (RootSum.terms more)

-- | By key, the total of one list less that of another, where that is not zero.
differences :: Ord k => [(k, RootSum)] -> [(k, RootSum)] -> [(k, RootSum)]
differences found expected = filter (not . isZero . snd) (Map.toList (RootSum.totalsBy (found <> less)))
  where
    less = [(k, negate x) | (k, x) <- expected]
    isZero = null . RootSum.terms . RootSum.merged
