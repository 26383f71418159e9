module Visibility.ErrorSpec (spec) where

import Control.Monad (forM)
import Data.Bifunctor (first)
import qualified Data.ByteString as Bytes
import Data.Foldable (for_, toList)
import Data.List (isPrefixOf, nub, sort, stripPrefix, tails)
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.Set as Set
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import System.Directory (listDirectory)
import System.FilePath (replaceExtension, takeExtension, (</>))
import Test.Hspec
import Visibility.Error
import Visibility.Format.File (readSceneBytes)
import Visibility.Format.Number
import Visibility.Scene.Id
import Visibility.Scene.Validate

folder :: FilePath
folder = "test" </> "golden" </> "errors"

spec :: Spec
spec = do
  describe "golden messages: each scene in test/golden/errors has the problems in the file beside it" $ do
    files <- runIO (listDirectory folder)
    let scenes = sort (filter ((`elem` [".json", ".geojson", ".wkt"]) . takeExtension) files)
    for_ scenes $ \file -> it file $ do
      outcome <- problemsOf file
      expected <- Bytes.readFile (folder </> replaceExtension file ".txt")
      case outcome of
        [] -> expectationFailure "the scene is valid"
        p : ps -> report (p :| ps) `shouldBe` Text.unpack (Text.decodeUtf8 expected)
    it "has no expectation without a scene" $
      sort (filter ((== ".txt") . takeExtension) files) `shouldBe` sort (map (`replaceExtension` ".txt") scenes)
    it "shows every kind of problem" $ do
      shown <- concatMap kinds . concat <$> forM scenes problemsOf
      Set.fromList (filter (not . isOfItsPlace) shown) `shouldBe` Set.fromList allKinds
    it "shows everything that may be expected or wanted in a place" $ do
      shown <- concatMap kinds . concat <$> forM scenes problemsOf
      readers <- map ("src/Visibility/Format" </>) <$> listDirectory "src/Visibility/Format"
      more <- map ("src/Visibility/Format/Json" </>) <$> listDirectory "src/Visibility/Format/Json"
      sources <- mapM readUtf8 ("src/Visibility/Error/Parse.hs" : filter ((== ".hs") . takeExtension) (readers <> more))
      let expected = [text | Syntax (KUnexpected (Expected text)) <- shown]
          wanted = [text | Shape (KWrongKind (Wanted text)) <- shown]
      (length . nub) (concatMap (stated "Expected") sources) `shouldSatisfy` (> 15)
      (length . nub) (concatMap (stated "Wanted") sources) `shouldSatisfy` (> 20)
      [text | text <- concatMap (stated "Expected") sources, not (any (text `isPrefixOf`) expected)] `shouldBe` []
      [text | text <- concatMap (stated "Wanted") sources, not (any (text `isPrefixOf`) wanted)] `shouldBe` []
  describe "errorText of files that cannot be read" $ do
    it "names the file" $ do
      errorText (UnreadableFile "a.json" NoSuchFile)
        `shouldBe` "a.json: there is no such file; give the path of a scene, or - for standard input"
      errorText (UnreadableFile "a.json" NotPermitted)
        `shouldBe` "a.json: may not be read; give yourself permission to read it"
      errorText (UnreadableFile "a" (ReadFailed "is a directory"))
        `shouldBe` "a: cannot be read (is a directory); give the path of a scene, or - for standard input"
  describe "briefly" $ do
    let polygon k = InvalidScene "a" (ZeroArea (Obstacle k))
        outside k = InvalidScene "a" (OutsideEnclosure (Obstacle k))
        shapes k = UnparseableFile "b" (ShapeError (Item Root k) (UnknownKey (Text.pack "x") [Text.pack "y"]))
    it "briefly problems == map errorText problems if there are at most twenty of each kind" $ do
      let problems = concat [[polygon k, outside k] | k <- [0 .. 19]] <> map shapes [0 .. 19]
      briefly problems `shouldBe` map errorText problems
    it "tells twenty of each kind in their order, and how many more there are" $
      briefly (concat [[polygon k, outside k] | k <- [0 .. 21]] <> [polygon 22])
        `shouldBe` map errorText (concat [[polygon k, outside k] | k <- [0 .. 19]])
          <> [ "a: and 3 more like this: polygon 0: all corners lie on one line, so its area is zero; \
               \--all-errors tells all"
             , "a: and 2 more like this: polygon 0: lies outside the enclosure; --all-errors tells all"
             ]
    it "stops after a hundred thousand, of however many" $ do
      let last' = drop 20 . briefly
      last' (map outside [0 .. 99999])
        `shouldBe` ["a: and 99980 more like this: polygon 0: lies outside the enclosure; --all-errors tells all"]
      last' (map outside [0 ..])
        `shouldBe` [ "a: and at least 99980 more like this: polygon 0: lies outside the enclosure; \
                     \so many are enough, --all-errors tells all"
                   ]
  describe "exit codes" $ do
    it "are those of the contract" $
      map exitNumber [minBound .. maxBound] `shouldBe` [0, 1, 2, 3, 4, 5, 6, 70]
    it "tell how far the file was read" $ do
      let invalid = InvalidScene "a" EmptyScene
          unparseable = UnparseableFile "b" (SyntaxError (TextPosition 1 1) InvalidUtf8)
          unreadable = UnreadableFile "c" NoSuchFile
      map (exitNumber . problemOutcome) [unreadable, unparseable, invalid] `shouldBe` [2, 3, 4]

