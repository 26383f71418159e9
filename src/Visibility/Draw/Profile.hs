{-# LANGUAGE OverloadedStrings #-}

-- | Profiles: how a value runs along a side, as steps.
module Visibility.Draw.Profile
  ( Profile (..)
  , Step (..)
  , Panel (..)
  , panelHeight
  , profilePanel
  ) where

import Data.List (sortOn)
import qualified Data.Set as Set
import Data.Text (Text)
import Visibility.Draw.Colour (Shade)
import Visibility.Draw.Drawing
import Visibility.Draw.Values

-- | A value along a side.
data Profile = Profile
  { profileName :: !Text
  , profileAcross :: !Text
  -- ^ What the horizontal axis tells.
  , profileUpwards :: !Text
  -- ^ What the values are.
  , profileLength :: !Rational
  -- ^ Of the side, in the file's units.
  , profileSteps :: ![Step]
  }
  deriving (Eq, Show)

-- | A value that holds between two positions on the side, 0 at its start and 1 at its end.
data Step = Step
  { stepFrom :: !Rational
  , stepTo :: !Rational
  , stepValue :: !Double
  }
  deriving (Eq, Ord, Show)

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
        plain Axis (Polyline [Place l t, Place l b, Place r b]) : map breakMark (Set.toList breaks)
          <> [plain Tick (Polyline [Place x (b - 5), Place x b]) | (s, _) <- distances, let x = across s]
          <> [plain Tick (Polyline [Place (l - 5) y, Place l y]) | (s, _) <- heights, let y = up s]
    , panelLabels =
        [plain TickLabel (Label MiddleAnchor (Place (across s) (b - 18)) text) | (s, text) <- distances]
          <> [ plain TickLabel (Label EndAnchor (Place (l - 8) (up s - 0.36 * textSize TickLabel)) text)
             | (s, text) <- heights
             ]
          <> [ plain AxisTitle (Label EndAnchor (Place r (b - 37)) (profileAcross profile))
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
    steps = sortOn stepFrom (profileSteps profile)
    height step = up (placeOn values (stepValue step))
    area step =
      Mark name (Band (shade (stepValue step))) $
        boxRegion (Box (along (stepFrom step)) b (along (stepTo step)) (height step))
    flat step = [Place (along (stepFrom step)) (height step), Place (along (stepTo step)) (height step)]
    breaks = Set.fromList [s | step <- steps, s <- [stepFrom step, stepTo step], s > 0, s < 1]
    breakMark s = plain Tick (Polyline [Place (along s) b, Place (along s) (b + 4)])
    distances = ticksAcross (r - l) (evenTicks (profileLength profile))
    heights = ticks values 4

-- | Steps that follow each other without a gap.
runs :: [Step] -> [[Step]]
runs steps = foldr add [] steps
  where
    add step ((next : more) : others) | stepTo step == stepFrom next = (step : next : more) : others
    add step others = [step] : others
