{-# LANGUAGE BangPatterns #-}

-- | Lists of points in little memory.
module Visibility.Scene.Packed
  ( Packed
  , packed
  , unpacked
  , packedLength
  , machineTable
  ) where

import Control.Monad.ST (runST)
import Data.Primitive.PrimArray
import Data.Ratio (denominator, numerator, (%))
import Visibility.Exact.Point (Point (..))

-- | A list of points. Where a common denominator and all coordinates times it are machine integers, it takes two words
-- a point; else it is the list itself.
data Packed
  = -- | The least common denominator; x and y of point i times it at 2i and 2i + 1.
    Scaled !Int {-# UNPACK #-} !(PrimArray Int)
  | -- | With the length.
    Apart !Int ![Point]
  deriving (Eq)

-- | As the list.
instance Show Packed where
  showsPrec p = showsPrec p . unpacked

-- | /Cost/ O(n), but for the size of the numbers. All points are computed.
--
-- /Laws/ @unpacked (packed ps) == ps@; @packed ps == packed qs@ just if @ps == qs@.
packed :: [Point] -> Packed
packed points = case leastDenominator points >>= scaledBy of
  Just scaled -> scaled
  Nothing -> foldr seq (Apart n points) points
  where
    n = length points
    scaledBy d = runST $ do
      table <- newPrimArray (2 * n)
      let fill !_ [] = Just . Scaled d <$> unsafeFreezePrimArray table
          fill !k (Point x y : rest) = case (machine (timesOver x), machine (timesOver y)) of
            (Just x', Just y') -> writePrimArray table k x' *> writePrimArray table (k + 1) y' *> fill (k + 2) rest
            _ -> pure Nothing
          timesOver q
            | d == 1 = numerator q
            | otherwise = numerator q * (toInteger d `quot` denominator q)
      fill 0 points

-- If it is a machine integer.
leastDenominator :: [Point] -> Maybe Int
leastDenominator = go 1
  where
    go !d [] = Just d
    go !d (Point x y : rest) = joined d (denominator x) >>= (`joined` denominator y) >>= (`go` rest)
    joined d 1 = Just d
    joined d q = machine (lcm (toInteger d) q)

machine :: Integer -> Maybe Int
machine n = if toInteger k == n then Just k else Nothing
  where
    k = fromInteger n

-- | The points, each time anew: nothing of the list is kept.
--
-- /Cost/ O(n) where all of it is looked at.
unpacked :: Packed -> [Point]
unpacked (Apart _ points) = points
unpacked (Scaled d table) = go 0
  where
    go k
      | k < sizeofPrimArray table = Point (over k) (over (k + 1)) : go (k + 2)
      | otherwise = []
    over k
      | d == 1 = fromInteger n
      | otherwise = n % toInteger d
      where
        n = toInteger (indexPrimArray table k)

-- | How many points there are. /Cost/ O(1).
packedLength :: Packed -> Int
packedLength (Apart n _) = n
packedLength (Scaled _ table) = sizeofPrimArray table `quot` 2

-- | The least common denominator of a list of points, and x and y of point i times it at 2i and 2i + 1, where machine
-- integers do. /Cost/ O(1).
machineTable :: Packed -> Maybe (Int, PrimArray Int)
machineTable (Apart _ _) = Nothing
machineTable (Scaled d table) = Just (d, table)
