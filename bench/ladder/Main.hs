-- | The ladder: the sweeps on scenes of 2^7 to 2^14 corners of every family.
--
-- For each scene: time, allocation and chain steps of the topological sweep per elementary visible pair, the best of
-- several runs in this process; and the time as a ratio to that at 2^8 corners. Then, per vertex, the time of both
-- schedulers and of all tables of the complex, the sweep included, as ratios to the topological sweep alone. Then
-- views: walking in the complex against asking every side. At last the growth of all commands, on adversarial kinds of
-- scenes too, see "Ladder.Growth". Arguments: names of families and kinds, none means all; and @growth@, for the growth
-- alone.
module Main (main) where

import Bench.Scenes
import Control.Exception (evaluate)
import Control.Monad (forM_, unless, zipWithM)
import Data.Foldable (traverse_)
import Data.IORef (newIORef, readIORef)
import Data.List (find, zip4)
import qualified Data.Text as Text
import GHC.Stats (getRTSStats, getRTSStatsEnabled, allocated_bytes)
import Ladder.Growth
import Ladder.Kind
import Ladder.Time
import Numeric (showFFloat)
import System.CPUTime (getCPUTime)
import System.Environment (getArgs)
import System.Exit (die)
import Visibility.Complex (Complex, complexOf, complexScene, faceIds)
import Visibility.Complex.Walk (Look (..), lookAround)
import Visibility.Exact.Point (Point (..))
import Visibility.FormFactor (measureList, measures)
import Visibility.Scene (Scene, cornerCount, cornerPoint, corners)
import Visibility.Scene.Family
import Visibility.Sight (Viewpoint (..))
import Visibility.Sweep (straightVertices, vertexPairs, vertices)
import Visibility.Test.Generator (sizeOfCorners)
import Visibility.Test.Scan (scan)
import Visibility.Test.SweepLaw (searchWork)

main :: IO ()
main = do
  arguments <- getArgs
  let names = filter (/= "growth") arguments
      chosen = [kind | kind <- [minBound ..], null names || Text.unpack (familyName kind) `elem` names]
  climbing <- either (die . ("no kind is named " <>) . unwords) pure (kindsNamed names)
  unless ("growth" `elem` arguments) $ sweeps chosen
  growth climbing

-- | The tables of the sweep, the complex, views and form factors.
sweeps :: [Family] -> IO ()
sweeps chosen = do
  enabled <- getRTSStatsEnabled
  unless enabled $ die "allocations are counted: run with +RTS -T"
  putStrLn (row ["family", "corners", "pairs", "pairs/corner", "us/pair", "growth", "bytes/pair", "steps/pair"])
  forM_ chosen $ \kind -> do
    let scenes = map (sceneOf kind) (ladder kind)
    times <- bestTimes 7 scenes (length . vertices)
    rungs <- zipWithM measured scenes times
    let base = find ((>= 250) . rungCorners) rungs
    traverse_ (putStrLn . rungText (Text.unpack (familyName kind)) base) rungs
  putStrLn ""
  putStrLn (row ["per vertex", "corners", "vertices", "topological", "straight", "ratio", "tables", "ratio"])
  forM_ chosen $ \kind -> do
    let scenes = map (sceneOf kind) (ladder kind)
    stream <- bestTimes 7 scenes (length . vertices)
    straight <- bestTimes 7 scenes (length . straightVertices)
    tables <- bestTimes 7 scenes (length . faceIds . complexOf)
    forM_ (zip4 scenes stream straight tables) $ \(scene, a, b, c) -> do
      let count = length (vertices scene)
          each seconds = microseconds (seconds / fromIntegral count)
          ratio x = showFFloat (Just 2) (x / a) ""
          name = Text.unpack (familyName kind)
      putStrLn (row [name, show (cornerCount scene), show count, each a, each b, ratio b, each c, ratio c])
  putStrLn ""
  putStrLn (row ["view", "corners", "faces/view", "us/view", "us/face", "scan us", "scan/walk"])
  forM_ (ladder Random) $ \count -> do
    let scene = sceneOf Random count
        complex = complexOf scene
        places = lookouts complex
        perView total = total / fromIntegral (length places) :: Double
        faces = sum [lookSteps look | Right look <- map (lookAround complex) places]
        looks found = sum [length (lookSights look) | Right look <- map (lookAround found) places]
    walking <- sum <$> bestTimes 7 [complex] looks
    scanning <- scanned scene (perView walking)
    putStrLn . row $
      [ "random"
      , show (cornerCount scene)
      , showFFloat (Just 1) (perView (fromIntegral faces)) ""
      , microseconds (perView walking)
      , microseconds (walking / fromIntegral faces)
      ]
        <> scanning
  putStrLn ""
  putStrLn (row ["factors", "corners", "pairs", "", "us/pair"])
  let scenes = map (sceneOf Random) [25, 100, 400]
  times <- bestTimes 7 scenes (\s -> length (measureList s (measures s (vertices s))))
  forM_ (zip scenes times) $ \(scene, seconds) -> do
    let pairs = pairCount scene
    putStrLn (row ["random", show (cornerCount scene), show pairs, "", microseconds (seconds / fromIntegral pairs)])

