{-# LANGUAGE OverloadedStrings #-}

-- | The figure of a mesh: the sides with their break points, and on demand the lines that cast them.
module Visibility.Draw.Mesh
  ( CastingLines (..)
  , meshDrawing
  ) where

import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Vector as V
import Visibility.Draw.Figure
import Visibility.Exact.Rounding (rationalText)
import Visibility.Format.Mesh (kindText)
import Visibility.Mesh
import Visibility.Mesh.Span
import Visibility.Scene

-- | Whether the lines are drawn.
data CastingLines = WithLines | WithoutLines
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | The scene drawn to scale, 800 pixels wide, with a mesh.
--
-- Layers, from the bottom: @lines@, for each caster the part of its line from the break point to the farther corner,
-- named by its corners, @2.1 3.0@; @polygons@, named as in output; @breaks@, a short line into free space at each break
-- point, longer and darker at shadow limits, named by side and parameter, @0.0 1/6@; @flat-corners@, dots.
--
-- /Degenerate cases/ break points of a thin wall are drawn on the face that they are on.
--
-- /Cost/ that of the marks, besides labels.
--
-- /Laws/ those of 'planeDrawing'; every break point has exactly one mark, every caster one line.
meshDrawing :: CastingLines -> Mesh -> Drawing
meshDrawing wanted mesh =
  planeDrawing scene $
    scenePlane
      { planeTitle = titleAfter "Break points" scene
      , planeAbout = "Polygons of the scene and the break points of their sides: "
      , planeFacts =
          counted (length points) "break point" "break points"
            : [ counted k one many
              | (kind, one, many) <-
                  [(Just ShadowLimit, "shadow limit", "shadow limits"), (Just Kink, "kink", "kinks")]
              , let k = length (filter (== kind) kinds)
              , k > 0
              ]
      , planeEntries =
          fst (sceneryEntries scene)
            <> [ Entry (lineSwatch [tickStyle kind]) (kindName kind)
               | kind <- [Just ShadowLimit, Just Kink, Nothing]
               , kind `elem` kinds
               ]
            <> [ Entry (lineSwatch [lineStyle kind]) ("line of a " <> kindName (Just kind))
               | wanted == WithLines
               , kind <- [ShadowLimit, Kink]
               , kind `elem` map casterKind (concatMap (breakCasters . snd) points)
               ]
      , planeSheets = \frame ->
          let castingLines = case wanted of
                WithoutLines -> []
                WithLines -> concatMap (lineMarks scene frame . snd) points
              breaks = [breakMark scene frame piece side p | (side, p) <- points, piece <- spanOf side]
           in [ Sheet Crossable "lines" (densityOf (length castingLines)) castingLines
              , polygonSheet scene frame
              , Sheet Solid "breaks" (densityOf (length breaks)) breaks
              , Sheet Ground "flat-corners" Sparse (flatCornerMarks scene frame)
              ]
      }
  where
    scene = meshScene mesh
    points = [(side, point) | side <- sides scene, point <- breaksOn mesh side]
    spans = pieceSpans scene
    spanOf (SideId s) = maybe [] pure (spans V.!? s)
    kinds = map (breakKind . snd) points

-- | A short line from a break point into free space.
breakMark :: Scene -> Frame -> Span -> SideId -> BreakPoint -> Mark
breakMark scene frame piece side point =
  Mark name (tickStyle kind) (Polyline [at 0, at (if kind == Just ShadowLimit then 9 else 5.5)])
  where
    kind = breakKind point
    name = sideTag scene side <> Text.pack (' ' : rationalText (breakParameter point))
    at = besideSide scene (placeOf scene frame) side along
    along = fromRational ((breakParameter point - spanStart piece) / (spanEnd piece - spanStart piece))

-- | The lines of all casters of a break point, shadow limits above.
lineMarks :: Scene -> Frame -> BreakPoint -> [Mark]
lineMarks scene frame point =
  [ Mark (cornerTag scene near <> " " <> cornerTag scene far) (lineStyle kind) $
      Polyline [placeOfPoint scene frame (breakAt point), placeOf scene frame far]
  | Caster kind near far <- reverse (breakCasters point)
  ]

tickStyle :: Maybe Kind -> Style
tickStyle kind = case kind of
  Just ShadowLimit -> ShadowLimitTick
  Just Kink -> KinkTick
  Nothing -> EqualPartsTick

lineStyle :: Kind -> Style
lineStyle ShadowLimit = ShadowLine
lineStyle Kink = KinkLine

kindName :: Maybe Kind -> Text
kindName = Text.replace "-" " " . Text.pack . kindText
