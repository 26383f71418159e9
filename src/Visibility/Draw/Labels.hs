-- | Places for labels where they cover nothing.
--
-- Each label tries positions around its points, near ones first, and takes the best of those where it lies on no line,
-- outline, dot or other label. Farther ones get a thin leader. A label for which there is no such position is left out
-- and returned, so that the figure can say so.
module Visibility.Draw.Labels
  ( -- * What is in the way
    Obstruction (..)
  , Line (..)
    -- * Labels
  , Request (..)
  , Seat (..)
  , placeLabels
    -- * Labels inside a polygon
  , labelInside
  ) where

import Data.List (find, minimumBy, sortOn)
import Data.Maybe (listToMaybe)
import Data.Ord (Down (..), comparing)
import Data.Text (Text)
import Visibility.Draw.Drawing

-- | What labels have to avoid.
data Obstruction = Obstruction
  { canvas :: !Box
  , lightLines :: ![Line]
  -- ^ Leaders may cross them.
  , walls :: ![Line]
  -- ^ Nothing may cross them.
  , taken :: ![Box]
  , clearance :: !Double
  -- ^ How far labels stay from all that, in pixels.
  }

-- | A segment and half the width of its stroke.
data Line = Line !Double !(Place, Place)

-- | A label to be placed.
data Request = Request
  { requestName :: !Text
  , requestStyle :: !Style
  , requestText :: !Text
  , requestSeats :: ![Seat]
  }

-- | A point that a label may belong to, the direction (radians) in which it had best lie, and how far it may turn away
-- from that.
data Seat = Seat !Place !Double !Double

-- | The marks of the labels and of their leaders, and the requests that found no place.
--
-- The labels with the least choice choose first. /Cost/ O(k·s) for k candidate positions and s segments, s counting
-- only those within reach of a label.
placeLabels :: Obstruction -> [Request] -> ([Mark], [Mark], [Request])
placeLabels start requests = go start ordered
  where
    ordered = map snd (sortOn (Down . fst) [(maybe maxBound fst (choose start request), request) | request <- requests])
    go _ [] = ([], [], [])
    go scenery (request : rest) = case choose scenery request of
      Nothing -> let (labels, leaders, failed) = go scenery rest in (labels, leaders, request : failed)
      Just (_, Candidate label box leader) ->
        let scenery' =
              scenery
                { taken = box : taken scenery
                , lightLines = maybe id ((:) . Line 0.4) leader (lightLines scenery)
                }
            (labels, leaders, failed) = go scenery' rest
            thin = [Mark (requestName request) Leader (Polyline [a, b]) | Just (a, b) <- [leader]]
         in (label : labels, thin <> leaders, failed)

-- | A label at a position, its box and its leader.
data Candidate = Candidate !Mark !Box !(Maybe (Place, Place))

-- | The distances that are tried, in pixels.
rings :: [Double]
rings = [0, 3, 6, 10, 15, 21, 28, 36, 46, 58, 72, 90, 110]

-- | The obstructions that a label can meet that is at most so far from a place.
within :: Double -> Request -> Place -> Obstruction -> Obstruction
within r request (Place x y) scenery =
  scenery
    { lightLines = filter (meets reach) (lightLines scenery)
    , walls = filter (meets reach) (walls scenery)
    , taken = filter (boxesMeet reach) (taken scenery)
    }
  where
    size = textSize (requestStyle request)
    (across, up) = (r + textWidth (requestStyle request) (requestText request) + 20, r + size + 20)
    reach = Box (x - across) (y - up) (x + across) (y + up)

