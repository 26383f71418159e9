{-# LANGUAGE OverloadedStrings #-}

-- | Where the title, the caption and the legend of a figure stand. Every figure is laid out here.
--
-- A figure in the plane of the scene is a 'Plane': a title, facts for the caption, entries of the legend, and layers of
-- marks by a 'Frame', which takes points of the scene to the canvas. Any other figure is a 'Page' whose layers are
-- made already.
module Visibility.Draw.Figure
  ( -- * Figures of any kind
    Page (..)
  , pageDrawing
  , pageBelow
  , scenePage
  , titleAfter
  , Bar (..)
  , barMarks
    -- * Figures in the plane of the scene
  , Plane (..)
  , scenePlane
  , Sheet (..)
  , Hold (..)
  , Naming (..)
  , polygonSheet
  , planeDrawing
    -- * What they consist of
  , module Visibility.Draw.Drawing
  , module Visibility.Draw.Labels
  , module Visibility.Draw.Legend
  , module Visibility.Draw.Scale
  , module Visibility.Draw.Scenery
  , module Visibility.Draw.Values
  ) where

import Data.Maybe (fromMaybe, mapMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Visibility.Draw.Drawing
import Visibility.Draw.Labels
import Visibility.Draw.Legend
import Visibility.Draw.Scale
import Visibility.Draw.Scenery
import Visibility.Draw.Values
import Visibility.Exact.Point (Point)
import Visibility.Scene

-- | A figure whose layers are made, and where its texts stand, in pixels.
data Page = Page
  { pageTitle :: !Text
  , pageAbout :: !Text
  -- ^ What the description says before the facts.
  , pageFacts :: ![Text]
  , pageEntries :: ![Entry]
  , pageHeight :: !Double
  , pageAcross :: !(Double, Double)
  -- ^ Where title, legend and caption begin and end.
  , pageTop :: !Double
  -- ^ How far the title's base line is below the top.
  , pageLegend :: !(Double, Double)
  -- ^ The top and the width of the legend.
  , pageExtras :: ![Mark]
  -- ^ What else stands in the layer of the legend.
  , pageCaption :: !Double
  -- ^ The base line of the caption's first line.
  , pageLayers :: ![Layer]
  }

-- | The drawing of a page, 800 pixels wide: its layers, without the empty ones, and above them the layer @legend@ with
-- the texts.
--
-- /Degenerate cases/ where the caption has more lines than the page has room for, all else stands higher.
pageDrawing :: Page -> Drawing
pageDrawing page =
  Drawing
    { drawingTitle = title
    , drawingDescription = pageAbout page <> Text.intercalate ", " (pageFacts page) <> "."
    , drawingWidth = canvasWidth
    , drawingHeight = pageHeight page + lift
    , drawingLayers =
        [ layer {layerMarks = if lift > 0 then map lifted (layerMarks layer) else layerMarks layer}
        | layer <- pageLayers page <> [Layer "legend" Sparse texts]
        , not (null (layerMarks layer))
        ]
    }
  where
    lifted mark = mark {markShape = raisedBy lift (markShape mark)}
    lift = maximum (0 : [5 - y | Mark _ _ (Label _ (Place _ y) _) <- caption])
    caption = captionLines left (pageCaption page) (right - left) (pageFacts page)
    title = pageTitle page
    (left, right) = pageAcross page
    (legendTop, legendWidth) = pageLegend page
    texts =
      plain
        FigureTitle
        (Label StartAnchor (Place left (pageHeight page - pageTop page)) (shortened FigureTitle (right - left) title))
        : legend left legendTop legendWidth (pageEntries page)
          <> pageExtras page
          <> caption

-- | The base line of a caption below a legend by its top.
pageBelow :: Double -> Double -> [Entry] -> Double
pageBelow top width entries = top - legendHeight width entries - 15

-- | A page of this height with nothing but a title: texts stand between the side margins.
scenePage :: Text -> Double -> Page
scenePage title height = Page title "" [] [] height (sideMargin, canvasWidth - sideMargin) 25 (0, 0) [] 0 []

-- | What the figure shows of the scene, with the scene's title.
titleAfter :: Text -> Scene -> Text
titleAfter what scene = what <> ": " <> fromMaybe "untitled scene" (sceneTitle scene)

-- | What the colours stand for.
data Bar = Bar !Text !Tone !Values

-- | The bar of colours by its top, the name's room and where the bar begins after it; its cells, then the rest.
barMarks :: Bar -> Double -> Double -> (Text -> Double) -> ([Mark], [Mark])
barMarks (Bar quantity tone values) top room begin =
  (cells, plain Caption (Label StartAnchor (Place sideMargin (top - 10)) name) : ticked)
  where
    name = shortened Caption room quantity
    left = begin name
    (cells, ticked) = colourBar tone values (Box left (top - 12) (left + 404) top)

-- | A figure in the plane of the scene.
data Plane = Plane
  { planeTitle :: !Text
  , planeAbout :: !Text
  -- ^ What the description says before the facts.
  , planeFacts :: ![Text]
  , planeEntries :: ![Entry]
  , planePoints :: ![Point]
  -- ^ Points besides the scene that the figure shows.
  , planeNaming :: !Naming
  , planeBar :: !(Maybe Bar)
  , planeRoom :: !Double
  -- ^ The height of what stands below the caption.
  , planeBelow :: ![Layer]
  , planeSheets :: Frame -> [Sheet]
  -- ^ From the bottom upwards. What is crossable above the first solid one is in the way of labels inside polygons.
  }

-- | A figure of the scene alone whose corners have labels, without title, facts and layers.
scenePlane :: Plane
scenePlane = Plane "" "" [] [] [] Corners Nothing 0 [] (const [])

-- | A layer, and how it is in the way of labels.
data Sheet = Sheet !Hold !Text !Density ![Mark]

-- | How marks are in the way of labels. Dots are in any case.
data Hold
  = -- | Labels may lie on them.
    Ground
  | -- | Leaders may cross them.
    Crossable
  | Solid
  deriving (Eq)

-- | What has labels.
data Naming
  = -- | All corners if there are up to 40; else the polygons that have room. Corners without a label are counted.
    Corners
  | -- | What is asked for.
    Asked !(Frame -> [Request])
  | -- | The polygons that have room, and what is asked for.
    PolygonsAnd !(Frame -> [Request])

-- | The polygons.
polygonSheet :: Scene -> Frame -> Sheet
polygonSheet scene frame = Sheet Solid "polygons" (polygonDensity scene) (polygonMarks scene frame)

-- | The figure to scale, 800 pixels wide.
--
-- Layers, from the bottom: @outside@ and @room@ of an enclosure; the figure's own; @leaders@ and @labels@; what stands
-- below the caption; @bar@; @legend@. Up to 40 corners are
-- labelled; where there are more, the polygons are numbered that have room for it.
--
-- /Degenerate cases/ corners that are nearer to each other than what is seen are counted in the caption, see
-- 'mergedFact'.
--
-- /Laws/ no label covers a line, an outline or another label; nothing leaves the canvas.
planeDrawing :: Scene -> Plane -> Drawing
planeDrawing scene plane =
  pageDrawing
    (scenePage (planeTitle plane) (frameHeight frame + foot + 40))
      { pageAbout = planeAbout plane
      , pageFacts = map (shortened Caption width) (facts <> countedUnlabelled unlabelled)
      , pageEntries = entries
      , pageLegend = (legendTop, legendWidth)
      , pageExtras = scaleMarks scene frame (Place (canvasWidth - sideMargin) (legendTop - rowHeight / 2)) <> barTexts
      , pageCaption = pageBelow legendTop legendWidth entries - fst barRoom
      , pageLayers =
          groundLayers scene frame
            <> [Layer name density marks | Sheet _ name density marks <- sheets]
            <> [Layer "leaders" Sparse leaders, Layer "labels" Sparse labels]
            <> planeBelow plane
            <> [Layer "bar" Sparse barCells]
      }
  where
    (width, legendWidth) = (canvasWidth - 2 * sideMargin, width - 150)
    entries = planeEntries plane
    facts = planeFacts plane <> mergedFact (framePixel scene unfooted) (planePoints plane <> statedPoints)
    statedPoints = map snd (statedCorners scene)
    unfooted = frameFor 0 scene (planePoints plane)
    frame = frameFor foot scene (planePoints plane)
    legendTop = foot - 6

    -- How much room the foot takes must be known before there are labels.
    foot =
      planeRoom plane
        + max standardFoot (legendHeight legendWidth entries + rowHeight * captionRows + 9 + snd barRoom)
    captionRows = fromIntegral (length (captionLines 0 0 width (map (shortened Caption width) (facts <> doubtful))))
    doubtful = case planeNaming plane of
      Corners | fewCorners scene -> countedUnlabelled (corners scene)
      _ -> []

    barRoom = maybe (0, 0) (const (39, 47)) (planeBar plane)
    (barCells, barTexts) = maybe ([], []) drawnBar (planeBar plane)
    drawnBar bar =
      barMarks bar (legendTop - legendHeight legendWidth entries - 8) 200 (\n -> sideMargin + textWidth Caption n + 12)

    sheets = planeSheets plane frame
    obstruction =
      Obstruction
        { canvas = frameOutside frame
        , lightLines = held Crossable sheets
        , walls = held Solid sheets
        , taken = concat [dotBoxes marks | Sheet _ _ _ marks <- sheets]
        , clearance = 1.5
        }
    (labels, leaders, unlabelled) = case planeNaming plane of
      Corners
        | fewCorners scene -> placeLabels obstruction (cornerRequests scene frame)
        | otherwise -> (numbers, [], [])
      -- The caption has what finds no room.
      Asked requests -> let (found, thin, _) = placeLabels obstruction (requests frame) in (found, thin, [])
      PolygonsAnd requests ->
        let around = obstruction {taken = mapMaybe textBox numbers <> taken obstruction}
            (found, thin, _) = placeLabels around (requests frame)
         in (numbers <> found, thin, [])
    numbers = mapMaybe (polygonLabel (placeOfPoint scene frame) overPolygons) (scenePolygons scene)
    overPolygons = held Crossable (dropWhile (\(Sheet hold _ _ _) -> hold /= Solid) sheets)
    held how found = concat [concatMap wideLines marks | Sheet hold _ _ marks <- found, hold == how]
