-- | What specs of estimates share: a scene's exact form factors, and how far an estimate is from them.
module Estimate.Sample
  ( truthIn
  , errorsIn
  , rowSums
  ) where

import Estimate.Matrix
import Visibility.FormFactor
import Visibility.Scene
import Visibility.Sweep

truthIn :: Scene -> Truth
truthIn scene = truthOf scene (formFactors scene (measures scene (vertices scene)))

errorsIn :: Scene -> Matrix -> Errors
errorsIn scene = errorsOf (truthIn scene)

-- | For each side the sum of its form factors, and the part of it that is not covered.
rowSums :: Scene -> Matrix -> [(Double, Double)]
rowSums scene matrix =
  [ (sum [entryAt matrix row column | column <- [0 .. matrixSize matrix]], fromRational (uncovered scene side))
  | (row, side) <- zip [0 ..] (statedSides scene)
  ]
