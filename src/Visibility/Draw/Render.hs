{-# LANGUAGE OverloadedStrings #-}

-- | The one place that knows SVG: drawings become documents.
module Visibility.Draw.Render
  ( renderSvg
  ) where

import Data.ByteString.Builder
import Data.ByteString.Lazy (ByteString)
import Data.List (groupBy, intercalate)
import Data.Text (Text)
import qualified Data.Text as Text
import Numeric (readHex, showFFloat)
import Visibility.Draw.Drawing
import Visibility.Draw.Path

-- | The SVG of a drawing: as many user units as the drawing has pixels, a white ground, each layer a @g@ whose class
-- is the layer's name, title and description as elements.
--
-- /Shape/ places are rounded to hundredths of a pixel. Neighbouring marks of a layer that look the same share a path.
-- Each layer is a document within its group.
--
-- /Cost/ linear in the marks and their texts; the document is made as it is read.
--
-- /Laws/ a function of the drawing, byte for byte; well-formed XML.
renderSvg :: Drawing -> ByteString
renderSvg drawing =
  toLazyByteString $
    element
      "svg"
      [ ("xmlns", svgSpace)
      , ("width", pixels width)
      , ("xmlns:xlink", xlinkSpace)
      , ("role", "img")
      , ("viewBox", "0 0 " <> pixels width <> " " <> pixels height)
      , ("height", pixels height)
      , ("version", "1.1")
      ]
      ( element "title" [] (escaped (drawingTitle drawing))
          <> element "desc" [] (escaped (drawingDescription drawing))
          <> element "style" [] (escaped styleSheet)
          <> document (painted "butt" "miter" (Look (Just "#ffffff") Nothing [] 0) 1 (groundPath width height))
          <> foldMap layerGroup (drawingLayers drawing)
      )
  where
    layerGroup layer =
      element "g" (("class", Text.unpack (layerName layer)) : edges layer) (document (layerPicture height layer))
    -- Cells that share an edge would show a seam of the ground where viewers smooth their edges.
    edges layer = [("shape-rendering", "crispEdges") | any (isCell . markStyle) (layerMarks layer)]
    isCell style = case style of Cell _ -> True; _ -> False
    (width, height) = (drawingWidth drawing, drawingHeight drawing)
    pixels x = showFFloat (Just 2) x ""
    document picture =
      element
        "svg"
        [ ("stroke", "rgb(0,0,0)")
        , ("xmlns", svgSpace)
        , ("font-size", "1")
        , ("width", showFFloat (Just 4) width "")
        , ("stroke-opacity", "1")
        , ("xmlns:xlink", xlinkSpace)
        , ("viewBox", unwords (map show [0, 0, width, height]))
        , ("height", showFFloat (Just 4) height "")
        , ("version", "1.1")
        ]
        (element "defs" [] mempty <> picture)
    svgSpace = "http://www.w3.org/2000/svg"
    xlinkSpace = "http://www.w3.org/1999/xlink"

-- | An element with attributes and content. /Requires/ values of attributes without characters to be escaped.
element :: String -> [(String, String)] -> Builder -> Builder
element name attributes content =
  char7 '<' <> string7 name <> foldMap attribute attributes <> char7 '>' <> content <> "</" <> string7 name <> char7 '>'
  where
    attribute (key, value) = char7 ' ' <> string7 key <> "=\"" <> stringUtf8 value <> char7 '"'

commas :: [String] -> String
commas = intercalate ","

-- | A text as XML has it, without the characters that XML has no way to write.
escaped :: Text -> Builder
escaped = foldMap character . filter isPrintable . Text.unpack
  where
    isPrintable c = c >= ' ' && c /= '\xFFFE' && c /= '\xFFFF'
    character c = case c of
      '<' -> "&lt;"
      '>' -> "&gt;"
      '&' -> "&amp;"
      '"' -> "&quot;"
      '\'' -> "&#39;"
      _ -> charUtf8 c

-- | Viewers treat a dominant base line differently; texts here stand on their alphabetic base line.
styleSheet :: Text
styleSheet = "text{dominant-baseline:alphabetic}"

layerPicture :: Double -> Layer -> Builder
layerPicture height (Layer _ density marks) = foldMap (piece height density) (shared marks)

-- | Neighbours that may be drawn as one path: same style, same kind of shape, no text. Pieces stay short, since
-- viewers are slow at long paths.
shared :: [Mark] -> [[Mark]]
shared = concatMap (chunks 250) . groupBy alike
  where
    alike (Mark _ style shape) (Mark _ style' shape') = style == style' && kind shape == kind shape' && kind shape /= 3
    kind :: Shape -> Int
    kind (Region _) = 0
    kind (Polyline _) = 1
    kind (Dot _) = 2
    kind (Label {}) = 3
    chunks k list = case splitAt k list of
      ([], _) -> []
      (now, later) -> now : chunks k later

-- | One path, or one text, in a drawing of some height.
piece :: Double -> Density -> [Mark] -> Builder
piece _ _ [] = mempty
piece height density marks@(Mark _ style shape : _) = case shape of
  Label anchor place text -> words' height style anchor place text
  Dot _
    -- A full dot is the end of a line of no length: a tenth of the text of a circle.
    | Look (Just colour) Nothing _ _ <- found ->
      let cap = if isSquare then "square" else "round"
       in painted cap "miter" (Look Nothing (Just colour) [] (2 * radius)) 1 (foldMap dotPath dots)
    | otherwise -> lined (foldMap (if isSquare then squarePath height radius else circlePath height radius) dots)
  Polyline _ -> lined (foldMap (linePath height) [places | Mark _ _ (Polyline places) <- marks])
  Region _ -> lined (foldMap (regionPath height) [places | Mark _ _ (Region places) <- marks])
  where
    found = look density style
    lined = painted "butt" "round" found ink
    -- Lines cannot get thinner without end: viewers drop what covers too little of a pixel.
    ink = if style `elem` [Bitangent, ShadowLine, KinkLine] then byDensity density 1 1 0.6 0.12 else 1
    dots = [place | Mark _ _ (Dot place) <- marks]
    dotPath place = linePath height [place, place]
    radius = dotRadius density style
    -- Where there are thousands of dots, squares are as good; hollow ones are a quarter of the size.
    isSquare = density >= Crowded

words' :: Double -> Style -> Anchor -> Place -> Text -> Builder
words' height style anchor (Place x y) text =
  element
    "g"
    ( [("fill", "rgb(26,26,26)"), ("stroke", "rgb(0,0,0)"), ("stroke-linecap", "butt"), ("stroke-width", "0.0")]
        <> [("font-size", show (textSize style) <> "px"), ("stroke-miterlimit", "10.0")]
        <> [("font-weight", "bold") | style == FigureTitle]
        <> [("fill-opacity", "1.0"), ("stroke-opacity", "1.0"), ("stroke-linejoin", "miter")]
        <> [("font-family", "Helvetica, Arial, sans-serif")]
    )
    ( element
        "text"
        [ ("dominant-baseline", "middle")
        , ("stroke", "none")
        , ("transform", "matrix(" <> commas (map fixed [1, 0, 0, 1, x, height - y]) <> ")")
        , ("text-anchor", across)
        ]
        (escaped text)
    )
  where
    fixed v = showFFloat (Just 4) v ""
    across = case anchor of
      StartAnchor -> "start"
      MiddleAnchor -> "middle"
      EndAnchor -> "end"

-- | A path: how its lines end and are joined, its look and the opacity of its stroke.
painted :: String -> String -> Look -> Double -> Builder -> Builder
painted end joint (Look fill stroke dashes width) ink path =
  element
    "g"
    ( [("fill", colour fill), ("stroke", colour stroke)]
        <> concat [[("stroke-dashoffset", "0.0"), ("stroke-dasharray", commas (map show dashes))] | not (null dashes)]
        <> [("stroke-linecap", end), ("stroke-width", show width)]
        <> [("stroke-miterlimit", "10.0"), ("fill-opacity", maybe "0.0" (const "1.0") fill)]
        <> [("stroke-opacity", show ink), ("stroke-linejoin", joint)]
    )
    ("<path d=\"" <> path <> "\"/>")
  where
    colour = maybe "rgb(0,0,0)" decimalRgb

-- | @rgb(255,0,0)@ for @#ff0000@.
decimalRgb :: String -> String
decimalRgb hex = "rgb(" <> commas (pairs (drop 1 hex)) <> ")"
  where
    pairs digits = case splitAt 2 digits of
      ([], _) -> []
      (pair, others) -> concatMap (show . fst) (readHex pair :: [(Int, String)]) : pairs others
