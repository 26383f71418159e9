{-# LANGUAGE OverloadedStrings #-}

-- | @viscomplex radiosity@ as its users see it.
module Command.RadiositySpec (spec) where

import Command.Run
import qualified Data.Aeson as Aeson
import qualified Data.Aeson.Types as Aeson
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Foldable (for_)
import qualified Data.Text as Text
import Test.Hspec
import Visibility.Format.Number (readNumber)

-- | Elements by id, with their bounds; and emitted power with its bounds.
data Document = Document ![(String, (Rational, Rational))] !(Rational, (Rational, Rational))

documentOf :: String -> Maybe Document
documentOf text = Aeson.decode (Lazy.pack text) >>= Aeson.parseMaybe parser
  where
    parser = Aeson.withObject "document" $ \o -> do
      elements <- o Aeson..: "elements" >>= mapM element
      emitted <- o Aeson..: "emitted" >>= number
      around' <- o Aeson..: "emittedBounds" >>= bounds
      pure (Document elements (emitted, around'))
    element = Aeson.withObject "element" $ \o -> (,) <$> o Aeson..: "id" <*> (o Aeson..: "radiosity" >>= bounds)
    bounds value = Aeson.parseJSON value >>= \(low, high) -> (,) <$> number low <*> number high
    number = Aeson.withText "decimal" (either (fail . show) pure . readNumber . Text.strip)

solved :: [String] -> IO Document
solved arguments = output ("radiosity" : arguments) "" >>= maybe (fail "no such document") pure . documentOf

spec :: Spec
spec = describe "radiosity" $ do
  it "gives bounds as close as asked, all around the same numbers" $
    for_ ["room", "flat", "city", "thin-walls"] $ \name -> do
      let call options = solved (("scenes/" <> name <> ".json") : options)
      Document fine _ <- call ["--digits", "30"]
      let largest = maximum (map (fst . snd) fine)
      for_ [[], ["--mesh", "sides"], ["--tolerance", "1e-12"], ["--tolerance", "0.01"]] $ \options -> do
        Document found (emitted, (low, high)) <- call options
        map fst found `shouldBe` map fst fine
        [name' | ((name', (a, b)), (_, (c, d))) <- zip found fine, a > d || c > b] `shouldBe` []
        let asked = case options of
              ["--tolerance", x] -> either (const 0) id (readNumber (Text.pack x))
              _ -> 1e-9
        maximum [b - a | (_, (a, b)) <- found] `shouldSatisfy` (<= asked * largest)
        emitted `shouldSatisfy` (\x -> low <= x && x <= high)
  it "refuses what Doubles cannot prove, with what they can, as wrong usage" $
    refuses 1 ["with Doubles", "--tolerance", "--digits"] ["radiosity", "scenes/flat.json", "--tolerance", "1e-25"] ""
  it "refuses tolerances that are none, and two at once" $ do
    for_ ["0", "-1", "1", "1e3"] $ \x ->
      refuses 1 ["above 0 and below 1"] ["radiosity", "scenes/room.json", "--tolerance=" <> x] ""
    refuses 1 ["close"] ["radiosity", "scenes/room.json", "--tolerance", "close"] ""
    refuses 1 ["--digits"] ["radiosity", "scenes/room.json", "--tolerance", "1e-9", "--digits", "9"] ""
    refuses 1 ["whole number"] ["radiosity", "scenes/room.json", "--digits", "0"] ""
    refuses 1 ["none of: sides"] ["radiosity", "scenes/room.json", "--mesh", "triangles"] ""
  it "refuses materials that are none" $
    refuses 4 ["reflectivity"] ["radiosity", "-"] $
      "{\"polygons\": [{\"corners\": [[0,0],[1,0],[0,1]], \"reflectivity\": 1}]}"
