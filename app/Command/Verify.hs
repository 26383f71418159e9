-- | All laws of a complex, decided.
module Command.Verify
  ( runVerify
  ) where

import Control.Monad (unless)
import Data.ByteString.Builder (stringUtf8)
import Options
import Run (ends, printed, sweeping, withScene)
import Visibility.Complex (build)
import Visibility.Complex.Law (checked)
import Visibility.Error (Outcome (..))
import Visibility.Format.Verdict (verdictText)

-- | A line for each law; exit code 5 if one does not hold.
runVerify :: Common -> IO ()
runVerify common = withScene common $ \scene ->
  sweeping common scene $ \swept -> do
    let verdicts = checked (build scene swept)
    printed (stringUtf8 (verdictText verdicts))
    unless (all (null . snd) verdicts) $ ends DifferenceFound
