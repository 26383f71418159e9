-- | Form factors and radiosities against closed forms of two-dimensional view factors.
--
-- /Source/ Howell, A Catalog of Radiation Heat Transfer Configuration Factors, section C: C-1, parallel plates of equal
-- width opposite each other; C-2, of different widths, the middle of one opposite that of the other; C-3, plates of
-- different widths at a right angle, with a common edge; C-5, the same at any angle, of which plates of equal width are
-- a case.
module Visibility.Radiosity.ClosedFormSpec (spec) where

import Data.List (sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Ratio ((%))
import Test.Hspec
import Test.QuickCheck hiding (sample)
import Visibility.Exact.Point (Point (..))
import Visibility.Exact.RootSum
import Visibility.Exact.Rounding (defaultDigits, digits)
import Visibility.Exact.SomeRoots
import Visibility.FormFactor
import Visibility.Mesh
import Visibility.Radiosity
import Visibility.Scene
import Visibility.Scene.Raw
import Visibility.Sweep
import Visibility.Test.Generator

spec :: Spec
spec = do
  describe "the closed forms" $
    it "are crossed strings less uncrossed ones, by the width" $
      forAll ((,,) <$> width <*> width <*> tangent) $ \(a, b, t) ->
        conjoin
          [ opposite a b === strings (Point 0 0, Point a 0) (Point 0 b, Point a b)
          , midlines a b (a + b) === strings (Point 0 0, Point a 0) (facing a b (a + b))
          , corner a b === strings (Point a 0, Point 0 0) (Point 0 b, Point 0 0)
          , wedge t a b === strings (Point a 0, Point 0 0) (turned t b, Point 0 0)
          , equalWedge t === wedge t a a
          ]
  describe "the form factors" $ do
    it "of opposite parallel plates are those of C-1, and so are those of opposite elements" $
      forAll ((,,) <$> width <*> width <*> choose (1, 4)) $ \(w, h, n) ->
        onPlates [[Point 0 0, Point w 0], [Point 0 h, Point w h]] $ \scene ->
          conjoin
            [ between 0 1 (unrefined scene) === [opposite w h]
            , fmap (fromOneTo w 1) (equalParts n scene) === Just [opposite w h]
            , fmap (length . filter (== opposite (w / toRational n) h) . between 0 1) (equalParts n scene)
                === Just (fromIntegral n)
            ]
    it "of parallel plates of two widths are those of C-2" $
      forAll ((,,) <$> width <*> width <*> width) $ \(a, b, h) ->
        let (from, to) = facing a b h
         in onPlates [[Point 0 0, Point a 0], [from, to]] $ \scene ->
              conjoin
                [ between 0 1 (unrefined scene) === [midlines a b h]
                , fmap (fromOneTo a 1) (equalParts 3 scene) === Just [midlines a b h]
                , fmap (fromOneTo a 1) (Just (discontinuities scene)) === Just [midlines a b h]
                ]
    it "of plates at a right angle are those of C-3, of two plates that touch and of one that is bent" $
      forAll ((,) <$> width <*> width) $ \(a, b) ->
        conjoin
          [ onPlates [[Point a 0, Point 0 0], [Point 0 0, Point 0 b]] $ \scene ->
              conjoin
                [ between 0 1 (unrefined scene) === [corner a b]
                , fmap (fromOneTo a 1) (equalParts 2 scene) === Just [corner a b]
                , fmap (elem (corner (a / 2) (b / 2)) . between 0 1) (equalParts 2 scene) === Just True
                ]
          , onPlates [[Point a 0, Point 0 0, Point 0 b]] $ \scene ->
              sort (between 0 0 (unrefined scene)) === sort [corner a b, corner b a]
          ]
    it "of plates at any angle are those of C-5" $
      forAll ((,,) <$> width <*> width <*> tangent) $ \(a, b, t) ->
        conjoin
          [ onPlates [[Point a 0, Point 0 0], [Point 0 0, turned t b]] $ \scene ->
              conjoin
                [ between 0 1 (unrefined scene) === [wedge t a b]
                , fmap (fromOneTo a 1) (equalParts 3 scene) === Just [wedge t a b]
                ]
          , onPlates [[Point a 0, Point 0 0], [Point 0 0, turned t a]] $ \scene ->
              between 0 1 (unrefined scene) === [equalWedge t]
          ]
  describe "in an L-shaped room of unit squares" $ do
    it "the form factors of the discontinuity mesh are those that closed forms give, by additivity and closure" $
      forAll width $ \k -> onRoom k [] $ \scene ->
        let cut = discontinuities scene
         in conjoin
              [ Map.fromList [((s, t), f) | (s, t, f) <- byName cut] === lShape
              , sort (map elementText (refinedElements cut)) === sort lElements
              ]
    it "the closed forms close" $
      [sums | row <- lElements, let sums = mconcat [f | ((s, _), f) <- Map.toList lShape, s == row], sums /= rational 1]
        `shouldBe` []
    it "form factors of whole sides are those of elements, added up" $
      onRoom 1 [] $ \scene -> Map.fromList [((s, t), f) | (s, t, f) <- byName (unrefined scene)] === lSides
  describe "radiosities to 30 digits" $ do
    it "of two parallel plates, one of which gives light, are those of the closed form" $
      forAll ((,,,) <$> width <*> width <*> part <*> part) $ \(w, h, r, r') ->
        onLit [Material 3 r, Material 0 r'] [[Point 0 0, Point w 0], [Point 0 h, Point w h]] $ \scene ->
          let -- Without the faces that see the sky only.
              names = ["0.1", "1.0"]
              system' = [((a, b), opposite w h) | a <- names, b <- names, a /= b]
           in agree (unrefined scene) names system' (\name -> if name == "0.1" then Material 3 r else Material 0 r')
    it "of the halves of two parallel plates are those of the closed form" $
      forAll ((,,,) <$> width <*> width <*> part <*> part) $ \(w, h, r, r') ->
        onLit [Material 3 r, Material 0 r'] [[Point 0 0, Point w 0], [Point 0 h, Point w h]] $ \scene ->
          let near = opposite (w / 2) h
              -- Two halves see a half each: 2 (w/2) (near + far) = w F.
              far = opposite w h - near
              -- The second face of a wall begins where its first one ends.
              lower = ["0.1#1", "0.1#0"]
              upper = ["1.0#0", "1.0#1"]
              system' =
                concat
                  [ [((a, b), f), ((b, a), f)]
                  | (i, a) <- zip [0 :: Int ..] lower
                  , (j, b) <- zip [0 ..] upper
                  , let f = if i == j then near else far
                  ]
           in case equalParts 2 scene of
                Nothing -> counterexample "there is no mesh" False
                Just cut ->
                  agree cut (lower <> upper) system' $ \name ->
                    if name `elem` lower then Material 3 r else Material 0 r'
    it "of the elements of an L-shaped room are those of the closed form" $
      forAll ((,) <$> width <*> vectorOf 6 material) $ \(k, given) ->
        onRoom k given $ \scene ->
          agree (discontinuities scene) lElements (Map.toList lShape) (materialIn given . takeWhile (/= '#'))
    it "of the sides of an L-shaped room are those of the closed form" $
      forAll ((,) <$> width <*> vectorOf 6 material) $ \(k, given) ->
        onRoom k given $ \scene ->
          agree (unrefined scene) (map fst lWidths) (Map.toList lSides) (materialIn given)
  where
    width = (%) <$> choose (1, 30) <*> choose (1, 7) :: Gen Rational
    -- Of half an angle: 90° and more too, less than 180°.
    tangent = (%) <$> choose (1, 12) <*> choose (1, 5) :: Gen Rational
    part = (% 20) <$> choose (0, 19) :: Gen Rational
    material = Material <$> elements [0, 0, 1, 7 % 3] <*> part
    materialIn given name = fromMaybe black (lookup name (zip (map fst lWidths) given))

-- * Closed forms: from a plate to another one.

-- | C-1: width, distance.
opposite :: Rational -> Rational -> RootSum
opposite w h = rootOf (1 + (h / w) ^ (2 :: Int)) - rational (h / w)

-- | C-2: width of the plate, of the other one, distance.
midlines :: Rational -> Rational -> Rational -> RootSum
midlines a b h = scaled (1 / (2 * x)) (rootOf ((x + y) ^ (2 :: Int) + 4) - rootOf ((y - x) ^ (2 :: Int) + 4))
  where
    (x, y) = (a / h, b / h)

-- | C-3: width of the plate, of the other one.
corner :: Rational -> Rational -> RootSum
corner w h = scaled (1 / 2) (rational (1 + h / w) - rootOf (1 + (h / w) ^ (2 :: Int)))

-- | C-5: the tangent of half the angle, width of the plate, of the other one.
wedge :: Rational -> Rational -> Rational -> RootSum
wedge t w h = scaled (1 / 2) (rational (1 + x) - rootOf (1 + x * x - 2 * x * cosine t))
  where
    x = h / w

-- | 1 − sin(α/2), by the tangent of α/2.
equalWedge :: Rational -> RootSum
equalWedge t = rational 1 - rootOf (t * t / (1 + t * t))

cosine :: Rational -> Rational
cosine t = (1 - t * t) / (1 + t * t)

-- | The end of a plate of a width that begins at the origin, at an angle of which half the tangent is given.
turned :: Rational -> Rational -> Point
turned t w = Point (w * cosine t) (w * 2 * t / (1 + t * t))

-- | The plate opposite (0, 0) (a, 0) with the same middle, of another width, at a distance.
facing :: Rational -> Rational -> Rational -> (Point, Point)
facing a b h = (Point ((a - b) / 2) h, Point ((a + b) / 2) h)

rootOf :: Rational -> RootSum
rootOf = fromMaybe zero . rootOfRational

-- | Hottel: the crossed strings less the uncrossed ones, by twice the width. The first ends of both plates are joined
-- by an uncrossed string.
strings :: (Point, Point) -> (Point, Point) -> RootSum
strings (a, b) (c, d) = case terms (way a b) of
  [(q, n)] -> fromMaybe zero (quotientByRoot (scaled (1 / 2) crossed) q n)
  _ -> zero
  where
    crossed = (way a d + way b c) - (way a c + way b d)
    way (Point x y) (Point x' y') = rootOf ((x - x') * (x - x') + (y - y') * (y - y'))

-- * The L-shaped room: (0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2).

-- | Its sides with their lengths.
lWidths :: [(String, Rational)]
lWidths = [("E.0", 2), ("E.1", 1), ("E.2", 1), ("E.3", 1), ("E.4", 1), ("E.5", 2)]

-- | Its elements: the lines of the short sides land in the middle of the long ones. All are 1 long.
lElements :: [String]
lElements = ["E.0#0", "E.0#1", "E.1#0", "E.2#0", "E.3#0", "E.4#0", "E.5#0", "E.5#1"]

-- | Form factors between elements: of one half of the room, and of its mirror image.
lShape :: Map.Map (String, String) RootSum
lShape = Map.fromList (concat [[((a, b), f), ((b, a), f)] | (a, b, f) <- half <> map mirrored half <> middle])
  where
    half =
      [ ("E.0#1", "E.1#0", next)
      , ("E.1#0", "E.2#0", next)
      , ("E.0#1", "E.2#0", across)
      , ("E.0#0", "E.2#0", aside)
      , ("E.0#0", "E.1#0", farther)
      , ("E.5#1", "E.1#0", opposite 1 2)
      , ("E.5#1", "E.2#0", farther)
      , ("E.5#1", "E.0#1", farther)
      , ("E.0#1", "E.4#0", rest)
      ]
    middle = [("E.0#0", "E.5#1", next), ("E.0#1", "E.5#0", ends)]
    mirrored (a, b, f) = (mirror a, mirror b, f)
    mirror name = case name of
      'E' : '.' : k : '#' : j -> case k of
        '0' -> "E.5#" <> map other j
        '5' -> "E.0#" <> map other j
        '1' -> "E.4#" <> j
        '4' -> "E.1#" <> j
        '2' -> "E.3#" <> j
        _ -> "E.2#" <> j
      _ -> name
    other j = if j == '0' then '1' else '0'
    next = corner 1 1
    across = opposite 1 1
    -- 2 F = 2 (across + aside) for the whole strip, 2 wide and 1 high.
    aside = opposite 2 1 - across
    -- From a wall of 1 to a floor of 2, less the near half of that.
    farther = corner 1 2 - next
    -- 2 F = next + 2 farther + ends for walls of 2; the strings of the far halves meet in the corner of the L.
    ends = scaled 2 (corner 2 2) - (next + scaled 2 farther)
    rest = rational 1 - mconcat [next, across, farther, ends]

-- | Form factors between sides: Σ |s_k| F(s_k, t_l) / |s|.
lSides :: Map.Map (String, String) RootSum
lSides =
  Map.fromListWith
    (+)
    [ ((side s, side t), scaled (1 / fromMaybe 1 (lookup (side s) lWidths)) f)
    | ((s, t), f) <- Map.toList lShape
    ]
  where
    side = takeWhile (/= '#')

-- * Scenes

-- | Thin walls under the sky.
onPlates :: Testable check => [[Point]] -> (Scene -> check) -> Property
onPlates = onLit (repeat black)

onLit :: Testable check => [Material] -> [[Point]] -> (Scene -> check) -> Property
onLit given plates =
  onScene (RawScene Nothing Nothing [(rawWall plate) {rawMaterial = m} | (m, plate) <- zip given plates])

-- | The room, larger by a factor, with materials of its sides.
onRoom :: Testable check => Rational -> [Material] -> (Scene -> check) -> Property
onRoom k given = onScene (RawScene Nothing (Just room) [])
  where
    room =
      (rawPolygon [Point (k * x) (k * y) | (x, y) <- [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]])
        { rawSides = Map.fromList [(j, MaterialOverride (Just e) (Just r)) | (j, Material e r) <- zip [0 ..] given]
        }

onScene :: Testable check => RawScene -> (Scene -> check) -> Property
onScene raw check = maybe (counterexample "the scene is not valid" False) (property . check . sampleScene) (sample raw)

equalParts :: Int -> Scene -> Maybe Refined
equalParts n scene = (\parts -> refined (uniformMesh parts scene)) <$> elementCount n

discontinuities :: Scene -> Refined
discontinuities scene = refined (discontinuityMesh scene (vertices scene))

measured :: Refined -> Measures
measured cut = let scene = refinedScene cut in measures scene (vertices scene)

-- | Form factors between elements, by what they are called.
byName :: Refined -> [(String, String, RootSum)]
byName cut =
  [ (name (factorFrom f), name to, factorValue f)
  | f <- formFactors (refinedScene cut) (measured cut)
  , TheSide to <- [factorTo f]
  ]
  where
    -- Sides that are not cut are called as in the file.
    name = if all whole (refinedElements cut) then sideText else elementNames cut
    whole e = elementFrom e == 0 && elementTo e == 1

-- | The form factors from one polygon's elements to another's.
between :: Int -> Int -> Refined -> [RootSum]
between p q cut =
  [ factorValue f
  | f <- formFactors (refinedScene cut) (measured cut)
  , SideName (Obstacle a) _ <- [factorFrom f]
  , TheSide (SideName (Obstacle b) _) <- [factorTo f]
  , (a, b) == (p, q)
  ]

-- | The form factor from polygon 0, of this width, to another polygon, by those of its elements.
fromOneTo :: Rational -> Int -> Refined -> [RootSum]
fromOneTo w q cut =
  [ scaled (1 / w) (mconcat [scaled (lengthOf (factorFrom f)) (factorValue f) | f <- found])
  | let found =
          [ f
          | f <- formFactors scene (measured cut)
          , SideName (Obstacle 0) _ <- [factorFrom f]
          , TheSide (SideName (Obstacle b) _) <- [factorTo f]
          , b == q
          ]
  ]
  where
    scene = refinedScene cut
    -- Along the first axis.
    lengthOf = fromMaybe 0 . asRational . sideLength scene

-- | Does the solution enclose that of the equations with these form factors, to 30 digits?
agree :: Refined -> [String] -> [((String, String), RootSum)] -> (String -> Material) -> Property
agree cut names factors material =
  case radiosityOfElements (ToDigits (fromMaybe defaultDigits (digits 30))) cut (measured cut) of
    Left why -> counterexample (show why) False
    Right found ->
      let bounds = Map.fromList [(named (litElement l), litRadiosity l) | l <- litElements found]
          largest = maximum (0 : map snd (Map.elems bounds))
       in conjoin
            [ counterexample (show (name, found', low, high)) $
                fmap (\(a, b) -> a <= low && high <= b && (b - a) * 10 ^ (31 :: Int) <= largest) found' === Just True
            | (name, low, high) <- zip3 names (solved fst) (solved snd)
            , let found' = Map.lookup name bounds
            ]
  where
    named e = if elem (elementText e) names then elementText e else sideText (elementSide e)
    -- Radiosities grow with form factors: those of their lower bounds are lower bounds.
    solved pick = gauss [row pick name | name <- names]
    row pick name =
      [ (if other == name then 1 else 0) - reflectivity (material name) * known
      | other <- names
      , let known = maybe 0 (pick . enclosure 300) (lookup (name, other) factors)
      ]
        <> [emission (material name)]

-- | Solves rows of coefficients with the right side last; the diagonal dominates.
gauss :: [[Rational]] -> [Rational]
gauss rows = case rows of
  (pivot : more) : rest | first : others <- reverse (pivot : more), pivot /= 0 ->
    let below = gauss [zipWith (\a b -> b - a * (x / pivot)) more row | x : row <- rest]
        coefficients = drop 1 (reverse others)
     in (first - sum (zipWith (*) coefficients below)) / pivot : below
  _ -> []
