-- | Products of roots, which specs compare quotients and lengths with.
module Visibility.Exact.SomeRoots
  ( timesRoot
  , rootOfRational
  ) where

import Data.Ratio (denominator, numerator, (%))
import Visibility.Exact.RootSum

-- | @timesRoot r n s@ is s · r √n, the quotient by √n \/ (r n); 'Nothing' if n is negative.
timesRoot :: Rational -> Integer -> RootSum -> Maybe RootSum
timesRoot r n s
  | n == 0 || r == 0 && n > 0 = Just zero
  | otherwise = quotientByRoot s (1 / (r * fromInteger n)) n

-- | √(p\/q) = (1\/q) √(p q); 'Nothing' for a negative one.
rootOfRational :: Rational -> Maybe RootSum
rootOfRational q = root (1 % denominator q) (numerator q * denominator q)
