{-# LANGUAGE OverloadedStrings #-}

-- | The commands that work on elements of sides, as their users see them.
module Command.ElementsSpec (spec) where

import Command.Run
import qualified Data.Aeson as Aeson
import qualified Data.Aeson.Types as Aeson
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Foldable (for_)
import Data.List (intercalate, isInfixOf, nub)
import qualified Data.Text as Text
import Test.Hspec
import Visibility.Format.Number (readNumber)

-- | The entries of a list of the document, each by some texts that it has.
listed :: Aeson.Key -> [Aeson.Key] -> String -> IO [[String]]
listed name keys text = maybe (fail ("no such document: " <> text)) pure (Aeson.decode (Lazy.pack text) >>= parsed)
  where
    parsed = Aeson.parseMaybe (Aeson.withObject "document" (\o -> o Aeson..: name >>= mapM entry))
    entry = Aeson.withObject "entry" (\o -> mapM (o Aeson..:) keys)

-- | The bounds of radiosity of elements, by id.
boundsOf :: String -> IO [(String, (Rational, Rational))]
boundsOf text = maybe (fail ("no such document: " <> text)) pure (Aeson.decode (Lazy.pack text) >>= parsed)
  where
    parsed = Aeson.parseMaybe (Aeson.withObject "document" (\o -> o Aeson..: "elements" >>= mapM entry))
    entry = Aeson.withObject "element" $ \o -> (,) <$> o Aeson..: "id" <*> (o Aeson..: "radiosity" >>= pair)
    pair (low, high) = (,) <$> number low <*> number high
    number = either (fail . show) pure . readNumber . Text.pack

-- | How many break points each side has, by id.
breaksIn :: [String] -> IO [(String, Int)]
breaksIn options = do
  text <- output (["mesh", room] <> options) ""
  let parsed = Aeson.parseMaybe (Aeson.withObject "document" (\o -> o Aeson..: "sides" >>= mapM side))
      side = Aeson.withObject "side" $ \o -> (,) <$> o Aeson..: "id" <*> (length <$> points o)
      points o = o Aeson..: "points" :: Aeson.Parser [Aeson.Value]
  maybe (fail "no such document") pure (Aeson.decode (Lazy.pack text) >>= parsed)

room :: String
room = "scenes/room.json"

-- | Ids of elements, from the break points of all sides; no side of the room is covered.
idsFrom :: [(String, Int)] -> [String]
idsFrom found = [side <> "#" <> show k | (side, count) <- found, k <- [0 .. count]]

spec :: Spec
spec = do
  describe "factors" $ do
    it "of elements are between the elements of the discontinuity mesh, and the same with --mesh discontinuity" $ do
      ids <- idsFrom <$> breaksIn []
      text <- output ["factors", room, "--elements", "--format", "json"] ""
      names <- map concat <$> listed "factors" ["from"] text
      nub names `shouldBe` ids
      reached <- map concat <$> listed "factors" ["to"] text
      filter (`notElem` ids) reached `shouldBe` []
      length (filter ("#3" `isInfixOf`) names) `shouldSatisfy` (> 0)
      output ["factors", room, "--mesh", "discontinuity", "--format", "json"] "" `shouldReturn` text
    it "of equal parts are written with exact measures in all formats" $ do
      csv <- lines <$> output ["factors", room, "--mesh", "uniform:3", "--exact"] ""
      take 1 csv `shouldBe` ["from,to,value,measure"]
      json <- output ["factors", room, "--mesh", "uniform:3", "--exact", "--format", "json"] ""
      entries <- listed "factors" ["from", "to", "value"] json
      map (take 3 . cells) (drop 1 csv) `shouldBe` entries
      filter (not . isInfixOf "sqrt") (map (concat . drop 3 . cells) (drop 1 csv)) `shouldBe` []
      nub (concatMap (take 1) entries) `shouldBe` idsFrom [(side, 2) | side <- sidesOf (concatMap (take 1) entries)]
      text <- output ["factors", room, "--mesh", "uniform:3", "--format", "text"] ""
      filter (not . (`isInfixOf` text)) (concat [[from, value] | [from, _, value] <- entries]) `shouldBe` []
    it "of whole sides are those without a mesh" $ do
      plain <- output ["factors", room] ""
      output ["factors", room, "--mesh", "sides"] "" `shouldReturn` plain
    it "of at most one element on each side are those of sides, but for their names" $ do
      plain <- output ["factors", room] ""
      one <- output ["factors", room, "--elements", "--max-elements", "1"] ""
      one `shouldSatisfy` isInfixOf "E.0#0,"
      unnumbered one `shouldBe` plain
  describe "radiosity" $ do
    it "has bounds for every element of the mesh" $
      for_ [("discontinuity", "all"), ("shadow-limits", "shadow-limits"), ("uniform:2", "uniform:2")] $
        \(mesh, breaks) -> do
          ids <- idsFrom <$> breaksIn ["--breaks", breaks]
          found <- boundsOf =<< output ["radiosity", room, "--mesh", mesh] ""
          map fst found `shouldBe` ids
          filter (\(_, (low, high)) -> low > high || low < 0) found `shouldBe` []
    it "has no more elements than asked for, and no others on sides that have few" $ do
      ids <- idsFrom <$> breaksIn ["--max-elements", "2"]
      found <- boundsOf =<< output ["radiosity", room, "--mesh", "discontinuity", "--max-elements", "2"] ""
      map fst found `shouldBe` ids
      filter ("#2" `isInfixOf`) ids `shouldBe` []
    it "of elements encloses the same numbers in Doubles and to digits" $ do
      rough <- boundsOf =<< output ["radiosity", room, "--mesh", "uniform:2"] ""
      fine <- boundsOf =<< output ["radiosity", room, "--mesh", "uniform:2", "--digits", "20"] ""
      map fst fine `shouldBe` map fst rough
      [name | ((name, (a, b)), (_, (c, d))) <- zip rough fine, a > d || c > b] `shouldBe` []
  describe "draw" $ do
    it "plots radiosity along sides, and divides them by the discontinuity mesh if nothing else is said" $ do
      svg <- output ["draw", "radiosity", room, "--profile", "E.0", "--profile", "E.1"] ""
      plain <- output ["draw", "radiosity", room] ""
      let layers text = [("class=\"" <> layer <> "\"") `isInfixOf` text | layer <- ["bands", "areas"]]
      map layers [svg, plain] `shouldBe` [[True, True], [True, False]]
      output ["draw", "radiosity", room, "--mesh", "discontinuity"] "" `shouldReturn` plain
      logarithmic <- output ["draw", "radiosity", room, "--log"] ""
      few <- output ["draw", "radiosity", room, "--max-elements", "2"] ""
      output ["draw", "radiosity", room, "--mesh", "discontinuity", "--max-elements", "2"] "" `shouldReturn` few
      map (== plain) [logarithmic, few] `shouldBe` [False, False]
    it "draws the matrix of elements" $ do
      svg <- output ["draw", "matrix", room, "--mesh", "uniform:2"] ""
      sides <- breaksIn []
      let wanted = show (2 * length sides) <> " elements in " <> show (length sides) <> " sides"
      map (`isInfixOf` svg) [wanted, "class=\"cells\""] `shouldBe` [True, True]
      plain <- output ["draw", "matrix", room] ""
      output ["draw", "matrix", room, "--mesh", "sides"] "" `shouldReturn` plain
  describe "mistakes" $ do
    it "in what goes with what end with exit code 1, say what is wrong, and how to call the command" $
      for_
        [ (["radiosity", room, "--max-elements", "3"], withoutMesh)
        , (["radiosity", room, "--mesh", "sides", "--max-elements", "3"], withoutMesh)
        , (["factors", room, "--max-elements", "3"], withoutMesh)
        , (["draw", "matrix", room, "--max-elements", "3"], withoutMesh)
        , (["draw", "scene", room, "--breaks", "all"], unknown "--breaks" ["mesh", "draw mesh"])
        , (["draw", "matrix", room, "--breaks", "all"], unknown "--breaks" ["mesh", "draw mesh"])
        , (["draw", "mesh", room, "--mesh", "discontinuity"], unknown "--mesh" ["factors", "radiosity", "draw matrix", "draw radiosity"])
        , (["draw", "dual", room, "--max-elements", "2"], forFigures)
        , (["draw", "radiosity", room, "--lines"], unknown "--lines" ["draw mesh"])
        , (["draw", "mesh", room, "--log"], unknown "--log" ["draw radiosity"])
        , (["draw", "matrix", room, "--profile", "E.0"], unknown "--profile" ["draw radiosity"])
        ]
        $ \(arguments, wanted) -> do
          (code, out, err) <- run arguments ""
          (arguments, code, out, takeWhile (/= '\n') err) `shouldBe` (arguments, 1, "", "viscomplex: " <> called arguments <> ": " <> wanted)
          err `shouldSatisfy` isInfixOf ("Usage: viscomplex " <> concat (take 1 arguments))
    it "in names of meshes and sides too" $ do
      for_ ["all", "triangles", "uniform", "uniform:x", "uniform:0", "uniform:-1"] $ \mesh ->
        for_ [["factors", room], ["radiosity", room], ["draw", "matrix", room]] $ \call ->
          refuses 1 ["--mesh", "Usage"] (call <> ["--mesh", mesh]) ""
      refuses 1 ["none of: sides, discontinuity, shadow-limits, uniform:N"] ["factors", room, "--mesh", "triangles"] ""
      refuses 1 ["not a name", "Usage"] ["draw", "radiosity", room, "--profile", "zz"] ""
  where
    withoutMesh = "--max-elements goes with a --mesh other than sides"
    forFigures = unknown "--max-elements" (words "factors radiosity mesh" <> ["draw matrix", "draw mesh", "draw radiosity"])
    unknown option commands = "unknown option " <> option <> "; it is an option of " <> intercalate ", " commands
    called arguments = unwords (takeWhile (/= room) arguments)
    sidesOf = nub . map (takeWhile (/= '#'))
    -- Without the numbers of elements.
    unnumbered text = case break (== '#') text of
      (start, '#' : '0' : rest) -> start <> unnumbered rest
      (start, rest) -> start <> rest