problemsOf :: FilePath -> IO [Problem]
problemsOf file = do
  bytes <- Bytes.readFile (folder </> file)
  pure (either toList (const []) (readSceneBytes file bytes >>= first (fmap (InvalidScene file)) . validate))

-- | All problems of a file have one outcome.
report :: NonEmpty Problem -> String
report problems = unlines (map (("exit " <>) . show) codes <> map errorText (toList problems))
  where
    codes = nub (map (exitNumber . problemOutcome) (toList problems))

-- | A case of a problem that has a text of its own. The functions below are total, so a new case cannot be forgotten.
data Kind
  = Syntax SyntaxKind
  | Shape ShapeKind
  | Scene SceneKind
  deriving (Eq, Ord, Show)

data SyntaxKind
  = KUnexpected Expected
  | KControl
  | KUtf8
  | KDeep
  | KWord NumberFault
  | KGeometry OutlineKind
  deriving (Eq, Ord, Show)

data ShapeKind
  = KWrongKind Wanted
  | KMissing
  | KClash
  | KUnknown
  | KTwice
  | KSideKey
  | KNumber NumberFault
  | KOutline OutlineKind
  | KEnclosureHole
  | KEnclosureWall
  | KSecondEnclosure
  deriving (Eq, Ord, Show)

data OutlineKind = KOpenRing | KShortRing | KShortLine | KHole
  deriving (Eq, Ord, Show, Enum, Bounded)

data SceneKind
  = KEmpty
  | KFew
  | KRepeated
  | KZeroArea
  | KSpike
  | KCornerOnSide
  | KOverlappingPolygons Whose
  | KOverlappingWalls Whose
  | KCrossing Whose
  | KNested
  | KOutside
  | KNoSide
  | KEmission PlaceKind
  | KReflectivity PlaceKind
  deriving (Eq, Ord, Show)

data Whose = OwnBoundary | OtherPolygon | TheEnclosure
  deriving (Eq, Ord, Show, Enum, Bounded)

data PlaceKind = AtPolygon | AtSide
  deriving (Eq, Ord, Show, Enum, Bounded)

