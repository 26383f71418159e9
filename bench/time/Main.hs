-- | The time of single parts of the work and of whole commands, measured by criterion. Options are criterion's; @--csv@
-- writes what the table of ratios is made from.
--
-- The yardstick is work of the containers library alone: times are compared with those of another machine in units of
-- it.
module Main (main) where

import Bench.Scenes
import Control.Exception (bracket)
import Criterion.Main
import qualified Data.ByteString as Bytes
import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl')
import Data.Maybe (maybeToList)
import System.Directory (getTemporaryDirectory, removeDirectoryRecursive)
import System.Environment (lookupEnv)
import System.Exit (ExitCode (..), die)
import System.FilePath ((</>))
import System.IO (IOMode (WriteMode), withFile)
import System.IO.Temp (createTempDirectory)
import System.Process (CreateProcess (..), StdStream (..), proc, waitForProcess, withCreateProcess)
import Visibility.Complex (complexOf, faceIds)
import Visibility.Exact.Point (Arithmetic (..))
import Visibility.Exact.Predicate (Turn (LeftTurn), turn)
import Visibility.Exact.RootSum (Sign (Zero), fromTerms, merged, sign, terms)
import Visibility.Exact.Rounding (decimal, defaultDigits, nearestDouble)
import Visibility.FormFactor
  ( FactorRow (..)
  , FormFactor (..)
  , decimalFactors
  , formFactors
  , measureList
  , measures
  , nearestFactors
  )
import Visibility.Format.File (readSceneBytes)
import Visibility.Scene
import Visibility.Scene.Family (Family (..))
import Visibility.Scene.Validate (validate)
import Visibility.Sweep
import Visibility.View (events)

main :: IO ()
main = do
  exe <- lookupEnv "VISCOMPLEX_EXE" >>= maybe (die "VISCOMPLEX_EXE must name the program") pure
  bracket ((`createTempDirectory` "viscomplex-bench") =<< getTemporaryDirectory) removeDirectoryRecursive $
    \folder -> do
    let files = [(folder </> ("random-" <> show n <> ".json"), n) | n <- [30, 100, 1000]]
    mapM_ (\(path, n) -> Bytes.writeFile path (fileOf Random n)) files
    defaultMain (yardstick : parts <> [commands exe files])

yardstick :: Benchmark
yardstick = bench "yardstick" (whnf (foldl' enter IntMap.empty) [1 .. 16384 :: Int])
  where
    enter m k = IntMap.insert (k * 7919 `mod` 65537) k m

parts :: [Benchmark]
parts =
  [ bgroup
      "predicates, 1000 turns"
      [ bench "machine integers" (whnf lefts (sceneOf Random 1000))
      , bench "filter" (whnf lefts (sceneOf Kettner 400))
      , bench "integers" (whnf lefts (underArithmetic Exact (sceneOf Random 1000)))
      ]
  , bgroup
      "scene"
      [ bench "read, 1000 quadrilaterals" (whnf (readSceneBytes "scene.json") (fileOf Random 1000))
      , bench "validate, 1000 quadrilaterals" (whnf validate (rawOf Random 1000))
      ]
  , bgroup
      "sweep"
      [ bench (show kind <> ", " <> show n) (whnf (sum . map pieceLength . verticesInPieces) (sceneOf kind n))
      | (kind, n) <- [(Random, 100), (Random, 1000), (Grid, 400), (Checkerboard, 400), (Needles, 300)]
      ]
  , bgroup
      "views"
      [ bench "events, 1000 quadrilaterals" (whnf (\s -> length (events s (vertices s))) (sceneOf Random 1000))
      , bench "all tables, 100 quadrilaterals" (whnf (length . faceIds . complexOf) (sceneOf Random 100))
      ]
  , bgroup
      "form factors, sweep included"
      [ bench "exact values, 100 quadrilaterals" (whnf exactTerms (sceneOf Random 100))
      , bench "exact values, 1000 quadrilaterals" (whnf exactTerms (sceneOf Random 1000))
      , bench "17 digits, 1000 quadrilaterals" $
          whnf
            (\s -> sum (map (sum . map (Bytes.length . snd) . rowFactors) (decimalFactors defaultDigits s (swept s))))
            (sceneOf Random 1000)
      , bench "Doubles, 1000 quadrilaterals" $
          whnf (\s -> sum (map (sum . map snd . rowFactors) (nearestFactors s (swept s)))) (sceneOf Random 1000)
      ]
  , bgroup
      "root sums"
      [ bench "merge, 64 terms" (nf (map (terms . merged)) longSums)
      , bench "sign, 64 terms" (nf (map ((== Zero) . sign)) longSums)
      , bench "measures, 100 quadrilaterals" $
          whnf (\s -> length (measureList s (measures s (vertices s)))) (sceneOf Random 100)
      ]
  , bgroup
      "rounding, 64 terms"
      [ bench "17 digits" (nf (map (decimal defaultDigits)) longSums)
      , bench "Double" (nf (map nearestDouble) longSums)
      ]
  ]
  where
    swept s = measures s (vertices s)
    exactTerms s = sum (map (length . terms . factorValue) (formFactors s (swept s)))
    longSums = maybeToList (fromTerms [(fromInteger (k * 17 `mod` 29 - 14) / 3, k * k + 1) | k <- [1 .. 64]])

-- | How many of a thousand triples of corners turn left.
lefts :: Scene -> Int
lefts scene = length (filter isLeft [0 .. 999])
  where
    points = scenePoints scene
    n = cornerCount scene
    isLeft k = turn points (k * 7919 `mod` n) (k * 104729 `mod` n) (k * 1299709 `mod` n) == LeftTurn

commands :: FilePath -> [(FilePath, Int)] -> Benchmark
commands exe files =
  bgroup
    "commands"
    [ bench (unwords arguments <> ", " <> show n <> " quadrilaterals") (nfIO (run (arguments <> [path])))
    | (arguments, n) <-
        [ (["info"], 100)
        , (["graph", "--unsorted"], 1000)
        , (["graph"], 1000)
        , (["complex"], 100)
        , (["factors"], 30)
        , (["factors"], 100)
        , (["factors"], 1000)
        , (["factors", "--exact"], 1000)
        , (["factors", "--double"], 1000)
        ]
    , (path, k) <- files
    , k == n
    ]
  where
    run arguments = withFile "/dev/null" WriteMode $ \sink ->
      withCreateProcess (proc exe arguments) {std_out = UseHandle sink} $ \_ _ _ process -> do
        code <- waitForProcess process
        case code of
          ExitSuccess -> pure ()
          ExitFailure k -> die (unwords (exe : arguments) <> " ended with exit code " <> show k)
