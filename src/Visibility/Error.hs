{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE MagicHash #-}

-- | All that can be wrong with input, its text, and the exit code of each case.
--
-- A text has the form @FILE: PLACE: WHAT IS WRONG; WHAT WOULD BE RIGHT@. The place is a line and column, a JSON path,
-- or a polygon with its corner or side as the file counts them.
module Visibility.Error
  ( -- * Problems of a file
    Problem (..)
  , errorText
  , briefly
    -- ** It cannot be read
  , ReadFault (..)
  , systemText
    -- ** It cannot be parsed
  , module Visibility.Error.Parse
    -- ** It states no valid scene
  , module Visibility.Error.Scene
    -- * Outcomes of a run
  , Outcome (..)
  , exitNumber
  , problemOutcome
  ) where

import qualified Data.IntMap.Strict as IntMap
import Data.List (sortOn)
import GHC.Exts (Int (..), dataToTag#)
import Visibility.Error.Parse
import Visibility.Error.Scene
import Visibility.Error.System

-- | Something wrong with an input file. The path is what the user called it.
data Problem
  = UnreadableFile !FilePath !ReadFault
  | UnparseableFile !FilePath !ParseError
  | InvalidScene !FilePath !SceneError
  deriving (Eq, Ord, Show)

-- | Why no bytes came.
data ReadFault
  = NoSuchFile
  | NotPermitted
  | -- | Anything else, as 'systemText' says it.
    ReadFailed !String
  deriving (Eq, Ord, Show)

-- | One line without its end.
errorText :: Problem -> String
errorText problem = problemFile problem <> ": " <> problemText problem

problemFile :: Problem -> FilePath
problemFile problem = case problem of
  UnreadableFile file _ -> file
  UnparseableFile file _ -> file
  InvalidScene file _ -> file

problemText :: Problem -> String
problemText problem = case problem of
  UnreadableFile _ fault -> readText fault
  UnparseableFile _ fault -> parseErrorText fault
  InvalidScene _ fault -> sceneErrorText fault

-- | The texts of problems in their order, at most twenty of a kind, and then of each kind how many more there are. A
-- kind is a case of what can be wrong. After a hundred thousand problems no more are looked at.
--
-- /Cost/ O(1) memory besides the problems, which may be made while they are consumed.
--
-- /Laws/ @briefly problems == map errorText problems@ if there are at most twenty of each kind.
briefly :: [Problem] -> [String]
briefly = go (0 :: Int) IntMap.empty
  where
    go !looked kinds (problem : rest)
      | looked < 100000 =
          let kind = problemKind problem
              Kind began sample count = IntMap.findWithDefault (Kind looked problem 0) kind kinds
           in [errorText problem | count < 20]
                <> go (looked + 1) (IntMap.insert kind (Kind began sample (count + 1)) kinds) rest
    go _ kinds rest =
      [ concat [problemFile sample, ": and ", among, show (count - 20), " more like this: ", cause sample, "; ", advice]
      | Kind _ sample count <- sortOn (\(Kind began _ _) -> began) (IntMap.elems kinds)
      , count > 20
      ]
      where
        (among, advice)
          | null rest = ("", "--all-errors tells all")
          | otherwise = ("at least ", "so many are enough, --all-errors tells all")
    cause = takeWhile (/= ';') . problemText

-- | When the first problem of a kind was met, which it is, and how many there are.
data Kind = Kind !Int !Problem !Int

-- | The constructor of what is wrong, by number.
problemKind :: Problem -> Int
problemKind problem = case problem of
  UnreadableFile _ fault -> I# (dataToTag# fault)
  UnparseableFile _ (SyntaxError _ fault) -> I# (dataToTag# fault)
  UnparseableFile _ (ShapeError _ fault) -> 1000 + I# (dataToTag# fault)
  InvalidScene _ fault -> I# (dataToTag# fault)

readText :: ReadFault -> String
readText fault = case fault of
  NoSuchFile -> "there is no such file; give the path of a scene, or - for standard input"
  NotPermitted -> "may not be read; give yourself permission to read it"
  ReadFailed reason -> "cannot be read (" <> reason <> "); give the path of a scene, or - for standard input"

-- | How a run ends.
data Outcome
  = Success
  | WrongUsage
  | UnreadableInput
  | UnparseableInput
  | InvalidInput
  | -- | A check found a difference.
    DifferenceFound
  | -- | More than the program is allowed.
    MemoryNeeded
  | -- | A law that holds by construction does not: an error of this program.
    LawBroken
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | The exit code.
exitNumber :: Outcome -> Int
exitNumber outcome = case outcome of
  Success -> 0
  WrongUsage -> 1
  UnreadableInput -> 2
  UnparseableInput -> 3
  InvalidInput -> 4
  DifferenceFound -> 5
  MemoryNeeded -> 6
  LawBroken -> 70

-- | How a run ends that meets this problem.
problemOutcome :: Problem -> Outcome
problemOutcome problem = case problem of
  UnreadableFile _ _ -> UnreadableInput
  UnparseableFile _ _ -> UnparseableInput
  InvalidScene _ _ -> InvalidInput
