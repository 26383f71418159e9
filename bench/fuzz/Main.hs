-- | Looks for files that the readers, the check of scenes or the sweep treat wrongly: @fuzz SECONDS SEED OUT FILE …@
-- changes the given files at random and keeps each result that reaches a part of the program that none has reached,
-- or reaches it more often by a power of two. What is reached is told by the boxes of hpc, so this program must be
-- compiled with @-fhpc@.
--
-- Of each file it asks that an answer comes within two seconds and is a documented one, and of each small scene that
-- the sweep finds what brute force finds. New files go to @OUT/corpus@, each as small as it was found to be, and those
-- that fail to @OUT/findings@; the exit status is 1 if there are any.
module Main (main) where

import Control.Exception (SomeException, evaluate, try)
import Control.Monad (filterM, foldM, unless, when)
import Data.Bits (popCount, setBit, testBit)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Chars
import Data.ByteString (ByteString)
import Data.Char (isDigit)
import Data.IORef
import Data.List (isPrefixOf, sort, sortOn)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed.Mutable as M
import Data.Word (Word8)
import GHC.Clock (getMonotonicTime)
import Numeric (showHex)
import System.Directory (createDirectoryIfMissing)
import System.Environment (getArgs)
import System.Exit (exitFailure)
import System.FilePath (takeExtension, (<.>), (</>))
import System.IO
import System.Random.SplitMix
import System.Timeout (timeout)
import Text.Read (readMaybe)
import Trace.Hpc.Reflect (clearTix, examineTix)
import Trace.Hpc.Tix (Tix (..), TixModule (..))
import Visibility.Error (Problem (..), errorText)
import Visibility.Format.File (readSceneBytes)
import Visibility.Scene
import Visibility.Scene.Validate (validate)
import Visibility.Sweep (vertices)
import Visibility.Test.BruteForce (bruteForce)

-- | A file by what it holds and the ending that tells its format.
data Input = Input {inputEnding :: !String, inputBytes :: !ByteString}

main :: IO ()
main = do
  arguments <- getArgs
  case arguments of
    seconds : seed : out : files | Just s <- readMaybe seconds, Just g <- readMaybe seed, not (null files) -> do
      hSetBuffering stdout LineBuffering
      inputs <- mapM (\file -> Input (takeExtension file) <$> Bytes.readFile file) files
      fuzz s (mkSMGen g) out inputs
    _ -> hPutStrLn stderr "fuzz SECONDS SEED OUT FILE …" >> exitFailure

-- | What a run has found: the inputs that reached something new, and those that fail.
data Found = Found {foundInputs :: !(V.Vector Input), foundFailing :: ![(Input, String)]}

