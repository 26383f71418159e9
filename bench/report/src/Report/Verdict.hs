-- | What an arithmetic makes of a scene, against what is known to be right.
module Report.Verdict
  ( Verdict (..)
  , verdictWord
  , verdictCells
  , verdictsText
  , vertexVerdict
  , unsafeVerdict
  , differences
  ) where

import qualified Data.ByteString.Char8 as Bytes
import Data.List (intercalate, sort)
import qualified Data.Set as Set
import Report.Measure
import Report.Paper (Plan (..))
import Visibility.Law (broken)

-- | Whether a result is the right one.
data Verdict
  = Correct
  | -- | Wrong, and nothing noticed: so many are missing, and so many should not be there.
    Wrong !Int !Int
  | NoAnswer !Failure
  deriving (Eq)

verdictWord :: Verdict -> String
verdictWord verdict = case verdict of
  Correct -> "right"
  Wrong _ _ -> "wrong and nothing noticed"
  NoAnswer failure -> failureWord failure

-- | As data: the word, how many are missing and how many should not be there.
verdictCells :: Verdict -> [String]
verdictCells verdict =
  verdictWord verdict : case verdict of
    Correct -> ["0", "0"]
    Wrong missing extra -> [show missing, show extra]
    NoAnswer _ -> ["", ""]

-- | How many there are of each kind, those too that do not occur; and what is wrong in the wrong ones.
verdictsText :: [Verdict] -> String
verdictsText verdicts =
  intercalate "; " [show (amount p) <> " " <> word | (word, p) <- kinds]
    <> ". In the wrong ones "
    <> show (sum [missing | Wrong missing _ <- verdicts])
    <> " pairs are missing and "
    <> show (sum [extra | Wrong _ extra <- verdicts])
    <> " spurious."
  where
    amount p = length (filter p verdicts)
    kinds =
      [ (verdictWord Correct, (== Correct))
      , (verdictWord (Wrong 0 0), \verdict -> case verdict of Wrong _ _ -> True; _ -> False)
      , (failureWord Refused, (== NoAnswer Refused))
      , ("crashed", \verdict -> case verdict of NoAnswer (Crashed _) -> True; _ -> False)
      , (failureWord OutOfTime, (== NoAnswer OutOfTime))
      , (failureWord OutOfMemory, (== NoAnswer OutOfMemory))
      ]

-- | The verdict on items in any order, given the right ones in order; they may break a law when they are asked for.
vertexVerdict :: Ord a => [a] -> [a] -> IO Verdict
vertexVerdict truth found = do
  sorted <- ended (let list = sort found in length list `seq` list)
  pure $ case sorted of
    Nothing -> NoAnswer Refused
    Just list
      | list == truth -> Correct
      | otherwise -> uncurry Wrong (differences truth list)

-- | The verdict on the graph that unsafe arithmetic prints, in a process of its own with limits, for a scheduler.
unsafeVerdict :: Plan -> String -> FilePath -> IO Verdict
unsafeVerdict plan scheduler file = do
  printed <- runContained plan ["graph", "--arithmetic", "double", "--scheduler", scheduler, file]
  exact <- runChild plan ["graph", file]
  pure $ case (printed, exact) of
    (Failed failure, _) -> NoAnswer failure
    (Finished _ lines', Finished _ truth)
      | lines' == truth -> Correct
      | otherwise -> uncurry Wrong (differences (Bytes.lines truth) (Bytes.lines lines'))
    (_, Failed failure) -> broken "the exact graph of a scene of the report is printed" (failureWord failure <> file)

-- | How many are missing, and how many should not be there.
differences :: Ord a => [a] -> [a] -> (Int, Int)
differences truth found = (Set.size (known Set.\\ s), Set.size (s Set.\\ known))
  where
    known = Set.fromList truth
    s = Set.fromList found
