module Visibility.Draw.RenderSpec (spec) where

import qualified Data.ByteString.Lazy as Lazy
import Data.Char (digitToInt, isAlphaNum, isSpace)
import Data.Foldable (for_)
import Data.List (intercalate, isInfixOf, isPrefixOf)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Test.Hspec
import Test.QuickCheck
import Visibility.Draw.Colour
import Visibility.Draw.Checks
import Visibility.Draw.Drawing
import Visibility.Draw.Dual
import Visibility.Draw.Gallery
import Visibility.Draw.Matrix
import Visibility.Draw.Render
import Visibility.Draw.Scene
import Visibility.FormFactor
import Visibility.Sweep
import Visibility.View

spec :: Spec
spec = do
  for_ goldenScenes $ \(name, raw) ->
    describe name $
      for_ figures $ \(figure, draw) ->
        describe figure $ do
          it "is well-formed XML" $ withValid raw $ \scene -> xmlFault (rendered (draw scene)) `shouldBe` Nothing
          it "has a group for each layer, by its class, in their order" $
            withValid raw $ \scene -> do
              let drawing = draw scene
              groups (rendered drawing) `shouldBe` map (Text.unpack . layerName) (drawingLayers drawing)
          it "has all texts, a title and a description" $
            withValid raw $ \scene -> do
              let drawing = draw scene
                  svg = rendered drawing
                  isWritten text = (">" <> escaped text <> "</text>") `isInfixOf` svg
              [text | Mark _ _ (Label _ _ text) <- drawingMarks drawing, not (isWritten text)] `shouldBe` []
              (("<title>" <> escaped (drawingTitle drawing) <> "</title>") `isInfixOf` svg) `shouldBe` True
              (("<desc>" <> escaped (drawingDescription drawing) <> "</desc>") `isInfixOf` svg) `shouldBe` True
          it "is 800 pixels wide on a white ground" $
            withValid raw $ \scene -> do
              let svg = rendered (draw scene)
                  afterStyle = snd (Text.breakOn (Text.pack "</style>") (Text.pack svg))
                  firstShape = Text.unpack (Text.takeWhile (/= 'M') afterStyle)
              (" width=\"800.00\"" `isInfixOf` takeWhile (/= '>') svg) `shouldBe` True
              ("fill=\"rgb(255,255,255)\"" `isInfixOf` firstShape) `shouldBe` True
          it "keeps places: one unit to a pixel, y downwards" $
            withValid raw $ \scene -> do
              let line = plain Axis (Polyline [Place 100 50, Place 140 70])
                  drawing = (draw scene) {drawingLayers = [Layer (Text.pack "x") Sparse [line]]}
                  y = show (round (drawingHeight drawing) - 50 :: Int)
              (("M100 " <> y <> "l40-20") `isInfixOf` rendered drawing) `shouldBe` True
  describe "any title" $
    it "leaves well-formed XML" $
      property $ \(UnicodeString title) ->
        let text = Text.pack title
            caption = plain Caption (Label StartAnchor (Place 5 5) text)
            drawing = Drawing text text 800 100 [Layer (Text.pack "t") Sparse [caption]]
         in xmlFault (rendered drawing) === Nothing
  describe "any shade" $
    it "is drawn in its colour, as a cell without smoothed edges, so that no seams show between cells, or as a band" $
      for_ shades $ \shade -> do
        let svgOf style = rendered (Drawing Text.empty Text.empty 800 100 [Layer (Text.pack "l") Sparse [marked style]])
            marked style = plain style (boxRegion (Box 1 1 9 9))
            crisp = "shape-rendering=\"crispEdges\""
        for_ [(Cell shade, True), (Band shade, False)] $ \(style, isCrisp) -> do
          (("fill=\"" <> decimalRgb (hexText shade) <> "\"") `isInfixOf` svgOf style) `shouldBe` True
          (crisp `isInfixOf` svgOf style) `shouldBe` isCrisp
  describe "any density" $ do
    it "draws as many pieces of line as there are" $
      for_ [minBound .. maxBound] $ \density -> do
        let k = 1000
            line i = Mark Text.empty Bitangent (Polyline [Place i 1, Place (i / 2) 90])
            drawing = Drawing Text.empty Text.empty 800 100 [Layer (Text.pack "l") density (map line [1 .. k])]
        length (filter (== 'M') (rendered drawing)) `shouldBe` 1 + round k
    it "has a place for each dot, full or hollow" $
      for_ ((,) <$> [minBound .. maxBound] <*> [VertexDot, DegenerateVertexDot]) $ \(density, style) -> do
        let dots = [Mark Text.empty style (Dot (Place (i / 7) (i / 11))) | i <- [1 .. 600 :: Double]]
            drawing = Drawing Text.empty Text.empty 800 100 [Layer (Text.pack "l") density dots]
        length (filter (== 'M') (rendered drawing)) `shouldBe` 1 + length dots
  where
    figures =
      [ ("scene", \scene -> sceneDrawing scene (vertices scene))
      , ("dual", \scene -> dualDrawing scene (events scene (vertices scene)))
      , ("matrix", \scene -> matrixDrawing (factorMatrix scene (factors scene)))
      ]
    factors scene = nearestFactors scene (measures scene (vertices scene))
    decimalRgb hex = case map digitToInt (drop 1 hex) of
      [a, b, c, d, e, f] -> "rgb(" <> intercalate "," (map show [16 * a + b, 16 * c + d, 16 * e + f]) <> ")"
      _ -> "no colour"
    rendered drawing = Text.unpack (Text.decodeUtf8 (Lazy.toStrict (renderSvg drawing)))
    groups svg = [takeWhile (/= '"') (drop 7 rest) | rest <- suffixes svg, "class=\"" `isPrefixOf` rest]
    suffixes = takeWhile (not . null) . iterate (drop 1)
    escaped = concatMap character . Text.unpack
    character c = case c of
      '<' -> "&lt;"
      '>' -> "&gt;"
      '&' -> "&amp;"
      _ -> [c]

