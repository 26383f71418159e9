module Visibility.Format.ViewSpec (spec) where

import Data.ByteString.Builder (Builder, toLazyByteString)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.List (find)
import Data.Maybe (fromMaybe)
import Test.Hspec
import Visibility.Exact.Point
import Visibility.Exact.Predicate (Direction (..))
import qualified Visibility.Exact.RootSum as RootSum
import Visibility.Exact.Rounding
import Visibility.FormFactor
import Visibility.Format.Factors (Detail (..))
import Visibility.Format.View
import Visibility.Scene
import Visibility.Sight
import Visibility.Sweep
import Visibility.Test.Generator

-- | A square and a thin wall in front of one of its sides.
pair :: Maybe Scene
pair = sampleScene <$> sampleOf [[(0, 0), (1, 0), (1, 1), (0, 1)], [(2, 0), (2, 1)]]

text :: Builder -> String
text = Lazy.unpack . toLazyByteString

fewDigits :: Digits
fewDigits = fromMaybe defaultDigits (digits 4)

-- | The side of this name, and all objects with a factor of zero.
seenFrom :: Scene -> String -> Detail -> Maybe String
seenFrom scene name detail = do
  side <- find ((== name) . sideText) (statedSides scene)
  pure . text . sideDocument detail fewDigits side $
    reverse (formFactors scene (measures scene (vertices scene)))

spec :: Spec
spec = do
  describe "regionDocument" $ do
    let seen = Region [Point 0 0, Point (1 / 2) (-3), Point 4 (2 / 3)] []
    it "writes points exactly and always says what is unbounded" $
      text (regionDocument (AtPoint (Point (1 / 2) 3)) seen)
        `shouldBe` ( "{\"format\":\"viscomplex/1\",\"from\":[\"1/2\",\"3\"],"
                   <> "\"polygon\":[[\"0\",\"0\"],[\"1/2\",\"-3\"],[\"4\",\"2/3\"]],\"unbounded\":[]}\n"
                   )
    it "names a corner, and lists directions two and two" $
      fmap
        ( \scene ->
            let open = Region [Point 1 0] [(Direction 1 0, Direction (-2) 7), (Direction (-1) 0, Direction 0 (-1))]
                name = CornerName (Obstacle 0) 1
             in text . flip regionDocument open . AtCorner name <$> statedPoint scene name
        )
        pair
        `shouldBe` (Just . Just)
          ( "{\"format\":\"viscomplex/1\",\"from\":[\"1\",\"0\"],\"corner\":\"0.1\",\"polygon\":[[\"1\",\"0\"]],"
              <> "\"unbounded\":[[\"1\",\"0\"],[\"-2\",\"7\"],[\"-1\",\"0\"],[\"0\",\"-1\"]]}\n"
          )
  describe "sideDocument" $ do
    it "lists what the side sees by name, the sky last" $
      (pair >>= \scene -> seenFrom scene "0.1" DecimalsOnly)
        `shouldBe` Just
          ( "{\"format\":\"viscomplex/1\",\"side\":\"0.1\",\"sees\":["
              <> "{\"id\":\"1.1\",\"value\":\"0.4142\"},{\"id\":\"sky\",\"value\":\"0.5858\"}]}\n"
          )
    it "adds the exact measure 2 L F on demand" $
      (pair >>= \scene -> seenFrom scene "1.1" WithExactMeasures)
        `shouldBe` Just
          ( "{\"format\":\"viscomplex/1\",\"side\":\"1.1\",\"sees\":["
              <> "{\"id\":\"0.1\",\"value\":\"0.4142\",\"measure\":[[\"-2\",\"1\"],[\"2\",\"2\"]]},"
              <> "{\"id\":\"sky\",\"value\":\"0.5858\",\"measure\":[[\"4\",\"1\"],[\"-2\",\"2\"]]}]}\n"
          )
  describe "elementDocument" $ do
    -- In the middle of side 0.1, half a unit from either end of the wall in height.
    let factors = [(TheSky, rest), (TheSide wall, root), (TheSide square, RootSum.zero)]
        rest = RootSum.rational 1 - root
        root = RootSum.hypotenuse (1 / 5) 1 2
        wall = SideName (Obstacle 1) 1
        square = SideName (Obstacle 0) 1
        written detail = text (elementDocument detail fewDigits (AtPoint (Point 1 (1 / 2))) (Direction 3 0) factors)
    it "states the normal, sorts, and leaves out what is exactly zero" $
      written DecimalsOnly
        `shouldBe` ( "{\"format\":\"viscomplex/1\",\"from\":[\"1\",\"1/2\"],\"normal\":[\"3\",\"0\"],\"sees\":["
                   <> "{\"id\":\"1.1\",\"value\":\"0.4472\"},{\"id\":\"sky\",\"value\":\"0.5528\"}]}\n"
                   )
    it "adds the exact factor on demand" $
      written WithExactMeasures
        `shouldBe` ( "{\"format\":\"viscomplex/1\",\"from\":[\"1\",\"1/2\"],\"normal\":[\"3\",\"0\"],\"sees\":["
                   <> "{\"id\":\"1.1\",\"value\":\"0.4472\",\"exact\":[[\"1/5\",\"5\"]]},"
                   <> "{\"id\":\"sky\",\"value\":\"0.5528\",\"exact\":[[\"1\",\"1\"],[\"-1/5\",\"5\"]]}]}\n"
                   )
