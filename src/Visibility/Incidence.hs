{-# LANGUAGE DeriveFunctor #-}

-- | What the line through a corner is at a direction between two of the corner's vertices, and the rule which faces
-- meet at the corner's curve there (mathematics: lines, curves, the dual).
module Visibility.Incidence
  ( -- * Views
    View (..)
  , Flank (..)
  , End (..)
  , isBuried
    -- ** As tables tell them
  , Outlook (..)
  , viewIn
  , viewOf
    -- * Faces at a corner
  , Part (..)
  , foldIncidences
  , foldFaces
  , Incidence (..)
  , incidences
  ) where

import Visibility.Scene
import Visibility.Sweep.Vertical (objectAt, solid)

-- | A side of a directed line: above is to the left of it.
data Flank = Above | Below
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | An end of a maximal free segment: the front is where the right-going line leads.
data End = Back | Front
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | The line through a corner at a direction between two of the corner's vertices.
data View object
  = -- | The polygon lies strictly on this flank of the line; what is seen backward and forward. Three faces meet.
    Tangent !Flank !object !object
  | -- | The maximal free segment has this end at the corner; what is seen at its other end. Two faces meet.
    Ending !End !object
  | -- | Neither ray is free: a reflex corner of the solid, whose free cone lies on this flank. The segment through it
    -- is a single point, so it is no edge of the complex; yet it bounds one face, the segments that cut the corner off.
    Buried !Flank
  deriving (Eq, Ord, Show, Functor)

-- | Is the line through the corner no edge of the complex?
isBuried :: View object -> Bool
isBuried (Buried _) = True
isBuried _ = False

-- | A view in the numbers that tables hold: of the objects at the back and in front of a corner, and 1 where the
-- following corner lies above its line.
data Outlook = Outlook !Int !Int !Int
  deriving (Eq)

-- | The view that an outlook stands for, with objects by their numbers.
viewIn :: Outlook -> View Int
viewIn (Outlook back front above)
  | back /= solid = if front /= solid then Tangent flank back front else Ending Front back
  | front /= solid = Ending Back front
  | otherwise = Buried flank
  where
    flank = if above == 1 then Above else Below
{-# INLINE viewIn #-}

-- | The view that an outlook stands for.
viewOf :: Scene -> Outlook -> View Object
viewOf scene = fmap (objectAt scene) . viewIn

-- | The part of a line, seen from a corner on it, along which a face lies.
data Part = AtBack | InFront | Throughout

-- | The rule which faces meet at the curve of a corner under a view: 3 where it is tangent, 2 where it is ending, 1
-- where it is buried. The faces are told from above the line to below it, and from the back to the front: for each the
-- flank and the part of the line where it lies, and its label, the objects at the back and in front of its segments.
--
-- Besides the view it takes the side that leaves the corner and the one that arrives there, with the solid on their
-- left.
--
-- /Degenerate cases/ none: at a direction between two vertices no side of the corner lies on the line, and a flat
-- corner is never tangent.
--
-- /Law/ at a vertex, above and below faces of one label alternate along the corners, before and after it.
foldIncidences :: (Flank -> Part -> object -> object -> r -> r) -> r -> object -> object -> View object -> r
foldIncidences face end leaving arriving view = case view of
  Tangent Above back front ->
    face Above AtBack back arriving $ face Above InFront leaving front $ face Below Throughout back front end
  Tangent Below back front ->
    face Above Throughout back front $ face Below AtBack back leaving $ face Below InFront arriving front end
  Ending Front back -> face Above AtBack back arriving $ face Below AtBack back leaving end
  Ending Back front -> face Above InFront leaving front $ face Below InFront arriving front end
  Buried Above -> face Above Throughout leaving arriving end
  Buried Below -> face Below Throughout arriving leaving end
{-# INLINE foldIncidences #-}

-- | The same for a corner and an outlook of it, by numbers.
foldFaces :: Scene -> (Flank -> Part -> Int -> Int -> r -> r) -> r -> Int -> Outlook -> r
foldFaces scene face end c = foldIncidences face end c arriving . viewIn
  where
    CornerId arriving = previousCorner scene (CornerId c)
{-# INLINE foldFaces #-}

-- | A face at the curve of a corner: the flank on which the face lies, and its label.
data Incidence = Incidence !Flank !Object !Object
  deriving (Eq, Ord, Show)

-- | The faces that meet at the curve of a corner under a view, in the order of 'foldIncidences'.
incidences :: Scene -> CornerId -> View Object -> [Incidence]
incidences scene c = foldIncidences face [] (starting c) (starting before)
  where
    face flank _ back front = (Incidence flank back front :)
    starting (CornerId start) = Side (SideId start)
    before = previousCorner scene c
