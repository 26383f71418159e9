{-# LANGUAGE FlexibleContexts #-}
{-# LANGUAGE OverloadedStrings #-}

-- | The one place that knows a drawing library: drawings become SVG by diagrams.
--
-- All that concerns looks is here. Styles differ in lightness, width and dashes, not in hue alone, so that figures can be
-- read in shades of grey.
module Visibility.Draw.Render
  ( renderSvg
  ) where

import Data.ByteString.Builder (lazyByteString, toLazyByteString)
import Data.ByteString.Lazy (ByteString)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.List (groupBy)
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Text.Encoding (encodeUtf8Builder)
import Diagrams.Backend.SVG
import Diagrams.Prelude hiding (Style, element, height, place, solid, stroke, text, thin, width)
import Graphics.Svg (Element, renderBS, style_, toElement)
import Visibility.Draw.Drawing

-- | The SVG of a drawing: as many user units as the drawing has pixels, a white ground, each layer a group whose class is the layer's name,
-- title and description as elements.
--
-- /Shape/ coordinates are rounded to 4 decimals of a pixel. Neighbouring marks of a layer that look the same share a path.
--
-- /Laws/ a function of the drawing, byte for byte; well-formed XML.
renderSvg :: Drawing -> ByteString
renderSvg drawing = described drawing (renderBS (renderDia SVG options picture))
  where
    options = SVGOptions (dims2D width height) (Just styleSheet) "viscomplex" [] False
    (width, height) = (drawingWidth drawing, drawingHeight drawing)
    ground = rect width height # moveTo (p2 (width / 2, height / 2)) # fc white # lw none
    picture =
      (mconcat (reverse (ground : map layerPicture (drawingLayers drawing))) :: Diagram SVG)
        # withEnvelope (rect width height # moveTo (p2 (width / 2, height / 2)) :: Diagram SVG)

-- | The backend states a dominant base line, which viewers treat differently; texts here stand on their alphabetic base line.
styleSheet :: Element
styleSheet = style_ [] (toElement ("text{dominant-baseline:alphabetic}" :: Text))

-- | Puts title and description where readers look for them: first in the root element. No attribute of the root holds a @>@.
described :: Drawing -> ByteString -> ByteString
described drawing svg = root <> ">" <> element "title" (drawingTitle drawing) <> element "desc" (drawingDescription drawing) <> Lazy.drop 1 rest
  where
    (root, rest) = Lazy.break (== '>') svg
    element name text =
      toLazyByteString
        ("<" <> lazyByteString name <> ">" <> encodeUtf8Builder (escaped text) <> "</" <> lazyByteString name <> ">")
    escaped = Text.concatMap safe . Text.filter printable
    safe '<' = "&lt;"
    safe '>' = "&gt;"
    safe '&' = "&amp;"
    safe c = Text.singleton c
    -- XML has no way to write the other control characters.
    printable c = c >= ' ' && c /= '\xFFFE' && c /= '\xFFFF'

layerPicture :: Layer -> Diagram SVG
layerPicture (Layer name density marks) = svgClass (Text.unpack name) (mconcat (reverse (map (piece density) (shared marks))))

-- | Neighbours that may be drawn as one path: same style, same kind of shape, no text. Pieces stay short, since viewers are slow at
-- long paths.
shared :: [Mark] -> [[Mark]]
shared = concatMap (chunks 250) . groupBy alike
  where
    alike (Mark _ style shape) (Mark _ style' shape') = style == style' && kind shape == kind shape' && kind shape /= 3
    kind :: Shape -> Int
    kind (Region _) = 0
    kind (Polyline _) = 1
    kind (Dot _) = 2
    kind (Label _ _ _) = 3
    chunks k list = case splitAt k list of
      ([], _) -> []
      (now, later) -> now : chunks k later

-- | One path, or one text.
piece :: Density -> [Mark] -> Diagram SVG
piece _ [] = mempty
piece density marks@(Mark _ style shape : _) = case shape of
  Label anchor place text -> words' style anchor place text
  Dot _ -> strokePath (foldMap dotPath [place | Mark _ _ (Dot place) <- marks]) # painted density style
  Polyline _ -> strokePath (foldMap polyline [places | Mark _ _ (Polyline places) <- marks]) # painted density style
  Region _ -> strokePath (foldMap region [places | Mark _ _ (Region places) <- marks]) # painted density style
  where
    polyline, region :: [Place] -> Path V2 Double
    polyline = pathFromLocTrail . fromVertices . map point
    region = pathFromLocTrail . mapLoc closeTrail . fromVertices . map point
    -- Where there are thousands of dots, squares are as good and a quarter of the size.
    dotPath :: Place -> Path V2 Double
    dotPath place
      | density >= Crowded = square (2 * r) # moveTo (point place)
      | otherwise = circle r # moveTo (point place)
      where
        r = dotRadius density style

words' :: Style -> Anchor -> Place -> Text -> Diagram SVG
words' style anchor place text =
  alignedText across 0.5 (Text.unpack (Text.filter (>= ' ') text))
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
    . maybe (lw none) (\colour -> lc (sRGB24read colour) . lwO (strokeWidth density style)) stroke
    . (if null dashes then id else dashingO dashes 0)
    . lineJoin LineJoinRound
  where
    Look fill stroke dashes = look density style

-- | How a style looks in a layer of some density.
look :: Density -> Style -> Look
look density style = case style of
  Outside -> Look (Just solid) Nothing []
  RoomFloor -> Look (Just "#ffffff") Nothing []
  Opaque -> Look (Just solid) (Just dark) []
  RoomWall -> line dark
  ThinWall -> line dark
  Bitangent -> line (by "#3a78b5" "#5a91c6" "#8fb3d6")
  LightRim -> line dark
  LightSource -> line "#ffd92e"
  LightRay -> line dark
  TangentCurve -> line (by "#16365c" "#16365c" "#33557f")
  EndingCurve -> Look Nothing (Just (by "#d08a3e" "#d08a3e" "#dba368")) (by [4, 2.5] [3, 2] [2, 1.5])
  VertexDot -> Look (Just dark) Nothing []
  DegenerateVertexDot -> Look (Just "#ffffff") (Just "#b3122a") []
  Axis -> line dark
  Reference -> line "#b5b5b5"
  Tick -> line dark
  Leader -> Look Nothing (Just "#555555") [1.5, 1.5]
  _ -> Look Nothing Nothing []
  where
    line colour = Look Nothing (Just colour) []
    solid = "#d4d4d4"
    dark = "#1f1f1f"
    by :: a -> a -> a -> a
    by sparse dense crowded = byDensity density sparse dense crowded crowded
