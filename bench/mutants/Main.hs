-- | Asks whether the tests notice faults in the modules that decide: @mutants WORK COUNT SEED GROUP …@ makes COUNT
-- small faults in each group of modules, one at a time, compiles the module that has it at -O0, and puts it to the
-- tests of its group, those that take least first. It says of each fault what became of it, and at the end how many
-- there were in each module. @MODULE:LINE@ instead of a group makes all faults of a line.
--
-- WORK holds a copy of the modules in @src@, in which the faults are made. Which faults are made depends on the
-- sources, COUNT and SEED alone. Those that do not compile are passed over. The tests have several times the processor
-- time that they take without a fault; if that is not enough, the fault counts as noticed, and is told apart.
module Main (main) where

import Control.Monad (forM, unless, when)
import Data.List (intercalate, isPrefixOf, nub, sortOn, transpose)
import Mutation
import System.Environment (getArgs)
import System.Exit
import System.FilePath ((</>))
import System.IO
import System.Posix.Process (ProcessTimes (..), getProcessTimes)
import System.Process
import System.Random.SplitMix
import Text.Read (readMaybe)

-- | Modules that decide together, and their tests.
data Group = Group {groupName :: String, groupModules :: [String], groupStages :: [Stage]}

-- | Specs, and for how many cases each of their properties is asked.
data Stage = Stage {stageCases :: Int, stageSpecs :: [String]}

-- | The later stages see what got through the earlier ones.
groups :: [Group]
groups =
  [ Group "predicates" ["Exact.Predicate", "Exact.DoubleDouble", "Exact.Lattice"]
      [Stage 20 exact, Stage 150 exact]
  , Group "roots" ["Exact.RootSum", "Exact.Rounding"]
      [Stage 20 roots, Stage 100 roots]
  , Group "sweep" ("Sweep.Topological" : map ("Sweep.HorizonTree" <>) ["", ".Plant", ".Frame", ".Table"])
      [Stage 5 ["Sweep.TopologicalSpec"], Stage 20 ["Sweep.TopologicalSpec"]]
  , Group "boundary" (map ("Scene." <>) ["Boundary", "Scan", "Status", "Touching"])
      [Stage 2 scenes, Stage 10 scenes]
  ]
  where
    exact = map ("Exact." <>) ["PredicateSpec", "DoubleDoubleSpec", "LatticeSpec", "PointSpec"]
    roots = map ("Exact." <>) ["RootSumSpec", "RoundingSpec", "SquareClassSpec"]
    scenes = map ("Scene." <>) ["StatusSpec", "TouchingSpec", "BoundarySpec", "ValidateSpec"]

-- | What became of a fault.
data Verdict
  = Noticed String
  -- ^ By the example of this name, or by what ended the tests.
  | TimedOut
  | Left'
  deriving (Eq)

main :: IO ()
main = do
  arguments <- getArgs
  hSetBuffering stdout LineBuffering
  hSetEncoding stdout utf8
  case arguments of
    work : count : seed : wanted | Just n <- readMaybe count, Just g <- readMaybe seed, not (null wanted) -> do
      results <- forM wanted $ \name -> case filter ((== name) . groupName) groups of
        group : _ -> drawn (mkSMGen g) (groupModules group) >>= tested work n group
        [] -> case [(group, m) | group <- groups, m <- groupModules group, (m <> ":") `isPrefixOf` name] of
          (group, m) : _ -> do
            source <- readFile (sourceIn "src" m)
            let isThere mutant = show (lineOf source mutant) == drop (length m + 1) name
            tested work maxBound group [Candidate m source mutant | mutant <- mutants source, isThere mutant]
          [] -> die ("No group: " <> name <> "; there are " <> unwords (map groupName groups) <> " and MODULE:LINE")
      putStr (table (concat results))
    _ -> die "mutants WORK COUNT SEED GROUP …"

sourceIn :: FilePath -> String -> FilePath
sourceIn folder m = folder </> "Visibility" </> map (\c -> if c == '.' then '/' else c) m <> ".hs"

lineOf :: String -> Mutant -> Int
lineOf source mutant = 1 + length (filter (== '\n') (take (mutantFrom mutant) source))

-- | A module, its source, and a fault.
data Candidate = Candidate String String Mutant

