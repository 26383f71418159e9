module Visibility.Draw.BandSpec (spec) where

import Data.Foldable (for_)
import qualified Data.Map.Strict as Map
import Test.Hspec
import Test.QuickCheck hiding (within)
import Visibility.Draw.Band
import Visibility.Draw.Drawing
import Visibility.Draw.Gallery
import Visibility.Draw.Scenery
import Visibility.Exact.Point
import Visibility.Scene
import Visibility.Scene.Raw hiding (Polyline)
import qualified Visibility.Scene.Raw as Raw
import Visibility.Scene.Validate (validate)
import Visibility.Test.Generator

spec :: Spec
spec = do
  describe "every scene in scenes/" $
    withGallery $ \name scene ->
      it (name <> ": no strip and no ray crosses into the solid") $ intruders scene `shouldBe` []
  describe "of scenes with parts that differ by more than Doubles hold" $
    for_ extremeScenes $ \(name, _, raw) ->
      it (name <> ": no strip and no ray crosses into the solid") $
        withValid raw $ \scene -> intruders scene `shouldBe` []
  describe "of any scene" $ do
    it "no strip and no ray crosses into the solid" $
      property $ \(AnyScene s) -> intruders (sampleScene s) === []
    it "no strip and no ray does where polygons touch" $
      property $ \(TouchingScene s) -> intruders (sampleScene s) === []
    it "a part of a strip lies in it, and the parts are as large as the whole" $
      property $ \(AnyScene s) ->
        forAll (choose (0, 1)) $ \t ->
          let scene = sampleScene s
              defect strip = area (stripPart strip 0 t) + area (stripPart strip t 1) - area (stripOutline strip)
           in [side | (side, strip) <- Map.toList (stripsOf scene (placed scene) 8), abs (defect strip) > 1e-6] === []
  describe "a strip" $ do
    it "goes on to the bisectors around a square" $
      outlines 8 [solid [(0, 0), (1, 0), (1, 1), (0, 1)]] `shouldBe` replicate 4 (8 * (700 + 8))
    it "is one on either face of a thin wall" $
      outlines 8 [rawWall [Point 0 0, Point 1 0]] `shouldBe` replicate 2 (8 * 700)
    it "is cut along the bisectors in the corners of a room" $
      withValid (RawScene Nothing (Just (solid [(0, 0), (1, 0), (1, 1), (0, 1)])) []) $ \scene ->
        areas 8 scene `shouldBe` replicate 4 (8 * (700 - 8))
    it "goes half of the way where there is little room" $ do
      -- A hundredth of the whole, and so seven pixels, between the two.
      let left = [(0, 0), (99 / 200, 0), (99 / 200, 1), (0, 1)]
          right = [(101 / 200, 0), (1, 0), (1, 1), (101 / 200, 1)]
      outlines 8 [solid left, solid right] `shouldSatisfy` \found -> length (filter (== 3.5 * 700) found) == 2
  where
    solid = rawPolygon . map (uncurry Point)
    outlines most polygons = either (const []) (areas most) (validate (RawScene Nothing Nothing polygons))
    areas most scene = [rounded (area (stripOutline strip)) | strip <- Map.elems (stripsOf scene (placed scene) most)]
    rounded v = fromIntegral (round (v * 1e6) :: Integer) / 1e6 :: Double

placed :: Scene -> CornerId -> Place
placed scene = placeOf scene (frameFor 0 scene [])

-- | The sides whose strips or rays are crossed by a side of the file, or are in the solid, by more than rounding
-- explains.
intruders :: Scene -> [(String, String)]
intruders scene =
  [ (sideText (sideName scene side), what)
  | (side, strip) <- Map.toList (stripsOf scene (placed scene) 8)
  , let region = stripOutline strip
  , (what, True) <-
      [ (text, wrong)
      | area region > 1e-6
      , (text, wrong) <-
          [("strip crossed", any (enters region) segments), ("strip in the solid", inSolid (centre region))]
      ]
        <> [ (text, wrong)
           | ray@[a, b] <- stripRays 8 strip
           , long a b > 1e-6
           , (text, wrong) <-
              [("ray crossed", any (cross (a, b)) segments), ("ray in the solid", inSolid (centre ray))]
           ]
  ]
  where
    frame = frameFor 0 scene []
    outlines =
      [(polygon, map (placeOfPoint scene frame) (polygonPoints polygon)) | polygon <- scenePolygons scene]
    segments =
      [ segment
      | (polygon, places) <- outlines
      , segment <- case polygonForm polygon of
          Ring -> zip places (drop 1 places <> take 1 places)
          Raw.Polyline -> zip places (drop 1 places)
      ]
    inSolid at =
      or
        [ within at places /= (polygonId polygon == Enclosure)
        | (polygon, places) <- outlines
        , polygonForm polygon == Ring
        ]
    long (Place x y) (Place x' y') = sqrt ((x' - x) ^ (2 :: Int) + (y' - y) ^ (2 :: Int))
    centre places = Place (mean [x | Place x _ <- places]) (mean [y | Place _ y <- places])
    mean values = sum values / fromIntegral (length values)
    cross (p, q) (a, b) = apart p q a b && apart a b p q
    apart u v s t = across u v s * across u v t < 0 && min (abs (across u v s)) (abs (across u v t)) > 1e-6 * long u v
    across (Place ux uy) (Place vx vy) (Place x y) = (vx - ux) * (y - uy) - (vy - uy) * (x - ux)

-- | Does a segment enter a convex region, its corners clockwise, by more than a millionth of a pixel?
enters :: [Place] -> (Place, Place) -> Bool
enters region (p, q) = from < to
  where
    (from, to) = foldl cut (0, 1) [(depth edge p, depth edge q) | edge <- edges]
    edges = [edge | edge@(a, b) <- zip region (drop 1 region <> take 1 region), a /= b]
    depth (Place ax ay, Place bx by) (Place x y) =
      ((by - ay) * (x - ax) - (bx - ax) * (y - ay)) / sqrt ((bx - ax) ^ (2 :: Int) + (by - ay) ^ (2 :: Int)) - 1e-6
    cut (low, high) (d, d')
      | d <= 0 && d' <= 0 = (1, 0)
      | d <= 0 = (max low (d / (d - d')), high)
      | d' <= 0 = (low, min high (d / (d - d')))
      | otherwise = (low, high)

area :: [Place] -> Double
area region = sum [x * y' - x' * y | (Place x y, Place x' y') <- zip region (drop 1 region <> take 1 region)] / (-2)

-- | Is a place inside a polygon, by the number of crossings of a ray?
within :: Place -> [Place] -> Bool
within (Place x y) outline =
  odd . length $
    [ ()
    | (Place ax ay, Place bx by) <- zip outline (drop 1 outline <> take 1 outline)
    , (ay > y) /= (by > y)
    , x < ax + (y - ay) * (bx - ax) / (by - ay)
    ]
