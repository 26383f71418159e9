-- | The visibility complex of polygonal scenes, exactly: what most users need.
--
-- One thing flows through it: a file becomes a 'Scene', the scene a stream of vertices, the stream all else.
--
-- > Right scene <- readSceneFile "scenes/room.json"
-- > let swept = vertices scene
-- >     sums = measures scene swept
-- > mapM_ (putStrLn . decimal defaultDigits . factorValue) (formFactors scene sums)
--
-- Everything geometric is decided in exact arithmetic; degenerate scenes are ordinary input.
module Visibility
  ( -- * Scenes
    Scene
  , CornerId (..)
  , SideId (..)
  , Object (..)
  , readSceneFile
  , validate
  , RawScene (..)
  , RawPolygon (..)
  , rawPolygon
  , Point (..)
  , Direction (..)
    -- * The sweep
  , Vertex
  , vertices
  , vertexCorners
  , vertexPairs
    -- * Views
  , Event (..)
  , View (..)
  , events
    -- * The complex (its parts: "Visibility.Complex")
  , Complex
  , complexOf
  , violations
    -- * Walking in it
  , Viewpoint (..)
  , Look (..)
  , lookAround
  , Sight (..)
  , Region (..)
  , region
    -- * Form factors
  , Measures
  , measures
  , FormFactor (..)
  , formFactors
  , FactorRow (..)
  , nearestFactors
  , decimalFactors
  , exactFactors
    -- * The discontinuity mesh (all of it: "Visibility.Mesh")
  , Mesh
  , BreakPoint (..)
  , discontinuityMesh
  , meshSides
    -- * Radiosity (its parts: "Visibility.Radiosity")
  , radiosity
  , Closeness (..)
  , Radiosity (..)
    -- * Numbers
  , RootSum
  , decimal
  , defaultDigits
    -- * Figures
  , sceneDrawing
  , dualDrawing
  , viewDrawing
  , ViewFigure (..)
  , meshDrawing
  , CastingLines (..)
  , renderSvg
  ) where

import Visibility.Complex (Complex, complexOf)
import Visibility.Complex.Law (violations)
import Visibility.Complex.Walk (Look (..), lookAround)
import Visibility.Draw.Dual (dualDrawing)
import Visibility.Draw.Mesh (CastingLines (..), meshDrawing)
import Visibility.Draw.Render (renderSvg)
import Visibility.Draw.Scene (sceneDrawing)
import Visibility.Draw.View (ViewFigure (..), viewDrawing)
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.Predicate (Direction (..))
import Visibility.Exact.RootSum (RootSum)
import Visibility.Exact.Rounding (decimal, defaultDigits)
import Visibility.FormFactor
  ( FactorRow (..)
  , FormFactor (..)
  , Measures
  , decimalFactors
  , exactFactors
  , formFactors
  , measures
  , nearestFactors
  )
import Visibility.Format.File (readSceneFile)
import Visibility.Mesh (BreakPoint (..), Mesh, discontinuityMesh, meshSides)
import Visibility.Radiosity (Closeness (..), Radiosity (..), radiosity)
import Visibility.Scene (CornerId (..), Object (..), Scene, SideId (..))
import Visibility.Scene.Raw (RawPolygon (..), RawScene (..), rawPolygon)
import Visibility.Scene.Validate (validate)
import Visibility.Sight (Region (..), Sight (..), Viewpoint (..), region)
import Visibility.Sweep (Vertex, vertexCorners, vertexPairs, vertices)
import Visibility.View (Event (..), View (..), events)
