#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contour_editing.hpp"
#include "geometry/contour/crossing.hpp"
#include "seeded_random.hpp"

namespace kerf::features {
namespace {

using namespace test;  // NOLINT: shapes and expectations by their names

struct FilletRow {
  Vec2 p, corner, q;
  double radius;
  Vec2 begin, end;
  double bulge;
};
constexpr FilletRow kFillets[] = {
    {{0, 0}, {50, 0}, {80, 40}, 10, {45, 0}, {53, 4}, 0.236068},
    {{0, 0}, {10, 0}, {10, 10}, 2, {8, 0}, {10, 2}, 0.414214},
    {{0, 10}, {0, 0}, {30, 0}, 4, {0, 4}, {4, 0}, 0.414214},
    {{0, 0}, {20, 0}, {5, 15}, 3, {12.757359, 0}, {14.878680, 5.121320}, 0.668179},
    {{0, 0}, {20, 0}, {40, 1}, 50, {18.750780, 0}, {21.247661, 0.062383}, 0.012490}};

TEST(FilletedCorner, HasThePointsOfTheTable) {
  for (const FilletRow& row : kFillets) {
    ContourEdit edit({open({{row.p}, {row.corner}, {row.q}}), {}});
    apply(edit, FilletCorner{.corner = 1, .radius = row.radius});
    expect_outer(edit, open({{row.p}, {row.begin, row.bulge}, {row.end}, {row.q}}));
  }
}

TEST(FilletedCorner, OfAClosedContourIsThatOfTheTable) {
  for (const FilletRow& row : kFillets) {
    Contour triangle = closed({{row.p}, {row.corner}, {row.q}});
    const Contour normal = normal_form(triangle);
    const auto corner =
        std::find_if(normal.vertices.begin(), normal.vertices.end(),
                     [&](const auto& vertex) { return vertex.point == row.corner; });
    ContourEdit edit({normal, {}});
    apply(edit, FilletCorner{.corner = static_cast<std::size_t>(corner - normal.vertices.begin()),
                             .radius = row.radius});
    expect_outer(edit, closed({{row.p}, {row.begin, row.bulge}, {row.end}, {row.q}}));
  }
}

struct ChamferRow {
  Vec2 p, corner, q;
  double before, after;
  Vec2 begin, end;
};
constexpr ChamferRow kChamfers[] = {{{0, 0}, {50, 0}, {80, 40}, 5, 5, {45, 0}, {53, 4}},
                                    {{0, 0}, {10, 0}, {10, 10}, 2, 3, {8, 0}, {10, 3}},
                                    {{0, 10}, {0, 0}, {30, 0}, 4, 8, {0, 4}, {8, 0}}};

TEST(ChamferedCorner, HasThePointsOfTheTable) {
  for (const ChamferRow& row : kChamfers) {
    ContourEdit edit({open({{row.p}, {row.corner}, {row.q}}), {}});
    apply(edit, ChamferCorner{.corner = 1, .before = row.before, .after = row.after});
    expect_outer(edit, open({{row.p}, {row.begin}, {row.end}, {row.q}}));
  }
}

TEST(ChamferedCorner, ByAnAngleHasThatAngleToTheElementBefore) {
  ContourEdit square = edit_of(pocket());
  apply(square, ChamferCorner{.corner = 1, .before = 6, .angle_deg = 30});
  expect_outer(
      square,
      closed({{{10, 10}}, {{44, 10}}, {{50, 10 + 6 / std::sqrt(3.0)}}, {{50, 38}}, {{10, 38}}}));
  // In a corner of 60° a chamfer of 60° cuts off a triangle of equal sides.
  ContourEdit sharp({open({{{0, 0}}, {{20, 0}}, {{10, 10 * std::sqrt(3.0)}}}), {}});
  apply(sharp, ChamferCorner{.corner = 1, .before = 4, .angle_deg = 60});
  expect_outer(
      sharp, open({{{0, 0}}, {{16, 0}}, {{18, 2 * std::sqrt(3.0)}}, {{10, 10 * std::sqrt(3.0)}}}));
}

TEST(ChamferedCorner, ByAnAngleThatMeetsNothingIsRefused) {
  ContourEdit edit = edit_of(pocket());
  expect_refused(edit.apply(ChamferCorner{.corner = 1, .before = 6, .angle_deg = 90}, {}),
                 Code::edit_does_not_fit, "CHAMFER 6 AT 90° TOUCHES NOT BOTH ELEMENTS 0 AND 1");
  ContourEdit round = edit_of(closed({{{0, 0}}, {{40, 0}, 0.5}, {{40, 20}}, {{0, 20}}}));
  expect_refused(round.apply(ChamferCorner{.corner = 1, .before = 6, .angle_deg = 45}, {}),
                 Code::edit_does_not_fit,
                 "A CHAMFER BY ITS ANGLE IS BETWEEN TWO LINES, NOT ELEMENTS 0 AND 1");
}

TEST(ChamferedCorner, GoesByLengthsAlongAnArc) {
  // A quarter of a circle of radius 20, chamfered half-way: 5π along it.
  ContourEdit edit({open({{{-30, 0}}, {{0, 0}, -kQuarter}, {{20, -20}}}), {}});
  apply(edit, ChamferCorner{.corner = 1, .before = 5, .after = 5 * std::numbers::pi});
  const double half = 20 * std::numbers::sqrt2 / 2;
  expect_outer(edit, open({{{-30, 0}},
                           {{-5, 0}},
                           {{half, half - 20}, -std::tan(std::numbers::pi / 16)},
                           {{20, -20}}}));
}

TEST(EveryCorner, IsFilletedOrChamfered) {
  ContourEdit round = edit_of(pocket());
  apply(round, FilletCorner{.radius = 5});
  const auto rounded = round.finished();
  ASSERT_TRUE(rounded);
  EXPECT_EQ(rounded->outer.vertices.size(), 8U);
  EXPECT_NEAR(contour::area(rounded->outer), 40 * 28 - (4 - std::numbers::pi) * 25, 1e-9);
  ContourEdit cut = edit_of(pocket());
  apply(cut, ChamferCorner{.before = 5, .after = 5});
  expect_outer(cut, closed({{{15, 10}},
                            {{45, 10}},
                            {{50, 15}},
                            {{50, 33}},
                            {{45, 38}},
                            {{15, 38}},
                            {{10, 33}},
                            {{10, 15}}}));
}

TEST(EveryCorner, IsOneOfTwoLines) {
  ContourEdit edit = edit_of(closed({{{0, 0}}, {{40, 0}, 0.5}, {{40, 20}}, {{0, 20}}}));
  apply(edit, FilletCorner{.radius = 2});
  const auto finished = edit.finished();
  ASSERT_TRUE(finished);
  EXPECT_EQ(finished->outer.vertices.size(), 6U);
  ContourEdit round = edit_of(disc({0, 0}, 10));
  apply(round, ChamferCorner{.before = 2, .after = 2});
  expect_outer(round, disc({0, 0}, 10));
}

TEST(EveryCorner, MayTakeAllOfAnElement) {
  ContourEdit edit = edit_of(pocket());
  apply(edit, FilletCorner{.radius = 14});
  expect_outer(edit, closed({{{24, 10}}, {{36, 10}, 1}, {{36, 38}}, {{24, 38}, 1}}));
  expect_refused(edit.apply(DeleteElement{1}, {}), Code::edit_element_unknown,
                 "ELEMENT 1 IS NO LONGER THERE");
  ContourEdit cut = edit_of(pocket());
  apply(cut, ChamferCorner{.before = 14, .after = 14});
  EXPECT_EQ(cut.finished()->outer.vertices.size(), 6U);
}

TEST(Corners, KeepTheirNumbersUntilTheEnd) {
  // One after the other, each by the number that it had in the beginning.
  ContourEdit edit = edit_of(pocket());
  for (const std::size_t corner : {2U, 0U, 3U, 1U}) {
    apply(edit, FilletCorner{.corner = corner, .radius = 3.0 + static_cast<double>(corner)});
  }
  expect_outer(edit, closed({{{10, 13}, kQuarter},
                             {{13, 10}},
                             {{46, 10}, kQuarter},
                             {{50, 14}},
                             {{50, 33}, kQuarter},
                             {{45, 38}},
                             {{16, 38}, kQuarter},
                             {{10, 32}}}));
  // The arcs are 4 to 7 in the order in which they came: 6 is that of corner 3.
  apply(edit, DeleteElement{6});
  apply(edit, JoinElements{3, 2});
  const auto finished = edit.finished();
  ASSERT_TRUE(finished);
  EXPECT_EQ(finished->outer.vertices.size(), 7U);
}

TEST(Corners, ThatDoNotFitAreRefusedAndChangeNothing) {
  ContourEdit edit = edit_of(pocket());
  expect_refused(edit.apply(FilletCorner{.corner = 2, .radius = 30}, {}), Code::edit_does_not_fit,
                 "FILLET 30 NEEDS 30 mm OF ELEMENT 1, IT HAS 28");
  expect_refused(edit.apply(ChamferCorner{.corner = 2, .before = 3, .after = 41}, {}),
                 Code::edit_does_not_fit, "CHAMFER 41 NEEDS 41 mm OF ELEMENT 2, IT HAS 40");
  expect_refused(edit.apply(FilletCorner{.radius = 15}, {}), Code::edit_does_not_fit,
                 "FILLET 15 NEEDS 15 mm OF ELEMENT 1, IT HAS 13");
  expect_outer(edit, pocket());
}

TEST(Corners, WithoutAnElementBeforeThemAreRefused) {
  ContourEdit edit = edit_of(pocket());
  apply(edit, DeleteElement{1});
  expect_refused(edit.apply(FilletCorner{.corner = 2, .radius = 3}, {}), Code::edit_no_meeting,
                 "NO ELEMENT MEETS THE BEGINNING OF ELEMENT 2");
}

/// A star-shaped polygon: no two of its edges cross.
Contour random_polygon(kerf::test::SeededRandom& random) {
  const int count = random.count(3, 12);
  Contour polygon{{}, true};
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (i + random.in(0.1, 0.9)) / count;
    const double reach = random.size(5, 50);
    polygon.vertices.push_back({{reach * std::cos(angle), reach * std::sin(angle)}});
  }
  return polygon;
}

TEST(RandomPolygons, FilletedOrChamferedStayClosedAndSimple) {
  int done = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    kerf::test::SeededRandom random(kerf::test::kSeed + seed);
    const Contour polygon = random_polygon(random);
    if (!(contour::area(polygon) > 1)) continue;
    ContourEdit edit = edit_of(polygon);
    if (!edit.finished()) continue;  // a triangle may lie beside the middle
    const std::size_t corners = normal_form(polygon).vertices.size();
    for (std::size_t corner = 0; corner < corners; ++corner) {
      const double size = random.size(0.05, 3);
      const EditOperation operation =
          random.coin() ? EditOperation{FilletCorner{corner, size}}
                        : EditOperation{ChamferCorner{corner, size, random.size(0.05, 3)}};
      const auto fits = edit.apply(operation, {});
      EXPECT_TRUE(fits || fits.error().code == Code::edit_does_not_fit) << seed;
      done += fits ? 1 : 0;
      const auto finished = edit.finished();
      ASSERT_TRUE(finished) << seed << ": " << finished.error().sentence;
      EXPECT_EQ(finished->outer, normal_form(finished->outer)) << seed;
    }
  }
  EXPECT_GT(done, 1000);
}

}  // namespace
}  // namespace kerf::features
