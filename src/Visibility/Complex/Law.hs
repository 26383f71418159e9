-- | What must hold of the complex of a scene: named laws, each decided exactly from the tables and the scene,
-- whatever made the tables.
--
-- Most cost O(incidences). Those of the vertices and of measures cost a sweep, and a sum of roots for each face; those
-- of pairs and rays O(log n) for each pair or stretch where few sides lie about its way, O(n) at worst, and that of
-- sections as much for each corner and each of eight directions.
module Visibility.Complex.Law
  ( Law (..)
  , laws
  , checked
  , violations
  ) where

import Visibility.Complex.Law.Base
import Visibility.Complex.Law.Face
import Visibility.Complex.Law.Local
import Visibility.Complex.Law.Measure
import Visibility.Complex.Law.Polygons
import Visibility.Complex.Law.Section
import Visibility.Complex.Law.Table
import Visibility.Complex.Polygons
import Visibility.Complex.Type (Complex)
import Visibility.Law

-- | All laws. The first one says that the tables are well formed; the others may be asked of well-formed tables only,
-- with whatever values.
laws :: [Law Complex]
laws = wellFormed : others measured

-- | All others, given how measures are found.
others :: (Complex -> Measured) -> [Law Complex]
others measuring =
  [vertexStretches, cornerLinks, cornerDirections, cornersOnLine, pairsSee, sweptVertices]
    <> localLaws
    <> faceLaws
    <> [one {lawViolations = lawViolations one . measuring} | one <- measureLaws]
    <> [raysConfirm, sections]

-- | Each law, now of anything, with what violates it in a complex: first the laws of the complex, then, if they all
-- hold, those of its complex of polygons. If the tables are not well formed, this law alone.
checked :: Complex -> [(Law (), [Violation])]
checked complex
  | all (null . snd) verdicts = verdicts <> map (decided (polygonComplex (exactly complex))) polygonLaws
  | otherwise = verdicts
  where
    verdicts = case decided complex wellFormed of
      verdict@(_, []) -> verdict : map (decided complex) (others (const measures))
      broken' -> [broken']
    measures = measured complex
    decided :: a -> Law a -> (Law (), [Violation])
    decided made one = (one {lawViolations = const found}, found)
      where
        found = lawViolations one made

-- | Everything that is wrong with a complex, law by law; nothing for one that "Visibility.Complex.Build" makes. If the
-- tables are not well formed, only how.
--
-- /Degenerate cases/ a scene under 'Visibility.Exact.Point.UnsafeDouble' is judged by exact signs all the same.
--
-- /Cost/ see 'laws'.
violations :: Complex -> [Violation]
violations = concatMap snd . checked
