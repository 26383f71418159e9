-- | What the specs of points and lattices share.
module Visibility.Exact.SomePoints
  ( SomePoints (..)
  , wholePlaces
  ) where

import Data.Ratio ((%))
import Test.QuickCheck
import Visibility.Exact.Point (LatticePoint (..), Places, Point (..), Vector2 (..), placesFrom)

-- | Points with denominators of all kinds, at least one.
newtype SomePoints = SomePoints [Point]
  deriving (Show)

instance Arbitrary SomePoints where
  arbitrary = SomePoints <$> listOf1 (Point <$> coordinate <*> coordinate)
    where
      coordinate =
        oneof
          [ fromInteger <$> choose (-9, 9)
          , (%) <$> choose (-99, 99) <*> choose (1, 30)
          , (*) . (10 ^^) <$> choose (-40, 40 :: Int) <*> arbitrary
          ]
  shrink (SomePoints ps) = [SomePoints qs | qs <- shrinkList (const []) ps, not (null qs)]

-- | The places at the ends of vectors from the origin.
wholePlaces :: [Vector2] -> Places
wholePlaces vectors = placesFrom [LatticePoint x y 1 | Vector2 x y <- vectors]
