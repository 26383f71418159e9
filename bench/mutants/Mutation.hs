-- | Small faults in Haskell sources, found by looking at their words: no type is known, so some do not compile.
module Mutation
  ( Kind
  , Mutant (..)
  , mutants
  , mutated
  ) where

import Data.Char
import Data.List (isPrefixOf, tails)

-- | What is changed.
data Kind
  = -- | A comparison, a connective, an operator of arithmetic.
    Operator
  | -- | A word for its opposite.
    Opposite
  | -- | A number for the next one.
    Next
  | -- | Two arguments for each other.
    Arguments
  | -- | A case that is never taken, or a condition that always or never holds.
    Condition
  | -- | A statement left out.
    Statement
  | -- | A constant for an expression.
    Constant
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | What to put in the place of some characters of a source, from one on and so many.
data Mutant = Mutant {mutantKind :: Kind, mutantFrom :: Int, mutantLength :: Int, mutantText :: String}
  deriving (Eq, Ord, Show)

mutated :: Mutant -> String -> String
mutated (Mutant _ from size new) source = take from source <> new <> drop (from + size) source

-- | All that are known of a source, from its beginning to its end.
mutants :: String -> [Mutant]
mutants = concatMap mutantsAt . tails . (Token Other "" 0 0 0 :) . computing . tokens

-- | Those of the second token, given what stands before it.
mutantsAt :: [Token] -> [Mutant]
mutantsAt (before : t : after) = concat
  [ [ changed Operator new | shape t == Sign, isBinary, Just news <- [lookup (text t) operators], new <- news ]
  , [ changed Opposite new | (old, new) <- opposites, old == text t ]
  , [ changed Next (show (read (text t) + 1 :: Integer)) | shape t == Number ]
  , [ Mutant Arguments (begin a) (end b - begin a) (text b <> " " <> text a)
    | isWord t, a : b : _ <- [after], all isArgument [a, b], all ((== line t) . line) [a, b], text a /= text b ]
  , [ mutant | text t == "|", mutant <- guardMutants (spanned ["=", "->"] after) ]
  , [ over Condition condition new | text t == "if", condition <- spanned ["then"] after, new <- ["True", "False"] ]
  , [ over Condition (atom after) "True" | text t == "when" ]
  , [ over Condition (atom after) "False" | text t == "unless" ]
  , [ over Statement statement "pure ()"
    | text t `elem` effects, isFirst, column t > 0, let statement = t : takeWhile ((> column t) . column) after ]
  , [ over Constant group "0"
    | text t == "(", group@(_ : _ : _ : _) <- [atom (t : after)], any ((`elem` ["+", "-", "*"]) . text) (level group)
    , all ((`notElem` [",", "->", "<-", "="]) . text) (level group) ]
  ]
  where
    isBinary = end before < begin t && shape before `notElem` [Sign, Bracket] || text before `elem` [")", "]"]
    isFirst = line before /= line t
    changed kind = Mutant kind (begin t) (length (text t))
    over kind part = Mutant kind (begin (head' part)) (end (last part) - begin (head' part))
    head' = foldr const t
    guardMutants condition = case concat condition of
      first : more
        | text first /= "otherwise" -> Mutant Condition (begin first) 0 "False, "
            : [over Condition (first : more) "True" | all ((/= "<-") . text) (first : more)]
      _ -> []
mutantsAt _ = []

operators :: [(String, [String])]
operators =
  [ ("<", ["<="]), ("<=", ["<"]), (">", [">="]), (">=", [">"]), ("==", ["/="]), ("/=", ["=="])
  , ("&&", ["||"]), ("||", ["&&"]), ("+", ["-"]), ("-", ["+"]), ("*", ["+"])
  ]

-- | Words for others of the same type.
opposites :: [(String, String)]
opposites =
  [("EQ", "LT"), ("Collinear", "LeftTurn"), ("Zero", "Positive"), ("not", "id"), ("negate", "id"), ("abs", "id")]
  <> concat
    [ [(a, b), (b, a)]
    | (a, b) <-
        [ ("LT", "GT"), ("LeftTurn", "RightTurn"), ("Positive", "Negative"), ("True", "False"), ("min", "max")
        , ("minimum", "maximum"), ("any", "all"), ("fst", "snd"), ("take", "drop"), ("floor", "ceiling")
        , ("Rightward", "Leftward"), ("rightTree", "leftTree"), ("rightward", "leftward"), ("earlier", "later")
        , ("first", "final"), ("top", "leaf"), ("following", "preceding"), ("edgeNode", "markerNode")
        , ("cornerList", "ceilingList"), ("Starts", "Ends"), ("OnLeft", "OnRight"), ("SolidLeft", "SolidRight")
        , ("LowerTree", "UpperTree"), ("Below", "Above"), ("crossedBelow", "crossedAbove"), ("Upwards", "Downwards")
        , ("numerator", "denominator"), ("front", "back"), ("low", "high")
        ]
    ]

-- | What changes something, or may, and gives nothing.
effects :: [String]
effects =
  [ "when", "unless", "forM_", "mapM_", "put", "putNode", "putList", "set", "setRoot", "cut", "release", "unlink"
  , "relink", "attach", "insertAfter", "separate", "advance", "writePrimArray", "M.write", "splay", "lift", "marked"
  , "sweepLine", "copyMutablePrimArray", "begins"
  ]

