-- | Corners and sides that the command line names, looked up in the scene.
module Command.Address
  ( cornerNamed
  , sideNamed
  ) where

import Data.List (genericDrop, intercalate)
import qualified Data.Text as Text
import Options.Reader (Address (..), meant)
import Visibility.Exact.Point (Point)
import Visibility.Scene

-- | The corner that an option names and where it is, or what the scene has in its stead.
cornerNamed :: Scene -> String -> Address -> Either String (CornerName, Point)
cornerNamed scene option = lookedUp scene option "corner" members
  where
    members polygon = [corner | corner@(CornerName p _, _) <- statedCorners scene, p == polygon]

-- | The side, likewise.
sideNamed :: Scene -> String -> Address -> Either String SideName
sideNamed scene option = lookedUp scene option "side" members
  where
    members polygon = [side | side@(SideName p _) <- statedSides scene, p == polygon]

-- One of the members of a polygon, by number. A polygon's number goes before a name that is spelled like it.
lookedUp :: Scene -> String -> String -> (PolygonId -> [a]) -> Address -> Either String a
lookedUp scene option what members (Address owner number) = case (filter ((== owner) . polygonText) ids, named) of
  (polygon : _, _) -> within polygon
  ([], [polygon]) -> within polygon
  ([], []) -> wrong ("there is no polygon " <> owner <> meant owner names <> "; give one of " <> range)
  ([], several) ->
    wrong (show (length several) <> " polygons are named " <> owner <> "; give the number of one: " <> listed several)
  where
    ids = map polygonId (scenePolygons scene)
    named = [polygonId polygon | polygon <- scenePolygons scene, Just owner == (Text.unpack <$> polygonName polygon)]
    names = [Text.unpack name | polygon <- scenePolygons scene, Just name <- [polygonName polygon]]
    within polygon = case genericDrop number (members polygon) of
      member : _ -> Right member
      [] -> wrong (noSuch <> "; give one from " <> place 0 <> " to " <> place (length (members polygon) - 1))
      where
        noSuch = "polygon " <> polygonText polygon <> " has no " <> what <> " " <> show number
        place k = polygonText polygon <> "." <> show (k :: Int)
    range = intercalate " and " (obstacles [k | Obstacle k <- ids] <> ["E" | Enclosure `elem` ids])
    obstacles numbers = case numbers of
      [] -> []
      [k] -> [show k]
      _ -> [show (minimum numbers) <> " to " <> show (maximum numbers)]
    listed several = intercalate ", " (map polygonText (take 10 several) <> ["…" | not (null (drop 10 several))])
    wrong problem = Left (option <> " " <> owner <> "." <> show number <> ": " <> problem)
