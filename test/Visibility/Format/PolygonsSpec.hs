{-# LANGUAGE OverloadedStrings #-}

module Visibility.Format.PolygonsSpec (spec) where

import Control.Monad (forM_)
import Data.Aeson (Value, eitherDecode, withObject, (.:), (.:?))
import Data.Aeson.Types (Parser, parseEither)
import Data.ByteString.Builder (toLazyByteString)
import qualified Data.ByteString.Lazy as Lazy
import Data.List (sort)
import Data.Maybe (isJust, isNothing)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck
import Visibility.Complex
import Visibility.Complex.Polygons
import Visibility.Format.Complex
import Visibility.Format.File (readSceneFile)
import Visibility.Sweep
import Visibility.Test.Generator

spec :: Spec
spec = describe "polygonDocument" $ do
  modifyMaxSuccess (* 3) $
    it "is the same to the last byte for both sweeps" $
      property $ \(AnyScene s) -> sameForBoth s
  modifyMaxSuccess (* 3) $
    it "is the same to the last byte for both sweeps in convex scenes" $
      property $ \(ConvexScene s) -> sameForBoth s
  it "is the same to the last byte for both sweeps where polygons touch" $
    property $ \(TouchingScene s) -> sameForBoth s
  it "has each face of sides in one face" $
    property $ \(AnyScene s) ->
      let complex = complexOf (sampleScene s)
       in reading (document complex) $ \found ->
            sort (concatMap faceParts (facesRead found)) === [0 .. length (faceIds complex) - 1]
  it "has vertices, edges and chains together or not at all" $
    property $ \(AnyScene s) ->
      reading (document (complexOf (sampleScene s))) $ \found ->
        map (isJust . faceChains) (facesRead found) === map (const (isJust (edgesRead found))) (facesRead found)
  modifyMaxSuccess (* 5) $
    it "has chains of edges that lead from the first vertex to the last, by turns that are told" $
      property $ \(ConvexScene s) ->
        reading (document (complexOf (sampleScene s))) $ \found ->
          conjoin
            [ counterexample (show (k, chain)) (leads edges (faceEnds face) chain)
            | Just edges <- [edgesRead found]
            , (k, face) <- zip [0 :: Int ..] (facesRead found)
            , Just (upper, lower) <- [faceChains face]
            , chain <- [upper, lower]
            ]
  it "has each edge in the chains of the faces that it has above and below, on the flank that the turns tell" $
    property $ \(ConvexScene s) ->
      reading (document (complexOf (sampleScene s))) $ \found ->
        conjoin
          [ sort (concat (zipWith (bounding edges) [0 ..] bounded))
              === sort [entry | entry@(_, f, _) <- concat (zipWith beside [0 ..] edges), f < length bounded]
          | Just edges <- [edgesRead found]
          , let bounded = takeWhile (isJust . fst . faceEnds) (facesRead found)
          ]
  forM_
    [ ("two squares", "two-squares")
    , ("a room, which has faces only", "l-room")
    , ("thin walls on one line, and a triangle", "walls-in-a-line")
    , ("a triangle that is alone", "alone")
    ]
    $ \(what, name) ->
      it ("tells all of " <> what) $ do
        scene <- readSceneFile ("test/golden/complex/" <> name <> ".scene.json") >>= either (fail . show) pure
        expected <- Lazy.readFile ("test/golden/complex/" <> name <> ".polygons.json")
        document (complexOf scene) `shouldBe` expected
  where
    document = toLazyByteString . polygonDocument . polygonComplex
    sameForBoth s =
      let scene = sampleScene s
       in document (build scene (straightVertices scene)) === document (build scene (vertices scene))
    beside e edge = [(e, f, True) | f <- aboveIt edge] <> [(e, f, False) | f <- belowIt edge]
    reading bytes check = either (`counterexample` False) check (eitherDecode bytes >>= parseEither documentRead)

-- | What a document has in its lists.
data Document = Document
  { edgesRead :: Maybe [EdgeRead]
  , facesRead :: [FaceRead]
  }

data EdgeRead = EdgeRead
  { edgeEnds :: (Maybe Int, Maybe Int)
  , turnsTold :: Int
  , aboveIt :: [Int]
  , belowIt :: [Int]
  }

data FaceRead = FaceRead
  { faceParts :: [Int]
  , faceEnds :: (Maybe Int, Maybe Int)
  , faceChains :: Maybe ([Int], [Int])
  }

documentRead :: Value -> Parser Document
documentRead = withObject "document" $ \o ->
  Document <$> (o .:? "edges" >>= traverse (mapM edge)) <*> (o .: "faces" >>= mapM face)
  where
    edge = withObject "edge" $ \o ->
      EdgeRead <$> ((,) <$> o .: "from" <*> o .: "to") <*> o .: "turns" <*> o .: "above" <*> o .: "below"
    face = withObject "face" $ \o -> do
      upper <- o .:? "upper"
      lower <- o .:? "lower"
      FaceRead <$> o .: "parts" <*> ((,) <$> o .:? "first" <*> o .:? "last") <*> pure ((,) <$> upper <*> lower)

-- | Does a chain begin at the first vertex of its face, go on from edge to edge, and end at the last vertex? A closed
-- one comes back to where it began.
leads :: [EdgeRead] -> (Maybe Int, Maybe Int) -> [Int] -> Bool
leads edges (first, end) chain = map (fst . edgeEnds) along <> [end'] == [first'] <> map (snd . edgeEnds) along
  where
    along = map (edges !!) chain
    closing = foldr (const . fst . edgeEnds) Nothing along
    (first', end') = if isNothing first then (closing, closing) else (first, end)

-- | The edges that bound a face, by number, with the face and whether it lies above the edge where the edge begins. An
-- edge is read backwards if those before it have gone on over the end of the half turn an odd number of times.
bounding :: [EdgeRead] -> Int -> FaceRead -> [(Int, Int, Bool)]
bounding edges f face = concat [along False upper <> along True lower | Just (upper, lower) <- [faceChains face]]
  where
    along isAbove chain =
      [(e, f, isAbove /= odd turns) | (e, turns) <- zip chain (scanl (+) 0 (map (turnsTold . (edges !!)) chain))]
