-- | Light that comes straight from the sources, or after one reflection: enough to try figures with.
module Visibility.Draw.DirectLight
  ( directLight
  , wholeSides
  , directFigure
  , divided
  , undivided
  ) where

import qualified Data.Map.Strict as Map
import qualified Data.Text as Text
import Visibility.Draw.Radiosity
import Visibility.Draw.Values
import Visibility.Exact.Point
import Visibility.FormFactor
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Sweep

-- | An element for each side that is not all covered, with B = E + ρ Σ F·E.
directLight :: Scene -> [LitElement]
directLight scene =
  [ element {litValue = given side + reflected side * Map.findWithDefault 0 side arriving}
  | element <- wholeSides scene
  , let side = litSide element
  , Map.member side materials
  ]
  where
    materials = Map.fromList [(sideName scene s, sideMaterial scene s) | s <- sides scene]
    given side = maybe 0 (fromRational . emission) (Map.lookup side materials)
    reflected side = maybe 0 (fromRational . reflectivity) (Map.lookup side materials)
    arriving =
      Map.fromList
        [ (rowFrom row, sum [f * given to | (TheSide to, f) <- rowFactors row])
        | row <- nearestFactors scene (measures scene (vertices scene))
        ]

-- | The figure of direct light.
directFigure :: Scaling -> [SideName] -> [LitElement] -> RadiosityFigure
directFigure = RadiosityFigure (Text.pack "direct light B")

-- | An element for each side of the file, covered or not, without light.
wholeSides :: Scene -> [LitElement]
wholeSides scene =
  [ LitElement (SideName (polygonId polygon) k) 0 1 ends 0
  | polygon <- scenePolygons scene
  , (k, ends) <- zip [0 ..] (around (polygonForm polygon) (polygonPoints polygon))
  ]
  where
    around Ring points = zip points (drop 1 points <> take 1 points)
    around Polyline points = let forth = zip points (drop 1 points) in forth <> reverse [(q, p) | (p, q) <- forth]

-- | The scene with each side divided in so many equal parts by flat corners.
divided :: Int -> RawScene -> RawScene
divided n raw = raw {rawEnclosure = finer <$> rawEnclosure raw, rawPolygons = map finer (rawPolygons raw)}
  where
    finer polygon =
      polygon
        { rawCorners = case rawForm polygon of
            Ring -> concatMap parts (zip points (drop 1 points <> take 1 points))
            Polyline -> concatMap parts (zip points (drop 1 points)) <> drop (length points - 1) points
        , rawSides = Map.fromList [(k * n + i, m) | (k, m) <- Map.toList (rawSides polygon), i <- [0 .. n - 1]]
        }
      where
        points = rawCorners polygon
    parts (Point x y, Point x' y') =
      [Point (x + t * (x' - x)) (y + t * (y' - y)) | i <- [0 .. n - 1], let t = fromIntegral i / fromIntegral n]

-- | An element of a scene whose sides are divided in so many parts, as an element of the scene that it was.
undivided :: Int -> LitElement -> LitElement
undivided n element =
  element
    { litSide = SideName polygon (k `div` n)
    , litFrom = fromIntegral (k `mod` n) / fromIntegral n
    , litTo = fromIntegral (k `mod` n + 1) / fromIntegral n
    }
  where
    SideName polygon k = litSide element
