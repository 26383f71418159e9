{-# LANGUAGE FlexibleContexts #-}
{-# LANGUAGE OverloadedStrings #-}

-- | The one place that knows a drawing library: drawings become SVG by diagrams.
--
-- All that concerns looks is here. Styles differ in lightness, width and dashes, not in hue alone, so that figures can
-- be read in shades of grey.
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
import Visibility.Draw.Colour (hexText)
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
      <> style_ [] (toElement styleSheet)
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

-- | The backend states a dominant base line, which viewers treat differently; texts here stand on their alphabetic
-- base line.
styleSheet :: Text
styleSheet = "text{dominant-baseline:alphabetic}"

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
    alike (Mark _ style shape) (Mark _ style' shape') = style == style' && kind shape == kind shape' && kind shape /= 3
    kind :: Shape -> Int
    kind (Region _) = 0
    kind (Polyline _) = 1
    kind (Dot _) = 2
    kind (Label {}) = 3
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
    | Look (Just colour) Nothing _ <- look density style ->
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

-- | Fill, colour of the stroke and its dashes in pixels.
data Look = Look !(Maybe String) !(Maybe String) ![Double]

painted :: Density -> Style -> Diagram SVG -> Diagram SVG
painted density style =
  maybe (fcA transparent) (fc . sRGB24read) fill
    . maybe (lw none) (\colour -> lcA (sRGB24read colour `withOpacity` ink) . lwO (strokeWidth density style)) stroke
    . (if null dashes then id else dashingO dashes 0)
    . lineJoin LineJoinRound
  where
    Look fill stroke dashes = look density style
    -- Lines cannot get thinner without end: viewers drop what covers too little of a pixel.
    ink = if style `elem` [Bitangent, ShadowLine, KinkLine] then byDensity density 1 1 0.6 0.12 else 1 :: Double

-- | How a style looks in a layer of some density.
look :: Density -> Style -> Look
look density style = case style of
  Outside -> Look (Just solid) Nothing []
  RoomFloor -> Look (Just "#ffffff") Nothing []
  Opaque -> Look (Just solid) (Just dark) []
  Bitangent -> line (by "#3a78b5" "#5a91c6" "#3a78b5")
  LightSource -> line "#ffd92e"
  TangentCurve -> line (by "#16365c" "#16365c" "#33557f")
  EndingCurve -> Look Nothing (Just (by "#d08a3e" "#d08a3e" "#dba368")) (by [4, 2.5] [3, 2] [2, 1.5])
  BuriedCurve -> Look Nothing (Just "#8c8c8c") (by [1.2, 2.6] [1, 2] [0.8, 1.6])
  SeenRegion -> Look (Just "#cde3f6") Nothing []
  SightLimit -> line "#3a78b5"
  ShadowLimitTick -> line accent
  KinkTick -> line "#1f62a8"
  ShadowLine -> line (by "#c9556a" "#c9556a" "#b3122a")
  KinkLine -> Look Nothing (Just (by "#6f9fcc" "#6f9fcc" "#3a78b5")) (by [5, 3] [4, 2.5] [3, 2])
  SweptLine -> line "#f3b6bd"
  ReadyLine -> line "#cfe8c6"
  RightTreeEdge -> line "#1f62a8"
  LeftTreeEdge -> line "#c2701c"
  NewRightTreeEdge -> line "#1f62a8"
  NewLeftTreeEdge -> line "#c2701c"
  SeenSide -> line "#1f62a8"
  SeeingSide -> line accent
  Arrow -> line accent
  ViewpointDot -> Look (Just accent) (Just "#ffffff") []
  VertexDot -> Look (Just dark) Nothing []
  DegenerateVertexDot -> Look (Just "#ffffff") (Just accent) []
  Cell shade -> Look (Just (hexText shade)) Nothing []
  Band shade -> Look (Just (hexText shade)) Nothing []
  PlotLine colour -> line colour
  Reference -> line "#b5b5b5"
  Leader -> Look Nothing (Just "#555555") [1.5, 1.5]
  _ -> line dark
  where
    line colour = Look Nothing (Just colour) []
    solid = "#d4d4d4"
    dark = "#1f1f1f"
    accent = "#b3122a"
    by :: a -> a -> a -> a
    by sparse dense crowded = byDensity density sparse dense crowded crowded
