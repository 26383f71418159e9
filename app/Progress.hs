{-# LANGUAGE BangPatterns #-}

-- | A line on the terminal that says how far long work has come. It is shown by cbits/progress.c.
module Progress
  ( Talk (..)
  , watching
  , stage
  , counting
  ) where

import Data.Word (Word64)
import Foreign.C (CInt (..), CString, newCString)
import Foreign.Ptr (Ptr)
import Foreign.Storable (poke)
import System.IO.Unsafe (unsafeInterleaveIO)

foreign import ccall unsafe "viscomplex_watch" watch :: IO ()

foreign import ccall unsafe "viscomplex_is_watched" isWatched :: IO CInt

foreign import ccall "&viscomplex_work" workShown :: Ptr CString

foreign import ccall "&viscomplex_done" doneShown :: Ptr Word64

-- | What is said on standard error besides errors.
data Talk
  = -- | Progress on a terminal, and warnings.
    Talkative
  | Quiet

-- | On a terminal, if that is wanted, each second what is being done is shown from now on, until something else is
-- written to the terminal or the program ends.
watching :: Talk -> IO ()
watching Talkative = watch
watching Quiet = pure ()

-- | Says what is done from now on.
stage :: String -> IO ()
stage what = newCString what >>= poke workShown >> poke doneShown 0

-- | The same list, which says while it is consumed how much of it has been, each item counting as much as the function
-- says. It is read lazily, as standard input would be, so that memory stays what the consumer needs.
counting :: String -> (a -> Int) -> [a] -> IO [a]
counting what amount items = do
  watched <- isWatched
  name <- newCString what
  if watched == 0 then pure items else from name 0 items
  where
    from name !done rest = unsafeInterleaveIO $ case rest of
      [] -> pure []
      item : more -> do
        poke workShown name
        poke doneShown (fromIntegral done)
        (item :) <$> from name (done + amount item) more
