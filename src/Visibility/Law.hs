-- | A law that does not hold: a value for those who check laws, and an exception where going on would give a wrong
-- result.
module Visibility.Law
  ( Violation (..)
  , broken
  , ensure
  ) where

import Control.Exception (Exception (..), throw)

-- | A law of a data structure or of the scene's complex that does not hold, and what was found, with all that is needed
-- to see it again. Never the fault of the input.
data Violation = Violation
  { violatedLaw :: !String
  , violationDetails :: !String
  }
  deriving (Eq, Ord, Show)

instance Exception Violation where
  displayException (Violation law details) =
    "an internal law is broken, which is an error of this program: " <> law <> "\n" <> details

-- | Stops with a broken law. The program ends with exit code 70.
broken :: String -> String -> a
broken law details = throw (Violation law details)

-- | The violation of a law, if what it says is false.
ensure :: String -> String -> Bool -> [Violation]
ensure _ _ True = []
ensure law details False = [Violation law details]
