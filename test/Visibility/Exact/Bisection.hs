-- | Roots as specs find them, by a way that the library does not go.
module Visibility.Exact.Bisection
  ( bisected
  ) where

-- | The integer square root by bisection.
bisected :: Integer -> Integer
bisected n = go 0 (n + 1)
  where
    go a b
      | b - a <= 1 = a
      | c * c <= n = go c b
      | otherwise = go a c
      where
        c = (a + b) `div` 2
