-- | Proposals of polygons on a small lattice, aimed at degeneracy. A proposal need not be valid.
module Visibility.Test.Shape
  ( -- * Lattice points
    Corner
  , Box (..)
    -- * Proposals
  , shape
  , roomShape
  , wall
  , squareGrid
  , slimTriangles
  , throughTwo
    -- * Proposals that touch
  , sideBySide
  , atPoints
  , alongSegment
  , wallFrom
    -- * Building blocks
  , hull
  , untangled
  , withFlatCorners
  ) where

import Data.List (nub, sort)
import Test.QuickCheck

-- | A point of the lattice.
type Corner = (Integer, Integer)

-- | The lattice points of a rectangle: lower left corner and extent, both ends in.
data Box = Box !Corner !Integer !Integer

inBox :: Box -> Gen Corner
inBox (Box (x, y) w h) = (,) <$> choose (x, x + w) <*> choose (y, y + h)

-- | Any polygon of at most so many corners in a box.
shape :: Int -> Box -> Gen [Corner]
shape most box =
  frequency
    [ (3, wall box)
    , (3, hull <$> vectorOf (max 3 most) (inBox box))
    , (2, triangle)
    , (2, rectangle box)
    , (2, angle box)
    , (3, choose (4, max 4 most) >>= \k -> untangled . nub <$> vectorOf k (inBox box))
    , (1, rectangle box >>= withFlatCorners)
    , (1, vectorOf 5 (inBox box) >>= withFlatCorners . hull)
    ]
  where
    triangle = vectorOf 3 (inBox box)

-- | A room for the box: a rectangle around it, with or without flat corners, an angle, or any simple polygon that may
-- cut into it.
roomShape :: Box -> Gen [Corner]
roomShape (Box (x, y) w h) =
  frequency
    [ (2, pure around)
    , (1, withFlatCorners around)
    , (1, cutCorner)
    , (2, choose (4, 9) >>= \k -> untangled . nub <$> vectorOf k (inBox wide))
    , (1, hull <$> vectorOf 8 (inBox wide))
    ]
  where
    wide = Box (x - 3, y - 3) (w + 6) (h + 6)
    around = [(x - 1, y - 1), (x + w + 1, y - 1), (x + w + 1, y + h + 1), (x - 1, y + h + 1)]
    cutCorner = do
      (cx, cy) <- inBox (Box (x, y) w h)
      pure [(x - 1, y - 1), (x + w + 2, y - 1), (x + w + 2, cy), (cx, cy), (cx, y + h + 2), (x - 1, y + h + 2)]

-- | A thin wall, often along an axis or a diagonal.
wall :: Box -> Gen [Corner]
wall box = do
  a@(x, y) <- inBox box
  b@(x', y') <- inBox box
  elements [[a, b], [a, (x', y)], [a, (x, y')], [a, (x + y' - y, y')]]

rectangle :: Box -> Gen [Corner]
rectangle box = do
  (x, y) <- inBox box
  (x', y') <- inBox box
  pure [(x, y), (x', y), (x', y'), (x, y')]

-- | An L, in one of its positions: a reflex corner and parallel sides.
angle :: Box -> Gen [Corner]
angle (Box (x0, y0) w h) = do
  (x1, x2) <- ascending (choose (x0, x0 + w))
  (y1, y2) <- ascending (choose (y0, y0 + h))
  flipX <- elements [id, \x -> 2 * x0 + w - x]
  flipY <- elements [id, \y -> 2 * y0 + h - y]
  pure [(flipX x, flipY y) | (x, y) <- [(x0, y0), (x2, y0), (x2, y1), (x1, y1), (x1, y2), (x0, y2)]]
  where
    ascending draw = (\a b -> (min a b, max a b)) <$> draw <*> draw

-- | Some unit squares of a square lattice.
squareGrid :: Gen [[Corner]]
squareGrid = do
  columns <- choose (1, 4)
  rows <- choose (1, 4)
  pitch <- choose (2, 3)
  gaps <- elements [0, 1, 4 :: Int]
  chosen <- mapM (\c -> (,) c <$> choose (0, 9)) [(pitch * i, pitch * j) | i <- [1 .. columns], j <- [1 .. rows]]
  pure [[(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)] | ((x, y), k) <- chosen, k >= gaps]

-- | Long slender triangles, nearly parallel, stacked.
slimTriangles :: Gen [[Corner]]
slimTriangles = choose (2, 7) >>= \count -> mapM slim [1 .. count]
  where
    slim :: Integer -> Gen [Corner]
    slim k = do
      a <- choose (0, 2)
      b <- choose (0, 2)
      left <- choose (0, 20)
      right <- choose (60, 90)
      elements
        [ [(left, 5 * k + a), (right, 5 * k + b), (right, 5 * k + b + 1)]
        , [(right, 5 * k + a), (left, 5 * k + b + 1), (left, 5 * k + b)]
        ]

-- | A polygon with a corner on the line through two given ones, beyond, between or before them.
throughTwo :: Corner -> Corner -> Box -> Gen [Corner]
throughTwo (ax, ay) (bx, by) box = do
  k <- elements [-2, -1, 2, 3]
  others <- choose (1, 3) >>= \n -> vectorOf n (inBox box)
  pure (untangled (nub ((ax + k * dx, ay + k * dy) : others)))
  where
    (dx, dy) = let g = max 1 (gcd (bx - ax) (by - ay)) in ((bx - ax) `quot` g, (by - ay) `quot` g)

