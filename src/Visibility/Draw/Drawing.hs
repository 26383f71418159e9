-- | Figures as values: a list of marks in named layers, which no drawing library has seen.
--
-- Figures are made and tested as such lists; "Visibility.Draw.Render" turns them into SVG. A mark says what it stands
-- for and what it means, not how it looks. Places are in pixels, (0, 0) at the lower left, y upwards.
module Visibility.Draw.Drawing
  ( -- * Drawings
    Drawing (..)
  , Layer (..)
  , Density (..)
  , densityOf
  , byDensity
  , Mark (..)
  , plain
  , Shape (..)
  , Anchor (..)
  , Style (..)
  , Place (..)
    -- * Extents
  , Box (..)
  , boxRegion
  , raisedBy
  , textBox
  , textBoxAt
  , textWidth
  , letterWidth
  , textSize
  , boxesMeet
  , segmentMeetsBox
  , strokes
  , dotRadius
  , widened
    -- * Looks
  , strokeWidth
  , Look (..)
  , look
  ) where

import Data.Text (Text)
import qualified Data.Text as Text
import Visibility.Draw.Colour (Shade, hexText)

-- | A figure. The title and the description are for those who cannot see it.
data Drawing = Drawing
  { drawingTitle :: !Text
  , drawingDescription :: !Text
  , drawingWidth :: !Double
  , drawingHeight :: !Double
  , drawingLayers :: ![Layer]
  -- ^ From the bottom upwards.
  }
  deriving (Eq, Show)

-- | Marks of one kind, the later ones above.
data Layer = Layer
  { layerName :: !Text
  -- ^ Different in each layer; becomes the class of the SVG group.
  , layerDensity :: !Density
  , layerMarks :: ![Mark]
  }
  deriving (Eq, Show)

-- | How crowded a layer is: strokes and dots become thinner, none is left out.
data Density = Sparse | Dense | Crowded | Packed
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | The density of a layer of so many marks: up to 600 are sparse, up to 12000 dense, up to 50000 crowded.
densityOf :: Int -> Density
densityOf k
  | k <= 600 = Sparse
  | k <= 12000 = Dense
  | k <= 50000 = Crowded
  | otherwise = Packed

-- | One shape. Its name is that of the thing drawn: @3@ for a polygon, @0.1@ for a corner, @0.1 2.3@ for a line through
-- two; empty for what belongs to the figure itself.
data Mark = Mark
  { markName :: Text
  , markStyle :: !Style
  , markShape :: !Shape
  }
  deriving (Eq, Show)

data Shape
  = -- | A closed region by its corners, filled, with its outline where the style has one.
    Region ![Place]
  | Polyline ![Place]
  | -- | A small disc whose size depends on the style only.
    Dot !Place
  | -- | One line of text; the place is on the base line.
    Label !Anchor !Place !Text
  deriving (Eq, Show)

-- | Which part of a text is at its place.
data Anchor = StartAnchor | MiddleAnchor | EndAnchor
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | A mark that belongs to the figure itself.
plain :: Style -> Shape -> Mark
plain = Mark Text.empty

-- | What a mark means. How it looks is decided by 'look' alone.
data Style
  = -- | The opaque outside of a room.
    Outside
  | -- | The free inside of a room.
    RoomFloor
  | Opaque
  | RoomWall
  | ThinWall
  | Bitangent
  | -- | The dark rim below a light source.
    LightRim
  | LightSource
  | LightRay
  | TangentCurve
  | EndingCurve
  | BuriedCurve
  | -- | What is seen from a point.
    SeenRegion
  | -- | A line of sight past a corner, where the seen region ends.
    SightLimit
  | -- | Where a shadow ends on a side.
    ShadowLimitTick
  | -- | Where what a side sees changes otherwise.
    KinkTick
  | -- | Where a side is cut into equal parts.
    EqualPartsTick
  | -- | The line that casts a shadow limit; a kink.
    ShadowLine
  | KinkLine
  | -- | The line of a vertex that has been swept just now.
    SweptLine
  | -- | The line of a vertex that may be swept.
    ReadyLine
  | -- | The next pair of a corner, to the right and to the left; those found just now.
    RightTreeEdge
  | LeftTreeEdge
  | NewRightTreeEdge
  | NewLeftTreeEdge
  | -- | A side, or a piece of one, that is seen.
    SeenSide
  | SeeingSide
  | -- | The normal of an element.
    Arrow
  | ViewpointDot
  | VertexDot
  | DegenerateVertexDot
  | -- | A cell of a matrix or of a colour bar, for a value.
    Cell !Shade
  | -- | A band along a side, or the area under a profile, for a value.
    Band !Shade
  | BandEdge
  | ProfileLine
  | -- | Points of a plot that belong together, and the line that joins them, in a colour @#rrggbb@ of its own.
    PlotLine !String
  | Axis
  | -- | The line u = 0 or another faint line of reference.
    Reference
  | Tick
  | -- | A thin line from a corner or curve to its label.
    Leader
  | CornerLabel
  | -- | What a side is called, and how much of it is seen.
    SideLabel
  | PolygonLabel
  | TickLabel
  | AxisTitle
  | FigureTitle
  | Caption
  deriving (Eq, Ord, Show)

