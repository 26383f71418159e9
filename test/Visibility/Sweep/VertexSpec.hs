module Visibility.Sweep.VertexSpec (spec) where

import Test.Hspec
import Test.QuickCheck
import Visibility.Scene
import Visibility.Sweep
import Visibility.Sweep.Vertex (vertexLast)

spec :: Spec
spec = describe "a vertex" $ do
  it "has the corners it is made of, if they are two or more" $
    property $ \ks -> fmap vertexCorners (fromCorners (map CornerId ks)) === (if length ks < 2 then Nothing else Just (map CornerId ks))
  it "has a pair less than corners, each beginning where the one before ends" $
    property $ \a b ks -> fmap vertexPairs (fromCorners (map CornerId (a : b : ks))) === Just (zip (map CornerId (a : b : ks)) (map CornerId (b : ks)))
  it "is degenerate from three corners on, and ends at the last" $
    [(isDegenerate v, vertexLast v) | Just v <- map (fromCorners . map CornerId) [[3, 1], [3, 1, 2]]]
      `shouldBe` [(False, CornerId 1), (True, CornerId 2)]