-- | The sizes at which a family has about 2^7 to 2^14 corners; fewer where the number of pairs grows with the square of
-- it.
ladder :: Family -> [Int]
ladder kind = map (sizeOfCorners kind) (takeWhile (<= top) (iterate (* 2) 128))
  where
    top = case kind of
      Sparse -> 2048
      _ -> 16384

-- | Places in and around a scene, in free space or on a boundary, none of them special.
lookouts :: Complex -> [Viewpoint]
lookouts complex = take 40 [place | place <- candidates, Right _ <- [lookAround complex place]]
  where
    scene = complexScene complex
    points = map (cornerPoint scene) (corners scene)
    candidates =
      [ AtPoint (Point ((ax + 2 * bx) / 3 + 1 / 1000) ((ay + 2 * by) / 3 + 1 / 999))
      | (Point ax ay, Point bx by) <- zip points (drop 7 (cycle (reverse points)))
      ]

-- | The time of the test's oracle for a view, from one of the places, and its ratio to that of a walk. It shoots a ray
-- between every two directions to corners at all sides, so it is asked in small scenes only.
scanned :: Scene -> Double -> IO [String]
scanned scene walking = case take 1 (lookouts (complexOf scene)) of
  [AtPoint place] | cornerCount scene <= 512 -> do
    begun <- getCPUTime
    _ <- evaluate (length (show (scan scene place)))
    ended <- getCPUTime
    let seconds = fromInteger (ended - begun) / 1e12
    pure [microseconds seconds, showFFloat (Just 0) (seconds / walking) ""]
  _ -> pure []

pairCount :: Scene -> Int
pairCount scene = sum (map (length . vertexPairs scene) (vertices scene))

data Rung = Rung
  { rungCorners :: !Int
  , rungPairs :: !Int
  , rungSeconds :: !Double
  , rungBytes :: !Double
  , rungSteps :: !Int
  }

measured :: Scene -> Double -> IO Rung
measured scene seconds = do
  (pairs, steps) <- evaluate (searchWork scene)
  held <- newIORef scene
  before <- allocated_bytes <$> getRTSStats
  _ <- readIORef held >>= evaluate . length . vertices
  after <- allocated_bytes <$> getRTSStats
  pure (Rung (cornerCount scene) pairs seconds (fromIntegral (after - before)) steps)

rungText :: String -> Maybe Rung -> Rung -> String
rungText name base rung =
  row
    [ name
    , show (rungCorners rung)
    , show (rungPairs rung)
    , showFFloat (Just 1) (fromIntegral (rungPairs rung) / fromIntegral (rungCorners rung) :: Double) ""
    , microseconds (perPair rung)
    , maybe "" (\b -> showFFloat (Just 2) (perPair rung / perPair b) "") base
    , showFFloat (Just 0) (rungBytes rung / fromIntegral (rungPairs rung)) ""
    , showFFloat (Just 2) (fromIntegral (rungSteps rung) / fromIntegral (rungPairs rung) :: Double) ""
    ]
  where
    perPair r = rungSeconds r / fromIntegral (rungPairs r)