-- | The corners of the convex hull, counter-clockwise, without flat ones.
hull :: [Corner] -> [Corner]
hull points = case nub (sort points) of
  (a : b : rest) -> chain (a : b : rest) <> chain (reverse (a : b : rest))
  few -> few
  where
    chain = reverse . drop 1 . foldl add []
    add (b : a : done) c | cross a b c <= 0 = add (a : done) c
    add done c = c : done

cross :: Corner -> Corner -> Corner -> Integer
cross (ax, ay) (bx, by) (cx, cy) = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)

-- | Reverses runs of corners between crossing sides until none cross, which shortens the boundary each time; gives up
-- after some rounds.
untangled :: [Corner] -> [Corner]
untangled = go (40 :: Int)
  where
    go 0 loop = loop
    go k loop = case [(i, j) | i <- [0 .. n - 1], j <- [i + 2 .. n - 1], (i, j) /= (0, n - 1), crossing i j] of
      [] -> loop
      (i, j) : _ ->
        let (start, rest) = splitAt (i + 1) loop
            (middle, end) = splitAt (j - i) rest
         in go (k - 1) (start <> reverse middle <> end)
      where
        n = length loop
        at i = loop !! (i `mod` n)
        crossing i j = meet (at i) (at (i + 1)) (at j) (at (j + 1))
    meet a b c d = opposed (cross a b c) (cross a b d) && opposed (cross c d a) (cross c d b)
    opposed s t = signum s * signum t <= 0

-- | Puts corners on some sides that have lattice points inside.
withFlatCorners :: [Corner] -> Gen [Corner]
withFlatCorners loop = concat <$> mapM side (zip loop (drop 1 (cycle loop)))
  where
    side (a@(ax, ay), (bx, by)) = do
      let g = gcd (bx - ax) (by - ay)
          (dx, dy) = if g == 0 then (0, 0) else ((bx - ax) `quot` g, (by - ay) `quot` g)
      ks <- sublistOf [1 .. min 3 (g - 1)]
      pure (a : [(ax + k * dx, ay + k * dy) | k <- ks])

-- | Some rectangles of a grid without gaps, of different widths and heights: they touch along whole sides or parts of
-- them, or in corners, and may close off pockets.
sideBySide :: Gen [[Corner]]
sideBySide = do
  xs <- cuts
  ys <- cuts
  chance <- choose (3, 9 :: Int)
  chosen <- mapM (\cell -> (,) cell <$> choose (0, 9)) [(c, r) | c <- zip xs (drop 1 xs), r <- zip ys (drop 1 ys)]
  pure [[(x, y), (x', y), (x', y'), (x, y')] | (((x, x'), (y, y')), k) <- chosen, k < chance]
  where
    cuts = choose (2, 4) >>= \n -> scanl (+) 0 <$> vectorOf n (choose (1, 2))

-- | A lattice point of a segment: often an end.
pointOf :: (Corner, Corner) -> Gen Corner
pointOf ((ax, ay), (bx, by)) = do
  let g = gcd (bx - ax) (by - ay)
      (dx, dy) = if g == 0 then (0, 0) else ((bx - ax) `quot` g, (by - ay) `quot` g)
  k <- oneof [pure 0, choose (0, g), choose (min 1 g, max 0 (g - 1))]
  pure (ax + k * dx, ay + k * dy)

-- | A polygon with one or two corners on given segments.
atPoints :: [(Corner, Corner)] -> Box -> Gen [Corner]
atPoints segments box = do
  fixed <- choose (1, 2) >>= \n -> vectorOf n (elements segments >>= pointOf)
  others <- choose (1, 3) >>= \n -> vectorOf n (inBox box)
  frequency [(3, pure (untangled (nub (fixed <> others)))), (2, pure (hull (fixed <> others)))]

-- | A polygon with a side along a part of a segment, or along its line and beyond its ends; or a thin wall there.
alongSegment :: Corner -> Corner -> Box -> Gen [Corner]
alongSegment a@(ax, ay) b@(bx, by) box = do
  let g = gcd (bx - ax) (by - ay)
      (dx, dy) = if g == 0 then (0, 0) else ((bx - ax) `quot` g, (by - ay) `quot` g)
      at k = (ax + k * dx, ay + k * dy)
  i <- choose (-1, g)
  j <- choose (i + 1, g + 2)
  aside <- elements [-1, 1, 2, -2]
  (px, py) <- inBox box
  let along = if a == b then [a] else [at i, at j]
      lifted (x, y) = (x - aside * dy, y + aside * dx)
  elements [along, along <> [(px, py)], along <> map lifted (reverse along)]

-- | A thin wall of up to four corners that begins, and perhaps ends, on given segments.
wallFrom :: [(Corner, Corner)] -> Box -> Gen [Corner]
wallFrom segments box = do
  begin <- elements segments >>= pointOf
  middle <- choose (0, 2) >>= \n -> vectorOf n (inBox box)
  end <- oneof [inBox box, elements segments >>= pointOf]
  pure (begin : middle <> [end])
