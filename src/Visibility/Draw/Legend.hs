{-# LANGUAGE OverloadedStrings #-}

-- | Legends and captions: a row of swatches with their meanings, broken where it gets too long, and lines of text.
module Visibility.Draw.Legend
  ( Entry (..)
  , lineSwatch
  , regionSwatch
  , dotSwatch
  , legendHeight
  , legend
  , captionLines
  , shortened
  , rowHeight
  ) where

import Data.List (inits)
import Data.Text (Text)
import qualified Data.Text as Text
import Visibility.Draw.Drawing

-- | What a style means. The swatch is drawn in the box given.
data Entry = Entry
  { entrySwatch :: Box -> [Mark]
  , entryText :: !Text
  }

-- | A piece of line in some styles, the later above.
lineSwatch :: [Style] -> Box -> [Mark]
lineSwatch styles (Box l b r t) = [plain style (Polyline [Place l y, Place r y]) | style <- styles]
  where
    y = (b + t) / 2

-- | A filled rectangle.
regionSwatch :: Style -> Box -> [Mark]
regionSwatch style box = [plain style (boxRegion box)]

-- | A dot.
dotSwatch :: Style -> Box -> [Mark]
dotSwatch style (Box l b r t) = [plain style (Dot (Place ((l + r) / 2) ((b + t) / 2)))]

-- | The height of a row, in pixels.
rowHeight :: Double
rowHeight = 19

swatchWidth, swatchGap, entryGap :: Double
swatchWidth = 24
swatchGap = 6
entryGap = 20

-- | How high a legend of this width is.
legendHeight :: Double -> [Entry] -> Double
legendHeight width entries = rowHeight * fromIntegral (length (rows width entries))

-- | The marks of a legend by its left, its top and its width.
legend :: Double -> Double -> Double -> [Entry] -> [Mark]
legend left top width entries =
  concat
    [ entryMarks (left + x) (top - rowHeight * (k + 0.5)) entry
    | (k, row) <- zip [0 ..] (rows width entries)
    , (x, entry) <- zip (scanl (+) 0 (map advance row)) row
    ]
  where
    entryMarks x y (Entry swatch text) =
      swatch (Box x (y - 4.5) (x + swatchWidth) (y + 4.5))
        <> [ plain Caption $
               Label StartAnchor (Place (x + swatchWidth + swatchGap) (y - 0.36 * textSize Caption)) text
           ]

advance :: Entry -> Double
advance entry = swatchWidth + swatchGap + textWidth Caption (entryText entry) + entryGap

rows :: Double -> [Entry] -> [[Entry]]
rows width = filled (\row -> sum (map advance row) - entryGap <= width)

-- | As many things to a row as fit, but at least one.
filled :: ([a] -> Bool) -> [a] -> [[a]]
filled _ [] = []
filled fits things = row : filled fits rest
  where
    (row, rest) = splitAt (max 1 (length (takeWhile fits (drop 1 (inits things))))) things

-- | Texts joined by commas to lines that fit a width; the base line of the first line, and the rest below.
captionLines :: Double -> Double -> Double -> [Text] -> [Mark]
captionLines left base width parts =
  [ plain Caption (Label StartAnchor (Place left (base - rowHeight * k)) line)
  | (k, line) <- zip [0 ..] (zipWith (<>) (map joined inRows) (map (const ",") (drop 1 inRows) <> [""]))
  ]
  where
    inRows = filled fits parts
    joined = Text.intercalate ", "
    fits row = textWidth Caption (joined row) <= width

-- | A text cut so that it fits a width. /Cost/ linear in the text.
shortened :: Style -> Double -> Text -> Text
shortened style width text
  | textWidth style text <= width = text
  | otherwise = Text.snoc (Text.take (length (takeWhile fits (drop 1 widths))) text) '…'
  where
    -- Those of the beginnings of the text, up to the last but one letter.
    widths = scanl (+) 0 (map letterWidth (Text.unpack (Text.dropEnd 2 text)))
    fits w = textSize style * (w + letterWidth '…') <= width
