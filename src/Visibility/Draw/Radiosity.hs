{-# LANGUAGE OverloadedStrings #-}

-- | The figure of light: how bright each element of each side is.
module Visibility.Draw.Radiosity
  ( RadiosityFigure (..)
  , LitElement (..)
  , lightFigure
  , radiosityDrawing
    -- * Profiles
  , Profile (..)
  , Panel (..)
  , panelHeight
  , profilePanel
  ) where

import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as Text
import Visibility.Draw.Band
import Visibility.Draw.Colour (Shade)
import Visibility.Draw.Figure
import Visibility.Exact.Point (Point)
import Visibility.Exact.RootSum (asRational, enclosureRelative, rational)
import Visibility.Exact.Rounding (nearestDouble)
import Visibility.FormFactor (sideLength)
import Visibility.Mesh.Element
import Visibility.Mesh.Span (parameterOn)
import Visibility.Radiosity (Lit (..), Radiosity (..))
import Visibility.Scene

-- | What is shown, and how.
data RadiosityFigure = RadiosityFigure
  { radiosityQuantity :: !Text
  -- ^ What the values are, such as @radiosity B@.
  , radiosityScaling :: !Scaling
  , radiosityProfiles :: ![SideName]
  -- ^ The sides that have a profile, in this order.
  , radiosityElements :: ![LitElement]
  }
  deriving (Eq, Show)

-- | A part of a side of the file, with a value that holds on all of it.
data LitElement = LitElement
  { litSide :: !SideName
  , litFrom :: !Rational
  -- ^ Where it begins on the side, 0 at the side's first corner and 1 at its second.
  , litTo :: !Rational
  , litEnds :: !(Point, Point)
  -- ^ The same in the file's coordinates.
  , litValue :: !Double
  }
  deriving (Eq, Show)

-- | The radiosities of elements, each the Double nearest to the middle of its bounds, with profiles along some sides.
--
-- /Degenerate cases/ where all are too small for Doubles, or some too large, they are in units that the figure names.
lightFigure :: Scaling -> [SideName] -> Refined -> Radiosity -> RadiosityFigure
lightFigure scaling profiles cut found =
  RadiosityFigure
    { radiosityQuantity = "radiosity" <> unitText
    , radiosityScaling = scaling
    , radiosityProfiles = profiles
    , radiosityElements = map lit (litElements found)
    }
  where
    lit l =
      LitElement
        { litSide = elementSide (litElement l)
        , litFrom = elementFrom (litElement l)
        , litTo = elementTo (litElement l)
        , litEnds = elementEnds cut (litElement l)
        , litValue = nearestDouble (rational (middle l / unit))
        }
    middle l = let (low, high) = litRadiosity l in (low + high) / 2
    greatest = maximum (0 : map middle (litElements found))
    (unit, unitText)
      | greatest == 0 || (1e-300 < greatest && greatest < 1e300) = (1, "")
      | otherwise = let step = roundStep greatest in (step, " in units of " <> decimalText step)

-- | The scene to scale, 800 pixels wide, with the elements as bands beside their sides in free space, brighter where
-- there is more light; below it a panel for each profile.
--
-- Layers, from the bottom: @bands@, named by their sides; @edges@, the outlines of bands; @polygons@, named as in
-- output; @lights@, rays at the sides that give light; of the profiles @areas@, @profiles@, @axes@, @ticks@.
--
-- A linear scale ends at the greatest value of what gives no light of its own; light sources have the brightest colour.
--
-- /Degenerate cases/ each face of a thin wall has a band of its own. Bands are thinner where there is little room. An
-- element on a part of a side that is covered has no band; one that is covered in part has one for each part that is
-- not. On a logarithmic scale, what is dark has the colour of the least value. A profile of a side without elements is
-- empty; there is none of a name that the scene has not.
--
-- /Requires/ elements of the scene's sides. /Cost/ that of 'stripsOf', and O(m log n) for m elements, besides labels.
--
-- /Laws/ those of 'planeDrawing'; bands do not cross into the solid; a larger value is not darker; every polygon has
-- exactly one mark.
radiosityDrawing :: Scene -> RadiosityFigure -> Drawing
radiosityDrawing scene figure =
  planeDrawing scene $
    scenePlane
      { planeTitle = title
      , planeAbout = title <> ", the brighter the more: "
      , planeFacts = facts
      , planeEntries =
          fst (sceneryEntries scene) <> [Entry raySwatch "light source" | not (null (snd (sceneryEntries scene)))]
      , planeNaming = PolygonsAnd (\frame -> map (sideRequest scene (stripsIn frame)) chosen)
      , planeBar = Just (Bar quantity MoreIsBrighter scale)
      , planeRoom = panelHeight * fromIntegral (length chosen)
      , planeBelow =
          [ Layer name Sparse (concatMap marks panels)
          | (name, marks) <-
              [("areas", panelAreas), ("profiles", panelLines), ("axes", panelAxes), ("ticks", panelLabels)]
          ]
      , planeSheets = sheets
      }
  where
    title = titleAfter (capital quantity) scene
    capital text = Text.toUpper (Text.take 1 text) <> Text.drop 1 text
    quantity = radiosityQuantity figure
    found = radiosityElements figure
    shown = [element | (element, _, _) <- lit]
    counting = countedValues scene (radiosityScaling figure) shown
    scale = fitted (radiosityScaling figure) counting
    shade = shadeOf MoreIsBrighter scale
    beyond = maximum (0 : map litValue shown)

    stripsIn frame = stripsOf scene (placeOf scene frame) bandWidth
    lit = [(element, piece, part) | element <- found, (piece, part) <- uncoveredParts scene element]
    -- In order along the sides, each a little below the next, since viewers smooth edges and would leave seams.
    inOrder = sortOn (\(_, piece, (from, _)) -> (piece, from)) lit
    sheets frame =
      [ Sheet Ground "bands" (densityOf (length bands)) bands
      , Sheet Solid "edges" (polygonDensity scene) edges
      , polygonSheet scene frame
      , Sheet Solid "lights" (polygonDensity scene) rays
      ]
      where
        strips = stripsIn frame
        bands =
          [ Mark (Text.pack (sideText (litSide element))) (Band (shade (litValue element))) $
              Region (stripPart strip (fromRational from) (belowNext strip (fromRational to)))
          | (element, piece, (from, to)) <- inOrder
          , Just strip <- [Map.lookup piece strips]
          ]
        edges =
          [ Mark (sideTag scene piece) BandEdge (Region (stripOutline strip))
          | piece <- Map.keys (Map.fromList [(piece, ()) | (_, piece, _) <- lit])
          , Just strip <- [Map.lookup piece strips]
          ]
        rays =
          [ Mark (sideTag scene side) LightRay (Polyline ray)
          | side <- lightSources scene
          , Just strip <- [Map.lookup side strips]
          , ray <- stripRays bandWidth strip
          ]

    chosen = [side | side <- radiosityProfiles figure, Just _ <- [piecesOf scene side]]
    panels =
      [ profilePanel shade panelScale sideMargin top (canvasWidth - 2 * sideMargin) (profileOf scene figure side)
      | (k, side) <- zip [0 ..] chosen
      , let top = panelHeight * (fromIntegral (length chosen) - k)
      ]
    -- One scale for all panels, so that they can be compared; lamps elsewhere do not press them down.
    panelScale = fitted (radiosityScaling figure) [litValue e | e <- found, litSide e `elem` chosen]
    facts =
      [ counted (length (scenePolygons scene)) "polygon" "polygons"
      , counted (length found) "element" "elements"
      , case radiosityScaling figure of
          Linear -> "linear scale"
          Logarithmic -> "logarithmic scale"
      ]
        <> [ "light sources, up to " <> shortNumber beyond <> ", are beyond the scale"
           | beyond > maximum (0 : counting)
           ]

-- | The values that the scale is made for: on a linear one light sources would leave all else in the dark, so they do
-- not count unless there is nothing else.
countedValues :: Scene -> Scaling -> [LitElement] -> [Double]
countedValues scene scaling found = case scaling of
  Linear | any (> 0) dark -> dark
  _ -> map litValue found
  where
    dark = [litValue e | e <- found, not (Set.member (litSide e) lights)]
    lights = Set.fromList (map (sideName scene) (lightSources scene))

-- | The width of a band that has room, in pixels.
bandWidth :: Double
bandWidth = 8

-- | A position on a strip, moved a little onwards, but not beyond its end.
belowNext :: Strip -> Double -> Double
belowNext strip to
  | stripLong strip > 0 = min 1 (to + 0.3 / stripLong strip)
  | otherwise = to

-- | The rays that mark a light, above a piece of its side.
raySwatch :: Box -> [Mark]
raySwatch (Box l b r t) =
  plain Axis (Polyline [Place l b, Place r b])
    : [plain LightRay (Polyline [Place x (b + 2.5), Place x t]) | k <- [1, 3, 5], let x = l + (r - l) * k / 6]

-- | The uncovered pieces of its side that an element lies on, each with the part that it takes, 0 at the start of the
-- piece and 1 at its end.
uncoveredParts :: Scene -> LitElement -> [(SideId, (Rational, Rational))]
uncoveredParts scene element =
  [ (piece, (from, to))
  | piece <- fromMaybe [] (piecesOf scene (litSide element))
  , let (a, b) = (cornerPoint scene (sideStart piece), cornerPoint scene (sideEnd scene piece))
  , let (s, s') = (parameterOn (a, b) p, parameterOn (a, b) q)
  , let (from, to) = (max 0 (min s s'), min 1 (max s s'))
  , from < to
  ]
  where
    (p, q) = litEnds element

-- | The label of a side, beyond its band.
sideRequest :: Scene -> Map.Map SideId Strip -> SideName -> Request
sideRequest scene strips side = Request name SideLabel name seats
  where
    name = Text.pack (sideText side)
    seats =
      [ Seat here (outward strip) pi
      | s <- [1 / 2, 1 / 3, 2 / 3, 1 / 6, 5 / 6]
      , piece <- fromMaybe [] (piecesOf scene side)
      , Just strip <- [Map.lookup piece strips]
      , here <- [stripPlace strip s]
      ]
    outward strip =
      let (Place x y, Place x' y') = (outwardPlace strip 0 0, outwardPlace strip 0 1) in atan2 (y' - y) (x' - x)

-- | How a value runs along a side.
data Profile = Profile
  { profileName :: !Text
  , profileUpwards :: !Text
  -- ^ What the values are.
  , profileLength :: !Rational
  -- ^ Of the side, in the file's units.
  , profileSteps :: ![LitElement]
  }
  deriving (Eq, Show)

-- | The values along a side.
profileOf :: Scene -> RadiosityFigure -> SideName -> Profile
profileOf scene figure side =
  Profile (Text.pack (sideText side)) (radiosityQuantity figure) about (filter ((== side) . litSide) elements)
  where
    elements = radiosityElements figure
    long = sideLength scene side
    near = nearestDouble long
    about
      | 1e-15 < near && near < 1e15 = toRational near
      | otherwise = fromMaybe (fst (enclosureRelative 64 long)) (asRational long)

-- | The marks of a panel by their layers.
data Panel = Panel
  { panelAreas :: ![Mark]
  -- ^ In the colours of the values.
  , panelLines :: ![Mark]
  , panelAxes :: ![Mark]
  , panelLabels :: ![Mark]
  }

-- | The height of a panel with its labels, in pixels.
panelHeight :: Double
panelHeight = 158

-- | The panel by the colours of values, the scale of its vertical axis, its left, its top and its width: steps over the
-- distance along the side, with a tick below at round distances and one above the axis at each position where a step
-- ends.
--
-- /Degenerate cases/ where steps do not follow each other, as on parts that are covered, the line is interrupted.
-- Values beyond the scale are at its end.
--
-- /Laws/ one area for each step, as high as its value on the scale.
profilePanel :: (Double -> Shade) -> Values -> Double -> Double -> Double -> Profile -> Panel
profilePanel shade values left top width profile =
  Panel
    { panelAreas = map area steps
    , panelLines = [Mark name ProfileLine (Polyline (concatMap flat run)) | run <- runs steps]
    , panelAxes =
        plain Axis (Polyline [Place l t, Place l b, Place r b]) : map partMark (Set.toList breaks)
          <> [plain Tick (Polyline [Place x (b - 5), Place x b]) | (s, _) <- distances, let x = across s]
          <> [plain Tick (Polyline [Place (l - 5) y, Place l y]) | (s, _) <- heights, let y = up s]
    , panelLabels =
        [plain TickLabel (Label MiddleAnchor (Place (across s) (b - 18)) text) | (s, text) <- distances]
          <> [ plain TickLabel (Label EndAnchor (Place (l - 8) (up s - 0.36 * textSize TickLabel)) text)
             | (s, text) <- heights
             ]
          <> [ plain AxisTitle (Label EndAnchor (Place r (b - 37)) ("distance along side " <> name))
             , plain AxisTitle (Label StartAnchor (Place l (t + 9)) (profileUpwards profile))
             ]
    }
  where
    name = profileName profile
    (l, r) = (left + 62, left + width - 18)
    (b, t) = (top - panelHeight + 46, top - 24)
    across s = l + s * (r - l)
    along = across . fromRational
    up s = b + s * (t - b)
    steps = sortOn litFrom (profileSteps profile)
    height step = up (placeOn values (litValue step))
    area step =
      Mark name (Band (shade (litValue step))) $
        boxRegion (Box (along (litFrom step)) b (along (litTo step)) (height step))
    flat step = [Place (along (litFrom step)) (height step), Place (along (litTo step)) (height step)]
    breaks = Set.fromList [s | step <- steps, s <- [litFrom step, litTo step], s > 0, s < 1]
    partMark s = plain Tick (Polyline [Place (along s) b, Place (along s) (b + 4)])
    distances = ticksAcross (r - l) (evenTicks (profileLength profile))
    heights = ticks values 4

-- | Steps that follow each other without a gap.
runs :: [LitElement] -> [[LitElement]]
runs steps = foldr add [] steps
  where
    add step ((next : more) : others) | litTo step == litFrom next = (step : next : more) : others
    add step others = [step] : others
