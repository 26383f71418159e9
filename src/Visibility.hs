-- | The visibility complex of polygonal scenes, exactly: what most users need.
--
-- One thing flows through it: a file becomes a 'Scene', the scene a stream of vertices, the stream all else.
--
-- > found <- readSceneFile "scenes/room.json"
-- > case found of
-- >   Left problems -> mapM_ (hPutStrLn stderr . errorText) problems
-- >   Right scene ->
-- >     for_ (formFactors scene (measures scene (vertices scene))) $ \factor ->
-- >       putStrLn (sideText (factorFrom factor) <> " " <> decimal defaultDigits (factorValue factor))
--
-- Everything geometric is decided in exact arithmetic; degenerate scenes are ordinary input. Figures are in
-- "Visibility.Draw".
module Visibility
  ( -- * Scenes (all of them: "Visibility.Scene")
    Scene
  , readSceneFile
  , validate
  , RawScene (..)
  , RawPolygon (..)
  , rawPolygon
  , Form (..)
  , Material (..)
  , MaterialOverride (..)
  , Point (..)
  , Direction (..)
    -- ** What is wrong with a file (all of it: "Visibility.Error")
  , Problem (..)
  , errorText
  , ReadFault
  , ParseError
  , SceneError
  , sceneErrorText
    -- ** Its corners and sides
  , CornerId
  , SideId
  , Object (..)
  , PolygonId (..)
  , CornerName (..)
  , SideName (..)
  , Seen (..)
  , cornerText
  , sideText
  , seenText
    -- * The sweep
  , Vertex
  , vertices
  , vertexCorners
  , vertexPairs
    -- * Views (more: "Visibility.View")
  , Event (..)
  , View (..)
  , Flank (..)
  , End (..)
  , events
    -- * The complex (its parts: "Visibility.Complex")
  , Complex
  , complexOf
  , violations
  , Violation (..)
    -- * Walking in it
  , Viewpoint (..)
  , Look (..)
  , lookAround
  , Sight (..)
  , Region (..)
  , region
    -- * Form factors (more: "Visibility.FormFactor")
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
  , Cause (..)
  , Caster (..)
  , Kind (..)
  , discontinuityMesh
  , meshSides
    -- * Radiosity (its parts: "Visibility.Radiosity")
  , radiosity
  , Closeness (..)
  , Tolerance
  , defaultTolerance
  , Radiosity (..)
  , Lit (..)
  , Element (..)
  , Balance (..)
  , Shortfall (..)
    -- * Numbers (sums of roots: "Visibility.Exact.RootSum")
  , RootSum
  , decimal
  , Digits
  , digits
  , defaultDigits
  , nearestDouble
  ) where

import Visibility.Complex (Complex, complexOf)
import Visibility.Complex.Law (violations)
import Visibility.Complex.Walk (Look (..), lookAround)
import Visibility.Error
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.Predicate (Direction (..))
import Visibility.Exact.RootSum (RootSum)
import Visibility.Exact.Rounding (Digits, decimal, defaultDigits, digits, nearestDouble)
import Visibility.FormFactor
import Visibility.Format.File (readSceneFile)
import Visibility.Law (Violation (..))
import Visibility.Mesh
import Visibility.Radiosity
import Visibility.Scene.Raw
import Visibility.Scene.Validate (validate)
import Visibility.Sight (Region (..), Sight (..), Viewpoint (..), region)
import Visibility.Surface.Scene
import Visibility.Sweep (Vertex, vertexCorners, vertexPairs, vertices)
import Visibility.View (End (..), Event (..), Flank (..), View (..), events)