allKinds :: [Kind]
allKinds =
  map Syntax [KControl, KUtf8, KDeep]
    <> map (Shape . KNumber) [minBound .. maxBound]
    <> map Shape [KMissing, KClash, KUnknown, KTwice, KSideKey, KEnclosureHole, KEnclosureWall, KSecondEnclosure]
    <> map (Shape . KOutline) [minBound .. maxBound]
    <> map Syntax (map KWord [minBound .. maxBound] <> map KGeometry [minBound .. maxBound])
    <> map
      Scene
      ( [KEmpty, KFew, KRepeated, KZeroArea, KSpike, KCornerOnSide, KNested, KOutside, KNoSide]
          <> map KOverlappingPolygons [OtherPolygon, TheEnclosure]
          <> map KOverlappingWalls [OwnBoundary, OtherPolygon]
          <> map KCrossing [minBound .. maxBound]
          <> map KEmission [minBound .. maxBound]
          <> map KReflectivity [minBound .. maxBound]
      )

-- | Of these there are as many kinds as places where something is expected or wanted.
isOfItsPlace :: Kind -> Bool
isOfItsPlace kind = case kind of
  Syntax (KUnexpected _) -> True
  Shape (KWrongKind _) -> True
  _ -> False

-- | The texts, or their beginnings, that a constructor is applied to in a source.
stated :: String -> String -> [String]
stated name source =
  [ text
  | rest <- tails source
  , Just argument <- [stripPrefix (name <> " ") rest]
  , (text, _) <- reads (dropWhile (== '(') argument)
  ]

readUtf8 :: FilePath -> IO String
readUtf8 file = Text.unpack . Text.decodeUtf8 <$> Bytes.readFile file

kinds :: Problem -> [Kind]
kinds problem = case problem of
  UnreadableFile _ _ -> []
  UnparseableFile _ (SyntaxError _ fault) -> [Syntax (syntaxKind fault)]
  UnparseableFile _ (ShapeError _ fault) -> [Shape (shapeKind fault)]
  InvalidScene _ fault -> [Scene (sceneKind fault)]

syntaxKind :: SyntaxFault -> SyntaxKind
syntaxKind fault = case fault of
  Unexpected _ expected -> KUnexpected expected
  UnexpectedWord _ expected -> KUnexpected expected
  BadWord _ why -> KWord why
  BadGeometry why -> KGeometry (outlineKind why)
  ControlCharacter _ -> KControl
  InvalidUtf8 -> KUtf8
  TooDeep _ -> KDeep

shapeKind :: ShapeFault -> ShapeKind
shapeKind fault = case fault of
  WrongKind _ wanted -> KWrongKind wanted
  MissingKey _ _ -> KMissing
  ClashingKeys _ _ -> KClash
  UnknownKey _ _ -> KUnknown
  DuplicateKey _ -> KTwice
  BadSideKey _ -> KSideKey
  BadNumber _ why -> KNumber why
  BadOutline why -> KOutline (outlineKind why)
  EnclosureHole -> KEnclosureHole
  EnclosureWall -> KEnclosureWall
  SecondEnclosure _ -> KSecondEnclosure

outlineKind :: OutlineFault -> OutlineKind
outlineKind fault = case fault of
  OpenRing _ _ -> KOpenRing
  ShortRing _ -> KShortRing
  ShortLine _ -> KShortLine
  Hole -> KHole

sceneKind :: SceneError -> SceneKind
sceneKind fault = case fault of
  EmptyScene -> KEmpty
  TooFewCorners _ _ -> KFew
  RepeatedCorner {} -> KRepeated
  ZeroArea _ -> KZeroArea
  Spike _ _ -> KSpike
  CornerOnSide {} -> KCornerOnSide
  OverlappingPolygons p q -> KOverlappingPolygons (whose p q)
  OverlappingWalls p q -> KOverlappingWalls (whose p q)
  CrossingSides (SideName p _) (SideName q _) -> KCrossing (whose p q)
  NestedPolygon _ _ -> KNested
  OutsideEnclosure _ -> KOutside
  NoSuchSide _ _ -> KNoSide
  BadEmission place _ -> KEmission (placeKind place)
  BadReflectivity place _ -> KReflectivity (placeKind place)
  where
    whose p q
      | p == q = OwnBoundary
      | q == Enclosure = TheEnclosure
      | otherwise = OtherPolygon
    placeKind (OfPolygon _) = AtPolygon
    placeKind (OfSide _) = AtSide
