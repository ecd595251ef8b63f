#include <gtest/gtest.h>

#include <limits>

#include "contour_editing.hpp"
#include "geometry/contour/crossing.hpp"
#include "seeded_random.hpp"

namespace kerf::features {
namespace {

using namespace test;  // NOLINT: shapes and expectations by their names

void expect_crossing(const Contour& outer, const std::vector<Contour>& islands,
                     const std::string& sentence) {
  expect_fault(edit_of(outer, islands), Code::edit_crosses_itself, sentence);
}

TEST(OpenContour, NamesTheGapAndItsElements) {
  ContourEdit edit = edit_of(pocket());
  apply(edit, DeleteElement{1});
  expect_fault(edit, Code::edit_open, "THE CONTOUR IS OPEN BY 28 mm BETWEEN ELEMENTS 0 AND 2");
}

TEST(OpenContour, MayBeAnIsland) {
  ContourEdit edit = edit_of(pocket(), {closed({{{20, 20}}, {{30, 20}}, {{30, 26}}, {{20, 26}}})});
  apply(edit, DeleteElement{3}, 0);
  expect_fault(edit, Code::edit_open,
               "THE CONTOUR OF ISLAND 0 IS OPEN BY 6 mm BETWEEN ELEMENTS 2 AND 0");
}

TEST(OpenContour, IsOneFromAMicrometreOn) {
  for (const bool is_wide : {false, true}) {
    ContourEdit edit = edit_of(pocket());
    apply(edit, DeleteElement{3});
    apply(edit, AddElement{{{10, 38}, {10, is_wide ? 10.002 : 10.0005}}});
    EXPECT_EQ(edit.finished().has_value(), !is_wide);
  }
}

TEST(NoArea, IsTheFirstThatIsChecked) {
  ContourEdit edit = edit_of(pocket());
  for (const std::size_t element : {0U, 1U, 2U}) apply(edit, DeleteElement{element});
  expect_fault(edit, Code::edit_no_area, "THE CONTOUR ENCLOSES NOTHING");
  ContourEdit flat = edit_of(pocket());
  apply(flat, ReplaceContour{.contour = closed({{{0, 0}}, {{30, 10}}, {{60, 20}}})});
  expect_fault(flat, Code::edit_no_area, "THE CONTOUR ENCLOSES NOTHING");
  ContourEdit point = edit_of(pocket(), {disc({30, 24}, 5)});
  apply(point, ReplaceContour{.contour = closed({{{20, 20}}, {{20, 20}}})}, 0);
  expect_fault(point, Code::edit_no_area, "THE CONTOUR OF ISLAND 0 ENCLOSES NOTHING");
}

TEST(NoArea, IsWhatLiesBeyondAllNumbers) {
  for (const double factor : {1e12, 1e308, std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()}) {
    ContourEdit edit = edit_of(pocket());
    apply(edit, ScaleFeature{factor});
    expect_fault(edit, Code::edit_no_area, "THE CONTOUR ENCLOSES NOTHING");
  }
}

TEST(CrossingContour, NamesTheElementsAndThePoint) {
  // A bow tie with wings of one size, gone round in two senses: no area, but not nothing.
  expect_crossing(closed({{{10, 10}}, {{50, 38}}, {{50, 10}}, {{10, 38}}}), {},
                  "ELEMENTS 1 AND 3 CROSS AT X30 Y24");
  expect_crossing(closed({{{0, 0}}, {{20, 0}}, {{20, 10}}, {{10, -5}}, {{0, 10}}}), {},
                  "ELEMENTS 0 AND 2 CROSS AT X13.333 Y0");
}

TEST(CrossingContour, OfALatheTellsDiameters) {
  const Contour loop = open({{{0, 20}}, {{-30, 20}}, {{-30, 40}}, {{-10, 40}}, {{-10, 10}}});
  expect_fault(ContourEdit({loop, {}}, true), Code::edit_crosses_itself,
               "ELEMENTS 0 AND 3 CROSS AT Z-10 X20");
}

TEST(CrossingContour, MayBeAnArcThroughALine) {
  expect_crossing(closed({{{0, 0}}, {{20, 0}}, {{20, 9}, -1}, {{0, 9}}}), {},
                  "ELEMENTS 0 AND 2 CROSS AT X5.641 Y0");
}

TEST(CrossingContour, IsAlsoOneThatGoesBackOnItself) {
  expect_crossing(closed({{{0, 0}}, {{20, 0}}, {{20, 25}}, {{20, 10}}, {{0, 10}}}), {},
                  "ELEMENTS 1 AND 2 MEET AT X20 Y10");
}

TEST(CrossingContour, IsNotOneThatTouchesItselfInAPoint) {
  const Contour touching = closed({{{0, 0}}, {{30, 0}}, {{30, 20}}, {{15, 0}}, {{0, 20}}});
  expect_outer(edit_of(touching), touching);
}

TEST(Islands, HaveToLieInsideAndApart) {
  expect_crossing(pocket(), {disc({80, 24}, 5)}, "ISLAND 0 IS NOT INSIDE THE CONTOUR");
  expect_crossing(pocket(), {disc({30, 24}, 5), disc({30, 24}, 8)},
                  "ISLAND 0 IS NOT APART FROM ISLAND 1");
  expect_crossing(pocket(), {disc({30, 24}, 5), disc({30, 24}, 5)},
                  "ISLAND 0 IS NOT APART FROM ISLAND 1");
  expect_crossing(disc({0, 0}, 5), {disc({0, 0}, 8)}, "ISLAND 0 IS NOT INSIDE THE CONTOUR");
  const Contour square = closed({{{45, 20}}, {{55, 20}}, {{55, 26}}, {{45, 26}}});
  expect_crossing(pocket(), {square}, "ELEMENT 1 AND ELEMENT 0 OF ISLAND 0 CROSS AT X50 Y20");
  expect_crossing(pocket(), {disc({20, 20}, 3), closed({{{18, 21}}, {{30, 21}}, {{30, 31}}})},
                  "ELEMENT 1 OF ISLAND 0 AND ELEMENT 0 OF ISLAND 1 CROSS AT X22.828 Y21");
}

TEST(Islands, MayNotShareAWall) {
  const Contour at_wall = closed({{{10, 20}}, {{20, 20}}, {{20, 26}}, {{10, 26}}});
  EXPECT_EQ(edit_of(pocket(), {at_wall}).finished().error().code, Code::edit_crosses_itself);
  const Contour in_corner = closed({{{10, 20}}, {{20, 18}}, {{20, 26}}});
  EXPECT_TRUE(edit_of(pocket(), {in_corner}).finished());  // it touches in a point
}

TEST(Meetings, OfManyLinesThroughEachOtherAreFoundSoon) {
  kerf::test::SeededRandom random(kerf::test::kSeed);
  Contour scribble{{}, true};
  for (int i = 0; i < 20000; ++i) {
    scribble.vertices.push_back({{random.in(0, 100), random.in(0, 100)}});
  }
  const auto meeting = contour::meeting_of({&scribble, 1}, 1e-3);
  ASSERT_TRUE(meeting);
  EXPECT_TRUE(meeting->is_crossing);
}

}  // namespace
}  // namespace kerf::features
