-- | What the system says when it refuses, in plain words.
module Visibility.Error.System
  ( systemText
  ) where

import Data.Maybe (fromMaybe)
import Foreign.C.Error
import GHC.IO.Exception (IOErrorType (..), IOException (..))
import System.IO.Error (ioeGetErrorString)

-- | Why something could not be read or written; words of the system only where there are none of ours.
systemText :: IOException -> String
systemText fault = fromMaybe (ioeGetErrorString fault) (known (ioe_errno fault) (ioe_type fault))
  where
    known (Just code) _ = lookup (Errno code) texts
    -- The base library tells these by itself.
    known Nothing InappropriateType = lookup eISDIR texts
    known Nothing IllegalOperation = lookup eBADF texts
    known Nothing _ = Nothing
    texts =
      [ (eNOENT, "there is no such file or folder")
      , (eNOTDIR, "a part of the path is no folder")
      , (eISDIR, "it is a folder")
      , (eACCES, "permission is denied")
      , (ePERM, "permission is denied")
      , (eROFS, "the file system can only be read")
      , (eNOSPC, "no space is left")
      , (eDQUOT, "the quota of space is used up")
      , (eFBIG, "the file would be larger than is allowed")
      , (eNAMETOOLONG, "the name is too long")
      , (eLOOP, "symbolic links lead in a circle")
      , (eMFILE, "too many files are open")
      , (eNFILE, "too many files are open")
      , (eTXTBSY, "it is a program that is running")
      , (eBUSY, "it is in use")
      , (eIO, "the device failed")
      , (eNXIO, "there is no such device")
      , (eNODEV, "there is no such device")
      , (ePIPE, "nobody reads it any longer")
      , (eBADF, "it is closed")
      , (eNOMEM, "the system has no memory left")
      ]
