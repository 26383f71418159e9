-- | Whose view is asked for.
module Options.View
  ( From (..)
  , ViewOptions (..)
  , place
  , viewOptions
  ) where

import Options.Applicative
import Options.Factors (detailOption, digitsOption)
import Options.Reader
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.Predicate (Direction)
import Visibility.Exact.Rounding (Digits)
import Visibility.Format.Factors (Detail (..))
import Visibility.Scene (CornerName (..), SideName (..))

-- | Whose view is asked for.
data From
  = -- | A point, with the normal of an element there.
    FromPoint !Point !(Maybe Direction)
  | FromCorner !CornerName !(Maybe Direction)
  | FromSide !SideName

data ViewOptions = ViewOptions
  { viewFrom :: !From
  , viewDigits :: !Digits
  , viewDetail :: !Detail
  }

-- | Where one looks from, if that is said, or what is wrong with it.
place :: Parser (Either String (Maybe From))
place = combined <$> point <*> corner <*> side <*> normal
  where
    point =
      optional . option pairReader $
        long "from" <> metavar "X,Y" <> help "A point in free space or on a boundary: exact numbers, as in files."
    corner = named CornerName "corner" "P.K" "A corner, such as 3.0 or E.2."
    side = named SideName "side" "P.S" "A side, such as 3.0 or E.2."
    normal =
      optional . option directionReader $
        long "normal" <> metavar "DX,DY" <> help "Form factors of a small element that faces this way; no --side."
    named make name shape purpose =
      optional (option (nameReader make) (long name <> metavar shape <> help purpose))
    combined (Just (x, y)) Nothing Nothing facing = Right (Just (FromPoint (Point x y) facing))
    combined Nothing (Just name) Nothing facing = Right (Just (FromCorner name facing))
    combined Nothing Nothing (Just name) Nothing = Right (Just (FromSide name))
    combined Nothing Nothing (Just _) (Just _) = Left "--normal goes with --from or --corner, not with --side"
    combined Nothing Nothing Nothing (Just _) = Left "--normal needs --from X,Y or --corner P.K"
    combined Nothing Nothing Nothing Nothing = Right Nothing
    combined _ _ _ _ = Left "give one of --from, --corner and --side, not more"

viewOptions :: Parser (Either String ViewOptions)
viewOptions = complete <$> place <*> digitsOption <*> detailOption
  where
    complete from wanted detail = from >>= maybe (Left nowhere) (\known -> Right (ViewOptions known wanted detail))
    nowhere = "view needs --from X,Y, --corner P.K or --side P.S"