-- | The best position on the innermost ring that has one, with the number of the ring.
choose :: Obstruction -> Request -> Maybe (Int, Candidate)
choose scenery request =
  fmap (snd . minimumBy (comparing fst)) <$> find (not . null . snd) (zip [0 ..] (concatMap ringsTogether [near, far]))
  where
    (near, far) = span (<= 10) rings
    -- What is around a seat is looked up once for several rings.
    ringsTogether radii =
      let seats = [(seat, within (maximum radii) request place scenery) | seat@(Seat place _ _) <- requestSeats request]
       in map (onRing seats) radii
    onRing seats r =
      [ (cost, candidate)
      | (Seat place preferred most, around) <- seats
      , turned <- takeWhile ((<= most + 1e-9) . abs) turns
      , Just (cost, candidate) <- [tried around place r (preferred + turned) (abs turned)]
      ]
    turns = [fromIntegral (if even k then k else negate (k + 1)) * pi / 32 | k <- [0 .. 31 :: Int]]
    tried around at@(Place x y) r angle turned
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
        roomy = widened (clearance around) box
        end = Place (max (bl - 1) (min (br + 1) x)) (max (bb - 1) (min (bt + 1) y))
        leader = if r >= 6 then Just (at, end) else Nothing
        -- A leader that runs along a line is not seen.
        halfway = let Place ex ey = end in widened 2.5 (Box ((x + ex) / 2) ((y + ey) / 2) ((x + ex) / 2) ((y + ey) / 2))
        leaderOver = or [segmentMeetsBox box' (at, end) | box' <- map (widened 0.8) (taken around), not (holds at box')]
        leaderHidden = any (meets halfway) (walls around)
        crossed = length [() | Line _ segment <- lightLines around, crosses (at, end) segment]
        blocked =
          not (inside (canvas around) roomy)
            || any (meets roomy) (walls around)
            || any (meets roomy) (lightLines around)
            || any (boxesMeet roomy) (taken around)
            || or [crosses (at, middle) segment | Line _ segment <- walls around]
            || (r >= 6 && (leaderHidden || leaderOver))
        -- Next to other things it is less clear what a label belongs to.
        wide = widened 7 box
        neighbours = having (meets wide) (lightLines around) + having (boxesMeet wide) (taken around)
        overlaid = if r >= 6 then having (meets halfway) (lightLines around) else 0
        cost = turned * 4 + fromIntegral (3 * crossed + neighbours + 3 * overlaid) :: Double
    having test = length . filter test
    holds (Place x y) (Box l b r t) = l <= x && x <= r && b <= y && y <= t

meets :: Box -> Line -> Bool
meets box (Line around segment) = segmentMeetsBox (widened around box) segment

inside :: Box -> Box -> Bool
inside (Box l b r t) (Box l' b' r' t') = l <= l' && b <= b' && r' <= r && t' <= t

-- | Do two segments cross at a point inside both?
crosses :: (Place, Place) -> (Place, Place) -> Bool
crosses (p, q) (a, b) = apart p q a b && apart a b p q
  where
    apart u v s t = side u v s * side u v t < 0
    side (Place ux uy) (Place vx vy) (Place sx sy) = (vx - ux) * (sy - uy) - (vy - uy) * (sx - ux)

-- | The first of some texts that fits inside a polygon and on none of some lines, next to the polygon's middle.
labelInside :: [Line] -> Text -> Style -> [Text] -> [Place] -> Maybe Mark
labelInside inTheWay name style texts outline =
  listToMaybe [Mark name style label | text <- texts, (x, y) <- spots, let (label, box) = at text x y, fits box]
  where
    n = fromIntegral (max 1 (length outline))
    (xs, ys) = ([x | Place x _ <- outline], [y | Place _ y <- outline])
    (cx, cy) = (sum xs / n, sum ys / n)
    edges = zip outline (drop 1 (cycle outline))
    spots =
      sortOn
        (\(x, y) -> (x - cx) ^ (2 :: Int) + (y - cy) ^ (2 :: Int))
        ((cx, cy) : [(part i xs, part j ys) | i <- [1 .. 11], j <- [1 .. 11]])
    part i values = minimum values + (maximum values - minimum values) * i / 12
    at text x y =
      let Box _ b _ t = textBoxAt style MiddleAnchor (Place 0 0) text
          base = Place x (y - (b + t) / 2)
       in (Label MiddleAnchor base text, widened 3 (textBoxAt style MiddleAnchor base text))
    fits box@(Box l b r t) =
      odd (length (filter (crossesRay ((l + r) / 2) ((b + t) / 2)) edges))
        && not (any (segmentMeetsBox box) edges)
        && not (any (meets box) inTheWay)
    -- The ray to the right.
    crossesRay x y (Place ax ay, Place bx by) =
      (ay > y) /= (by > y) && x < ax + (y - ay) * (bx - ax) / (by - ay)
