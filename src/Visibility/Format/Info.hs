-- | The sizes of a scene and of its complex, and what became of the complex's laws, for people.
module Visibility.Format.Info
  ( infoText
  , verdictText
  ) where

import qualified Data.Text as Text
import Numeric (showFFloat)
import Visibility.Complex.Law (Law (..))
import Visibility.Count
import Visibility.Exact.IntegerRoot (bitLength)
import Visibility.Exact.Point
import Visibility.Law (Violation (..))
import Visibility.Scene
import Visibility.Sweep (Scheduler (..))

-- | A line for each size. The last argument is the seconds of processor time that the sweep took.
infoText :: Scene -> Scheduler -> Counts -> Double -> String
infoText scene scheduler counts seconds =
  unlines
    [ padded name <> value
    | (name, value) <-
        [("scene", Text.unpack title) | Just title <- [sceneTitle scene]]
          <> [ ("polygons", show (length (scenePolygons scene)))
             , ("corners", show (length (statedCorners scene)))
             , ("contacts", show (sceneContacts scene))
             , ("vertices", show (vertexCount counts))
             , ("degenerate vertices", show (degenerateCount counts))
             , ("bitangents", show (bitangentCount counts))
             , ("elementary visible pairs", show (pairCount counts))
             , ("edges", show (edgeCount counts))
             , ("faces", show (faceCount counts))
             , ("scheduler", schedulerText scheduler)
             , ("arithmetic", arithmeticText scene)
             , ("time", showFFloat (Just 3) seconds " s")
             ]
    ]
  where
    padded name = name <> replicate (26 - length name) ' '

schedulerText :: Scheduler -> String
schedulerText Topological = "topological"
schedulerText Straight = "straight"
schedulerText Reference = "reference"

-- | The arithmetic, and what it comes to for this scene.
arithmeticText :: Scene -> String
arithmeticText scene = case sceneArithmetic scene of
  Exact -> "exact: integers of any size"
  UnsafeDouble -> "double: unsafe, results may be wrong"
  Filtered -> case pointsKernel (scenePoints scene) of
    MachineKernel _ -> "filtered: the lattice fits machine integers" <> lattice
    _ -> "filtered: floating-point filter, integers behind it" <> lattice
  where
    lattice = " (" <> show (bitLength (latticeScale (sceneLattice scene))) <> "-bit common denominator)"

-- | A line for each law that has been decided: whether it holds, and its name; below one that does not, what it says
-- and its first counter-examples. The last line counts.
verdictText :: [(Law a, [Violation])] -> String
verdictText verdicts = unlines (concatMap block verdicts <> [total])
  where
    block (law, found)
      | null found = ["holds   " <> lawName law]
      | otherwise =
          ("BROKEN  " <> lawName law)
            : ("        " <> lawStatement law)
            : map (("        " <>) . violationDetails) (take shown found)
              <> ["        and " <> show (length found - shown) <> " more" | length found > shown]
    total = show (length verdicts - failures) <> " laws hold, " <> show failures <> " broken"
    failures = length (filter (not . null . snd) verdicts)
    shown = 10
