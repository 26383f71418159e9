{-# LANGUAGE OverloadedStrings #-}

-- | The figure of a matrix, as that of the form factors: a cell for each entry, coloured by its logarithm.
module Visibility.Draw.Matrix
  ( Matrix (..)
  , Group (..)
  , matrixDrawing
  , factorMatrix
  , elementMatrix
  , withSky
  ) where

import Data.Foldable (toList)
import Data.Function (on)
import Data.List (sortOn)
import qualified Data.List.NonEmpty as NonEmpty
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Ord (Down (..))
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Numeric (showFFloat)
import Visibility.Draw.Colour (Shade (..), shades)
import Visibility.Draw.Figure hiding (Line)
import Visibility.FormFactor (FactorRow (..))
import Visibility.Mesh.Element
import Visibility.Scene
import Visibility.Sorting (bucketOf, bucketsBy)

-- | A matrix whose rows and columns are things in groups: sides by polygons, or elements by sides.
data Matrix thing = Matrix
  { matrixTitle :: !Text
  , matrixQuantity :: !Text
  -- ^ What the entries are.
  , matrixThings :: !Text
  -- ^ What the things are, in the plural.
  , matrixGroups :: !Text
  -- ^ What the groups are, in the plural.
  , matrixRows :: ![Group thing]
  , matrixColumns :: ![Group thing]
  , matrixName :: thing -> Text
  , matrixEntries :: ![(thing, thing, Double)]
  -- ^ Row, column and value of all entries that are not zero, each once.
  }

-- | Rows or columns that belong together, with their name.
data Group thing = Group
  { groupLabel :: !Text
  , groupWhole :: !Text
  -- ^ The name of what the group is a part of. Neighbours of one whole belong together, too.
  , groupMembers :: ![thing]
  }
  deriving (Eq, Show)

-- | The matrix of form factors: from the sides of the file, by polygons, to the same and the sky.
--
-- /Shape/ no column for the sky where there is none. /Degenerate cases/ sides that are all covered have empty rows.
factorMatrix :: Scene -> [FactorRow Double] -> Matrix Seen
factorMatrix scene factors =
  Matrix
    { matrixTitle = "Form factors of " <> fromMaybe "an untitled scene" (sceneTitle scene)
    , matrixQuantity = "form factor"
    , matrixThings = "sides"
    , matrixGroups = "polygons"
    , matrixRows = polygons
    , matrixColumns = withSky scene polygons
    , matrixName = Text.pack . seenText
    , matrixEntries = [(TheSide (rowFrom row), to, value) | row <- factors, (to, value) <- rowFactors row]
    }
  where
    polygons =
      [ Group name name (map TheSide members)
      | (p, members) <- Map.toList byPolygon
      , let name = Text.pack (polygonText p)
      ]
    byPolygon = Map.fromListWith (flip (<>)) [(p, [side]) | side@(SideName p _) <- statedSides scene]

-- | The matrix of the form factors of elements, by the sides that they are on, which are parts of polygons.
--
-- /Laws/ those of 'factorMatrix'.
elementMatrix :: Refined -> [FactorRow Double] -> Matrix Seen
elementMatrix cut rows =
  (factorMatrix scene rows)
    { matrixTitle = "Form factors of the elements of " <> fromMaybe "an untitled scene" (sceneTitle scene)
    , matrixThings = "elements"
    , matrixGroups = "sides"
    , matrixRows = sidesOfFile
    , matrixColumns = withSky scene sidesOfFile
    , matrixName = nameOf
    }
  where
    scene = refinedScene cut
    sidesOfFile =
      [ Group (Text.pack (sideText side)) (Text.pack (polygonText polygon)) (map TheSide members)
      | (side@(SideName polygon _), members) <- Map.toList bySide
      ]
    bySide = Map.fromListWith (flip (<>)) [(elementSide e, [elementIn e]) | e <- refinedElements cut]
    names = elementNames cut
    nameOf seen = Text.pack $ case seen of
      TheSide name -> names name
      TheSky -> seenText TheSky

-- | Columns with one for the sky where there is one.
withSky :: Scene -> [Group Seen] -> [Group Seen]
withSky scene groups = groups <> [Group "sky" "sky" [TheSky] | surroundings scene == OpenSky]

-- | The matrix, 800 pixels wide: rows from above, columns from the left, in the order given; darker is more, on a
-- logarithmic scale. An entry that is 0 has no cell.
--
-- Layers, from the bottom: @groups@, lines between groups; @cells@, squares named @0.1 2.3@ by row and column; @frame@;
-- @labels@, of all rows and columns where they have room, else of the groups that have; @bar@ and @legend@.
--
-- /Degenerate cases/ an entry that is given as 0, because it is too small for a Double, is as light as a cell can be.
-- A line stands only where it is apart from others: between two wholes that are both wide enough, and between two such
-- groups of one whole; so small groups, as the sides of a round object, are not hatched, and what lies beside them is
-- told apart all the same. A matrix without rows is an empty square.
--
-- /Requires/ all things of entries in the rows and columns. /Cost/ O(m log n) for m entries of n rows and columns,
-- besides labels; what is kept are three numbers for each entry.
--
-- /Laws/ as many cells as entries, none of which share a point inside both; all cells are squares of one size; a larger
-- value is not lighter; no line crosses a cell; lines are at least six pixels apart; no label covers anything.
matrixDrawing :: Ord thing => Matrix thing -> Drawing
matrixDrawing matrix =
  pageDrawing
    (scenePage (matrixTitle matrix) (top + 30 + 40 + 14))
      { pageAbout = "A matrix with a square for each entry that is not zero, the darker the larger: "
      , pageFacts = facts
      , pageExtras = barTexts <> blankMarks
      , pageCaption = 10 + rowHeight * (captionRows - 1)
      , pageLayers =
          [ Layer "groups" Sparse (map groupLine (lineGaps columns) <> map groupLineAcross (lineGaps rows))
          , Layer "cells" (densityOf count) cells
          , Layer "frame" Sparse [plain Axis (boxRegion (Box left bottom right top))]
          , Layer "labels" Sparse (labels <> axisTitles)
          , Layer "bar" Sparse barCells
          ]
      }
  where
    -- A million entries are common, so they are kept as numbers: the places of row and column, and the value.
    entries = placedEntries matrix
    count = U.length entries
    values = let (_, _, found) = U.unzip3 entries in found
    scale = fitted Logarithmic (U.toList values)

    -- How large a cell is, and how wide the gaps between groups.
    room = canvasWidth - leftMargin - 2 * sideMargin - 14
    most = max (total (matrixRows matrix)) (total (matrixColumns matrix))
    roomiest = min 30 ((room - 2 * inset) / fromIntegral (max 1 most))
    (rowsApart, columnsApart) = (setApart roomiest (matrixRows matrix), setApart roomiest (matrixColumns matrix))
    gapCount = fromIntegral (max (length (filter id rowsApart)) (length (filter id columnsApart)))
    gap = min 2 (0.1 * room / max 1 gapCount)
    cell = wholeIfLarge (min 30 ((room - gap * gapCount - 2 * inset) / fromIntegral (max 1 most)))
    wholeIfLarge c = if c >= 4 then fromIntegral (floor c :: Int) else c
    columns = arranged cell gap columnsApart (matrixColumns matrix)
    rows = arranged cell gap rowsApart (matrixRows matrix)
    across line = lineLength line + 2 * inset
    left = leftMargin + (room - across columns) / 2
    right = left + across columns
    bottom = footHeight
    top = bottom + across rows

    cells = [cellMark (Shade k) (entries U.! i) | k <- [0 .. length shades - 1], i <- bucketOf byShade k]
    byShade = bucketsBy (length shades) (U.map shadeNumber values)
    shadeNumber value = let Shade k = shadeOf MoreIsDarker scale value in fromIntegral k
    cellMark shade (row, column, _) =
      Mark (rowNames V.! row <> " " <> columnNames V.! column) (Cell shade) $
        boxRegion (Box (left + inset + x) (top - inset - y - cell) (left + inset + x + cell) (top - inset - y))
      where
        (x, y) = (columnStarts V.! column, rowStarts V.! row)
    (rowNames, columnNames) = (namesOf (matrixRows matrix), namesOf (matrixColumns matrix))
    namesOf = V.fromList . map (matrixName matrix) . concatMap groupMembers
    (rowStarts, columnStarts) = (V.fromList (lineStarts rows), V.fromList (lineStarts columns))
    groupLine s = plain Reference (Polyline [Place (left + inset + s) bottom, Place (left + inset + s) top])
    groupLineAcross s = plain Reference (Polyline [Place left (top - inset - s), Place right (top - inset - s)])

    names line groups
      | fits =
        [ Span (matrixName matrix thing) s (s + cell)
        | (thing, s) <- zip (concatMap groupMembers groups) (lineStarts line)
        ]
      | otherwise = lineSpans line
    fits = all (\thing -> textWidth TickLabel (matrixName matrix thing) + 3 <= cell) across'
    across' = concatMap groupMembers (matrixColumns matrix)
    labels =
      apart (map columnLabel (names columns (matrixColumns matrix)))
        <> apart (map rowLabel (names rows (matrixRows matrix)))
    columnLabel s = labelMark s (Label MiddleAnchor (Place (left + inset + spanMiddle s) (top + 6)))
    rowLabel s = labelMark s (Label EndAnchor (Place (left - 5) (onMiddle (top - inset - spanMiddle s))))
    onMiddle y = y - 0.36 * textSize TickLabel
    labelMark s shape = Mark (spanLabel s) TickLabel (shape (spanLabel s))
    axisTitles =
      [ plain AxisTitle (Label MiddleAnchor (Place ((left + right) / 2) (top + 22)) "to")
      , plain AxisTitle (Label EndAnchor (Place (left - 5) (top + 22)) "from")
      ]

    captionRows = fromIntegral (length (captionLines 0 0 (canvasWidth - 2 * sideMargin) facts))
    footHeight = 14 + rowHeight * captionRows + 44
    (barTop, barLeft) = (footHeight - 14, sideMargin + 110)
    (barCells, barTexts) = barMarks (Bar (matrixQuantity matrix) MoreIsDarker scale) barTop 100 (const barLeft)
    blankMarks = legend (barLeft + 404 + 50) (barTop + 3.5) 200 [Entry (regionSwatch Axis) "exactly 0"]
    facts =
      [ Text.pack (show (total (matrixRows matrix))) <> " " <> matrixThings matrix <> " in "
          <> Text.pack (show (length (matrixRows matrix)))
          <> " "
          <> matrixGroups matrix
      , counted count "entry is not 0" "entries are not 0"
          <> " (" <> percentage count (total (matrixRows matrix) * total (matrixColumns matrix)) <> ")"
      ]
        <> [ "from " <> least (U.minimum values) <> " to " <> shortNumber (U.maximum values)
           | count > 0
           ]

    -- What is no 0 and rounds to it.
    least v = if v > 0 then shortNumber v else "less than 5e−324"

-- | The entries, with the numbers of their rows and columns.
placedEntries :: Ord thing => Matrix thing -> U.Vector (Int, Int, Double)
placedEntries matrix =
  U.fromList
    [ (r, c, value)
    | (row, column, value) <- matrixEntries matrix
    , Just r <- [Map.lookup row rows]
    , Just c <- [Map.lookup column columns]
    ]
  where
    (rows, columns) = (numbered (matrixRows matrix), numbered (matrixColumns matrix))
    numbered groups = Map.fromList (zip (concatMap groupMembers groups) [0 ..])

-- | Room for labels to the left, room between the frame and the cells.
leftMargin, inset :: Double
leftMargin = 50
inset = 1

-- | How wide a group has to be to have lines on both sides. Lines in a tenth of the room then have their full width.
leastApart :: Double
leastApart = 8

total :: [Group thing] -> Int
total = sum . map (length . groupMembers)

percentage :: Int -> Int -> Text
percentage part whole = Text.pack (showFFloat (Just 1) share " %")
  where
    share = 100 * fromIntegral part / fromIntegral (max 1 whole) :: Double

-- | Where rows or columns lie, from their beginning.
data Line = Line
  { lineStarts :: ![Double]
  -- ^ Of each thing.
  , lineSpans :: ![Span]
  , lineGaps :: ![Double]
  -- ^ The middles of the gaps.
  , lineLength :: !Double
  }

-- | What a group, or a thing, takes of it.
data Span = Span {spanLabel :: !Text, spanStart :: !Double, spanEnd :: !Double}

spanMiddle :: Span -> Double
spanMiddle s = (spanStart s + spanEnd s) / 2

-- | For each group, whether a line stands before it, if cells are at most so wide; none before the first.
--
-- Gaps and whole pixels make cells narrower than that, by not much more than a quarter.
setApart :: Double -> [Group thing] -> [Bool]
setApart cell groups = take (length groups) (False : zipWith between parts (drop 1 parts))
  where
    wholes = NonEmpty.groupBy ((==) `on` groupWhole) groups
    parts = zip (concat (zipWith3 inWhole [0 :: Int ..] wideWholes wholes)) (wide (map size groups))
    inWhole k isWide = map (const (k, isWide)) . toList
    wideWholes = wide (map (sum . fmap size) wholes)
    size = length . groupMembers
    between ((whole, isWideWhole), isWide) ((whole', isWideWhole'), isWide')
      | whole == whole' = isWide && isWide'
      | otherwise = isWideWhole && isWideWhole'
    -- The first and the last one have a line on one side only.
    wide sizes = [k == 0 || k == final || cell * fromIntegral s >= leastApart | (k, s) <- zip [0 ..] sizes]
      where
        final = length sizes - 1

-- | Things one behind the other, each as wide as a cell, with gaps before the groups that are set apart.
arranged :: Double -> Double -> [Bool] -> [Group thing] -> Line
arranged cell gap areApart groups =
  Line
    { lineStarts = concat (zipWith starts offsets groups)
    , lineSpans = [Span (groupLabel g) from (from + width g) | (from, g) <- zip offsets groups]
    , lineGaps = [from - gap / 2 | (from, True) <- zip offsets areApart]
    , lineLength = max cell (sum (map width groups) + sum gaps)
    }
  where
    width g = cell * fromIntegral (length (groupMembers g))
    gaps = [if isApart then gap else 0 | isApart <- areApart]
    offsets = zipWith (+) (scanl (+) 0 (map width groups)) (drop 1 (scanl (+) 0 gaps))
    starts from g = [from + cell * k | (k, _) <- zip [0 ..] (groupMembers g)]

-- | Those labels that have room beside others: the last two first, which are of what surrounds all else, then the
-- others in order.
apart :: [Mark] -> [Mark]
apart marks = map snd (sortOn fst (foldl add [] (sortOn (Down . fst) outer <> inner)))
  where
    (inner, outer) = splitAt (length marks - 2) (zip [0 :: Int ..] marks)
    add kept (k, mark)
      | or [boxesMeet a (widened 1.5 b) | Just a <- [textBox mark], Just b <- map (textBox . snd) kept] = kept
      | otherwise = (k, mark) : kept
