-- | The break points of two meshes.
module Report.Union
  ( meshUnion
  ) where

import qualified Data.Vector as V
import Visibility.Mesh.Span
import Visibility.Mesh.Type

-- | The mesh that cuts where either of two meshes of one scene does. Where both do, the break point is the one with
-- casters; the first one's if both have some.
--
-- /Requires/ meshes of the same scene.
-- /Cost/ O(1) per break point.
--
-- /Laws/ idempotent and associative; with the empty mesh the other one.
meshUnion :: Mesh -> Mesh -> Mesh
meshUnion first second = first {breakTable = V.zipWith3 merged spans (breakTable first) (breakTable second)}
  where
    spans = pieceSpans (meshScene first)
    merged piece = go
      where
        before a b
          | spanStart piece < spanEnd piece = compare (breakParameter a) (breakParameter b)
          | otherwise = compare (breakParameter b) (breakParameter a)
        go [] others = others
        go points [] = points
        go (a : as) (b : bs) = case before a b of
          LT -> a : go as (b : bs)
          GT -> b : go (a : as) bs
          EQ -> (if null (breakCasters a) then b else a) : go as bs
