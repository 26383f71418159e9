-- | How the command line takes mistakes: what was meant is guessed, and all of it ends with exit code 1.
module Command.ConductSpec (spec) where

import Command.Run
import Data.Char (isAlpha)
import Data.Foldable (for_)
import Data.List (isInfixOf, isPrefixOf, nub)
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
    let asked wanted = concatMap (\word -> ["--bash-completion-word", word]) ("viscomplex" : wanted)
        completed wanted position =
          lines <$> output (["--bash-completion-index", show (position :: Int)] <> asked wanted) ""
    completed ["gra"] 1 >>= (`shouldBe` ["graph"])
    completed ["draw", "mat"] 2 >>= (`shouldBe` ["matrix"])
    completed ["graph", "--arithmetic", "f"] 3 >>= (`shouldBe` ["filtered"])
  where
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
