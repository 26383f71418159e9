-- | Allocation and live memory of single parts of the work, measured by weigh in processes of their own; as CSV, which
-- the table of ratios is made from: the name, bytes allocated, the most bytes live.
module Main (main) where

import Bench.Scenes
import Control.Monad (forM_)
import Data.List (intercalate)
import Visibility.Complex (complexOf, faceIds)
import Visibility.FormFactor (measureList, measures)
import Visibility.Format.File (readSceneBytes)
import Visibility.Scene.Family (Family (..))
import Visibility.Scene.Validate (validate)
import Visibility.Sweep
import Visibility.View (events)
import Weigh

main :: IO ()
main = do
  (results, _) <- weighResults $ do
    setFormat Plain
    value "nothing" ()
    func' "read, 1000 quadrilaterals" (isRight . readSceneBytes "scene.json") (fileOf Random 1000)
    func' "read and validate, 1000 quadrilaterals" (fmap (isRight . validate) . rightOf . readSceneBytes "scene.json") $
      fileOf Random 1000
    forM_ [(Random, 100), (Random, 1000), (Grid, 400), (Checkerboard, 400)] $ \(kind, n) ->
      func' ("sweep, " <> show kind <> " " <> show n) (sum . map pieceLength . verticesInPieces . sceneOf kind) n
    func' "events, 1000 quadrilaterals" ((\s -> length (events s (vertices s))) . sceneOf Random) 1000
    func' "all tables, 100 quadrilaterals" (length . faceIds . complexOf . sceneOf Random) 100
    func' "measures, 100 quadrilaterals" (entries . sceneOf Random) 100
  putStrLn "name,allocated,most live"
  mapM_ row (concatMap leaves results)
  where
    entries scene = length (measureList scene (measures scene (vertices scene)))
    rightOf = either (const Nothing) Just
    isRight = either (const False) (const True)
    row (weight, _) =
      putStrLn $
        intercalate "," [show (weightLabel weight), show (weightAllocatedBytes weight), show (weightMaxBytes weight)]
    leaves grouped = case grouped of
      Singleton x -> [x]
      Grouped _ inner -> concatMap leaves inner
