{-# LANGUAGE OverloadedStrings #-}

-- | Meshes as JSON.
module Visibility.Format.Mesh
  ( meshDocument
  , uniformDocument
  , kindText
  ) where

import Visibility.Format.Json.Document
import Visibility.Mesh
import Visibility.Scene

-- | A mesh, and the break points that were dropped from it.
--
-- /Shape/ @sides@, an entry for each side of the file, by name: @id@; @points@ by ascending parameter; @dropped@
-- likewise, if there are any. A point has @at@, @parameter@, @kind@; unless it cuts a side into equal parts, @caster@,
-- the corner nearer to the point first; and if there are more casters @others@, each with its own @kind@. All numbers
-- are exact, as strings.
--
-- /Requires/ two meshes of one scene.
meshDocument :: Mesh -> Mesh -> Builder
meshDocument kept dropped =
  sidesDocument (meshScene kept) [(side, points, breaksOf dropped side) | (side, points) <- meshSides kept]

-- | The same of the sides cut into equal parts, of which none are dropped, in constant memory.
uniformDocument :: ElementCount -> Scene -> Builder
uniformDocument parts scene = sidesDocument scene [(side, points, []) | (side, points) <- uniformSides parts scene]

sidesDocument :: Scene -> [(SideName, [BreakPoint], [BreakPoint])] -> Builder
sidesDocument scene found = document (pair "sides" (list side found))
  where
    side (name, points, dropped) =
      pairs $
        pair "id" (string (sideText name))
          <> pair "points" (list (breakPoint scene) points)
          <> mconcat [pair "dropped" (list (breakPoint scene) dropped) | not (null dropped)]

breakPoint :: Scene -> BreakPoint -> Encoding
breakPoint scene point =
  pairs $
    pair "at" (exactPoint (breakAt point))
      <> pair "parameter" (exact (breakParameter point))
      <> pair "kind" (string (kindText (breakKind point)))
      <> case breakCasters point of
        [] -> mempty
        first : others -> cornersOf first <> mconcat [pair "others" (list other others) | not (null others)]
  where
    cornersOf caster =
      let (near, far) = casterNames scene caster in pair "caster" (list (string . cornerText) [near, far])
    other caster = pairs (cornersOf caster <> pair "kind" (string (kindText (Just (casterKind caster)))))

-- | @shadow-limit@ or @kink@, or else @equal-parts@.
kindText :: Maybe Kind -> String
kindText kind = case kind of
  Just ShadowLimit -> "shadow-limit"
  Just Kink -> "kink"
  Nothing -> "equal-parts"