-- | Pixels to the right and upwards.
data Place = Place !Double !Double
  deriving (Eq, Ord, Show)

-- | A rectangle: left, bottom, right, top.
data Box = Box !Double !Double !Double !Double
  deriving (Eq, Show)

-- | A rectangle as a region.
boxRegion :: Box -> Shape
boxRegion (Box l b r t) = Region [Place l b, Place r b, Place r t, Place l t]

-- | A shape so much higher.
raisedBy :: Double -> Shape -> Shape
raisedBy up shape = case shape of
  Region places -> Region (map higher places)
  Polyline places -> Polyline (map higher places)
  Dot place -> Dot (higher place)
  Label anchor place text -> Label anchor (higher place) text
  where
    higher (Place x y) = Place x (y + up)

-- | The size of the font, in pixels; 0 for what is not text.
textSize :: Style -> Double
textSize style = case style of
  FigureTitle -> 15
  AxisTitle -> 14
  Caption -> 12
  TickLabel -> 12
  PolygonLabel -> 11
  CornerLabel -> 11
  SideLabel -> 11
  _ -> 0

-- | An upper bound for the usual sans serif fonts: the reader's font is not known.
textWidth :: Style -> Text -> Double
textWidth style text = textSize style * Text.foldl' (\width c -> width + letterWidth c) 0 text

-- | The same of a letter, in sizes of the font.
letterWidth :: Char -> Double
letterWidth c
  | c `elem` ['0' .. '9'] = 0.64
  | c `elem` " .,:;ijl|'()" = 0.39
  | c `elem` "mwMW−+=" = 0.99
  | c `elem` ['A' .. 'Z'] = 0.78
  | otherwise = 0.64

-- | The box of a text in a style at a place.
textBoxAt :: Style -> Anchor -> Place -> Text -> Box
textBoxAt style anchor (Place x y) text = Box left (y - below * size) (left + width) (y + 0.76 * size)
  where
    size = textSize style
    width = textWidth style text
    below = if Text.any (`elem` "gjpqyQ,;()/") text then 0.24 else 0.02
    left = case anchor of
      StartAnchor -> x
      MiddleAnchor -> x - width / 2
      EndAnchor -> x - width

-- | The box of a mark that is text.
textBox :: Mark -> Maybe Box
textBox (Mark _ style (Label anchor place text)) = Just (textBoxAt style anchor place text)
textBox _ = Nothing

-- | Do two boxes share a point inside both?
boxesMeet :: Box -> Box -> Bool
boxesMeet (Box l b r t) (Box l' b' r' t') = l < r' && l' < r && b < t' && b' < t

-- | Does a segment run through the inside of a box?
segmentMeetsBox :: Box -> (Place, Place) -> Bool
segmentMeetsBox (Box l b r t) (Place x0 y0, Place x1 y1)
  | max x0 x1 <= l || min x0 x1 >= r || max y0 y1 <= b || min y0 y1 >= t = False
  | otherwise = any (> 0) corners && any (< 0) corners
  where
    -- On which side of the segment's line the box's corners lie.
    corners = [(x1 - x0) * (y - y0) - (y1 - y0) * (x - x0) | x <- [l, r], y <- [b, t]]

-- | The segments that a mark draws.
strokes :: Mark -> [(Place, Place)]
strokes (Mark _ _ shape) = case shape of
  Region places@(first : _ : _) -> zip places (drop 1 places <> [first])
  Polyline places -> zip places (drop 1 places)
  _ -> []

-- | One of four values for the four densities.
byDensity :: Density -> a -> a -> a -> a -> a
byDensity density sparse dense crowded packed = case density of
  Sparse -> sparse
  Dense -> dense
  Crowded -> crowded
  Packed -> packed

-- | The radius of a dot, in pixels.
dotRadius :: Density -> Style -> Double
dotRadius _ ViewpointDot = 4
dotRadius density DegenerateVertexDot = byDensity density 3.6 2.2 1.2 0.8
dotRadius density _ = byDensity density 2.2 1.2 0.6 0.25

