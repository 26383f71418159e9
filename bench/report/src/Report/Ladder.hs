-- | Scenes that get harder step by step.
module Report.Ladder
  ( Ladder (..)
  , ladders
  ) where

import Report.Paper (Plan (..))
import Visibility.Exact.Point (Point (..))
import Visibility.Law (broken)
import Visibility.Scene.Family
import Visibility.Scene.Raw

-- | A family by a growing number.
data Ladder = Ladder
  { ladderName :: !String
  , ladderMeaning :: !String
  , ladderScene :: Int -> RawScene
  , ladderRungs :: ![Int]
  }

ladders :: Plan -> [Ladder]
ladders plan =
  [ Ladder "nearly collinear" "three triangles with tips on a line, but for 2^-k" nearlyCollinear steps
  , Ladder "slit" "two walls end to end with a slit of 2^-k between them, and a triangle on either side" slit steps
  , Ladder "needles" "twelve slanted triangles, about a unit long and 2^-k wide" needles steps
  , Ladder "far away" "ten quadrilaterals with corners at thirds, and a triangle at a distance of 4000 · 2^k" far steps
  , Ladder
      "touching"
      "four triangles of size 2^k that touch in (1/7, 1/11), and a fifth that nearly touches one of them along a side"
      touching
      steps
  , Ladder
      "moved"
      "nine quadrilaterals with corners at thirds, many of them in line, all moved by 2^k along both axes"
      (blocksAt . moved)
      steps
  , Ladder "moved apart" "the same nine moved by 2^k, and a triangle that stays" (blocksApart . moved) steps
  , Ladder "scaled" "the same nine, 2^(16 k) times as large" (blocksAt . scaled) steps
  , Ladder "kettner" "k tiny triangles near (1/2, 1/2), and two others" (named Kettner . max 1) (filter (> 0) steps)
  ]
  where
    steps = hardSteps plan
    moved k (Point x y) = Point (x + 2 ^ k) (y + 2 ^ k)
    scaled k (Point x y) = Point (2 ^ (16 * k) * x) (2 ^ (16 * k) * y)

scene' :: [[Point]] -> RawScene
scene' = RawScene Nothing Nothing . map rawPolygon

nearlyCollinear, slit, needles, far, touching :: Int -> RawScene
nearlyCollinear k = scene' [at 0 0, at (1 / 3) (1 / 3 + tiny k), at (5 / 7) (5 / 7)]
  where
    at x y = [Point x y, Point (x + 1 / 11) (y - 1 / 5), Point (x + 1 / 7) (y - 1 / 7)]
slit k =
  scene'
    [ [Point 0 (-1), Point 0 0]
    , [Point 0 (tiny k), Point 0 (2 + tiny k)]
    , [Point (-3) (-1 / 3), Point (-2) (-1 / 7), Point (-2) (1 / 3)]
    , [Point 2 (-1 / 3), Point 3 0, Point 2 (1 / 7)]
    ]
needles k =
  scene'
    [ [Point (j / 7) base, Point (1 + j / 11) (base + 1 / 3 + tiny k / 3), Point (j / 7) (base + tiny k)]
    | j <- map fromInteger [0 .. 11]
    , let base = j / 3 + j * tiny k * 2
    ]
far k =
  RawScene Nothing Nothing $
    [p {rawCorners = [Point (x / 3) (y / 3) | Point x y <- rawCorners p]} | p <- rawPolygons (named Random 10)]
      <> [rawPolygon [Point (-d) (-d), Point (-d) (1 - d), Point (-d - 1) (-d)]]
  where
    d = 4000 * 2 ^ k
touching k =
  scene'
    [ map moved corners'
    | corners' <-
        [ [(0, 0), (s, s / 7), (s, s / 2)]
        , [(0, 0), (-s / 7, s), (-s / 2, s)]
        , [(0, 0), (-s, -s / 7), (-s, -s / 2)]
        , [(0, 0), (s / 7, -s), (s / 2, -s)]
        , [(s / 3, s / 6 + 1 / 97), (s / 2, s / 4 + 1 / 97), (s / 3, s / 3)]
        ]
    ]
  where
    s = 4 + 2 ^ k / 3
    moved (x, y) = Point (x + 1 / 7) (y + 1 / 11)

-- The blocks somewhere else; and with a triangle that stays.
blocksAt, blocksApart :: (Point -> Point) -> RawScene
blocksAt place = scene' (map (map place) blocks)
blocksApart place = scene' ([Point (-1) (-1), Point (-1 / 3) (-1), Point (-1) (-1 / 3)] : map (map place) blocks)

-- Three columns of three quadrilaterals. Corners of a column, of a row and of a diagonal are in line.
blocks :: [[Point]]
blocks =
  [ [Point x y, Point (x + 4 / 3) (y + lean), Point (x + 1) (y + 4 / 3), Point x (y + 1)]
  | (x, lean) <- zip [0, 2, 4] [0, 1 / 3, 0]
  , y <- [0, 2, 4]
  ]

tiny :: Int -> Rational
tiny k = 1 / 2 ^ k

named :: Family -> Int -> RawScene
named kind n = case size n of
  Just k -> family kind k (Seed 1)
  Nothing -> broken "a scene of the report has a size" (show (kind, n))