-- | All faults of the modules in the order in which they are tried: by turns from each module, and of each module by
-- turns of each kind, drawn by the seed.
drawn :: SMGen -> [String] -> IO [Candidate]
drawn gen modules = byTurns <$> forM modules queue
  where
    queue m = do
      source <- readFile (sourceIn "src" m)
      let shuffled = map snd (sortOn fst (zip (keys gen) (mutants source)))
      pure (byTurns [[Candidate m source x | x <- shuffled, mutantKind x == kind] | kind <- [minBound ..]])
    keys g = let (key, g') = nextWord64 g in key : keys g'
    byTurns = concat . transpose

-- | Tries faults until so many have been put to the tests.
tested :: FilePath -> Int -> Group -> [Candidate] -> IO [(String, Verdict)]
tested work count group candidates = do
  specMain work group
  compiles <- compiled work
  unless compiles $ readFile (work </> "log") >>= die
  limits <- case groupStages group of
    [] -> pure []
    stages@(fewest : _) -> do
      before <- childTime
      verdict <- run work 3600 fewest
      after <- childTime
      when (verdict /= Left') $ die ("The tests of " <> groupName group <> " fail without a fault: " <> work </> "log")
      let limit stage = 4 * (after - before) * fromIntegral (stageCases stage) / fromIntegral (stageCases fewest)
      pure (map (ceiling . limit) stages)
  putStrLn (groupName group <> ": the tests have " <> intercalate ", " (map show limits) <> " s of processor time")
  go limits [] candidates
  where
    go _ found [] = pure found
    go _ found _ | length found >= count = pure found
    go limits found (Candidate m source mutant : rest) = do
      let place = sourceIn (work </> "src") m
          old = take (mutantLength mutant) (drop (mutantFrom mutant) source)
          at = lineOf source mutant
      writeFile place (mutated mutant source)
      compiles <- compiled work
      verdict <- if compiles then Just <$> noticed (zip limits (groupStages group)) else pure Nothing
      writeFile place source
      case verdict of
        Nothing -> go limits found rest
        Just v -> do
          putStrLn (intercalate "\t"
            [ said v, m <> ":" <> show at, "‹" <> mutantText mutant <> "› for ‹" <> unwords (words old) <> "›"
            , unwords (words (lines source !! (at - 1)))
            ])
          go limits ((m, v) : found) rest
    noticed ((limit, stage) : more) = do
      verdict <- run work limit stage
      if verdict == Left' then noticed more else pure verdict
    noticed [] = pure Left'
    said (Noticed by) = "noticed by " <> by
    said TimedOut = "timed out"
    said Left' = "NOT NOTICED"

-- | The processor time of all processes that have been waited for.
childTime :: IO Double
childTime = (\times -> fromIntegral (fromEnum (childUserTime times)) / 100) <$> getProcessTimes

-- | The suite of a group.
specMain :: FilePath -> Group -> IO ()
specMain work group = do
  let specs = nub (concatMap stageSpecs (groupStages group))
      text = unlines $
        ["module Main (main) where", "", "import Test.Hspec"]
          <> map ("import qualified Visibility." <>) specs
          <> ["", "main :: IO ()", "main = hspec $ do"]
          <> ["  describe " <> show s <> " Visibility." <> s <> ".spec" | s <- specs]
  writeFile (work </> "Main.hs") text

compiled :: FilePath -> IO Bool
compiled work = (== ExitSuccess) <$> logged work "ghc"
  [ "-O0", "-w", "-v0", "-rtsopts", "-optl-fuse-ld=gold", "-outputdir", work </> "objects"
  , "-i" <> work </> "src", "-ilaws", "-itest", work </> "Main.hs", "-o", work </> "spec"
  ]

-- | Runs a stage, for so many seconds of processor time at most.
run :: FilePath -> Int -> Stage -> IO Verdict
run work limit (Stage cases specs) = do
  code <- logged work "bash" $
    ["-c", "ulimit -t " <> show limit <> "; exec timeout " <> show (20 * limit) <> " \"$@\"", "run", work </> "spec"
    , "--seed=1", "--fail-fast", "--qc-max-shrinks=0", "--qc-max-success=" <> show cases, "--skip=up to 2^14 corners" ]
    <> ["--match=" <> s <> "/" | s <- specs] <> ["+RTS", "-A16m", "-M1g", "-RTS"]
  said <- readFile (work </> "log")
  pure $! length said `seq` case code of
    ExitSuccess -> Left'
    ExitFailure status | status `elem` [124, 137, 152, -9, -24] -> TimedOut
    _ -> Noticed (concat (take 1 ([drop 5 l | l <- lines said, "  1) " `isPrefixOf` l] <> ["an end of the program"])))

-- | Its output goes to the log.
logged :: FilePath -> FilePath -> [String] -> IO ExitCode
logged work command arguments = withFile (work </> "log") WriteMode $ \file ->
  withCreateProcess (proc command arguments) {std_out = UseHandle file, std_err = UseHandle file} $ \_ _ _ process ->
    waitForProcess process

-- | By module: how many faults, noticed by tests, timed out, left.
table :: [(String, Verdict)] -> String
table results = unlines (header : map row (nub (map fst results)))
  where
    header = "| module | faults | noticed by a test | timed out | left |\n|---|---|---|---|---|"
    row m = "| " <> intercalate " | " (("`" <> m <> "`") : map show (counts [v | (m', v) <- results, m' == m])) <> " |"
    counts vs = map length [vs, [v | v@(Noticed _) <- vs], filter (== TimedOut) vs, filter (== Left') vs]
