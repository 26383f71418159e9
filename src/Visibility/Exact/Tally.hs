-- | How many signs a floating-point filter decided, and how many it left to integers.
module Visibility.Exact.Tally
  ( -- * Counts
    Signs (..)
  , shareLeft
    -- * Counting
  , Tally
  , newTally
  , signsSoFar
  , counted
  ) where

import Data.Ratio ((%))
import qualified Data.Vector.Unboxed.Mutable as M
import System.IO.Unsafe (unsafeDupablePerformIO)

-- | Signs asked of a filter.
data Signs = Signs
  { signsDecided :: !Int
  -- ^ All of them.
  , signsLeft :: !Int
  -- ^ Those of them that the filter was not sure of, so that integers decided.
  }
  deriving (Eq, Show)

-- | The part of the signs that was left to integers, from 0 to 1; 0 if there were none.
shareLeft :: Signs -> Rational
shareLeft (Signs decided left) = if decided == 0 then 0 else toInteger left % toInteger decided

-- | Two counters that go up: all signs, and those left to integers.
newtype Tally = Tally (M.IOVector Int)

-- | Counters at zero.
newTally :: IO Tally
newTally = Tally <$> M.replicate 2 0

-- | What has been counted up to now. Signs that have not been evaluated yet are not among them.
signsSoFar :: Tally -> IO Signs
signsSoFar (Tally cells) = Signs <$> M.read cells 0 <*> M.read cells 1

-- Note [Counting evaluations]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~~~
-- 'counted' writes to its counters when its result is evaluated, which no type shows. This is harmless: the result is
-- that of the arguments alone, for nothing pure can read a tally; only 'signsSoFar' can, in IO, where an answer may
-- depend on what has been evaluated. Nothing counts but points that 'Visibility.Exact.Point.tallied' made, again in IO,
-- with counters of their own.
--
-- The count itself is what has been evaluated: if the compiler shares two equal calls, one sign is decided and one is
-- counted. Nothing else is shared, since every call has its own arguments, and 'counted' is not inlined. Two threads
-- that evaluate signs at one time may lose counts, nothing more; hence no lock.

-- | @counted tally answer behind@ is the answer of a filter, or what integers find behind it if there is none; the sign
-- is counted.
--
-- /Laws/ @counted tally answer behind == fromMaybe behind answer@.
counted :: Tally -> Maybe a -> a -> a
counted (Tally cells) answer behind = unsafeDupablePerformIO $ do
  M.modify cells (+ 1) 0
  case answer of
    Just sign -> pure sign
    Nothing -> behind <$ M.modify cells (+ 1) 1
{-# NOINLINE counted #-}
