-- | The command that solves for radiosity.
module Command.Radiosity
  ( runRadiosity
  , solved
  ) where

import Command.Mesh (divided)
import Data.Maybe (fromMaybe)
import Options
import Run (complain, ends, measuring, printed, withScene)
import Visibility.Error (Outcome (..))
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Exact.Rounding (decimal, defaultDigits, digits, outwardDecimals)
import Visibility.Format.Radiosity (radiosityDocument)
import Visibility.Mesh (Refined, refinedScene)
import Visibility.Radiosity

-- | Radiosities with their bounds; or how close bounds can be, where they cannot be as close as asked.
runRadiosity :: Common -> RadiosityOptions -> IO ()
runRadiosity common options = withScene common $ \scene ->
  divided common (radiosityElements options) scene $ \cut ->
    solved common (radiosityCloseness options) cut (printed . radiosityDocument)

-- | Works on the radiosities of elements; or ends the program where bounds cannot be as close as asked.
solved :: Common -> Closeness -> Refined -> (Radiosity -> IO ()) -> IO ()
solved common closeness cut work = do
  sums <- measuring common (refinedScene cut)
  case radiosityOfElements closeness cut sums of
    Right found -> work found
    Left shortfall -> do
      complain [sceneFile common <> ": " <> shortfallText closeness shortfall]
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
