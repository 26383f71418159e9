module Visibility.Sweep.HorizonTreeSpec (spec) where

import Data.List (inits, sortBy)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Point (coordinates)
import Visibility.Exact.Predicate
import Visibility.Ray
import Visibility.Scene
import Visibility.Sweep
import Visibility.Sweep.HorizonTree
import Visibility.Sweep.Topological (Sweep (..))
import Visibility.Sweep.Vertical
import Visibility.Test.Generator

spec :: Spec
spec =
  describe "a horizon tree" $
    modifyMaxSuccess (* 3) $ do
      it "leads, in every state, along the unswept pair of least slope" $
        property $ \(SmallScene s) -> leadsAlongLeast (sampleScene s)
      it "leads, in every state, along the unswept pair of least slope, where polygons touch" $
        forAllShrink (resize 10 touchingScene) shrinkSample $ \s ->
          cornerCount (sampleScene s) <= 24 ==> leadsAlongLeast (sampleScene s)
      it "ends with what each corner sees upward" $
        property $ \(AnyScene s) ->
          let scene = sampleScene s
              end = finish scene
           in conjoin
                [ counterexample (show (heading, c)) $
                    targetOf scene (tree heading end) c `elem` allowed (upward scene heading c)
                | heading <- [minBound ..]
                , c <- corners scene
                ]
  where
    leadsAlongLeast scene =
      conjoin
        [ counterexample (show (length swept, heading, c)) $
            cornerTarget (targetOf scene (tree heading state) c) === nextPair scene all' swept heading c
        | let all' = concatMap (vertexPairs scene) (bruteForce scene)
        , let found = trace scene
        , (state, done) <- zip (start scene : map snd found) (inits (map fst found))
        , let swept = concatMap (vertexPairs scene) done
        , heading <- [minBound ..]
        , c <- corners scene
        ]
    tree Rightward = rightTree
    tree Leftward = leftTree
    cornerTarget (ToCorner c) = Just c
    cornerTarget _ = Nothing
    allowed (Meets (Side side)) = [ToCeiling side]
    allowed (Meets Sky) = [ToSky]
    allowed Solid = [NoTarget]
    -- After the half turn the right-going ray is the one that was the left-going one before it.
    upward scene Rightward c = shoot scene c (opposed (steep scene))
    upward scene Leftward c = shoot scene c (steep scene)
    opposed (Direction x y) = Direction (-x) (-y)
    nextPair scene pairs swept heading c =
      case sortBy (bySlope scene c) (concatMap (from heading c) (filter (`notElem` swept) pairs)) of
        q : _ -> Just q
        [] -> Nothing
    from Rightward c (a, b) = [b | a == c]
    from Leftward c (a, b) = [a | b == c]
    -- Of a wall's two faces on one line, that which has free space on the right of the way comes first.
    bySlope scene from'@(CornerId c) to'@(CornerId p) (CornerId q) = case turn (scenePoints scene) c p q of
      LeftTurn -> LT
      Collinear -> if nextCorner scene from' == to' then LT else GT
      RightTurn -> GT

-- | A direction after -90 degrees, steeper than any line of two corners that is not vertical.
steep :: Scene -> Direction
steep scene = Direction 1 (-1 - height)
  where
    height = maximum (0 : [ceiling (snd (coordinates (cornerAt scene c))) | c <- corners scene])
