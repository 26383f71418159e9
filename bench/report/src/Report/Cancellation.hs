{-# LANGUAGE OverloadedStrings #-}

-- | The report's third section: two sides that move apart.
module Report.Cancellation
  ( cancellationSection
  ) where

import Control.Monad (forM)
import Data.List (isPrefixOf)
import Data.String (IsString)
import qualified Data.Text as Text
import Report.Factors (Method (..), looks, methods)
import Report.Measure (ended)
import Report.Paper
import Report.Scenes
import Estimate.Matrix
import Visibility.Exact.Point (Point (..))
import Visibility.FormFactor
import Report.Plot
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Sweep

data Row = Row !String !Int !String !Double !Double

cancellationSection :: Plan -> IO Section
cancellationSection plan = do
  rows <- fmap concat . forM [(kind, k) | kind <- ["free", "occluded"], k <- [0 .. 12]] $ \(kind, k) -> do
    progress plan ("cancellation: " <> kind <> ", 1e" <> show k)
    found <- saved (rawCase (folder plan) (kind <> "-1e" <> show k) (facing kind k))
    let scene = caseScene found
        truth = truthOf scene (formFactors scene (measures scene (vertices scene)))
        entry =
          [ (place, x)
          | (place@(row, column), x) <- truthEntries truth
          , row `elem` ofWall scene 0
          , column `elem` ofWall scene 1
          ]
    concat
      <$> forM chosen (\m -> do
        matrix <- ended (methodMatrix m scene)
        pure
          [Row kind k (named m) x (errorOf truth made place) | Just made <- [matrix], (place, x) <- take 1 entry])
  pure
    Section
      { sectionTitle = "Cancellation: two unit sides move apart"
      , sectionText =
          [ "Two unit walls face each other at the distance d = 10^k. Their form factor, about 1/(2d), is a \
            \difference of lengths near d: √(d² + 1) − d. Doubles lose twice as many digits as d has; in the occluded \
            \case a third wall, at a third of the way and 2/7 high, hides some of it. The exact sums are rounded \
            \correctly at every distance, and so are the nearest Doubles, which take two Doubles or, where those do \
            \not suffice, the roots themselves."
          , "The methods are those of the form factors above; a number behind a name is its parameter, the largest \
            \there: points on each side, directions, lines."
          ]
      , sectionTables =
          [ Table
              ( "Relative error of the form factor between the two walls, "
                  <> kind
                  <> ", at each distance in lengths of a wall. "
                  <> ofOne
              )
              ("distance" : "form factor" : map named chosen)
              [ ("1e" <> show k)
                  : take 1 [sig x | Row _ _ _ x _ <- here]
                    <> [concat (take 1 [sig e | Row _ _ m' _ e <- here, m' == named m]) | m <- chosen]
              | k <- [0 .. 12 :: Int]
              , let here = [row | row@(Row kind' k' _ _ _) <- rows, kind' == kind, k' == k]
              ]
          | kind <- ["free", "occluded"]
          ]
      , sectionFigures =
          [ Figure ("cancellation-" <> kind <> ".svg") (plot (Text.pack kind) mine) (caption kind)
          | kind <- ["free", "occluded"]
          , let mine = [r | r@(Row kind' _ _ _ _) <- rows, kind' == kind]
          ]
      , sectionData =
          [ ( "cancellation.csv"
            , ["case", "log10_distance", "method", "form_factor", "relative_error"]
                : [[kind, show k, m, show x, show e] | Row kind k m x e <- rows]
            )
          ]
      }
  where
    chosen = concatMap (take 1 . reverse . alike) distinct
    alike name = [m | m <- methods plan, methodName m == name]
    distinct = foldr (\m names -> if m `elem` names then names else m : names) [] (map methodName (methods plan))
    named m = methodName m <> maybe "" ((" " <>) . show) (methodParameter m)
    ofWall scene p = [r | (r, SideName (Obstacle q) _) <- zip [0 ..] (statedSides scene), q == p]
    caption kind =
      "Two unit walls at growing distance, "
        <> Text.pack kind
        <> ": relative error of the form factor between them against the distance, both logarithmic, one line for each \
           \method. Where lines lie on each other, the last in the legend is on top: all Double on the string rule in \
           \Double, the proved results on the exact ones, random lines on all that find nothing. The plain string rule \
           \in Doubles loses two digits with each decade of distance until nothing is right; the exact and the proved \
           \results stay at the rounding of a Double. "
        <> compensated kind
        <> " Directions and lines meet the far wall more and more seldom, and then never; "
        <> integral kind
        <> " "
        <> ofOne
        <> " An error of 0 is not drawn."
    ofOne :: IsString a => a
    ofOne = "An error of 1 means that the method found nothing."
    integral kind
      | kind == "free" = "points see all of it, and from far away each sees nearly the same, so their sum gets better."
      | otherwise = "points see the edge of the shadow, which falls between them at any distance."
    compensated kind
      | kind == "free" = "So do the compensated ones, which lie on top of both: here all corners are Doubles."
      | otherwise =
          "The compensated ones do not: the corners of the third wall are no Doubles, and compensation does not bring \
          \back what is lost by rounding them."

errorOf :: Truth -> Matrix -> (Int, Int) -> Double
errorOf truth matrix place = largestRelative (errorsOf (only place truth) matrix)

facing :: String -> Int -> RawScene
facing kind k =
  RawScene Nothing Nothing $
    [rawWall [Point 0 0, Point 0 1], rawWall [Point d 0, Point d 1]]
      <> [rawWall [Point (d / 3) 0, Point (d / 3) (2 / 7)] | kind == "occluded"]
  where
    d = 10 ^ k

plot :: Text.Text -> [Row] -> Plot
plot kind rows =
  Plot
    { plotTitle = "Two unit walls move apart, " <> kind
    , plotDescription = "Relative error of one form factor against the distance, by method, both axes logarithmic."
    , plotAcross = Decades "distance, in lengths of a wall"
    , plotUpwards = Decades "relative error"
    , plotSeries =
        [ Series (Text.pack name) style marker Joined [(10 ^^ k, e) | Row _ k m _ e <- rows, m == name]
        | name <- names
        , (family', (style, marker)) <- looks
        , family' `isPrefixOf` name
        ]
    }
  where
    names = [m | Row _ 0 m _ _ <- rows]
