-- | Reading that goes on behind a fault, so that every fault is reported.
module Visibility.Format.Checked
  ( Checked (..)
  , fault
  , andThen
  , eachOf
  , outcome
  ) where

import Data.List.NonEmpty (NonEmpty (..))
import Visibility.Error

-- | A value or all the faults that prevent it. Nothing waits to be computed, so that what has been read keeps no text.
data Checked a = Wrong !(NonEmpty ParseError) | Good !a

instance Functor Checked where
  fmap _ (Wrong faults) = Wrong faults
  fmap f (Good a) = Good (f a)

-- | Collects the faults of both sides, in order.
instance Applicative Checked where
  pure = Good
  Good f <*> Good a = Good (f a)
  Wrong faults <*> Wrong faults' = Wrong (faults <> faults')
  Wrong faults <*> Good _ = Wrong faults
  Good _ <*> Wrong faults = Wrong faults

-- | One fault.
fault :: ParseError -> Checked a
fault why = Wrong (why :| [])

-- | What a value leads to, which may be faults of its own. Faults before it hide those.
andThen :: Checked a -> (a -> Checked b) -> Checked b
andThen (Wrong faults) _ = Wrong faults
andThen (Good a) next = next a

-- | 'traverse' with the places in the list, from 0.
eachOf :: (Int -> a -> Checked b) -> [a] -> Checked [b]
eachOf check = sequenceA . zipWith check [0 ..]
{-# INLINE eachOf #-}

-- | What has been read from a file, or its problems.
outcome :: FilePath -> Checked a -> Either (NonEmpty Problem) a
outcome file (Wrong faults) = Left (fmap (UnparseableFile file) faults)
outcome _ (Good a) = Right a
