-- | Reading that goes on behind a fault, so that every fault is reported.
module Visibility.Format.Checked
  ( Checked (..)
  , fault
  , andThen
  , eachOf
  , outcome
  ) where

import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.List.NonEmpty as NonEmpty
import Data.Semigroup (sconcat)
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

-- | 'traverse' with the places in the list, from 0; in a loop, for lists of any length.
eachOf :: (Int -> a -> Checked b) -> [a] -> Checked [b]
eachOf check = good [] 0
  where
    good done _ [] = Good (reverse done)
    good done k (item : rest) = case check k item of
      Good made -> good (made : done) (k + 1) rest
      Wrong faults -> wrong faults [] (k + 1) rest
    -- The last faults first.
    wrong faults before _ [] = Wrong (sconcat (NonEmpty.reverse (faults :| before)))
    wrong faults before k (item : rest) = case check k item of
      Good _ -> wrong faults before (k + 1) rest
      Wrong faults' -> wrong faults' (faults : before) (k + 1) rest
{-# INLINE eachOf #-}

-- | What has been read from a file, or its problems.
outcome :: FilePath -> Checked a -> Either (NonEmpty Problem) a
outcome file (Wrong faults) = Left (fmap (UnparseableFile file) faults)
outcome _ (Good a) = Right a
