-- | Tables by ids of one kind that hold things of another one, in numbers of 32 bits. Who makes tables, checks them or
-- breaks them on purpose sees the numbers.
module Visibility.Complex.Table
  ( Table (..)
  , Code (..)
  , at
  , numberAt
  , tableLength
  ) where

import Data.Int (Int32)
import qualified Data.Vector.Unboxed as U
import Visibility.Scene (CornerId (..))

-- | A table by its index, and what it holds.
newtype Table index item = Table {tableNumbers :: U.Vector Int32}

-- | What a number in a table stands for. An index is its own number.
class Code a where
  code :: a -> Int
  decoded :: Int -> a

instance Code Int where
  code = id
  decoded = id

instance Code CornerId where
  code (CornerId c) = c
  decoded = CornerId

-- | −1 stands for 'Nothing'.
instance Code a => Code (Maybe a) where
  code = maybe (-1) code
  decoded n = if n < 0 then Nothing else Just (decoded n)
  {-# INLINE decoded #-}

-- | /Requires/ an index of the table.
at :: (Code index, Code item) => Table index item -> index -> item
at table = decoded . numberAt table
{-# INLINE at #-}

-- | The number itself. /Requires/ an index of the table.
numberAt :: Code index => Table index item -> index -> Int
numberAt (Table numbers) i = fromIntegral (numbers U.! code i)
{-# INLINE numberAt #-}

tableLength :: Table index item -> Int
tableLength (Table numbers) = U.length numbers
