-- | What became of the laws of a complex, for people.
module Visibility.Format.Verdict
  ( verdictText
  ) where

import Visibility.Complex.Law (Law (..))
import Visibility.Law (Violation (..))

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
