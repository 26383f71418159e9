-- | Places for labels where they cover nothing.
--
-- Each label tries positions around its points, near ones first, and takes the best of those where it lies on no line, outline, dot
-- or other label. Farther ones get a thin leader. A label for which there is no such position is left out and returned,
-- so that the figure can say so.
module Visibility.Draw.Labels
  ( -- * What is in the way
    Obstruction (..)
    -- * Labels
  , Request (..)
  , Seat (..)
  , placeLabels
    -- * Labels inside a polygon
  , labelInside
  ) where

import Data.List (find, minimumBy, sortOn)
import Data.Ord (Down (..), comparing)
import Data.Text (Text)
import Visibility.Draw.Drawing

-- | What labels have to avoid.
data Obstruction = Obstruction
  { canvas :: !Box
  , lightLines :: ![(Place, Place)]
  -- ^ Leaders may cross them.
  , walls :: ![(Place, Place)]
  -- ^ Nothing may cross them.
  , taken :: ![Box]
  }

-- | A label to be placed.
data Request = Request
  { requestName :: !Text
  , requestStyle :: !Style
  , requestText :: !Text
  , requestSeats :: ![Seat]
  }

-- | A point that a label may belong to, with the direction (radians) in which it had best lie.
data Seat = Seat !Place !Double

-- | The marks of the labels and of their leaders, and the requests that found no place.
--
-- The labels with the least choice choose first. /Cost/ O(k·s) for k candidate positions and s segments, s counting only those
-- within reach of a label.
placeLabels :: Obstruction -> [Request] -> ([Mark], [Mark], [Request])
placeLabels start requests = go start ordered
  where
    ordered = map snd (sortOn (Down . fst) [(maybe maxBound fst (choose (within start request) request), request) | request <- requests])
    go _ [] = ([], [], [])
    go scenery (request : rest) = case choose (within scenery request) request of
      Nothing -> let (labels, leaders, failed) = go scenery rest in (labels, leaders, request : failed)
      Just (_, Candidate label box leader) ->
        let scenery' =
              scenery
                { taken = box : taken scenery
                , lightLines = maybe id (:) leader (lightLines scenery)
                }
            (labels, leaders, failed) = go scenery' rest
         in (label : labels, leaderMark request leader <> leaders, failed)
    leaderMark _ Nothing = []
    leaderMark request (Just (a, b)) = [Mark (requestName request) Leader (Polyline [a, b])]

-- | A label at a position, its box and its leader.
data Candidate = Candidate !Mark !Box !(Maybe (Place, Place))

-- | The distances that are tried, in pixels.
rings :: [Double]
rings = [0, 3, 6, 10, 15, 21, 28, 36, 46, 58, 72, 90, 110]

-- | The obstructions that a label of this request can meet.
within :: Obstruction -> Request -> Obstruction
within scenery request =
  scenery
    { lightLines = filter (segmentMeetsBox reach) (lightLines scenery)
    , walls = filter (segmentMeetsBox reach) (walls scenery)
    , taken = filter (boxesMeet reach) (taken scenery)
    }
  where
    places = [place | Seat place _ <- requestSeats request]
    far = maximum rings + textWidth (requestStyle request) (requestText request) + 20
    reach =
      Box
        (minimum [x | Place x _ <- places] - far)
        (minimum [y | Place _ y <- places] - far)
        (maximum [x | Place x _ <- places] + far)
        (maximum [y | Place _ y <- places] + far)

