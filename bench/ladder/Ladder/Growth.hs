-- | The tables of growth: how the time of commands grows with their input and output, on all kinds of scenes.
module Ladder.Growth
  ( growth
  ) where

import Control.Monad (forM)
import Data.List (intercalate, maximumBy, nub, sortOn)
import Data.Ord (Down (..), comparing)
import Ladder.Kind
import Ladder.Time
import Numeric (showFFloat)
import System.IO
import Visibility.Scene (Scene, cornerCount)
import Visibility.Scene.Raw
import Visibility.Scene.Validate (validate)
import Visibility.Sweep (vertexPairs, vertices)
import Visibility.Test.Part

-- | A part of the work on scenes of a kind that grow.
data Climb = Climb
  { climbKind :: !String
  , climbPart :: !String
  , climbRungs :: ![Rung]
  }

-- | Corners; units of input and output; seconds.
data Rung = Rung !Int !Int !Double

-- | Prints the microseconds for each unit of input and output, of each part of the work on each kind. Then come two
-- tables in Markdown: by what power of the units the time grew between the two largest sizes, by part and by kind.
growth :: [Kind] -> IO ()
growth chosen = do
  hSetBuffering stdout LineBuffering
  putStrLn "microseconds for each unit of input and output, at sizes in corners"
  climbs <- concat <$> mapM climbed chosen
  putStrLn ""
  mapM_ putStrLn (byPart climbs)
  putStrLn ""
  mapM_ putStrLn (byKind climbs)

-- | All parts on one kind, each told when it is done.
climbed :: Kind -> IO [Climb]
climbed kind = do
  check <- climb "check" raws (either (const 0) cornerCount . validate) (\raw _ -> cornersOf raw) cornersOf
  others <- forM parts $ \part ->
    climb (partName part) scenes (partBytes part . fst) (\(_, n) bytes -> n + writtenUnits bytes) (cornerCount . fst)
  pure (check : others)
  where
    raws = takeWhile (either (const False) isModest . validate) (map (kindScene kind) (take 4 (iterate (* 4) 64)))
    scenes = [(scene, sceneUnits scene) | Right scene <- map validate raws]
    cornersOf raw = sum (map cornerTotal (maybe id (:) (rawEnclosure raw) (rawPolygons raw)))
    climb name scenes' work unitsOf corners = do
      tried <- affordable 0.25 scenes' work
      times <- bestTimes 1 (map fst tried) work
      let rungs = [Rung (corners s) (unitsOf s result) seconds | ((s, result), seconds) <- zip tried times]
      putStrLn (rungsText (kindName kind) name rungs)
      pure (Climb (kindName kind) name rungs)

-- | Has a scene few enough pairs for all parts to be tried?
isModest :: Scene -> Bool
isModest scene = null (drop 80000 (concatMap (vertexPairs scene) (vertices scene)))

rungsText :: String -> String -> [Rung] -> String
rungsText kind part rungs =
  kind <> ", " <> part <> ": "
    <> intercalate ", " [microseconds (perUnit rung) <> " at " <> show corners | rung@(Rung corners _ _) <- rungs]
    <> maybe "" ((", power " <>) . two) (power rungs)

perUnit :: Rung -> Double
perUnit (Rung _ count seconds) = seconds / fromIntegral count

-- | By what power of the units the time grew from the rung before the last one to the last one: 1 is linear. Nothing
-- where there are fewer rungs, or hardly more units.
power :: [Rung] -> Maybe Double
power rungs = case reverse rungs of
  Rung _ many slow : Rung _ few fast : _
    | many > 2 * few -> Just (log (slow / fast) / log (fromIntegral many / fromIntegral few))
  _ -> Nothing

-- | A row for each part: its power on the first kinds, then the kinds with the greatest powers; and the kind on which
-- a unit takes the longest.
byPart :: [Climb] -> [String]
byPart climbs =
  tableText (["part"] <> map code friends <> ["worst", "next", "third", "dearest unit"]) $
    [ [code part] <> map (ofKind powers) friends <> take 3 (map told worst <> repeat "") <> [dearest here]
    | part <- nub (map climbPart climbs)
    , let here = filter ((== part) . climbPart) climbs
          powers = [(climbKind c, p) | c <- here, Just p <- [power (climbRungs c)]]
          worst = sortOn (Down . snd) powers
    ]
  where
    friends = take 3 (nub (map climbKind climbs))
    ofKind powers kind = concat [two p | (k, p) <- powers, k == kind]
    told (kind, p) = two p <> " " <> code kind
    dearest here = case [(climbKind c, perUnit (last rungs)) | c <- here, rungs@(_ : _) <- [climbRungs c]] of
      [] -> ""
      costs -> let (kind, cost) = maximumBy (comparing snd) costs in microseconds cost <> " µs " <> code kind

-- | A row for each kind: the parts with the greatest powers.
byKind :: [Climb] -> [String]
byKind climbs =
  tableText ["kind", "corners", "worst", "next", "third"] $
    [ [code kind, show most] <> take 3 (map told worst <> repeat "")
    | kind <- nub (map climbKind climbs)
    , let here = filter ((== kind) . climbKind) climbs
          most = maximum (0 : [corners | c <- here, Rung corners _ _ <- climbRungs c])
          worst = sortOn (Down . snd) [(climbPart c, p) | c <- here, Just p <- [power (climbRungs c)]]
    ]
  where
    told (part, p) = two p <> " " <> code part

tableText :: [String] -> [[String]] -> [String]
tableText titles rows = line titles : line (map (const "---") titles) : map line rows
  where
    line cells = "| " <> intercalate " | " cells <> " |"

code :: String -> String
code word = "`" <> word <> "`"

two :: Double -> String
two x = showFFloat (Just 2) x ""
