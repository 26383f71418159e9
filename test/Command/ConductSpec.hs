-- | How the command line takes mistakes: what was meant is guessed, and all of it ends with exit code 1.
module Command.ConductSpec (spec) where

import Command.Run
import Data.Char (isAlpha)
import Data.Foldable (for_)
import Data.List (isInfixOf, isPrefixOf, nub, sort)
import System.Process (readProcessWithExitCode)
import Test.Hspec

spec :: Spec
spec = do
  it "every command that help lists has a help of its own, whose options are told from ones misspelt" $
    for_ commands $ \command -> do
      page <- output ("help" : words command) ""
      page `shouldSatisfy` isInfixOf ("viscomplex " <> command)
      for_ (optionsIn page) $ \option -> do
        -- Two letters changed places in what is long enough to be known again.
        let misspelt = take 3 option <> reverse (take 2 (drop 3 option)) <> drop 5 option
        if length option < 7 || misspelt == option || misspelt `elem` optionsIn page
          then pure ()
          else do
            (code, out, err) <- run (words command <> ["scenes/room.json", misspelt]) ""
            (command, option, code, out) `shouldBe` (command, option, 1, "")
            err `shouldSatisfy` isInfixOf ("unknown option " <> misspelt <> "; did you mean " <> option)
            err `shouldSatisfy` isPrefixOf ("viscomplex: " <> command <> ": ")
  it "commands, figures and values are guessed" $ do
    refuses 1 ["viscomplex: unknown command grpah; did you mean graph?"] ["grpah"] ""
    refuses 1 ["unknown figure secne; did you mean scene?"] ["draw", "secne", "scenes/room.json"] ""
    refuses 1 ["dobule", "did you mean double?"] ["graph", "scenes/room.json", "--arithmetic", "dobule"] ""
    refuses 1 ["did you mean random?"] ["generate", "radnom", "--size", "3"] ""
  it "corners and sides that are not there are refused with those that are" $ do
    for_ ["view scenes/two-squares.json --corner", "view scenes/two-squares.json --side"] $ \call -> do
      refuses 1 ["give one of 0 to 1"] (words call <> ["18446744073709551616.0"]) ""
      refuses 1 ["0.0 to 0.3"] (words call <> ["0.18446744073709551616"]) ""
    refuses 1 ["0 to 2 and E"] (words "draw radiosity scenes/room.json --profile 9.9") ""
  it "a figure is not written under the name of another format" $
    refuses 1 ["PNG", "rsvg-convert"] (words "draw scene scenes/room.json -o out.png") ""
  it "a name of several polygons addresses none of them" $ do
    let twins =
          "{\"polygons\": [{\"name\": \"a\", \"corners\": [[0,0],[1,0],[0,1]]}, \
          \{\"name\": \"a\", \"corners\": [[3,0],[4,0],[3,1]]}]}"
    refuses 1 ["2 polygons are named a"] ["view", "-", "--corner", "a.0"] twins
    (code, _, err) <- run ["info", "-"] twins
    (code, "2 polygons are named a" `isInfixOf` err) `shouldBe` (0, True)
    (_, _, silent) <- run ["info", "--quiet", "-"] twins
    silent `shouldBe` ""
  it "the manual page has every command and every option" $ do
    page <- filter (/= '\\') <$> output ["--man"] ""
    for_ commands $ \command -> do
      page `shouldSatisfy` isInfixOf command
      options <- optionsIn <$> output ("help" : words command) ""
      for_ options $ \option -> page `shouldSatisfy` isInfixOf option
  it "completion knows commands, figures and values" $ do
    completed ["gra"] 1 >>= (`shouldBe` ["graph"])
    completed ["draw", "mat"] 2 >>= (`shouldBe` ["matrix"])
    completed ["graph", "--arithmetic", "f"] 3 >>= (`shouldBe` ["filtered"])
  it "every option with a value states its default, or that it is required" $
    for_ ("generate" : commands) $ \command -> do
      page <- lines <$> output ("help" : words command) ""
      let stated = [(option, isStated text) | (option, text) <- described page, isOption option]
      length stated `shouldSatisfy` (>= 3)
      [option | (option, False) <- stated] `shouldBe` []
  it "completion gives all values that help lists, and each is taken or lacks only its number" $
    for_ commands $ \command -> do
      page <- lines <$> output ("help" : words command) ""
      let options = [(option, cut shape) | (heading, _) <- described page, [option, shape] <- [words heading]]
      for_ [(option, values) | (option, values@(_ : _ : _)) <- options, option /= "-o,--output"] $
        \(option, values) -> do
          offered <- completed (words command <> ["x", option, ""]) (length (words command) + 3)
          sort offered `shouldBe` sort (map (filter (/= 'N')) values)
          for_ values $ \value -> do
            let number = map (\c -> if c == 'N' then '3' else c) value
            (_, _, err) <- run (words command <> ["/no/such", option, number]) ""
            (command, option, value, "is none of" `isInfixOf` err) `shouldBe` (command, option, value, False)
  it "families are completed as help lists them" $ do
    page <- output ["help", "generate"] ""
    offered <- filter ((/= "-") . take 1) <$> completed ["generate", ""] 2
    length offered `shouldSatisfy` (> 10)
    for_ offered $ \family -> page `shouldSatisfy` isInfixOf ("\n  " <> family <> " ")
  it "a line on the terminal tells progress after a second, but not with --quiet, nor elsewhere" $ do
    exe <- executable
    let call options = "(sleep 2; cat scenes/room.json) | " <> unwords ([exe, "info -"] <> options <> ["> /dev/null"])
        onTerminal options = readProcessWithExitCode "script" ["-qec", call options, "/dev/null"] ""
    (_, shown, _) <- onTerminal []
    shown `shouldSatisfy` isInfixOf "\ESC[K"
    (_, silent, _) <- onTerminal ["--quiet"]
    silent `shouldBe` ""
  where
    -- What stands at the left of a page of help, and the text beside and below it.
    described page = case dropWhile (not . isHeading) page of
      [] -> []
      line : rest ->
        let (below, later) = span (\l -> take 4 l == "    ") rest
            (heading, text) = splitAt 27 line
            (option, beside) = if take 2 (reverse heading) == "  " then (heading, text) else (line, "")
         in (unwords (words option), unwords (words (unwords (beside : below)))) : described later
    isHeading line = take 2 line == "  " && take 1 (drop 2 line) == "-"
    isOption heading = length (words heading) == 2
    isStated text = "(default: " `isInfixOf` text || "(required)" `isInfixOf` text
    cut shape = case break (== '|') shape of
      (value, _ : more) -> value : cut more
      (value, []) -> [value]
    completed wanted position =
      lines
        <$> output
          ( ["--bash-completion-index", show (position :: Int)]
              <> concatMap (\word -> ["--bash-completion-word", word]) ("viscomplex" : wanted)
          )
          ""
    commands =
      words "info graph complex factors mesh view radiosity verify"
        <> map ("draw " <>) (words "scene dual matrix view mesh radiosity sweep")
    optionsIn page =
      nub
        [ option
        | word <- words (map separated page)
        , ("--", rest) <- [splitAt 2 word]
        , let option = "--" <> takeWhile isLetter rest
        , length option > 3
        ]
    separated c = if c `elem` ",|[]()" then ' ' else c
    isLetter c = isAlpha c || c == '-'
