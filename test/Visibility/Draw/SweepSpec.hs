module Visibility.Draw.SweepSpec (spec) where

import qualified Data.Map.Strict as Map
import qualified Data.Text as Text
import Test.Hspec
import Test.QuickCheck hiding (sample)
import Visibility.Draw.Checks
import Visibility.Draw.Drawing
import Visibility.Draw.Gallery
import Visibility.Draw.Sweep
import Visibility.Scene
import Visibility.Sweep (vertexCorners, vertices)
import Visibility.Sweep.Reference (Change (..), State (..), Tree (..), readyVertices)
import Visibility.Sweep.Vertical (Heading (..))
import Visibility.Test.Generator

spec :: Spec
spec = do
  describe "the moments of a sweep" $
    it "are the start and one for each vertex" $
      property $ \(SmallScene s) ->
        let scene = sampleScene s
            found = moments scene
         in ([v | Just v <- map momentVertex found], map momentCount found)
              === (vertices scene, [0 .. length (vertices scene)])
  describe "of any moment" $ do
    it "no label covers anything, and nothing leaves the canvas" $
      onMoments $ \scene moment -> isLegible (drawing scene moment)
    it "every corner with a target has an edge in each tree, bold where the last step found it" $
      onMoments $ \scene moment@(Moment _ _ state) ->
        conjoin
          [ [(Text.unpack name, style) | Mark name style _ <- marksIn (Text.pack layer) (drawing scene moment)]
              === [ (cornerText (cornerName scene p), if p `elem` new then bold else thin)
                  | p <- Map.keys (targets tree)
                  , let new = [changedCorner c | c <- changes state, changedHeading c == way]
                  ]
          | (layer, way, tree, thin, bold) <-
              [ ("right-tree", Rightward, rightTree state, RightTreeEdge, NewRightTreeEdge)
              , ("left-tree", Leftward, leftTree state, LeftTreeEdge, NewLeftTreeEdge)
              ]
          ]
    it "every line that may be swept has a mark, and so has the one swept just now" $
      onMoments $ \scene moment@(Moment _ vertex state) ->
        let names layer = map markName (marksIn (Text.pack layer) (drawing scene moment))
            nameOf v = Text.pack (unwords (map (cornerText . cornerName scene) (vertexCorners v)))
            wanted = (map nameOf (readyVertices scene state), map nameOf (maybe [] pure vertex))
         in (names "ready", names "swept") === wanted
  where
    drawing scene = sweepDrawing scene (length (vertices scene))
    onMoments f = property $ \(AnyScene s) ->
      let scene = sampleScene s
          found = moments scene
       in forAll (choose (0, length found - 1)) $ \k -> conjoin (map (f scene) (take 1 (drop k found)))
