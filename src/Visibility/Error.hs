-- | All that can be wrong with input, its text, and the exit code of each case.
--
-- A text has the form @FILE: PLACE: WHAT IS WRONG; WHAT WOULD BE RIGHT@. The place is a line and column, a JSON path,
-- or a polygon with its corner or side as the file counts them.
module Visibility.Error
  ( -- * Problems of a file
    Problem (..)
  , errorText
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
  , problemsOutcome
  ) where

import Data.Foldable (toList)
import Data.List.NonEmpty (NonEmpty)
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
errorText problem = case problem of
  UnreadableFile file fault -> file <> ": " <> readText fault
  UnparseableFile file fault -> file <> ": " <> parseErrorText fault
  InvalidScene file fault -> file <> ": " <> sceneErrorText fault

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

-- | The earliest failure decides: an unreadable file before an unparseable one before an invalid one.
problemsOutcome :: NonEmpty Problem -> Outcome
problemsOutcome = minimum . map problemOutcome . toList
