-- | What commands do, each from a checked scene to the last byte: for tests and benchmarks of how their cost grows.
module Visibility.Test.Part
  ( Part (..)
  , parts
  , sceneUnits
  , writtenUnits
  ) where

import qualified Data.ByteString as Bytes
import Data.ByteString.Builder (toLazyByteString)
import qualified Data.ByteString.Lazy as Lazy
import Visibility.Complex (complexOf)
import Visibility.Complex.Law (checked)
import Visibility.Complex.Polygons (polygonComplex)
import Visibility.Complex.Walk (Look (..), lookAround)
import Visibility.Count (count)
import Visibility.Draw.Dual (dualDrawing)
import Visibility.Draw.Matrix (factorMatrix, matrixDrawing)
import Visibility.Draw.Mesh (CastingLines (..), meshDrawing)
import Visibility.Draw.Render (renderSvg)
import Visibility.Draw.Scene (sceneDrawing)
import Visibility.Exact.Rounding (defaultDigits)
import Visibility.FormFactor
import Visibility.Format.Complex (complexDocument, polygonDocument)
import Visibility.Format.Factors
import Visibility.Format.Graph
import Visibility.Format.Info (infoText, verdictText)
import Visibility.Format.Mesh (meshDocument)
import Visibility.Format.Radiosity (radiosityDocument)
import Visibility.Format.View (regionDocument)
import Visibility.Mesh
import Visibility.Radiosity
import Visibility.Scene
import Visibility.Sight
import Visibility.Sweep
import Visibility.View (events)

-- | The work of a command.
data Part = Part
  { partName :: !String
  , partBytes :: Scene -> Int
  -- ^ How many bytes it writes, all of which are made.
  }

-- | The commands on whole scenes, by what one would type.
parts :: [Part]
parts =
  [ Part "info" (\s -> length (infoText s Topological (count s (events s (vertices s))) 0))
  , Part "graph --unsorted" (asSwept Topological)
  , Part "graph --scheduler straight" (asSwept Straight)
  , written "graph" (\s -> let names = namesOf s in sortedLines names (keys Topological s names))
  , written "complex" (complexDocument . complexOf)
  , written "complex --polygons" (polygonDocument . polygonComplex . complexOf)
  , Part "verify" (length . verdictText . checked . complexOf)
  , written "view" (\s -> foldMap (seenFrom s) (take 1 (statedCorners s)))
  , written "factors" (\s -> decimalDocument FactorsCsv defaultDigits sideBuilder s (decimalFactors defaultDigits s (summed s)))
  , written "factors --exact" $ \s ->
      exactDocument FactorsCsv defaultDigits sideBuilder s (exactFactors defaultDigits s (summed s))
  , written "factors --double" (\s -> nearestDocument FactorsCsv sideBuilder s (nearestFactors s (summed s)))
  , written "radiosity" (either mempty radiosityDocument . lit)
  , written "mesh" (\s -> let mesh = allBreaks s in meshDocument mesh (emptyMesh s))
  , written "mesh --max-elements 4" (uncurry meshDocument . fewElements . allBreaks)
  , drawn "draw scene" (\s -> sceneDrawing s (vertices s))
  , drawn "draw dual" (\s -> dualDrawing s (events s (vertices s)))
  , drawn "draw matrix" (\s -> matrixDrawing (factorMatrix s (nearestFactors s (summed s))))
  , drawn "draw mesh" (meshDrawing WithoutLines . allBreaks)
  ]
  where
    written name document = Part name (fromIntegral . Lazy.length . toLazyByteString . document)
    drawn name drawing = Part name (fromIntegral . Lazy.length . renderSvg . drawing)
    keys scheduler s names = map (pairKeys s names AllPairs) (piecesBy scheduler s)
    asSwept scheduler s = let names = namesOf s in sum (map (Bytes.length . linesOf names) (keys scheduler s names))
    summed s = measures s (vertices s)
    allBreaks s = discontinuityMesh s (vertices s)
    fewElements mesh = maybe (mesh, mesh) (`bounded` mesh) (elementCount 4)
    lit s = radiosity (WithinTolerance defaultTolerance) s (summed s)
    seenFrom s (name, place) =
      let viewpoint = AtCorner name place
       in either mempty (regionDocument viewpoint . region s place . lookSights) (lookAround (complexOf s) viewpoint)

-- | How many units a scene has: a unit is a corner or an elementary visible pair.
--
-- /Cost/ that of the sweep.
sceneUnits :: Scene -> Int
sceneUnits scene = cornerCount scene + sum (map (length . vertexPairs scene) (vertices scene))

-- | How many units so many bytes are, 100 bytes being one: about what a line of an answer has.
writtenUnits :: Int -> Int
writtenUnits bytes = bytes `div` 100
