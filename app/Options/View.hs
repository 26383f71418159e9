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

-- | Whose view is asked for.
data From
  = -- | A point, with the normal of an element there.
    FromPoint !Point !(Maybe Direction)
  | FromCorner !Address !(Maybe Direction)
  | FromSide !Address

data ViewOptions = ViewOptions
  { viewFrom :: !From
  , viewDigits :: !Digits
  , viewDetail :: !Detail
  }

-- | Where one looks from, or what is wrong with what is said of it.
place :: Parser (Either String From)
place = combined <$> point <*> corner <*> side <*> normal
  where
    point = optional (given (pair "X,Y") "from" "A point in free space or on a boundary, in the scene's unit." needed)
    corner = optional (given (address "K") "corner" "A corner." needed)
    side = optional (given (address "S") "side" "A side." needed)
    normal =
      optional $
        given
          (direction "DX,DY")
          "normal"
          "Form factors of a small element that faces this way; no --side."
          (Default "none: the visibility polygon")
    needed = Default "none; one of --from, --corner and --side is required"
    combined (Just (x, y)) Nothing Nothing facing = Right (FromPoint (Point x y) facing)
    combined Nothing (Just name) Nothing facing = Right (FromCorner name facing)
    combined Nothing Nothing (Just name) Nothing = Right (FromSide name)
    combined Nothing Nothing (Just _) (Just _) = Left "--normal goes with --from or --corner, not with --side"
    combined Nothing Nothing Nothing (Just _) = Left "--normal needs --from X,Y or --corner P.K"
    combined Nothing Nothing Nothing Nothing = Left "give --from X,Y, --corner P.K or --side P.S"
    combined _ _ _ _ = Left "give one of --from, --corner and --side, not more"

viewOptions :: Parser (Either String ViewOptions)
viewOptions = complete <$> place <*> digitsOption <*> detailOption
  where
    complete from wanted detail = (\known -> ViewOptions known wanted detail) <$> from
