{-# LANGUAGE OverloadedStrings #-}

module Visibility.Draw.DrawingSpec (spec) where

import qualified Data.Text as Text
import Test.Hspec
import Test.QuickCheck hiding (label, within)
import Visibility.Draw.Checks
import Visibility.Draw.Drawing

spec :: Spec
spec = do
  describe "segmentMeetsBox" $ do
    it "is true of what passes through, false of what ends before, runs along or touches" $
      map
        (segmentMeetsBox (Box 0 0 4 2))
        [ (Place (-1) 1, Place 5 1)
        , (Place 1 1, Place 2 1)
        , (Place (-1) 1, Place 0 1)
        , (Place 0 2, Place 4 2)
        , (Place (-1) 1, Place 1 (-1))
        , (Place 3 3, Place 5 1)
        , (Place 3 2.9, Place 5 0.9)
        ]
        `shouldBe` [True, True, False, False, False, False, True]
    it "agrees with many points of the segment" $
      property $ \(Small a) (Small b) (Small c) (Small d) ->
        let place x y = Place (fromIntegral (x :: Int)) (fromIntegral (y :: Int))
            (p, q) = (place a b, place c d)
            within (Place x y) = x > -7 && x < 5 && y > -3 && y < 11
         in p /= q ==> any within (between p q) ==> segmentMeetsBox (Box (-7) (-3) 5 11) (p, q)
  describe "labelCollisions" $ do
    let label name x = Mark name CornerLabel (Label MiddleAnchor (Place x 50) name)
        a = "0.0"
        b = "0.1"
        figure layers =
          Drawing Text.empty Text.empty 100 100 $
            [Layer (Text.pack (show k)) Sparse marks | (k, marks) <- zip [0 :: Int ..] layers]
        region = Mark b Opaque . Region . map (uncurry Place)
    it "finds a label on a label" $
      labelCollisions (figure [[label a 50, label b 60]]) `shouldBe` [LabelOnLabel a b]
    it "finds a label on a line, also if only the width of the stroke reaches it" $ do
      let wall y = [Mark b ThinWall (Polyline [Place 0 y, Place 100 y])]
          Box _ bottom _ _ = textBoxAt CornerLabel MiddleAnchor (Place 50 50) a
      labelCollisions (figure [wall 52, [label a 50]]) `shouldBe` [LabelOnLine a b]
      labelCollisions (figure [wall (bottom - 1), [label a 50]]) `shouldBe` [LabelOnLine a b]
      labelCollisions (figure [wall (bottom - 1.4), [label a 50]]) `shouldBe` []
    it "finds a label on the closing side of an outline and on a dot" $ do
      labelCollisions (figure [[region [(0, 54), (50, 100), (100, 54)]], [label a 50]]) `shouldBe` [LabelOnLine a b]
      labelCollisions (figure [[Mark b VertexDot (Dot (Place 50 54))], [label a 50]]) `shouldBe` [LabelOnDot a b]
    it "lets a label lie inside a region" $
      labelCollisions (figure [[region [(0, 0), (100, 0), (100, 100), (0, 100)]], [label a 50]]) `shouldBe` []
  describe "strayMarks" $
    it "finds texts whose box leaves the canvas" $ do
      let mark x = Mark Text.empty Caption (Label EndAnchor (Place x 50) "caption")
          figure x = Drawing Text.empty Text.empty 100 100 [Layer "l" Sparse [mark x]]
      strayMarks (figure 90) `shouldBe` []
      strayMarks (figure 30) `shouldBe` [mark 30]
      strayMarks (figure 101) `shouldBe` [mark 101]
  where
    between (Place x y) (Place x' y') =
      [Place (x + (x' - x) * t) (y + (y' - y) * t) | k <- [0 .. 100 :: Int], let t = fromIntegral k / 100]
