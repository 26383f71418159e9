{-# LANGUAGE OverloadedStrings #-}

module Visibility.Draw.FigureSpec (spec) where

import qualified Data.Text as Text
import Test.Hspec
import Test.QuickCheck
import Visibility.Draw.Checks
import Visibility.Draw.Drawing
import Visibility.Draw.Figure

spec :: Spec
spec = describe "a page" $ do
  it "holds captions of any number of lines, which stand in order below all else" $
    property $ \(NonNegative k) ->
      let page = (scenePage "title" 100) {pageFacts = replicate k "a fact of some length", pageCaption = 30}
          drawing = pageDrawing page
          heights = [y | Mark _ Caption (Label _ (Place _ y) _) <- drawingMarks drawing]
       in conjoin [strayMarks drawing === [], property (and (zipWith (>) heights (drop 1 heights)))]
  it "states its facts and its title in what is read aloud" $
    let drawing = pageDrawing (scenePage "title" 100) {pageAbout = "What: ", pageFacts = ["one", "two"]}
     in (drawingTitle drawing, drawingDescription drawing) `shouldBe` ("title", Text.pack "What: one, two.")
