-- | The command that solves for radiosity.
module Command.Radiosity
  ( runRadiosity
  ) where

import Data.Maybe (fromMaybe)
import Options
import Run (complain, ends, printed, sweepingPieces, withScene)
import Visibility.Error (Outcome (..))
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Exact.Rounding (decimal, defaultDigits, digits, outwardDecimals)
import Visibility.FormFactor (measuresInPieces)
import Visibility.Format.Radiosity (radiosityDocument)
import Visibility.Radiosity

-- | Radiosities with their bounds; or how close bounds can be, where they cannot be as close as asked.
runRadiosity :: Common -> RadiosityOptions -> IO ()
runRadiosity common options = withScene common $ \scene -> do
  sums <- sweepingPieces common OneProcessor scene id (\swept -> pure $! measuresInPieces scene swept)
  let found = case radiosityElements options of
        WholeSides -> radiosity (radiosityCloseness options) scene sums
  case found of
    Right solved -> printed (radiosityDocument solved)
    Left shortfall -> do
      complain [sceneFile common <> ": " <> shortfallText (radiosityCloseness options) shortfall]
      ends WrongUsage

-- | What was asked for, what can be had, and what to ask for.
shortfallText :: Closeness -> Shortfall -> String
shortfallText closeness (Shortfall spread passes) = case (closeness, spread) of
  (WithinTolerance x, Just proved) ->
    "bounds cannot be proved to be within "
      <> short (toleranceValue x)
      <> " with Doubles, but within "
      <> upper (proved * 10 / 9)
      <> afterwards
      <> "; give --tolerance "
      <> upper (proved * 10 / 9)
      <> " or more, or --digits for exact form factors"
  (ToDigits _, Just proved) ->
    "bounds came within " <> upper proved <> afterwards <> ", no closer; give fewer --digits, or lower reflectivities"
  (_, Nothing) -> "no bounds can be proved" <> afterwards <> ": a reflectivity is too near to 1; give lower ones"
  where
    afterwards = " after " <> show passes <> " passes over the form factors"
    short = decimal two . RootSum.rational
    upper q = snd (outwardDecimals two (q, q))
    two = fromMaybe defaultDigits (digits 2)
