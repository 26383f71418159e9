{-# LANGUAGE OverloadedStrings #-}

-- | What specs ask of drawings: their marks, what is wrong with them, and their listing for golden tests.
module Visibility.Draw.Checks
  ( -- * Marks
    drawingMarks
  , marksIn
    -- * Flaws
  , Flaw (..)
  , labelCollisions
  , strayMarks
    -- * As text
  , listing
  ) where

import Data.List (tails)
import Data.Text (Text)
import qualified Data.Text as Text
import Numeric (showFFloat)
import Visibility.Draw.Drawing

-- | All marks, from the bottom upwards.
drawingMarks :: Drawing -> [Mark]
drawingMarks = concatMap layerMarks . drawingLayers

-- | The marks of the layer of this name.
marksIn :: Text -> Drawing -> [Mark]
marksIn name drawing = concat [layerMarks layer | layer <- drawingLayers drawing, layerName layer == name]

-- | What is wrong with a label, by the names of the marks.
data Flaw
  = LabelOnLabel !Text !Text
  | LabelOnLine !Text !Text
  | LabelOnDot !Text !Text
  deriving (Eq, Ord, Show)

-- | Texts that run over another text, a line, an outline or a dot. Meant to be empty.
--
-- /Cost/ the number of texts times that of segments.
labelCollisions :: Drawing -> [Flaw]
labelCollisions drawing =
  [LabelOnLabel a b | ((a, box) : others) <- tails texts, (b, box') <- others, boxesMeet box box']
    <> [ LabelOnLine a (markName mark)
       | layer <- drawingLayers drawing
       , mark <- layerMarks layer
       , let around = strokeWidth (layerDensity layer) (markStyle mark) / 2
       , let segments = strokes mark
       , not (null segments)
       , (a, box) <- texts
       , any (segmentMeetsBox (widened around box)) segments
       ]
    <> [ LabelOnDot a name
       | layer <- drawingLayers drawing
       , Mark name style (Dot (Place x y)) <- layerMarks layer
       , let r = dotRadius (layerDensity layer) style + strokeWidth (layerDensity layer) style / 2
       , (a, box) <- texts
       , boxesMeet box (Box (x - r) (y - r) (x + r) (y + r))
       ]
  where
    texts = [(text, box) | mark@(Mark _ _ (Label _ _ text)) <- drawingMarks drawing, Just box <- [textBox mark]]

-- | Marks that leave the canvas. Meant to be empty.
strayMarks :: Drawing -> [Mark]
strayMarks drawing = filter (any outside . extremes) (drawingMarks drawing)
  where
    outside (Place x y) = not (x >= 0 && x <= drawingWidth drawing && y >= 0 && y <= drawingHeight drawing)
    extremes mark = case (markShape mark, textBox mark) of
      (_, Just (Box l b r t)) -> [Place l b, Place r t]
      (Region places, _) -> places
      (Polyline places, _) -> places
      (Dot place, _) -> [place]
      (Label _ place _, _) -> [place]

-- | A drawing as lines of text, places to hundredths of a pixel: what golden tests compare.
listing :: Drawing -> String
listing drawing =
  unlines $
    [ "title " <> Text.unpack (drawingTitle drawing)
    , "description " <> Text.unpack (drawingDescription drawing)
    , "size " <> number (drawingWidth drawing) <> " " <> number (drawingHeight drawing)
    ]
      <> concatMap layerLines (drawingLayers drawing)
  where
    layerLines (Layer name density marks) =
      ("layer " <> Text.unpack name <> " " <> show density) : map (("  " <>) . markLine) marks
    markLine (Mark name style shape) =
      unwords (show style : ["[" <> Text.unpack name <> "]" | not (Text.null name)] <> shapeWords shape)
    shapeWords shape = case shape of
      Region places -> "region" : map placed places
      Polyline places -> "polyline" : map placed places
      Dot place -> ["dot", placed place]
      Label anchor place text -> ["text", show anchor, placed place, show (Text.unpack text)]
    placed (Place x y) = number x <> "," <> number y
    number v = case showFFloat (Just 2) v "" of
      "-0.00" -> "0.00"
      digits -> digits
