module Visibility.Complex.CanonicalSpec (spec) where

import Data.List (sort)
import Test.Hspec
import Test.QuickCheck
import Visibility.Complex
import Visibility.Complex.Canonical
import Visibility.Scene
import Visibility.Test.Generator

spec :: Spec
spec = describe "canonicalNumbering" $ do
  it "orders everything once, and numbers it from 0" $
    property $ \(AnyScene s) ->
      let complex = complexOf (sampleScene s)
          numbering = canonicalNumbering complex
       in conjoin
            [ sort (orderedVertices numbering) === vertexIds complex
            , sort (orderedEdges numbering) === edgeIds complex
            , sort (orderedEdges numbering <> orderedBuried numbering) === stretchIds complex
            , sort (orderedFaces numbering) === faceIds complex
            , map (vertexNumber numbering) (orderedVertices numbering) === [0 .. length (vertexIds complex) - 1]
            , map (edgeNumber numbering) (orderedEdges numbering) === [0 .. length (edgeIds complex) - 1]
            , map (edgeNumber numbering) (orderedBuried numbering) === [0 .. length (orderedBuried numbering) - 1]
            , map (faceNumber numbering) (orderedFaces numbering) === [0 .. length (faceIds complex) - 1]
            ]
  it "puts the lines that miss everything last" $
    property $ \(ConvexScene s) ->
      let complex = complexOf (sampleScene s)
       in [faceFirst complex f | f <- take 1 (reverse (orderedFaces (canonicalNumbering complex)))] === [Nothing]
  it "puts the upper of two faces first that begin at one vertex and have the same ends" $
    -- A line with a triangle above it on the left, one below it on the right, and a thin wall in it between them: just
    -- after it, lines from sky to sky pass the wall above and below.
    fmap (twins . complexOf . sampleScene) (sampleOf [above, wall, below])
      `shouldBe` Just [[[(0, 0)], [(2, 0)]], [[(3, 0)], [(5, 0)]]]
  where
    above = [(0, 0), (1, 2), (-1, 2)]
    wall = [(2, 0), (3, 0)]
    below = [(5, 0), (4, -2), (6, -2)]
    -- Of the faces from sky to sky that begin on the x axis: where the first corners of their chains lie.
    twins complex = [map (places complex . early) [upperChain complex f, lowerChain complex f] | f <- found]
      where
        found =
          [ f
          | f <- orderedFaces (canonicalNumbering complex)
          , (faceBack complex f, faceFront complex f) == (Sky, Sky)
          , Just v <- [faceFirst complex f]
          , length (vertexEdgesAfter complex v) == 4
          ]
    early (Chain first _) = take 1 first
    places complex es =
      [place | e <- es, (c, place) <- zip (corners (complexScene complex)) sorted, c == edgeCorner complex e]
    sorted = sort (above <> wall <> below)
