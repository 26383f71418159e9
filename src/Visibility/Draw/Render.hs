{-# LANGUAGE FlexibleContexts #-}
{-# LANGUAGE OverloadedStrings #-}

-- | The one place that knows a drawing library: drawings become SVG by diagrams.
module Visibility.Draw.Render
  ( renderSvg
  ) where

import Data.ByteString.Lazy (ByteString)
import Data.List (groupBy)
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Text.Lazy.Encoding (encodeUtf8)
import Diagrams.Backend.SVG
import Diagrams.Prelude hiding (Style, height, place, solid, stroke, text, thin, width, with)
import Graphics.Svg (Element, desc_, g_, makeAttribute, renderText, style_, svg11_, title_, toElement, with)
import Numeric (showFFloat)
import Visibility.Draw.Compact (compactPaths)
import Visibility.Draw.Drawing

-- | The SVG of a drawing: as many user units as the drawing has pixels, a white ground, each layer a @g@ whose class
-- is the layer's name, title and description as elements.
--
-- /Shape/ places are rounded to hundredths of a pixel. Neighbouring marks of a layer that look the same share a path.
-- The library writes whole documents and no named groups, so a layer is a document within its group.
--
-- /Laws/ a function of the drawing, byte for byte; well-formed XML.
renderSvg :: Drawing -> ByteString
renderSvg drawing =
  encodeUtf8 . compactPaths . renderText . flip with attributes . svg11_ $
    title_ [] (toElement (printable (drawingTitle drawing)))
      <> desc_ [] (toElement (printable (drawingDescription drawing)))
      -- The backend states a dominant base line, which viewers treat differently.
      <> style_ [] ("text{dominant-baseline:alphabetic}" :: Element)
      <> document (rect width height # moveTo (p2 (width / 2, height / 2)) # fc white # lw none)
      <> foldMap layerGroup (drawingLayers drawing)
  where
    layerGroup layer = g_ (makeAttribute "class" (layerName layer) : edges layer) (document (layerPicture layer))
    -- Cells that share an edge would show a seam of the ground where viewers smooth their edges.
    edges layer = [makeAttribute "shape-rendering" "crispEdges" | any (isCell . markStyle) (layerMarks layer)]
    isCell style = case style of Cell _ -> True; _ -> False
    (width, height) = (drawingWidth drawing, drawingHeight drawing)
    attributes =
      [ makeAttribute "role" "img"
      , makeAttribute "width" (pixels width)
      , makeAttribute "height" (pixels height)
      , makeAttribute "viewBox" ("0 0 " <> pixels width <> " " <> pixels height)
      ]
    pixels x = Text.pack (showFFloat (Just 2) x "")
    document :: Diagram SVG -> Element
    document picture =
      renderDia SVG (SVGOptions (dims2D width height) Nothing "" [] False) $
        picture # withEnvelope (rect width height # moveTo (p2 (width / 2, height / 2)) :: Diagram SVG)

-- | XML has no way to write the other characters.
printable :: Text -> Text
printable = Text.filter (\c -> c >= ' ' && c /= '\xFFFE' && c /= '\xFFFF')

layerPicture :: Layer -> Diagram SVG
layerPicture (Layer _ density marks) = mconcat (reverse (map (piece density) (shared marks)))

-- | Neighbours that may be drawn as one path: same style, same kind of shape, no text. Pieces stay short, since
-- viewers are slow at long paths.
shared :: [Mark] -> [[Mark]]
shared = concatMap (chunks 250) . groupBy alike
  where
    alike (Mark _ style shape) (Mark _ style' shape') = style == style' && isOfKind shape shape'
    isOfKind (Region _) (Region _) = True
    isOfKind (Polyline _) (Polyline _) = True
    isOfKind (Dot _) (Dot _) = True
    isOfKind _ _ = False
    chunks k list = case splitAt k list of
      ([], _) -> []
      (now, later) -> now : chunks k later

-- | One path, or one text.
piece :: Density -> [Mark] -> Diagram SVG
piece _ [] = mempty
piece density marks@(Mark _ style shape : _) = case shape of
  Label anchor place text -> words' style anchor place text
  Dot _
    -- A full dot is the end of a line of no length: a tenth of the text of a circle.
    | Look (Just colour) Nothing _ _ <- look density style ->
      strokePath (foldMap (\place -> polyline [place, place]) dots)
        # lc (sRGB24read colour)
        # lwO (2 * dotRadius density style)
        # lineCap (if isSquare then LineCapSquare else LineCapRound)
    | otherwise -> strokePath (foldMap dotPath dots) # painted density style
  Polyline _ -> strokePath (foldMap polyline [places | Mark _ _ (Polyline places) <- marks]) # painted density style
  Region _ -> strokePath (foldMap region [places | Mark _ _ (Region places) <- marks]) # painted density style
  where
    polyline, region :: [Place] -> Path V2 Double
    polyline = pathFromLocTrail . fromVertices . map point
    region = pathFromLocTrail . mapLoc closeTrail . fromVertices . map point
    dots = [place | Mark _ _ (Dot place) <- marks]
    -- Where there are thousands of dots, squares are as good; hollow ones are a quarter of the size.
    isSquare = density >= Crowded
    dotPath :: Place -> Path V2 Double
    dotPath place
      | isSquare = square (2 * r) # moveTo (point place)
      | otherwise = circle r # moveTo (point place)
      where
        r = dotRadius density style

words' :: Style -> Anchor -> Place -> Text -> Diagram SVG
words' style anchor place text =
  alignedText across 0.5 (Text.unpack (printable text))
    # fontSizeO (textSize style)
    # font "Helvetica, Arial, sans-serif"
    # weight
    # fc (sRGB24read "#1a1a1a")
    # lw none
    # moveTo (point place)
  where
    weight = if style == FigureTitle then bold else id
    across = case anchor of
      StartAnchor -> 0
      MiddleAnchor -> 0.5
      EndAnchor -> 1

point :: Place -> P2 Double
point (Place x y) = p2 (x, y)

painted :: Density -> Style -> Diagram SVG -> Diagram SVG
painted density style =
  maybe (fcA transparent) (fc . sRGB24read) fill
    . maybe (lw none) (\colour -> lcA (sRGB24read colour `withOpacity` ink) . lwO width') stroke
    . (if null dashes then id else dashingO dashes 0)
    . lineJoin LineJoinRound
  where
    Look fill stroke dashes width' = look density style
    -- Lines cannot get thinner without end: viewers drop what covers too little of a pixel.
    ink = if style `elem` [Bitangent, ShadowLine, KinkLine] then byDensity density 1 1 0.6 0.12 else 1 :: Double
