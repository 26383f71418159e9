-- | How to test a visibility graph of your own against viscomplex.
--
-- The library @visibility-laws@ makes valid scenes that aim at degeneracy: collinear corners, parallel sides, thin
-- walls. When a scene shows a difference, it is made smaller as long as it still does, so that what is printed at the
-- end is a scene to think about. Run it by @cabal run toy-graph@, from the top folder.
module Main (main) where

import Control.Monad (unless)
import qualified Data.Set as Set
import System.Exit (exitFailure)
import Test.QuickCheck
import Test.QuickCheck.Random (mkQCGen)
import Toy
import Visibility
import Visibility.Scene (cornerPoint)
import Visibility.Test.Generator (ConvexScene (..), Sample (..))

-- | The pairs of corners that see each other with nothing in between, from the sweep.
exactPairs :: Scene -> Pairs
exactPairs scene =
  Set.fromList
    [ (min p q, max p q)
    | vertex <- vertices scene
    , (a, b) <- vertexPairs scene vertex
    , let (p, q) = (at a, at b)
    ]
  where
    at = plain . cornerPoint scene

-- | A scene as the toy has it: its polygons as the file states them.
asToy :: RawScene -> [[Corner]]
asToy = map (map plain . rawCorners) . rawPolygons

plain :: Point -> Corner
plain (Point x y) = (x, y)

-- | Whether the toy finds the pairs of the sweep; if not, those that are missing and those that are too many.
agrees :: ([[Corner]] -> Pairs) -> ConvexScene -> Property
agrees toy (ConvexScene sample) =
  counterexample ("missing: " <> show (Set.toList (exact Set.\\ found))) $
    counterexample ("too many: " <> show (Set.toList (found Set.\\ exact))) (found == exact)
  where
    exact = exactPairs (sampleScene sample)
    found = toy (asToy (sampleRaw sample))

main :: IO ()
main = do
  putStrLn "The first try is refuted by a small scene:"
  first <- run (expectFailure (agrees firstTry))
  putStrLn "The second one is right about convex polygons and walls:"
  second <- run (agrees secondTry)
  unless (isSuccess first && isSuccess second) exitFailure
  where
    -- With a seed of its own, it says the same each time.
    run :: Testable property => property -> IO Result
    run = quickCheckWithResult stdArgs {maxSuccess = 300, replay = Just (mkQCGen 1, 0)}