-- | What stands before one of these words on the level of brackets where it begins, if there is something.
spanned :: [String] -> [Token] -> [[Token]]
spanned ends = go (0 :: Int) []
  where
    go _ _ [] = []
    go depth found (t : rest)
      | depth == 0 && text t `elem` ends = [reverse found | not (null found)]
      | isOpening t || text t == "if" && ends == ["then"] = go (depth + 1) (t : found) rest
      | isClosing t || text t == "then" && ends == ["then"] = if depth == 0 then [] else go (depth - 1) (t : found) rest
      | otherwise = go depth (t : found) rest

-- | A word, or what a bracket encloses with it, at the beginning.
atom :: [Token] -> [Token]
atom (t : rest) | isOpening t = t : go (1 :: Int) rest
  where
    go 0 _ = []
    go depth (u : more) = u : go (if isOpening u then depth + 1 else if isClosing u then depth - 1 else depth) more
    go _ [] = []
atom ts = take 1 ts

-- | What stands between the outer brackets, and not within others.
level :: [Token] -> [Token]
level = go (0 :: Int)
  where
    go depth (t : rest)
      | isOpening t = go (depth + 1) rest
      | isClosing t = go (depth - 1) rest
      | depth == 1 = t : go depth rest
      | otherwise = go depth rest
    go _ [] = []

data Shape = Lower | Upper | Sign | Number | Bracket | Other
  deriving (Eq)

-- | A word of a source; it begins after so many characters, lines, and characters of its line.
data Token = Token {shape :: Shape, text :: String, begin, line, column :: Int}

end :: Token -> Int
end t = begin t + length (text t)

isWord, isVariable, isArgument, isOpening, isClosing :: Token -> Bool
isWord t = shape t == Upper || isVariable t
isVariable t = shape t == Lower && text t `notElem` reserved
-- What is passed on everywhere has no argument of its type beside it.
isArgument t = isVariable t
  && text t `notElem` ["f", "o", "tree", "state", "scan", "scene", "plane", "status", "points", "table"]
isOpening t = text t `elem` ["(", "[", "{"]
isClosing t = text t `elem` [")", "]", "}"]

reserved :: [String]
reserved = ["if", "then", "else", "let", "in", "where", "case", "of", "do", "instance", "deriving", "otherwise"]

-- | Without declarations and signatures.
computing :: [Token] -> [Token]
computing [] = []
computing (t : rest)
  | isDeclared || isSignature (t : rest) = computing (dropWhile ((> column t) . column) rest)
  | otherwise = let (same, more) = span ((== line t) . line) rest in t : same <> computing more
  where
    isDeclared = column t == 0
      && text t `elem` ["module", "import", "data", "newtype", "type", "class", "deriving", "infix", "infixl", "infixr"]
    isSignature (a : b : more)
      | shape a == Lower && text b == "::" = True
      | shape a == Lower && text b == "," = isSignature more
    isSignature _ = False

-- | Comments are left out; strings and characters are empty.
tokens :: String -> [Token]
tokens = go 0 0 0
  where
    go _ _ _ [] = []
    go i y x s@(c : rest)
      | c == '\n' = go (i + 1) (y + 1) 0 rest
      | isSpace c = go (i + 1) y (x + 1) rest
      | "{-" `isPrefixOf` s = passed (comment (0 :: Int) s)
      | c == '-', (dashes, more) <- span isSymbol' s, all (== '-') dashes, length dashes > 1 =
          passed (dashes <> takeWhile (/= '\n') more)
      | c == '"' = passed (c : quoted rest)
      | c == '\'' = passed (c : character rest)
      | isDigit c = let word = number s in found (if all isDigit word then Number else Other) word
      | isAlpha c || c == '_' = let word = name s in found (if isUpper (firstOfLast word) then Upper else Lower) word
      | isSymbol' c = found Sign (takeWhile isSymbol' s)
      | otherwise = found Bracket [c]
      where
        found kind word = Token kind word i y x : passed word
        passed word = go (i + length word) (y + newlines word) (column' word) (drop (length word) s)
        newlines = length . filter (== '\n')
        column' word = if newlines word == 0 then x + length word else length (takeWhile (/= '\n') (reverse word))
    comment depth s = case s of
      '{' : '-' : more -> "{-" <> comment (depth + 1) more
      '-' : '}' : more -> "-}" <> if depth == 1 then "" else comment (depth - 1) more
      a : more -> a : comment depth more
      [] -> []
    quoted s = case s of
      '\\' : a : more -> '\\' : a : quoted more
      '"' : _ -> "\""
      a : more -> a : quoted more
      [] -> []
    character s = case s of
      '\\' : a : more -> '\\' : a : takeWhile (/= '\'') more <> "'"
      a : _ -> [a, '\'']
      [] -> []
    number s = case span isAlphaNum s of
      (word@('0' : 'x' : _), '-' : more) -> word <> "-" <> takeWhile isDigit more
      (word, _) -> word
    name s = case span isNameChar s of
      (word@(a : _), '.' : more@(b : _)) | isUpper a, isAlpha b -> word <> "." <> name more
      (word, _) -> word
    firstOfLast word = case break (== '.') word of
      (a : _, "") -> a
      (_, _ : more) -> firstOfLast more
      _ -> '_'
    isNameChar a = isAlphaNum a || a == '_' || a == '\''
    isSymbol' a = a `elem` "!#$%&*+./<=>?@\\^|-~:" || not (isAscii a) && (isSymbol a || isPunctuation a)
