-- | What the command line says.
module Options
  ( readCommand
  ) where

import Data.List (intercalate)
import Options.Applicative
import Options.Applicative.Common (runParserInfo)
import Options.Applicative.Help (renderHelp)
import Options.Applicative.Internal (runP)
import Options.Applicative.Types (Context (..))
import Options.Manual
import Options.Reader (meant)
import Options.Table
import Output (complain, ends)
import System.Environment (getArgs)
import System.Exit (ExitCode (..), exitSuccess)
import System.IO (hPutStrLn, stderr)
import Visibility.Error (Outcome (WrongUsage))

-- | Reads what the arguments ask for. A mistake in them ends the program with exit code 1: what is wrong, and the usage
-- line of the command.
readCommand :: IO (IO ())
readCommand = getArgs >>= commandOf

commandOf :: [String] -> IO (IO ())
commandOf arguments = case execParserPure preferences everything arguments of
  Success (Left (Explain wanted)) -> commandOf (wanted <> ["--help"])
  Success (Right wanted) -> pure wanted
  Success (Left (Mistake contexts wrong)) -> refused contexts (ErrorMsg wrong)
  Failure _ | (Left wrong, contexts) <- runP (runParserInfo everything arguments) preferences -> refused contexts wrong
  other -> handleParseResult other >> exitSuccess
  where
    everything = whole manual
    preferences = prefs noBacktrack
    refused contexts wrong = case execFailure failure program of
      (answer, code, width) | null arguments || code /= ExitSuccess -> do
        let (messages, usage) = mistakeText path width answer
        complain messages
        hPutStrLn stderr usage
        ends WrongUsage
      _ -> handleParseResult (Failure failure)
      where
        failure = parserFailure preferences everything (told path (optionsHere contexts) wrong) contexts
        path = reverse [name | Context name _ <- contexts]
    optionsHere contexts = case contexts of
      Context _ here : _ -> optionNames here
      [] -> optionNames everything

program :: String
program = "viscomplex"

-- Where and what is wrong, and how to call it right. Without any arguments, all of the help.
mistakeText :: [String] -> Int -> ParserHelp -> ([String], String)
mistakeText path width answer = case shown mempty {helpError = helpError answer} of
  "" -> ([], shown answer)
  wrong -> ([intercalate ": " ([unwords path | not (null path)] <> [wrong])], "\n" <> usage <> "\n\n" <> more)
  where
    shown = renderHelp width
    usage = shown mempty {helpUsage = helpUsage answer}
    more = "'" <> unwords ([program, "help"] <> path) <> "' explains it."

-- What is wrong, in more words than those of the parser.
told :: [String] -> [String] -> ParseError -> ParseError
told path options wrong = case (wrong, choices) of
  (UnexpectedError word _, _) | '-' : _ : _ <- word -> ErrorMsg (unknown "option" (takeWhile (/= '=') word) options)
  (UnexpectedError word _, Just (kind, entries)) -> ErrorMsg (unknown kind word (map fst entries))
  (UnexpectedError word _, Nothing) -> ErrorMsg ("an argument too many: " <> word)
  (MissingError _ _, Just (kind, entries)) | not (null path) ->
    ErrorMsg ("give a " <> kind <> ": " <> intercalate ", " (map fst entries))
  (MissingError _ _, Just _) -> ShowHelpText Nothing
  _ -> wrong
  where
    choices = case path of
      [] -> Just ("command", commands)
      ["draw"] -> Just ("figure", figures)
      _ -> Nothing
    unknown kind word known = "unknown " <> kind <> " " <> word <> case (owners word, choices) of
      ([], _) -> meant word known
      (_, Just (chosen, _)) -> "; options come after the " <> chosen
      (others, Nothing) -> "; it is an option of " <> intercalate ", " others
    owners word = [unwords names | (names, here) <- leaves, word `elem` optionNames here]
