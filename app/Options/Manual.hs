-- | The manual page, from the table of commands.
module Options.Manual
  ( manual
  , leaves
  , optionNames
  ) where

import Data.List (intercalate)
import Options.Applicative
import Options.Applicative.Common (mapParser)
import Options.Applicative.Help.Chunk (Chunk (..))
import Options.Applicative.Types (OptName (..), OptReader (..), optHelp, optMain, optMetaVar)
import Options.Table

-- | All commands and figures that take a scene or a family, each with its words.
leaves :: [([String], ParserInfo (Either Instead (IO ())))]
leaves =
  [([name], here) | (name, here) <- commands, name /= "draw"] <> [(["draw", name], here) | (name, here) <- figures]

-- | The options that a command takes, each spelled in all ways.
optionNames :: ParserInfo a -> [String]
optionNames here = "--help" : "-h" : concat [names | (names, _, _) <- argumentsOf here]

-- What a command takes: the names of an option, none of an argument; what stands for a value; and the help.
argumentsOf :: ParserInfo a -> [([String], String, String)]
argumentsOf = mapParser (\_ o -> (namesOf (optMain o), optMetaVar o, running (optHelp o))) . infoParser
  where
    namesOf :: OptReader b -> [String]
    namesOf reader = case reader of
      OptReader names _ _ -> map spelled names
      FlagReader names _ -> map spelled names
      _ -> []
    spelled (OptLong name) = "--" <> name
    spelled (OptShort c) = ['-', c]

-- In one line.
running :: Show a => Chunk a -> String
running = unwords . words . text

text :: Show a => Chunk a -> String
text = maybe "" show . unChunk

-- | In the language of man, for all commands. What all commands on a scene take is said once.
manual :: String
manual = intercalate "\n" (heading <> concatMap section leaves <> [".SH EXAMPLES"] <> asItIs (infoFooter everything))
  where
    everything = whole ""
    shared = concat [argumentsOf here | (name, here) <- commands, name == "info"]
    heading =
      [ ".TH VISCOMPLEX 1 \"\" \"" <> versionText <> "\""
      , ".SH NAME"
      , "viscomplex \\- " <> escaped (drop (length "viscomplex: ") (text (infoHeader everything)))
      , ".SH SYNOPSIS"
      , "\\fBviscomplex\\fR \\fICOMMAND\\fR [\\fIARGUMENTS\\fR]"
      , ".SH DESCRIPTION"
      , escaped (running (infoProgDesc everything))
      , ".SH OPTIONS OF ALL COMMANDS ON A SCENE"
      ]
        <> concatMap described shared
        <> [".SH OTHER OPTIONS"]
        <> concatMap described [option' | option'@(_ : _, _, _) <- argumentsOf everything]
        <> [".SH COMMANDS"]
    section (path, here) =
      [".SS " <> unwords (path <> [shape | ([], shape, _) <- argumentsOf here]), escaped (running (infoProgDesc here))]
        <> concatMap described (filter (`notElem` shared) (argumentsOf here))
        <> asItIs (infoFooter here)
    described (names, shape, purpose) =
      [ ".TP"
      , unwords (filter (/= "") [styled "B" (intercalate ", " names), styled "I" shape])
      , escaped purpose
      ]
    styled font word = if null word then "" else "\\f" <> font <> escaped word <> "\\fR"
    asItIs lines' = [".PP", ".nf"] <> map escaped (lines (text lines')) <> [".fi"]

-- No letter of a text means anything to man.
escaped :: String -> String
escaped line = (if take 1 line `elem` [".", "'"] then "\\&" else "") <> concatMap one line
  where
    one c = case c of
      '\\' -> "\\e"
      '-' -> "\\-"
      _ -> [c]
