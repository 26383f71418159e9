-- | The command line where something fails that is not the program's: writing, memory, signals. The file that @-o@
-- names is whole, new or old, nothing else is left beside it, and the exit code is one of the list.
module Command.FaultSpec (spec) where

import Command.Run
import Control.Concurrent (threadDelay)
import Control.Monad (void, when)
import qualified Data.ByteString.Char8 as Bytes
import Data.Foldable (for_)
import Data.List (isInfixOf, isPrefixOf, sort)
import System.Directory (doesFileExist, getFileSize, listDirectory)
import System.Environment (getEnvironment)
import System.Exit (ExitCode (..))
import System.FilePath (takeDirectory, (</>))
import System.IO.Temp (withSystemTempDirectory)
import System.Process
import Test.Hspec

spec :: Spec
spec = describe "faults" $ do
  describe "of writing: the file named stays what it was, or is new" $
    aroundAll withShim $ do
      for_ [(28, "no space is left"), (5, "the device failed"), (122, "the quota")] $ \(number, text) ->
        it ("when one call fails with the error: " <> text) $ \shim ->
          for_ figures $ \figure ->
            for_ [Just "old", Nothing] $ \old -> do
              faults <- eachCall shim "FAULT_ERROR" number figure old $ \file code err -> do
                code `shouldBe` 2
                err `shouldSatisfy` isInfixOf ("cannot be written: " <> text)
                untouched file old
              faults `shouldSatisfy` (>= 4)
      for_ [("HUP", 1), ("INT", 2), ("QUIT", 3), ("PIPE", 13), ("TERM", 15)] $ \(name, number) ->
        it ("when the signal " <> name <> " comes before any call, which ends the program") $ \shim -> do
          let ended file code err = whole file >> ((code, err) `shouldBe` (negate number, ""))
          calls <- eachCall shim "FAULT_SIGNAL" number (head' figures) (Just "old") ended
          calls `shouldSatisfy` (>= 5)
      it "when standard output fails, of every command" $ \shim ->
        for_ commands $ \command -> do
          (code, _, err) <- runWith [("LD_PRELOAD", shim), ("FAULT_AT", "1"), ("FAULT_ERROR", "28")] command
          (command, code) `shouldBe` (command, 2)
          err `shouldSatisfy` isInfixOf "standard output: cannot be written: no space is left"
  it "of a limit of file sizes are told" $
    beside (Just "old") $ \file -> do
      (code, err) <- limited "-f 4" (["draw", "scene", "scenes/room.json", "-o", file])
      code `shouldBe` 2
      err `shouldSatisfy` isInfixOf "larger than is allowed"
      untouched file (Just "old")
  it "of the time: a signal ends the program at any moment" $
    for_ [1, 20, 60, 150] $ \milliseconds -> for_ ["INT", "TERM", "HUP"] $ \signal ->
      beside (Just "old") $ \file -> do
        exe <- executable
        (_, _, _, process) <- createProcess (proc exe ["draw", "dual", "scenes/city.json", "-o", file])
        threadDelay (milliseconds * 1000)
        pid <- getPid process
        for_ pid $ \number -> readProcessWithExitCode "kill" ["-" <> signal, show number] ""
        code <- waitForProcess process
        code `shouldSatisfy` (`elem` (ExitSuccess : map (ExitFailure . negate) [1, 2, 15]))
        whole file
  it "of a closed pipe end the program by that signal, quietly" $ do
    exe <- executable
    readProcessWithExitCode "bash" ["-c", "set -o pipefail; " <> exe <> " graph --unsorted scenes/city.json | true"] ""
      `shouldReturn` (ExitFailure 141, "", "")
  it "of memory end with exit code 6, at any bound" $ do
    codes <- concat <$> mapM bounded [("--memory", [16, 24 .. 72]), ("-v", [44, 60 .. 140])]
    filter (`notElem` [0, 6]) codes `shouldBe` []
    length (filter (== 6) codes) `shouldSatisfy` (>= 5)
    refuses 6 ["more memory is needed than the 64M allowed; allow more by --memory"]
      ["mesh", "scenes/two-squares.json", "--breaks", "uniform:1000000", "--max-elements", "9", "--memory", "64M"] ""
    -- What is printed while it is made needs no more, however much it is.
    streamed <- output ["mesh", "scenes/two-squares.json", "--breaks", "uniform:100000", "--memory", "32M"] ""
    length streamed `shouldSatisfy` (> 32 * 1000 * 1000)
    refuses 6 ["more memory"] ["info", "/dev/zero", "--memory", "64M"] ""
    refuses 1 ["16M to 1024T"] ["info", "scenes/room.json", "--memory", "15M"] ""
  it "of standard files that are full or closed have exit code 2, of help too" $ do
    exe <- executable
    for_ ["--help", "--version", "graph --help", "info scenes/room.json"] $ \call ->
      for_ [("> /dev/full", "no space is left"), (">&-", "it is closed")] $ \(place, text) -> do
        (code, _, err) <- readProcessWithExitCode "sh" ["-c", exe <> " " <> call <> " " <> place] ""
        (call, place, code) `shouldBe` (call, place, ExitFailure 2)
        err `shouldSatisfy` isInfixOf text
    for_ [("graph scenes/none.json", 2), ("graph --no-such-option", 1), ("graph a \"$(printf '\\374')\"", 1)] $
      \(call, wanted) -> for_ ["2> /dev/full", "2>&-", "2> /dev/null"] $ \place -> do
        (code, _, _) <- readProcessWithExitCode "sh" ["-c", exe <> " " <> call <> " " <> place] ""
        (call, place, code) `shouldBe` (call, place, ExitFailure wanted)
  it "keeps permissions, follows links, and writes to devices, pipes and standard output as they are" $
    beside (Just "old") $ \file -> do
      exe <- executable
      let draw = exe <> " draw scene scenes/room.json -o "
          link = file <> "-link"
          doing command = void (readProcess "sh" ["-c", command] "")
      wanted <- readProcess exe ["draw", "scene", "scenes/room.json"] ""
      doing ("chmod 640 " <> file <> "; ln -s out.svg " <> link <> "; " <> draw <> link)
      readFile file `shouldReturn` wanted
      readProcess "stat" ["-c", "%a %F", file] "" `shouldReturn` "640 regular file\n"
      readProcess "stat" ["-c", "%F", link] "" `shouldReturn` "symbolic link\n"
      readProcess "sh" ["-c", draw <> "/dev/stdout"] "" `shouldReturn` wanted
      doing ("echo before > " <> link <> "; " <> draw <> "/dev/stdout >> " <> file)
      readFile file `shouldReturn` ("before\n" <> wanted)
      readProcess "sh" ["-c", "mkfifo " <> link <> "-p; " <> draw <> link <> "-p & cat " <> link <> "-p; wait"] ""
        `shouldReturn` wanted
      refuses 2 ["no space is left"] ["draw", "scene", "scenes/room.json", "-o", "/dev/full"] ""
      refuses 2 ["it is a folder"] ["draw", "scene", "scenes/room.json", "-o", "docs"] ""
      refuses 2 ["the name is too long"] ["draw", "scene", "scenes/room.json", "-o", replicate 300 'x'] ""
      refuses 2 ["it is a folder"] ["graph", "docs"] ""
  it "listens neither to +RTS nor to GHCRTS" $ do
    (code, _, _) <- run ["info", "scenes/room.json", "+RTS", "-s"] ""
    code `shouldBe` 1
    runWith [("GHCRTS", "-M1k --no-such-flag")] ["graph", "scenes/room.json"]
      >>= \(code', _, err) -> (code', err) `shouldBe` (0, "")
  it "shows names of files alike in every locale, and nothing in them that a terminal would obey" $
    for_ ["C", "POSIX", "C.UTF-8", "de_DE.ISO-8859-1"] $ \locale -> do
      exe <- executable
      let name = "\\303\\274\\374\\033[31m\\n\\342\\200\\256"
          call = exe <> " graph \"$(printf '" <> name <> "')\" 2>&1 | cat -v"
      environment <- getEnvironment
      text <- readCreateProcess (shell call) {env = Just (("LC_ALL", locale) : without ["LC_ALL"] environment)} ""
      text `shouldSatisfy` isPrefixOf "viscomplex: M-CM-<\\xfc\\x1b[31m\\n\\u202e: there is no such file"
  where
    figures = ["scene", "matrix"]
    head' = concat . take 1
    commands =
      map (<> ["scenes/room.json"]) (map pure (words "info graph factors complex mesh radiosity verify"))
        <> [ ["graph", "--unsorted", "scenes/room.json"]
           , ["view", "scenes/room.json", "--corner", "0.0"]
           , ["draw", "dual", "scenes/room.json"]
           , ["generate", "grid", "--size", "4"]
           , ["--help"]
           , ["--version"]
           ]
    bounded (kind, sizes) = mapM (bounding kind) (sizes :: [Int])
    bounding kind size = beside (Just "old") $ \file -> do
      let draw = ["draw", "dual", "scenes/city.json", "-o", file]
      (code, err) <- case kind of
        "--memory" -> (\(code, _, err) -> (code, err)) <$> run (draw <> ["--memory", show size <> "M"]) ""
        _ -> limited (kind <> " " <> show (size * 1024)) draw
      when (code /= 0) $ untouched file (Just "old") >> (err `shouldSatisfy` isInfixOf "viscomplex: ")
      code <$ onlyFile file

-- | Runs an action on a file that is there or not, in a folder of its own.
beside :: Maybe String -> (FilePath -> IO a) -> IO a
beside old act = withSystemTempDirectory "viscomplex" $ \folder -> do
  let file = folder </> "out.svg"
  for_ old (writeFile file)
  act file

-- | The file is what it was, and the only one.
untouched :: FilePath -> Maybe String -> Expectation
untouched file old = do
  there <- doesFileExist file
  size <- if there then Just <$> getFileSize file else pure Nothing
  size `shouldBe` fmap (toInteger . length) old
  onlyFile file

-- | The file is what it was or new, as a whole, and the only one.
whole :: FilePath -> Expectation
whole file = do
  text <- Bytes.readFile file
  (text == Bytes.pack "old" || Bytes.pack "</svg>" `Bytes.isSuffixOf` text) `shouldBe` True
  onlyFile file

onlyFile :: FilePath -> Expectation
onlyFile file = do
  names <- sort <$> listDirectory (takeDirectory file)
  filter (/= "out.svg") names `shouldBe` []

-- | Lets each call that writes meet a fault while a figure is drawn, until there are no more; then the file is new. The
-- number of calls.
eachCall :: FilePath -> String -> Int -> String -> Maybe String -> (FilePath -> Int -> String -> Expectation) -> IO Int
eachCall shim kind number figure old check = go 1
  where
    go k = do
      succeeded <- beside old $ \file -> do
        (code, _, err) <-
          runWith
            [("LD_PRELOAD", shim), ("FAULT_AT", show k), (kind, show number)]
            ["draw", figure, "scenes/two-squares.json", "-o", file]
        if code == 0
          then True <$ whole file <* (getFileSize file >>= (`shouldSatisfy` (> 1000)))
          else False <$ check file code err
      if succeeded then pure (k - 1) else go (k + 1 :: Int)

withShim :: ActionWith FilePath -> IO ()
withShim act = withSystemTempDirectory "viscomplex-shim" $ \folder -> do
  let shim = folder </> "shim.so"
  callProcess "gcc" ["-shared", "-fPIC", "-o", shim, "test/faults/shim.c", "-ldl"]
  act shim

-- | Runs the program with changes to the environment.
runWith :: [(String, String)] -> [String] -> IO (Int, String, String)
runWith changes arguments = do
  exe <- executable
  environment <- getEnvironment
  let changed = changes <> without (map fst changes) environment
  (code, out, err) <- readCreateProcessWithExitCode (proc exe arguments) {env = Just changed} ""
  pure (case code of ExitSuccess -> 0; ExitFailure n -> n, out, err)

without :: [String] -> [(String, String)] -> [(String, String)]
without names = filter ((`notElem` names) . fst)

-- | Runs the program under a limit of the shell.
limited :: String -> [String] -> IO (Int, String)
limited limit arguments = do
  exe <- executable
  let script = "ulimit " <> limit <> "; exec \"$@\""
  (code, _, err) <- readProcessWithExitCode "bash" (["-c", script, "bash", exe] <> arguments) ""
  pure (case code of ExitSuccess -> 0; ExitFailure n -> n, err)
