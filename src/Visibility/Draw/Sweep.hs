{-# LANGUAGE OverloadedStrings #-}

-- | The figure of a state of the topological sweep: both horizon trees, what may be swept next, and what the last step
-- swept and changed.
module Visibility.Draw.Sweep
  ( Moment (..)
  , moments
  , sweepDrawing
  ) where

import Data.List (nub, unfoldr)
import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as Text
import Visibility.Draw.Figure hiding (heading)
import Visibility.Exact.Predicate (Direction (..))
import Visibility.Scene
import Visibility.Sight (rayMeets)
import Visibility.Sweep.Reference
import Visibility.Sweep.Vertex
import Visibility.Sweep.Vertical (Heading (..))

-- | A state of the sweep, how many vertices were swept before it, and the last one of these.
data Moment = Moment
  { momentCount :: !Int
  , momentVertex :: !(Maybe Vertex)
  , momentState :: !State
  }

-- | All states of the sweep of a scene, the first and the last too, lazily.
moments :: Scene -> [Moment]
moments scene = first : unfoldr onwards first
  where
    first = Moment 0 Nothing (start scene)
    onwards (Moment count _ state) = do
      (vertex, after) <- step scene state
      let next = Moment (count + 1) (Just vertex) after
      pure (next, next)

-- | The state in the plane of the scene, given the number of all vertices.
--
-- Layers above those of every such figure: @swept@, the line of the last vertex; @ready@, the lines that may be swept;
-- @right-tree@ and @left-tree@, an edge for each corner, beside the pair that it stands for, on its left as seen along
-- the heading, so that both trees can be told apart; what the last step found is in bold. An edge to a ceiling or to
-- the sky is vertical.
--
-- /Degenerate cases/ a vertex with many corners is one line. /Cost/ O(n log n), besides labels.
sweepDrawing :: Scene -> Int -> Moment -> Drawing
sweepDrawing scene total (Moment count vertex state) =
  planeDrawing scene $
    scenePlane
      { planeTitle = titleAfter "Sweep" scene
      , planeAbout = "The horizon trees of the topological sweep: "
      , planeFacts = facts
      , planeEntries = entries
      , planeSheets = \frame ->
          [ Sheet Crossable "swept" Sparse [lineMark frame SweptLine v | Just v <- [vertex]]
          , Sheet Crossable "ready" Sparse (map (lineMark frame ReadyLine) ready)
          , treeSheet frame "right-tree" (rightTree state)
          , treeSheet frame "left-tree" (leftTree state)
          , polygonSheet scene frame
          , Sheet Ground "flat-corners" Sparse (flatCornerMarks scene frame)
          ]
      }
  where
    ready = readyVertices scene state
    treeSheet frame name tree =
      Sheet Crossable name (densityOf (Map.size (targets tree))) (treeMarks scene frame state tree)
    lineMark frame style v =
      Mark (Text.unwords (map (cornerTag scene) (vertexCorners v))) style $
        Polyline [placeOf scene frame (vertexFirst v), placeOf scene frame (vertexLast v)]
    entries =
      fst (sceneryEntries scene)
        <> [ Entry (lineSwatch [style]) text
           | (style, text, isShown) <-
               [ (RightTreeEdge, "next to the right", True)
               , (LeftTreeEdge, "next to the left", True)
               , (ReadyLine, "may be swept", not (null ready))
               , (SweptLine, "swept just now", vertex /= Nothing)
               , (NewRightTreeEdge, "found just now", not (null (changes state)))
               ]
           , isShown
           ]
    facts =
      ["after " <> Text.pack (show count) <> " of " <> counted total "vertex" "vertices"]
        <> [counted (length ready) "vertex may be swept" "vertices may be swept" | count < total]
        <> map (changeText scene) (take 4 (changes state))
        <> ["and " <> Text.pack (show more) <> " more" | let more = length (changes state) - 4, more > 0]

-- | The tree edges of one tree, named by their corners.
treeMarks :: Scene -> Frame -> State -> Tree -> [Mark]
treeMarks scene frame state tree =
  [ Mark (cornerTag scene p) (style (p `elem` new)) (Polyline (beside (placeOf scene frame p) (end p t)))
  | (p, t) <- Map.toList (targets tree)
  ]
  where
    new = nub [changedCorner change | change <- changes state, changedHeading change == heading tree]
    style isNew = case (heading tree, isNew) of
      (Rightward, False) -> RightTreeEdge
      (Rightward, True) -> NewRightTreeEdge
      (Leftward, False) -> LeftTreeEdge
      (Leftward, True) -> NewLeftTreeEdge
    end p target = case target of
      ToCorner q -> placeOf scene frame q
      ToCeiling s -> placeOfPoint scene frame (rayMeets scene (cornerPoint scene p) (Direction 0 1) s)
      ToSky -> let Place x _ = placeOf scene frame p in Place x (if heading tree == Rightward then high else low)
    Box _ low _ high = frameOutside frame

-- | A line from place to place, a little to the left of where it is.
beside :: Place -> Place -> [Place]
beside (Place ax ay) (Place bx by)
  | long > 0 = [Place (ax - dy) (ay + dx), Place (bx - dy) (by + dx)]
  | otherwise = [Place ax ay, Place bx by]
  where
    long = sqrt ((bx - ax) * (bx - ax) + (by - ay) * (by - ay))
    (dx, dy) = (1.3 * (bx - ax) / long, 1.3 * (by - ay) / long)

-- | One change of a tree, in words.
changeText :: Scene -> Change -> Text
changeText scene change =
  Text.concat
    [ cornerTag scene (changedCorner change)
    , case changedHeading change of Rightward -> " to the right, past "; Leftward -> " to the left, past "
    , cornerTag scene (sweptTo change)
    , case foundBy change of
        BesideSolid -> " beside the solid"
        AlongSide x -> " along the side to " <> cornerTag scene x
        UnderSide s -> " back along side " <> sideOf s
        AlongEdge x -> " along its next pair, to " <> cornerTag scene x
        UnderCeiling (ToCeiling s) -> " back along side " <> sideOf s
        UnderCeiling _ -> " into the sky"
    , maybe "" (overChain . length . passed) (search change)
    , case touching <$> search change of
        Just (ToCorner q) -> ": next is " <> cornerTag scene q
        _ -> ": no pair is left"
    ]
  where
    sideOf = Text.pack . objectText scene . Side
    overChain k = if k == 0 then "" else ", over a chain past " <> counted k "corner" "corners"