fuzz :: Double -> SMGen -> FilePath -> [Input] -> IO ()
fuzz seconds gen out given = do
  begun <- getMonotonicTime
  boxes <- length <$> ticks
  seen <- M.replicate boxes 0
  runs <- newIORef (0 :: Int)
  -- Smaller files first, so that of two that reach the same the smaller one stays.
  start <- foldM (tried runs seen 0) (Found V.empty []) (sortOn (Bytes.length . inputBytes) given)
  reached <- countBits seen
  let loop g found = do
        now <- getMonotonicTime
        if now - begun > seconds then pure found else do
          let (input, g') = mutant (foundInputs found) g
          tried runs seen 200 found input >>= loop g'
  found <- loop gen start
  done <- readIORef runs
  ended <- getMonotonicTime
  after <- countBits seen
  let new = V.toList (V.drop (V.length (foundInputs start)) (foundInputs found))
  mapM_ (uncurry (written (out </> "corpus"))) [(input, "") | input <- new]
  mapM_ (uncurry (written (out </> "findings"))) (foundFailing found)
  putStrLn (show done <> " files in " <> show (round (ended - begun) :: Int) <> " s; " <> show boxes
    <> " boxes, of which " <> show reached <> " counts were reached by the given files and " <> show after <> " at the end; "
    <> show (length new) <> " new files, " <> show (length (foundFailing found)) <> " findings.")
  unless (null (foundFailing found)) exitFailure

-- | Runs the input, and keeps it if it reaches something new, as small as so many tries make it, or if it fails.
tried :: IORef Int -> M.IOVector Word8 -> Int -> Found -> Input -> IO Found
tried runs seen budget found input = do
  (verdict, new) <- run input
  case verdict of
    Just reason -> pure found {foundFailing = (input, reason) : foundFailing found}
    Nothing | null new -> pure found
    Nothing -> do
      small <- smaller new (max 1 (Bytes.length (inputBytes input) `div` 2)) 0 budget input
      _ <- run small >>= mapM_ mark . snd
      mapM_ mark new
      pure found {foundInputs = V.snoc (foundInputs found) small}
  where
    mark :: (Int, Int) -> IO ()
    mark (box, bit) = M.modify seen (`setBit` bit) box
    run one = do
      modifyIORef' runs (+ 1)
      clearTix
      verdict <- wrong one
      counts <- ticks
      new <- filterM (\(box, bit) -> not . (`testBit` bit) <$> M.read seen box)
        [(box, bucket n) | (box, n) <- zip [0 ..] counts, n > 0]
      pure (verdict, new)
    -- Leaves out stretches of this length from this place on, as long as the same new boxes are reached.
    smaller new size at left one
      | left == 0 || size == 0 = pure one
      | at >= Bytes.length (inputBytes one) = smaller new (size `div` 2) 0 left one
      | otherwise = do
          let bytes = inputBytes one
              less = one {inputBytes = Bytes.take at bytes <> Bytes.drop (at + size) bytes}
          (verdict, reached) <- run less
          if verdict == Nothing && all (`elem` reached) (take 50 new)
            then smaller new size at (left - 1) less
            else smaller new size (at + size) (left - 1) one

-- | How often a box was reached, by powers of two.
bucket :: Integer -> Int
bucket n = min 7 (length (takeWhile (<= n) (iterate (* 2) 2)))

countBits :: M.IOVector Word8 -> IO Int
countBits seen = sum <$> mapM (fmap popCount . M.read seen) [0 .. M.length seen - 1]

-- | How often each box of the program's own modules was reached.
ticks :: IO [Integer]
ticks = do
  Tix modules <- examineTix
  pure (concat [counts | TixModule name _ _ counts <- modules, "Visibility" `isPrefixOf` name
                       , not ("Visibility.Test" `isPrefixOf` name)])

-- | What is wrong with the program's answer to a file.
wrong :: Input -> IO (Maybe String)
wrong (Input ending bytes) = do
  answer <- timeout 2000000 (try (evaluate (verdict (readSceneBytes ("fuzz" <> ending) bytes))))
  pure $ case answer of
    Nothing -> Just "no answer within two seconds"
    Just (Left fault) -> Just ("an exception: " <> takeWhile (/= '\n') (show (fault :: SomeException)))
    Just (Right reason) -> reason
  where
    verdict (Left problems) = said (foldMap (\p -> errorText p <> "\n") problems)
    verdict (Right raw) = case validate raw of
      Left errors -> said (foldMap (\e -> errorText (InvalidScene "fuzz" e) <> "\n") errors)
      Right scene
        | cornerCount scene > 200 -> Nothing
        | cornerCount scene > 24 -> length (vertices scene) `seq` Nothing
        | sort (vertices scene) == bruteForce scene -> Nothing
        | otherwise -> Just "the sweep and brute force differ"
    -- A message of more than a hundred kilobytes serves nobody.
    said text
      | any null (lines text) = Just "an empty message"
      | length text > 100000 = Just "messages of more than 100 000 characters"
      | otherwise = Nothing

-- | A file of those given, changed in a few places.
mutant :: V.Vector Input -> SMGen -> (Input, SMGen)
mutant inputs g0 = (Input (inputEnding input) (Bytes.take 20000 bytes), g3)
  where
    (i, g1) = below (V.length inputs) g0
    input = inputs V.! i
    (times, g2) = below 4 g1
    (bytes, g3) = iterate change (inputBytes input, g2) !! (times + 1)
    change (b, g) = let (k, g') = below 9 g in changed k b g'
    other g = let (k, g') = below (V.length inputs) g in (inputBytes (inputs V.! k), g')
    changed :: Int -> ByteString -> SMGen -> (ByteString, SMGen)
    changed k b g = case k of
      0 -> (spliced b at 1 (Bytes.singleton (fromIntegral r)), g'')
      1 -> (spliced b at 0 (tokens V.! (r `mod` V.length tokens)), g'')
      2 -> (spliced b at r Bytes.empty, g'')
      3 -> (spliced b at 0 (Bytes.take r (Bytes.drop at b)), g'')
      4 ->
        let (o, g3') = other g''
         in (Bytes.take at b <> Bytes.drop (Bytes.length o * at `div` (Bytes.length b + 1)) o, g3')
      5 -> (onNumber (const (extremes V.! (r `mod` V.length extremes))), g'')
      -- Equal numbers make corners and lines fall together.
      6 -> (onNumber (const (numberAt (r * Bytes.length b `div` 64))), g'')
      7 -> (onNumber (\n -> Chars.pack (show (whole n + fromIntegral (r `mod` 5) - 2))), g'')
      _ -> (spliced b at (Bytes.length (tokens V.! 0)) (tokens V.! (r `mod` V.length tokens)), g'')
      where
        (at, g') = below (Bytes.length b + 1) g
        (r, g'') = below 64 g'
        onNumber f = case numberFrom at of
          (_, 0) -> b
          (from, size) -> spliced b from size (f (Bytes.take size (Bytes.drop from b)))
        numberAt p = let (from, size) = numberFrom p in Bytes.take size (Bytes.drop from b)
        -- The number that begins at the place or next after it.
        numberFrom p =
          let from = p + Chars.length (Chars.takeWhile (not . isDigit) (Bytes.drop p b))
           in (from, Chars.length (Chars.takeWhile isDigit (Bytes.drop from b)))
    whole n = maybe 0 fst (Chars.readInteger n)
    spliced b at size new = Bytes.take at b <> new <> Bytes.drop (at + size) b
    below :: Int -> SMGen -> (Int, SMGen)
    below n g = let (w, g') = bitmaskWithRejection64 (fromIntegral (max 1 n)) g in (fromIntegral w, g')

tokens :: V.Vector ByteString
tokens = V.fromList (map Chars.pack
  [ "[", "]", "{", "}", ",", ":", "\"", "null", "true", "\\u", "\\ud800", "\"polygons\":", "\"enclosure\":", "\"wall\":"
  , "\"corners\":", "\"sides\":", "\"reflectivity\":", "\"emission\":", "\"type\":", "\"Feature\"", "\"Polygon\""
  , "\"LineString\"", "\"MultiPolygon\"", "\"GeometryCollection\"", "\"coordinates\":", "\"properties\":", "POLYGON "
  , "LINESTRING ", "EMPTY", "(", ")", "((", "))", ", ", "/", "-", "e", ".", "[0,0]", "[1,1],", " ", "\n", "\r\n"
  , "\xEF\xBB\xBF", "\xFF", "\xC3" ])

extremes :: V.Vector ByteString
extremes = V.fromList (map Chars.pack
  [ "0", "1", "-1", "2147483647", "2147483648", "4294967296", "9223372036854775807", "9223372036854775808"
  , "18446744073709551616", "1e400", "1e-400", "1e401", "\"1/3\"", "\"-7/00\"", replicate 300 '9', "0.1", "1e22"
  , "-0" ])

written :: FilePath -> Input -> String -> IO ()
written folder (Input ending bytes) reason = do
  createDirectoryIfMissing True folder
  let digest = Bytes.foldl' (\h c -> (h * 31 + fromIntegral c) `mod` 4294967311) 7 bytes :: Integer
      name = folder </> showHex digest "" <.> drop 1 ending
  Bytes.writeFile name bytes
  when (reason /= "") $ putStrLn (name <> ": " <> reason)