-- | The width of a style's lines and outlines, in pixels; 0 where it has none.
strokeWidth :: Density -> Style -> Double
strokeWidth density style = let Look _ _ _ width = look density style in width

-- | Fill; colour, dashes and width of the stroke, in pixels.
data Look = Look !(Maybe String) !(Maybe String) ![Double] !Double

-- | How a style looks in a layer of some density. Styles differ in lightness, width and dashes, not in hue alone, so
-- that figures can be read in shades of grey.
look :: Density -> Style -> Look
look density style = case style of
  Outside -> filled solid
  RoomFloor -> filled "#ffffff"
  Opaque -> Look (Just solid) (Just dark) [] (by 1.2 0.9 0.4 0.2)
  RoomWall -> line dark (by 2 1.6 1.2 1)
  ThinWall -> line dark (by 2.6 2 1.2 0.8)
  Bitangent -> line (by blue "#5a91c6" blue blue) (by 0.7 0.35 0.2 0.2)
  LightRim -> line dark (by 5.4 4.2 3 1.6)
  LightSource -> line "#ffd92e" (by 3 2.4 1.6 0.8)
  LightRay -> line dark (by 0.9 0.7 0.4 0.2)
  TangentCurve -> line (by "#16365c" "#16365c" "#33557f" "#33557f") (by 1.3 0.5 0.18 0.06)
  EndingCurve -> dashed (by "#d08a3e" "#d08a3e" "#dba368" "#dba368") (dashes 4 2.5 3 2 2 1.5) (by 1.1 0.45 0.15 0.05)
  BuriedCurve -> dashed "#8c8c8c" (dashes 1.2 2.6 1 2 0.8 1.6) (by 1 0.4 0.15 0.05)
  SeenRegion -> filled "#cde3f6"
  SightLimit -> line blue (by 0.9 0.7 0.4 0.2)
  ShadowLimitTick -> line accent (by 1.8 1.2 0.6 0.3)
  KinkTick -> line "#1f62a8" (by 1.2 0.8 0.4 0.2)
  EqualPartsTick -> line dark (by 1.2 0.8 0.4 0.2)
  ShadowLine -> line (by "#c9556a" "#c9556a" accent accent) (by 0.7 0.35 0.2 0.2)
  KinkLine -> dashed (by "#6f9fcc" "#6f9fcc" blue blue) (dashes 5 3 4 2.5 3 2) (by 0.6 0.3 0.2 0.2)
  SweptLine -> line "#f3b6bd" (by 6 4 2.4 1.2)
  ReadyLine -> line "#cfe8c6" (by 7 4.5 2.4 1.2)
  RightTreeEdge -> line "#1f62a8" (by 1.1 0.7 0.4 0.2)
  LeftTreeEdge -> line "#c2701c" (by 1.1 0.7 0.4 0.2)
  NewRightTreeEdge -> line "#1f62a8" (by 2.4 1.6 0.8 0.4)
  NewLeftTreeEdge -> line "#c2701c" (by 2.4 1.6 0.8 0.4)
  SeenSide -> line "#1f62a8" (by 3.4 2.8 1.8 1.2)
  SeeingSide -> line accent (by 5.4 4.6 3.4 2.4)
  Arrow -> line accent 2
  ViewpointDot -> Look (Just accent) (Just "#ffffff") [] 1.6
  VertexDot -> filled dark
  DegenerateVertexDot -> Look (Just "#ffffff") (Just accent) [] (by 1.4 0.9 0.4 0.3)
  Cell shade -> filled (hexText shade)
  Band shade -> filled (hexText shade)
  BandEdge -> line dark (by 0.6 0.4 0.2 0.1)
  ProfileLine -> line dark 1.2
  PlotLine colour -> line colour 1.3
  Axis -> line dark 1
  Reference -> line "#b5b5b5" 0.8
  Tick -> line dark 0.8
  Leader -> dashed "#555555" [1.5, 1.5] 0.7
  _ -> line dark 0
  where
    filled colour = Look (Just colour) Nothing [] 0
    line colour = dashed colour []
    dashed = Look Nothing . Just
    dashes a b c d e f = by [a, b] [c, d] [e, f] [e, f]
    (solid, dark, accent, blue) = ("#d4d4d4", "#1f1f1f", "#b3122a", "#3a78b5")
    by :: a -> a -> a -> a -> a
    by = byDensity density

-- | A box with so much more on each side.
widened :: Double -> Box -> Box
widened d (Box l b r t) = Box (l - d) (b - d) (r + d) (t + d)
