#include "features/edit/contour_edit.hpp"

#include <gtest/gtest.h>

#include "contour_editing.hpp"
#include "features/edit/arc_ways.hpp"

namespace kerf::features {
namespace {

using namespace test;  // NOLINT: shapes and expectations by their names

TEST(ContourEdit, WithoutAnEditIsWhatItWas) {
  const ContourEdit edit = edit_of(pocket(), {disc({30, 24}, 5)});
  const auto finished = edit.finished();
  ASSERT_TRUE(finished);
  expect_contour(finished->outer, pocket());
  ASSERT_EQ(finished->islands.size(), 1U);
  expect_contour(finished->islands[0], disc({30, 24}, 5));
}

TEST(ReplacedContour, IsInNormalFormWhateverItsSenseAndStart) {
  ContourEdit edit = edit_of(pocket());
  const Contour clockwise =
      closed({{{60, 10}}, {{10, 10}}, {{10, 38}}, {{35, 38}}, {{60, 38}}, {{60, 10}}});
  apply(edit, ReplaceContour{.contour = clockwise});
  // Element 1 is the right side, for the two parts of the upper one are one.
  apply(edit, FilletCorner{.corner = 1, .radius = 5});
  expect_outer(edit,
               closed({{{10, 10}}, {{55, 10}, kQuarter}, {{60, 15}}, {{60, 38}}, {{10, 38}}}));
}

TEST(ReplacedContour, TakesIslandsAlong) {
  ContourEdit edit = edit_of(pocket(), {disc({30, 24}, 5)});
  apply(edit, ReplaceContour{.islands = std::vector{disc({20, 20}, 3), disc({40, 20}, 3)}});
  const auto finished = edit.finished();
  ASSERT_TRUE(finished);
  ASSERT_EQ(finished->islands.size(), 2U);
  expect_contour(finished->islands[1], disc({40, 20}, 3));
}

TEST(ReplacedContour, OfAnOpenOneIsOpenAndKeepsItsDirection) {
  ContourEdit edit({open({{{0, 5}}, {{-10, 5}}, {{-10, 20}}}), {}});
  apply(edit, ReplaceContour{.contour = closed({{{0, 6}}, {{-10, 6}}, {{-10, 20}}})});
  expect_outer(edit, open({{{0, 6}}, {{-10, 6}}, {{-10, 20}}}));
}

TEST(JoinedElements, MeetWhereTheTableSays) {
  ContourEdit edit({open({{{0, 0}}, {{30, 0}}}), {}});
  apply(edit, AddElement{{{40, 10}, {40, 50}}});
  apply(edit, JoinElements{0, 1});
  expect_outer(edit, open({{{0, 0}}, {{40, 0}}, {{40, 50}}}));
}

TEST(JoinedElements, MayHaveBeenDrawnAgainstTheContour) {
  ContourEdit edit({open({{{0, 0}}, {{30, 0}}}), {}});
  apply(edit, AddElement{{{40, 50}, {40, 10}}});
  apply(edit, JoinElements{1, 0});
  expect_outer(edit, open({{{0, 0}}, {{40, 0}}, {{40, 50}}}));
}

TEST(JoinedElements, CloseTheGapOfADeletedOne) {
  // A pocket with a chamfer at its lower right corner, which goes.
  ContourEdit edit = edit_of(closed({{{10, 10}}, {{45, 10}}, {{50, 15}}, {{50, 38}}, {{10, 38}}}));
  apply(edit, DeleteElement{1});
  expect_fault(edit, Code::edit_open, "THE CONTOUR IS OPEN BY 7.071 mm BETWEEN ELEMENTS 0 AND 2");
  apply(edit, JoinElements{2, 0});
  expect_outer(edit, pocket());
}

TEST(JoinedElements, LineAndArcMeetNearTheirEnds) {
  // The line ends beyond the circle about X30 Y10 with radius 10; it is cut off at Y20 of it.
  ContourEdit edit({open({{{0, 20}}, {{28, 20}}}), {}});
  apply(edit, AddElement{*arc_through({30, 20}, {37.0710678, 17.0710678}, {40, 10})});
  apply(edit, JoinElements{0, 1});
  expect_outer(edit, open({{{0, 20}}, {{30, 20}, -kQuarter}, {{40, 10}}}), 1e-4);
}

TEST(JoinedElements, ThatAreParallelAreRefused) {
  ContourEdit edit = edit_of(pocket());
  apply(edit, DeleteElement{1});
  expect_refused(edit.apply(JoinElements{0, 2}, {}), Code::edit_no_meeting,
                 "ELEMENTS 0 AND 2 DO NOT MEET");
  expect_refused(edit.apply(JoinElements{2, 2}, {}), Code::edit_no_meeting,
                 "ELEMENT 2 CANNOT BE JOINED TO ITSELF");
}

TEST(ModifiedLine, TakesItsNeighboursAlong) {
  ContourEdit edit = edit_of(pocket());
  apply(edit, ModifyLine{.element = 1, .from = Vec2{40, 10}, .to = Vec2{45, 38}});
  expect_outer(edit, closed({{{10, 10}}, {{40, 10}}, {{45, 38}}, {{10, 38}}}));
}

TEST(ModifiedLine, ByLengthAndAngleGoesFromItsStart) {
  ContourEdit edit = edit_of(pocket());
  apply(edit, ModifyLine{.element = 0, .length = 30.0});
  expect_outer(edit, closed({{{10, 10}}, {{40, 10}}, {{50, 38}}, {{10, 38}}}));
  apply(edit, ModifyLine{.element = 0, .length = 20.0, .angle_deg = -90.0});
  expect_outer(edit, closed({{{10, -10}}, {{50, 38}}, {{10, 38}}}));
}

TEST(ModifiedLine, OnAnArcIsRefused) {
  ContourEdit edit = edit_of(disc({0, 0}, 10));
  expect_refused(edit.apply(ModifyLine{.element = 0, .length = 5.0}, {}),
                 Code::edit_element_unknown, "ELEMENT 0 IS AN ARC: TAKE modify-arc");
}

TEST(ModifiedArc, ByItsRadiusKeepsItsEnds) {
  // The right end of a slot, flatter.
  ContourEdit edit = edit_of(closed({{{0, 0}}, {{40, 0}, 1}, {{40, 20}}, {{0, 20}}}));
  apply(edit, ModifyArc{.element = 1, .radius = 12.5});
  // tan(sweep / 4) of the short way: 10 / (12.5 + 7.5).
  expect_outer(edit, closed({{{0, 0}}, {{40, 0}, 0.5}, {{40, 20}}, {{0, 20}}}));
  expect_refused(edit.apply(ModifyArc{.element = 1, .radius = 9.0}, {}), Code::edit_does_not_fit,
                 "ELEMENT 1: RADIUS 9 IS TOO SMALL FOR ENDS THAT ARE 20 mm APART");
}

TEST(ModifiedArc, ByCentreOrAnglesTakesItsNeighboursAlong) {
  const Contour slot = closed({{{0, 0}}, {{40, 0}, 1}, {{40, 20}}, {{0, 20}}});
  ContourEdit moved = edit_of(slot);
  apply(moved, ModifyArc{.element = 1, .centre = Vec2{50, 10}});
  expect_outer(moved, closed({{{0, 0}}, {{50, 0}, 1}, {{50, 20}}, {{0, 20}}}));
  ContourEdit cut = edit_of(slot);
  apply(cut, ModifyArc{.element = 1, .end_deg = 0.0});
  expect_outer(cut, closed({{{0, 0}}, {{40, 0}, kQuarter}, {{50, 10}}, {{0, 20}}}));
  ContourEdit through = edit_of(slot);
  apply(through, ModifyArc{.element = 1, .through = {{45, 0}, {55, 10}, {45, 20}}});
  expect_outer(through, closed({{{0, 0}}, {{45, 0}, 1}, {{45, 20}}, {{0, 20}}}));
}

TEST(ModifiedArc, RefusesLinesAndWholeCircles) {
  ContourEdit edit = edit_of(closed({{{0, 0}}, {{40, 0}, 1}, {{40, 20}}, {{0, 20}}}));
  expect_refused(edit.apply(ModifyArc{.element = 0, .radius = 9.0}, {}), Code::edit_element_unknown,
                 "ELEMENT 0 IS A LINE: TAKE modify-line");
  expect_refused(edit.apply(ModifyArc{.element = 1, .start_deg = 90.0, .end_deg = 450.0}, {}),
                 Code::edit_does_not_fit, "ELEMENT 1: A WHOLE CIRCLE IS TWO ELEMENTS");
  expect_refused(edit.apply(ModifyArc{.element = 1, .through = {{0, 0}, {1, 1}, {2, 2}}}, {}),
                 Code::edit_does_not_fit, "ELEMENT 1: NO ARC GOES THROUGH THE THREE POINTS");
}

TEST(DrawnElements, FillAGapInAnyOrderAndDirection) {
  ContourEdit edit = edit_of(pocket());
  apply(edit, AddElement{{{60, 24}, {50, 38}}});
  apply(edit, DeleteElement{1});
  apply(edit, AddElement{{{60, 24}, {50, 10}}});
  expect_outer(edit, closed({{{10, 10}}, {{50, 10}}, {{60, 24}}, {{50, 38}}, {{10, 38}}}));
}

TEST(DrawnElements, HaveTheNextFreeNumber) {
  ContourEdit edit = edit_of(pocket());
  apply(edit, FilletCorner{.corner = 2, .radius = 4});  // its arc is 4
  apply(edit, DeleteElement{1});
  apply(edit, AddElement{{{50, 10}, {50, 34}}});  // 5
  apply(edit, FilletCorner{.corner = 5, .radius = 3});
  expect_outer(edit, closed({{{10, 10}},
                             {{47, 10}, kQuarter},
                             {{50, 13}},
                             {{50, 34}, kQuarter},
                             {{46, 38}},
                             {{10, 38}}}));
}

TEST(DrawnElements, MakeAWholeContour) {
  ContourEdit edit = edit_of(pocket());
  for (std::size_t element = 0; element < 4; ++element) apply(edit, DeleteElement{element});
  expect_fault(edit, Code::edit_no_area, "THE CONTOUR ENCLOSES NOTHING");
  apply(edit, AddElement{{{0, 0}, {10, 0}}});
  apply(edit, AddElement{{{0, 10}, {10, 10}}});
  apply(edit, AddElement{{{0, 0}, {0, 10}}});
  apply(edit, AddElement{{{10, 10}, {10, 0}, -1}});
  expect_outer(edit, closed({{{0, 0}}, {{10, 0}, 1}, {{10, 10}}, {{0, 10}}}));
}

TEST(Islands, ComeGoAndKeepTheirNumbers) {
  ContourEdit edit = edit_of(pocket(), {disc({20, 20}, 3), disc({40, 20}, 3)});
  apply(edit, AddIsland{closed({{{28, 30}}, {{28, 34}}, {{34, 34}}, {{34, 30}}})});
  apply(edit, DeleteIsland{0});
  apply(edit, FilletCorner{.corner = 0, .radius = 1}, 2);
  const auto finished = edit.finished();
  ASSERT_TRUE(finished) << finished.error().sentence;
  ASSERT_EQ(finished->islands.size(), 2U);
  expect_contour(finished->islands[0], disc({40, 20}, 3));
  EXPECT_EQ(finished->islands[1].vertices.size(), 5U);
  expect_refused(edit.apply(DeleteIsland{0}, {}), Code::edit_layer_unknown,
                 "NO ISLAND 0: THE CONTOUR HAS 0 TO 2");
  expect_refused(edit.apply(DeleteElement{9}, 1), Code::edit_element_unknown,
                 "NO ELEMENT 9 OF ISLAND 1: THE CONTOUR HAS 0 TO 1");
}

TEST(PlacedFeature, ThereAndBackIsWhereItWas) {
  const Contour outer =
      closed({{{10, 10}}, {{45, 10}, kQuarter}, {{50, 15}}, {{50, 38}}, {{10, 38}}});
  const std::vector<std::pair<EditOperation, EditOperation>> pairs{
      {MoveFeature{3.7, -12.1}, MoveFeature{-3.7, 12.1}},
      {RotateFeature{71.5, Vec2{-8, 3}}, RotateFeature{-71.5, Vec2{-8, 3}}},
      {ScaleFeature{1.7}, ScaleFeature{1 / 1.7}}};
  for (const auto& [there, back] : pairs) {
    ContourEdit edit = edit_of(outer, {disc({30, 24}, 5)});
    apply(edit, there);
    const auto between = edit.finished();
    ASSERT_TRUE(between);
    EXPECT_FALSE(are_equal(between->outer, normal_form(outer), 0.1));
    apply(edit, back);
    expect_outer(edit, outer, 1e-9);
    expect_contour(edit.finished()->islands[0], disc({30, 24}, 5), 1e-9);
  }
}

TEST(PlacedFeature, TurnsAboutTheMiddleOfItsBox) {
  ContourEdit edit = edit_of(pocket());
  apply(edit, RotateFeature{90});
  expect_outer(edit, closed({{{16, 4}}, {{44, 4}}, {{44, 44}}, {{16, 44}}}));
  apply(edit, ScaleFeature{0.5, Vec2{16, 4}});
  expect_outer(edit, closed({{{16, 4}}, {{30, 4}}, {{30, 24}}, {{16, 24}}}));
}

TEST(PlacedFeature, OneIslandMovesByItself) {
  ContourEdit edit = edit_of(pocket(), {disc({20, 20}, 3), disc({40, 20}, 3)});
  apply(edit, MoveFeature{0, 5}, 1);
  const auto finished = edit.finished();
  ASSERT_TRUE(finished);
  expect_contour(finished->outer, pocket());
  expect_contour(finished->islands[0], disc({20, 20}, 3));
  expect_contour(finished->islands[1], disc({40, 25}, 3));
}

TEST(TurnedContour, IsEditedByRadii) {
  // A shoulder from Ø20 to Ø40; the fillet's radius is 3 as the tool moves.
  ContourEdit edit({open({{{0, 20}}, {{-30, 20}}, {{-30, 40}}}), {}}, true);
  apply(edit, FilletCorner{.corner = 1, .radius = 3});
  expect_outer(edit, open({{{0, 20}}, {{-27, 20}, -kQuarter}, {{-30, 26}}, {{-30, 40}}}));
  apply(edit, ModifyLine{.element = 1, .to = Vec2{-30, 44}});
  apply(edit, MoveFeature{.dx = 2, .dz = -1});
  expect_outer(edit, open({{{-1, 22}}, {{-28, 22}, -kQuarter}, {{-31, 28}}, {{-31, 46}}}));
}

TEST(Elements, ThatAreNotThereAreRefused) {
  ContourEdit edit = edit_of(pocket());
  expect_refused(edit.apply(DeleteElement{4}, {}), Code::edit_element_unknown,
                 "NO ELEMENT 4: THE CONTOUR HAS 0 TO 3");
  apply(edit, DeleteElement{3});
  for (const EditOperation& operation :
       {EditOperation{DeleteElement{3}}, EditOperation{ModifyLine{.element = 3}},
        EditOperation{ModifyArc{.element = 3}}, EditOperation{JoinElements{0, 3}},
        EditOperation{FilletCorner{.corner = 3, .radius = 1}},
        EditOperation{ChamferCorner{.corner = 3, .before = 1, .after = 1}}}) {
    expect_refused(edit.apply(operation, {}), Code::edit_element_unknown,
                   "ELEMENT 3 IS NO LONGER THERE");
  }
  expect_refused(edit.apply(DeleteElement{0}, 0), Code::edit_layer_unknown,
                 "NO ISLAND 0: THE CONTOUR HAS NONE");
}

}  // namespace
}  // namespace kerf::features
