module Visibility.Sweep.VertexSpec (spec) where

import Test.Hspec
import Test.QuickCheck
import Visibility.Scene
import Visibility.Sweep
import Visibility.Sweep.Vertex (vertexLast)

spec :: Spec
spec = describe "a vertex" $ do
  it "has the corners it is made of, if they are two or more" $
    property $ \ks ->
      let line = map CornerId ks
       in fmap vertexCorners (fromCorners line) === (if length ks < 2 then Nothing else Just line)
  it "has a pair less than corners, each beginning where the one before ends" $
    property $ \a b ks ->
      let line = map CornerId (a : b : ks)
       in fmap vertexPairs (fromCorners line) === Just (zip line (drop 1 line))
  it "is degenerate from three corners on, and ends at the last" $
    [(isDegenerate v, vertexLast v) | Just v <- map (fromCorners . map CornerId) [[3, 1], [3, 1, 2]]]
      `shouldBe` [(False, CornerId 1), (True, CornerId 2)]
