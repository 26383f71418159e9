-- | Single bytes of a text.
module Visibility.Format.Bytes
  ( charAt
  ) where

import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.ByteString.Internal (accursedUnutterablePerformIO, toForeignPtr, w2c)
import Foreign.Storable (peekByteOff)
import GHC.ForeignPtr (unsafeWithForeignPtr)

-- | The byte at a place from 0 on, as a character; NUL behind the end. (The bytes of ASCII stand for nothing else in
-- UTF-8.)
--
-- /Requires/ a place that is not negative.
--
-- 'Data.ByteString.Unsafe.unsafeIndex' of bytestring 0.10 does the same, but allocates for each byte. What this reads
-- is within the bytes and never changes, and the reading always ends, as 'unsafeWithForeignPtr' wants.
charAt :: ByteString -> Int -> Char
charAt bytes i
  | i < Bytes.length bytes = w2c (accursedUnutterablePerformIO (unsafeWithForeignPtr start byte))
  | otherwise = '\0'
  where
    byte first = peekByteOff first (offset + i)
    (start, offset, _) = toForeignPtr bytes
{-# INLINE charAt #-}