-- | The best position on the innermost ring that has one, with the number of the ring.
choose :: Obstruction -> Request -> Maybe (Int, Candidate)
choose _ (Request _ _ _ []) = Nothing
choose scenery request = case find (not . null . snd) (zip [0 ..] (map onRing rings)) of
  Nothing -> Nothing
  Just (k, candidates) -> Just (k, snd (minimumBy (comparing fst) candidates))
  where
    onRing r =
      [ (cost, candidate)
      | Seat place preferred <- requestSeats request
      , k <- [0 .. 31 :: Int]
      , let angle = preferred + fromIntegral (if even k then k else negate (k + 1)) * pi / 32
      , Just (cost, candidate) <- [tried place preferred r angle]
      ]
    tried at@(Place x y) preferred r angle
      | blocked = Nothing
      | otherwise = Just (cost, Candidate (Mark (requestName request) style (Label MiddleAnchor base text)) box leader)
      where
        style = requestStyle request
        text = requestText request
        gap = 4 + r
        (c, s) = (cos angle, sin angle)
        -- The box's own size in that direction keeps the gap the same all around.
        Box l0 b0 r0 t0 = textBoxAt style MiddleAnchor (Place 0 0) text
        (w, h) = (r0 - l0, t0 - b0)
        middle@(Place mx my) = Place (x + gap * c + spread c * w / 2) (y + gap * s + spread s * h / 2)
        spread v = max (-1) (min 1 (1.3 * v))
        base = Place mx (my - (b0 + t0) / 2)
        box = Box (mx - w / 2) (my - h / 2) (mx + w / 2) (my + h / 2)
        Box bl bb br bt = box
        roomy = Box (bl - 1.5) (bb - 1.5) (br + 1.5) (bt + 1.5)
        end = Place (max (bl - 1) (min (br + 1) x)) (max (bb - 1) (min (bt + 1) y))
        leader = if r >= 6 then Just (at, end) else Nothing
        crossed = length (filter (crosses (at, end)) (lightLines scenery))
        blocked =
          not (inside (canvas scenery) roomy)
            || any (segmentMeetsBox roomy) (walls scenery)
            || any (segmentMeetsBox roomy) (lightLines scenery)
            || any (boxesMeet roomy) (taken scenery)
            || any (crosses (at, middle)) (walls scenery)
            || (r >= 6 && any (`segmentMeetsBox` (at, end)) (filter (not . holds at) (taken scenery)))
        turned = abs (angle - preferred)
        cost = turned * 4 + 3 * fromIntegral crossed :: Double
    holds (Place x y) (Box l b r t) = l <= x && x <= r && b <= y && y <= t

inside :: Box -> Box -> Bool
inside (Box l b r t) (Box l' b' r' t') = l <= l' && b <= b' && r' <= r && t' <= t

-- | Do two segments cross at a point inside both?
crosses :: (Place, Place) -> (Place, Place) -> Bool
crosses (p, q) (a, b) = apart p q a b && apart a b p q
  where
    apart u v s t = side u v s * side u v t < 0
    side (Place ux uy) (Place vx vy) (Place sx sy) = (vx - ux) * (sy - uy) - (vy - uy) * (sx - ux)

-- | The first of some texts that fits inside a polygon and on none of the boxes that are taken, next to the polygon's middle.
labelInside :: [Box] -> Text -> Style -> [Text] -> [Place] -> Maybe Mark
labelInside others name style texts outline = case [mark | text <- texts, Just mark <- [fitted text]] of
  mark : _ -> Just mark
  [] -> Nothing
  where
    n = fromIntegral (max 1 (length outline))
    (xs, ys) = ([x | Place x _ <- outline], [y | Place _ y <- outline])
    (cx, cy) = (sum xs / n, sum ys / n)
    edges = zip outline (drop 1 (cycle outline))
    spots =
      sortOn
        (\(x, y) -> (x - cx) ^ (2 :: Int) + (y - cy) ^ (2 :: Int))
        ((cx, cy) : [(minimum xs + (maximum xs - minimum xs) * i / 12, minimum ys + (maximum ys - minimum ys) * j / 12) | i <- [1 .. 11], j <- [1 .. 11]])
    fitted text = case filter fits [(label, box) | (x, y) <- spots, let (label, box) = at text x y] of
      ((label, _) : _) -> Just (Mark name style label)
      [] -> Nothing
    at text x y =
      let Box _ b _ t = textBoxAt style MiddleAnchor (Place 0 0) text
          base = Place x (y - (b + t) / 2)
          Box l' b' r' t' = textBoxAt style MiddleAnchor base text
       in (Label MiddleAnchor base text, Box (l' - 2) (b' - 2) (r' + 2) (t' + 2))
    fits (_, box@(Box l b r t)) =
      odd (length (filter (crossesRay ((l + r) / 2) ((b + t) / 2)) edges))
        && not (any (segmentMeetsBox box) edges)
        && not (any (boxesMeet box) others)
    -- The ray to the right.
    crossesRay x y (Place ax ay, Place bx by) =
      (ay > y) /= (by > y) && x < ax + (y - ay) * (bx - ax) / (by - ay)
