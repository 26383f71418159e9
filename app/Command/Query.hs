-- | Commands that ask what a scene's complex is: info, graph, factors, complex, verify; and the one that makes scenes.
module Command.Query
  ( runInfo
  , runGraph
  , LineOrder (..)
  , runFactors
  , FactorValues (..)
  , runComplex
  , runVerify
  , runGenerate
  ) where

import Command.Elements (divided)
import Control.Monad (unless)
import Data.ByteString.Builder (Builder, string7, stringUtf8)
import Data.ByteString.Builder.Extra (byteStringCopy)
import Data.Word (Word64)
import Options.Common
import Options.Mesh (Elements (..))
import Progress
import Run (allowMemory, ends, measuring, printed, streamed, sweeping, sweepingPieces, withScene)
import System.CPUTime (getCPUTime)
import Visibility.Complex (Complex, build)
import Visibility.Complex.Law (checked)
import Visibility.Count (count)
import Visibility.Error (Outcome (..))
import Visibility.Exact.Rounding (Digits)
import Visibility.FormFactor (FactorRow (..), decimalFactors, exactFactors, nearestFactors)
import Visibility.Format.Factors
import Visibility.Format.Graph (PairSelection, linesOf, namesOf, pairKeys, sortedLines)
import Visibility.Format.Info (infoText, verdictText)
import Visibility.Format.Json (sceneDocument)
import Visibility.Mesh (elementNames, refinedScene)
import Visibility.Scene.Family (Family, Seed, Size, family)
import Visibility.Sweep (Piece)
import Visibility.View (events)

-- | Counts, and the time it took to find them.
runInfo :: Common -> IO ()
runInfo common = withScene common $ \scene -> do
  begun <- getCPUTime
  counts <- sweeping common scene (\swept -> pure $! count scene (events scene swept))
  ended <- getCPUTime
  printed (stringUtf8 (infoText scene (schedulerChoice common) counts (fromInteger (ended - begun) / 1e12)))

-- | The elementary visible pairs.
runGraph :: Common -> PairSelection -> LineOrder -> IO ()
runGraph common selection order = withScene common $ \scene ->
  let names = namesOf scene
      keys = pairKeys scene names selection
      each :: (Piece -> a) -> ([a] -> IO ()) -> IO ()
      each = sweepingPieces common scene
   in case order of
        ByName -> each keys (printed . sortedLines names)
        AsSwept -> each (linesOf names . keys) (streamed . foldMap byteStringCopy)

data LineOrder = ByName | AsSwept

-- | What stands for a form factor.
data FactorValues
  = -- | A decimal of so many digits, correctly rounded, and perhaps the exact measure.
    Decimals !Digits !Detail
  | -- | The nearest Double.
    NearestDoubles

-- | The form factors.
runFactors :: Common -> FactorFormat -> FactorValues -> Elements -> IO ()
runFactors common format values elements = withScene common $ \file -> divided common elements file $ \cut -> do
  let scene = refinedScene cut
      names = case elements of
        WholeSides -> sideBuilder
        ElementsOf _ -> string7 . elementNames cut
  sums <- measuring common scene
  case values of
    Decimals wanted WithExactMeasures ->
      watched (exactFactors wanted scene sums) $ printed . exactDocument format wanted names scene
    Decimals wanted DecimalsOnly ->
      watched (decimalFactors wanted scene sums) $ printed . decimalDocument format wanted names scene
    NearestDoubles ->
      watched (nearestFactors scene sums) $ printed . nearestDocument format names scene
  where
    watched :: [FactorRow a] -> ([FactorRow a] -> IO ()) -> IO ()
    watched rows act = counting "form factors made" (length . rowFactors) rows >>= act

-- | The whole complex, as a document.
runComplex :: Common -> (Complex -> Builder) -> IO ()
runComplex common shown = withScene common $ \scene -> sweeping common scene (printed . shown . build scene)

-- | A line for each law; exit code 5 if one does not hold.
runVerify :: Common -> IO ()
runVerify common = withScene common $ \scene ->
  sweeping common scene $ \swept -> do
    verdicts <- counting "laws decided" (const 1) (checked (build scene swept))
    printed (stringUtf8 (verdictText verdicts))
    unless (all (null . snd) verdicts) $ ends DifferenceFound

-- | Prints a generated scene.
runGenerate :: Family -> Size -> Seed -> Talk -> Maybe Word64 -> IO ()
runGenerate kind wanted seed talking memory = do
  mapM_ allowMemory memory
  watching talking
  printed (sceneDocument (family kind wanted seed))
