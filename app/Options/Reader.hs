-- | Readers of words of the command line.
module Options.Reader
  ( oneOf
  , wholeNumber
  , countOf
  , pairReader
  , directionReader
  , nameReader
  ) where

import Data.Char (isDigit)
import Data.List (intercalate)
import Data.Ratio (denominator, numerator)
import qualified Data.Text as Text
import Options.Applicative (ReadM, eitherReader, readerError)
import Text.Read (readMaybe)
import Visibility.Error (numberFaultText)
import Visibility.Exact.Predicate (Direction (..), primitive)
import Visibility.Format.Number (readNumber)
import Visibility.Scene (CornerName (..), PolygonId, readCornerName)

-- | One of some words; another one is answered with the list.
oneOf :: [(String, a)] -> ReadM a
oneOf choices = eitherReader $ \word -> case lookup word choices of
  Just choice -> Right choice
  Nothing -> Left (word <> " is none of: " <> intercalate ", " (map fst choices))

-- | A number in decimal digits, within bounds; the name is that of what is counted.
wholeNumber :: String -> Integer -> Integer -> String -> Either String Integer
wholeNumber name least greatest word = case readMaybe word of
  Just n | not (null word), all isDigit word, least <= n, n <= greatest -> Right n
  _ -> Left (name <> ": " <> show word <> " is not a whole number from " <> show least <> " to " <> show greatest)

-- | What is made of a number from 1 to a greatest one.
countOf :: String -> Integer -> (Int -> Maybe a) -> String -> Either String a
countOf name greatest make word =
  wholeNumber name 1 greatest word >>= maybe (Left (name <> ": give 1 or more")) Right . make . fromInteger

-- | Two exact numbers with a comma between them.
pairReader :: ReadM (Rational, Rational)
pairReader = eitherReader $ \word -> case break (== ',') word of
  (x, ',' : y) | ',' `notElem` y -> (,) <$> number x <*> number y
  _ -> Left (word <> " is not a pair such as 1/2,3")
  where
    number word = either (Left . (show word <>) . numberFaultText) Right (readNumber (Text.pack word))

directionReader :: ReadM Direction
directionReader = pairReader >>= direct
  where
    direct (0, 0) = readerError "the normal 0,0 has no direction"
    direct (x, y) =
      let scale = denominator x * denominator y
       in pure (primitive (Direction (scaled scale x) (scaled scale y)))
    scaled scale q = numerator q * (scale `div` denominator q)

-- | The name of a corner or a side; both are spelled alike.
nameReader :: (PolygonId -> Int -> a) -> ReadM a
nameReader make = eitherReader $ \word -> case readCornerName word of
  Just (CornerName polygon k) -> Right (make polygon k)
  Nothing -> Left (word <> " is not a name such as 3.0 or E.2")