-- | What is wrong with a document of elements, attributes and text, if anything: tags that do not match, a stray @<@
-- or @&@, attributes that are repeated or not quoted, characters that XML has not.
xmlFault :: String -> Maybe String
xmlFault document = case document of
  '<' : _ -> content [] document
  _ -> Just "does not begin with an element"
  where
    content open text = case text of
      "" | null open -> Nothing
         | otherwise -> Just ("left open: " <> unwords open)
      '<' : '/' : rest ->
        let (name, next) = span isName rest
         in case (open, next) of
              (o : others, '>' : more) | o == name -> if null others then trailing more else content others more
              _ -> Just ("wrong end tag " <> name)
      '<' : rest ->
        let (name, next) = span isName rest
         in if null name then Just "stray <" else attributes open name [] next
      '&' : rest
        | any (`isPrefixOf` rest) ["lt;", "gt;", "amp;", "quot;", "apos;", "#39;"] -> content open rest
        | otherwise -> Just ("stray & before " <> take 10 rest)
      c : rest
        | c < ' ' && not (isSpace c) || c == '\xFFFE' || c == '\xFFFF' -> Just ("character " <> show c)
        | otherwise -> content open rest
    trailing more = if all isSpace more then Nothing else Just "goes on after the root"
    attributes open name seen text = case dropWhile isSpace text of
      '>' : rest -> content (name : open) rest
      '/' : '>' : rest -> content open rest
      rest ->
        let (key, next) = span isName rest
         in case next of
              '=' : '"' : value
                | not (null key)
                , key `notElem` seen
                , (inner, '"' : more) <- break (== '"') value
                , '<' `notElem` inner ->
                  attributes open name (key : seen) more
              _ -> Just ("attributes of " <> name <> " at " <> take 20 rest)
    isName c = isAlphaNum c || c `elem` "-:_"
